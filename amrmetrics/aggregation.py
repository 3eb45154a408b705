"""One table row for many runs: averages, percentiles, and the runs that failed (lecture 09)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_array, as_numbers, as_probability
from amrmetrics._intervals import quantile_ranks, share_interval, smallest_sample
from amrmetrics._results import Result
from amrmetrics._runs import as_runs, as_sign, check_rule, worst_value
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike


@dataclass(frozen=True, eq=False, repr=False)
class Aggregate(Result):
    """Numbers of many runs, those that failed counted.

    Attributes
    ----------
    n, failed : int
        Number of runs, and how many of them failed.
    failure_share, failure_lower, failure_upper : float
        Share of failed runs with its interval.
    failures : str
        The rule for failed runs: "worst", "censored", "separate" or "none failed".
    failure_value : float
        What they were given by the rule "worst", else nan.
    n_used : int
        Number of runs in the numbers below: all but those that "separate" leaves aside.
    mean, median, interquartile_mean : float
        The last is the mean of the middle half: a quarter of the runs, rounded down, is cut
        at each end.
    median_lower, median_upper : float
        Two of the values, which enclose the true median with at least probability
        `confidence`.
    percentiles : dict of float
        For each percentage asked for, linearly interpolated.
    unit : str
        Of the values.
    confidence : float
        Of the intervals, in (0, 1).
    scenarios : dict of dict
        For each scenario the same numbers of its runs, as plain numbers.
    undefined : dict
        For each other number that is nan, the reason.
    notes : tuple of str
        What limits what the numbers say.
    """

    n: int
    failed: int
    failure_share: float
    failure_lower: float
    failure_upper: float
    failures: str
    failure_value: float
    n_used: int
    mean: float
    median: float
    interquartile_mean: float
    median_lower: float
    median_upper: float
    percentiles: dict
    unit: str
    confidence: float
    scenarios: dict
    undefined: dict
    notes: tuple

    def __repr__(self):
        unit = f" {self.unit}" if self.unit else ""
        tails = "".join(f", P{q:g} {x:.6g}{unit}" for q, x in self.percentiles.items())
        rule = f", rule {self.failures}" if self.failed else ""
        if self.failure_value == self.failure_value:
            rule += f", entered as {self.failure_value:.6g}{unit}"
        return (
            f"mean {self.mean:.6g}{unit}, median {self.median:.6g}{unit} "
            f"[{self.median_lower:.6g}, {self.median_upper:.6g}], interquartile mean "
            f"{self.interquartile_mean:.6g}{unit}{tails}, {self.failed} of {self.n} runs failed "
            f"(share {self.failure_share:.3g} [{self.failure_lower:.3g}, "
            f"{self.failure_upper:.3g}]{rule}), confidence {self.confidence:g}, n {self.n_used}"
            + (f", {len(self.scenarios)} scenarios" if self.scenarios else "")
            + "".join(f"; {x}" for x in (*dict.fromkeys(self.undefined.values()), *self.notes))
        )


def aggregate(
    values: ArrayLike,
    scenarios: ArrayLike | None = None,
    *,
    failures: str | None = None,
    worst: float | None = None,
    better: str = "lower",
    percentiles: ArrayLike = (5, 95),
    confidence: float = 0.95,
    unit: str | None = None,
) -> Aggregate:
    """Summarize one number per run over runs and scenarios; no failed run gets lost.

    Parameters
    ----------
    values : (N,) array
        One number per run; nan where the run failed. Results such as those of `ate` are
        taken, too.
    scenarios : (N,) array of labels, optional
        Which scenario each run belongs to; each gets its own numbers beside those of all runs,
        in which every run counts once.
    failures : {None, "worst", "censored", "separate"}
        How failed runs count: with the worst value; as worse than all others by an unknown
        amount, which leaves the median and the other percentiles but no mean; or counted
        beside the others. Required if a run failed.
    worst : float, optional
        The value of a failed run under "worst"; the worst of all runs if not given.
    better : {"lower", "higher"}
        Which values are good.
    percentiles : sequence of float
        In percent, from 0 to 100.
    confidence : float
        Of the intervals of the median and of the share of failed runs, in (0, 1).
    unit : str, optional
        Of the values; results bring their own.

    Returns
    -------
    Aggregate
        The numbers, the rule, and how many runs failed, with the limits of Clopper and Pearson.

    Raises
    ------
    AmrError
        If there is no run, a run failed and no rule is given, a value is infinite, labels and
        values differ in number, or an option is unknown.

    References
    ----------
    Lecture 09. Interquartile mean: Agarwal et al., Deep reinforcement learning at the edge of
    the statistical precipice, NeurIPS 2021.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> errors = [0.2, 0.3, 0.4, 0.5, np.nan]
    >>> am.aggregate(errors, failures="censored").median
    0.4
    >>> round(am.aggregate(errors, failures="worst", worst=3.0).mean, 6)
    0.88
    """
    confidence, sign = as_probability(confidence, "confidence"), as_sign(better)
    wanted = as_numbers(percentiles, "percentiles").ravel()
    if ((wanted < 0) | (wanted > 100)).any():
        raise AmrError(f"percentiles are {percentiles!r}; expected percentages from 0 to 100.")
    runs, unit = as_runs(values, "values", unit)
    lost = np.isnan(runs)
    check_rule(failures, worst, lost, "values")
    value = float("nan")
    if failures == "worst" and lost.any():
        value = worst_value(runs, worst, sign)
    fill = {"worst": value, "censored": sign * np.inf}.get(failures, np.nan)
    options = (fill, failures or "none failed", wanted, confidence, unit)
    groups = _groups(scenarios, len(runs))
    parts = {name: _summary(runs[rows], *options).as_dict() for name, rows in groups.items()}
    sizes = [len(rows) for rows in groups.values()]
    notes = ()
    if len(set(sizes)) > 1:
        notes = (f"scenarios have {min(sizes)} to {max(sizes)} runs: those with more weigh more",)
    return _summary(runs, *options, parts, notes)


def _groups(scenarios, n):
    """Return the rows of each scenario, in the order in which they first occur."""
    if scenarios is None:
        return {}
    labels = as_array(scenarios, "scenarios")
    if labels.shape != (n,):
        raise AmrError(f"scenarios has shape {labels.shape}; expected one label per run, ({n},).")
    names = dict.fromkeys(labels.tolist())
    return {name: np.flatnonzero(labels == name) for name in names}


def _summary(runs, fill, rule, wanted, confidence, unit, scenarios=None, notes=()):
    lost = np.isnan(runs)
    used = np.sort(runs[~lost] if np.isnan(fill) else np.where(lost, fill, runs))
    n = len(used)
    cut = n // 4
    middle = used[cut : n - cut]
    low, high = quantile_ranks(n, 0.5, confidence) if n else (None, None)
    numbers = {
        "mean": used.mean() if n else np.nan,
        "median": _quantile(used, 0.5),
        "interquartile_mean": middle.mean() if n else np.nan,
        "median_lower": np.nan if low is None else used[low - 1],
        "median_upper": np.nan if high is None else used[high - 1],
    }
    tails = {float(q): _quantile(used, q / 100) for q in wanted}
    undefined = {}
    for name, x in {**numbers, **{f"P{q:g}": x for q, x in tails.items()}}.items():
        if not np.isfinite(x):
            undefined[name] = _why_not(name, x, n, confidence)
    failed = int(lost.sum())
    shares = share_interval(failed, len(runs), confidence)
    return Aggregate(
        n=len(runs),
        failed=failed,
        failure_share=failed / len(runs),
        failure_lower=shares[0],
        failure_upper=shares[1],
        failures=rule,
        failure_value=float(fill) if rule == "worst" and failed else float("nan"),
        n_used=n,
        **{name: float(x) if np.isfinite(x) else float("nan") for name, x in numbers.items()},
        percentiles={q: x if np.isfinite(x) else float("nan") for q, x in tails.items()},
        unit=unit,
        confidence=confidence,
        scenarios=scenarios or {},
        undefined=undefined,
        notes=notes,
    )


def _quantile(ranked, q):
    """Return the interpolated quantile; infinite as soon as an infinite value weighs in it."""
    if not len(ranked):
        return float("nan")
    place = (len(ranked) - 1) * q
    below = int(place)
    part = place - below
    if part == 0:
        return float(ranked[below])
    return float(ranked[below] * (1 - part) + ranked[below + 1] * part)


def _why_not(name, x, n, confidence):
    if n == 0:
        return "every run failed"
    if np.isinf(x):
        return f"{name} would need the values of failed runs"
    return f"an interval of the median needs at least {smallest_sample(0.5, confidence)} runs"
