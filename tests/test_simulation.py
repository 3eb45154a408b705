"""The source lesson's demonstration: its golden numbers, and where the lesson is wrong.

Everything is computed here from the definitions, with nothing of the library but the data.
"""

import numpy as np
import pytest
from scipy import integrate, stats

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


def test_erratum_e1_the_rpe_shortcut_depends_on_the_frame(run):
    X, X_hat = run.truth, run.estimate
    moved = aligned(X, X_hat)
    assert f"{rpe_shortcut(X, X_hat):.6f} {rpe_shortcut(X, moved):.6f}" == "0.075461 0.058794"
    assert f"{rpe(X, X_hat):.6f} {rpe(X, moved):.6f}" == "0.058960 0.058960"


@pytest.mark.parametrize("degrees", [7, -30, 180])
def test_erratum_e1_size_of_the_phantom_error(run, degrees):
    gamma = np.radians(degrees)
    G = am.planar_poses([[1.5, -0.8]], [gamma])[0]
    X = run.truth
    expected = 2 * abs(np.sin(gamma / 2)) * rms((X[5:] - X[:-5])[:, :2, 2])
    assert rpe_shortcut(X, G @ X) == pytest.approx(expected, rel=1e-12)
    assert rpe(X, G @ X) < 1e-12


def test_erratum_e2_the_expected_nis_is_not_2(run):
    mean = squares(run.innovations, run.innovation_covariance).mean()
    drawn, stated = np.array([0.08, np.radians(2.0)]), np.array([0.1, np.radians(2.5)])
    expected = np.sum(drawn**2 / stated**2)
    assert expected == pytest.approx(1.28)
    low, high = stats.chi2.ppf([0.025, 0.975], 400) / 200
    assert f"{low:.3f} {high:.3f}" == "1.732 2.287"
    assert mean < low
    # Under its true distribution, 0.64 chi2_400 / 200, the value is an ordinary one.
    assert 0.025 < stats.chi2.cdf(200 * mean / 0.64, 400) < 0.975


def test_erratum_e3_the_expected_anees_is_not_3_and_the_test_rarely_sees_it(run):
    mean = squares(run.errors, run.error_covariance).mean()
    ratio = (1.0 / 1.1) ** 2
    assert f"{2 + ratio:.3f}" == "2.826"
    low, high = stats.chi2.ppf([0.025, 0.975], 600)
    assert f"{low / 200:.3f} {high / 200:.3f}" == "2.670 3.349"
    assert low < 200 * mean < high

    # 200 ANEES = A + ratio B with A ~ chi2_400 and B ~ chi2_200, independent.
    def below(limit):
        density = stats.chi2(200).pdf
        return integrate.quad(
            lambda b: density(b) * stats.chi2.cdf(limit - ratio * b, 400), 90, 350, epsabs=1e-10
        )[0]

    power = below(low) + 1 - below(high)
    assert f"{power:.3f}" == "0.171"


def test_erratum_e4_the_fudge_makes_an_undefined_precision_the_worst_one(run):
    nothing = np.zeros_like(run.occupied)
    tp, fp = np.sum(nothing & run.occupied), np.sum(nothing & ~run.occupied)
    assert tp == fp == 0
    assert tp / (tp + fp + 1e-12) == 0
    # It also makes a perfect precision imperfect.
    assert 1 / (1 + 0 + 1e-12) < 1


def test_erratum_e5_clipping_belongs_to_the_logarithm(run):
    q, p = run.occupied, run.probability
    for clip in (1e-12, 1e-6, 1e-3):  # no probability of the demonstration is that certain
        assert brier(q, np.clip(p, clip, 1 - clip)) == brier(q, p)
    # A map that is certain and right has Brier score 0, and not clip**2.
    assert brier(q, q.astype(float)) == 0
    assert brier(q, np.clip(q, 0.01, 0.99)) == pytest.approx(1e-4)
    # A clipped logarithm is not strictly proper: below the clip the truth gains nothing.
    rate, clip = 1e-4, 1e-3

    def expected_score(report):
        report = np.clip(report, clip, 1 - clip)
        return -rate * np.log(report) - (1 - rate) * np.log(1 - report)

    assert expected_score(rate) == expected_score(clip / 2) == expected_score(0)


def test_erratum_e6_an_explicit_inverse_accepts_what_is_no_covariance():
    indefinite = np.array([[1.0, 2.0], [2.0, 1.0]])
    assert squares(np.array([[1.0, -1.0]]), indefinite)[0] == pytest.approx(-2)
    with pytest.raises(np.linalg.LinAlgError):
        np.linalg.cholesky(indefinite)


def test_erratum_e7_heading_depends_on_the_rule_of_differences(run):
    t, X = run.stamps, run.truth
    forward = np.diff(X[:, :2, 2], axis=0)
    one_sided = np.arctan2(forward[:, 1], forward[:, 0])
    exact = np.arctan2(0.8 * np.cos(0.4 * t), 0.5)
    heading = np.arctan2(X[:, 1, 0], X[:, 0, 0])
    inner = slice(1, -1)
    central_error = np.degrees(np.abs(heading - exact)[inner].max())
    one_sided_error = np.degrees(np.abs(one_sided - exact[:-1]).max())
    assert f"{central_error:.2f} {one_sided_error:.2f}" == "0.01 1.84"
    # Standing still, the rule has no answer at all, and arctan2 gives 0 without a word.
    assert np.arctan2(0.0, 0.0) == 0


def test_erratum_e8_successive_instants_are_not_independent_trials():
    # AR(1) errors with the stated variance: consistent at every instant. 400 runs.
    rng, phi, runs, n = np.random.default_rng(8), 0.9, 400, 200
    z = rng.standard_normal((n, runs, 3))
    for k in range(1, n):
        z[k] = phi * z[k - 1] + np.sqrt(1 - phi**2) * z[k]
    low, high = stats.chi2.ppf([0.025, 0.975], 3 * n) / n
    mean = np.sum(z**2, axis=2).mean(axis=0)
    alarms = np.mean((mean < low) | (mean > high))
    assert alarms > 0.4  # 0.05 is promised
