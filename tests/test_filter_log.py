"""The filter log of problem set 04 is what the simulation writes, and shows what is asked.

``python3 tests/test_filter_log.py`` writes it again.
"""

from pathlib import Path

import numpy as np

import amrmetrics as am

PATH = Path(__file__).parents[1] / "solutions" / "04_consistency" / "filter_log.csv"
COLUMNS = "robot,run,t,ex,ey,eh,Pxx,Pxy,Pxh,Pyy,Pyh,Phh,range,bearing,Srr,Srb,Sbb"
FAULTS = ({"process_scale": 1 / 4}, {"measurement_scale": 4})
RUNS, STEPS = 16, range(20, 201, 20)


def filter_log():
    """Return one row per robot, run and instant, with the first innovation of the instant."""
    rng, rows = np.random.default_rng(4), []
    for robot, fault in enumerate(FAULTS):
        run = am.simulation.drive(rng, runs=RUNS)
        log = am.simulation.ekf_localization(run, **fault)
        for k in STEPS:
            e = am.pose_errors(run.truth[:, k], log.estimate[:, k])
            P = log.covariances[:, k][:, *np.triu_indices(3)]
            first = np.flatnonzero(log.used[k - 1])[0]
            S = log.S[:, k - 1, first][:, *np.triu_indices(2)]
            head = [np.full(RUNS, robot), np.arange(RUNS), np.full(RUNS, k * run.dt)]
            rows.append(np.column_stack([*head, e, P, log.innovations[:, k - 1, first], S]))
    rows = np.concatenate(rows)
    return rows[np.lexsort(rows[:, [2, 1, 0]].T)]


def test_is_reproduced():
    stored = np.loadtxt(PATH, delimiter=",", skiprows=1)
    assert np.allclose(stored, filter_log(), rtol=1e-4, atol=1e-9)
    assert PATH.read_text(encoding="utf-8").splitlines()[0] == COLUMNS
    assert PATH.stat().st_size < 100_000


def test_each_fault_can_be_seen():
    log = np.loadtxt(PATH, delimiter=",", skiprows=1)
    verdicts = []
    for robot in (0, 1):
        rows = log[log[:, 0] == robot]
        P = rows[:, [6, 7, 8, 7, 9, 10, 8, 10, 11]].reshape(-1, 3, 3)
        S = rows[:, [14, 15, 15, 16]].reshape(-1, 2, 2)
        for values, dof in ((am.nees(rows[:, 3:6], P), 3), (am.nis(rows[:, 12:14], S), 2)):
            test = am.consistency_test(values.reshape(RUNS, -1), dof, confidence=0.999)
            verdicts.append(test.verdict)
    assert verdicts == ["overconfident", "consistent", "underconfident", "underconfident"]
    assert np.array_equal(log[:, 0], np.repeat([0, 1], len(log) // 2))


if __name__ == "__main__":
    np.savetxt(PATH, filter_log(), "%.6g", ",", header=COLUMNS, comments="", encoding="utf-8")
