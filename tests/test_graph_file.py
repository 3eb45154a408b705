"""The pose graph of problem set 07 is what the simulation writes, and shows what is asked.

``python3 tests/test_graph_file.py`` writes it again.
"""

from pathlib import Path

import numpy as np
import pytest

import amrmetrics as am

PATH = Path(__file__).parents[1] / "solutions" / "07_loops" / "graph.g2o"


def city():
    """Return a drive whose odometry drifts as far as look-alike blocks are apart."""
    return am.simulation.city_run(
        np.random.default_rng(99),
        160,
        closures=30,
        aliased=8,
        unlike=0,
        odometry_std=(0.04, 0.04, 0.02),
    )


def false_edges(run):
    """Return the indices of the false closures in `run.graph()`, and of all closures."""
    closures = len(run.odometry) + np.arange(len(run.labels))
    return closures[~run.labels], closures


def rows(text):
    return [line.split(maxsplit=1) for line in text.splitlines()]


def test_is_reproduced(tmp_path):
    am.write_g2o(tmp_path / "graph.g2o", city().graph())
    stored, made = (
        rows(path.read_text(encoding="utf-8")) for path in (PATH, tmp_path / "graph.g2o")
    )
    assert [tag for tag, _ in stored] == [tag for tag, _ in made]
    for (_, one), (_, other) in zip(stored, made, strict=True):
        # Sines and cosines may differ in the last digit from one system to the next.
        assert np.allclose(np.fromstring(one, sep=" "), np.fromstring(other, sep=" "), rtol=1e-12)
    assert PATH.stat().st_size < 50_000


def test_the_false_closures_can_be_told_by_the_map_and_not_before():
    run, graph = city(), am.read_g2o(PATH)
    false, closures = false_edges(run)
    right = np.setdiff1d(closures, false)
    rest = am.optimize(graph.keep(np.setdiff1d(np.arange(len(graph.edges)), false)))
    assert rest.p_value > 0.05
    chi_square = graph.with_poses(rest.poses).summary().edge_chi_square
    assert chi_square[right].max() < 30 < 1000 < chi_square[false].min()
    before = graph.summary().edge_chi_square  # dead reckoning
    assert before[right].max() > before[false].min()
    assert am.optimize(graph).edge_chi_square[right].max() > 100


@pytest.mark.parametrize("first", ["huber", "cauchy"])
def test_two_kernels_find_them(first):
    graph = am.read_g2o(PATH)
    false, closures = false_edges(city())
    robust = np.isin(np.arange(len(graph.edges)), closures)
    start = am.optimize(graph, first, robust=robust).graph
    weights = am.optimize(start, "geman_mcclure", robust=robust).weights
    assert np.flatnonzero(weights < 0.1).tolist() == false.tolist()


if __name__ == "__main__":
    am.write_g2o(PATH, city().graph())
