"""How long frames take and how long a lost robot stays lost, with intervals (lecture 08).

No distribution is assumed: the limits of a percentile are two of the measured times, and a
sample that is too small for a limit gets a number of frames instead.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_array, as_count, as_numbers, as_probability, as_size
from amrmetrics._intervals import (
    effective_number,
    quantile_ranks,
    share_interval,
    smallest_sample,
    spread_ranks,
)
from amrmetrics._results import Number, Result
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike

# Products of survival shares are rounded: 3/4 * 2/3 is half.
ROUNDING = 1e-12

NOT_ASKED = "no deadline was given"


@dataclass(frozen=True, eq=False, repr=False)
class Percentile(Number):
    """A percentile of measured values with its interval; converts to a number with ``float()``.

    Attributes
    ----------
    value : float
        The percentile of the sample.
    lower, upper : float
        Two of the values, which enclose the true percentile with at least probability
        `confidence`; nan where the sample gives no limit.
    percent : float
        Which percentile, such as 99.
    unit : str
        Of the values.
    confidence : float
        Of the interval, in (0, 1).
    n : int
        Number of values.
    n_effective : float
        How many independent values are worth as much; equals `n` unless values beyond the
        percentile follow each other, and then the interval is computed with it.
    n_needed : int
        Least number of independent values that gives both limits.
    undefined : dict
        For each number that is nan, the reason.
    """

    value: float
    lower: float
    upper: float
    percent: float
    unit: str
    confidence: float
    n: int
    n_effective: float
    n_needed: int
    undefined: dict

    def __float__(self):
        return self.value

    def __repr__(self):
        return (
            f"P{self.percent:g} {_interval(self.value, self.lower, self.upper, self.unit)}, "
            f"confidence {self.confidence:g}, n {self.n}"
            + _worth(self.n, self.n_effective)
            + _reasons(self.undefined)
        )


@dataclass(frozen=True, eq=False, repr=False)
class Latency(Result):
    """Frame times: the usual numbers, the tail, and how well the sample knows them.

    Attributes
    ----------
    n : int
        Number of frames used.
    warm_up : int
        Number of first frames that were left out.
    unit : str
        "s", of all times.
    confidence : float
        Of each interval, in (0, 1).
    mean, max : float
        Mean and longest frame time.
    median, p95, p99 : float
        Percentiles of the sample, linearly interpolated.
    median_lower, median_upper, p95_lower, p95_upper, p99_lower, p99_upper : float
        Frame times that enclose the true percentile; nan where the sample gives no limit.
    throughput : float
        Frames per second of computing, 1 / mean: what the frames reach back to back.
    n_effective : float
        How many independent frames are worth as much, for the percentile that suffers most;
        equals `n` unless long frames follow each other. Each interval uses its own number.
    deadline : float
        Seconds that a frame may take; nan if none was given.
    misses : int
        Frames that took longer, 0 without a deadline.
    miss_share, miss_lower, miss_upper : float
        Their share of the frames with its interval; nan without a deadline.
    undefined : dict
        For each number that is nan, the reason.
    """

    n: int
    warm_up: int
    unit: str
    confidence: float
    mean: float
    max: float
    median: float
    median_lower: float
    median_upper: float
    p95: float
    p95_lower: float
    p95_upper: float
    p99: float
    p99_lower: float
    p99_upper: float
    throughput: float
    n_effective: float
    deadline: float
    misses: int
    miss_share: float
    miss_lower: float
    miss_upper: float
    undefined: dict

    def __repr__(self):
        rows = [
            f"{title} " + _interval(*(getattr(self, name + end) for end in _ENDS), self.unit)
            for name, title in (("median", "median"), ("p95", "P95"), ("p99", "P99"))
        ]
        rows.append(f"max {self.max:.6g} s, mean {self.mean:.6g} s")
        rows.append(f"{self.throughput:.6g} frames/s back to back")
        if self.deadline == self.deadline:
            share = _interval(self.miss_share, self.miss_lower, self.miss_upper, "")
            rows.append(f"{self.misses} longer than {self.deadline:g} s, share {share}")
        rows.append(f"confidence {self.confidence:g}, n {self.n}")
        if self.warm_up:
            rows[-1] += f" after {self.warm_up} of warm-up"
        return ", ".join(rows) + _worth(self.n, self.n_effective) + _reasons(self.undefined)


_ENDS = ("", "_lower", "_upper")


def frames_needed(percentile: float, confidence: float = 0.95) -> int:
    """Least number of independent frames that gives a percentile a lower and an upper limit.

    Parameters
    ----------
    percentile : float
        In percent, such as 99; from 1 to below 100.
    confidence : float
        Of the interval, in (0, 1).

    Returns
    -------
    int
        The least n with 1 - q^n - (1 - q)^n >= confidence, q = percentile / 100: the shortest
        and the longest of n frames enclose the percentile.

    Raises
    ------
    AmrError
        If the percentile is outside [1, 100) or the confidence outside (0, 1).

    References
    ----------
    Lecture 08. David and Nagaraja, Order Statistics (2003), section 7.1.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.frames_needed(50), am.frames_needed(95), am.frames_needed(99)
    (6, 59, 299)
    """
    return smallest_sample(_as_percent(percentile) / 100, as_probability(confidence, "confidence"))


def percentile(
    values: ArrayLike, percentile: float, confidence: float = 0.95, *, unit: str = "s"
) -> Percentile:
    """Percentile of measured values with an interval that holds for every distribution.

    Parameters
    ----------
    values : (N,) array
        Independent values, or successive ones: those beyond the percentile are tested for
        standing together in time.
    percentile : float
        In percent, such as 99.9; from 1 to below 100.
    confidence : float
        Of the interval, in (0, 1).
    unit : str
        Of the values; it is only said again.

    Returns
    -------
    Percentile
        `value` by linear interpolation as in NumPy. Each limit misses with half of
        1 - confidence where the sample is large enough for that; where the largest value is
        not, it is the limit all the same and the other one gets the rest. With fewer than
        `frames_needed` values there is no limit on the far side, and the other is one-sided.

    Raises
    ------
    AmrError
        If there is no value, one is not finite, or a number is out of range.

    References
    ----------
    Lecture 08. David and Nagaraja, Order Statistics (2003), eq. (7.1.2).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> times = np.random.default_rng(8).permutation(np.arange(1.0, 1001.0))
    >>> result = am.percentile(times, 50, unit="ms")
    >>> result.value, result.lower, result.upper
    (500.5, 469.0, 532.0)
    >>> am.percentile([0.02, 0.03, 0.025], 99).undefined["upper"]
    'P99 needs at least 299 values'
    """
    q, confidence = _as_percent(percentile), as_probability(confidence, "confidence")
    values = _as_series(values, "values")
    return _percentile(values, np.sort(values), q, confidence, unit, "values")


def latency(
    durations: ArrayLike,
    deadline: float | None = None,
    *,
    confidence: float = 0.95,
    warm_up: int = 0,
) -> Latency:
    """Summarize frame times: percentiles with intervals, throughput, missed deadlines.

    Parameters
    ----------
    durations : (N,) array
        Seconds of wall time that each frame took, in the order of the frames, >= 0.
    deadline : float, optional
        Seconds that a frame may take, > 0; a frame of exactly that time meets it.
    confidence : float
        Of each interval, in (0, 1).
    warm_up : int
        How many first frames to leave out, in which caches fill and code is loaded.

    Returns
    -------
    Latency
        Median, P95 and P99 with limits, maximum, mean, throughput, misses with the limits of
        Clopper and Pearson. Time N log N.

    Raises
    ------
    AmrError
        If no frame is left, a time is negative or not finite, all are 0, or a number is out
        of range.

    References
    ----------
    Lecture 08. David and Nagaraja, Order Statistics (2003), eq. (7.1.2); Clopper and Pearson,
    Biometrika 26 (1934).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> times = np.random.default_rng(8).gamma(4, 0.005, size=50)
    >>> am.latency(times, deadline=0.05).undefined["p99_upper"]
    'P99 needs at least 299 frames'
    """
    confidence = as_probability(confidence, "confidence")
    warm_up = as_count(warm_up, "warm_up", least=0)
    times = _as_series(durations, "durations", least=0)
    if warm_up >= len(times):
        raise AmrError(f"warm_up is {warm_up}, but there are only {len(times)} durations.")
    times = times[warm_up:]
    total = float(times.sum())
    if total == 0:
        raise AmrError(
            "durations are all 0: the clock is too coarse for these frames. Take them with "
            "time.perf_counter, as amrmetrics.measure does."
        )
    ranked = np.sort(times)
    numbers, undefined, worth = {}, {}, []
    for name, q in (("median", 50.0), ("p95", 95.0), ("p99", 99.0)):
        p = _percentile(times, ranked, q, confidence, "s", "frames")
        numbers |= {name: p.value, f"{name}_lower": p.lower, f"{name}_upper": p.upper}
        undefined |= {f"{name}_{end}": why for end, why in p.undefined.items()}
        worth.append(p.n_effective)
    misses, why_not = _misses(times, deadline, confidence)
    return Latency(
        n=len(times),
        warm_up=warm_up,
        unit="s",
        confidence=confidence,
        mean=total / len(times),
        max=float(ranked[-1]),
        **numbers,
        throughput=len(times) / total,
        n_effective=min(worth),
        **misses,
        undefined=undefined | why_not,
    )


def _percentile(values, ranked, percent, confidence, unit, what):
    n, q = len(values), percent / 100
    value = float(np.quantile(ranked, q))
    n_effective = effective_number(_above(values, value, q))
    worth = int(n_effective)
    low, high = spread_ranks(quantile_ranks(worth, q, confidence), n, worth)
    # In tiny samples the interpolated value can lie beside the limits: widen them.
    place = (n - 1) * q + 1
    low, high = low and min(low, int(place)), high and max(high, int(np.ceil(place)))
    needed = smallest_sample(q, confidence)
    why = f"P{percent:g} needs at least {needed} {what}"
    if n_effective < n:
        why += f"; these {n} are correlated and worth {worth}"
    undefined = {end: why for end, rank in (("lower", low), ("upper", high)) if rank is None}
    limits = (float("nan") if rank is None else float(ranked[rank - 1]) for rank in (low, high))
    return Percentile(
        value, *limits, percent, unit, confidence, n, float(n_effective), needed, undefined
    )


def _above(values, value, q):
    """Return which values lie above the quantile q; ties go where they fit best."""
    above, reached = values > value, values >= value
    expected = (1 - q) * len(values)
    nearer = abs(above.sum() - expected) <= abs(reached.sum() - expected)
    return above if nearer else reached


def _misses(times, deadline, confidence):
    """Return the fields on missed deadlines, and the reasons for those that are nan."""
    names = ("deadline", "miss_share", "miss_lower", "miss_upper")
    if deadline is None:
        nothing = dict.fromkeys(names, float("nan")) | {"misses": 0}
        return nothing, dict.fromkeys(names, NOT_ASKED)
    deadline = float(as_size(deadline, "deadline"))
    late = times > deadline
    share = float(late.mean())
    worth = effective_number(late)
    lower, upper = share_interval(share * worth, worth, confidence)
    numbers = (deadline, share, lower, upper)
    return dict(zip(names, numbers, strict=True)) | {"misses": int(late.sum())}, {}


@dataclass(frozen=True, eq=False, repr=False)
class RelocalizationTime(Number):
    """How long lost robots stay lost, runs that never recovered counted.

    Attributes
    ----------
    median : float
        The first time at which at most half are still lost (Kaplan-Meier); nan if the runs
        do not reach it.
    lower, upper : float
        Interval of the median; nan where the runs give no limit.
    unit : str
        "s".
    confidence : float
        Of the interval and of the band, in (0, 1).
    n, recovered, censored : int
        Number of runs, of those that recovered, and of those that had not when watching
        ended.
    times : (K,) array
        The different times in the data, increasing.
    still_lost : (K,) array
        Probability of being lost longer than each of them, in [0, 1].
    still_lost_lower, still_lost_upper : (K,) array
        Its interval at each single time; nan where nobody or everybody has recovered.
    undefined : dict
        For each number that is nan, the reason.
    """

    median: float
    lower: float
    upper: float
    unit: str
    confidence: float
    n: int
    recovered: int
    censored: int
    times: np.ndarray
    still_lost: np.ndarray
    still_lost_lower: np.ndarray
    still_lost_upper: np.ndarray
    undefined: dict

    def __float__(self):
        return self.median

    def __repr__(self):
        return (
            f"median {_interval(self.median, self.lower, self.upper, self.unit)} "
            f"(Kaplan-Meier), confidence {self.confidence:g}, n {self.n}: {self.recovered} "
            f"recovered, {self.censored} censored" + _reasons(self.undefined)
        )


def relocalization_time(
    durations: ArrayLike, recovered: ArrayLike, confidence: float = 0.95
) -> RelocalizationTime:
    """Median time to relocalize by Kaplan-Meier; runs that stayed lost are counted, not dropped.

    Parameters
    ----------
    durations : (N,) array
        Seconds from losing track to finding it again or, in runs that did not, to the end
        of watching; > 0.
    recovered : (N,) array of 0/1 or bool
        Whether the run found its place again. Watching must not end for a reason that has to
        do with how long the robot would still have been lost.
    confidence : float
        Of the intervals, in (0, 1).

    Returns
    -------
    RelocalizationTime
        Median with limits and the whole curve. The limits are where the interval of the
        curve, from Greenwood's variance of log(-log), leaves 1/2; they need as many runs as
        a median needs, 6 at 0.95.

    Raises
    ------
    AmrError
        If there is no run, a time is not positive and finite, a label is not 0 or 1, or the
        shapes differ.

    References
    ----------
    Lecture 08. Kaplan and Meier, JASA 53 (1958), eqs. (2a) and (2b); Brookmeyer and Crowley,
    Biometrics 38 (1982), with the transformation of Kalbfleisch and Prentice (2002), eq. (1.13).

    Examples
    --------
    >>> import amrmetrics as am
    >>> times = [2, 3, 3, 5, 8, 10, 10, 10]
    >>> result = am.relocalization_time(times, recovered=[1, 1, 1, 1, 1, 0, 0, 0])
    >>> result.median, result.lower, result.censored
    (5.0, 2.0, 3)
    """
    from scipy.stats import CensoredData, ecdf

    confidence = as_probability(confidence, "confidence")
    times = _as_series(durations, "durations")
    if times.min() <= 0:
        k = int(np.argmax(times <= 0))
        raise AmrError(f"durations[{k}] is {times[k]:g} s; a lost robot is lost for some time.")
    back = _as_recovered(recovered, times.shape)
    curve = ecdf(CensoredData.right_censored(times, ~back)).sf
    at, lost = np.asarray(curve.quantiles, float), curve.probabilities
    low, high = _band(times, back, at, lost, confidence)
    numbers, undefined = {}, {}
    needed = smallest_sample(0.5, confidence)
    for name, bound in (("median", lost), ("lower", low), ("upper", high)):
        if name != "median" and len(times) < needed:
            numbers[name] = float("nan")
            undefined[name] = f"an interval of the median needs at least {needed} runs"
            continue
        bound = np.where(np.isnan(bound), lost, bound)  # there the curve itself is 0 or 1
        half = np.flatnonzero(bound <= 0.5 + ROUNDING)
        numbers[name] = float(at[half[0]]) if len(half) else float("nan")
        if not len(half):
            undefined[name] = _why_never(name, back, times)
    return RelocalizationTime(
        **numbers,
        unit="s",
        confidence=confidence,
        n=len(times),
        recovered=int(back.sum()),
        censored=int((~back).sum()),
        times=at,
        still_lost=lost,
        still_lost_lower=low,
        still_lost_upper=high,
        undefined=undefined,
    )


def _band(times, back, at, lost, confidence):
    """Return the limits of the curve at each of its times, nan where the curve is 0 or 1.

    SciPy's are the same, but come with a warning where they are undefined.
    """
    from scipy.special import ndtri

    at_risk = len(times) - np.searchsorted(np.sort(times), at)
    ended = np.bincount(np.searchsorted(at, times[back]), minlength=len(at))
    inside = (lost > 0) & (lost < 1)
    S, low, high = lost[inside], np.full(len(at), np.nan), np.full(len(at), np.nan)
    greenwood = np.cumsum(ended / (at_risk * np.maximum(at_risk - ended, 1)))[inside]
    wide = np.exp(ndtri((1 + confidence) / 2) * np.sqrt(greenwood) / np.abs(np.log(S)))
    low[inside], high[inside] = S**wide, S ** (1 / wide)
    return low, high


def _why_never(name, back, times):
    if not back.any():
        return f"no run recovered within its {times.min():g} to {times.max():g} s"
    if name == "median":
        return f"more than half are still lost when the runs end, at {times.max():g} s"
    return "so few runs recovered that they give no limit"


def _as_recovered(value, shape):
    labels = as_array(value, "recovered")
    numbers = labels if labels.dtype == bool else as_numbers(labels, "recovered")
    if numbers.shape != shape:
        raise AmrError(f"recovered has shape {numbers.shape}; durations have {shape}.")
    wrong = (numbers != 0) & (numbers != 1)
    if wrong.any():
        k = int(np.argmax(wrong))
        raise AmrError(
            f"recovered[{k}] is {numbers[k]:g}; expected 1 for a run that found its place again, "
            "0 for one that did not."
        )
    return numbers == 1


def _as_series(value, name, least=None):
    series = as_numbers(value, name)
    if series.ndim != 1 or not len(series):
        raise AmrError(f"{name} has shape {series.shape}; expected (N,), N >= 1.")
    if least is not None and series.min() < least:
        k = int(np.argmin(series))
        raise AmrError(
            f"{name}[{k}] is {series[k]:g} s; no frame takes less than {least} s. Are these time "
            "stamps, or the differences of a clock that was set back?"
        )
    return series


def _as_percent(value):
    number = float(as_size(value, "percentile", sign=""))
    if not 1 <= number < 100:
        raise AmrError(f"percentile is {value!r}; expected a percentage in [1, 100), such as 99.")
    return number


def _interval(value, lower, upper, unit):
    """Write a number with its limits and its unit; a limit that is missing is said so."""
    texts = ["none" if x != x else f"{x:.6g}" for x in (lower, upper)]
    return f"{value:.6g} {unit}".rstrip() + f" [{texts[0]}, {texts[1]}]"


def _worth(n, n_effective):
    return f", correlated: worth {n_effective:.1f} independent ones" if n_effective < n else ""


def _reasons(undefined):
    """Write each reason once, without those for what was not asked for."""
    return "".join(f"; {why}" for why in dict.fromkeys(undefined.values()) if why != NOT_ASKED)
