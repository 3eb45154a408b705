"""What all results share: plain numbers for JSON, a table, and numbers that behave like numbers."""

import json
import pickle
import tomllib
from pathlib import Path

import numpy as np
import pytest

import amrmetrics as am
from amrmetrics._results import Number, Result
from amrmetrics._version import VERSION

ROOT = Path(__file__).resolve().parent.parent
RNG = np.random.default_rng(0)
T = np.arange(0, 400, 0.5)
X = am.planar_poses(np.c_[T, np.sin(T / 7)], np.arctan(np.cos(T / 7) / 7))
Y = X @ am.planar_poses(0.05 * RNG.normal(size=(len(T), 2)), 0.01 * RNG.normal(size=len(T)))
LABELS, SCORES = RNG.random(50) < 0.4, RNG.random(50)
RESULTS = {
    "align": lambda: am.align(X, Y),
    "ate": lambda: am.ate(X, Y),
    "ate similarity": lambda: am.ate(X, Y, "similarity"),
    "ate rotation": lambda: am.ate(X, Y).rotation,
    "rpe": lambda: am.rpe(X, Y, 1, "m"),
    "pool": lambda: am.pool([am.ate(X, Y), am.ate(X, Y)]),
    "drift rate": lambda: am.drift_rate(X, Y),
    "segments": lambda: am.segment_drift(X, Y),
    "match": lambda: am.match(am.Trajectory(T, X), am.Trajectory(T, Y)).coverage,
    "evaluate": lambda: am.evaluate(am.Trajectory(T, X), am.Trajectory(T, Y)),
    "consistency": lambda: am.consistency_test(RNG.chisquare(3, 100), 3),
    "brier": lambda: am.brier(LABELS, SCORES),
    "murphy": lambda: am.murphy(LABELS, SCORES),
    "confusion": lambda: am.confusion(LABELS, SCORES),
    "sweep": lambda: am.threshold_sweep(LABELS, SCORES),
    "chamfer": lambda: am.chamfer(X[:, :2, 2], Y[:, :2, 2]),
    "precision_recall": lambda: am.precision_recall(LABELS, SCORES),
    "latency": lambda: am.latency(RNG.gamma(4, 0.01, 400), 0.05),
    "percentile": lambda: am.percentile(RNG.random(400), 95),
    "relocalization": lambda: am.relocalization_time(range(1, 11), LABELS[:10] | True),
    "energy": lambda: am.energy([0, 1, 2], [3, 4, 5]),
    "paired": lambda: am.compare_paired(SCORES, SCORES + LABELS),
    "aggregate": lambda: am.aggregate(SCORES),
}


@pytest.mark.parametrize("name", RESULTS)
def test_plain_numbers_and_a_table(name):
    result = RESULTS[name]()
    assert isinstance(result, Result)
    rows = result.as_dict()
    assert json.loads(json.dumps(rows)).keys() == rows.keys()
    assert "<table>" in result._repr_html_()
    assert len(repr(result)) > 10


@pytest.mark.parametrize("name", [name for name in RESULTS if isinstance(RESULTS[name](), Number)])
def test_numbers_behave_like_numbers(name):
    result = RESULTS[name]()
    x = float(result)
    assert f"{result:.3f}" == f"{x:.3f}"
    assert f"{result}" == str(result)
    assert np.asarray(result) == x
    assert np.asarray(result).dtype == float
    assert np.mean([result, result]) == x
    assert result + 1 == 1 + result == x + 1
    assert 2 * result == x * 2
    assert -result == -x
    assert (result < x + 1) and (result > x - 1)
    assert np.sqrt(abs(result)) == np.sqrt(abs(x))
    assert round(result, 2) == round(x, 2)
    assert len({result, result}) == 1


def test_an_ate_names_its_conventions_in_fields():
    rows = am.ate(X, Y, "similarity", first=100).as_dict()
    assert [rows[name] for name in ("metric", "quantity", "unit")] == ["ATE", "translation", "m"]
    assert rows["n"] == 800
    assert rows["alignment"]["mode"] == "similarity"
    assert rows["alignment"]["n"] == 100
    assert rows["rotation"]["unit"] == "rad"
    rows = am.rpe(X, Y, 2, "seconds", stamps=T).as_dict()
    assert rows["translation"]["delta"] == 2
    assert rows["translation"]["delta_unit"] == "s"
    assert rows["translation"]["pairs"] == "all"
    assert rows["left_out"] == 0


def test_an_errors_series_cannot_be_changed():
    error = am.ate(X, Y)
    with pytest.raises(ValueError, match="read-only"):
        error.series[0] = 1


def test_the_smallest_errors_stay():
    p = np.zeros((4, 2))
    tiny = p + [3e-170, 4e-170]
    assert am.ate(p, tiny, "none").rmse == pytest.approx(5e-170, rel=1e-12)
    assert am.ate(p, tiny, "none").mean == pytest.approx(5e-170, rel=1e-12)
    still = am.planar_poses(p, np.zeros(4))
    moved = am.planar_poses(np.r_[p[:2], tiny[:2]], np.zeros(4))
    assert am.rpe(still, moved, 2).translation.rmse == pytest.approx(5e-170, rel=1e-12)


class TestPool:
    RUNS = (am.ate(X, Y), am.ate(X[:100], Y[:100]))

    def test_keeps_rotations_and_the_mode_of_alignment(self):
        pooled = am.pool(self.RUNS)
        assert pooled.n == 900
        assert pooled.alignment is None
        assert pooled.run_alignment == "rigid"
        assert "rigid of each run" in repr(pooled)
        assert pooled.run_rmse == tuple(run.rmse for run in self.RUNS)
        expected = np.concatenate([run.rotation.series for run in self.RUNS])
        assert np.array_equal(pooled.rotation.series, expected)
        positions = am.pool([am.ate(am.positions(X), am.positions(Y))] * 2)
        assert positions.rotation is None

    def test_pooled_runs_can_be_pooled_again(self):
        one, two = am.pool(self.RUNS), am.pool([*self.RUNS, *self.RUNS])
        again = am.pool([one, one])
        assert again.rmse == two.rmse
        assert again.run_rmse == two.run_rmse
        assert again.rotation.rmse == two.rotation.rmse
        assert am.pool([one, self.RUNS[0]]).n == 1700


def test_results_travel_between_processes():
    error = am.ate(X, Y)
    back = pickle.loads(pickle.dumps(error))
    assert back.rmse == error.rmse
    assert back.rotation.rmse == error.rotation.rmse
    turning = am.planar_poses(np.zeros((len(T), 2)), np.sin(T / 3) + np.sin(T**1.3 / 9))
    offset = am.clock_offset(T, turning, T + 3, turning)
    back = pickle.loads(pickle.dumps(offset))
    assert (back, back.standard_error) == (offset, offset.standard_error)


def test_the_version_stands_in_one_place():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert project["project"]["dynamic"] == ["version"]
    assert am.__version__ == VERSION
    assert f"version: {VERSION}\n" in (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\n## {VERSION}" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")


def test_the_library_alone_needs_three_packages():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    names = {line.split(">")[0] for line in project["dependencies"]}
    assert names == {"numpy", "scipy", "lazy_loader"}
    assert {*project["optional-dependencies"]} == {"plot", "ros", "fast", "benchmark", "course"}
