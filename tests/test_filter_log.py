"""The filter log of problem set 04 is what the simulation writes, and shows what is asked.

``python3 tests/test_filter_log.py`` writes it again.
"""

from pathlib import Path

import numpy as np

import amrmetrics as am

PATH = Path(__file__).parents[1] / "solutions" / "04_consistency" / "filter_log.csv"
COLUMNS = "robot,run,t,ex,ey,eh,Pxx,Pxy,Pxh,Pyy,Pyh,Phh,left,right,Sll,Slr,Srr"
FAULTS = ({"process_scale": 1 / 4}, {"measurement_scale": 4})
RUNS, STEPS = 16, range(20, 201, 20)
# Ranges from two receivers, 1 m to the left and 1 m to the right of the robot's center, to first
# order, by range and bearing. Their innovations share the noise of the range: who leaves the
# correlation out gets another NIS, which range and bearing themselves would not show.
RECEIVERS = np.array([[1.0, -1.0], [1.0, 1.0]])


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
            S = RECEIVERS @ log.S[:, k - 1, first] @ RECEIVERS.T
            nu = log.innovations[:, k - 1, first] @ RECEIVERS.T
            head = [np.full(RUNS, robot), np.arange(RUNS), np.full(RUNS, k * run.dt)]
            rows.append(np.column_stack([*head, e, P, nu, S[:, *np.triu_indices(2)]]))
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


def test_the_correlation_of_the_innovations_is_felt():
    log = np.loadtxt(PATH, delimiter=",", skiprows=1)
    nu = log[:, 12:14]
    S = log[:, [14, 15, 15, 16]].reshape(-1, 2, 2)
    assert np.all(S[:, 0, 1] > 0.8 * np.sqrt(S[:, 0, 0] * S[:, 1, 1]))
    whole = am.nis(nu, S)
    by_variances = nu[:, 0] ** 2 / S[:, 0, 0] + nu[:, 1] ** 2 / S[:, 1, 1]
    for robot in (0, 1):
        mine = log[:, 0] == robot
        assert abs(whole[mine].mean() - by_variances[mine].mean()) > 0.02


if __name__ == "__main__":
    np.savetxt(PATH, filter_log(), "%.6g", ",", header=COLUMNS, comments="", encoding="utf-8")
