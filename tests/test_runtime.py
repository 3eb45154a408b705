"""Percentiles keep what their intervals promise; lost runs count; logs are read as they are."""

import builtins
import json
import sys
import time
import types
import warnings
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import trapezoid
from scipy.signal import lfilter
from scipy.stats import CensoredData, binom, binomtest, ecdf, expon, hypergeom, norm, quantile_test
from statsmodels.duration.survfunc import SurvfuncRight
from statsmodels.stats.proportion import proportion_confint

import amrmetrics as am
from amrmetrics import _intervals, resources

PERCENTS = (5, 50, 95, 99)


def short(rate, promised, runs):
    """Say by how many standard errors a measured coverage falls short of a promise."""
    return (promised - rate) / np.sqrt(promised * (1 - promised) / runs)


class TestFramesNeeded:
    def test_the_known_numbers(self):
        assert am.frames_needed(99) == 299
        assert am.frames_needed(95) == 59
        assert am.frames_needed(50) == 6
        assert am.frames_needed(99.9) == 2995
        assert am.frames_needed(99, confidence=0.99) == 459
        assert am.frames_needed(1) == 299

    @given(st.floats(1, 99.99), st.floats(0.01, 0.9999))
    def test_is_the_least_number_that_encloses(self, percent, confidence):
        n, q = am.frames_needed(percent, confidence), percent / 100
        assert 1 - q**n - (1 - q) ** n >= confidence
        assert n == 1 or 1 - q ** (n - 1) - (1 - q) ** (n - 1) < confidence

    def test_an_equality_is_enough(self):
        # Five values enclose the median with probability 1 - 2/32.
        assert am.frames_needed(50, confidence=0.9375) == 5


class TestRanks:
    @settings(max_examples=300)
    @given(st.integers(1, 700), st.sampled_from([0.01, 0.3, 0.5, 0.75, 0.95, 0.99]))
    def test_the_coverage_is_the_binomial_one(self, n, q):
        low, high = _intervals.quantile_ranks(n, q, 0.95)
        enough = n >= _intervals.smallest_sample(q, 0.95)
        assert (low is not None and high is not None) == enough
        below = binom.cdf(low - 1, n, q) if low else 0.0
        above = binom.sf(high - 1, n, q) if high else 0.0
        assert below + above <= 0.05 + 1e-12
        if enough:
            assert 1 <= low < high <= n
        if low and high and low > 1 and high < n:
            # Nothing is given away: the next values inside would miss too often.
            assert below <= 0.025 + 1e-12 < binom.cdf(low, n, q) + 1e-11
            assert above <= 0.025 + 1e-12 < binom.sf(high - 2, n, q) + 1e-11

    @pytest.mark.parametrize(("n", "q"), [(50, 0.5), (400, 0.99), (1000, 0.95), (77, 0.2)])
    def test_agree_with_scipy(self, rng, n, q):
        x = rng.gamma(4, 5, n)
        mine = am.percentile(x, 100 * q)
        interval = quantile_test(x, p=q).confidence_interval(0.95)
        assert (mine.lower, mine.upper) == (interval.low, interval.high)
        assert mine.value == pytest.approx(np.percentile(x, 100 * q), rel=1e-14)

    def test_the_largest_value_is_a_limit_as_soon_as_it_can_be(self):
        # One frame less: no upper limit, and the lower one may miss 5 times in 100, not 2.5.
        assert _intervals.quantile_ranks(298, 0.99, 0.95) == (292, None)
        low, high = _intervals.quantile_ranks(299, 0.99, 0.95)
        assert (low, high) == (289, 299)
        # What the upper side needs is taken from the lower one, not from the promise.
        assert 0.99**299 + binom.cdf(low - 1, 299, 0.99) <= 0.05

    def test_low_percentiles_are_the_mirror_of_high_ones(self):
        for n in (3, 58, 59, 120, 368):
            low, high = _intervals.quantile_ranks(n, 0.95, 0.9)
            mirrored = tuple(rank and n + 1 - rank for rank in (high, low))
            assert _intervals.quantile_ranks(n, 1 - 0.95, 0.9) == mirrored

    def test_dependent_values_spread_the_ranks(self):
        assert _intervals.spread_ranks((3, 8), 10, 10) == (3, 8)
        assert _intervals.spread_ranks((3, 8), 100, 10) == (21, 80)
        assert _intervals.spread_ranks((1, 10), 100, 10) == (1, 100)
        assert _intervals.spread_ranks((None, None), 100, 10) == (None, None)


class TestPercentile:
    @pytest.mark.parametrize("n", [59, 100, 299, 400])
    def test_encloses_the_truth_as_often_as_promised(self, rng, n):
        # Promised is at least 95 %. A false alarm per case is below one in 10 000.
        runs, hits = 1000, dict.fromkeys((50, 95, 99), 0)
        for x in rng.lognormal(size=(runs, n)):
            for q in hits:
                p = am.percentile(x, q)
                far = np.inf if np.isnan(p.upper) else p.upper
                hits[q] += p.lower <= np.exp(norm.ppf(q / 100)) <= far
        for q, hit in hits.items():
            assert short(hit / runs, 0.95, runs) < 3.8, q
            if n < am.frames_needed(q):
                assert np.isnan(p.upper) == (q == 99 or n < 59)

    @pytest.mark.parametrize("phi", [0.5, 0.9])
    def test_successive_values_of_a_slow_process(self, rng, phi):
        # With n_effective estimated, 95 % become 91 to 97; independent ones would be far below.
        runs, n = 300, 3000
        hits, naive = dict.fromkeys((50, 95), 0), 0
        for noise in rng.normal(size=(runs, n + 200)):
            x = lfilter([np.sqrt(1 - phi**2)], [1, -phi], noise)[200:]
            for q in hits:
                p = am.percentile(x, q)
                hits[q] += p.lower <= norm.ppf(q / 100) <= p.upper
            ranks = np.sort(x)[np.array(_intervals.quantile_ranks(n, 0.5, 0.95)) - 1]
            naive += ranks[0] <= 0 <= ranks[1]
        assert all(hit / runs > 0.90 for hit in hits.values()), hits
        assert naive / runs < 0.9

    def test_the_effective_number_is_that_of_the_theory(self, rng):
        # Signs of a process with correlations phi^k have correlations 2/pi arcsin(phi^k).
        phi, n = 0.8, 200_000
        x = lfilter([np.sqrt(1 - phi**2)], [1, -phi], rng.normal(size=n))
        rho = 2 / np.pi * np.arcsin(phi ** np.arange(1, 200))
        worth = am.percentile(x, 50).n_effective
        assert worth == pytest.approx(n / (1 + 2 * rho.sum()), rel=0.1)

    def test_independent_values_are_left_alone(self, rng):
        # Suspected is one in 740; 12 of 2000 would be one false alarm of the test in 10 000.
        suspected = dict.fromkeys(PERCENTS, 0)
        for x in rng.normal(size=(2000, 100)):
            for q in PERCENTS:
                above = x > np.percentile(x, q)
                suspected[q] += _intervals.effective_number(above) < 100
        assert max(suspected.values()) <= 11, suspected

    @pytest.mark.parametrize(("groups", "noticed"), [(17, True), (18, False)])
    def test_where_suspicion_begins(self, groups, noticed):
        # 50 of 100 stand in at most 17 groups with probability 0.0006, in at most 18 with 0.0024.
        sizes = np.diff(np.linspace(0, 50, groups + 1).astype(int))
        marks = np.concatenate([np.repeat([True, False], size) for size in sizes])
        assert (_intervals.effective_number(marks) < 100) == noticed
        assert hypergeom.cdf(17, 100, 51, 50) < _intervals.FALSE_ALARM
        assert hypergeom.cdf(18, 100, 51, 50) > _intervals.FALSE_ALARM

    def test_dips_in_a_row_are_noticed_at_low_percentiles(self, rng):
        x = rng.gamma(50, 0.0004, 6000)
        for k in rng.choice(5990, 60, replace=False):
            x[k : k + 5] -= 0.02
        assert am.percentile(x, 5).n_effective < 6000 / 2
        assert am.percentile(x, 95).n_effective > 5000

    def test_pauses_in_a_row_are_noticed_in_the_tail_only(self, rng):
        x = rng.gamma(50, 0.0004, 6000)
        for k in rng.choice(5990, 30, replace=False):
            x[k : k + 5] += 0.1
        assert am.percentile(x, 50).n_effective > 4500
        tail = am.percentile(x, 99)
        assert 6000 / 8 < tail.n_effective < 6000 / 2
        assert "correlated: worth" in repr(tail)
        assert "correlated" in repr(am.latency(x))
        assert am.latency(x).n_effective <= tail.n_effective

    def test_too_few_independent_values(self, rng):
        x = np.repeat(rng.gamma(4, 5, 60), 10)
        p = am.percentile(x, 99)
        assert np.isnan(p.upper)
        assert "needs at least 299 values; these 600 are correlated and worth" in repr(p)

    def test_a_percentile_lies_between_its_limits_in_tiny_samples(self):
        p = am.percentile([1, 2, 3], 99)
        assert (p.lower, p.value) == (2, pytest.approx(2.98))
        assert np.isnan(p.upper)
        low = am.percentile([1, 2, 3], 1)
        assert (low.upper, low.value) == (2, pytest.approx(1.02))
        assert np.isnan(low.lower)

    def test_one_value(self):
        p = am.percentile([4.0], 50)
        assert float(p) == 4
        assert set(p.undefined) == {"lower", "upper"}
        assert p.undefined["upper"] == "P50 needs at least 6 values"

    def test_all_equal(self):
        p = am.percentile(np.full(400, 0.25), 99)
        assert (p.lower, p.value, p.upper, p.n_effective) == (0.25, 0.25, 0.25, 400)

    def test_says_what_it_depends_on(self):
        p = am.percentile(np.arange(8.0)[[3, 1, 6, 0, 7, 2, 5, 4]], 50, 0.9, unit="ms")
        assert repr(p) == "P50 3.5 ms [1, 6], confidence 0.9, n 8"
        assert p.as_dict()["n_needed"] == 5


class TestLatency:
    def test_agrees_with_numpy(self, rng):
        x = rng.lognormal(-4, 0.5, 1234)
        found = am.latency(x)
        for q, name in ((50, "median"), (95, "p95"), (99, "p99")):
            assert getattr(found, name) == pytest.approx(np.percentile(x, q), rel=1e-14)
            p = am.percentile(x, q)
            assert getattr(found, f"{name}_lower") == p.lower
            assert getattr(found, f"{name}_upper") == p.upper
        assert found.mean == pytest.approx(x.mean(), rel=1e-14)
        assert found.max == x.max()
        assert found.throughput == pytest.approx(1234 / x.sum(), rel=1e-14)
        assert found.n == 1234
        assert found.unit == "s"

    def test_fifty_frames_have_no_p99(self, rng):
        found = am.latency(rng.gamma(4, 0.005, 50))
        assert np.isnan(found.p99_upper)
        assert np.isnan(found.p95_upper)
        assert found.median_lower < found.median < found.median_upper
        assert found.undefined["p99_upper"] == "P99 needs at least 299 frames"
        assert "P99 needs at least 299 frames" in repr(found)
        assert "none]" in repr(found)
        enough = am.latency(rng.gamma(4, 0.005, 299))
        assert enough.p99_upper == enough.max

    def test_a_frame_of_exactly_the_deadline_meets_it(self):
        found = am.latency([0.1, 0.1, 0.2, 0.05], deadline=0.1)
        assert (found.misses, found.miss_share, found.deadline) == (1, 0.25, 0.1)

    @pytest.mark.parametrize(("misses", "n"), [(0, 20), (3, 50), (50, 50), (1, 1)])
    def test_misses_agree_with_scipy_and_statsmodels(self, misses, n):
        x = np.r_[np.full(n - misses, 1.0), np.full(misses, 2.0)]
        found = am.latency(x[np.random.default_rng(3).permutation(n)], deadline=1.5)
        interval = binomtest(misses, n).proportion_ci(0.95)
        assert (found.miss_lower, found.miss_upper) == pytest.approx(interval, abs=1e-12)
        peer = proportion_confint(misses, n, method="beta")
        assert (found.miss_lower, found.miss_upper) == pytest.approx(peer, abs=1e-12)

    @pytest.mark.parametrize("share", [0.01, 0.2])
    def test_the_interval_of_misses_covers(self, rng, share):
        runs, n = 4000, 100
        hits = 0
        for k in rng.binomial(n, share, runs):
            lower, upper = _intervals.share_interval(int(k), n, 0.95)
            hits += lower <= share <= upper
        assert short(hits / runs, 0.95, runs) < 3.8

    def test_misses_in_a_row_widen_their_interval(self):
        late = np.zeros(1000)
        late[100:120] = late[500:520] = 1
        spread = np.zeros(1000)
        spread[::25] = 1
        row, alone = (am.latency(0.01 + x, deadline=0.5) for x in (late, spread))
        assert row.misses == alone.misses == 40
        assert row.miss_upper > 1.5 * alone.miss_upper

    def test_without_a_deadline(self):
        found = am.latency([0.1, 0.2])
        assert found.misses == 0
        assert np.isnan([found.deadline, found.miss_share, found.miss_lower]).all()
        assert found.undefined["miss_share"] == "no deadline was given"
        assert "deadline" not in repr(found)

    def test_warm_up_is_left_out_and_said(self):
        found = am.latency([9.0, 0.1, 0.1], warm_up=1)
        assert (found.n, found.warm_up, found.max) == (2, 1, 0.1)
        assert "n 2 after 1 of warm-up" in repr(found)

    def test_one_frame_and_equal_frames(self):
        assert am.latency([0.5]).max == 0.5
        assert am.latency([0.0, 0.5]).throughput == 4
        equal = am.latency(np.full(300, 0.02))
        assert equal.p99_lower == equal.p99_upper == 0.02

    def test_results_are_plain_numbers(self, rng):
        found = am.latency(rng.gamma(4, 0.005, 400), deadline=0.03)
        assert json.loads(json.dumps(found.as_dict()))["p99"] == found.p99
        assert "<th>p99_upper</th>" in found._repr_html_()

    def test_a_million_frames_take_seconds(self, rng):
        x = rng.gamma(4, 0.005, 1_000_000)
        slow = np.convolve(x, np.ones(200) / 200, "same")
        start = time.process_time()
        am.latency(x, deadline=0.05)
        am.latency(slow, deadline=0.021)
        assert time.process_time() - start < 10


def by_hand(times, back):
    """Return the product of conditional survival at each time, and Greenwood's sum."""
    at = np.unique(times)
    S, curve, total, sums = 1.0, [], 0.0, []
    for t in at:
        risk = sum(times >= t)
        events = sum((times == t) & back)
        S *= 1 - events / risk
        if events < risk:
            total += events / risk / (risk - events)
        curve.append(S)
        sums.append(total)
    return at, np.array(curve), np.array(sums)


# Computed once with lifelines 0.30.3 (median_survival_times of the confidence interval), which
# needs an older pandas than the other tests: times, recovered, median, lower, upper.
LIFELINES = (
    ([121, 121, 121, 5, 16, 93, 121, 1, 77], [0, 0, 0, 1, 1, 1, 0, 1, 1], 93, 1, None),
    (
        [91, 54, 91, 6, 82, 26, 64, 91, 21, 91, 42, 49, 91, 40, 91, 91, 28, 91, 22, 20, 10],
        [0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 1, 0, 1, 0, 1, 1, 1],
        54,
        26,
        None,
    ),
    (
        [79, 94, 75, 9, 157, 58, 15, 32, 231, 11, 74, 4, 85, 45, 103, 41, 141, 172, 217, 59, 32],
        [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1],
        74,
        32,
        94,
    ),
    (
        [
            81,
            69,
            27,
            81,
            81,
            2,
            20,
            26,
            35,
            81,
            29,
            31,
            26,
            81,
            42,
            34,
            56,
            81,
            81,
            40,
            3,
            81,
            65,
            81,
            21,
            37,
            81,
            81,
            81,
            30,
            81,
        ],
        [
            0,
            1,
            1,
            0,
            0,
            1,
            1,
            1,
            1,
            0,
            1,
            1,
            1,
            0,
            1,
            1,
            1,
            0,
            0,
            1,
            1,
            0,
            1,
            0,
            1,
            1,
            0,
            0,
            0,
            1,
            0,
        ],
        56,
        31,
        None,
    ),
    ([101, 489, 156, 35, 430, 62, 88], [1, 1, 1, 1, 1, 1, 1], 101, 35, 430),
    (
        [31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31],
        [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        None,
        None,
        None,
    ),
)

SURVIVAL = st.lists(st.tuples(st.integers(1, 9), st.booleans()), min_size=1, max_size=30)


class TestRelocalization:
    @settings(max_examples=200)
    @given(SURVIVAL)
    def test_is_the_product_of_conditional_survival(self, runs):
        times, back = (np.array(column) for column in zip(*runs, strict=True))
        found = am.relocalization_time(times, back)
        at, curve, _ = by_hand(times, back)
        assert np.array_equal(found.times, at)
        assert np.allclose(found.still_lost, curve, atol=1e-12)
        below = at[curve <= 0.5 + 1e-12]
        assert found.median == below[0] if len(below) else np.isnan(found.median)
        assert (found.n, found.recovered, found.censored) == (len(runs), back.sum(), (~back).sum())
        assert ("median" in found.undefined) == (len(below) == 0)

    @settings(max_examples=100)
    @given(SURVIVAL, st.sampled_from([0.8, 0.95]))
    def test_the_band_is_scipys(self, runs, confidence):
        times, back = (np.array(column) for column in zip(*runs, strict=True))
        found = am.relocalization_time(times, back, confidence)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            curve = ecdf(CensoredData.right_censored(times.astype(float), ~back)).sf
            band = curve.confidence_interval(confidence, method="log-log")
        for mine, theirs in (
            (found.still_lost_lower, band.low),
            (found.still_lost_upper, band.high),
        ):
            assert np.allclose(mine, theirs.probabilities, equal_nan=True, atol=1e-12)

    def test_agrees_with_statsmodels(self, rng):
        for horizon in (0.9, 2.0, 9.0):
            x = rng.exponential(size=41)
            times, back = np.minimum(x, horizon), x <= horizon
            found, peer = am.relocalization_time(times, back), SurvfuncRight(times, back)
            events = np.isin(found.times, peer.surv_times)
            assert np.allclose(found.still_lost[events], peer.surv_prob, atol=1e-12)
            _, _, greenwood = by_hand(times, back)
            error = found.still_lost * np.sqrt(greenwood)
            keep = found.still_lost[events] > 0
            assert np.allclose(error[events][keep], peer.surv_prob_se[keep], atol=1e-12)
            if not np.isnan(found.median):
                assert found.median == peer.quantile(0.5)

    @pytest.mark.parametrize("case", LIFELINES, ids=range(len(LIFELINES)))
    def test_agrees_with_lifelines(self, case):
        times, back, *expected = case
        found = am.relocalization_time(times, back)
        for name, value in zip(("median", "lower", "upper"), expected, strict=True):
            number = getattr(found, name)
            assert np.isnan(number) if value is None else number == value, name
            assert (name in found.undefined) == (value is None)

    def test_ties_recover_before_they_are_censored(self):
        found = am.relocalization_time([1, 1, 2, 2], [1, 0, 1, 0])
        assert found.still_lost.tolist() == [0.75, 0.375]

    def test_half_is_reached_in_spite_of_rounding(self):
        # 8/10 * 6/8 * 5/6 is a half; the product of doubles is larger by one in the last place.
        times, back = [4, 1, 7, 6, 5, 5, 1, 2, 2, 3], [1, 1, 1, 0, 1, 1, 1, 1, 1, 1]
        found = am.relocalization_time(times, back)
        assert found.still_lost[2] > 0.5
        assert found.median == 3

    def test_half_is_not_reached_before(self):
        # 51 of 101 are still lost after the 50th.
        assert am.relocalization_time(np.arange(1, 102), np.ones(101)).median == 51

    def test_dropping_lost_runs_would_flatter(self, rng):
        x = rng.exponential(10, 4000)
        times, back = np.minimum(x, 8), x <= 8
        found = am.relocalization_time(times, back, confidence=0.9999)
        assert found.lower <= expon(scale=10).median() <= found.upper
        assert np.median(times[back]) < 0.6 * expon(scale=10).median()

    @pytest.mark.parametrize("n", [6, 10, 15, 25, 60])
    def test_the_interval_of_the_median_covers(self, rng, n):
        # Greenwood's variance is an approximation: 95 % become 92 to 98, at every censoring.
        runs, hits = 800, 0
        for horizon in (0.9, 2.0):
            for x in rng.exponential(size=(runs // 2, n)):
                found = am.relocalization_time(np.minimum(x, horizon), x <= horizon)
                low = 0 if np.isnan(found.lower) else found.lower
                high = np.inf if np.isnan(found.upper) else found.upper
                hits += low <= np.log(2) <= high
        assert hits / runs > 0.92 - 3 * np.sqrt(0.05 * 0.95 / runs)

    def test_the_band_covers_at_a_time(self, rng):
        runs, hits = 800, 0
        for x in rng.exponential(size=(runs, 40)):
            found = am.relocalization_time(np.minimum(x, 1.5), x <= 1.5)
            k = np.searchsorted(found.times, 0.7, side="right") - 1
            hits += found.still_lost_lower[k] <= np.exp(-0.7) <= found.still_lost_upper[k]
        assert abs(hits / runs - 0.95) < 0.03

    def test_nobody_recovered(self):
        found = am.relocalization_time([30, 60], [0, 0])
        assert np.isnan(float(found))
        assert found.undefined["median"] == "no run recovered within its 30 to 60 s"
        assert np.isnan(found.still_lost_upper).all()
        assert "0 recovered, 2 censored" in repr(found)
        many = am.relocalization_time(np.full(9, 30.0), np.zeros(9))
        assert set(many.undefined) == {"median", "lower", "upper"}

    def test_fewer_than_six_runs_have_no_interval(self):
        five = am.relocalization_time([1, 2, 3, 4, 5], np.ones(5))
        assert five.median == 3
        assert np.isnan([five.lower, five.upper]).all()
        assert "needs at least 6 runs" in repr(five)
        six = am.relocalization_time([1, 2, 3, 4, 5, 6], np.ones(6))
        assert (six.lower, six.upper) == (1, 6)

    def test_more_than_half_stay_lost(self):
        found = am.relocalization_time([1, 2, 9, 9, 9], [1, 1, 0, 0, 0])
        assert "more than half are still lost when the runs end, at 9 s" in repr(found)

    def test_all_equal_and_a_single_run(self):
        assert am.relocalization_time([3.0] * 8, [True] * 8).median == 3
        assert am.relocalization_time([3.0], [1]).median == 3


class Clock:
    """A clock that a test moves."""

    def __init__(self):
        self.now = 100.0

    def __call__(self):
        return self.now


class TestMeasure:
    def test_wall_processor_and_starts(self):
        wall, cpu = Clock(), Clock()
        with am.measure(wall, cpu) as log:
            for k in range(3):
                wall.now += 1  # reading, between the frames
                with log.frame():
                    wall.now += k + 1
                    cpu.now += 0.5
        found = log.result
        assert found.durations.tolist() == [1, 2, 3]
        assert log.durations.tolist() == [1, 2, 3]
        assert found.processor_times.tolist() == [0.5, 0.5, 0.5]
        assert found.starts.tolist() == [1, 3, 6]
        assert (found.n, found.elapsed, found.cpu_share) == (3, 9, 0.25)
        assert am.latency(log.durations).max == 3

    def test_an_interrupted_frame_is_counted_and_not_timed(self):
        with pytest.raises(KeyError), am.measure() as log:
            with log.frame():
                pass
            with log.frame():
                raise KeyError
        assert (log.result.n, log.result.interrupted) == (1, 1)
        assert "1 interrupted" in repr(log.result)

    def test_real_time_and_share(self):
        with am.measure() as log:
            with log.frame():
                time.sleep(0.05)
            with log.frame():
                end = time.process_time() + 0.05
                while time.process_time() < end:
                    pass
        found = log.result
        assert (found.durations >= 0.049).all()
        assert found.processor_times[0] < 0.03
        assert found.processor_times[1] >= 0.05
        assert 0 < found.cpu_share < 1

    def test_costs_little(self):
        with am.measure() as log:
            for _ in range(20_000):
                with log.frame():
                    pass
        # A few microseconds; a hundred would be noticed in a frame of 1 ms.
        assert log.result.elapsed / 20_000 < 100e-6
        assert np.median(log.durations) < 20e-6

    def test_no_frame(self):
        with am.measure() as log:
            pass
        found = log.result
        assert found.n == 0
        assert np.isnan(found.cpu_share)
        assert found.undefined["cpu_share"] == "no frame"
        json.dumps(found.as_dict())

    def test_the_peak_is_noticed(self):
        with am.measure() as log, log.frame():
            block = np.ones(30_000_000)
            del block
        found = log.result
        if sys.platform != "emscripten":
            assert found.peak_memory >= found.peak_before > 1e6
            assert found.peak_memory > 240e6

    @pytest.mark.parametrize(("system", "factor"), [("darwin", 1), ("freebsd14", 1024)])
    def test_other_systems(self, monkeypatch, system, factor):
        usage = types.SimpleNamespace(ru_maxrss=7_000)
        fake = types.SimpleNamespace(RUSAGE_SELF=0, getrusage=lambda who: usage)
        monkeypatch.setitem(sys.modules, "resource", fake)
        monkeypatch.setattr(resources.sys, "platform", system)
        assert resources._peak_memory() == 7_000 * factor

    def test_windows(self, monkeypatch):
        import ctypes

        class Ask:
            def __call__(self, handle, counters, size):
                assert handle == 42
                counters._obj.peak = 12_345_678
                # 2 DWORD and 8 size_t: PROCESS_MEMORY_COUNTERS has 72 bytes on 64 bits.
                return size == 8 + 8 * ctypes.sizeof(ctypes.c_size_t)

        class Kernel:
            K32GetProcessMemoryInfo = Ask()

            class GetCurrentProcess:
                def __new__(cls):
                    return 42

        monkeypatch.setattr(ctypes, "WinDLL", lambda name, use_last_error: Kernel, raising=False)
        monkeypatch.setattr(resources.sys, "platform", "win32")
        assert resources._peak_memory() == 12_345_678

    def test_a_system_that_does_not_tell(self, monkeypatch):
        monkeypatch.setattr(resources.sys, "platform", "emscripten")
        monkeypatch.setitem(sys.modules, "resource", None)
        with am.measure() as log:
            pass
        assert np.isnan(log.result.peak_memory)
        assert "does not tell the peak memory" in repr(log.result)

    def test_a_sealed_proc(self, monkeypatch):
        def closed(*_):
            raise OSError

        monkeypatch.setattr(resources.sys, "platform", "linux")
        monkeypatch.setattr(builtins, "open", closed)
        assert np.isnan(resources._peak_memory())


class TestEnergy:
    def test_is_the_trapezoidal_rule(self, rng):
        t = np.cumsum(rng.uniform(0.1, 1, 200))
        p = rng.uniform(10, 60, 200)
        found = am.energy(t, p)
        assert float(found) == pytest.approx(trapezoid(p, t), rel=1e-12)
        assert found.watt_hours == pytest.approx(found.joules / 3600)
        assert found.mean_power == pytest.approx(found.joules / (t[-1] - t[0]))
        assert found.max_power == p.max()
        assert found.n == 200
        assert found.longest_gap == pytest.approx(np.diff(t).max())

    def test_parts_add_up(self, rng):
        t, p = np.arange(50.0), rng.uniform(10, 60, 50)
        cuts = [0, 3.25, 17, 30.5, 49]
        parts = [am.energy(t, p, start=a, end=b) for a, b in pairwise(cuts)]
        assert sum(map(float, parts)) == pytest.approx(float(am.energy(t, p)), rel=1e-12)
        assert [x.n for x in parts] == [4, 14, 14, 19]

    def test_limits_interpolate(self):
        found = am.energy([0, 2, 10], [0, 20, 20], start=1, end=1.5, frames=5)
        assert found.joules == pytest.approx(0.5 * 12.5)
        assert found.per_frame == pytest.approx(1.25)
        assert (found.n, found.longest_gap, found.max_power) == (0, 2, 15)
        assert "J per frame" in repr(found)

    def test_a_motor_that_brakes(self):
        assert am.energy([0, 1, 2], [30, -10, 30]).joules == 20


class TestResourceUse:
    LOG = {
        "time": [0.0, 1.0, 2.0, 6.0],
        "cpu_percent": [100.0, 300.0, 100.0, 100.0],
        "gpu_percent": [0.0, 50.0, 100.0, 0.0],
        "memory_MiB": [1.0, 2.0, 4.0, 4.0],
        "power_W": [-5.0, 5.0, 5.0, 5.0],
    }

    def test_columns_by_name(self):
        use = am.resource_use(self.LOG)
        assert use.mean["cpu_percent"] == pytest.approx((200 + 200 + 400) / 6)
        assert use.max["memory_MiB"] == 4 * 2**20
        assert use.unit == {
            "cpu_percent": "%",
            "gpu_percent": "%",
            "memory_MiB": "bytes",
            "power_W": "W",
        }
        assert use.p95["gpu_percent"] == pytest.approx(np.percentile([0, 50, 100, 0], 95))
        assert (use.n, use.duration) == (4, 6)
        assert "gpu_percent: mean" in repr(use)
        json.dumps(use.as_dict())

    def test_a_table_and_a_text_file(self, tmp_path):
        pandas = pytest.importorskip("pandas")
        expected = am.resource_use(self.LOG).mean
        table = pandas.DataFrame(self.LOG)
        assert am.resource_use(table).mean == pytest.approx(expected)
        table.to_csv(tmp_path / "log.csv", index=False)
        rows = np.genfromtxt(tmp_path / "log.csv", delimiter=",", names=True)
        assert am.resource_use(rows).mean == pytest.approx(expected)

    @pytest.mark.parametrize(
        ("name", "factor"),
        [("a_kB", 1e3), ("a_MB", 1e6), ("a_GB", 1e9), ("a_KiB", 1024), ("a_GiB", 2**30)]
        + [("a_bytes", 1), ("a_mW", 1e-3), ("a_celsius", 1)],
    )
    def test_units(self, name, factor):
        use = am.resource_use({"stamp": [0, 1], name: [2, 2]})
        assert use.mean[name] == pytest.approx(2 * factor)


NAN = float("nan")
REFUSED = {
    "no frames": (lambda: am.latency([]), r"durations has shape \(0,\)"),
    "two axes": (lambda: am.latency([[0.1]]), r"durations has shape \(1, 1\)"),
    "nan frame": (lambda: am.latency([0.1, NAN]), r"durations\[1\] is nan"),
    "negative": (lambda: am.latency([0.1, -0.1]), r"durations\[1\] is -0.1 s; no frame"),
    "text": (lambda: am.latency(["0.1"]), "durations must be an array of real numbers"),
    "coarse clock": (lambda: am.latency([0, 0]), "clock is too coarse"),
    "only warm-up": (lambda: am.latency([0.1], warm_up=1), "warm_up is 1, but there are only 1"),
    "half a frame": (lambda: am.latency([0.1], warm_up=0.5), "warm_up is 0.5"),
    "deadline": (lambda: am.latency([0.1], deadline=0), "deadline is 0; expected > 0"),
    "confidence": (lambda: am.latency([0.1], confidence=95), "confidence is 95"),
    "fraction": (lambda: am.frames_needed(0.99), r"percentile is 0.99; expected a percentage"),
    "hundred": (lambda: am.frames_needed(100), "percentile is 100"),
    "percentile": (lambda: am.percentile([1.0], "99"), "percentile must be an array of real"),
    "sure": (lambda: am.frames_needed(99, 1.0), "confidence is 1.0"),
    "lost for no time": (
        lambda: am.relocalization_time([1, 0], [1, 1]),
        r"durations\[1\] is 0 s; a lost robot",
    ),
    "label": (lambda: am.relocalization_time([1, 2], [1, 2]), r"recovered\[1\] is 2"),
    "labels": (lambda: am.relocalization_time([1, 2], [1]), r"recovered has shape \(1,\)"),
    "no run": (lambda: am.relocalization_time([], []), r"durations has shape \(0,\)"),
    "nan run": (lambda: am.relocalization_time([NAN], [0]), r"durations\[0\] is nan"),
    "clock": (lambda: am.measure(clock=3), "clock is 3; expected a function"),
    "processor": (lambda: am.measure(processor_clock=3), "processor_clock is 3"),
    "energy": (lambda: am.energy([0, 1], [1, 2, 3]), r"power has shape \(3,\)"),
    "one sample": (lambda: am.energy([0], [1]), "N >= 2"),
    "order": (lambda: am.energy([1, 0], [1, 2]), "stamps go back in time"),
    "before": (lambda: am.energy([0, 1], [1, 2], start=-1), "start is -1 s, outside the log"),
    "after": (lambda: am.energy([0, 1], [1, 2], end=2), "end is 2 s, outside the log"),
    "backwards": (lambda: am.energy([0, 3], [1, 2], start=2, end=1), "start must come first"),
    "sign": (lambda: am.energy([0, 1], [-9, -9]), "power is -9 W on average"),
    "frames": (lambda: am.energy([0, 1], [9, 9], frames=0), "frames is 0"),
    "no clock": (lambda: am.resource_use({"cpu_percent": [1, 2]}), "expected one called 'time'"),
    "only a clock": (lambda: am.resource_use({"time": [1, 2]}), r"log has the columns \['time'\]"),
    "no columns": (lambda: am.resource_use([1, 2]), r"log has the columns \[\]"),
    "no unit": (
        lambda: am.resource_use({"time": [0, 1], "cpu": [1, 2]}),
        "'cpu' does not say its unit; rename it .* cpu_percent",
    ),
    "unknown unit": (lambda: am.resource_use({"time": [0, 1], "cpu_load": [1, 2]}), "cpu_load"),
    "column length": (
        lambda: am.resource_use({"time": [0, 1], "cpu_percent": [1]}),
        r"cpu_percent has shape \(1,\)",
    ),
    "negative use": (
        lambda: am.resource_use({"time": [0, 1], "cpu_percent": [1, -1]}),
        r"cpu_percent\[1\] is -1",
    ),
    "nan use": (
        lambda: am.resource_use({"time": [0, 1], "gpu_percent": [1, NAN]}),
        r"gpu_percent\[1\] is nan",
    ),
    "single sample": (lambda: am.resource_use({"time": [0], "cpu_percent": [1]}), "single sample"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()


def test_frames_do_not_nest():
    with am.measure() as log, pytest.raises(am.AmrError, match="inside another"):  # noqa: SIM117
        with log.frame(), log.frame():
            pass


def test_no_result_before_the_end():
    with am.measure() as log, pytest.raises(am.AmrError, match="after the with block"):
        _ = log.result


def test_inputs_are_not_changed(rng):
    x = rng.gamma(4, 1, 40)
    kept, back = x.copy(), x < 4
    am.latency(x, deadline=3, warm_up=2)
    am.relocalization_time(x, back)
    am.energy(np.arange(40.0), x)
    assert np.array_equal(x, kept)
