"""Read one number per run, with runs that failed, for `comparison` and `aggregation`.

A failed run is written nan. It is never dropped: the caller says by which rule it counts.
"""

from dataclasses import dataclass

import numpy as np

from amrmetrics._arguments import as_reals, as_size
from amrmetrics.errors import AmrError

# Differences that agree to this many units in the last place are equal but for rounding.
SAME_WITHIN = 8

RULES = {
    "worst": "a failed run gets the worst value",
    "censored": "a failed run is worse than every other, by an unknown amount",
    "separate": "failed runs are counted beside the others",
}


@dataclass(frozen=True, eq=False)
class Pairs:
    """Differences A - B of paired runs, with failed runs treated by a rule.

    Attributes
    ----------
    differences : (n,) array
        What the rule leaves; censored ones are infinite, and 0 if both runs failed.
    scale : float
        Largest finite value, for rounding.
    unit : str
        Of the differences.
    sign : int
        1 if a positive difference speaks for B, -1 if for A.
    fields : dict
        What a result says about runs that failed.
    """

    differences: np.ndarray
    scale: float
    unit: str
    sign: int
    fields: dict


def as_runs(value, name, unit=None):
    """Return one double per run, nan where it failed, and the unit ("" if nobody says it).

    Results that stand for a number, such as ErrorSummary, bring their unit along.
    """
    if not isinstance(value, np.ndarray):
        items = list(value) if np.iterable(value) and not isinstance(value, str) else value
        found = {x.unit for x in items if hasattr(x, "unit")} if isinstance(items, list) else set()
        if found:
            if len(found | ({unit} - {None})) > 1:
                units = ", ".join(sorted(found | ({unit} - {None})))
                raise AmrError(f"{name} holds values of the units {units}; compare one unit only.")
            unit, value = found.pop(), [float(x) for x in items]
    runs = as_reals(value, name)
    if runs.ndim != 1 or not len(runs):
        raise AmrError(f"{name} has shape {runs.shape}; expected (N,), one number per run, N >= 1.")
    if np.isinf(runs).any():
        k = int(np.argmax(np.isinf(runs)))
        raise AmrError(f"{name}[{k}] is {runs[k]}; write a run that failed as nan.")
    return runs, unit or ""


def as_sign(better):
    """Return 1 if lower values are better, -1 if higher ones are."""
    if better not in ("lower", "higher"):
        raise AmrError(f"better is {better!r}; expected 'lower' or 'higher'.")
    return 1 if better == "lower" else -1


def check_rule(failures, worst, failed, name, allowed=tuple(RULES)):
    """Refuse a rule that does not exist here, and failed runs without one."""
    if failures is not None and failures not in allowed:
        why = ""
        if failures in RULES:
            why = " Runs without a value have no mean; compare_sign_flip takes them."
        raise AmrError(f"failures is {failures!r}; expected one of {', '.join(allowed)}.{why}")
    if worst is not None and failures != "worst":
        raise AmrError("worst is given, but failures is not 'worst': nothing would use it.")
    if failures is None and failed.any():
        rules = "; ".join(f"failures={rule!r}: {RULES[rule]}" for rule in allowed)
        raise AmrError(
            f"{name}[{int(np.argmax(failed))}] is nan, a run that failed ({int(failed.sum())} in "
            f"all). Say how it counts: {rules}."
        )


def worst_value(values, worst, sign):
    """Return what a failed run gets: `worst`, or the worst of the other runs."""
    seen = values[~np.isnan(values)]
    if worst is None:
        if not len(seen):
            raise AmrError("every run failed, so no worst value was seen; state one by worst=...")
        return float(sign * (sign * seen).max())
    number = float(as_size(worst, "worst", sign=""))
    if len(seen) and sign * number < (sign * seen).max():
        raise AmrError(
            f"worst is {number:g}, but a run that did not fail has "
            f"{sign * (sign * seen).max():g}; a failed run cannot be better than that."
        )
    return number


def as_pairs(a, b, failures, worst, better, unit, allowed=("worst", "separate")):
    """Return the differences of paired runs, at least two of them, and how failures counted."""
    sign = as_sign(better)
    a, unit = as_runs(a, "a", unit)
    b, unit = as_runs(b, "b", unit or None)
    if len(a) != len(b):
        raise AmrError(
            f"a has {len(a)} runs and b has {len(b)}; run k of one must be paired with run k of "
            "the other: the same scenario and seed. Write a run that failed as nan."
        )
    if len(a) < 2:
        raise AmrError(
            "a and b hold a single run, which shows no spread; repeat it with other seeds. "
            "amrmetrics.comparison.runs_needed says how often."
        )
    lost_a, lost_b = np.isnan(a), np.isnan(b)
    for name, lost in (("a", lost_a), ("b", lost_b)):
        check_rule(failures, worst, lost, name, allowed)
    scale = max(_largest(a), _largest(b))
    fields = {
        "failures": failures or "none failed",
        "failed_a": int(lost_a.sum()),
        "failed_b": int(lost_b.sum()),
        "failed_both": int((lost_a & lost_b).sum()),
        "failure_value": float("nan"),
    }
    if failures == "worst" and (lost_a | lost_b).any():
        value = worst_value(np.r_[a, b], worst, sign)
        fields["failure_value"] = value
        a, b = np.where(lost_a, value, a), np.where(lost_b, value, b)
    differences = a - b
    differences[np.abs(differences) <= rounding(scale)] = 0  # ties: 0.1 + 0.2 and 0.3
    if failures == "separate":
        differences = differences[~(lost_a | lost_b)]
    elif failures == "censored":
        differences[lost_a] = sign * np.inf
        differences[lost_b] = -sign * np.inf
        differences[lost_a & lost_b] = 0
    return Pairs(differences, scale, unit, sign, fields)


def rounding(scale):
    """Return what a difference of two numbers of this size may be off by."""
    return SAME_WITHIN * np.finfo(float).eps * scale


def _largest(values):
    return float(np.abs(values[~np.isnan(values)]).max(initial=0))
