"""The runs of problem set 09 are what the generator writes, and show what is asked.

``python3 tests/test_comparison_log.py`` writes them again.
"""

from pathlib import Path

import numpy as np

import amrmetrics as am

PATH = Path(__file__).parents[1] / "solutions" / "09_comparison" / "runs.csv"
SCENARIOS, SEEDS = 12, 4


def runs_log():
    """Return the lines of a log in which the system that fails in hard scenarios looks better."""
    rng = np.random.default_rng(109)
    difficulty = rng.permutation(np.linspace(0.12, 0.78, SCENARIOS))
    gain = 0.045 + 0.045 * rng.standard_normal(SCENARIOS)
    noise = 0.012 * rng.standard_normal((2, SCENARIOS, SEEDS))
    ate = difficulty[:, np.newaxis] + noise
    ate[0] += gain[:, np.newaxis]
    hardest = np.argsort(difficulty)[::-1]
    for place, lost in enumerate((4, 3, 3, 2, 1)):
        ate[0, hardest[place], rng.permutation(SEEDS)[:lost]] = np.nan
    ate[1, hardest[4], rng.integers(SEEDS)] = np.nan
    ate[1, hardest[9], rng.integers(SEEDS)] = np.nan
    lines = [
        f"{k + 1},{seed + 1},{system},{ate[row, k, seed]:.3f}"
        for row, system in enumerate("AB")
        for k in range(SCENARIOS)
        for seed in range(SEEDS)
    ]
    return ["scenario,seed,system,ate_m"] + [lines[k] for k in rng.permutation(len(lines))]


def table():
    """Return the stored errors, shape (system, scenario, seed)."""
    log = np.genfromtxt(PATH, delimiter=",", names=True, dtype=None, encoding="utf-8")
    errors = np.full((2, SCENARIOS, SEEDS), np.inf)
    row = (log["system"] == "B").astype(int)
    errors[row, log["scenario"] - 1, log["seed"] - 1] = log["ate_m"]
    return errors


def test_is_reproduced():
    assert PATH.read_text(encoding="utf-8").splitlines() == runs_log()


def test_the_table_of_means_misleads():
    errors = table()
    assert not np.isinf(errors).any()
    finished = np.nanmean(errors, axis=(1, 2))
    assert finished[0] < finished[1] - 0.02
    d = errors[0] - errors[1]
    both = ~np.isnan(d)
    means = np.array([x[ok].mean() for x, ok in zip(d, both, strict=True) if ok.any()])
    assert len(means) == SCENARIOS - 1
    by_scenario = am.compare_paired(means, np.zeros(len(means)))
    assert by_scenario.verdict == "B better"
    as_if_independent = am.compare_paired(d[both], np.zeros(both.sum()))
    assert as_if_independent.upper < by_scenario.upper - 0.005
    assert np.isnan(errors).sum(axis=(1, 2)).tolist() == [13, 2]


if __name__ == "__main__":
    PATH.write_text("\n".join(runs_log()) + "\n", encoding="utf-8", newline="\n")
