"""Which system is better than which, of all pairs at once (lecture 10).

Trials are paired: the same scenario with the same seed is the same world. Seeds of one scenario
say nothing of other scenarios, so that on all of them together the mean of a scenario counts as
one number; on one scenario each seed does.

The question of a protocol is who is better over all scenarios: these pairs are the primary family
of tests, and their verdicts hold together by Holm's correction. Verdicts on single scenarios are a
secondary family, and hold together among themselves.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._results import Result
from amrmetrics.benchmark.evaluating import Evaluation, evaluate
from amrmetrics.benchmark.measuring import columns
from amrmetrics.benchmark.summarizing import better_of, filled, reason_for, rule_of
from amrmetrics.comparison import compare_paired, holm
from amrmetrics.errors import AmrError
from amrmetrics.resampling import EXACT_UP_TO, compare_sign_flip

if TYPE_CHECKING:
    from amrmetrics._types import Path as PathLike

# What stands in the column "scenario" where all of them are taken together.
ALL = "all scenarios"
# Families of tests, each with a correction of its own.
PRIMARY, SECONDARY = "primary", "secondary"


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Comparisons(Result):
    """All pairs of systems, on all scenarios together and on each one.

    Attributes
    ----------
    title : str
        Of the evaluation, with what limits it.
    metric, unit, better : str
        What was compared.
    failures : str
        The rule for failed trials, "worst" or "separate".
    confidence : float
        Of each interval, and of all verdicts of a family together.
    tests : int
        How many p-values Holm's correction was made for in the primary family: pairs over all
        scenarios.
    secondary_tests : int
        Likewise in the secondary family: pairs on single scenarios.
    rows : tuple of dict
        One per pair and scenario, as in `table`.
    """

    title: str
    metric: str
    unit: str
    better: str
    failures: str
    confidence: float
    tests: int
    secondary_tests: int
    rows: tuple

    def table(self) -> list[dict[str, Any]]:
        """Return one dictionary per pair and scenario, ready for pandas.

        `mean`, `lower` and `upper` are of the `n` differences a - b, which are means of
        scenarios on all of them together and trials on one; each interval for itself. `p` is
        the t test's, `p_sign_flip` that of the exact test where there are few, `p_holm` is `p`
        after Holm's correction within its `family`, by which alone `verdict` goes. `trials`
        counts the pairs that both have a number for.
        """
        return [dict(row) for row in self.rows]

    def verdict(self, a: str, b: str, scenario: str | None = None) -> str:
        """Return "X better" with the name of the better system, "undecided" or "conflicting".

        Under the rule "separate" it is conflicting if the one that is better in the trials that
        both finished failed more often.

        Raises
        ------
        AmrError
            If this pair was not compared on this scenario.
        """
        where = scenario or ALL
        for row in self.rows:
            if {row["a"], row["b"]} == {a, b} and a != b and row["scenario"] == where:
                return row["verdict"]
        raise AmrError(f"{a!r} and {b!r} were not compared on {where!r}.")

    def as_dict(self):
        """Return everything as plain numbers and text, None in place of nan."""
        rows = super().as_dict()
        rows["rows"] = [
            {key: None if value != value else value for key, value in row.items()}
            for row in self.rows
        ]
        return rows

    def _title(self):
        unit = f" [{self.unit}]" if self.unit else ""
        return (
            f"{self.title}; differences of {self.metric}{unit}, {self.better} is better, paired "
            f"by scenario and seed, rule {self.failures} for failed trials; verdicts at "
            f"{100 * self.confidence:g} % after Holm over {self.tests} primary tests"
            + (f", and over {self.secondary_tests} secondary ones" if self.secondary_tests else "")
        )

    def _rows(self):
        return [(_name_of(row), self._said(row)) for row in self.rows]

    def _said(self, row):
        failed = f"failed {row['failed_a']} and {row['failed_b']}"
        why = f"; {row['why']}" if row["why"] else ""
        if row["p"] != row["p"]:
            return f"{row['verdict']}, n {row['n']}, {failed}{why}"
        return (
            f"{row['verdict']}: {row['mean']:.4g} [{row['lower']:.4g}, {row['upper']:.4g}] "
            f"{self.unit}".rstrip()
            + f", p after Holm {row['p_holm']:.3g}, n {row['n']} from "
            f"{row['trials']} trials, {failed}{why}"
        )

    def __repr__(self):
        rows = self._rows()
        width = max((len(name) for name, _ in rows), default=0)
        return "\n".join([self._title(), *(f"  {name:{width}}  {text}" for name, text in rows)])


def _name_of(row):
    family = "" if row["family"] == PRIMARY else f" ({SECONDARY})"
    return f"{row['a']} - {row['b']}, {row['scenario']}{family}"


def compare(
    folder: PathLike | Evaluation,
    metric: str | None = None,
    *,
    systems: Iterable[str] | None = None,
    scenarios: Iterable[str] | None = None,
    jobs: int | None = None,
) -> Comparisons:
    """Compare all systems two by two, paired by scenario and seed.

    Parameters
    ----------
    folder : str, Path or Evaluation
        A benchmark's folder, which is evaluated first, or what `evaluate` returned.
    metric : str, optional
        A column of the table in which lower or higher is better; that of the protocol by
        default.
    systems, scenarios : sequence of str, optional
        Only these; the title says so. Holm's correction is for what is shown, in two families:
        the pairs over all scenarios, which are primary, and those on single scenarios.
    jobs : int, optional
        As in `evaluate`.

    Returns
    -------
    Comparisons
        For each pair the mean of the differences with the t interval, and the verdict after
        Holm, on all scenarios together (their means count) and on each (its seeds count). A
        failed trial counts as the worst value that any system has on its scenario, or
        is counted beside the others, as the protocol says.

    Raises
    ------
    AmrError
        If there are not two systems, a name is unknown, or of the metric neither lower nor
        higher is better.

    References
    ----------
    Lecture 10; the tests are those of lecture 09.

    Examples
    --------
    >>> import tempfile
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t, rng = np.arange(0.0, 20.0, 0.1), np.random.default_rng(10)
    >>> xy = np.c_[5 * np.cos(t / 2), 3 * np.sin(t)]
    >>> truth = am.Trajectory(t, am.planar_poses(xy, 0 * t))
    >>> def drive(noise):
    ...     noisy = xy + noise * rng.normal(size=xy.shape)
    ...     return am.Trajectory(t, am.planar_poses(noisy, 0 * t))
    >>> table = [
    ...     {"system": name, "scenario": "yard", "seed": seed, "reference": truth,
    ...      "estimate": drive(noise)}
    ...     for name, noise in (("orb", 0.02), ("vins", 0.04)) for seed in range(8)
    ... ]
    >>> folder = tempfile.mkdtemp()
    >>> _ = am.benchmark.adopt(table, folder)
    >>> am.benchmark.compare(folder).verdict("orb", "vins")
    'orb better'
    """
    if not isinstance(folder, Evaluation):
        folder = evaluate(folder, jobs=jobs)
    evaluation = folder
    decisions = evaluation.decisions
    metric = metric or decisions["metric"]
    better = better_of(metric, decisions)
    if not better:
        raise AmrError(f"of {metric} neither lower nor higher is better: it cannot be compared.")
    chosen, limits = _chosen(evaluation, systems, scenarios)
    names = list(dict.fromkeys(row["system"] for row in chosen))
    if len(names) < 2:
        raise AmrError(f"a comparison needs two systems; there is {', '.join(names) or 'none'}.")
    rule = rule_of(metric, decisions)
    found = _compared(chosen, names, metric, decisions)
    rows = _judged(list(found), better, rule, decisions["confidence"])
    return Comparisons(
        title="; ".join([evaluation.title, *limits]),
        metric=metric,
        unit=columns(decisions)[metric].unit,
        better=better,
        failures=rule,
        confidence=decisions["confidence"],
        tests=_counted(rows, PRIMARY),
        secondary_tests=_counted(rows, SECONDARY),
        rows=tuple(rows),
    )


def _chosen(evaluation, systems, scenarios):
    rows, limits = list(evaluation.rows), []
    for what, wanted in (("system", systems), ("scenario", scenarios)):
        if wanted is None:
            continue
        known = list(dict.fromkeys(row[what] for row in evaluation.rows))
        wanted = [wanted] if isinstance(wanted, str) else list(wanted)
        strange = [x for x in wanted if x not in known]
        if strange:
            raise AmrError(f"there is no {what} {strange[0]!r}; there are {', '.join(known)}.")
        rows = [row for row in rows if row[what] in wanted]
        if set(wanted) != set(known):
            limits.append(f"COMPARED: {len(wanted)} of {len(known)} {what}s ({', '.join(wanted)})")
    return rows, limits


def _compared(rows, names, metric, decisions):
    """Yield a row for each pair on all scenarios, and on each if there are several."""
    values, _ = filled(rows, metric, decisions)
    runs = {name: {} for name in names}
    for row, value in zip(rows, values.tolist(), strict=True):
        runs[row["system"]][row["scenario"], row["seed"]] = (row, value)
    scenarios = list(dict.fromkeys(row["scenario"] for row in rows))
    for where in (ALL, *(scenarios if len(scenarios) > 1 else ())):
        for a, b in combinations(names, 2):
            keys = [key for key in runs[a] if key in runs[b] and where in (ALL, key[0])]
            pairs = [(runs[a][key], runs[b][key]) for key in keys]
            who = {"scenario": where, "family": PRIMARY if where == ALL else SECONDARY}
            several = where == ALL and len(scenarios) > 1
            yield who | {"a": a, "b": b} | _pair(pairs, a, b, metric, decisions, several)


def _pair(pairs, a, b, metric, decisions, several):
    """Return the numbers of two systems on these trials.

    The unit is the scenario if there are several, even if the two share one only, else the trial.
    """
    done = [pair for pair in pairs if all(row["status"] != "missing" for row, _ in pair)]
    failed = [[row["status"] == "failed" for row, _ in pair] for pair in done]
    found = {
        "failed_a": sum(x for x, _ in failed),
        "failed_b": sum(y for _, y in failed),
        "failed_both": sum(x and y for x, y in failed),
        "missing": len(pairs) - len(done),
    }
    kept = {}
    for (row, x), (_, y) in done:
        if x == x and y == y:
            kept.setdefault(row["scenario"], []).append((x, y))
    found |= dict.fromkeys(NUMBERS, float("nan"))
    found |= {"n": 0, "trials": sum(map(len, kept.values())), "why": ""}
    if not kept:
        return found | {"why": _why_no_pair(done, failed, a, b, metric)}
    if several:
        x, y = np.array([np.mean(values, axis=0) for values in kept.values()]).T
    else:
        x, y = np.array(next(iter(kept.values()))).T
    found |= {"n": len(x), "mean": float((x - y).mean())}
    if len(x) < 2:
        unit = "scenario" if several else "pair of trials"
        return found | {"why": f"one {unit} shows no spread"}
    return found | _tested(x, y, metric, decisions)


NUMBERS = ("mean", "lower", "upper", "p", "p_sign_flip")


def _tested(x, y, metric, decisions):
    options = {"confidence": decisions["confidence"], "better": better_of(metric, decisions)}
    test = compare_paired(x, y, **options)
    found = {"mean": test.mean, "lower": test.lower, "upper": test.upper, "p": test.p_value}
    if len(x) <= EXACT_UP_TO:
        found["p_sign_flip"] = compare_sign_flip(x, y, **options).p_value
    if test.p_value == test.p_value:
        return found
    if not test.mean:
        return found | {"lower": 0.0, "upper": 0.0, "p": 1.0, "why": "all differences are 0"}
    if "p_sign_flip" in found:
        why = "all differences are equal: p is that of the sign-flip test"
        return found | {"p": found["p_sign_flip"], "why": why}
    return found | {"why": "all differences are equal: there is no spread to judge by"}


def _why_no_pair(done, failed, a, b, metric):
    if not done:
        return "no trial that both have run"
    for name, which in ((a, 0), (b, 1)):
        ok = [pair[which] for pair in done if pair[which][0]["status"] == "ok"]
        if not ok:
            return f"every trial of {name} failed"
        if all(value != value for _, value in ok):
            why = next(iter(reason_for(metric, ok[0][0]["skipped"])), "there is no value")
            return f"{name}: {why}"
    if all(x or y for x, y in failed):
        return "in every trial one of the two failed"
    return "no trial in which both have a value"


def _judged(rows, better, rule, confidence):
    """Return the rows with p-values after Holm in either family, and the verdicts."""
    for row in rows:
        row |= {"p_holm": float("nan"), "verdict": "undecided"}
    for family in (PRIMARY, SECONDARY):
        tested = _tested_in(rows, family)
        adjusted = holm([row["p"] for row in tested]).tolist() if tested else []
        for row, p in zip(tested, adjusted, strict=True):
            row["p_holm"] = p
    for row in rows:
        if row["p_holm"] <= 1 - confidence and row["mean"]:
            row["verdict"] = _winner(row, better, rule)
            if row["p_sign_flip"] > 1 - confidence:
                row["why"] = "rests on normal differences: the exact test does not show it"
    return rows


def _tested_in(rows, family):
    return [row for row in rows if row["family"] == family and row["p"] == row["p"]]


def _counted(rows, family):
    return len(_tested_in(rows, family))


def _winner(row, better, rule):
    a_wins = (row["mean"] < 0) == (better == "lower")
    more = row["failed_a"] - row["failed_b"]
    if rule == "separate" and more and (more > 0) == a_wins:
        return "conflicting"
    return f"{row['a'] if a_wins else row['b']} better"
