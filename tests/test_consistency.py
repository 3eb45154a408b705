"""NEES and NIS are quadratic forms of real covariances, and their test keeps its promises."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from scipy.stats import chi2, kstest, ncx2

import amrmetrics as am

SEEDS = st.integers(0, 2**32 - 1)


def random_covariances(rng, n, dim):
    A = rng.normal(size=(n, dim, dim))
    return A @ A.swapaxes(1, 2) + 0.1 * np.eye(dim)


class TestPoseErrors:
    def test_plane(self, rng):
        X = am.planar_poses(rng.normal(size=(50, 2)), rng.uniform(-9, 9, 50))
        e = np.c_[rng.normal(size=(50, 2)), rng.uniform(-np.pi, np.pi, 50)]
        Y = am.planar_poses(am.positions(X) - e[:, :2], am.yaw(X) - e[:, 2])
        assert np.allclose(am.pose_errors(X, Y), e)

    def test_space(self, rng):
        Y = am.spatial_poses(rng.normal(size=(50, 3)), Rotation.random(50, rng=rng).as_quat())
        t, phi = rng.uniform(-1.5, 1.5, size=(2, 50, 3))
        X = Y.copy()
        X[:, :3, 3] += t
        X[:, :3, :3] = Rotation.from_rotvec(phi).as_matrix() @ Y[:, :3, :3]
        assert np.allclose(am.pose_errors(X, Y), np.c_[t, phi])

    def test_the_heading_error_is_wrapped(self):
        X, Y = (am.planar_poses([[0, 0]], [np.radians(a)]) for a in (-179, 179))
        assert am.pose_errors(X, Y)[0, 2] == pytest.approx(np.radians(2))


@pytest.mark.parametrize("dim", [1, 2, 3, 6])
class TestNees:
    def test_equals_the_definition(self, rng, dim):
        P, e = random_covariances(rng, 100, dim), rng.normal(size=(100, dim))
        expected = np.einsum("ni,nij,nj->n", e, np.linalg.inv(P), e)
        assert np.allclose(am.nees(e, P), expected, rtol=1e-10)
        assert np.array_equal(am.nis(e, P), am.nees(e, P))
        assert np.allclose(am.nees(e, P[0]), am.nees(e, np.tile(P[0], (100, 1, 1))))

    @given(seed=SEEDS)
    def test_no_change_of_coordinates_changes_it(self, dim, seed):
        rng = np.random.default_rng(seed)
        P, e = random_covariances(rng, 5, dim), rng.normal(size=(5, dim))
        T = rng.normal(size=(dim, dim)) + 3 * np.eye(dim)
        if np.linalg.cond(T) < 1e3:
            moved = T @ P @ T.T
            moved = (moved + moved.swapaxes(1, 2)) / 2
            assert np.allclose(am.nees(e @ T.T, moved), am.nees(e, P), rtol=1e-6)

    def test_adds_over_independent_blocks(self, rng, dim):
        P, Q = random_covariances(rng, 20, dim), random_covariances(rng, 20, 2)
        e, f = rng.normal(size=(20, dim)), rng.normal(size=(20, 2))
        both = np.zeros((20, dim + 2, dim + 2))
        both[:, :dim, :dim], both[:, dim:, dim:] = P, Q
        assert np.allclose(am.nees(np.c_[e, f], both), am.nees(e, P) + am.nees(f, Q))

    @pytest.mark.parametrize("seed", range(20))
    def test_is_chi_square(self, dim, seed):
        # One false alarm in 10 000 per seed; n + 1 degrees of freedom would be found.
        rng = np.random.default_rng(seed)
        P = random_covariances(rng, 1, dim)[0]
        e = rng.normal(size=(4000, dim)) @ np.linalg.cholesky(P).T
        values = am.nees(e, P)
        assert kstest(values, chi2(dim).cdf).pvalue > 1e-4
        assert kstest(values, chi2(dim + 1).cdf).pvalue < 1e-8

    def test_inputs_are_not_changed(self, rng, dim):
        P, e = random_covariances(rng, 4, dim), rng.normal(size=(4, dim))
        P0, e0, single = P.copy(), e.copy(), P[0].copy()
        am.nees(e, P)
        am.nees(e, single)
        assert np.array_equal(P, P0)
        assert np.array_equal(e, e0)
        assert np.array_equal(single, P0[0])


class TestTwoSidedTest:
    def test_bounds_of_the_lesson(self):
        result = am.consistency_test(np.full(200, 1.3146), 2)
        assert (result.lower, result.upper) == pytest.approx((1.732, 2.287), abs=5e-4)
        assert result.verdict == "underconfident"

    def test_bounds_that_a_popular_one_sided_rule_lacks(self):
        result = am.consistency_test(np.full(80, 2.0), 2)
        assert (result.lower, result.upper) == pytest.approx((1.586, 2.461), abs=5e-4)
        assert chi2.sf(160, 160) == pytest.approx(0.485, abs=5e-4)

    @pytest.mark.parametrize("confidence", [0.8, 0.95, 0.99])
    def test_a_consistent_filter_passes_as_often_as_promised(self, rng, confidence):
        runs = rng.chisquare(3, size=(2000, 30))
        passed = [am.consistency_test(r, 3, confidence).verdict == "consistent" for r in runs]
        spread = np.sqrt(confidence * (1 - confidence) / len(runs))
        # Correlation is suspected in 0.3 % of independent recordings and widens the interval.
        assert abs(np.mean(passed) - confidence) < 4 * spread + 0.003

    def test_verdicts_and_p_value(self, rng):
        values = rng.chisquare(3, size=400)
        assert am.consistency_test(2 * values, 3).verdict == "overconfident"
        assert am.consistency_test(values / 2, 3).verdict == "underconfident"
        result = am.consistency_test([3.0], 3)
        expected = 2 * min(chi2.cdf(3, 3), chi2.sf(3, 3))
        assert result.p_value == pytest.approx(expected)
        assert result.n == 1

    def test_correlated_values_are_not_taken_for_independent(self):
        # Errors with phi = 0.9 have NEES correlations 0.81**k, so 9.5 values are worth one.
        rng = np.random.default_rng(4)
        wrong, naive, worth = 0, 0, []
        for _ in range(300):
            x = np.empty(500)
            x[0] = rng.normal()
            for t in range(1, 500):
                x[t] = 0.9 * x[t - 1] + np.sqrt(0.19) * rng.normal()
            result = am.consistency_test(x**2, 1)
            worth.append(result.n_effective)
            wrong += result.verdict != "consistent"
            naive += not chi2.ppf(0.025, 500) < 500 * result.mean < chi2.ppf(0.975, 500)
        assert naive / 300 > 0.4
        assert wrong / 300 < 0.15
        assert np.median(worth) == pytest.approx(500 * 0.19 / 1.81, rel=0.3)
        assert "correlated in time" in repr(result)

    def test_several_runs(self, rng):
        values = rng.chisquare(2, size=(20, 50))
        result = am.consistency_test(values, 2, confidence=0.9999)
        assert result.n == 1000
        assert result.verdict == "consistent"
        # What follows in time is the last axis: a slow change inside each run is noticed.
        slow = values + 3 * np.sin(np.arange(50) / 10) + 3
        assert am.consistency_test(slow, 2).n_effective < 300


class TestMisspecified:
    @pytest.mark.parametrize("seed", range(20))
    def test_mean_and_variance_by_simulation(self, seed):
        rng = np.random.default_rng(seed)
        P, Sigma = random_covariances(rng, 2, 3)
        bias = rng.normal(size=3)
        e = bias + rng.normal(size=(20_000, 3)) @ np.linalg.cholesky(Sigma).T
        values = am.nees(e, P)
        mean, variance = am.expected_nees(P, Sigma, bias), am.nees_variance(P, Sigma, bias)
        assert abs(values.mean() - mean) < 5 * np.sqrt(variance / len(e))
        assert values.var() == pytest.approx(variance, rel=0.25)

    def test_a_bias_alone_is_noncentral_chi_square(self):
        b = np.array([0.5, -1.0])
        law = ncx2(2, b @ b)
        assert am.expected_nees(np.eye(2), np.eye(2), b) == pytest.approx(law.mean())
        assert am.nees_variance(np.eye(2), np.eye(2), b) == pytest.approx(law.var())

    def test_erratum_e3(self):
        P, Sigma = np.diag([1, 1, 1.1**2]), np.eye(3)
        assert am.expected_nees(P, Sigma) == pytest.approx(2.826, abs=5e-4)


class TestPower:
    @pytest.mark.parametrize("inflation", [0.5, 0.8, 1.25, 2.0])
    def test_by_simulation(self, rng, inflation):
        means = rng.chisquare(3 * 20, size=20_000) / inflation / 20
        low, high = chi2.ppf([0.025, 0.975], 60) / 20
        noticed = ((means < low) | (means > high)).mean()
        power = am.consistency_power(3, 20, inflation)
        assert abs(noticed - power) < 5 * np.sqrt(power * (1 - power) / 20_000)

    def test_is_the_false_alarm_rate_without_a_fault(self):
        assert am.consistency_power(3, 20, 1.0, 0.9) == pytest.approx(0.1)

    def test_broadcasts(self):
        power = am.consistency_power(3, [10, 100], [0.5])
        assert power.shape == (2,)
        assert power[1] > power[0]

    def test_runs_needed_is_the_smallest(self):
        n = am.runs_needed(3, 0.9, power=0.9)
        assert am.consistency_power(3, n - 1, 0.9) < 0.9 <= am.consistency_power(3, n, 0.9)


EYE = np.eye(2)
REFUSED = {
    "asymmetric": (lambda: am.nees([[1, 2]], [[1, 2], [0, 1]]), "covariances is not symmetric"),
    "singular": (lambda: am.nees([[1, 2]], [[1, 1], [1, 1]]), "not positive definite"),
    "negative": (
        lambda: am.nis(np.ones((3, 2)), np.stack([EYE, EYE, -EYE])),
        r"covariances\[2\] is not positive definite",
    ),
    "shape": (lambda: am.nees([[1, 2]], np.eye(3)), r"covariances has shape \(3, 3\)"),
    "one row": (lambda: am.nees([1, 2], EYE), r"errors has shape \(2,\)"),
    "nis names itself": (lambda: am.nis([1, 2], EYE), "innovations has shape"),
    "empty": (lambda: am.nees(np.zeros((0, 2)), EYE), "N >= 1"),
    "nan": (lambda: am.nees([[np.nan, 1]], EYE), r"errors\[0, 0\] is nan"),
    "negative nees": (lambda: am.consistency_test([1, -1], 2), r"values\[1\] is -1"),
    "no values": (lambda: am.consistency_test([], 2), r"shape \(0,\)"),
    "dof": (lambda: am.consistency_test([1], 0), "dof is 0"),
    "half dof": (lambda: am.consistency_test([1], 1.5), "dof is 1.5"),
    "confidence": (lambda: am.consistency_test([1], 2, 95), "confidence is 95"),
    "expected shapes": (lambda: am.expected_nees(EYE, np.eye(3)), r"P has shape \(2, 2\)"),
    "expected bias": (lambda: am.expected_nees(EYE, EYE, [1, 2, 3]), r"bias has shape \(3,\)"),
    "expected singular": (lambda: am.expected_nees(0 * EYE, EYE), "P is not positive"),
    "inflation": (lambda: am.consistency_power(2, 10, -1), "inflation is -1"),
    "trials": (lambda: am.consistency_power(2, 0, 2), "trials is 0"),
    "hopeless power": (lambda: am.runs_needed(2, 0.9, power=0.04), "power is 0.04"),
    "no fault": (lambda: am.runs_needed(2, 1.0), "never shown"),
    "unaligned shapes": (
        lambda: am.pose_errors(np.eye(3)[None], np.eye(4)[None]),
        "reference is 2-D and estimate is 3-D",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()
