"""One number for many trials, failures counted: what a table of a benchmark shows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from amrmetrics._intervals import quantile_ranks, share_interval
from amrmetrics._results import Result
from amrmetrics.aggregation import aggregate
from amrmetrics.benchmark.measuring import columns
from amrmetrics.errors import AmrError

STATISTICS = ("mean", "median", "p95")


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Summary(Result):
    """A statistic of one column over trials, with its interval, and the trials that failed.

    Attributes
    ----------
    metric, unit, better, statistic : str
        What it is.
    value, lower, upper : float
        nan where they do not exist, as where every trial failed; `why` says so.
    method : str
        How the interval was found.
    confidence : float
        Of the intervals, in (0, 1).
    done, failed, missing : int
        Trials that have run, those of them that failed, and those that have not run.
    failure_lower, failure_upper : float
        Interval of the share of failed trials (Clopper and Pearson).
    n : int
        Number of values; failed trials are among them under the rule "worst". A mean over
        several scenarios takes the mean of each as one value: trials of one scenario share
        what is hard about it, and are not independent of each other.
    failures : str
        The rule for failed trials.
    why : str
        Why a number is missing.
    """

    metric: str
    unit: str
    better: str
    statistic: str
    value: float
    lower: float
    upper: float
    method: str
    confidence: float
    done: int
    failed: int
    missing: int
    failure_lower: float
    failure_upper: float
    n: int
    failures: str
    why: str

    def __repr__(self):
        unit = f" {self.unit}" if self.unit else ""
        if self.value == self.value:
            text = f"{self.statistic} {self.metric} {self.value:.4g}{unit}{self.interval}"
        else:
            text = f"no {self.metric}"
        why = f"; {self.why}" if self.why else ""
        missing = f", {self.missing} missing" if self.missing else ""
        return f"{text}, n {self.n}, {self.failed} of {self.done} failed{missing}{why}"

    @property
    def interval(self):
        """The interval as text, empty if there is none."""
        if self.lower != self.lower and self.upper != self.upper:
            return ""
        low, high = (f"{x:.4g}" if x == x else "none" for x in (self.lower, self.upper))
        return f" [{low}, {high}]"


def filled(rows, metric, decisions):
    """Return the values of a column, one per row, and which of them stand for failed trials.

    Under the rule "worst" a failed trial gets the worst value that any of the rows has on its
    scenario, or anywhere if there is none. Without that rule, and where there is no value, the
    number is nan.
    """
    better = better_of(metric, decisions)
    values = np.array([np.nan if row[metric] is None else row[metric] for row in rows], float)
    failed = np.array([row["status"] == "failed" for row in rows], bool)
    values[failed] = np.nan
    if rule_of(metric, decisions) != "worst":
        return values, failed
    scenarios = np.array([row["scenario"] for row in rows])
    worst_of = np.nanmax if better == "lower" else np.nanmin
    having = _having(rows, values)
    for k in np.flatnonzero(failed & having):
        seen = values[(scenarios == scenarios[k]) & ~failed]
        seen = seen[~np.isnan(seen)]
        if not len(seen):
            seen = values[~failed]
        if not np.isnan(seen).all():
            values[k] = worst_of(seen)
    return values, failed


def _having(rows, values):
    """Say which rows are of systems that have this number at all, or never finished a trial."""
    has, finished = set(), set()
    for row, value in zip(rows, values, strict=True):
        if row["status"] == "ok":
            finished.add(row["system"])
            if value == value:
                has.add(row["system"])
    return np.array([row["system"] in has or row["system"] not in finished for row in rows], bool)


def better_of(metric, decisions):
    """Return "lower" or "higher", or "" where neither is."""
    known = columns(decisions)
    if metric not in known:
        raise AmrError(f"metric is {metric!r}; expected one of {', '.join(known)}.")
    return decisions["better"] if metric == decisions["metric"] else known[metric].better


def rule_of(metric, decisions):
    """Return how failed trials count in a column: "worst" or "separate".

    The rule of the protocol is about how good a result is. A failed trial has no worst latency,
    unless latency is what decides.
    """
    column = columns(decisions)[metric]
    applies = column.counts_failures and column.better
    return decisions["failures"] if applies or metric == decisions["metric"] else "separate"


def summarize(rows, metric, decisions):
    """Return a `Summary` for each (scenario, system), and for all scenarios as (None, system)."""
    values, _ = filled(rows, metric, decisions)
    groups = {}
    for k, row in enumerate(rows):
        for scenario in (row["scenario"], None):
            groups.setdefault((scenario, row["system"]), []).append(k)
    return {
        key: _summary([rows[k] for k in places], values[places], metric, decisions)
        for key, places in groups.items()
    }


def _summary(rows, values, metric, decisions):
    failed = sum(row["status"] == "failed" for row in rows)
    missing = sum(row["status"] == "missing" for row in rows)
    done = len(rows) - missing
    used = values[~np.isnan(values)]
    statistic, confidence = decisions["statistic"], decisions["confidence"]
    value = lower = upper = float("nan")
    method, why = "", _why_none(rows, metric, done, failed)
    if len(used) and failed < done:
        places = np.array([row["scenario"] for row in rows])[~np.isnan(values)]
        if statistic == "mean" and len(np.unique(places)) > 1:
            used = np.array([used[places == place].mean() for place in np.unique(places)])
        value, lower, upper, method, why = _STATISTICS[statistic](used, confidence)
    shares = share_interval(failed, done, confidence) if done else (float("nan"),) * 2
    return Summary(
        metric=metric,
        unit=columns(decisions)[metric].unit,
        better=better_of(metric, decisions),
        statistic=statistic,
        value=value,
        lower=lower,
        upper=upper,
        method=method,
        confidence=confidence,
        done=done,
        failed=failed,
        missing=missing,
        failure_lower=shares[0],
        failure_upper=shares[1],
        n=len(used) if failed < done else 0,
        failures=rule_of(metric, decisions),
        why=why,
    )


def _why_none(rows, metric, done, failed):
    if not done:
        return "no trial has run"
    if failed == done:
        return "every trial failed"
    known = {}
    for row in rows:
        if row["status"] == "ok":
            known |= row["skipped"]
    return next(iter(reason_for(metric, known)), "no trial has a value")


# Reasons are kept once for columns that have the same one.
TOGETHER = {
    "NEES": ("anees", "nees_"),
    "NIS": ("anis", "nis_"),
    "map": ("map_",),
    "closures": ("closure_", "false_closures", "average_precision"),
    "latency": ("latency_",),
    "rotation and RPE": ("ate_rotation", "rpe_"),
    "drift": ("drift_",),
}


def reason_for(metric, skipped):
    """Yield the reasons in `skipped` that are about a column."""
    for what, why in skipped.items():
        if metric.startswith((what, *TOGETHER.get(what, ()))):
            yield why


def _median(used, confidence):
    found = aggregate(used, confidence=confidence)
    return (
        found.median,
        found.median_lower,
        found.median_upper,
        "order statistics",
        found.undefined.get("median_lower", ""),
    )


def _mean(used, confidence):
    from scipy.special import stdtrit

    mean, n = aggregate(used, confidence=confidence).mean, len(used)
    if n < 2:
        return mean, float("nan"), float("nan"), "t", "an interval of the mean needs 2 values"
    half = float(stdtrit(n - 1, (1 + confidence) / 2)) * float(used.std(ddof=1)) / n**0.5
    return mean, mean - half, mean + half, "t", ""


def _p95(used, confidence):
    ranked = np.sort(used)
    value = aggregate(used, confidence=confidence, percentiles=(95,)).percentiles[95.0]
    ranks = quantile_ranks(len(used), 0.95, confidence)
    lower, upper = (float("nan") if k is None else float(ranked[k - 1]) for k in ranks)
    # In tiny samples the interpolated value can lie beside the limits.
    why = "" if upper == upper else "P95 has no upper limit with so few trials"
    return value, min(lower, value), upper, "order statistics", why


_STATISTICS = {"mean": _mean, "median": _median, "p95": _p95}
