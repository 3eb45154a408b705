"""Compare two systems without a formula for the law of their differences (lecture 09).

The bootstrap draws runs again; the sign-flip test turns the signs of the differences, which is
exact for few runs. `comparison` has the results' common fields and the t interval.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._arguments import as_count, as_generator, as_probability
from amrmetrics._intervals import quantile_ranks, share_interval, smallest_sample
from amrmetrics._runs import as_pairs, rounding
from amrmetrics.comparison import (
    Comparison,
    described,
    is_finite,
    moments,
    reasons_for_nan,
    why_no_spread,
)
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from collections.abc import Callable

    from amrmetrics._types import ArrayLike

# The sign-flip test goes through all 2^n flips up to this number of runs.
EXACT_UP_TO = 20

# A bootstrap is called too small when it misses so many times as often as it promises, which is
# known for normal differences.
TOO_OFTEN = 1.5

# Doubles that a block of random runs may hold.
BLOCK = 2**20


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class BootstrapInterval(Comparison):
    """A `Comparison` by drawing runs again.

    Attributes
    ----------
    resamples : int
        How many samples were drawn.
    coverage_if_normal : float
        How often a percentile bootstrap of so many runs encloses the mean of normal
        differences; compare it with `confidence`.
    enough : bool
        Whether the runs are enough: whether such an interval would miss at most 1.5 times as
        often as it promises.
    """

    resamples: int
    coverage_if_normal: float
    enough: bool


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class SignFlipTest(Comparison):
    """A `Comparison` by turning the signs of the differences.

    Attributes
    ----------
    p_value : float
        Share of the flips whose mean is at least as far from 0, on either side.
    exact : bool
        Whether all 2^n flips were tried; otherwise a random part of them.
    flips : int
        How many flips were tried, none at all included.
    """

    p_value: float
    exact: bool
    flips: int

    def _test(self):
        return f", p {self.p_value:.3g} from {self.flips} flips"


def compare_bootstrap(
    a: ArrayLike,
    b: ArrayLike,
    confidence: float = 0.95,
    statistic: Callable[..., Any] = np.mean,
    method: str = "BCa",
    rng: np.random.Generator | None = None,
    *,
    resamples: int = 9999,
    failures: str | None = None,
    worst: float | None = None,
    better: str = "lower",
    unit: str | None = None,
) -> BootstrapInterval:
    """Compare two systems by the bootstrap interval of the differences of their paired runs.

    Parameters
    ----------
    a, b : (N,) array
        One number per run, as in `compare_paired`.
    confidence : float
        Of the intervals, in (0, 1).
    statistic : callable
        Takes the differences, returns a number: numpy.mean, numpy.median or your own.
    method : {"BCa", "percentile"}
        Bias-corrected and accelerated, or plain percentiles of the resampled statistic.
    rng : numpy.random.Generator, optional
        Draws the runs. Without it, a generator with seed 0 is made, so that a call gives the
        same interval each time.
    resamples : int
        How many samples are drawn, >= 100.
    failures, worst, better, unit
        As in `compare_paired`.

    Returns
    -------
    BootstrapInterval
        The statistic of A - B with interval, and whether the runs are enough for it; no
        p-value. The share of runs that B wins has the limits of Clopper and Pearson.

    Raises
    ------
    AmrError
        As `compare_paired`, and if the statistic returns no finite number.

    References
    ----------
    Lecture 09. Efron, Better bootstrap confidence intervals, JASA 82 (1987), eq. (2.3).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> rng = np.random.default_rng(9)
    >>> a, b = rng.exponential(size=(2, 40))
    >>> result = am.compare_bootstrap(a + 1, b, unit="m", rng=rng)
    >>> result.verdict, result.enough
    ('B better', True)
    >>> am.compare_bootstrap(a[:8], b[:8], rng=rng).enough
    False
    """
    confidence = as_probability(confidence, "confidence")
    if method not in ("BCa", "percentile"):
        raise AmrError(f"method is {method!r}; expected 'BCa' or 'percentile'.")
    rng = np.random.default_rng(0) if rng is None else as_generator(rng)
    resamples = as_count(resamples, "resamples", least=100)
    pairs = as_pairs(a, b, failures, worst, better, unit)
    n, mean, std = moments(pairs)
    estimate = lower = upper = float("nan")
    why = why_no_spread(pairs, n, std)
    if n:
        estimate = _value_of(statistic, pairs.differences)
    if not why:
        lower, upper = _bootstrap(pairs.differences, statistic, confidence, method, resamples, rng)
        if lower != lower:
            why = (
                "BCa has no acceleration here: leaving out any one run does not change the "
                "statistic. Use method='percentile'"
            )
    covered = _coverage_if_normal(n, confidence) if n > 1 else 0.0
    enough = 1 - covered <= TOO_OFTEN * (1 - confidence)
    wins, no_wins = _wins(pairs, confidence)
    undefined = dict.fromkeys(("lower", "upper"), why) if why else {}
    return BootstrapInterval(
        **described(pairs, n, mean, std, lower, upper, confidence, better),
        statistic=getattr(statistic, "__name__", type(statistic).__name__),
        estimate=estimate,
        method=f"{method} bootstrap of {resamples} resamples",
        assumption="independent runs, enough of them to show the shape of the differences",
        **wins,
        resamples=resamples,
        coverage_if_normal=covered,
        enough=enough,
        undefined=reasons_for_nan(n, undefined | no_wins),
        notes=() if enough or n < 2 else (_too_few(n, covered, confidence),),
    )


def compare_sign_flip(
    a: ArrayLike,
    b: ArrayLike,
    confidence: float = 0.95,
    rng: np.random.Generator | None = None,
    *,
    flips: int = 10_000,
    failures: str | None = None,
    worst: float | None = None,
    better: str = "lower",
    unit: str | None = None,
) -> SignFlipTest:
    """Compare two systems by turning the signs of the differences of their paired runs.

    If neither is better, A - B is as likely as B - A in each run, so all 2^n choices of signs
    are equally likely. Up to 20 runs all of them are tried, beyond that a random part.

    Parameters
    ----------
    a, b : (N,) array
        One number per run, as in `compare_paired`.
    confidence : float
        Of the intervals, in (0, 1).
    rng : numpy.random.Generator, optional
        Draws the flips of more than 20 runs; without it, one with seed 0 is made.
    flips : int
        How many flips are tried beyond 20 runs, >= 100.
    failures : {None, "worst", "censored", "separate"}
        As in `compare_paired`. Under "censored" a run that one of them failed says only who is
        better, so that signs take the place of differences: the p-value is that of the sign
        test, the estimate the median.
    worst, better, unit
        As in `compare_paired`.

    Returns
    -------
    SignFlipTest
        Mean of A - B and the share of runs that B wins. The interval of the mean excludes 0
        exactly if the p-value is at most 1 - confidence. Under "censored" it is the interval
        of the median, which counts ties, while the sign test leaves them out.

    Raises
    ------
    AmrError
        As `compare_paired`.

    References
    ----------
    Lecture 09. Fisher, The Design of Experiments (1935), section 21; the interval: Hartigan,
    Using subsample values as typical values, JASA 64 (1969), theorem 1; sampled flips:
    Phipson and Smyth, Statistical Applications in Genetics and Molecular Biology 9 (2010).

    Examples
    --------
    >>> import amrmetrics as am
    >>> a = [0.52, 0.48, 0.50, 0.43, 0.49, 0.45, 0.47, 0.51]
    >>> result = am.compare_sign_flip(a, [0.40] * 8, unit="m")
    >>> result.p_value, result.verdict
    (0.0078125, 'B better')
    """
    confidence = as_probability(confidence, "confidence")
    rng = np.random.default_rng(0) if rng is None else as_generator(rng)
    flips = as_count(flips, "flips", least=100)
    pairs = as_pairs(a, b, failures, worst, better, unit, allowed=("worst", "censored", "separate"))
    n, mean, std = moments(pairs)
    censored = not np.isfinite(pairs.differences).all()
    d = np.sign(pairs.differences) if censored else pairs.differences
    exact = n <= EXACT_UP_TO
    sums, means = _all_subsets(d) if exact else _some_subsets(d, flips - 1, rng)
    near = n * rounding(1 if censored else pairs.scale)
    p_value = _flip_p_value(sums, near)
    wins, undefined = _wins(pairs, confidence)
    if censored:
        with np.errstate(invalid="ignore"):  # between a run that A failed and one that B failed
            estimate = float(np.median(pairs.differences))
        lower, upper, why = _median_limits(pairs.differences, confidence)
    else:
        estimate = mean
        lower, upper, why = _flip_limits(means, near / max(n, 1), confidence)
    if why and n:
        undefined |= {k: why for k, x in (("lower", lower), ("upper", upper)) if not is_finite(x)}
    if not is_finite(estimate) and n:
        undefined["estimate"] = "half of the runs or more are failed ones"
    return SignFlipTest(
        **described(pairs, n, mean, std, lower, upper, confidence, better),
        statistic="median" if censored else "mean",
        estimate=estimate if is_finite(estimate) else float("nan"),
        method=("exact" if exact else "sampled")
        + (" sign" if censored else " sign-flip")
        + " test",
        assumption="independent runs"
        + ("" if censored else " with differences that are symmetric about their mean"),
        **wins,
        p_value=p_value,
        exact=exact,
        flips=2**n if exact else flips,
        undefined=reasons_for_nan(n, undefined, censored),
        notes=(),
    )


def _value_of(statistic, d):
    if not callable(statistic):
        raise AmrError(f"statistic is {statistic!r}; expected a function such as numpy.median.")
    value = np.asarray(statistic(d))
    if value.shape != () or value.dtype.kind not in "fiu" or not np.isfinite(value):
        raise AmrError(f"statistic returned {value!r}; expected one finite number.")
    return float(value)


def _bootstrap(d, statistic, confidence, method, resamples, rng):
    import warnings

    from scipy.stats import DegenerateDataWarning, bootstrap

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DegenerateDataWarning)  # its nan gets a reason
        warnings.simplefilter("ignore", RuntimeWarning)
        interval = bootstrap(
            (d,),
            statistic,
            n_resamples=resamples,
            batch=max(1, BLOCK // len(d)),
            confidence_level=confidence,
            method=method,
            rng=rng,
        ).confidence_interval
    return float(interval.low), float(interval.high)


def _coverage_if_normal(n, confidence):
    """Return how often a percentile bootstrap encloses the mean of n normal differences.

    It is an interval of z standard errors in which the spread has divisor n, not n - 1.
    """
    from scipy.special import ndtri, stdtr

    z = ndtri((1 + confidence) / 2) * np.sqrt((n - 1) / n)
    return float(2 * stdtr(n - 1, z) - 1)


def _too_few(n, covered, confidence):
    wanted = max(n, 2)
    while 1 - _coverage_if_normal(wanted, confidence) > TOO_OFTEN * (1 - confidence):
        wanted += 1
    return (
        f"{n} runs are too few for a bootstrap: of normal differences its interval would cover "
        f"{100 * covered:.1f} %, not {100 * confidence:g} %; take {wanted} runs, or compare_paired "
        "or compare_sign_flip"
    )


def _wins(pairs, confidence):
    """Return the share of runs that B wins among those that differ, and reasons for nan."""
    won = int((pairs.sign * pairs.differences > 0).sum())
    total = int((pairs.differences != 0).sum())
    names = ("effect", "effect_lower", "effect_upper")
    numbers, undefined = (float("nan"),) * 3, dict.fromkeys(names, "no two runs differ")
    if total:
        numbers, undefined = (won / total, *share_interval(won, total, confidence)), {}
    fields = {"effect_name": "share of runs that B wins"}
    return fields | dict(zip(names, numbers, strict=True)), undefined


def _all_subsets(d):
    """Return sums and means of all subsets of the differences, the empty one first."""
    sums, sizes = np.zeros(1), np.zeros(1)
    for x in d:
        sums, sizes = np.r_[sums, sums + x], np.r_[sizes, sizes + 1]
    return sums, sums[1:] / sizes[1:]


def _some_subsets(d, count, rng):
    """Return sums and means of random subsets, after the sum of the empty one."""
    n = len(d)
    sums, sizes = np.zeros(count + 1), np.zeros(count + 1)
    step = max(1, BLOCK // n)
    for k in range(1, count + 1, step):
        rows = sums[k : k + step]
        flipped = rng.integers(0, 2, size=(len(rows), n), dtype=np.int8)
        rows[:] = flipped @ d
        sizes[k : k + step] = flipped.sum(1)
    return sums, sums[1:] / np.maximum(sizes[1:], 1)


def _flip_p_value(sums, near):
    """Return the two-sided p-value: flipping a subset lowers the sum if its sum is positive."""
    tail = min(int((sums <= near).sum()), int((sums >= -near).sum()))
    return min(1.0, 2 * tail / len(sums))


def _flip_limits(means, near, confidence):
    """Return the limits between which no flip is unlikely, and why there are none."""
    # The product is rounded: 0.05 / 2 * 2**n may be a whole number that is just missed.
    k = int((1 - confidence) / 2 * (len(means) + 1) * (1 + 1e-12))
    if k < 1:
        why = f"an interval needs at least {smallest_sample(0.5, confidence)} runs"
        return float("nan"), float("nan"), why
    ranked = np.sort(means)
    lower, upper = (0.0 if abs(x) <= near else float(x) for x in (ranked[k - 1], ranked[-k]))
    return lower, upper, None


def _median_limits(d, confidence):
    """Return the limits of the median of the differences, of which some are infinite."""
    low, high = quantile_ranks(len(d), 0.5, confidence)
    if low is None:
        why = f"an interval needs at least {smallest_sample(0.5, confidence)} runs"
        return float("nan"), float("nan"), why
    ranked = np.sort(d)
    return float(ranked[low - 1]), float(ranked[high - 1]), "a limit is a run that failed"
