"""The source lesson's demonstration: its golden numbers.

Everything is computed here from the definitions, with nothing of the library but the data.
"""

import numpy as np
import pytest

import amrmetrics as am


@pytest.fixture(scope="module")
def run():
    return am.simulation.demonstration()


def centered(X):
    xy = X[:, :2, 2]
    return xy - xy.mean(axis=0)


def best_angle(X, X_hat):
    (x, y), (u, v) = centered(X).T, centered(X_hat).T
    return np.arctan2(np.sum(u * y - v * x), np.sum(u * x + v * y))


def aligned(X, X_hat):
    """Turn the estimate by the best angle; what it is shifted by does not matter here."""
    c, s = np.cos(best_angle(X, X_hat)), np.sin(best_angle(X, X_hat))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ X_hat


def rms(rows):
    return np.sqrt(np.mean(np.sum(rows**2, axis=1)))


def rpe(X, X_hat, delta=5):
    inv = np.linalg.inv
    step, step_hat = (inv(Y[:-delta]) @ Y[delta:] for Y in (X, X_hat))
    return rms((inv(step) @ step_hat)[:, :2, 2])


def rpe_shortcut(X, X_hat, delta=5):
    return rms((X[delta:] - X[:-delta] - X_hat[delta:] + X_hat[:-delta])[:, :2, 2])


def squares(v, C):
    return np.array([x @ np.linalg.inv(C) @ x for x in v])


def cross_entropy(q, p):
    return -np.mean(q * np.log(p) + (1 - q) * np.log(1 - p))


def brier(q, p):
    return np.mean((p - q) ** 2)


class TestGoldenNumbers:
    def test_ate_and_angle(self, run):
        residual = centered(run.truth) - centered(aligned(run.truth, run.estimate))
        assert f"{rms(residual):.7f}" == "0.0732112"
        assert f"{np.degrees(best_angle(run.truth, run.estimate)):.6f}" == "7.139879"

    def test_anees_and_nis(self, run):
        assert f"{squares(run.errors, run.error_covariance).mean():.6f}" == "2.895405"
        assert f"{squares(run.innovations, run.innovation_covariance).mean():.6f}" == "1.314600"

    def test_scores(self, run):
        assert f"{cross_entropy(run.occupied, run.probability):.6f}" == "0.126164"
        assert f"{brier(run.occupied, run.probability):.7f}" == "0.0198597"

    def test_confusion(self, run):
        hit, q = run.probability >= 0.5, run.occupied
        tp, fp, fn, tn = (np.sum(m) for m in (hit & q, hit & ~q, ~hit & q, ~hit & ~q))
        assert (tp, fp, fn, tn) == (1884, 17, 1, 6098)
        assert f"{2 * tp / (2 * tp + fp + fn):.6f}" == "0.995246"
        assert f"{tp / (tp + fp + fn):.6f}" == "0.990536"

    def test_is_what_the_lesson_describes(self, run):
        t, xy = run.stamps, run.truth[:, :2, 2]
        assert (t[0], t[-1], len(t)) == (0, 20, 200)
        assert np.allclose(xy, np.column_stack([0.5 * t, 2 * np.sin(0.4 * t)]))
        assert run.occupied.shape == run.probability.shape == (80, 100)
        assert run.occupied[35, 53] and not run.occupied[35, 54]  # the disc: row y, column x
        assert run.occupied[54, 71] and not run.occupied[55, 71] and not run.occupied[54, 70]

    def test_same_seed_same_data(self, run):
        again = am.simulation.demonstration(19)
        assert all(np.array_equal(a, b) for a, b in zip(run, again, strict=True))
        assert not np.array_equal(am.simulation.demonstration(20).estimate, run.estimate)
