"""The stored matrix of lecture 10 is what its script writes, and shows what the lecture says.

``python3 tools/matrix.py`` writes it again; here single trials of it are run again.
"""

from functools import cache

import matrix
import numpy as np
import pytest

import amrmetrics as am
from amrmetrics.benchmark.data import Estimate

STORED = matrix.FOLDER
SYSTEMS = {system.name: system for system in am.benchmark.systems()}
SHAPE = (6, 6, len(matrix.SEEDS))


@cache
def evaluation():
    return am.benchmark.Evaluation.load(STORED / matrix.NAMES[0])


@cache
def trials():
    path = STORED / matrix.NAMES[1]
    return np.genfromtxt(path, delimiter=",", names=True, dtype=None, encoding="utf-8")


def table(name):
    return trials()[name].reshape(SHAPE)


@cache
def world(scenario, seed):
    return matrix.world(scenario, seed)


def row(scenario, system, seed):
    return next(
        r
        for r in evaluation().rows
        if (r["scenario"], r["system"], r["seed"]) == (scenario, system, seed)
    )


@pytest.mark.parametrize(
    ("scenario", "system", "seed"),
    [
        ("loop", "ekf_localization", 0),
        ("corridor", "pose_graph_robust", 24),
        ("sparse", "ekf_slam", 7),
        ("aliasing", "ekf_overconfident", 11),
        ("dropout", "ekf_overconfident", 3),
        ("dropout", "pose_graph", 12),
        ("outdoor", "dead_reckoning", 18),
    ],
)
def test_a_trial_gives_the_stored_numbers(scenario, system, seed):
    log, truth = world(scenario, seed)
    estimate = SYSTEMS[system].run(log, **SYSTEMS[system].settings)
    covered, errors = matrix.judged(truth, estimate)
    stored = row(scenario, system, seed)
    place = (
        evaluation().scenarios.index(scenario),
        evaluation().systems.index(system),
        seed,
    )
    assert covered == table("covered")[place] == (stored["status"] == "ok")
    for name, value in zip(matrix.CONVENTIONS, errors, strict=True):
        assert np.isclose(table(name)[place], value, rtol=1e-3), name
    if covered:
        assert np.isclose(stored["drift_percent"], errors[0], rtol=1e-3)
        ends = am.pose_errors(truth.poses[-1:], estimate.poses[-1:])
        nees = am.nees(ends, estimate.covariances[-1:])[0]
        assert np.isclose(stored["nees_end"], nees, rtol=1e-2)


def test_both_files_have_all_trials_in_one_order():
    found = evaluation()
    names = [(r["scenario"], r["system"], r["seed"]) for r in found.rows]
    assert len(names) == len(set(names)) == 900
    assert [tuple(x) for x in trials()[["scenario", "system", "seed"]].tolist()] == names
    for stored, covered, drift in zip(
        found.rows, trials()["covered"], trials()["rigid"], strict=True
    ):
        assert (stored["status"] == "ok") == covered
        if covered:
            assert np.isclose(stored["drift_percent"], drift, rtol=1e-4)


def test_was_made_by_the_systems_and_scenarios_of_today():
    recorded = evaluation().recorded
    for kind, now in (("systems", am.benchmark.systems()), ("scenarios", am.benchmark.scenarios())):
        for stored, one in zip(recorded[kind], now, strict=True):
            assert stored["name"] == one.name
            assert stored["settings"] == one.settings
    assert recorded["seeds"] == list(matrix.SEEDS)
    assert recorded["protocol"]["metric"] == matrix.PROTOCOL.metric
    assert not evaluation().folder
    assert not evaluation().limits


@pytest.mark.parametrize("line", [0, 17, 36])
def test_a_setting_gives_the_stored_numbers(line):
    path = STORED / matrix.NAMES[2]
    stored = np.genfromtxt(path, delimiter=",", skip_header=1)
    assert stored.shape == (37, 2 + len(matrix.TUNING_SEEDS))
    _, run, given = list(matrix.settings())[line]
    for seed in (0, 31, 49):
        value = matrix.tuned(*world(matrix.TUNED_ON, seed), run, given)
        assert np.isclose(stored[line, 2 + seed], value, rtol=1e-3, equal_nan=True)


def test_errors_follow_their_convention():
    t = np.arange(6.0)
    poses = am.planar_poses(np.column_stack([t, 0 * t]), 0 * t)
    shifted = am.planar_poses(np.column_stack([t, 0 * t + 0.5]), 0 * t)
    _, truth = world("loop", 0)
    same = type(truth)(t, poses)
    assert np.isclose(matrix.error(same, shifted, "none", 0), 100 * 0.5 / 5)
    assert np.isclose(matrix.error(same, shifted, "rigid", 0), 0, atol=1e-9)
    # One frame late is one meter on a straight way, without alignment.
    assert np.isclose(matrix.error(same, poses, "none", 1), 100 * 1 / 4)
    assert matrix.judged(same, Estimate(poses))[0]
    assert not matrix.judged(same, Estimate(poses[:5]))[0]


def test_is_small():
    assert sum((STORED / name).stat().st_size for name in matrix.NAMES) < 400_000


class TestWhatTheLectureSays:
    """Each careless decision crowns another winner than the protocol."""

    def first(self, values):
        return evaluation().systems[int(np.argmin(values))]

    def filled(self, values):
        covered = table("covered") == 1
        worst = np.where(covered, values, -np.inf).max(axis=(1, 2), keepdims=True)
        return np.where(covered, values, worst)

    def protocol(self):
        return self.first(self.filled(table("rigid")).mean(axis=(0, 2)))

    def test_the_library_ranks_as_the_protocol(self):
        summary = evaluation().summary()
        found = min(evaluation().systems, key=lambda name: summary[None, name].value)
        assert found == self.protocol() == "pose_graph_robust"

    def test_clock(self):
        values = self.filled(table("rigid"))
        values[:, 5] = table("late")[:, 5]
        assert self.first(values.mean(axis=(0, 2))) == "ekf_localization"

    def test_alignment(self):
        assert self.first(self.filled(table("none")).mean(axis=(0, 2))) == "ekf_localization"

    def test_dropped_failures(self):
        covered = table("covered") == 1
        means = [table("rigid")[:, k][covered[:, k]].mean() for k in range(6)]
        assert self.first(means) in ("ekf_localization", "ekf_overconfident")

    def test_median(self):
        values = self.filled(table("rigid")).transpose(1, 0, 2).reshape(6, -1)
        assert self.first(np.median(values, axis=1)) == "ekf_localization"

    def test_best_seed(self):
        values = self.filled(table("rigid"))
        means = values.mean(axis=(0, 2))
        means[3] = values[:, 3].min(axis=1).mean()
        assert self.first(means) == "ekf_slam"
