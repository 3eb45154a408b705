"""Which of two systems is better, by how much, and how sure that is (lecture 09).

Both systems run the same scenarios with the same seeds, and what is judged are the
differences of their runs, A - B. A result says who is better only if its interval excludes 0.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._arguments import as_numbers, as_probability, as_size
from amrmetrics._results import Result
from amrmetrics._runs import as_pairs, rounding
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import Array, ArrayLike

# Effects that no affordable number of runs shows.
SMALLEST_EFFECT = 1e-3

# Larger values of t are scaled down before their noncentrality is sought.
LARGE_T = 1000.0


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Comparison(Result):
    """What paired runs say about two systems, A and B.

    Attributes
    ----------
    verdict : str
        "A better" or "B better" if the interval excludes 0, else "undecided"; "conflicting" if
        the one that is better in the runs that both finished failed more often.
    statistic : str
        What was taken of the differences A - B, such as "mean".
    estimate, lower, upper : float
        Its value and its interval.
    unit : str
        Of the differences.
    confidence : float
        Of all intervals, in (0, 1).
    n : int
        Number of differences that were used.
    method, assumption : str
        How the interval was found, and what has to be true for it.
    mean, std : float
        Of the differences, std with divisor n - 1.
    effect_name : str
        "Cohen's d_z", which is mean / std, or "share of runs that B wins" among those that
        differ.
    effect, effect_lower, effect_upper : float
        The size of the effect with its interval.
    better : str
        "lower" or "higher": which values are good.
    failures : str
        The rule for failed runs: "worst", "censored", "separate" or "none failed".
    failed_a, failed_b, failed_both : int
        Runs in which A failed, B failed, both failed.
    failure_value : float
        What failed runs were given by the rule "worst", else nan.
    undefined : dict
        For each other number that is nan, the reason.
    notes : tuple of str
        What limits what the numbers say.
    """

    verdict: str
    statistic: str
    estimate: float
    lower: float
    upper: float
    unit: str
    confidence: float
    n: int
    method: str
    assumption: str
    mean: float
    std: float
    effect_name: str
    effect: float
    effect_lower: float
    effect_upper: float
    better: str
    failures: str
    failed_a: int
    failed_b: int
    failed_both: int
    failure_value: float
    undefined: dict
    notes: tuple

    def __repr__(self):
        unit = f" {self.unit}" if self.unit else ""
        by = f" by {abs(self.estimate):.6g}{unit}" if self.verdict.endswith("better") else ""
        text = (
            f"{self.verdict}{by}: {self.statistic} of A - B {self.estimate:.6g}{unit}, "
            f"{100 * self.confidence:g} % interval [{self.lower:.6g}, {self.upper:.6g}]{unit}"
            f"{self._test()}, {self.effect_name} {self.effect:.3g} "
            f"[{self.effect_lower:.3g}, {self.effect_upper:.3g}], n {self.n}, {self.better} is "
            f"better; {self.method}, which assumes {self.assumption}"
        )
        if self.failed_a or self.failed_b:
            text += (
                f"; failed: A {self.failed_a}, B {self.failed_b} (both {self.failed_both}), rule "
                f"{self.failures}"
            )
            if self.failure_value == self.failure_value:
                text += f", entered as {self.failure_value:.6g}{unit}"
        reasons = dict.fromkeys(self.undefined.values())
        return text + "".join(f"; {why}" for why in (*reasons, *self.notes))

    def _test(self):
        return ""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PairedTest(Comparison):
    """A `Comparison` by the t distribution.

    Attributes
    ----------
    t : float
        mean / (std / sqrt(n)).
    dof : int
        n - 1.
    p_value : float
        Probability of a mean at least as far from 0, on either side, if the true one is 0.
    """

    t: float
    dof: int
    p_value: float

    def _test(self):
        return f", t {self.t:.6g}, p {self.p_value:.3g}"


def compare_paired(
    a: ArrayLike,
    b: ArrayLike,
    confidence: float = 0.95,
    *,
    failures: str | None = None,
    worst: float | None = None,
    better: str = "lower",
    unit: str | None = None,
) -> PairedTest:
    """Compare two systems by the t interval of the differences of their paired runs.

    Parameters
    ----------
    a, b : (N,) array
        One number per run, N >= 2; run k of both on the same scenario with the same seed. A
        failed run is nan. Results such as those of `ate` are taken, too.
    confidence : float
        Of the intervals, in (0, 1).
    failures : {None, "worst", "separate"}
        How failed runs count: with the worst value, or counted beside the others. Required
        if a run failed.
    worst : float, optional
        The value of a failed run under "worst"; the worst of all runs if not given.
    better : {"lower", "higher"}
        Which values are good.
    unit : str, optional
        Of the values; results bring their own.

    Returns
    -------
    PairedTest
        Mean of A - B with interval, t, p-value, Cohen's d_z with interval, and the verdict.

    Raises
    ------
    AmrError
        If the numbers of runs differ, there is only one, a run failed and no rule is given, a
        value is infinite, or an option is unknown.

    References
    ----------
    Lecture 09. Student, Biometrika 6 (1908); the interval of d_z from the noncentral t
    distribution: Cumming and Finch, Educational and Psychological Measurement 61 (2001).

    Examples
    --------
    >>> import amrmetrics as am
    >>> a = [0.52, 0.48, 0.50, 0.43, 0.49, 0.45, 0.47, 0.51]
    >>> result = am.compare_paired(a, [0.40] * 8, unit="m")
    >>> result.verdict, round(result.mean, 5), round(result.lower, 6), round(result.upper, 6)
    ('B better', 0.08125, 0.055799, 0.106701)
    """
    from scipy.special import stdtr, stdtrit

    confidence = as_probability(confidence, "confidence")
    pairs = as_pairs(a, b, failures, worst, better, unit)
    n, mean, std = moments(pairs)
    lower = upper = t = p_value = d = d_lower = d_upper = float("nan")
    why = why_no_spread(pairs, n, std)
    if not why:
        error = std / np.sqrt(n)
        t = mean / error
        half = float(stdtrit(n - 1, (1 + confidence) / 2)) * error
        lower, upper = mean - half, mean + half
        p_value = float(2 * stdtr(n - 1, -abs(t)))
        d = mean / std
        d_lower, d_upper = _noncentral_limits(t, n - 1, confidence) / np.sqrt(n)
    names = ("lower", "upper", "t", "p_value", "effect", "effect_lower", "effect_upper")
    return PairedTest(
        **described(pairs, n, mean, std, lower, upper, confidence, better),
        statistic="mean",
        estimate=mean,
        method="paired t",
        assumption="independent runs with normal differences",
        effect_name="Cohen's d_z",
        effect=float(d),
        effect_lower=float(d_lower),
        effect_upper=float(d_upper),
        t=float(t),
        dof=n - 1,
        p_value=p_value,
        undefined=reasons_for_nan(n, dict.fromkeys(names, why) if why else {}),
        notes=(),
    )


def holm(p_values: ArrayLike) -> Array:
    """Adjust p-values of several comparisons, so that all claims hold together.

    Parameters
    ----------
    p_values : (M,) array
        In [0, 1], of any dependence.

    Returns
    -------
    (M,) array
        Adjusted p-values in the same order. Claiming those of at most alpha, the probability
        of a wrong claim among all of them is at most alpha.

    Raises
    ------
    AmrError
        If there is none, or one is outside [0, 1] or not finite.

    References
    ----------
    Lecture 09. Holm, A simple sequentially rejective multiple test procedure, Scandinavian
    Journal of Statistics 6 (1979).

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.holm([0.01, 0.04, 0.03]).round(12).tolist()
    [0.03, 0.06, 0.06]
    """
    p = as_numbers(p_values, "p_values")
    if p.ndim != 1 or not len(p):
        raise AmrError(f"p_values has shape {p.shape}; expected (M,), M >= 1.")
    outside = (p < 0) | (p > 1)
    if outside.any():
        k = int(np.argmax(outside))
        raise AmrError(f"p_values[{k}] is {p[k]:g}; a probability lies in [0, 1].")
    order = np.argsort(p)
    adjusted = np.empty(len(p))
    factors = np.arange(len(p), 0, -1)
    adjusted[order] = np.minimum(1, np.maximum.accumulate(factors * p[order]))
    return adjusted


def power(difference: ArrayLike, std: ArrayLike, n: ArrayLike, confidence: float = 0.95) -> Any:
    """Probability that `compare_paired` shows a true difference.

    Parameters
    ----------
    difference : float or array
        True mean of A - B.
    std : float or array
        Standard deviation of the differences of runs, in the same unit, > 0.
    n : int or array of int
        Number of paired runs, >= 2.
    confidence : float
        Of the interval, in (0, 1).

    Returns
    -------
    float or array
        Probability that the interval excludes 0, on either side; 1 - confidence without a
        difference.

    Raises
    ------
    AmrError
        If std is not positive, n no whole number of at least 2, or the confidence outside
        (0, 1).

    References
    ----------
    Lecture 09: t has the noncentral t distribution with n - 1 degrees of freedom and
    noncentrality sqrt(n) difference / std. Johnson, Kotz and Balakrishnan, Continuous
    Univariate Distributions 2 (1995), chapter 31.

    Examples
    --------
    >>> from amrmetrics import comparison
    >>> round(comparison.power(0.02, 0.05, n=20), 3)
    0.397
    """
    confidence = as_probability(confidence, "confidence")
    difference, std = as_numbers(difference, "difference"), as_numbers(std, "std")
    n = as_numbers(n, "n")
    if (std <= 0).any():
        raise AmrError(f"std is {std.min():g}; runs that differ by chance have a positive one.")
    if (n < 2).any() or (n != np.round(n)).any():
        raise AmrError(f"n is {n}; expected whole numbers of at least 2.")
    found = _power(np.abs(difference) / std, n, confidence)
    return found if np.ndim(found) else float(found)


def runs_needed(difference: float, std: float, power: float = 0.9, confidence: float = 0.95) -> int:
    """Smallest number of paired runs with which `compare_paired` shows a true difference.

    For NEES and NIS values there is another one, ``amrmetrics.runs_needed``.

    Parameters
    ----------
    difference : float
        True mean of A - B, not 0.
    std : float
        Standard deviation of the differences of runs, in the same unit, > 0.
    power : float
        Wanted probability of showing it, in (0, 1) and above 1 - confidence.
    confidence : float
        Of the interval, in (0, 1).

    Returns
    -------
    int
        Number of runs, >= 2.

    Raises
    ------
    AmrError
        If an argument is out of range, or the difference is below 1e-3 standard deviations.

    References
    ----------
    Lecture 09, from `power`.

    Examples
    --------
    >>> from amrmetrics import comparison
    >>> n = comparison.runs_needed(0.02, 0.05)
    >>> n, comparison.power(0.02, 0.05, n) >= 0.9
    (68, True)
    """
    wanted = as_probability(power, "power")
    confidence = as_probability(confidence, "confidence")
    if wanted <= 1 - confidence:
        raise AmrError(f"power is {wanted:g}; systems that are equal are told apart that often.")
    size = abs(float(as_size(difference, "difference", sign=""))) / float(as_size(std, "std"))
    if size < SMALLEST_EFFECT:
        raise AmrError(
            f"difference is {difference!r}, less than {SMALLEST_EFFECT:g} standard deviations; "
            "showing that takes ten million runs."
        )
    high = 2
    while _power(size, high, confidence) < wanted:
        high *= 2
    low = max(1, high // 2)
    while high - low > 1:
        middle = (low + high) // 2
        enough = _power(size, middle, confidence) >= wanted
        low, high = (low, middle) if enough else (middle, high)
    return high


def _power(size, n, confidence):
    from scipy.special import nctdtr, stdtrit

    limit, shift = stdtrit(n - 1, (1 + confidence) / 2), np.sqrt(n) * size
    # SciPy returns nan in place of probabilities below 1e-15.
    upper, lower = (np.nan_to_num(nctdtr(n - 1, shift, x), nan=0.0) for x in (limit, -limit))
    return 1 - upper + lower


def _noncentral_limits(t, dof, confidence):
    """Return the noncentralities for which t lies at the ends of the central interval."""
    from scipy.optimize import brentq
    from scipy.special import chdtri, nctdtr, ndtri

    # Far out, t is the noncentrality over a chi variable: both limits are proportional to t.
    size = min(abs(t), LARGE_T)
    tail = (1 - confidence) / 2
    least = 1.01 * ndtri(tail)
    most = size * np.sqrt(chdtri(dof, tail / 2) / dof) - ndtri(tail / 2)

    limits = np.array(
        [brentq(lambda x, p=p: nctdtr(dof, x, size) - p, least, most) for p in (1 - tail, tail)]
    )
    limits *= max(1, abs(t) / LARGE_T)
    return limits if t >= 0 else -limits[::-1]


def moments(pairs):
    """Return n, mean and standard deviation of the differences, nan where there are none."""
    d = pairs.differences
    if not np.isfinite(d).all():
        return len(d), float("nan"), float("nan")
    mean = float(d.mean()) if len(d) else float("nan")
    return len(d), mean, float(d.std(ddof=1)) if len(d) > 1 else float("nan")


def why_no_spread(pairs, n, std):
    """Return why the differences have no spread to judge their mean by, or None."""
    if n < 2:
        return f"both systems finished {n} of the runs; an interval needs at least 2 such runs"
    if std <= rounding(pairs.scale):
        return (
            f"all {n} differences are equal, so there is no spread to judge by: are they runs "
            "with different seeds? compare_sign_flip needs no spread"
        )
    return None


def described(pairs, n, mean, std, lower, upper, confidence, better):
    """Return the fields that all comparisons share."""
    for_b, for_a = (bool(lower > 0), bool(upper < 0))[:: pairs.sign]
    verdict = "B better" if for_b else "A better" if for_a else "undecided"
    if pairs.fields["failures"] == "separate":
        more = pairs.fields["failed_b"] - pairs.fields["failed_a"]
        if (for_b and more > 0) or (for_a and more < 0):
            verdict = "conflicting"
    return pairs.fields | {
        "verdict": verdict,
        "lower": float(lower) if is_finite(lower) else float("nan"),
        "upper": float(upper) if is_finite(upper) else float("nan"),
        "unit": pairs.unit,
        "confidence": confidence,
        "n": n,
        "mean": mean,
        "std": std,
        "better": better,
    }


def reasons_for_nan(n, reasons, censored=False):
    """Add the reasons why mean and std are nan."""
    if censored:
        why = "a failed run has no value, so the differences have no mean"
        return reasons | {"mean": why, "std": why}
    if n == 0:
        return reasons | dict.fromkeys(("mean", "estimate", "std"), "no run was finished by both")
    return reasons | ({"std": "a single run has no spread"} if n == 1 else {})


def is_finite(x):
    return abs(x) < np.inf
