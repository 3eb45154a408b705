"""The report of problem set 10 says what its trials say, but for the faults that it was given.

``python3 tests/test_benchmark_log.py`` writes the trials again.
"""

import re
from pathlib import Path

import nbformat
import numpy as np
from scipy import stats

import amrmetrics as am

FOLDER = Path(__file__).parents[1] / "solutions" / "10_benchmark"
PATH = FOLDER / "trials.csv"
SYSTEMS, SEEDS = "ABC", 6
SCENARIOS = ("aisle", "dock", "hall", "lab", "ramp", "yard")
TUNING = SCENARIOS.index("lab")
FAILED = 2.0  # meters, by the report's protocol
FAILURES = {
    "A": {"ramp": (3,)},
    "B": {"aisle": (2, 5), "dock": (6,), "ramp": (1, 3, 4), "yard": (2,)},
    "C": {"ramp": (5,)},
}


def trials_log():
    """Return the lines of a log in which the system that fails most looks best."""
    rng = np.random.default_rng(710)
    hard = np.array([0.42, 0.30, 0.36, 0.18, 0.55, 0.26])
    world = 0.035 * rng.standard_normal((len(SCENARIOS), SEEDS))
    gain = np.array(
        [
            [0.00, 0.00, 0.00, 0.00, 0.00, 0.00],
            [-0.11, -0.07, -0.09, -0.03, -0.10, -0.05],
            [0.06, 0.05, 0.12, 0.21, 0.09, 0.02],
        ]
    )
    own = 0.025 * rng.standard_normal((3, len(SCENARIOS), SEEDS))
    ate = hard[:, np.newaxis] + world + gain[:, :, np.newaxis] + own
    share = np.array([0.75, 0.85, 0.45])[:, np.newaxis, np.newaxis]
    aligned = ate * share * rng.uniform(0.85, 1.1, ate.shape)
    tail = ate * rng.uniform(1.6, 2.1, ate.shape)
    nees = rng.chisquare(3, ate.shape)
    lines = []
    for k, system in enumerate(SYSTEMS):
        for j, scenario in enumerate(SCENARIOS):
            for i in range(SEEDS):
                found = ate[k, j, i], aligned[k, j, i], tail[k, j, i], nees[k, j, i]
                failed = i + 1 in FAILURES[system].get(scenario, ())
                numbers = "nan,nan,nan,nan" if failed else ",".join(f"{x:.3f}" for x in found)
                lines.append(f"{system},{scenario},{i + 1},{numbers}")
    shuffled = [lines[k] for k in rng.permutation(len(lines))]
    return ["system,scenario,seed,ate_m,aligned_m,p95_m,nees", *shuffled]


def table(column="ate_m"):
    """Return a column of the stored log, shape (system, scenario, seed)."""
    log = np.genfromtxt(PATH, delimiter=",", names=True, dtype=None, encoding="utf-8")
    found = np.full((3, len(SCENARIOS), SEEDS), np.inf)
    for row in log:
        place = SYSTEMS.index(row["system"]), SCENARIOS.index(row["scenario"]), row["seed"] - 1
        found[place] = row[column]
    assert not np.isinf(found).any()
    return found


def judged(column="ate_m", failed=FAILED):
    """Return a column of the test scenarios, failed trials with a value."""
    return np.nan_to_num(np.delete(table(column), TUNING, axis=1), nan=failed)


def by_scenario(a, b):
    """Compare two systems as the report's protocol has it."""
    means = judged().mean(axis=2)
    return am.compare_paired(means[SYSTEMS.index(a)], means[SYSTEMS.index(b)], unit="m")


def statements():
    """Return the numbered statements of the report, without line breaks."""
    notebook = nbformat.read(FOLDER / "10_benchmark.ipynb", 4)
    text = next(cell.source for cell in notebook.cells if cell.id == "intro-e")
    report = text.split("**The report:**")[1].split("`faults`")[0]
    parts = re.split(r"^(\d+)\. ", report, flags=re.MULTILINE)[1:]
    return {
        int(number): " ".join(text.split())
        for number, text in zip(parts[::2], parts[1::2], strict=True)
    }


def test_is_reproduced():
    assert PATH.read_text(encoding="utf-8").splitlines() == trials_log()


class TestSoundStatements:
    """What the report says without a fault is true of its trials."""

    def test_1_failures(self):
        lost = np.isnan(np.delete(table(), TUNING, axis=1)).sum(axis=(1, 2))
        assert lost.tolist() == [1, 7, 1]
        assert "Of the 90 test trials 9 failed: A 1, B 7, C 1." in statements()[1]

    def test_3_a_rigid_alignment_makes_each_error_smaller(self):
        assert np.nanmax(table("aligned_m") - table()) < 0
        assert "smaller after a rigid alignment" in statements()[3]

    def test_6_degrees_of_freedom(self):
        assert by_scenario("A", "B").dof == 4
        assert "four degrees of freedom" in statements()[6]

    def test_9_signs(self):
        means = judged().mean(axis=2)
        assert (means[0] < means[2]).all()
        assert am.compare_sign_flip(means[0], means[2]).p_value == 2 / 32
        assert "p = 2/32" in statements()[9]

    def test_11_median(self):
        medians = [np.median(judged(failed=value)[1]).round(3) for value in (2.0, 5.0)]
        assert medians == [0.274, 0.274]
        assert "0.274 m" in statements()[11]

    def test_13_nees(self):
        values = np.delete(table("nees")[0], TUNING, axis=0)
        values = values[~np.isnan(values)]
        band = stats.chi2.ppf([0.025, 0.975], 3 * len(values)) / len(values)
        assert len(values) == 29
        assert values.mean().round(2) == 2.75
        assert band.round(2).tolist() == [2.18, 3.95]
        for number in ("29 finished", "2.75", "87 degrees", "2.18 to 3.95"):
            assert number in statements()[13]

    def test_17_all_failures_of_a_and_c_are_on_the_ramp(self):
        lost = np.isnan(table()).any(axis=2)
        for system in (0, 2):
            assert [SCENARIOS[k] for k in np.flatnonzero(lost[system])] == ["ramp"]


class TestFaults:
    """Each fault has changed a number, and it is the one in the report."""

    def test_2_failures_left_out(self):
        sound = judged().mean(axis=(1, 2))
        finished = np.nanmean(np.delete(table(), TUNING, axis=1), axis=(1, 2))
        assert sound.round(3).tolist() == [0.419, 0.669, 0.485]
        assert finished[1].round(3) == 0.264
        assert "A 0.419 m, B 0.264 m, C 0.485 m" in statements()[2]

    def test_4_alignment(self):
        hall = SCENARIOS.index("hall")
        assert table("aligned_m")[2, hall].mean().round(3) == 0.207
        assert table()[0, hall].mean().round(3) == 0.354
        assert table()[2, hall].mean() > table()[0, hall].mean() + 0.1
        assert "C (0.207 m) is ahead of A (0.354 m)" in statements()[4]

    def test_5_pairs(self):
        a, _, c = judged().reshape(3, -1)
        limits = stats.ttest_ind(a, c).confidence_interval()
        assert np.round(limits, 3).tolist() == [-0.228, 0.096]
        assert by_scenario("A", "C").verdict == "A better"
        assert "−0.228 to 0.096 m" in statements()[5]

    def test_7_best_seed(self):
        yard = table()[:, SCENARIOS.index("yard")]
        assert (yard[2].argmin() + 1, yard[2].min()) == (5, 0.269)
        assert yard[0].mean().round(3) == 0.286 < yard[2].mean()
        assert "C (0.269 m, seed 5) is ahead of A (0.286 m)" in statements()[7]

    def test_8_and_10_p_values(self):
        p = [by_scenario(*pair).p_value for pair in ("AB", "AC", "BC")]
        assert np.round(p, 3).tolist() == [0.055, 0.028, 0.156]
        assert (am.holm(p) > 0.05).all()
        assert "0.055, 0.028 and 0.156" in statements()[8]
        assert "p = 0.055" in statements()[10]

    def test_12_percentile(self):
        assert np.nanmean(np.delete(table("p95_m")[0], TUNING, axis=0)).round(3) == 0.654
        assert "0.654 m" in statements()[12]

    def test_14_independence(self):
        instants = 26_100
        assert (stats.chi2.ppf(0.975, 3 * instants) / instants).round(2) == 3.03
        assert "3.09" in statements()[14]

    def test_15_tuning(self):
        means = np.nan_to_num(table(), nan=FAILED).mean(axis=(1, 2))
        assert means.round(3)[[0, 2]].tolist() == [0.378, 0.468]
        assert "0.378 m, and C's is 0.468 m" in statements()[15]

    def test_16_stopping(self):
        means = judged()[:, :, :4].mean(axis=2)
        early = am.compare_paired(means[0], means[2])
        assert early.lower < 0 < early.upper
        assert by_scenario("A", "C").upper < 0


if __name__ == "__main__":
    PATH.write_text("\n".join(trials_log()) + "\n", encoding="utf-8", newline="\n")
