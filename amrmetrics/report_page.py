"""A report as one page that works offline: tables, figures with alt texts, conventions."""

from __future__ import annotations

import base64
import io
from html import escape
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics.errors import AmrError
from amrmetrics.trajectory import rpe

if TYPE_CHECKING:
    from amrmetrics.evaluation import Report, Reports

# Stretches of the last figure, and how many usual steps the shortest one has.
STRETCHES = 9
SHORTEST = 10

# Of more estimates, only the best are drawn: figures take time, and the page would be too long.
DRAWN = 10

# What every number of the page depends on, said once and beside the tables.
CONVENTIONS = (
    "Truth comes first: an error is that of the estimate against the reference. Lengths are in "
    "meters, angles in degrees, times in seconds.",
    "ATE: distance of each matched position after the alignment named in the table. RPE: error of "
    "the motion over a stretch; it needs no alignment. Drift rate: rmse of the ATE per meter of "
    "the reference's path. Segment drift: mean error over segments of 100 to 800 m, as KITTI "
    "reports it.",
    "rmse is the root of the mean square. Numbers hold for the matched samples only: see how much "
    "of the run they cover.",
)

STYLE = """
:root { color-scheme: light dark; --ink: #1a1a1a; --paper: #fff; --line: #bbb; --soft: #f2f4f6; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e8e8e8; --paper: #16181b; --line: #555; --soft: #24272b; }
}
body { font: 16px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin-top: 2rem; }
body { overflow-wrap: anywhere; } td.number, th { overflow-wrap: normal; }
.wide { overflow-x: auto; } .all td:first-child { min-width: 10em; }
table { border-collapse: collapse; margin: .5rem 0; }
th, td { border-bottom: 1px solid var(--line); padding: .25rem .7rem .25rem 0; text-align: left;
  vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.note { background: var(--soft); border-left: 4px solid #d55e00; padding: .5rem .8rem; }
figure { margin: 1rem 0; } img { max-width: 100%; background: #fff; border-radius: 4px; }
figcaption { font-size: .9rem; }
@media print {
  :root { --ink: #000; --paper: #fff; --line: #999; --soft: #fff; }
  body { margin: 0; max-width: none; font-size: 10.5pt; }
  figure, tr, h2 { break-inside: avoid; } h2 { break-after: avoid; }
  .wide { overflow: visible; } .all { font-size: 6pt; }
  .all th, .all td { padding-right: .4em; }
}
"""

# The page and what it links to work offline: a browser is told to fetch nothing for it.
POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"

# All columns of a table of several have to fit on paper.
LANDSCAPE = "@page { size: landscape; margin: 1cm; }"


def page(result: Report | Reports) -> str:
    """Return a report, or reports of several estimates, as the text of an HTML page.

    Parameters
    ----------
    result : Report or Reports
        As `evaluate` returns it.

    Returns
    -------
    str
        One file without links: figures are inside, each with an alt text.

    Raises
    ------
    AmrError
        If Matplotlib is not installed.

    References
    ----------
    Lecture 03.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0.0, 20.0)
    >>> truth = am.Trajectory(t, np.c_[t, np.sin(t)])
    >>> am.page(am.evaluate(truth, am.Trajectory(t, np.c_[t, np.sin(t) + 0.1])))[:15]
    '<!DOCTYPE html>'
    """
    several = hasattr(result, "reports")
    reports = result.reports if several else (result,)
    title = f"{len(reports)} estimates" if several else f"{reports[0].name}"
    parts = [_table_of_all(result)] if several else []
    if len(reports) > DRAWN:
        parts.append(f"<p>Figures are shown of the {DRAWN} best; one alone has them always.</p>")
    for k, report in enumerate(reports):
        parts.append(f"<h2>{escape(report._title())}</h2>" if several else "")
        parts += [note(report.notes), _table(report), *(_figures(report) if k < DRAWN else ())]
    conventions = "".join(f"<p>{escape(text)}</p>" for text in CONVENTIONS)
    parts.append(f"<h2>How to read the numbers</h2>{conventions}")
    heading = f"{title} against {reports[0].reference_name}"
    return document(heading, parts, LANDSCAPE if several else "")


def document(heading, parts, style=""):
    """Return a page of these parts, HTML texts, that asks no other place for anything.

    Parameters
    ----------
    heading : str
        Its title, plain text.
    parts : sequence of str
        HTML, one below the other; empty ones are left out.
    style : str
        More CSS.
    """
    from amrmetrics import __version__

    heading = escape(heading)
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{heading}</title><style>{STYLE}{style}</style></head><body>\n<h1>{heading}</h1>\n"
        + "\n".join(part for part in parts if part)
        + f"\n<p>Made by amrmetrics {__version__}.</p></body></html>\n"
    )


def note(texts):
    """Return a box with these sentences, plain text, or nothing if there are none."""
    items = "".join(f"<li>{escape(text)}</li>" for text in texts)
    return f'<div class="note"><ul>{items}</ul></div>' if items else ""


def _table(report):
    rows = "".join(
        f"<tr><th scope='row'>{escape(name)}</th><td>{escape(text)}</td></tr>"
        for name, text in report._rows()
        if name != "note"
    )
    return f"<div class='wide'><table>{rows}</table></div>"


def _table_of_all(result):
    rows = result.table()
    head = "".join(f"<th scope='col'>{escape(name.replace('_', ' '))}</th>" for name in rows[0])
    body = "".join("<tr>" + "".join(map(_cell, row.values())) + "</tr>" for row in rows)
    failed = "".join(
        f"<li>{escape(name)}: {escape(why)}</li>" for name, why in result.failures.items()
    )
    failed = f"<p>Failed:</p><ul>{failed}</ul>" if failed else ""
    compared = "".join(
        f"<li>{escape(name)}: {escape(repr(x))}</li>" for name, x in result.comparisons.items()
    )
    compared = f"<p>Differences of paired runs:</p><ul>{compared}</ul>" if compared else ""
    return (
        f"<p>{escape(result._title())}.</p>"
        f"<div class='wide all'><table><tr>{head}</tr>{body}</table></div>{failed}{compared}"
    )


def _cell(value):
    if isinstance(value, float | int):
        return f"<td class='number'>{value:.4g}</td>"
    return f"<td>{escape('' if value is None else str(value))}</td>"


def _figures(report):
    """Return the figures of a report as HTML."""
    plotting = with_matplotlib()
    error, p, q = report.ate, report.reference, report.estimate
    aligned = report.alignment.apply(q.positions)
    worst = int(error.series.argmax())

    def drawn(draw, size=(7.2, 3.4)):
        return picture(lambda figure: draw(figure.subplots()), size)

    yield image(
        drawn(lambda ax: plotting.error_plan(ax, p.positions, aligned, error.series), (7.2, 5)),
        f"The path from above, the estimate in the color of its error. The largest, "
        f"{error.max:.3g} m, is at x = {aligned[worst, 0]:.4g} m, y = {aligned[worst, 1]:.4g} m.",
    )
    if p.stamps is not None:
        t = p.stamps - p.stamps[0]
        yield image(
            drawn(lambda ax: plotting.error_series(ax, error, t)),
            f"ATE over time: rmse {error.rmse:.3g} m, the largest {error.max:.3g} m at "
            f"{t[worst]:.4g} s.",
        )
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(p.positions, axis=0), axis=1))]
    yield image(
        drawn(lambda ax: plotting.error_series(ax, error, along, "distance along the path [m]")),
        f"ATE along the path of {along[-1]:.4g} m; the largest error is at {along[worst]:.4g} m.",
    )
    yield image(
        drawn(lambda ax: plotting.error_histogram(ax, error)),
        f"How often which ATE occurs: half are below {error.median:.3g} m, 95 % below "
        f"{error.p95:.3g} m.",
    )
    deltas, values = _over_stretches(p, q, along[-1]) if report.rpe else ((), ())
    if len(deltas) > 1:
        yield image(
            drawn(lambda ax: plotting.relative_errors(ax, deltas, values)),
            f"RPE against the length of the stretch: from {values[0]:.3g} m over {deltas[0]:.3g} m "
            f"to {values[-1]:.3g} m over {deltas[-1]:.3g} m.",
        )


def _over_stretches(p, q, length):
    """Return stretches in meters, short to long, and the RPE of the translation over each."""
    found = []
    step = length / len(p)
    for delta in np.geomspace(SHORTEST * step, length / 4, STRETCHES) if step > 0 else ():
        try:
            found.append((delta, rpe(p, q, delta, "m").translation.rmse))
        except AmrError:  # the robot moves in steps that are longer than this
            continue
    return tuple(zip(*found, strict=True)) or ((), ())


def with_matplotlib():
    """Return the module that draws, or say what is missing."""
    try:
        from amrmetrics import plotting
    except ImportError:
        raise AmrError("the page needs Matplotlib: pip install 'amrmetrics[plot]'.") from None
    return plotting


def picture(draw, size):
    """Return a figure of the course's look, of so many inches, that `draw` was called with."""
    from matplotlib.figure import Figure

    plotting = with_matplotlib()
    with plotting.plt.rc_context(plotting.STYLE):
        figure = Figure(figsize=size, layout="constrained")
        draw(figure)
        return figure


def image(figure, alt):
    """Return a figure as HTML with its text, all in one."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=110, metadata={"Software": None})
    png = base64.b64encode(buffer.getvalue()).decode()
    text = escape(alt, quote=True)
    return (
        f'<figure><img alt="{text}" src="data:image/png;base64,{png}">'
        f"<figcaption>{text}</figcaption></figure>"
    )
