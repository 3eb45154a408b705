"""A benchmark as one page that somebody else can check, and the same as Markdown (lecture 10).

The page works offline; its figures are inside, and its links go to the raw logs beside it. What
both show is a list of parts, each of which knows how it is written in either.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import quote

from amrmetrics.benchmark import picturing
from amrmetrics.benchmark.comparing import ALL, compare
from amrmetrics.benchmark.data import Protocol
from amrmetrics.benchmark.evaluating import Evaluation, evaluate
from amrmetrics.benchmark.logs import PROTOCOL, put_file, trial_path
from amrmetrics.benchmark.measuring import columns
from amrmetrics.errors import AmrError
from amrmetrics.report_page import document, image, note, picture

if TYPE_CHECKING:
    from amrmetrics._types import Path as PathLike

STYLE = """
body { max-width: 74rem; } p, figcaption { max-width: 60rem; }
table.dense { min-width: 36rem; }
table.dense { font-size: .85rem; } table.dense td { white-space: nowrap; }
table.dense th { font-weight: 600; } td.text { white-space: normal !important; min-width: 14em; }
p.caption { font-size: .9rem; margin: 1.2rem 0 .2rem; }
nav ul { columns: 2; padding-left: 1.2rem; }
a { color: inherit; }
@page { margin: 1.2cm; }
@media print { table.dense { font-size: 7pt; } .wide { overflow: visible; } nav { display: none; }
  table.dense td { white-space: normal; } table.dense { overflow-wrap: normal; }
  thead { display: table-header-group; }
  table.dense th, table.dense td { padding-right: .4rem; } td.text { min-width: 9em; }
  img { max-height: 19cm; } p.caption { break-after: avoid; } }
"""

# Decisions of the protocol in words.
IN_WORDS = {
    "metric": "the number that decides",
    "better": "which values of it are good",
    "statistic": "what a table shows of many trials",
    "failures": "how a failed trial counts",
    "confidence": "confidence of each interval, and of all verdicts together",
    "align": "alignment of the ATE",
    "max_difference": "seconds between matched stamps, at most",
    "deltas": "stretches of the RPE",
    "minimum_coverage": "part of the truth that a trial must cover",
    "maximum_ate": "ATE rmse in meters above which a trial failed",
    "time_limit": "seconds of wall clock that a trial may take",
    "memory_limit": "gigabytes that a trial may take",
    "calibration": "where the calibration came from",
    "synchronization": "how clocks were brought together",
}
# Seeds listed in a row before the rest is left to protocol.json.
SEEDS_SHOWN = 40


class Paths(NamedTuple):
    """Where a report was written."""

    html: Path
    markdown: Path


@dataclass(frozen=True)
class Heading:
    """A heading of level 2 or 3."""

    text: str
    level: int = 2

    def html(self, _base):
        anchor = f" id='{_anchor(self.text)}'" if self.level == 2 else ""
        return f"<h{self.level}{anchor}>{escape(self.text)}</h{self.level}>"

    def markdown(self, _base):
        return f"{'#' * self.level} {_plain(self.text)}"


@dataclass(frozen=True)
class Text:
    """A paragraph."""

    text: str

    def html(self, _base):
        return f"<p>{escape(self.text)}</p>"

    def markdown(self, _base):
        return _plain(self.text)


@dataclass(frozen=True)
class Notes:
    """Sentences in a box."""

    texts: tuple

    def html(self, _base):
        return note(self.texts)

    def markdown(self, _base):
        return "\n".join(f"> - {_plain(text)}" for text in self.texts)


@dataclass(frozen=True)
class Link:
    """A text that leads to a file beside the report."""

    text: str
    path: Path

    def target(self, base):
        try:
            return quote(Path(os.path.relpath(self.path, base)).as_posix())
        except ValueError:  # another drive
            return Path(self.path).resolve().as_uri()


@dataclass(frozen=True)
class Table:
    """A table whose cells are texts or lists of texts and links."""

    head: tuple
    rows: tuple
    caption: str = ""

    def html(self, base):
        caption = f"<p class='caption'>{escape(self.caption)}</p>" if self.caption else ""
        label = escape(self.caption or ", ".join(self.head), quote=True)
        head = "".join(f"<th scope='col'>{escape(name)}</th>" for name in self.head)
        body = "".join(self._row(row, base) for row in self.rows)
        return (
            f"{caption}<div class='wide'><table class='dense' aria-label=\"{label}\"><thead><tr>"
            f"{head}</tr></thead><tbody>{body}</tbody></table></div>"
        )

    def _row(self, row, base):
        first, *rest = (_cell_html(cell, base) for cell in row)
        cells = "".join(
            f"<td{self._kind(cell)}>{text}</td>" for cell, text in zip(row[1:], rest, strict=True)
        )
        return f"<tr><th scope='row'>{first}</th>{cells}</tr>"

    def _kind(self, cell):
        longest = max(map(len, cell.split("\n"))) if isinstance(cell, str) else LONG
        return " class='text'" if longest >= LONG else ""

    def markdown(self, base):
        lines = [_markdown_row(self.head, base), "|" + " --- |" * len(self.head)]
        lines += [_markdown_row(row, base) for row in self.rows]
        caption = [f"{_plain(self.caption)}\n"] if self.caption else []
        return "\n".join([*caption, *lines])


@dataclass(frozen=True)
class Figure:
    """A picture; in Markdown its text alone."""

    picture: picturing.Picture

    def html(self, _base):
        return image(picture(self.picture.draw, self.picture.size), self.picture.alt)

    def markdown(self, _base):
        return f"*Figure (in the HTML page): {_plain(self.picture.alt)}*"


def _cell_html(cell, base):
    if isinstance(cell, list):
        return " ".join(_cell_html(part, base) for part in cell)
    if isinstance(cell, Link):
        return f"<a href='{escape(cell.target(base), quote=True)}'>{escape(cell.text)}</a>"
    return escape(cell).replace("\n", "<br>")


# Longer texts are wrapped.
LONG = 50


def _markdown_row(row, base):
    return "| " + " | ".join(_cell_markdown(cell, base) for cell in row) + " |"


def _cell_markdown(cell, base):
    if isinstance(cell, list):
        return " ".join(_cell_markdown(part, base) for part in cell)
    if isinstance(cell, Link):
        return f"[{_plain(cell.text)}]({cell.target(base)})"
    return "<br>".join(map(_plain, cell.split("\n")))


def _plain(text):
    """Return a text in which Markdown finds nothing to do."""
    return re.sub(r"([\\`*_\[\]<>|])", r"\\\1", " ".join(text.split()))


def _anchor(text):
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


def report(
    folder: PathLike | Evaluation,
    html: PathLike | None = None,
    markdown: PathLike | None = None,
    *,
    systems: Iterable[str] | None = None,
    scenarios: Iterable[str] | None = None,
    seeds: Iterable[int] | None = None,
    protocol: Protocol | Mapping[str, Any] | None = None,
    jobs: int | None = None,
) -> Paths:
    """Write a benchmark as one HTML page that works offline, and as Markdown.

    Parameters
    ----------
    folder : str, Path or Evaluation
        A benchmark's folder, which is evaluated first, or what `evaluate` returned.
    html, markdown : str or Path, optional
        Where to; ``report.html`` and ``report.md`` in the benchmark's folder by default.
    systems, scenarios, seeds, protocol, jobs
        As in `evaluate`; not for an Evaluation, which has made its choice. A report over a
        selection, or under other decisions, says so in its title.

    Returns
    -------
    Paths
        `html` and `markdown`.

    Raises
    ------
    AmrError
        As `evaluate`, and if Matplotlib is not installed.
    OSError
        If a file cannot be written.

    References
    ----------
    Lecture 10.

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
    ...     for name, noise in (("orb", 0.02), ("vins", 0.04)) for seed in range(3)
    ... ]
    >>> folder = tempfile.mkdtemp()
    >>> _ = am.benchmark.adopt(table, folder)
    >>> am.benchmark.report(folder).html.name
    'report.html'
    """
    choice: dict[str, Any] = {
        "systems": systems,
        "scenarios": scenarios,
        "seeds": seeds,
        "protocol": protocol,
    }
    if isinstance(folder, Evaluation):
        _refuse_choice(choice)
        evaluation = folder
    else:
        evaluation = evaluate(folder, **choice, jobs=jobs)
    if not evaluation.folder and not (html and markdown):
        raise AmrError(
            "this Evaluation was read from a file: say where to write by html, markdown."
        )
    where = Path(evaluation.folder)
    paths = Paths(Path(html or where / "report.html"), Path(markdown or where / "report.md"))
    parts = _parts(evaluation)
    page = [part.html(paths.html.parent) for part in parts]
    page.insert(1, _contents(parts))
    text = "\n\n".join(part.markdown(paths.markdown.parent) for part in parts)
    put_file(paths.html, document(evaluation.title, page, STYLE).encode())
    put_file(paths.markdown, f"# {_plain(evaluation.title)}\n\n{text}\n".encode())
    return paths


def _refuse_choice(choice):
    given = [name for name, value in choice.items() if value is not None]
    if given:
        raise AmrError(
            f"{given[0]} is given, but this Evaluation has been made already. Give it to evaluate, "
            "or give report the folder."
        )


def _contents(parts):
    headings = [part.text for part in parts if isinstance(part, Heading) and part.level == 2]
    items = "".join(f"<li><a href='#{_anchor(x)}'>{escape(x)}</a></li>" for x in headings)
    return f"<nav aria-label='Contents'><ul>{items}</ul></nav>"


def _parts(evaluation):
    """Return all parts of a report, one after the other."""
    compared = None
    if len(dict.fromkeys(row["system"] for row in evaluation.rows)) > 1:
        compared = compare(evaluation)
    sections = (
        _limits(evaluation),
        _in_short(evaluation, compared),
        _protocol(evaluation),
        _results(evaluation),
        _verdicts(evaluation, compared),
        _pictures(evaluation, "Trajectories", picturing.trajectories, "ate"),
        _pictures(evaluation, "Error over time", picturing.errors, "ate"),
        _consistency(evaluation, "NEES"),
        _consistency(evaluation, "NIS"),
        _pictures(evaluation, "Map scores", picturing.maps, "map_rmse"),
        _pictures(evaluation, "Loop closures", picturing.closures, "closure_precision"),
        _pictures(evaluation, "Latency", picturing.latency, "latency_p95_ms"),
        _failures(evaluation),
        _by_scenario(evaluation),
        _all_tests(compared),
        _tuning(evaluation),
        _logs(evaluation),
        _conventions(evaluation),
    )
    return [part for section in sections for part in section]


def _limits(evaluation):
    texts = [f"{text}." for text in (*evaluation.limits, *evaluation.notes)]
    yield Notes(tuple(texts or ["All trials of the recorded protocol have run, and are here."]))


def _in_short(evaluation, compared):
    yield Heading("In short")
    yield Text(f"{evaluation.decides}.")
    rows = []
    for system, x in _ranked(evaluation):
        beaten = _beaten(evaluation, compared, system)
        rows.append((system, _value(x), _failed(x), _share(x), *beaten))
    d = evaluation.decisions
    x = f"{d['statistic']} of {_with_unit(d['metric'], evaluation)}"
    percent = f"{100 * d['confidence']:g} %"
    head = ("system", f"{x} [{percent} interval]", "failed", f"share failed [{percent}]")
    several = len(evaluation.scenarios) > 1
    head += ("beats on all scenarios together", "beats on single scenarios")[: 1 + several]
    yield Table(
        head,
        tuple(rows),
        f"All test scenarios together, the best first. {_spoken_of(evaluation)} Who beats whom "
        "are the pairwise verdicts after Holm's correction: over all scenarios, with the mean of "
        "a scenario as one number, which is primary, and on single scenarios, which is "
        "secondary.",
    )
    yield from map(Figure, picturing.overview(evaluation))


def _spoken_of(evaluation):
    if evaluation.decisions["statistic"] == "mean" and len(evaluation.scenarios) > 1:
        return "An interval takes the mean of each scenario as one number."
    return "Intervals speak of new seeds of these scenarios."


def _ranked(evaluation):
    """Return the systems and their summaries over all scenarios, the best first."""
    overall = {s: x for (where, s), x in evaluation.summary().items() if where is None}
    sign = 1 if evaluation.decisions["better"] == "lower" else -1

    def place(item):
        x = item[1]
        return (x.value != x.value, sign * x.value if x.value == x.value else 0)

    return sorted(overall.items(), key=place)


def _beaten(evaluation, compared, system):
    """Return in words whom a system beats on all scenarios together, and on single ones."""
    together, single = [], Counter()
    for row in compared.rows if compared else ():
        if row["verdict"] != f"{system} better":
            continue
        loser = row["b"] if row["a"] == system else row["a"]
        if row["scenario"] == ALL:
            alone = row["p_sign_flip"] > 1 - compared.confidence
            together.append(f"{loser} (by the t test alone)" if alone else loser)
        else:
            single[loser] += 1
    k = len(evaluation.scenarios)
    counts = ", ".join(f"{loser} on {count} of {k}" for loser, count in single.items())
    said = (", ".join(together) or "none shown", counts or "none shown")
    return said if k > 1 else said[:1]


def _value(x):
    if x.value != x.value:
        return f"– ({x.why})" if x.why else "–"
    if x.lower == x.upper or (x.lower != x.lower and x.upper != x.upper):
        return _number(x.value)
    return f"{_number(x.value)} [{_number(x.lower)}, {_number(x.upper)}]"


def _failed(x):
    return f"{x.failed} of {x.done}" + (f", {x.missing} missing" if x.missing else "")


def _share(x):
    if not x.done:
        return "–"
    share = x.failed / x.done
    return f"{share:.3g} [{x.failure_lower:.3g}, {x.failure_upper:.3g}]"


def _number(x):
    if x is None or x != x:
        return "–"
    return f"{x:.0f}" if 1e3 <= abs(x) < 1e9 else f"{x:.3g}"


def _with_unit(metric, evaluation):
    unit = columns(evaluation.decisions)[metric].unit
    return f"{metric} [{unit}]" if unit else metric


def _protocol(evaluation):
    recorded, applied = evaluation.recorded, evaluation.decisions
    yield Heading("Protocol")
    rows = [(words, _decision(evaluation, name)) for name, words in IN_WORDS.items()]
    rows.append(("seeds", _seeds(recorded.get("seeds", evaluation.seeds))))
    rows += [(f"recorded rule: {name}", text) for name, text in recorded.get("rules", {}).items()]
    for name in ("origin", "randomness", "threads", "digest"):
        if name in recorded:
            rows.append((name, str(recorded[name])))
    versions = recorded.get("versions", {})
    rows.append(("versions", ", ".join(f"{name} {x}" for name, x in versions.items())))
    yield Table(("decided before the first trial", "what"), tuple(rows))
    yield from _named(recorded.get("systems", ()), "Systems", ())
    yield from _named(recorded.get("scenarios", ()), "Scenarios", ("split",))
    if _has_logs(evaluation):
        whole = Link(PROTOCOL, Path(evaluation.folder, PROTOCOL))
        yield Table(("file", "what"), (([whole], "everything, as it was recorded"),))
    if applied["failures"] == "worst":
        yield Text(
            "A failed trial counts as the worst value that any system has on the same scenario (on "
            "any, if all trials of that one failed), in tables and in verdicts, for each number "
            "that says how good an estimate is. Of coverage, times and memory failed trials are "
            "counted beside the others. A system of which every trial failed has no number, and "
            "these worst values in verdicts."
        )


def _decision(evaluation, name):
    value = evaluation.decisions[name]
    value = value / 1e9 if name == "memory_limit" else value
    if name == "deltas":
        text = ", ".join(f"{delta:g} {unit}" for delta, unit in value) or "none"
    else:
        text = "none" if value is None else f"{value:g}" if isinstance(value, float) else str(value)
    if name in evaluation.departures:
        text += f" (DEPARTS: recorded {evaluation.departures[name][0]!r})"
    return text


def _seeds(seeds):
    shown = ", ".join(map(str, seeds[:SEEDS_SHOWN]))
    return shown + (f", ... ({len(seeds)} in all)" if len(seeds) > SEEDS_SHOWN else "")


def _named(items, what, more):
    rows = []
    for item in items:
        settings = ", ".join(f"{k} {v}" for k, v in item.get("settings", {}).items())
        code = item.get("code", "").replace(":", ":\n")
        if item.get("source"):
            code += f"\nsource {item['source'][:12]}"
        extra = tuple(str(item.get(name, "")) for name in more)
        rows.append((item["name"], *extra, item.get("description", ""), settings, code))
    if rows:
        head = ("name", *more, "what it is", "settings", "code")
        told = [k for k in range(len(head)) if any(row[k] for row in rows)]
        yield Heading(what, 3)
        yield Table(
            tuple(head[k] for k in told), tuple(tuple(row[k] for k in told) for row in rows)
        )


def _results(evaluation):
    d = evaluation.decisions
    yield Heading("Results")
    summary = evaluation.summary()
    rows = []
    several = len(evaluation.scenarios) > 1
    for where in (*evaluation.scenarios, *([None] if several else [])):
        cells = [summary.get((where, system)) for system in evaluation.systems]
        rows.append((where or ALL, *(_with_failures(x) for x in cells)))
    yield Table(
        ("scenario", *evaluation.systems),
        tuple(rows),
        f"{d['statistic'].capitalize()} of {_with_unit(d['metric'], evaluation)} with the "
        f"{100 * d['confidence']:g} % interval; failed trials of those that have run.",
    )
    yield from _every_number(evaluation, None, "All test scenarios together")


def _with_failures(x):
    if x is None:
        return "–"
    if not x.done:
        return "has not run"
    return f"{_value(x) if x.value == x.value else '–'}\n{x.failed} of {x.done} failed"


def _every_number(evaluation, scenario, title):
    """Yield the table of all metrics of all systems; those that nobody has are left out."""
    d, rows = evaluation.decisions, []
    counts = ["failed trials"]
    for system in evaluation.systems:
        x = evaluation.summary()[scenario, system] if _has(evaluation, scenario, system) else None
        counts.append(_failed(x) if x else "–")
    for metric in columns(d):
        summary = evaluation.summary(metric)
        cells = [summary.get((scenario, system)) for system in evaluation.systems]
        if any(x is not None and x.value == x.value for x in cells):
            texts = (_two_lines(x) for x in cells)
            rows.append((_with_unit(metric, evaluation), *texts))
    if not rows:
        yield Text(f"{title}: there are no numbers, no trial was finished.")
        return
    caption = (
        f"{title}: the {d['statistic']} over the trials of each number, with its "
        f"{100 * d['confidence']:g} % interval where there is one. – means that there is none; why "
        "stands under What is missing. What the names mean stands under How to read the numbers."
    )
    yield Table(("number", *evaluation.systems), (tuple(counts), *rows), caption)


def _two_lines(x):
    return "–" if x is None or x.value != x.value else _value(x).replace(" [", "\n[")


def _has(evaluation, scenario, system):
    return any(
        row["system"] == system and scenario in (None, row["scenario"]) for row in evaluation.rows
    )


def _verdicts(evaluation, compared):
    yield Heading("Who is better")
    if compared is None:
        yield Text("There is one system only: nothing to compare it with.")
        return
    overall = [row for row in compared.rows if row["scenario"] == ALL]
    d = evaluation.decisions
    yield Text(
        f"Differences of {_with_unit(d['metric'], evaluation)}, paired by scenario and seed. "
        "Verdicts are those of the t test after Holm's correction, by which all of a table hold "
        f"together at {100 * d['confidence']:g} %. Intervals hold each for itself, and so can "
        f"exclude 0 where the verdict is undecided.{_units(evaluation, compared)}"
    )
    yield _tests(overall, "Primary: all test scenarios together", compared)
    scenarios = [name for name in evaluation.scenarios if len(evaluation.scenarios) > 1]
    if not scenarios:
        return
    found = {(row["a"], row["b"], row["scenario"]): row["verdict"] for row in compared.rows}
    rows = tuple(
        (f"{row['a']} – {row['b']}", *(found[row["a"], row["b"], name] for name in scenarios))
        for row in overall
    )
    rows = tuple(tuple(cell.replace(" better", "\nbetter") for cell in row) for row in rows)
    yield Table(("pair", *scenarios), rows, "Secondary: verdicts on single scenarios")


def _units(evaluation, compared):
    """Say what counts as one number, where there are several scenarios."""
    k = len(evaluation.scenarios)
    if k < 2:
        return ""
    best = f", and {k} that all agree have an exact p-value of {2 / 2**k:.2g} at best"
    return (
        f" Primary is the question over all scenarios together ({_tests_of(compared.tests)}). "
        "There the mean of a scenario counts as one number, for seeds say nothing about other "
        f"scenarios{best if k <= 10 else ''}. Secondary are single scenarios "
        f"({_tests_of(compared.secondary_tests)}), on which each seed counts; they hold together "
        "among themselves."
    )


def _tests_of(count):
    return f"{count} test{'s' * (count != 1)}"


def _tests(rows, caption, compared, scenario=False):
    head = ("A", "B", "verdict", "mean of A – B [interval]", "p after Holm", "p of the t test")
    head += ("p of the exact sign-flip test", "n", "trials", "failed A", "failed B", "remark")
    head = ("scenario", *head) if scenario else head
    unit = f" [{compared.unit}]" if compared.unit else ""
    return Table(
        head,
        tuple(_test(row, scenario) for row in rows),
        f"{caption}: differences of {compared.metric}{unit}, {compared.better} is better.",
    )


def _test(row, scenario):
    mean = _number(row["mean"])
    if row["lower"] == row["lower"]:
        mean += f" [{_number(row['lower'])}, {_number(row['upper'])}]"
    remark = row["why"]
    if row["missing"]:
        remark = f"{remark}; {row['missing']} pairs missing".strip("; ")
    chances = (_chance(row[name]) for name in ("p_holm", "p", "p_sign_flip"))
    counts = (str(row[name]) for name in ("n", "trials", "failed_a", "failed_b"))
    cells = (row["a"], row["b"], row["verdict"], mean, *chances, *counts, remark)
    return (row["scenario"], *cells) if scenario else cells


def _chance(p):
    return "–" if p != p else "< 0.0001" if p < 1e-4 else f"{p:.3g}"


def _pictures(evaluation, title, draw, metric):
    """Yield a section of figures, or why there are none."""
    yield Heading(title)
    found = [Figure(picture) for picture in draw(evaluation)]
    yield from found
    why = _why_missing(evaluation, metric)
    if why:
        yield Text(("Not shown: " if found else f"No {title.lower()}: ") + "; ".join(why) + ".")
    elif not found:
        yield Text(f"No {title.lower()}: no trial was finished.")


def _why_missing(evaluation, metric):
    """Return for each reason which systems have no value anywhere."""
    reasons = {}
    for system in evaluation.systems:
        x = evaluation.summary(metric).get((None, system))
        has = any(row[metric] is not None for row in evaluation.rows if row["system"] == system)
        if x is not None and not has:
            reasons.setdefault(x.why or "no trial was finished", []).append(system)
    return [f"{', '.join(systems)} ({why})" for why, systems in reasons.items()]


WHAT_IS_TESTED = {
    "NEES": (
        "Errors at successive instants of one run depend on each other: a run is one trial, not as "
        "many as it has instants. Verdicts come from the NEES of different seeds at five fixed "
        "parts of the run, one independent value of each seed: of the nearest estimate, within a "
        "gap that does not count as lost; the average over a run describes, and is not tested. Of "
        "a trial that broke a rule of the protocol counts what it handed in. NEES is taken in the "
        "filter's own frame, without alignment. Consistent means that so many seeds show nothing "
        "else."
    ),
    "NIS": (
        "Innovations of a consistent filter do not depend on each other, and all of them are "
        "tested together; where they are correlated in time, they count as fewer, as many as "
        "stand under n worth. Of a trial that broke a rule of the protocol counts what it "
        "handed in."
    ),
}


def _consistency(evaluation, kind):
    yield Heading(f"Consistency: {kind}")
    found = [row for row in evaluation.consistency if row["kind"] == kind]
    metric = {"NEES": "anees", "NIS": "anis"}[kind]
    why = _why_missing(evaluation, metric)
    if not found:
        yield Text(f"No {kind}: {'; '.join(why) or 'no trial was finished'}.")
        return
    tests = sum(len(row["p"]) for row in evaluation.consistency)
    percent = f"{100 * evaluation.decisions['confidence']:g} %"
    yield Text(
        f"{WHAT_IS_TESTED[kind]} Verdicts hold together at {percent}, after Holm's correction for "
        f"the {tests} tests of NEES and NIS; bands in the figure hold each for itself."
    )
    yield from (Figure(x) for x in picturing.consistency(evaluation, kind))
    rows = tuple(_nees_row(row) if kind == "NEES" else _nis_row(row) for row in found)
    yield Table(("scenario", "system", "verdict", *TESTED_HEAD[kind]), rows, f"{kind}, {percent}")
    if why:
        yield Text(f"Not shown: {'; '.join(why)}.")


TESTED_HEAD = {
    "NEES": (
        "expected",
        "mean over the seeds at 20, 40, 60, 80, 100 % of the run",
        "band at the end",
        "seeds",
        "smallest p after Holm",
        "average over runs (described only)",
    ),
    "NIS": ("expected", "mean", "band", "n", "n worth", "p after Holm"),
}


def _nees_row(row):
    first = (row["scenario"], row["system"], row["verdict"] or f"none: {row['why']}")
    run = _number(row["run_average"])
    if not row["p"]:
        return (*first, "–", "–", "–", "–", "–", run)
    means = dict(zip([round(5 * x) for x in row["at"]], row["mean"], strict=True))
    return (
        *first,
        f"{row['dof']}",
        ", ".join(_number(means.get(k)) for k in range(1, 6)),
        f"{row['lower'][-1]:.3g} to {row['upper'][-1]:.3g}",
        _counts(row["n"]),
        _chance(min(row["p_holm"])),
        run,
    )


def _counts(n):
    return f"{min(n)} to {max(n)}" if min(n) < max(n) else f"{n[0]}"


def _nis_row(row):
    first = (row["scenario"], row["system"], row["verdict"] or f"none: {row['why']}")
    if not row["p"]:
        return (*first, "–", "–", "–", "–", "–", "–")
    return (
        *first,
        f"{row['dof']}",
        _number(row["mean"][0]),
        f"{row['lower'][0]:.3g} to {row['upper'][0]:.3g}",
        _number(row["n"][0]),
        _number(row["n_effective"]),
        _chance(row["p_holm"][0]),
    )


def _failures(evaluation):
    yield Heading("Failures")
    failed = evaluation.failures
    done = sum(row["status"] != "missing" for row in evaluation.rows)
    yield Text(f"{len(failed)} of {done} trials that have run failed.")
    if failed:
        rows = tuple(
            (row["scenario"], row["system"], [_trial_link(evaluation, row, str(row["seed"]))],
             row["kind"], row["reason"])
            for row in failed
        )  # fmt: skip
        head = ("scenario", "system", "seed and log", "kind", "reason")
        yield Table(head, rows)
    yield Heading("What is missing", 3)
    skipped = evaluation.skipped
    if not skipped:
        yield Text("Of the trials that were finished nothing is missing.")
        return
    rows = []
    for what, whys in skipped.items():
        for why, count in list(whys.items())[:5]:
            rows.append((what, why, f"{count}"))
        if len(whys) > 5:
            rest = sum(list(whys.values())[5:])
            rows.append((what, f"{len(whys) - 5} other reasons, in the table of trials", f"{rest}"))
    yield Table(("number", "why it is missing", "trials"), tuple(rows))


def _trial_link(evaluation, row, text):
    if not _has_logs(evaluation):
        return text
    path = trial_path(evaluation.folder, row["scenario"], row["system"], row["seed"])
    return Link(text, path / "trial.json")


def _has_logs(evaluation):
    return bool(evaluation.folder) and Path(evaluation.folder, PROTOCOL).exists()


def _by_scenario(evaluation):
    if len(evaluation.scenarios) < 2:
        return
    yield Heading("Every number by scenario")
    for scenario in evaluation.scenarios:
        yield Heading(scenario, 3)
        yield from _every_number(evaluation, scenario, scenario)


def _all_tests(compared):
    single = [row for row in compared.rows if row["scenario"] != ALL] if compared else []
    if single:
        yield Heading("Every pairwise test")
        yield _tests(single, "Secondary: each scenario for itself", compared, scenario=True)


def _tuning(evaluation):
    if not evaluation.tuning:
        return
    yield Heading("Tuning scenarios")
    yield Text(
        "Parameters were chosen on these. They are in no table, figure or verdict above, and are "
        "here to show that they were run."
    )
    groups = {}
    for row in evaluation.tuning:
        groups.setdefault((row["scenario"], row["system"]), []).append(row["status"])
    rows = tuple(
        (*key, f"{found.count('ok')}", f"{found.count('failed')}", f"{found.count('missing')}")
        for key, found in groups.items()
    )
    yield Table(("scenario", "system", "finished", "failed", "missing"), rows)


def _logs(evaluation):
    yield Heading("Raw logs")
    if not _has_logs(evaluation):
        yield Text("The raw logs are not here: this evaluation was read from a file.")
        return
    yield Text(
        "Each number leads to what was recorded of the trial with that seed; beside it stand its "
        "poses as text and all else that the system handed in."
    )
    rows, systems = {}, evaluation.systems
    for row in (*evaluation.rows, *evaluation.tuning):
        cells = rows.setdefault(row["scenario"], {name: [] for name in systems})
        text = str(row["seed"])
        if row["status"] == "missing":
            cells[row["system"]].append(f"{text} (missing)")
        else:
            mark = " (failed)" if row["status"] == "failed" else ""
            cells[row["system"]].append(_trial_link(evaluation, row, text + mark))
    table = tuple((name, *(cells[system] for system in systems)) for name, cells in rows.items())
    yield Table(("scenario", *systems), table)


def _conventions(evaluation):
    yield Heading("How to read the numbers")
    yield Text(
        "Truth comes first: an error is that of the estimate against the truth. A trial is one "
        "system on one scenario with one seed, and every table counts the trials that failed. "
        "Medians have the interval of order statistics, which assumes no distribution; means that "
        "of Student's t."
    )
    rows = tuple(
        (name, x.unit or "none", x.better or "neither", x.meaning)
        for name, x in columns(evaluation.decisions).items()
    )
    yield Table(("number", "unit", "better", "what it is"), rows)
