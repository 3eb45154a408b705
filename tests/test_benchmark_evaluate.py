"""From raw logs to numbers, verdicts and what limits them."""

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest
from benchmark_logs import estimate_of, truth_of, write
from scipy.stats import chi2

import amrmetrics as am
from amrmetrics.benchmark import gathering, logs, summarizing, workers
from amrmetrics.benchmark.data import Estimate, Protocol, Truth
from amrmetrics.benchmark.measuring import measure

DECISIONS = vars(Protocol())


def good(truth, rng, scenario, seed):
    return estimate_of(truth, rng, 0.05)


def over(truth, rng, scenario, seed):
    return estimate_of(truth, rng, 0.08, claim=0.5)


def bare(truth, rng, scenario, seed):
    if seed == 1:
        return "raised", "ValueError: no luck"
    return estimate_of(truth, rng, 0.3, full=False, until=0.5 if seed == 2 else 1)


def crash(truth, rng, scenario, seed):
    return "too slow", "stopped after 60 s"


SYSTEMS = {"good": good, "over": over, "bare": bare, "crash": crash}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write(tmp_path_factory.mktemp("bench") / "demo", SYSTEMS)


@pytest.fixture(scope="module")
def evaluation(folder):
    return am.benchmark.evaluate(folder, jobs=1)


@pytest.fixture(scope="module")
def compared(evaluation):
    return am.benchmark.compare(evaluation)


def trial(estimate, truth, **more):
    entry = logs.TrialEntry("s", "w", "test", 0, None, None, status="ok")
    return logs.Trial(**vars(entry), estimate=estimate, truth=truth, **more)


def row_of(evaluation, **wanted):
    (row,) = [x for x in evaluation.rows if wanted.items() <= x.items()]
    return row


def measured(estimate, truth, **changes):
    return measure(trial(estimate, truth), DECISIONS | changes)


@pytest.fixture
def truth(rng):
    return truth_of(rng)


class TestNumbersOfATrial:
    def test_are_those_of_the_library(self, truth, rng):
        estimate = estimate_of(truth, rng)
        row = measured(estimate, truth).row
        error = am.ate(truth.poses, estimate.poses)
        relative = am.rpe(truth.poses, estimate.poses, 10, "m")
        assert row["ate"] == error.rmse
        assert row["ate_max"] == error.max
        assert row["ate_rotation_deg"] == np.degrees(error.rotation.rmse)
        assert row["rpe_10m"] == relative.translation.rmse
        assert row["rpe_10m_deg"] == np.degrees(relative.rotation.rmse)
        assert row["drift_percent"] == pytest.approx(
            100 * float(am.drift_rate(truth.poses, estimate.poses))
        )
        values = am.nees(am.pose_errors(truth.poses, estimate.poses), estimate.covariances)
        assert row["anees"] == values.mean()
        assert row["nees_end"] == values[-1]
        nis = am.nis(estimate.innovations, estimate.innovation_covariances)
        assert row["anis"] == nis.mean()
        assert (row["nees_dof"], row["nis_dof"]) == (3, 2)
        ms = 1e3 * np.percentile(estimate.frame_seconds, [50, 95, 99])
        found = [row[f"latency_{name}_ms"] for name in ("median", "p95", "p99")]
        assert found == pytest.approx(ms)
        assert row["skipped"] == {}
        assert row["status"] == "ok"

    def test_the_map_is_aligned_with_the_trajectory(self, truth, rng):
        turned = am.planar_poses([[3, -2]], [0.7])[0]
        estimate = estimate_of(truth, rng, 1e-9)
        moved = estimate.map_points @ turned[:2, :2].T + turned[:2, 2]
        moved[3] = np.nan  # never seen
        moved[4] += turned[:2, :2] @ [0.3, 0.4]
        estimate = replace(estimate, poses=turned @ estimate.poses, map_points=moved)
        row = measured(estimate, truth).row
        assert row["map_rmse"] == pytest.approx(0.5 / np.sqrt(7), rel=1e-4)
        assert row["map_found"] == 7 / 8
        assert measured(estimate, truth, align="none").row["map_rmse"] > 1
        distances = np.linalg.norm(truth.landmarks[3] - np.delete(truth.landmarks, 3, 0), axis=1)
        # Landmark 3 was not mapped: only from the truth to the map does that count.
        assert row["map_chamfer"] >= (distances.min() - 0.5) / 8

    def test_a_scale_is_shown_if_one_was_fitted(self, truth, rng):
        estimate = estimate_of(truth, rng, 1e-6)
        poses = estimate.poses.copy()
        poses[:, :2, 2] /= 2
        half = replace(estimate, poses=poses)
        assert "scale" not in measured(half, truth).row
        row = measured(half, truth, align="similarity").row
        assert row["scale"] == pytest.approx(2, rel=1e-5)
        assert row["ate"] < 1e-4

    def test_a_map_that_is_not_numbered_like_the_truth_has_a_chamfer_distance(self, truth, rng):
        estimate = replace(estimate_of(truth, rng), map_points=truth.landmarks[:5] + 0.01)
        row = measured(estimate, truth).row
        assert row["map_rmse"] is None
        assert row["map_chamfer"] > 0
        assert "not numbered" in row["skipped"]["map_rmse"]

    def test_closures(self, truth, rng):
        labels = np.array([1, 1, 1, 0, 0], bool)
        truth = replace(truth, labels=labels)
        accepted = np.array([1, 0, 1, 1, 0], bool)
        scores = np.array([0.9, 0.2, 0.6, 0.8, 0.1])
        estimate = replace(estimate_of(truth, rng), accepted=accepted, closure_scores=scores)
        found = measured(estimate, truth)
        row = found.row
        assert (row["closure_precision"], row["closure_recall"]) == (2 / 3, 2 / 3)
        assert row["false_closures"] == 1
        curve = am.precision_recall(labels, scores)
        assert row["average_precision"] == curve.average_precision
        # Recall 1/3 at threshold 0.9, 2/3 at 0.6, 1 at 0.2; levels 0.02, 0.04, ...
        assert found.series["precision"][[0, 15, 16, 32, 33, 49]] == pytest.approx(
            [1, 1, 2 / 3, 2 / 3, 3 / 4, 3 / 4]
        )
        nothing = measured(replace(estimate, accepted=~accepted & False), truth).row
        assert nothing["closure_precision"] is None
        assert nothing["skipped"]["closure_precision"] == "no closure was accepted"
        other = measured(replace(estimate, accepted=accepted[:3]), truth).row
        assert other["skipped"]["closures"] == "3 closures for 5 candidates"

    def test_classes_of_latency_are_named_after_their_longest_time(self, truth, rng):
        seconds = np.array([0.0203, 0.01005, 0.0204, 0])
        estimate = replace(estimate_of(truth, rng), frame_seconds=seconds)
        kinds, counts = measured(estimate, truth).series["frames"]
        assert counts.tolist() == [1, 1, 2]
        assert (10 ** (kinds / 200) >= [1e-9, 0.01005, 0.0204]).all()
        assert (10 ** ((kinds - 1) / 200) < [1e-9, 0.01005, 0.0203]).all()

    def test_what_is_missing_has_its_reason(self, truth, rng):
        row = measured(estimate_of(truth, rng, full=False), truth).row
        assert row["anees"] is row["map_rmse"] is row["closure_recall"] is None
        assert set(row["skipped"]) == {"NEES", "NIS", "map", "closures", "latency"}
        blind = replace(truth, landmarks=None, labels=None)
        row = measured(estimate_of(truth, rng), blind).row
        assert row["skipped"]["map"] == "the truth has no landmarks"
        assert "which closures are true" in row["skipped"]["closures"]

    def test_a_start_that_is_known_for_sure_has_no_nees(self, truth, rng):
        estimate = estimate_of(truth, rng)
        P = estimate.covariances.copy()
        P[0] = 0
        found = measured(replace(estimate, covariances=P), truth)
        whole = am.nees(am.pose_errors(truth.poses, estimate.poses), estimate.covariances)
        assert found.row["anees"] == pytest.approx(whole[1:].mean())
        assert "1 of 120 covariances" in found.row["skipped"]["NEES of some poses"]
        row = measured(replace(estimate, covariances=0 * P), truth).row
        assert row["anees"] is None
        assert "not positive definite" in row["skipped"]["NEES"]

    def test_covariances_follow_the_poses_that_are_matched(self, truth, rng):
        estimate = estimate_of(truth, rng)
        growing = estimate.covariances * np.linspace(1, 9, 120)[:, None, None]
        estimate = replace(estimate, covariances=growing)
        kept = np.r_[0:60, 61:120]
        some = replace(
            estimate,
            poses=estimate.poses[kept],
            stamps=estimate.stamps[kept],
            covariances=estimate.covariances[kept],
        )
        late = replace(truth, stamps=truth.stamps[5:], poses=truth.poses[5:])
        whole = am.nees(am.pose_errors(truth.poses, estimate.poses), estimate.covariances)
        assert measured(some, late).row["anees"] == pytest.approx(whole[kept[5:]].mean())

    def test_in_space_with_positions_only(self, rng):
        t = np.arange(100) * 0.1
        xyz = np.c_[np.cos(t), np.sin(t), 0.3 * t]
        truth = Truth(t, am.spatial_poses(xyz, np.tile([0, 0, 0, 1.0], (100, 1))))
        row = measured(Estimate(xyz + 0.01 * rng.normal(size=(100, 3)), t), truth).row
        assert 0.01 < row["ate"] < 0.03
        assert row["rpe_1s"] is None
        assert row["ate_rotation_deg"] is None
        assert row["skipped"]["rotation and RPE"] == "only positions were given"

    def test_a_run_that_is_too_short_for_a_stretch_says_so(self, rng):
        truth = truth_of(rng, n=8)
        row = measured(estimate_of(truth, rng), truth).row
        assert row["rpe_10m"] is None
        assert "10 m" in row["skipped"]["rpe_10m"]

    def test_without_stamps_samples_are_matched_in_order(self, truth, rng):
        estimate = estimate_of(truth, rng)
        bare = replace(truth, stamps=None)
        row = measured(replace(estimate, stamps=None), bare).row
        assert row["ate"] == measured(estimate, truth).row["ate"]
        assert (row["coverage"], row["lost_seconds"]) == (1.0, None)


class TestCoverage:
    def cut(self, truth, rng, kept):
        estimate = estimate_of(truth, rng, full=False)
        return Estimate(estimate.poses[kept], estimate.stamps[kept])

    def test_gaps_count_in_the_middle_and_at_both_ends(self, truth, rng):
        duration = truth.stamps[-1]
        for kept, lost in (
            (np.r_[0:40, 80:120], 4.1),
            (np.r_[0:80], duration - 7.9),
            (np.r_[30:120], 3.0),
            (np.r_[0:120:2], 0.0),  # every second pose is no gap
        ):
            row = measured(self.cut(truth, rng, kept), truth, minimum_coverage=0.0).row
            assert row["lost_seconds"] == pytest.approx(lost, abs=1e-9)
            assert row["coverage"] == pytest.approx(1 - lost / duration)

    def test_too_little_is_a_failure_with_its_reason(self, truth, rng):
        found = measured(self.cut(truth, rng, np.r_[0:60]), truth)
        row = found.row
        assert (row["status"], row["kind"], row["ate"]) == ("failed", "rule", None)
        assert row["reason"] == (
            "covers 49.6 % of the truth, 6 s are lost; minimum_coverage is 90 %"
        )
        assert row["coverage"] == pytest.approx(5.9 / 11.9)
        assert np.isnan(found.series["error"][-1])

    def test_a_large_error_is_a_failure_only_if_that_was_decided(self, truth, rng):
        estimate = estimate_of(truth, rng, 1.0)
        assert measured(estimate, truth).row["status"] == "ok"
        row = measured(estimate, truth, maximum_ate=0.5).row
        assert row["status"] == "failed"
        assert row["reason"].endswith("maximum_ate is 0.5 m")
        assert row["anees"] is None

    def test_what_cannot_be_measured_is_a_failure(self, truth, rng):
        still = replace(estimate_of(truth, rng), poses=np.repeat(truth.poses[:1], 120, 0))
        row = measured(still, truth).row
        assert (row["status"], row["kind"]) == ("failed", "not measured")
        assert "all coincide" in row["reason"]
        late = replace(estimate_of(truth, rng), stamps=truth.stamps + 100)
        assert "match" in measured(late, truth).row["reason"]

    def test_who_meets_a_limit_exactly_has_not_failed(self, truth, rng):
        estimate = estimate_of(truth, rng)
        found = measured(estimate, truth, minimum_coverage=1.0).row
        assert (found["coverage"], found["status"]) == (1, "ok")
        again = measured(estimate, truth, maximum_ate=found["ate"]).row
        assert again["status"] == "ok"

    def test_a_reason_is_text_that_can_be_written(self, truth):
        entry = replace(trial(None, truth), status="failed", reason="no\udcff\x1b[1m\nbag")
        row = measure(entry, DECISIONS).row
        assert row["reason"] == "no??[1m bag"


class TestEvaluate:
    def test_the_first_seed_is_drawn(self, evaluation):
        assert {x["seed"] for x in evaluation.traces.values()} == {0}

    def test_every_trial_is_a_row(self, evaluation):
        assert len(evaluation.rows) == 4 * 2 * 6
        assert len(evaluation.table()) == 48
        assert len({tuple(row) for row in evaluation.table()}) == 1
        assert evaluation.title == "demo: 4 systems, 2 scenarios, 6 seeds"
        assert evaluation.systems == ("good", "over", "bare", "crash")
        row = row_of(evaluation, system="bare", scenario="hall", seed=1)
        assert (row["status"], row["kind"]) == ("failed", "raised")
        assert row["reason"] == "ValueError: no luck"
        assert row["ate"] is None

    def test_rows_have_plain_numbers(self, evaluation):
        kinds = {type(x) for row in evaluation.table() for x in row.values()}
        assert kinds <= {str, int, float, type(None)}
        whole = evaluation.as_dict()
        assert json.loads(json.dumps(whole, allow_nan=False)) == json.loads(json.dumps(whole))

    def test_failures_are_counted(self, evaluation):
        assert len(evaluation.failures) == 16
        counts = {s: x.failed for (where, s), x in evaluation.summary().items() if where is None}
        assert counts == {"good": 0, "over": 0, "bare": 4, "crash": 12}
        assert "12 of 12 failed" in repr(evaluation)
        assert "bare, rule" in evaluation._repr_html_()

    def test_tuning_scenarios_stay_apart(self, evaluation):
        assert {row["scenario"] for row in evaluation.tuning} == {"tune"}
        assert evaluation.scenarios == ("loop", "hall")
        assert "tune" not in evaluation.profiles
        assert "tune" not in {row["scenario"] for row in evaluation.consistency}
        assert "tune" not in evaluation.traces
        assert "tune, for tuning" in repr(evaluation)

    def test_reasons_are_collected(self, evaluation):
        assert evaluation.skipped["map"] == {"the system hands in no map": 8}

    def test_a_selection_says_so(self, folder):
        some = am.benchmark.evaluate(folder, systems=["good"], seeds=[1, 2])
        assert some.title == (
            "demo: 1 system, 2 scenarios, 2 seeds; SELECTION: 1 of 4 systems (good); "
            "SELECTION: 2 of 6 seeds (1, 2)"
        )
        assert "SELECTION" not in am.benchmark.evaluate(folder, seeds=range(6)).title
        one = am.benchmark.evaluate(folder, scenarios="loop")
        assert "1 of 3 scenarios (loop)" in one.title

    @pytest.mark.parametrize(
        "what, value", [("systems", "best"), ("scenarios", ["moon"]), ("seeds", [77])]
    )
    def test_an_unknown_name_is_refused(self, folder, what, value):
        with pytest.raises(am.AmrError, match=f"there is no {what[:-1]} .*there are "):
            am.benchmark.evaluate(folder, **{what: value})

    def test_other_decisions_are_named(self, folder, evaluation):
        other = am.benchmark.evaluate(folder, protocol={"align": "none", "statistic": "p95"})
        assert "DEPARTS from the recorded protocol: align is 'none', recorded 'rigid'" in (
            other.title
        )
        assert other.departures["statistic"] == ("median", "p95")
        row = row_of(other, system="good", scenario="loop", seed=0)
        assert row["ate"] > row_of(evaluation, system="good", scenario="loop", seed=0)["ate"]
        same = am.benchmark.evaluate(folder, protocol=Protocol())
        assert same.title == evaluation.title
        strict = am.benchmark.evaluate(folder, protocol=Protocol(maximum_ate=0.1))
        assert len(strict.failures) > len(evaluation.failures)

    @pytest.mark.parametrize(
        "change, message",
        [
            ({"time_limit": 1.0}, "cannot be changed afterwards"),
            ({"calibration": "by hand"}, "cannot be changed afterwards"),
            ({"aling": "none"}, "protocol has no 'aling'"),
            ({"align": "free"}, "expected one of rigid"),
            ({"metric": "speed"}, "the table has coverage"),
            ({"statistic": "best"}, "expected one of mean"),
            ({"confidence": 2}, "expected in"),
        ],
    )
    def test_other_decisions_that_make_no_sense_are_refused(self, folder, change, message):
        with pytest.raises(am.AmrError, match=message):
            am.benchmark.evaluate(folder, protocol=change)

    def test_trials_that_have_not_run_are_no_failures(self, tmp_path):
        folder = write(
            tmp_path / "half",
            {"good": good, "slow": lambda t, r, w, seed: None if seed > 3 else over(t, r, w, seed)},
        )
        found = am.benchmark.evaluate(folder)
        assert "INCOMPLETE: 4 of 24 trials have not run" in found.title
        assert len(found.failures) == 0
        x = found.summary()[None, "slow"]
        assert (x.done, x.missing, x.n) == (8, 4, 8)
        compared = am.benchmark.compare(found)
        assert [row["missing"] for row in compared.rows] == [4, 2, 2]
        assert compared.rows[1]["n"] == 4

    def test_an_edited_log_is_refused(self, folder, tmp_path):
        copy = tmp_path / "copy"
        shutil.copytree(folder, copy)
        path = logs.trial_path(copy, "loop", "good", 2) / "estimate.tum"
        path.write_bytes(path.read_bytes().replace(b"1", b"2", 1))
        with pytest.raises(am.AmrError, match=r"trial loop/good/2 cannot be evaluated.*SHA-256"):
            am.benchmark.evaluate(copy)

    def test_a_trial_of_another_protocol_is_refused(self, folder, tmp_path):
        copy = tmp_path / "copy"
        shutil.copytree(folder, copy)
        other = write(tmp_path / "other", SYSTEMS, align="none", tuning=())
        path = logs.trial_path("", "hall", "over", 0)
        shutil.rmtree(copy / path)
        shutil.copytree(other / path, copy / path)
        with pytest.raises(am.AmrError, match=r"hall.over.000000 was logged under protocol"):
            am.benchmark.evaluate(copy)

    @pytest.mark.parametrize(
        ("place", "other", "name"),
        [
            ("trials/loop/over/000000", "trials/loop/good/000000", "system good"),
            ("trials/loop/over/000001", "trials/loop/over/000000", "seed 0"),
            ("worlds/loop/000001", "worlds/loop/000000", "seed 0"),
        ],
    )
    def test_a_folder_in_the_place_of_another_is_refused(
        self, folder, tmp_path, place, other, name
    ):
        copy = tmp_path / "copy"
        shutil.copytree(folder, copy)
        shutil.rmtree(copy / place)
        shutil.copytree(copy / other, copy / place)
        with pytest.raises(am.AmrError, match=f"is of {name}: it was moved or copied"):
            am.benchmark.evaluate(copy)

    def test_another_folder_is_refused(self, tmp_path):
        with pytest.raises(am.AmrError, match="not the folder of a benchmark"):
            am.benchmark.evaluate(tmp_path)

    def test_trials_that_the_protocol_does_not_know_are_noted(self, folder, tmp_path):
        copy = tmp_path / "copy"
        shutil.copytree(folder, copy)
        shutil.copytree(copy / "trials/loop/good", copy / "trials/loop/better")
        found = am.benchmark.evaluate(copy, systems=["good"])
        assert "6 folders of trials are not in the protocol" in found.notes[0]

    def test_many_processes_give_the_same(self, folder, evaluation, monkeypatch):
        monkeypatch.setattr(workers, "ALONE", 0.0)
        other = am.benchmark.evaluate(folder, jobs=2)
        assert other.rows == evaluation.rows
        assert other.consistency == evaluation.consistency
        assert other.frames == evaluation.frames
        np.testing.assert_equal(other.profiles, evaluation.profiles)
        np.testing.assert_equal(other.traces, evaluation.traces)

    def test_a_process_sends_its_error_back(self, folder, tmp_path, monkeypatch):
        monkeypatch.setattr(workers, "ALONE", 0.0)
        copy = tmp_path / "copy"
        shutil.copytree(folder, copy)
        (logs.trial_path(copy, "hall", "good", 3) / "estimate.npz").unlink()
        with pytest.raises(am.AmrError, match=r"trial hall/good/3 .*missing"):
            am.benchmark.evaluate(copy, jobs=2)

    def test_a_process_that_dies_is_told_of(self, folder, monkeypatch):
        monkeypatch.setattr(workers, "ALONE", 0.0)
        monkeypatch.setattr(workers, "START", "{path} and __import__('os')._exit(3)")
        with pytest.raises(am.AmrError, match="process that evaluates trials has died"):
            am.benchmark.evaluate(folder, jobs=2)

    def test_jobs_is_a_number(self, folder):
        with pytest.raises(am.AmrError, match="jobs is 0"):
            am.benchmark.evaluate(folder, jobs=0)


class TestSave:
    def test_what_is_loaded_is_what_was_saved(self, evaluation, tmp_path):
        path = tmp_path / "e.json"
        evaluation.save(path, digits=17)
        loaded = am.benchmark.Evaluation.load(path)
        assert loaded.rows == evaluation.rows
        assert loaded.title == evaluation.title
        assert repr(loaded) == repr(evaluation)
        assert loaded.consistency == evaluation.consistency
        np.testing.assert_equal(loaded.profiles, evaluation.profiles)
        before, after = (am.benchmark.compare(x).table() for x in (evaluation, loaded))
        np.testing.assert_equal(after, before)
        assert str(evaluation.folder) not in path.read_text(encoding="utf-8")

    def test_trajectories_keep_their_ends(self, evaluation, tmp_path):
        evaluation.save(tmp_path / "e.json", digits=17)
        loaded = am.benchmark.Evaluation.load(tmp_path / "e.json")
        before, after = (x.traces["loop"]["systems"]["good"]["path"] for x in (evaluation, loaded))
        assert len(after) == len(before) // 2 + 1
        assert after[[0, -1]].tolist() == before[[0, -1]].tolist()

    def test_limits_survive(self, folder, tmp_path):
        found = am.benchmark.evaluate(folder, seeds=[0, 3], protocol={"align": "none"})
        found.save(tmp_path / "e.json")
        assert am.benchmark.Evaluation.load(tmp_path / "e.json").title == found.title

    def test_few_digits_and_no_traces_are_small(self, evaluation, tmp_path):
        sizes = []
        for options in ({}, {"digits": 3, "traces": False}):
            evaluation.save(tmp_path / "e.json", **options)
            sizes.append((tmp_path / "e.json").stat().st_size)
        assert sizes[1] < sizes[0] < 60_000

    def test_another_file_is_refused(self, tmp_path):
        for text in ("{}", "[]", "no"):
            (tmp_path / "e.json").write_text(text, encoding="utf-8")
            with pytest.raises(am.AmrError, match="no saved evaluation"):
                am.benchmark.Evaluation.load(tmp_path / "e.json")


class TestConsistency:
    def verdicts(self, evaluation, kind):
        return {
            (row["scenario"], row["system"]): row["verdict"]
            for row in evaluation.consistency
            if row["kind"] == kind
        }

    def test_overconfidence_is_found(self, evaluation):
        for kind in ("NEES", "NIS"):
            assert self.verdicts(evaluation, kind) == {
                ("loop", "good"): "consistent",
                ("hall", "good"): "consistent",
                ("loop", "over"): "overconfident",
                ("hall", "over"): "overconfident",
            }

    def test_and_underconfidence(self, tmp_path):
        shy = {"shy": lambda t, r, *_: estimate_of(t, r, claim=4.0)}
        found = am.benchmark.evaluate(write(tmp_path / "shy", shy, seeds=range(8), tuning=()))
        assert set(self.verdicts(found, "NEES").values()) == {"underconfident"}
        assert set(self.verdicts(found, "NIS").values()) == {"underconfident"}

    def test_instants_of_one_run_are_not_taken_for_trials(self, rng):
        """Erratum E8: errors that stay the same all run long, and are claimed rightly."""
        alarms, wrong = 0, 0
        for _ in range(300):
            values = np.repeat(rng.chisquare(3, size=(6, 1)), 50, axis=1)
            test = gathering._nees_over_seeds(values, 3, 0.95)
            alarms += am.holm(test["p"]).min() <= 0.05
            plain = am.consistency_test(values.ravel()[:, None], 3)  # what must not be done
            wrong += plain.verdict != "consistent"
        assert alarms / 300 < 0.08
        assert wrong / 300 > 0.5

    def test_the_number_of_false_alarms_is_as_promised(self, rng):
        alarms = 0
        for _ in range(400):
            tests = [gathering._nees_over_seeds(rng.chisquare(3, (8, 50)), 3, 0.95) for _ in "ab"]
            found = gathering._with_verdicts(tests, 0.95)
            alarms += any(row["verdict"] != "consistent" for row in found)
        assert 0.02 < alarms / 400 < 0.08

    def test_innovations_are_tested_on_both_sides_for_what_they_are_worth(self):
        totals = np.array([[130.0, 50, 25], [100, 40, 20]])
        test = gathering._nis(totals, 2, 0.9)
        mean = 230 / 90
        assert (test["mean"], test["n"], test["n_effective"]) == ([mean], [90], 45)
        assert test["p"][0] == pytest.approx(2 * chi2.sf(45 * mean, 90))
        limits = chi2.ppf([0.05, 0.95], 90) / 45
        assert [test["lower"][0], test["upper"][0]] == pytest.approx(limits.tolist())

    def test_a_verdict_names_the_side_however_small_the_excess(self):
        tests = [
            {"why": "", "dof": 2, "mean": [mean], "p": [p]}
            for mean, p in ((2.1, 1e-4), (1.9, 1e-4), (2.9, 0.04), (9.0, 0.06))
        ]
        said = [row["verdict"] for row in gathering._with_verdicts(tests, 0.95)]
        assert said == ["overconfident", "underconfident", "consistent", "consistent"]

    def test_seeds_that_lost_track_are_not_there(self, truth):
        values = np.ones((4, 50))
        values[1:, 30:] = np.nan
        test = gathering._nees_over_seeds(values, 3, 0.95)
        assert test["n"] == [4, 4, 4, 1, 1]
        values[:, 30:] = np.nan
        assert gathering._nees_over_seeds(values, 3, 0.95)["at"] == [0.2, 0.4, 0.6]
        assert gathering._nees_over_seeds(values + np.nan, 3, 0.95)["why"]

    def test_innovations_that_depend_on_each_other_count_as_fewer(self, truth, rng):
        estimate = estimate_of(truth, rng)
        white = measured(estimate, truth).series["nis_total"]
        same = replace(estimate, innovations=np.repeat(estimate.innovations[::40], 40, axis=0))
        total = measured(same, truth).series["nis_total"]
        assert white[2] == pytest.approx(240, rel=0.3)
        assert total[1] == 240
        assert total[2] < 60


class TestSummary:
    def test_statistics_and_intervals(self, evaluation):
        rows = [x for x in evaluation.rows if x["system"] == "good"]
        values = np.array([row["ate"] for row in rows])
        d = evaluation.decisions
        from amrmetrics.benchmark.summarizing import summarize

        median = evaluation.summary()[None, "good"]
        direct = am.aggregate(values)
        assert (median.value, median.lower) == (direct.median, direct.median_lower)
        mean = summarize(rows, "ate", d | {"statistic": "mean"})[None, "good"]
        assert mean.value == pytest.approx(values.mean())
        places = {row["scenario"] for row in rows}
        means = [np.mean([r["ate"] for r in rows if r["scenario"] == x]) for x in places]
        half = am.compare_paired(means, np.zeros(len(means)))
        assert mean.n == len(places) > 1
        assert (mean.lower, mean.upper) == pytest.approx((half.lower, half.upper))
        place = rows[0]["scenario"]
        one = summarize(rows, "ate", d | {"statistic": "mean"})[place, "good"]
        here = np.array([row["ate"] for row in rows if row["scenario"] == place])
        half = am.compare_paired(here, 0 * here)
        assert (one.lower, one.upper) == pytest.approx((half.lower, half.upper))
        tail = summarize(rows, "ate", d | {"statistic": "p95"})[None, "good"]
        assert tail.value == pytest.approx(np.percentile(values, 95))
        assert np.isnan(tail.upper)
        assert "no upper limit" in tail.why

    def test_a_failed_trial_counts_as_the_worst_of_its_scenario(self, evaluation):
        x = evaluation.summary()["loop", "bare"]
        rows = [row for row in evaluation.rows if row["scenario"] == "loop" and row["ate"]]
        worst = max(row["ate"] for row in rows)
        own = [row["ate"] for row in rows if row["system"] == "bare"]
        assert x.value == pytest.approx(np.median([*own, worst, worst]))
        assert (x.n, x.failed) == (6, 2)
        assert x.failure_lower < 1 / 3 < x.failure_upper

    def test_the_worst_is_the_smallest_where_higher_is_better(self, evaluation):
        rows = [row for row in evaluation.rows if row["scenario"] == "loop"]
        values, failed = summarizing.filled(rows, "closure_recall", DECISIONS)
        least = min(x["closure_recall"] for x in rows if x["closure_recall"] is not None)
        crashed = [row["system"] == "crash" for row in rows]
        assert failed[crashed].all()
        assert set(values[crashed]) == {least}

    def test_each_scenario_has_a_worst_of_its_own(self, evaluation):
        values, failed = summarizing.filled(evaluation.rows, "ate", DECISIONS)
        found = {}
        for row, value in zip(evaluation.rows, values, strict=True):
            found.setdefault((row["scenario"], row["status"]), []).append(value)
        worst = {where: max(found[where, "ok"]) for where in ("loop", "hall")}
        assert worst["loop"] != worst["hall"]
        assert {where: set(found[where, "failed"]) for where in worst} == {
            where: {value} for where, value in worst.items()
        }
        assert failed.sum() == sum(row["status"] == "failed" for row in evaluation.rows)

    def test_or_is_counted_beside_the_others(self, folder):
        found = am.benchmark.evaluate(folder, protocol={"failures": "separate"})
        x = found.summary()["loop", "bare"]
        assert (x.n, x.failed) == (4, 2)

    def test_times_and_coverage_of_failed_trials_are_not_made_up(self, tmp_path):
        late = {
            "good": good,
            "late": lambda t, r, w, k: crash(t, r, w, k) if k else good(t, r, w, k),
        }
        found = am.benchmark.evaluate(write(tmp_path / "late", late, tuning=()))
        assert found.summary("latency_p95_ms")[None, "late"].n == 2
        assert found.summary("coverage")[None, "late"].n == 2
        assert found.summary("rpe_1s")[None, "late"].n == 12

    def test_a_system_that_always_failed_has_no_number(self, evaluation):
        x = evaluation.summary()[None, "crash"]
        assert np.isnan(x.value)
        assert x.why == "every trial failed"
        assert evaluation.summary("map_rmse")[None, "bare"].why == "the system hands in no map"
        with pytest.raises(am.AmrError, match="metric is 'speed'; expected one of coverage"):
            evaluation.summary("speed")


class TestCompare:
    def test_all_pairs_on_all_and_on_each_scenario(self, compared):
        assert len(compared.rows) == 6 * 3
        assert (compared.tests, compared.secondary_tests) == (6, 12)
        assert compared.verdict("good", "over", "loop") == "good better"
        assert compared.verdict("over", "good", "loop") == "good better"
        assert compared.verdict("crash", "good", "hall") == "good better"
        with pytest.raises(am.AmrError, match="were not compared on 'moon'"):
            compared.verdict("good", "over", "moon")

    def test_on_one_scenario_the_seeds_count(self, evaluation, compared):
        ate = {
            s: [x["ate"] for x in evaluation.rows if x["scenario"] == "hall" and x["system"] == s]
            for s in ("good", "over")
        }
        direct = am.compare_paired(ate["good"], ate["over"])
        flips = am.compare_sign_flip(ate["good"], ate["over"])
        (row,) = [
            x for x in compared.rows if (x["scenario"], x["a"], x["b"]) == ("hall", "good", "over")
        ]
        assert row["mean"] == direct.mean
        assert (row["lower"], row["upper"], row["p"]) == (
            direct.lower,
            direct.upper,
            direct.p_value,
        )
        assert row["p_sign_flip"] == flips.p_value
        assert (row["n"], row["trials"]) == (6, 6)

    def test_on_all_of_them_the_means_of_scenarios_count(self, evaluation, compared):
        means = {
            s: [
                np.mean(
                    [x["ate"] for x in evaluation.rows if (x["scenario"], x["system"]) == (w, s)]
                )
                for w in ("loop", "hall")
            ]
            for s in ("good", "over")
        }
        direct = am.compare_paired(means["good"], means["over"])
        row = compared.rows[0]
        assert (row["scenario"], row["n"], row["trials"]) == ("all scenarios", 2, 12)
        assert row["p"] == pytest.approx(direct.p_value)

    def test_one_scenario_that_both_have_run_is_one_number_of_all(self, tmp_path):
        def only_in_the_hall(truth, rng, scenario, seed):
            return over(truth, rng, scenario, seed) if scenario == "hall" else None

        folder = write(tmp_path / "b", {"good": good, "over": only_in_the_hall}, tuning=())
        both, *single = am.benchmark.compare(folder, jobs=1).rows
        assert (both["scenario"], both["n"], both["trials"]) == ("all scenarios", 1, 6)
        assert (both["verdict"], both["why"]) == ("undecided", "one scenario shows no spread")
        assert [(row["scenario"], row["n"]) for row in single] == [("loop", 0), ("hall", 6)]

    def test_holm_is_for_two_families(self, evaluation, compared):
        for family, count in (("primary", 6), ("secondary", 12)):
            rows = [row for row in compared.rows if row["family"] == family]
            assert {row["scenario"] == "all scenarios" for row in rows} == {family == "primary"}
            assert len(rows) == count
            assert [row["p_holm"] for row in rows] == am.holm([x["p"] for x in rows]).tolist()
        for row in compared.rows:
            assert (row["verdict"] != "undecided") == (row["p_holm"] <= 0.05)
        assert "Holm over 6 primary tests, and over 12 secondary ones" in repr(compared)
        assert "good - over, loop (secondary)" in repr(compared)

    def test_and_for_what_is_shown(self, evaluation):
        few = am.benchmark.compare(evaluation, systems=["good", "over"], scenarios=["hall"])
        assert (few.tests, few.secondary_tests) == (1, 0)
        assert few.rows[0]["p_holm"] == few.rows[0]["p"]
        assert "COMPARED: 2 of 4 systems (good, over); COMPARED: 1 of 2 scenarios" in few.title

    def test_failures_on_each_side(self, compared):
        row = next(x for x in compared.rows if (x["a"], x["b"]) == ("bare", "crash"))
        assert (row["failed_a"], row["failed_b"], row["failed_both"]) == (4, 12, 4)

    def test_higher_can_be_better(self, tmp_path):
        truth_full = {
            "sharp": lambda t, r, *_: replace(estimate_of(t, r), accepted=t.labels),
            "loose": lambda t, r, *_: replace(estimate_of(t, r), accepted=t.labels | True),
        }
        found = am.benchmark.evaluate(write(tmp_path / "c", truth_full, ("loop",), range(8)))
        compared = am.benchmark.compare(found, "closure_precision")
        assert compared.better == "higher"
        assert compared.verdict("sharp", "loose") == "sharp better"
        assert len(compared.rows) == 1  # one scenario is not shown twice

    def test_a_winner_that_fails_more_often_is_conflicting(self, tmp_path):
        systems = {
            "frail": lambda t, r, w, k: crash(t, r, w, k) if k % 4 == 0 else good(t, r, w, k),
            "tough": over,
        }
        folder = write(tmp_path / "f", systems, ("loop",), range(12), failures="separate")
        found = am.benchmark.compare(folder)
        assert found.verdict("frail", "tough") == "conflicting"
        assert found.rows[0]["n"] == 9
        worst = am.benchmark.evaluate(folder, protocol={"failures": "worst"})
        assert am.benchmark.compare(worst).verdict("frail", "tough") != "conflicting"

    def test_ties(self, tmp_path):
        def twin(t, r, w, k):
            return estimate_of(t, np.random.default_rng(k), 0.05)

        found = am.benchmark.compare(write(tmp_path / "t", {"a": twin, "b": twin}))
        assert {row["verdict"] for row in found.rows} == {"undecided"}
        assert {row["p"] for row in found.rows} == {1.0}
        assert "all differences are 0" in repr(found)

    def test_a_decision_that_the_exact_test_does_not_show_says_so(self, tmp_path):
        folder = write(tmp_path / "t", {"good": good, "over": over}, ("loop",), range(4))
        row = am.benchmark.compare(folder).rows[0]
        assert row["verdict"] == "good better"
        assert row["p_sign_flip"] == 0.125
        assert "the exact test does not show it" in row["why"]

    def test_nothing_to_compare_has_its_reason(self, tmp_path, evaluation):
        compared = am.benchmark.compare(evaluation, "map_rmse")
        row = next(x for x in compared.rows if (x["a"], x["b"]) == ("good", "bare"))
        assert (row["n"], row["verdict"]) == (0, "undecided")
        assert row["why"] == "bare: the system hands in no map"
        lost = am.benchmark.compare(write(tmp_path / "l", {"a": crash, "b": crash}))
        assert lost.tests == 0
        assert lost.rows[0]["why"] == "every trial of a failed"
        one = write(tmp_path / "o", {"a": good, "b": over}, ("loop",), [3])
        assert "one pair of trials" in am.benchmark.compare(one).rows[0]["why"]

    def test_what_cannot_be_compared_is_refused(self, evaluation, folder):
        with pytest.raises(am.AmrError, match="of anees neither lower nor higher is better"):
            am.benchmark.compare(evaluation, "anees")
        with pytest.raises(am.AmrError, match="there is no system 'best'"):
            am.benchmark.compare(evaluation, systems=["good", "best"])
        with pytest.raises(am.AmrError, match="needs two systems; there is good"):
            am.benchmark.compare(evaluation, systems="good")

    def test_everything_is_plain(self, compared):
        json.dumps(compared.as_dict(), allow_nan=False)
        assert "undecided" in compared._repr_html_()
