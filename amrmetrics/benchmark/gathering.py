"""Series of single trials to series over the seeds, and the verdicts on NEES and NIS.

Errors at successive instants of one run are correlated, so that a run is one trial and not as
many as it has instants (erratum E8). What is tested are NEES of different seeds at one instant.
"""

from __future__ import annotations

import numpy as np

from amrmetrics.benchmark.measuring import INSTANTS, TESTED
from amrmetrics.comparison import holm
from amrmetrics.consistency import consistency_test


def gather(found, decisions):
    """Return profiles, traces, times of frames and the verdicts on consistency.

    Parameters
    ----------
    found : list of Measured
        Of the test scenarios.
    decisions : dict
        The fields of a `Protocol`.
    """
    groups, traces, frames = {}, {}, {}
    for one in found:
        row = one.row
        groups.setdefault((row["scenario"], row["system"]), []).append(one)
        _add_trace(traces, one)
        if "frames" in one.series:
            counts = frames.setdefault(row["system"], {})
            for kind, count in one.series["frames"].T.tolist():
                counts[kind] = counts.get(kind, 0) + count
    profiles, tests = {}, []
    for (scenario, system), group in groups.items():
        profile = _profile(group)
        if profile:
            profiles.setdefault(scenario, {})[system] = profile
        tests += _tests(scenario, system, group, decisions["confidence"])
    frames = {name: sorted(map(list, counts.items())) for name, counts in frames.items()}
    return profiles, traces, frames, _with_verdicts(tests, decisions["confidence"])


def _add_trace(traces, one):
    row = one.row
    if not one.trace:
        return
    trace = traces.setdefault(row["scenario"], {"seed": row["seed"], "systems": {}})
    trace.setdefault("truth", one.trace["truth"])
    if "estimate" in one.trace:
        trace["systems"][row["system"]] = {
            "path": one.trace["estimate"],
            "status": row["status"],
            "ate": one.trace["ate"],
        }


def _profile(group):
    """Return the series over the seeds of one system on one scenario."""
    profile = {}
    errors = _stacked(group, "error")
    if errors is not None:
        profile["error"] = _at_each(np.median, errors)
        profile["error_n"] = (~np.isnan(errors)).sum(axis=0)
    values = _stacked(group, "nees")
    if values is not None:
        profile["nees"] = _at_each(np.mean, values)
        profile["nees_n"] = (~np.isnan(values)).sum(axis=0)
        profile["nees_dof"] = _dof(group, "nees_dof")
    sums, counts = _stacked(group, "nis_sum"), _stacked(group, "nis_count")
    if sums is not None:
        count = counts.sum(axis=0)
        total = np.full(INSTANTS, np.nan)
        profile["nis"] = np.divide(sums.sum(axis=0), count, out=total, where=count > 0)
        profile["nis_n"] = count.astype(int)
        profile["nis_dof"] = _dof(group, "nis_dof")
    precision = _stacked(group, "precision")
    if precision is not None:
        profile["precision"] = precision.mean(axis=0)
        profile["precision_n"] = len(precision)
    for name in ("closure_precision", "closure_recall"):
        seen = [one.row[name] for one in group if one.row[name] is not None]
        if seen:
            profile[name] = float(np.mean(seen))
    return profile


def _stacked(group, name):
    found = [one.series[name] for one in group if name in one.series]
    return np.array(found) if found else None


def _at_each(statistic, values):
    """Return a statistic over the rows that have a value, nan where none has."""
    found = np.full(values.shape[1], np.nan)
    for k, column in enumerate(values.T):
        seen = column[~np.isnan(column)]
        if len(seen):
            found[k] = statistic(seen)
    return found


def _dof(group, name):
    found = {one.dof[name] for one in group if name in one.dof}
    return found.pop() if len(found) == 1 else None


def _tests(scenario, system, group, confidence):
    """Return the tests of NEES and of NIS of one system on one scenario, without verdicts."""
    who = {"scenario": scenario, "system": system}
    found = []
    values = _stacked(group, "nees")
    if values is not None:
        runs = [one.row["anees"] for one in group if one.row["anees"] is not None]
        test = _nees_over_seeds(values, _dof(group, "nees_dof"), confidence)
        run = {"run_average": float(np.mean(runs)) if runs else None}
        found.append(who | {"kind": "NEES"} | test | run)
    totals = _stacked(group, "nis_total")
    if totals is not None:
        found.append(who | {"kind": "NIS"} | _nis(totals, _dof(group, "nis_dof"), confidence))
    return found


def _nees_over_seeds(values, dof, confidence):
    """Test the NEES of the seeds at fixed parts of the run."""
    parts = np.arange(1, INSTANTS + 1)[TESTED] / INSTANTS
    seen = [column[~np.isnan(column)] for column in values[:, TESTED].T]
    used = [(part, x) for part, x in zip(parts.tolist(), seen, strict=True) if len(x)]
    if dof is None:
        return {"why": "covariances of different sizes", "p": []}
    if not used:
        return {"why": "no estimate at the tested instants", "p": []}
    # One value of each run: nothing follows anything in time.
    tests = [consistency_test(x[:, None], dof, confidence) for _, x in used]
    return {
        "why": "",
        "dof": dof,
        "at": [part for part, _ in used],
        "mean": [test.mean for test in tests],
        "lower": [test.lower for test in tests],
        "upper": [test.upper for test in tests],
        "n": [test.n for test in tests],
        "p": [test.p_value for test in tests],
    }


def _nis(totals, dof, confidence):
    """Test all innovations together: those of a consistent filter do not depend on each other.

    Where they do, they count as fewer.
    """
    from scipy.stats import chi2

    if dof is None:
        return {"why": "innovations of different sizes", "p": []}
    total, n, worth = totals.sum(axis=0)
    mean, tail = total / n, (1 - confidence) / 2
    lower, upper = chi2.ppf([tail, 1 - tail], worth * dof) / worth
    p = 2 * min(chi2.cdf(worth * mean, worth * dof), chi2.sf(worth * mean, worth * dof))
    return {
        "why": "",
        "dof": dof,
        "mean": [float(mean)],
        "lower": [float(lower)],
        "upper": [float(upper)],
        "n": [int(n)],
        "n_effective": float(worth),
        "p": [float(min(1, p))],
    }


def _with_verdicts(tests, confidence):
    """Return the tests with verdicts that hold together: Holm over all that are shown."""
    p = [x for test in tests for x in test["p"]]
    adjusted = iter(holm(p).tolist() if p else ())
    found = []
    for test in tests:
        after = [next(adjusted) for _ in test["p"]]
        said = {
            "overconfident" if mean > test["dof"] else "underconfident"
            for mean, x in zip(test.get("mean", ()), after, strict=True)
            if x <= 1 - confidence
        }
        verdict = " and ".join(sorted(said)) or ("" if test["why"] else "consistent")
        found.append(test | {"p_holm": after, "tests": len(p), "verdict": verdict})
    return tuple(found)
