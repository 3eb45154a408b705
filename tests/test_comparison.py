"""Comparisons agree with SciPy and statsmodels, keep their promises, and lose no failed run."""

import itertools
import json
import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import binomtest, bootstrap, nct, permutation_test, trim_mean, ttest_rel
from statsmodels.stats.multitest import multipletests
from statsmodels.stats.power import TTestPower

import amrmetrics as am
from amrmetrics import _runs, comparison, resampling

NAN = float("nan")

# Problem P5 of the lesson: differences of 8 runs in meters.
P5 = np.array([0.12, 0.08, 0.10, 0.03, 0.09, 0.05, 0.07, 0.11])
BASE = np.array([0.41, 0.40, 0.38, 0.42, 0.39, 0.43, 0.40, 0.37])

DIFFERENCES = st.lists(st.integers(-6, 6), min_size=2, max_size=9).map(np.array)


def falls_short(rate, promised, runs):
    """Return by how many standard errors a measured coverage is below what is promised."""
    return (promised - rate) / np.sqrt(promised * (1 - promised) / runs)


class TestP5:
    def test_every_figure_of_the_lesson(self):
        found = am.compare_paired(BASE + P5, BASE, unit="m")
        assert found.mean == pytest.approx(0.08125, abs=1e-12)
        assert found.std == pytest.approx(0.030443, abs=5e-7)
        assert found.lower == pytest.approx(0.055799, abs=5e-7)
        assert found.upper == pytest.approx(0.106701, abs=5e-7)
        assert found.t == pytest.approx(7.549, abs=5e-4)
        assert (found.n, found.dof, found.verdict) == (8, 7, "B better")

    def test_says_who_by_how_much_in_which_unit_and_why(self):
        text = repr(am.compare_paired(BASE + P5, BASE, unit="m"))
        assert text.startswith("B better by 0.08125 m: mean of A - B 0.08125 m, 95 % interval")
        assert "n 8, lower is better; paired t, which assumes independent runs with normal" in text
        assert "Cohen's d_z 2.67 [1.12, 4.19]" in text

    def test_all_three_agree(self):
        for compare in (am.compare_paired, am.compare_bootstrap, am.compare_sign_flip):
            found = compare(BASE + P5, BASE, unit="m")
            assert found.verdict == "B better"
            assert found.estimate == pytest.approx(0.08125)
            assert 0.05 < found.lower < 0.06
            assert 0.09 < found.upper < 0.11
            assert isinstance(found, am.Comparison)
            assert json.loads(json.dumps(found.as_dict()))["unit"] == "m"
        assert am.compare_sign_flip(BASE + P5, BASE).p_value == 2 / 2**8


class TestPaired:
    @settings(max_examples=60)
    @given(st.integers(0, 2**32 - 1), st.integers(2, 40), st.sampled_from([0.8, 0.95, 0.999]))
    def test_agrees_with_scipy(self, seed, n, confidence):
        a, b = np.random.default_rng(seed).normal(size=(2, n))
        found, peer = am.compare_paired(a, b, confidence), ttest_rel(a, b)
        assert found.t == pytest.approx(peer.statistic, rel=1e-9)
        assert found.p_value == pytest.approx(peer.pvalue, rel=1e-9)
        assert (found.lower, found.upper) == pytest.approx(
            tuple(peer.confidence_interval(confidence)), rel=1e-9
        )
        assert (found.verdict != "undecided") == (found.p_value < 1 - confidence)

    def test_the_verdict_follows_the_sign_and_what_is_good(self):
        a, b = BASE + P5, BASE
        assert am.compare_paired(b, a).verdict == "A better"
        assert am.compare_paired(a, b, better="higher").verdict == "A better"
        assert am.compare_paired(b, a, better="higher").verdict == "B better"
        assert am.compare_paired(b, a).mean == pytest.approx(-0.08125)
        assert repr(am.compare_paired(b, a)).startswith("A better by 0.08125:")

    def test_undecided(self):
        found = am.compare_paired([1, 2, 3], [2, 2, 2])
        assert found.verdict == "undecided"
        assert repr(found).startswith("undecided: mean of A - B 0, 95 %")

    @pytest.mark.parametrize("t", [-4000.0, -2.5, 0.0, 1e-6, 0.7, 30.0, 900.0])
    @pytest.mark.parametrize("dof", [1, 7, 300])
    def test_the_effect_inverts_the_noncentral_t(self, t, dof):
        low, high = comparison._noncentral_limits(t, dof, 0.9)
        if abs(t) <= 1000:
            sign = 1 if t >= 0 else -1
            ends = sorted((sign * low, sign * high))
            found = nct.cdf(abs(t), dof, ends)
            assert found == pytest.approx([0.95, 0.05], abs=1e-6)
        else:
            near = comparison._noncentral_limits(t / 4, dof, 0.9)
            assert (low, high) == pytest.approx(4 * near, rel=1e-3)

    @pytest.mark.parametrize("n", [3, 8, 30])
    def test_intervals_of_mean_and_effect_cover(self, rng, n):
        # Exact for normal differences; one false alarm in 10 000 a case.
        runs, hits, effects = 2000, 0, 0
        for d in rng.normal(0.5, 1, size=(runs, n)):
            found = am.compare_paired(d, np.zeros(n))
            hits += found.lower <= 0.5 <= found.upper
            effects += found.effect_lower <= 0.5 <= found.effect_upper
        assert abs(falls_short(hits / runs, 0.95, runs)) < 3.9
        assert abs(falls_short(effects / runs, 0.95, runs)) < 3.9

    @pytest.mark.parametrize("difference", [0.0, 0.1])
    def test_identical_differences_have_no_interval(self, difference):
        # 0.3 - 0.2 and 0.2 - 0.1 differ in the last place only.
        b = np.array([0.1, 0.2, 0.3, 0.4])
        found = am.compare_paired(b + difference, b)
        assert found.verdict == "undecided"
        assert found.mean == pytest.approx(difference)
        assert np.isnan([found.lower, found.upper, found.t, found.p_value, found.effect]).all()
        assert "all 4 differences are equal" in found.undefined["p_value"]
        assert "compare_sign_flip needs no spread" in repr(found)

    def test_small_differences_of_large_values_are_not_identical(self):
        a = 1e6 + np.array([0.0, 1e-6, 3e-6])
        assert not np.isnan(am.compare_paired(a, np.full(3, 1e6)).t)

    def test_two_runs(self):
        found = am.compare_paired([1, 3], [0, 0])
        assert found.t == pytest.approx(2)
        assert found.upper == pytest.approx(2 + 12.7062047)

    def test_takes_results_with_their_unit(self, rng):
        X = rng.normal(size=(20, 2))
        runs = [[am.ate(X, X + s * rng.normal(size=X.shape)) for _ in "1234"] for s in (1, 0.1)]
        found = am.compare_paired(*runs)
        assert found.unit == "m"
        assert found.mean == pytest.approx(np.mean([a.rmse - b.rmse for a, b in zip(*runs)]))  # noqa: B905


class TestFailures:
    A = np.array([0.5, NAN, 0.7, 0.6, NAN, 0.8, 0.9, 0.6])
    B = np.array([0.3, 0.4, 0.3, NAN, NAN, 0.2, 0.5, 0.3])

    def test_counted_under_every_rule(self):
        for rule in ("worst", "censored", "separate"):
            found = am.compare_sign_flip(self.A, self.B, failures=rule)
            assert (found.failed_a, found.failed_b, found.failed_both) == (2, 2, 1)
            assert found.failures == rule
            assert f"failed: A 2, B 2 (both 1), rule {rule}" in repr(found)

    def test_worst(self):
        found = am.compare_paired(self.A, self.B, failures="worst")
        expected = np.where(np.isnan(self.A), 0.9, self.A) - np.where(np.isnan(self.B), 0.9, self.B)
        assert found.failure_value == 0.9
        assert found.n == 8
        assert found.mean == pytest.approx(expected.mean())
        assert "entered as 0.9" in repr(found)
        stated = am.compare_paired(self.A, self.B, failures="worst", worst=5)
        assert stated.failure_value == 5
        assert am.compare_paired(self.A, self.B, failures="worst", worst=0.9).failure_value == 0.9

    def test_worst_is_the_smallest_where_higher_is_better(self):
        found = am.compare_paired(self.A, self.B, failures="worst", better="higher")
        assert found.failure_value == 0.2
        with pytest.raises(
            am.AmrError, match=r"worst is 0\.3, but a run that did not fail has 0\.2"
        ):
            am.compare_paired(self.A, self.B, failures="worst", better="higher", worst=0.3)

    def test_separate(self):
        found = am.compare_paired(self.A, self.B, failures="separate")
        both = ~np.isnan(self.A + self.B)
        assert found.n == 5
        assert found.t == pytest.approx(ttest_rel(self.A[both], self.B[both]).statistic)
        assert found.verdict == "B better"

    def test_better_where_both_finish_but_failing_more_is_no_victory(self):
        a, b = BASE + P5, BASE.copy()
        b[0] = NAN
        assert am.compare_paired(a, b, failures="separate").verdict == "conflicting"
        assert am.compare_paired(b, a, failures="separate").verdict == "conflicting"
        a[1] = NAN
        assert am.compare_paired(a, b, failures="separate").verdict == "B better"

    def test_censored_is_the_sign_test(self):
        a = np.array([0.5, NAN, 0.7, 0.6, 0.5, 0.8, 0.9, 0.6, 0.4, NAN])
        b = np.array([0.3, 0.40, 0.3, 0.7, 0.5, 0.2, 0.5, 0.3, 0.3, 0.5])
        found = am.compare_sign_flip(a, b, failures="censored")
        # One tie; of the others B wins 8 of 9.
        assert found.p_value == pytest.approx(binomtest(8, 9).pvalue, rel=1e-12)
        assert found.effect == pytest.approx(8 / 9)
        assert found.statistic == "median"
        d = np.sort(np.where(np.isnan(a), np.inf, a - b))
        assert found.estimate == pytest.approx((d[4] + d[5]) / 2)
        # The 2nd and the 9th of 10, and the 9th is a run that failed.
        assert found.lower == pytest.approx(d[1])
        assert np.isnan(found.upper)
        assert found.undefined["upper"] == "a limit is a run that failed"
        assert np.isnan([found.mean, found.std]).all()
        mirror = am.compare_sign_flip(b, a, failures="censored")
        assert (mirror.p_value, mirror.effect) == (found.p_value, pytest.approx(1 / 9))

    def test_censored_with_higher_values_better(self):
        a, b = np.full(8, NAN), np.arange(8.0)
        a[0] = -1
        found = am.compare_sign_flip(a, b, failures="censored", better="higher")
        assert found.verdict == "B better"
        assert found.effect == 1
        assert np.isnan(found.estimate)
        assert "half of the runs or more are failed ones" in repr(found)

    def test_both_failed_is_a_tie_when_censored(self):
        found = am.compare_sign_flip([NAN, 1, NAN], [NAN, 0, 0], failures="censored")
        assert (found.effect, found.p_value) == (1, 0.5)

    def test_each_failed_once(self):
        found = am.compare_sign_flip([NAN, 1], [1, NAN], failures="censored")
        assert np.isnan(found.estimate)
        assert (found.effect, found.p_value, found.verdict) == (0.5, 1, "undecided")

    def test_the_censored_interval_covers(self, rng):
        # A true median difference of 0.3; a quarter of the runs of A fails, always for the worse.
        runs, hits = 1500, 0
        for d in 0.3 + rng.standard_t(2, size=(runs, 15)):
            a = np.where(d > np.quantile(rng.standard_t(2, 4000), 0.75) + 0.3, NAN, d)
            found = am.compare_sign_flip(a, np.zeros(15), failures="censored")
            low = -np.inf if np.isnan(found.lower) else found.lower
            high = np.inf if np.isnan(found.upper) else found.upper
            hits += low <= 0.3 <= high
        assert falls_short(hits / runs, 0.95, runs) < 3.9

    def test_a_rule_has_to_be_named(self):
        with pytest.raises(
            am.AmrError, match=r"a\[1\] is nan, a run that failed \(2 in all\)"
        ) as e:
            am.compare_paired(self.A, self.B)
        for rule in ("worst", "separate"):  # the advice works
            assert f"failures={rule!r}" in str(e.value)
            am.compare_paired(self.A, self.B, failures=rule)
        with pytest.raises(am.AmrError, match="compare_sign_flip takes them"):
            am.compare_paired(self.A, self.B, failures="censored")

    def test_nobody_finished_beside_the_other(self):
        a, b = np.array([NAN, NAN, NAN, 1]), np.array([1, 2, 3, NAN])
        for compare in (am.compare_paired, am.compare_bootstrap, am.compare_sign_flip):
            found = compare(a, b, failures="separate")
            assert (found.n, found.verdict, found.failed_a) == (0, "undecided", 3)
            assert np.isnan([found.mean, found.lower, found.estimate]).all()
            assert "no run was finished by both" in repr(found)
        one = am.compare_paired([NAN, 2], [1, 1], failures="separate")
        assert (one.n, one.mean) == (1, 1)
        assert "both systems finished 1 of the runs" in one.undefined["lower"]
        assert one.undefined["std"] == "a single run has no spread"

    def test_no_failure_is_said(self):
        assert am.compare_paired([1, 2], [0, 0]).failures == "none failed"
        assert am.compare_paired([1, 2], [0, 0], failures="worst", worst=9).failures == "worst"


class TestBootstrap:
    @pytest.mark.parametrize("method", ["BCa", "percentile"])
    @pytest.mark.parametrize("statistic", [np.mean, np.median])
    def test_is_scipys(self, rng, method, statistic):
        a, b = rng.exponential(size=(2, 30))
        found = am.compare_bootstrap(
            a, b, 0.9, statistic, method, np.random.default_rng(5), resamples=2000
        )
        peer = bootstrap(
            (a - b,),
            statistic,
            n_resamples=2000,
            confidence_level=0.9,
            method=method,
            rng=np.random.default_rng(5),
            batch=max(1, resampling.BLOCK // 30),
        ).confidence_interval
        assert (found.lower, found.upper) == (peer.low, peer.high)
        assert found.estimate == statistic(a - b)
        assert found.statistic == statistic.__name__
        assert found.method == f"{method} bootstrap of 2000 resamples"

    def test_a_statistic_of_your_own(self, rng):
        a, b = rng.normal(size=(2, 40))

        def trimmed(d):
            return trim_mean(d, 0.1)

        found = am.compare_bootstrap(a + 2, b, statistic=trimmed, resamples=500)
        assert found.statistic == "trimmed"
        assert found.lower < found.estimate < found.upper

    def test_repeats_itself_without_a_generator(self, rng):
        a, b = rng.normal(size=(2, 20))
        first, second = (am.compare_bootstrap(a, b, resamples=500) for _ in "12")
        assert (first.lower, first.upper) == (second.lower, second.upper)
        other = am.compare_bootstrap(a, b, rng=np.random.default_rng(1), resamples=500)
        assert other.lower != first.lower

    @pytest.mark.parametrize(("n", "runs"), [(8, 1500), (60, 600)])
    def test_covers_as_often_as_it_says_for_normal_differences(self, rng, n, runs):
        # 3 % for resampling error and for what BCa differs from the percentiles.
        hits = dict.fromkeys(("percentile", "BCa"), 0)
        for d in rng.normal(size=(runs, n)):
            for method in hits:
                found = am.compare_bootstrap(d, np.zeros(n), method=method, rng=rng, resamples=399)
                hits[method] += found.lower <= 0 <= found.upper
        for hit in hits.values():
            assert hit / runs == pytest.approx(found.coverage_if_normal, abs=0.03)
        assert found.enough == (n == 60)

    def test_says_when_runs_are_too_few(self):
        found = am.compare_bootstrap(BASE + P5, BASE)
        assert not found.enough
        assert found.coverage_if_normal == pytest.approx(0.8906, abs=5e-5)
        assert "8 runs are too few for a bootstrap" in found.notes[0]
        assert "take 18 runs" in repr(found)  # and the advice is right:
        rng = np.random.default_rng(2)
        enough = {n: am.compare_bootstrap(*rng.normal(size=(2, n))).enough for n in (17, 18)}
        assert enough == {17: False, 18: True}

    def test_no_acceleration_has_a_reason(self):
        d = np.array([1.0, 1, 1, 1, 1, 1, 1, 1, 1, 5])
        found = am.compare_bootstrap(d, np.zeros(10), statistic=np.median, resamples=500)
        assert np.isnan(found.lower)
        assert "Use method='percentile'" in found.undefined["lower"]
        plain = am.compare_bootstrap(
            d, np.zeros(10), statistic=np.median, method="percentile", resamples=500
        )
        assert plain.lower == 1  # the advice works

    def test_identical_differences(self):
        found = am.compare_bootstrap([2, 3, 4], [1, 2, 3])
        assert np.isnan([found.lower, found.upper]).all()
        assert found.estimate == 1
        assert "all 3 differences are equal" in repr(found)

    def test_ten_thousand_replicates_take_seconds(self, rng):
        a, b = rng.normal(size=(2, 1000))
        start = time.process_time()
        found = am.compare_bootstrap(a, b, rng=rng)
        assert time.process_time() - start < 10
        assert found.resamples == 9999


class TestSignFlip:
    @settings(max_examples=150, deadline=None)
    @given(DIFFERENCES)
    def test_agrees_with_scipy_ties_included(self, d):
        found = am.compare_sign_flip(d / 10, np.zeros(len(d)))
        # SciPy gets whole numbers: of sums that differ by rounding only, it takes some for smaller.
        peer = permutation_test(
            (d,),
            np.mean,
            permutation_type="samples",
            n_resamples=np.inf,
            vectorized=False,
        )
        assert found.p_value == pytest.approx(peer.pvalue, abs=1e-12)
        assert (found.exact, found.flips) == (True, 2 ** len(d))

    @settings(max_examples=150, deadline=None)
    @given(DIFFERENCES, st.sampled_from([0.75, 0.9, 0.95]))
    def test_the_interval_is_what_the_test_does_not_refuse(self, d, confidence):
        d = d / 10
        found = am.compare_sign_flip(d, np.zeros(len(d)), confidence)
        assert (found.verdict != "undecided") == (found.p_value <= 1 - confidence + 1e-12)
        if np.isnan(found.lower):
            assert 2 / 2 ** len(d) > 1 - confidence
            return
        step = 1e-6
        for shift, refused in (
            (found.lower - step, True),
            (found.lower + step, found.upper - found.lower < step),
            (found.upper + step, True),
        ):
            p = am.compare_sign_flip(d - shift, np.zeros(len(d))).p_value
            assert (p <= 1 - confidence + 1e-12) == refused

    def test_by_hand(self):
        d = np.array([3.0, 1.0, -0.5])
        means = [abs(np.mean(s * d)) for s in itertools.product((1, -1), repeat=3)]
        expected = np.mean([m >= abs(d.mean()) - 1e-12 for m in means])
        assert am.compare_sign_flip(d, np.zeros(3)).p_value == expected == 0.5

    def test_exact_up_to_twenty_and_sampled_beyond(self, rng):
        a, b = rng.normal(size=(2, 21))
        assert am.compare_sign_flip(a[:20], b[:20]).exact
        sampled = am.compare_sign_flip(a, b, rng=rng)
        assert (sampled.exact, sampled.flips) == (False, 10_000)
        assert "sampled sign-flip test" in repr(sampled)

    def test_sampled_agrees_with_exact(self, rng, monkeypatch):
        a, b = rng.normal(0.35, 1, size=(2, 18))
        b = b - 0.7
        exact = am.compare_sign_flip(a, b)
        monkeypatch.setattr(resampling, "EXACT_UP_TO", 10)
        found = am.compare_sign_flip(a, b, rng=rng, flips=100_000)
        assert found.p_value == pytest.approx(exact.p_value, abs=0.003)
        assert (found.lower, found.upper) == pytest.approx((exact.lower, exact.upper), abs=0.02)

    def test_a_sampled_p_value_is_never_zero(self):
        found = am.compare_sign_flip(np.ones(40) + np.arange(40), np.zeros(40), flips=1000)
        assert found.p_value == 2 / 1000

    @pytest.mark.parametrize(("n", "draw"), [(8, "standard_t"), (8, "normal"), (25, "normal")])
    def test_the_interval_covers_symmetric_differences(self, rng, n, draw):
        runs, hits = 1000, 0
        size = (runs, n)
        data = rng.standard_t(2, size) if draw == "standard_t" else rng.normal(size=size)
        for d in data:
            found = am.compare_sign_flip(d, np.zeros(n), rng=rng, flips=1000)
            hits += found.lower <= 0 <= found.upper
        # Exactly 1 - 2 floor(0.025 * 2^8) / 2^8 for 8 runs.
        promised = 1 - 2 * 6 / 256 if n == 8 else 0.95
        assert abs(falls_short(hits / runs, promised, runs)) < 3.9

    def test_six_runs_are_the_least(self):
        five = am.compare_sign_flip([1, 2, 3, 4, 5], np.zeros(5))
        assert np.isnan(five.lower)
        assert five.p_value == 2 / 32
        assert five.undefined["lower"] == "an interval needs at least 6 runs"
        six = am.compare_sign_flip([1, 2, 3, 4, 5, 6], np.zeros(6))
        assert (six.lower, six.upper, six.verdict) == (1, 6, "B better")

    def test_identical_differences_are_no_obstacle(self):
        found = am.compare_sign_flip(np.full(8, 0.3), np.full(8, 0.1))
        assert found.p_value == 2 / 256
        assert (found.lower, found.upper) == pytest.approx((0.2, 0.2))
        same = am.compare_sign_flip(np.ones(8), np.ones(8))
        assert (same.p_value, same.lower, same.upper, same.verdict) == (1, 0, 0, "undecided")
        assert same.undefined["effect"] == "no two runs differ"

    def test_the_share_of_wins(self):
        found = am.compare_sign_flip([1, 1, 1, 0, 2], [0, 0, 0, 1, 2])
        interval = binomtest(3, 4).proportion_ci(0.95)
        assert found.effect == 0.75
        assert (found.effect_lower, found.effect_upper) == pytest.approx(tuple(interval))
        higher = am.compare_sign_flip([1, 1, 1, 0, 2], [0, 0, 0, 1, 2], better="higher")
        assert higher.effect == 0.25

    def test_ties_by_rounding_are_ties(self):
        found = am.compare_sign_flip([0.1 + 0.2, 1e6], [0.3, 1e6 + 1])
        assert found.effect == 0
        assert am.compare_sign_flip([1e6 + 0.3, 1e6], [1e6, 1e6 + 0.3]).p_value == 1

    def test_a_limit_that_is_zero_but_for_rounding_is_zero(self):
        # The sixth smallest of 255 means is 0.1 + 0.2 - 0.3.
        d = np.array([7, 2, 2, 1, 4, -3, 5, 3]) / 10
        found = am.compare_sign_flip(d, np.zeros(8))
        assert (found.lower, found.verdict) == (0, "undecided")
        assert found.p_value > 0.05

    def test_many_runs(self, rng):
        a, b = rng.normal(size=(2, 5000))
        start = time.process_time()
        found = am.compare_sign_flip(a + 0.2, b, rng=rng)
        assert time.process_time() - start < 10
        assert found.verdict == "B better"


class TestHolm:
    @settings(max_examples=10, deadline=None)  # the peer collects garbage in each call
    @given(st.lists(st.floats(0, 1), min_size=1, max_size=12))
    def test_agrees_with_statsmodels(self, p):
        assert am.holm(p) == pytest.approx(multipletests(p, method="holm")[1], abs=1e-12)

    def test_ties_and_the_limit(self):
        assert am.holm([0.5, 0.5, 0.5]).tolist() == [1, 1, 1]
        assert am.holm([0.01, 0.01]).tolist() == [0.02, 0.02]
        assert am.holm([0.2]).tolist() == [0.2]

    def test_keeps_the_error_rate_of_the_family(self, rng):
        p = rng.random((4000, 6))
        wrong = np.mean([(am.holm(row) <= 0.05).any() for row in p])
        assert falls_short(1 - wrong, 0.95, 4000) < 3.9
        assert np.mean((p <= 0.05).any(1)) > 0.25


class TestPower:
    @pytest.mark.parametrize("size", [0.0, 0.1, 0.8, 2.0])
    @pytest.mark.parametrize("n", [2, 8, 50])
    def test_agrees_with_statsmodels(self, size, n):
        expected = TTestPower().power(size, n, 0.1)
        if not np.isnan(expected):
            assert comparison.power(3 * size, 3, n, 0.9) == pytest.approx(expected, abs=1e-9)
            assert comparison.power(-size, 1, n, 0.9) == pytest.approx(expected, abs=1e-9)

    def test_by_simulation(self, rng):
        d = rng.normal(0.5, 1, size=(4000, 12))
        t = d.mean(1) / (d.std(1, ddof=1) / np.sqrt(12))
        noticed = (abs(t) > 2.2009852).mean()
        p = comparison.power(0.5, 1, 12)
        assert abs(noticed - p) < 4 * np.sqrt(p * (1 - p) / 4000)

    @pytest.mark.parametrize("confidence", [0.5, 0.95, 0.999])
    def test_grows_to_one_without_a_hole(self, confidence):
        for n in (3, 8, 300, 1001):
            p = comparison.power(np.linspace(0, 40, 2001) / np.sqrt(n), 1, n, confidence)
            assert (np.diff(p) > -1e-9).all()
            assert p[0] == pytest.approx(1 - confidence)
            assert p[-1] <= 1
        assert p[-1] == 1

    @pytest.mark.parametrize("size", [0.01, 0.3, 1.0, 5.0, 100.0])
    def test_runs_needed_is_the_smallest(self, size):
        n = comparison.runs_needed(-2 * size, 2, 0.8)
        assert comparison.power(size, 1, n) >= 0.8
        assert n == 2 or comparison.power(size, 1, n - 1) < 0.8

    def test_two_functions_of_one_name(self):
        assert am.runs_needed is am.consistency.runs_needed
        assert am.comparison.runs_needed is comparison.runs_needed
        assert "power" not in am.__all__


class TestAggregate:
    @settings(max_examples=150)
    @given(st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=40))
    def test_agrees_with_numpy_and_scipy(self, values):
        found = am.aggregate(values, percentiles=(0, 5, 50, 90, 100))
        assert found.mean == pytest.approx(np.mean(values), abs=1e-9)
        assert found.median == pytest.approx(np.median(values), abs=1e-9)
        assert found.interquartile_mean == pytest.approx(trim_mean(values, 0.25), abs=1e-9)
        for q, x in found.percentiles.items():
            assert x == pytest.approx(np.percentile(values, q), abs=1e-9)
        assert (found.n, found.failed, found.failures) == (len(values), 0, "none failed")

    def test_failed_runs_under_each_rule(self):
        values = [NAN, 4, 1, 2, 3, NAN, 5, 6]
        worst = am.aggregate(values, failures="worst", unit="m")
        assert (worst.mean, worst.median, worst.failure_value) == (33 / 8, 4.5, 6)
        stated = am.aggregate(values, failures="worst", worst=30)
        assert stated.mean == 81 / 8
        separate = am.aggregate(values, failures="separate")
        assert (separate.mean, separate.median, separate.n_used) == (3.5, 3.5, 6)
        censored = am.aggregate(values, failures="censored", percentiles=(50, 75, 80))
        assert (censored.median, censored.interquartile_mean) == (4.5, 4.5)
        assert np.isnan(censored.mean)
        assert np.isnan(censored.percentiles[80.0])
        assert np.isnan(censored.percentiles[75.0])
        assert censored.undefined["mean"] == "mean would need the values of failed runs"
        for found in (worst, stated, separate, censored):
            assert (found.n, found.failed, found.failure_share) == (8, 2, 0.25)
            interval = binomtest(2, 8).proportion_ci(0.95)
            assert (found.failure_lower, found.failure_upper) == pytest.approx(tuple(interval))
            assert f"2 of 8 runs failed (share 0.25 [0.0319, 0.651], rule {found.failures}" in repr(
                found
            )

    def test_a_percentile_at_a_finite_value_is_known(self):
        found = am.aggregate([1, 2, 3, 4, NAN], failures="censored", percentiles=(75, 76))
        assert found.percentiles[75.0] == 4
        assert np.isnan(found.percentiles[76.0])
        assert found.undefined["P76"] == "P76 would need the values of failed runs"

    def test_where_higher_is_better_failed_runs_are_low(self):
        found = am.aggregate([NAN, 1, 2, 3], failures="censored", better="higher")
        assert found.median == 1.5
        assert am.aggregate([NAN, 1, 2], failures="worst", better="higher").failure_value == 1

    def test_scenarios(self):
        values = [1, 2, 3, NAN, 5, 6]
        found = am.aggregate(values, list("abbaab"), failures="worst", worst=9)
        assert list(found.scenarios) == ["a", "b"]
        assert found.scenarios["a"]["mean"] == 5
        assert found.scenarios["b"]["failed"] == 0
        assert found.scenarios["b"]["failure_share"] == 0
        assert found.notes == ()
        assert "2 scenarios" in repr(found)
        uneven = am.aggregate(values, list("abbbab"), failures="separate")
        assert uneven.notes == ("scenarios have 2 to 4 runs: those with more weigh more",)
        json.dumps(uneven.as_dict())

    def test_the_worst_value_is_that_of_all_scenarios(self):
        found = am.aggregate([1, NAN, 7, 8], list("aabb"), failures="worst")
        assert found.scenarios["a"]["mean"] == 4.5

    @pytest.mark.parametrize("n", [6, 20, 41])
    def test_intervals_cover(self, rng, n):
        runs, medians, shares = 1500, 0, 0
        for x in rng.exponential(size=(runs, n)):
            values = np.where(x > 1.2, NAN, x)
            found = am.aggregate(values, failures="censored")
            high = np.inf if np.isnan(found.median_upper) else found.median_upper
            medians += found.median_lower <= np.log(2) <= high or np.isnan(found.median_lower)
            shares += found.failure_lower <= np.exp(-1.2) <= found.failure_upper
        assert falls_short(medians / runs, 0.95, runs) < 3.9
        assert falls_short(shares / runs, 0.95, runs) < 3.9

    def test_six_runs_give_the_median_an_interval(self):
        six = am.aggregate([5, 1, 2, 6, 3, 4])
        assert (six.median_lower, six.median_upper) == (1, 6)
        five = am.aggregate([1, 2, 3, 4, 5])
        assert np.isnan(five.median_lower)
        assert "an interval of the median needs at least 6 runs" in repr(five)

    def test_percentiles_close_to_a_value_are_interpolated(self):
        assert am.aggregate([0, 100], percentiles=(1,)).percentiles[1.0] == 1

    def test_one_run_and_none_that_finished(self):
        assert am.aggregate([3.0]).median == 3
        nothing = am.aggregate([NAN, NAN], failures="separate")
        assert (nothing.n_used, nothing.failure_share) == (0, 1)
        assert np.isnan([nothing.mean, nothing.median, nothing.percentiles[5.0]]).all()
        assert nothing.undefined["mean"] == "every run failed"

    def test_takes_results(self, rng):
        X = rng.normal(size=(20, 2))
        runs = [am.ate(X, X + 0.1 * rng.normal(size=X.shape)) for _ in range(4)]
        found = am.aggregate(runs)
        assert found.unit == "m"
        assert "<th>interquartile_mean</th>" in found._repr_html_()


class _Odd:
    unit = "deg"

    def __float__(self):
        return 1.0


class _Meter(_Odd):
    unit = "m"


REFUSED = {
    "lengths": (lambda: am.compare_paired([1, 2], [1]), "a has 2 runs and b has 1"),
    "one run": (lambda: am.compare_paired([1], [2]), "a single run, which shows no spread"),
    "empty": (lambda: am.compare_paired([], []), r"a has shape \(0,\)"),
    "a table": (lambda: am.compare_paired([[1, 2]], [[1, 2]]), r"a has shape \(1, 2\)"),
    "text": (lambda: am.compare_paired("ab", "cd"), "a must be an array of real numbers"),
    "infinite": (lambda: am.compare_paired([1, np.inf], [1, 2]), r"a\[1\] is inf; write a run"),
    "b failed": (lambda: am.compare_paired([1, 2], [NAN, 2]), r"b\[0\] is nan, a run that failed"),
    "rule": (lambda: am.compare_paired([1, 2], [1, 2], failures="drop"), "failures is 'drop'"),
    "worst alone": (lambda: am.compare_paired([1, 2], [1, 3], worst=3), "nothing would use it"),
    "worst too good": (
        lambda: am.compare_paired([1, NAN], [1, 3], failures="worst", worst=2),
        "worst is 2, but a run that did not fail has 3",
    ),
    "all failed": (
        lambda: am.compare_paired([NAN, NAN], [NAN, NAN], failures="worst"),
        "state one by worst=",
    ),
    "better": (lambda: am.compare_paired([1, 2], [1, 3], better="less"), "better is 'less'"),
    "units": (lambda: am.compare_paired([_Odd(), _Meter()], [1, 2]), "of the units deg, m"),
    "units of both": (lambda: am.compare_paired([_Odd()] * 2, [_Meter()] * 2), "units deg, m"),
    "unit said": (lambda: am.compare_paired([_Odd()] * 2, [1, 2], unit="m"), "units deg, m"),
    "confidence": (lambda: am.compare_paired([1, 2], [1, 3], 95), "confidence is 95"),
    "method": (lambda: am.compare_bootstrap([1, 2], [1, 3], method="bca"), "method is 'bca'"),
    "seed": (lambda: am.compare_bootstrap([1, 2], [1, 3], rng=4), "rng is 4; expected a numpy"),
    "seed of flips": (lambda: am.compare_sign_flip([1, 2], [1, 3], rng=4), "rng is 4"),
    "resamples": (lambda: am.compare_bootstrap([1, 2], [1, 3], resamples=9), "resamples is 9"),
    "flips": (lambda: am.compare_sign_flip([1, 2], [1, 3], flips=99), "flips is 99"),
    "statistic": (lambda: am.compare_bootstrap([1, 2], [1, 3], statistic="mean"), "numpy.median"),
    "two numbers": (
        lambda: am.compare_bootstrap([1, 2], [1, 3], statistic=np.sort),
        "expected one finite number",
    ),
    "no p-value": (lambda: am.holm([]), r"p_values has shape \(0,\)"),
    "nan p-value": (lambda: am.holm([0.1, NAN]), r"p_values\[1\] is nan"),
    "p-value": (lambda: am.holm([0.1, 1.1]), r"p_values\[1\] is 1.1"),
    "std": (lambda: comparison.power(1, 0, 5), "std is 0"),
    "power n": (lambda: comparison.power(1, 1, 1), "n is 1"),
    "half n": (lambda: comparison.power(1, 1, 2.5), "n is 2.5"),
    "no difference": (lambda: comparison.runs_needed(0, 1), "difference is 0"),
    "hopeless": (lambda: comparison.runs_needed(1, 1, power=0.05), "power is 0.05"),
    "needed std": (lambda: comparison.runs_needed(1, -1), "std is -1; expected > 0"),
    "no values": (lambda: am.aggregate([]), r"values has shape \(0,\)"),
    "nan value": (lambda: am.aggregate([1, NAN]), r"values\[1\] is nan, a run that failed"),
    "labels": (lambda: am.aggregate([1, 2], ["a"]), "expected one label per run"),
    "percentiles": (lambda: am.aggregate([1, 2], percentiles=[101]), "percentages from 0 to 100"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()


def test_inputs_are_not_changed():
    a, b = TestFailures.A.copy(), TestFailures.B.copy()
    for rule in _runs.RULES:
        am.compare_sign_flip(a, b, failures=rule)
        am.aggregate(a, failures=rule)
    assert np.array_equal(a, TestFailures.A, equal_nan=True)
    assert np.array_equal(b, TestFailures.B, equal_nan=True)
