"""The figures of a report: what is drawn, and the text that says what is seen (lecture 10).

A figure is a function that draws on an empty `matplotlib.figure.Figure`; Matplotlib is not
needed before it is called. In all of them a system has one color, line and marker.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from amrmetrics.benchmark.measuring import INSTANTS, PER_DECADE, RECALLS, columns
from amrmetrics.report_page import with_matplotlib

# Panels of one figure, and inches.
PANELS, ACROSS = 6, 2
WIDTH, ROW, SQUARE, TALLEST = 8.6, 2.7, 3.7, 11
# A horizontal axis is logarithmic if the values differ by more than this factor.
FAR_APART = 30
PERCENT = 100 * np.arange(1, INSTANTS + 1) / INSTANTS


@dataclass(frozen=True)
class Picture:
    """A figure that can be drawn, and its text.

    Attributes
    ----------
    draw : callable
        Called with an empty figure.
    size : (float, float)
        Inches.
    alt : str
        What is seen, with numbers.
    """

    draw: Callable
    size: tuple
    alt: str


def _panels(evaluation, scenarios, one, height, alt, said):
    """Yield pictures of a panel for each scenario, several in each picture.

    `one(ax, scenario, look)` draws a panel, `said(scenario)` says what is seen in it.
    """
    for start in range(0, len(scenarios), PANELS):
        part = scenarios[start : start + PANELS]
        across = min(ACROSS, len(part))
        rows = -(-len(part) // across)
        text = f"{alt} {' '.join(f'{name}: {said(name)}.' for name in part)}"
        size = (WIDTH, 0.6 + rows * height)
        yield Picture(_draw_panels(evaluation.systems, part, (rows, across), one), size, text)


def _draw_panels(systems, scenarios, shape, one):
    def draw(figure):
        look = with_matplotlib().looks(systems)
        axes = figure.subplots(*shape, squeeze=False).ravel()
        for ax, scenario in zip(axes, scenarios, strict=False):
            one(ax, scenario, look)
            ax.set_title(scenario, fontsize=11)
        for ax in axes[len(scenarios) :]:
            ax.set_axis_off()
        _legend(figure, axes)

    return draw


def _legend(figure, axes):
    """Name each line once, above all panels."""
    found = {}
    for ax in np.ravel(axes):
        for handle, label in zip(*ax.get_legend_handles_labels(), strict=True):
            found.setdefault(label, handle)
    if found:
        place = {"loc": "outside upper center", "ncols": 4, "fontsize": 9, "handlelength": 3.5}
        figure.legend(found.values(), found.keys(), **place)


def _span(values, unit=""):
    """Say between which values systems lie, and which two are at the ends."""
    known = {name: x for name, x in values.items() if x == x}
    if not known:
        return "no system has a value"
    unit = f" {unit}" if unit else ""
    low, high = min(known, key=known.get), max(known, key=known.get)
    if f"{known[low]:.3g}" == f"{known[high]:.3g}":
        return f"{known[low]:.3g}{unit} ({', '.join(known)})"
    return f"from {known[low]:.3g}{unit} ({low}) to {known[high]:.3g}{unit} ({high})"


def overview(evaluation):
    """Yield the picture of the deciding number on each scenario."""
    yield from _of_metrics(evaluation, [evaluation.decisions["metric"]])


def maps(evaluation):
    """Yield the picture of map scores on each scenario."""
    names = [name for name in ("map_rmse", "map_chamfer") if _any(evaluation, name)]
    yield from _of_metrics(evaluation, names)


def _any(evaluation, metric):
    return any(row[metric] is not None for row in evaluation.rows)


def _of_metrics(evaluation, metrics):
    known, scenarios = columns(evaluation.decisions), evaluation.scenarios
    tables = {}
    for metric in metrics:
        summary = evaluation.summary(metric)
        tables[metric] = {
            (where, system): (x.value, x.lower, x.upper)
            for (where, system), x in summary.items()
            if where is not None and x.value == x.value
        }
    tables = {metric: table for metric, table in tables.items() if table}
    if not tables:
        return

    def draw(figure):
        plotting = with_matplotlib()
        look = plotting.looks(evaluation.systems)
        axes = figure.subplots(1, len(tables), squeeze=False, sharey=True)[0]
        for ax, (metric, table) in zip(axes, tables.items(), strict=True):
            label = _named(metric, known[metric].unit)
            plotting.intervals(ax, scenarios, table, look, label, _far_apart(table))
        _legend(figure, axes)

    height = 0.9 + max(2.0, len(scenarios) * (0.3 + 0.11 * len(evaluation.systems)))
    height = min(height, TALLEST)
    yield Picture(draw, (WIDTH, height), _said_of_metrics(evaluation, tables, known))


def _said_of_metrics(evaluation, tables, known):
    d = evaluation.decisions
    texts = []
    for metric, table in tables.items():
        spans = [
            f"{where}: {_span({s: x for (w, s), (x, _, _) in table.items() if w == where}, unit)}"
            for where in evaluation.scenarios
            for unit in [known[metric].unit]
        ]
        texts.append(f"{d['statistic'].capitalize()} of {metric}, {'; '.join(spans)}.")
    return (
        f"Numbers with {100 * d['confidence']:g} % intervals, a row for each scenario and a marker "
        "for each system. " + " ".join(texts)
    )


def _named(metric, unit):
    return f"{metric} [{unit}]" if unit else metric


def _far_apart(table):
    values = [x for x, _, _ in table.values()]
    return min(values) > 0 and max(values) > FAR_APART * min(values)


def trajectories(evaluation):
    """Yield the paths of one seed of each scenario, all systems over each other."""
    traces = evaluation.traces
    scenarios = [name for name in evaluation.scenarios if name in traces]

    def one(ax, scenario, look):
        trace = traces[scenario]
        paths = {name: x["path"] for name, x in trace["systems"].items()}
        with_matplotlib().plans(ax, trace["truth"], paths, look)

    def said(scenario):
        trace = traces[scenario]
        found = _span({name: x["ate"] for name, x in trace["systems"].items()}, "m")
        lost = [name for name in evaluation.systems if name not in trace["systems"]]
        lost = f", no path of {', '.join(lost)}" if lost else ""
        return f"seed {trace['seed']}, ATE rmse {found}{lost}"

    align = evaluation.decisions["align"]
    alt = (
        "Paths from above, the truth as a wide gray line, estimates "
        f"{f'after {align} alignment' if align != 'none' else 'not aligned'}, one panel for each "
        "scenario at its first seed, which was not chosen by what it shows."
    )
    yield from _panels(evaluation, scenarios, one, SQUARE, alt, said)


def _profiles(evaluation, name):
    """Return for each scenario the series of this name by system."""
    found = {}
    for scenario in evaluation.scenarios:
        systems = evaluation.profiles.get(scenario, {})
        series = {s: np.asarray(p[name]) for s, p in systems.items() if name in p}
        series = {s: x for s, x in series.items() if not np.isnan(x).all()}
        if series:
            found[scenario] = series
    return found


def errors(evaluation):
    """Yield the error over time, the median of the seeds."""
    found = _profiles(evaluation, "error")

    def one(ax, scenario, look):
        values = {s: np.where(x > 0, x, np.nan) for s, x in found[scenario].items()}
        labels = ("time [% of the run]", "ATE [m]")
        with_matplotlib().series(ax, PERCENT, values, look, *labels, log=True)

    alt = (
        "ATE over time, the median over the seeds at fifty instants of the run, logarithmic; all "
        "trials that handed in an estimate. At the end of the run,"
    )
    end = {scenario: {s: x[-1] for s, x in series.items()} for scenario, series in found.items()}
    yield from _panels(evaluation, list(found), one, ROW, alt, lambda name: _span(end[name], "m"))


def consistency(evaluation, kind):
    """Yield NEES or NIS over time, the mean over the seeds, with the band of their mean."""
    name = kind.lower()
    found = _profiles(evaluation, name)
    confidence = evaluation.decisions["confidence"]

    def one(ax, scenario, look):
        plotting = with_matplotlib()
        limits = _band(evaluation.profiles[scenario], found[scenario], name, confidence)
        if limits is not None:
            plotting.band(ax, PERCENT, *limits, confidence)
        labels = ("time [% of the run]", kind)
        plotting.series(ax, PERCENT, found[scenario], look, *labels, log=True)

    def said(scenario):
        limits = _band(evaluation.profiles[scenario], found[scenario], name, confidence)
        middle = _span({s: float(np.nanmedian(x)) for s, x in found[scenario].items()})
        if limits is None:
            return f"over the run in the median {middle}"
        lower, upper, expected = limits
        low, high = np.nanmedian(lower), np.nanmedian(upper)
        return f"in the median {middle}, expected {expected:g}, band {low:.3g} to {high:.3g}"

    what = {
        "NEES": "NEES over time, the mean of the seeds at each of fifty instants",
        "NIS": "NIS over time, the mean of all innovations in each fiftieth of the runs",
    }
    alt = (
        f"{what[kind]}, with the {100 * confidence:g} % band of the system with the fewest values; "
        "each instant for itself. Over the run,"
    )
    yield from _panels(evaluation, list(found), one, ROW, alt, said)


def _band(profiles, shown, name, confidence):
    """Return lower and upper limits and the dof, None if systems have different ones."""
    from scipy.stats import chi2

    dofs = {profiles[system][f"{name}_dof"] for system in shown}
    if len(dofs) > 1 or None in dofs:
        return None
    dof = dofs.pop()
    counts = np.array([profiles[system][f"{name}_n"] for system in shown], float)
    n = np.where(counts > 0, counts, np.inf).min(axis=0)
    n = np.where(np.isfinite(n), n, np.nan)
    lower, upper = (chi2.ppf(x, n * dof) / n for x in ((1 - confidence) / 2, (1 + confidence) / 2))
    return lower, upper, dof


def closures(evaluation):
    """Yield precision over recall of loop closures, the mean over the seeds."""
    found = _profiles(evaluation, "precision")
    points = {}
    for scenario, systems in evaluation.profiles.items():
        for system, profile in systems.items():
            if "closure_precision" in profile and "closure_recall" in profile:
                point = profile["closure_recall"], profile["closure_precision"]
                points.setdefault(scenario, {})[system] = point
    scenarios = [name for name in evaluation.scenarios if name in found or name in points]

    def one(ax, scenario, look):
        curves, accepted = found.get(scenario, {}), points.get(scenario, {})
        with_matplotlib().closure_curves(ax, RECALLS, curves, accepted, look)

    def said(scenario):
        areas = {s: float(np.mean(x)) for s, x in found.get(scenario, {}).items()}
        accepted = {s: x[1] for s, x in points.get(scenario, {}).items()}
        text = f"mean precision {_span(areas)}" if areas else "no scores"
        return f"{text}; precision of the accepted {_span(accepted)}" if accepted else text

    alt = (
        "Precision over recall of loop closures, at each recall the mean over the seeds; open "
        "markers are what the systems accepted."
    )
    yield from _panels(evaluation, scenarios, one, ROW + 0.4, alt, said)


def latency(evaluation):
    """Yield which part of the frames takes longer than a time."""
    tails = {name: _tail(counts) for name, counts in evaluation.frames.items()}
    if not tails:
        return

    def draw(figure):
        plotting = with_matplotlib()
        ax = figure.subplots()
        plotting.latency_tails(ax, tails, plotting.looks(evaluation.systems))
        _legend(figure, ax)

    texts = [
        f"{name}: P95 {_reached(tail, 0.05):.3g} ms, P99 {_reached(tail, 0.01):.3g} ms"
        for name, tail in tails.items()
    ]
    alt = (
        "Part of the frames that takes longer than a time, the frames of all trials of a system "
        "together, also of those that broke a rule, where tables show many trials, each with its "
        f"own P95 and P99; both axes logarithmic, to 1.2 %. {'; '.join(texts)}. Times are "
        "measured and differ from run to run."
    )
    yield Picture(draw, (WIDTH, 4.2), alt)


def _tail(counts):
    """Return times in ms and the part of the frames above them, from frames by classes."""
    kinds, numbers = np.array(counts, float).T
    part = 1 - np.cumsum(numbers) / numbers.sum()
    return 1e3 * 10 ** (kinds / PER_DECADE), np.maximum(part, 0)


def _reached(tail, part):
    """Return the shortest time above which at most this part lies."""
    ms, above = tail
    return ms[int(np.argmax(above <= part + 1e-12))]
