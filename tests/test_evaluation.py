"""One call gives the numbers of the single functions, and says what it could not compute."""

import json
import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import amrmetrics as am
from amrmetrics.command import _body
from amrmetrics.stamps import ClockOffset

T = np.arange(0, 120, 0.1)


def drive(noise=0.0, seed=0, t=T, name="run"):
    rng = np.random.default_rng(seed)
    phase = t / 3 + (t / 40) ** 2
    xy = np.c_[2 * t, 5 * np.sin(phase)] + noise * rng.normal(size=(len(t), 2))
    slope = 5 * np.cos(phase) * (1 / 3 + t / 800)
    heading = np.arctan2(slope, 2) + noise * rng.normal(size=len(t))
    return am.Trajectory(t, am.planar_poses(xy, heading), name)


class TestReport:
    def test_has_the_numbers_of_the_single_functions(self):
        X, Y = drive(name="truth"), drive(0.05, t=T[::2], seed=1)
        report = am.evaluate(X, Y)
        p, q = am.match(X, Y)
        assert report.ate.rmse == am.ate(p, q).rmse
        assert report.ate.rotation.rmse == am.ate(p, q).rotation.rmse
        assert report.drift_rate.rate == am.drift_rate(p, q).rate
        expected = am.segment_drift(p, q)
        assert report.segments.translation_percent == expected.translation_percent
        stretches = [(x.translation.delta, x.translation.delta_unit) for x in report.rpe]
        assert stretches == [(1, "frames"), (1, "s"), (1, "m"), (10, "m")]
        for x, (delta, unit) in zip(report.rpe, stretches, strict=True):
            assert x.translation.rmse == am.rpe(p, q, delta, unit).translation.rmse
        assert report.coverage.matched == 600
        for text in ("ATE rotation", "RPE 1 s", "segment drift", "600 of 1200 reference", "rigid"):
            assert text in repr(report)
            assert text in report._repr_html_()

    def test_passes_options_on(self):
        X, Y = drive(), drive(0.05, seed=1)
        body = am.planar_poses([[0.1, 0.2]], [0.3])[0]
        for align, first in (("none", None), ("rigid", 50), ("origin", None), ("similarity", None)):
            report = am.evaluate(X, Y, align=align, first=first, body=body, deltas=[(3, "s")])
            assert report.ate.rmse == am.ate(X, Y, align, first=first, body=body).rmse
            assert len(report.rpe) == 1
            assert report.rpe[0].rotation.rmse == am.rpe(X, Y, 3, "s", body=body).rotation.rmse
        assert ", scale " in repr(report)
        late = am.Trajectory(T - 7.3, drive(0.003, seed=1).poses)
        for offset in (7.3, "auto"):
            assert am.evaluate(X, late, offset=offset).offset == pytest.approx(7.3, abs=5e-3)
        assert "clock offset estimated" in repr(am.evaluate(X, late, offset="auto"))
        with pytest.raises(am.AmrError, match="offset is 'soon'"):
            am.evaluate(X, late, offset="soon")

    def test_projects_only_what_is_spatial(self):
        X = drive()
        lifted = am.Trajectory(T, np.c_[X.positions, np.sin(T)])
        with pytest.raises(am.AmrError, match="Project the spatial one to the plane"):
            am.evaluate(lifted, drive(0.05, seed=1))
        found = am.evaluate(lifted, drive(0.05, seed=1), plane="xy")
        assert found.ate.rmse == am.ate(X, drive(0.05, seed=1)).rmse

    def test_projects(self):
        def lifted(run):
            X = np.tile(np.eye(4), (len(run), 1, 1))
            X[:, :2, :2], X[:, :2, 3] = run.poses[:, :2, :2], run.poses[:, :2, 2]
            X[:, 2, 3] = np.random.default_rng(0).normal(size=len(run))
            return am.Trajectory(run.stamps, X, run.source)

        X, Y = drive(), drive(0.05, seed=1)
        flat = am.evaluate(lifted(X), lifted(Y), plane="xy")
        assert flat.ate.rmse == pytest.approx(am.evaluate(X, Y).ate.rmse)
        assert "xy" in repr(flat)
        positions = am.Trajectory(T, am.positions(lifted(Y)))
        prism = am.evaluate(lifted(X), positions, plane="xy")
        assert prism.ate.rmse == pytest.approx(flat.ate.rmse)

    def test_says_what_is_missing_and_why(self):
        X, Y = drive(t=T[:200]), drive(0.05, t=T[:200], seed=1)
        report = am.evaluate(X, am.Trajectory(Y.stamps, am.positions(Y), "prism"))
        assert report.rpe == ()
        assert report.skipped["RPE"] == "only positions were given"
        assert "no RPE" in repr(report)
        short = am.evaluate(X, Y)
        assert "too short for 100 m segments" in short.skipped["segment drift"]
        assert short.segments is None
        still = am.Trajectory(T, np.zeros((len(T), 2)))
        report = am.evaluate(still, am.Trajectory(T, np.ones((len(T), 2))), align="none")
        assert "does not move" in report.skipped["drift rate"]

    def test_json_comes_back(self):
        report = am.evaluate(drive(), drive(0.05, seed=1))
        rows = report.as_dict()
        assert json.loads(json.dumps(rows, allow_nan=False)) == rows
        assert rows["ate"]["rmse"] == report.ate.rmse
        assert rows["alignment"]["mode"] == "rigid"
        assert rows["rpe"][0]["rotation"]["unit"] == "rad"
        nothing = am.evaluate(*(am.Trajectory(None, drive(s).poses) for s in (0, 0.1))).as_dict()
        assert nothing["coverage"]["duration"] is None
        json.dumps(nothing, allow_nan=False)

    def test_reads_files_and_says_what_was_repaired(self, tmp_path):
        am.write_tum(tmp_path / "truth.txt", drive())
        run = (tmp_path / "run.txt").open("w", encoding="utf-8")
        am.write_tum(tmp_path / "whole.txt", drive(0.05, seed=1))
        lines = (tmp_path / "whole.txt").read_text(encoding="utf-8").splitlines(keepends=True)
        with run:
            run.writelines([*lines[:10], lines[9], *lines[10:]])
        with pytest.warns(am.RecordingWarning, match="line 11"):
            report = am.evaluate(tmp_path / "truth.txt", str(tmp_path / "run.txt"))
        assert report.coverage.matched == 1200
        assert any("estimate repaired: 1 " in note for note in report.notes)
        assert report.name == "run.txt"
        assert report.reference_name == "truth.txt"

    def test_refuses_other_options(self):
        X = drive()
        for deltas in ((10, "m"), 5, [(1, "m", 2)]):
            with pytest.raises(am.AmrError, match="expected pairs such as"):
                am.evaluate(X, X, deltas=deltas)
        bare = am.Trajectory(T, np.c_[X.positions, T])
        for run in (X, bare):
            with pytest.raises(am.AmrError, match="plane is 'yx'; expected one of 'xy', 'xz'"):
                am.evaluate(run, run, plane="yx")

    @pytest.mark.parametrize(("seconds", "stretches"), [(4.0, 2), (3.9, 1)])
    def test_stretches_are_a_quarter_of_the_run_at_most(self, seconds, stretches):
        """A run of 4 s has an RPE over 1 s, a shorter one has none."""
        t = np.arange(0, seconds + 0.05, 0.1)
        run = am.Trajectory(t, am.planar_poses(np.c_[0 * t, 0.001 * np.sin(t)], t))
        found = am.evaluate(run, run, align="none").rpe
        assert [x.translation.delta_unit for x in found] == ["frames", "s"][:stretches]

    def test_refuses_other_things(self):
        with pytest.raises(am.AmrError, match="reference is of type ndarray; expected the path"):
            am.evaluate(drive().poses, drive())
        for other in (drive().poses, 5):
            with pytest.raises(am.AmrError, match=r"estimate is of type .* expected the path"):
                am.evaluate(drive(), other)
        with pytest.raises(am.AmrError, match="is of type ndarray; expected the path"):
            am.evaluate(drive(), [drive().poses])
        for nothing in ([], {}):
            with pytest.raises(am.AmrError, match="estimate is empty"):
                am.evaluate(drive(), nothing)
        with pytest.raises(am.AmrError, match="no estimate could be evaluated"):
            am.evaluate(drive(), [drive(t=T + 1e6)])


class TestEstimatedOffset:
    @staticmethod
    def turning(t, noise, seed):
        rng = np.random.default_rng(seed)
        yaw = np.sin(t / 2) + 0.5 * np.sin(1.3 * t + 1) + noise * rng.normal(size=len(t))
        return am.planar_poses(np.c_[t, np.sin(t)], yaw)

    def pair(self, noise, seed=1, apart=0.0098):
        """Return ten poses a second; those of the estimate are a little later than the truth's."""
        t = np.arange(0, 60, 0.1)
        late = am.Trajectory(t + apart - 7.3, self.turning(t + apart, noise, seed))
        return am.Trajectory(t, self.turning(t, 0, 0)), late

    def test_no_match_is_lost_to_the_error_of_the_offset(self):
        lost = 0
        for seed in range(8):
            truth, late = self.pair(0.01, seed)
            offset = am.clock_offset(truth, late)
            try:
                lost += 600 - am.match(truth, late, offset=float(offset)).coverage.matched
            except am.AmrError:
                lost += 600
            report = am.evaluate(truth, late, offset="auto")
            assert report.coverage.matched == 600
            wide = 0.01 + 2 * offset.standard_error
            said = f"clock offset estimated: {offset!r}; stamps matched up to {wide:.3g} s apart"
            assert said in report.notes[0]
        assert lost >= 600  # in some of the runs, all of them

    def test_but_never_to_another_pose(self, monkeypatch):
        """Half a step of the reference is the most, whatever the offset is worth."""
        truth, late = self.pair(0, apart=0.07)
        for error, widest in ((0.01, 0.03), (0.5, 0.06)):
            offset = ClockOffset(7.3, error)
            monkeypatch.setattr("amrmetrics.evaluation.clock_offset", lambda *_, x=offset: x)
            report = am.evaluate(truth, late, offset="auto")
            assert f"up to {widest:g} s apart" in report.notes[0]
            apart = report.reference.stamps - report.estimate.stamps - 7.3
            assert apart == pytest.approx(np.full(599, 0.03), abs=1e-9)

    def test_a_given_offset_and_interpolation_widen_nothing(self):
        truth, late = self.pair(0.01)
        notes = am.evaluate(truth, late, offset="auto", interpolate=True).notes
        assert "apart" not in notes[0]
        assert am.evaluate(truth, late, offset=7.3).notes == ()
        assert am.evaluate(truth, late, offset=7.3, max_difference=0.009901).ate.n == 600
        with pytest.raises(am.AmrError, match=r"match within max_difference=0\.0097 s"):
            am.evaluate(truth, late, offset=7.3, max_difference=0.0097)


class TestSeveral:
    def test_are_sorted_and_failures_are_counted(self):
        runs = {"bad": drive(0.5, 1), "good": drive(0.01, 2), "lost": drive(t=T + 1e6)}
        found = am.evaluate(drive(), runs)
        assert [report.name for report in found] == ["good", "bad"]
        assert found.success_rate == pytest.approx(2 / 3)
        assert found.median == found[1].ate.rmse
        assert "no stamps match" in found.failures["lost"]
        assert "failed: lost: no stamps match" in repr(found)
        assert "2 of 3 estimates evaluated" in repr(found)
        assert len(found) == 2
        assert [row["estimate"] for row in found.table()] == ["good", "bad"]
        assert json.loads(json.dumps(found.as_dict(), allow_nan=False)) == found.as_dict()
        half = am.evaluate(drive(), {"good": runs["good"], "lost": runs["lost"]})
        assert np.isnan(half.median)
        assert "median ATE rmse none, half failed" in repr(half)

    def test_says_how_samples_were_matched(self):
        bare = am.Trajectory(None, drive(0.01).poses)
        assert ", by order in the files" in repr(am.evaluate(drive(), bare))
        assert ", by interpolated" in repr(am.evaluate(drive(), drive(0.01), interpolate=True))

    def test_runs_of_two_systems_are_compared(self):
        runs = {f"orb_{k}": drive(0.02 + 0.001 * k, k) for k in range(8)}
        runs |= {f"vins_{k}.txt": drive(0.05 + 0.001 * k, 50 + k) for k in range(8)}
        found = am.evaluate(drive(), runs)
        (name,) = found.comparisons
        result = found.comparisons[name]
        rmse = {report.name: report.ate.rmse for report in found}
        a = [rmse[f"orb_{k}"] for k in range(8)]
        b = [rmse[f"vins_{k}.txt"] for k in range(8)]
        assert name == "orb - vins"
        assert result.verdict == "A better"
        assert result.mean == pytest.approx(am.compare_paired(a, b).mean)
        assert result.unit == "m"
        del runs["orb_3"], runs["orb_4"]
        assert len(am.evaluate(drive(), runs).comparisons) == 1  # six pairs
        del runs["orb_5"]
        assert am.evaluate(drive(), runs).comparisons == {}

    def test_a_failed_run_gets_the_worst_value(self):
        runs = {f"orb_{k}": drive(0.02 + 0.001 * k, k) for k in range(6)}
        runs |= {f"vins_{k}": drive(0.05 + 0.001 * k, 50 + k) for k in range(6)}
        runs["vins_2"] = drive(t=T + 1e6)
        found = am.evaluate(drive(), runs)
        rmse = {report.name: report.ate.rmse for report in found}
        a = [rmse[f"orb_{k}"] for k in range(6)]
        b = [rmse.get(f"vins_{k}", max(rmse.values())) for k in range(6)]
        result = found.comparisons["orb - vins"]
        assert result.mean == pytest.approx(am.compare_paired(a, b).mean)
        for name in [name for name in runs if name != "orb_0"]:
            runs[name] = drive(t=T + 1e6)
        lost = {f"lost_{name}": run for name, run in runs.items() if name != "orb_0"}
        assert am.evaluate(drive(), lost | {"good": drive(0.01)}).comparisons == {}

    def test_names_need_not_be_text_and_missing_files_are_failures(self, tmp_path):
        found = am.evaluate(drive(), {1: drive(0.01), 2: tmp_path / "none.txt"})
        assert [report.name for report in found] == ["1"]
        assert "none.txt" in found.failures["2"]
        with pytest.raises(OSError, match=r"none\.txt"):
            am.evaluate(drive(), tmp_path / "none.txt")

    def test_runs_with_and_without_orientations_share_a_table(self):
        X = drive(0.01, 1)
        bare = am.Trajectory(T, X.positions)
        runs = {"bare": bare, "good": drive(0.02, 1), "short": drive(0.02, 1)[:9]}
        found = am.evaluate(drive(), runs, align="none")
        assert {report.name for report in found} == set(runs)
        columns = {tuple(row) for row in found.table()}
        assert len(columns) == 1
        assert "rpe_10m_rmse_m" in columns.pop()
        lines = repr(found).splitlines()[1:5]
        assert len({len(line) for line in lines}) == 1

    def test_names_are_told_apart(self, tmp_path):
        for folder in "ab":
            (tmp_path / folder).mkdir()
            am.write_tum(tmp_path / folder / "run.txt", drive(0.01))
        paths = [tmp_path / folder / "run.txt" for folder in "ab"]
        names = {report.name for report in am.evaluate(paths[0], paths)}
        assert names == {str(path) for path in paths}
        assert len(am.evaluate(drive(), [drive(0.01), drive(0.02)])) == 2

    def test_columns_stand_in_the_order_of_the_longest_table(self):
        bare = am.Trajectory(T, drive(0.01, 1).positions)
        found = am.evaluate(drive(), {"bare": bare, "good": drive(0.02, 1)})
        assert [x.name for x in found] == ["bare", "good"]
        columns = list(found.table()[0])
        assert columns.index("rpe_1m_rmse_m") < columns.index("drift_percent")
        assert columns[-2:] == ["jumps", "lost_s"]
        (row,) = am.evaluate(drive(), [drive(0.01)[:600]]).table()
        assert row["matched_percent"] == pytest.approx(100 * 59.9 / 119.9)


class TestAWordOnEstimatesThatDoNotFollow:
    @pytest.mark.parametrize("part", [0.49, 0.51])
    def test_half_of_what_a_point_leaves_that_never_moves(self, part):
        X = drive()
        p = X.positions
        still = np.sqrt(((p - p.mean(axis=0)) ** 2).sum(axis=1).mean())
        apart = part * still * np.where(np.arange(len(T)) % 2, 1, -1)
        run = am.Trajectory(T, p + np.c_[0 * T, apart])
        notes = am.evaluate(X, run, align="none").notes
        said = f"the ATE of a point that never moves would be {still:.4g} m"
        assert any(said in note for note in notes) == (part > 0.5), notes

    def test_few_samples_show_nothing(self):
        X = drive()[:10]
        apart = np.where(np.arange(10) % 2, 1, -1)
        run = am.Trajectory(X.stamps, X.positions + np.c_[0 * apart, apart])
        for n, said in ((10, True), (9, False)):
            pair = X[:n], run[:n]
            notes = am.evaluate(*pair, align="none").notes
            assert any("never moves" in note for note in notes) == said

    def test_jumps_across_a_gap_that_may_be(self):
        kept = (np.arange(len(T)) < 300) | (np.arange(len(T)) > 340)
        run = drive(0.001, 1)[kept]
        assert am.evaluate(drive(), run).jumps.steps == kept.sum() - 2
        assert am.evaluate(drive(), run, max_gap=5).jumps.steps == kept.sum() - 1

    def test_a_given_body_is_part_of_the_advice(self):
        t = np.arange(0, 60, 0.1)
        e = np.c_[t / 4, 0.4 * np.sin(t / 3), 0.5 * np.cos(t / 2)]
        q = Rotation.from_euler("zyx", e).as_quat()
        X = am.spatial_poses(np.c_[9 * np.cos(t / 4), 9 * np.sin(t / 4), np.sin(t)], q)
        arm = am.spatial_poses([[0.7, -0.3, 0.4]], [[0, 0, 0, 1]])[0]
        truth, run = am.Trajectory(t, X), am.Trajectory(t, X @ arm)
        body = am.spatial_poses([[0.2, 0.1, 0]], [[0, 0, 0, 1]])[0]
        report = am.evaluate(truth, run, body=body)
        (note,) = [note for note in report.notes if "lever arm" in note]
        advised = _body(re.search('--body "([^"]*)"', note)[1])
        assert "body=body @ arm.body" in note
        assert am.evaluate(truth, run, body=advised).ate.rmse < 1e-3
