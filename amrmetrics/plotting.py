"""The look of the course's figures, and how they get into a page.

Nothing here computes a metric: the functions draw what they are given.
"""

import base64
import html
import inspect
import io

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import patheffects

# Okabe and Ito, Color Universal Design (2008); a test checks that every two stay apart
# for the three common kinds of color blindness.
BLACK, ORANGE, SKY, GREEN, YELLOW, BLUE, RED, PINK = (
    "#000000",
    "#E69F00",
    "#56B4E9",
    "#009E73",
    "#F0E442",
    "#0072B2",
    "#D55E00",
    "#CC79A7",
)

# The same thing looks the same in every lecture, by color and by line or marker, so that
# a figure also reads in gray. Use as ``ax.plot(x, y, **LOOK["truth"])``.
LOOK = {
    "truth": {"color": BLACK, "linestyle": "-", "label": "truth"},
    "estimate": {"color": RED, "linestyle": "--", "label": "estimate"},
    "aligned": {"color": BLUE, "linestyle": "-.", "label": "aligned estimate"},
    "error": {"color": PINK, "linestyle": "-", "label": "error"},
    "bound": {"color": "0.45", "linestyle": ":", "label": "bound"},
    "theory": {"color": GREEN, "linestyle": "-", "label": "theory"},
    "measured": {"color": ORANGE, "linestyle": "none", "marker": "o", "label": "measured"},
}

STYLE = {
    "figure.figsize": (6.4, 3.6),
    "figure.dpi": 110,
    "figure.constrained_layout.use": True,
    "axes.grid": True,
    "grid.alpha": 0.25,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": plt.cycler(
        color=[BLUE, RED, GREEN, PINK, ORANGE, SKY], linestyle=["-", "--", "-.", ":", "-", "--"]
    ),
    "font.size": 11,
    "legend.frameon": False,
    "lines.linewidth": 1.8,
    "lines.markersize": 5,
}


def use_style():
    """Give all figures from here on the course's look."""
    plt.rcParams.update(STYLE)


def show(fig, alt):
    """Show a figure as the output of a notebook cell, with a text for who cannot see it.

    Parameters
    ----------
    fig : matplotlib.figure.Figure
        The figure; it is closed.
    alt : str
        What the figure shows, with its finding, in a sentence or two.

    Raises
    ------
    ValueError
        If `alt` is empty.

    Examples
    --------
    >>> from amrmetrics import plotting
    >>> fig, ax = plotting.plt.subplots()
    >>> plotting.show(fig, alt="An empty pair of axes.")  # doctest: +SKIP
    """
    from IPython.display import display

    if not alt.strip():
        raise ValueError("alt is empty; say in a sentence what the figure shows.")
    buffer = io.BytesIO()
    # Without the version string the same figure gives the same bytes everywhere.
    fig.savefig(buffer, format="png", metadata={"Software": None})
    plt.close(fig)
    png = base64.b64encode(buffer.getvalue()).decode()
    display(
        {"image/png": png, "text/plain": f"Figure: {alt}"},
        metadata={"image/png": {"alt": alt}},
        raw=True,
    )


def explore(draw, **controls):
    """Show sliders, and below them what `draw` shows and prints at their values.

    JupyterLab calls `draw` again at every move. Where nobody moves a slider, in a page or in
    `course.py refresh`, it is called once, so that its errors and warnings are seen.

    Parameters
    ----------
    draw : callable
        Called with one keyword argument for each control. It ends with `show`; what it prints
        stands below the figure.
    **controls
        A slider (lowest, highest) or (lowest, highest, step); two options or more as a list; a
        flag as True or False; or a widget of ipywidgets. A slider starts at the default that
        `draw` has for its argument, otherwise in the middle.

    Raises
    ------
    ValueError
        If a control is none of these.

    Examples
    --------
    >>> from amrmetrics import plotting
    >>> def draw(degrees=30):
    ...     fig, ax = plotting.plt.subplots()
    ...     ax.plot([0, np.cos(np.radians(degrees))], [0, np.sin(np.radians(degrees))])
    ...     plotting.show(fig, alt=f"A line of {degrees} degrees.")
    >>> plotting.explore(draw, degrees=(-180, 180, 5))  # doctest: +SKIP
    """
    from IPython.display import display
    from ipywidgets import HTML, VBox, interactive

    arguments = inspect.signature(draw).parameters
    widgets = {}
    for name, control in controls.items():
        default = arguments[name].default if name in arguments else inspect.Parameter.empty
        widgets[name] = interactive.widget_from_abbrev(control, default)
        if widgets[name] is None:
            raise ValueError(
                f"{name} is {control!r}; give (lowest, highest), (lowest, highest, step), a list, "
                "True, False or a widget."
            )
        widgets[name].description = widgets[name].description or name

    def values():
        return {name: widget.value for name, widget in widgets.items()}

    # `ipywidgets.interact` draws into an Output widget. A program that executes a notebook must
    # play the browser for one: it answers every figure on the channel on which it waits for the
    # end of the cell. ZeroMQ reports an arrival once, and to send takes the report too; then the
    # cell stalls until its time limit (nbclient, issue 312). A page that only the kernel writes
    # asks for no answer.
    page = HTML(_page(draw, values()))

    def moved(_):
        try:
            page.value = _page(draw, values())
        except Exception as error:  # nobody else would show it
            page.value = f"<pre>{html.escape(f'{type(error).__name__}: {error}')}</pre>"

    for widget in widgets.values():
        widget.observe(moved, names="value")
    display(VBox([*widgets.values(), page]))


def _page(draw, values):
    """Return what a call of `draw` shows and prints, as HTML."""
    from IPython.utils.capture import capture_output

    with capture_output(stderr=False) as seen:
        draw(**values)
    parts = [_shown(output.data, output.metadata) for output in seen.outputs]
    if seen.stdout:
        parts.append(f"<pre>{html.escape(seen.stdout)}</pre>")
    return "\n".join(parts)


def _shown(data, metadata):
    """Return one output of a cell, which maps types to contents, as HTML."""
    if "image/png" in data:
        alt = html.escape(metadata.get("image/png", {}).get("alt", ""))
        return f'<img src="data:image/png;base64,{data["image/png"]}" alt="{alt}">'
    return data.get("text/html", f"<pre>{html.escape(data.get('text/plain', ''))}</pre>")


def plan(ax, **trajectories):
    """Draw trajectories from above, axes of equal scale.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    **trajectories : (N, d) arrays
        Positions in meters under the names of `LOOK`: truth, estimate, aligned.
    """
    for name, xy in trajectories.items():
        ax.plot(xy[:, 0], xy[:, 1], **LOOK[name])
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    ax.legend()


def consistency_band(
    ax, times, values, lower, upper, expected, confidence=0.95, name="NEES", mark_outside=False
):
    """Draw NEES or NIS over time with the band that holds them if the filter is consistent.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    times : (T,) array
        Seconds.
    values : (T,) array
        One run's values or their means over runs; no unit.
    lower, upper : float or (T,) array
        Two-sided chi-square bounds of one of these values.
    expected : float
        Degrees of freedom of one value.
    confidence : float
        Of the band, for the legend.
    name : str
        For the vertical axis.
    mark_outside : bool
        True draws the band over the values, and gives those outside another marker and their
        number in the legend.
    """
    lower, upper = np.broadcast_to(lower, len(times)), np.broadcast_to(upper, len(times))
    alpha, over = (0.3, {"zorder": 3}) if mark_outside else (0.15, {})
    ax.fill_between(times, lower, upper, color=LOOK["bound"]["color"], alpha=alpha, linewidth=0)
    ax.plot(times, lower, **LOOK["bound"] | {"label": f"{100 * confidence:g} % band"} | over)
    ax.plot(times, upper, **LOOK["bound"] | {"label": "_"} | over)
    ax.axhline(expected, **LOOK["theory"] | {"label": "expected"} | over)
    if mark_outside:
        values = np.asarray(values, dtype=float)
        outside = (values < lower) | (values > upper)
        label = f"{outside.sum()} of {len(values)} outside"
        far = {"linestyle": "none", "marker": "x", "markersize": 4, "label": label}
        ax.plot(times, np.where(outside, np.nan, values), **LOOK["measured"] | {"markersize": 2})
        ax.plot(times, np.where(outside, values, np.nan), **LOOK["estimate"] | far)
    else:
        ax.plot(times, values, **LOOK["measured"] | {"markersize": 3})
    ax.set(xlabel="time [s]", ylabel=name)
    if ax.get_yscale() == "linear":
        ax.set_ylim(0, None)
    ax.legend()


def covariance_ellipse(ax, P, nees, center=(0.0, 0.0), **look):
    """Draw all errors in the plane that have one NEES under a covariance: an ellipse.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    P : (2, 2) array
        Covariance, symmetric positive definite.
    nees : float
        The value e^T P^-1 e on the curve, > 0. A share 1 - exp(-nees / 2) of Gaussian errors
        lies inside.
    center : (2,) array
        Where the error is 0.
    **look
        For `Axes.plot`: color, linestyle, label.
    """
    angle = np.linspace(0, 2 * np.pi, 181)
    circle = np.sqrt(nees) * np.array([np.cos(angle), np.sin(angle)])
    # P = L L^T, so e = L z has the NEES |z|^2.
    x, y = np.linalg.cholesky(np.asarray(P, dtype=float)) @ circle
    ax.plot(center[0] + x, center[1] + y, **look)
    ax.set_aspect("equal")


def chi_square(ax, values, grid, density, name="NEES"):
    """Draw the distribution of NEES or NIS values against the one they should have.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    values : (N,) array
        NEES or NIS, no unit. What lies beyond the grid is counted in the legend, and its
        area is missing from the bars.
    grid, density : (M,) array
        Increasing abscissas > 0 and the chi-square density there.
    name : str
        For the horizontal axis.
    """
    edges = np.linspace(0, grid[-1], 31)
    counts, _ = np.histogram(values, edges)
    beyond = np.mean(np.asarray(values) > grid[-1])
    label = "measured" + (f" ({100 * beyond:.2g} % beyond {grid[-1]:g})" if beyond else "")
    heights = counts / (np.size(values) * edges[1])
    ax.stairs(heights, edges, fill=True, color=LOOK["measured"]["color"], alpha=0.6, label=label)
    ax.plot(grid, density, **LOOK["theory"] | {"label": "chi-square density"})
    ax.set(xlabel=name, ylabel="density", xlim=(0, grid[-1]))
    ax.legend()


def reliability_diagram(ax, forecast, frequency, count):
    """Draw how often it was so against how likely it was said to be, and a strip of counts.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw; the strip hangs below and has the label of the common abscissa.
    forecast, frequency : (B,) array
        Mean forecast and frequency of the bins, in [0, 1]; bins that are nan are left out.
    count : (B,) array
        Cells per bin; drawn on a logarithmic scale.
    """
    ax.plot([0, 1], [0, 1], **LOOK["theory"] | {"label": "calibrated"})
    ax.plot(forecast, frequency, **LOOK["measured"])
    ax.set(xlim=(-0.02, 1.02), ylim=(-0.02, 1.02), ylabel="frequency of occupied")
    ax.tick_params(labelbottom=False)
    ax.legend(loc="lower right")
    strip = ax.inset_axes([0, -0.3, 1, 0.24], sharex=ax)
    strip.bar(forecast, count, width=0.03, color=LOOK["bound"]["color"])
    strip.set(yscale="log", xlabel="forecast", ylabel="cells", ylim=(0.5, None))
    strip.minorticks_off()


def threshold_sweep(ax, thresholds, mark=None, **rates):
    """Draw rates of a map over the threshold at which it is cut.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    thresholds : (K,) array
        Decreasing, in [0, 1] or inf, as `amrmetrics.threshold_sweep` gives them: a rate
        holds from its threshold down to the next. That at inf, nothing called occupied, is
        drawn from the largest probability up to 1.
    mark : float, optional
        A threshold to mark.
    **rates : (K,) arrays
        Under their names: precision, recall, f1, iou, ...; in [0, 1], gaps where nan.
    """
    thresholds = np.asarray(thresholds)
    # No cut lies above a probability of 1.
    shown = np.isfinite(thresholds) | (thresholds != 1).all()
    x = np.concatenate([[0], np.minimum(thresholds, 1)[shown][::-1]])
    for name, values in rates.items():
        y = np.asarray(values)[shown][::-1]
        label = {"f1": "F1", "iou": "IoU"}.get(name, name.replace("_", " "))
        ax.plot(x, np.concatenate([y[:1], y]), drawstyle="steps-pre", label=label)
    if mark is not None:
        ax.axvline(mark, **LOOK["bound"] | {"label": f"threshold {mark:.3g}"})
    ax.set(xlabel="threshold", ylabel="rate", xlim=(0, 1), ylim=(-0.02, 1.02))
    ax.legend(frameon=True, edgecolor="none", framealpha=0.85)


def grid_maps(axes, maps, extent, titles):
    """Draw occupancy grids side by side on one scale from 0 (white) to 1 (black).

    Parameters
    ----------
    axes : sequence of K matplotlib.axes.Axes
        Where to draw; all in one figure.
    maps : sequence of K (H, W) arrays
        Truth first; probabilities of "occupied", rows y upward, columns x. Cells that are
        nan are unknown and hatched.
    extent : (4,) array
        Left, right, bottom and top border of the grid, meters.
    titles : sequence of K str
        One for each.
    """
    gray = plt.get_cmap("gray_r").with_extremes(bad=(0, 0, 0, 0))
    for ax, grid, title in zip(axes, maps, titles, strict=True):
        ax.patch.set(facecolor="#DCEBF5", edgecolor=SKY, hatch="////", linewidth=0)
        image = ax.imshow(
            np.asarray(grid, dtype=float), gray, origin="lower", extent=extent, vmin=0, vmax=1,
            interpolation="nearest",
        )  # fmt: skip
        ax.grid(False)
        ax.set(title=title, xlabel="x [m]")
    axes[0].set_ylabel("y [m]")
    unknown = any(np.isnan(np.asarray(grid, dtype=float)).any() for grid in maps)
    label = "p(occupied)" + "\nhatched: unknown" * unknown
    axes[0].figure.colorbar(image, ax=axes, label=label, shrink=0.8)


def point_maps(ax, reference, estimate, worst=None):
    """Draw two point maps over each other, axes of equal scale.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    reference, estimate : (N, 2), (M, 2) array
        Points in meters, in one frame.
    worst : (int, int), optional
        Indices of a point of `reference` and one of `estimate` to join and to ring, as the
        `worst` of `amrmetrics.hausdorff` gives them.
    """
    reference, estimate = np.asarray(reference), np.asarray(estimate)
    # The truth lies on top: it is thin, and would vanish below a good estimate.
    dots = {"linestyle": "none", "marker": ".", "markersize": 2.5, "zorder": 3}
    crosses = {"linestyle": "none", "marker": "x", "markersize": 2.5, "markeredgewidth": 0.6}
    ax.plot(*reference.T, **LOOK["truth"] | dots)
    ax.plot(*estimate.T, **LOOK["estimate"] | crosses)
    if worst is not None:
        ends = np.array([reference[worst[0]], estimate[worst[1]]])
        label = f"worst pair, {np.linalg.norm(ends[1] - ends[0]):.2f} m"
        # A pair is much smaller than the map: a ring says where to look, a rim sets it off.
        rim = [patheffects.withStroke(linewidth=5, foreground="black")]
        pair = {"linewidth": 3, "zorder": 5, "path_effects": rim, "solid_capstyle": "round"}
        ring = {"marker": "o", "markersize": 24, "markerfacecolor": "none", "markeredgewidth": 2}
        ring |= {"linestyle": "none", "label": "_", "zorder": 4}
        ax.plot(*ends.T, **LOOK["error"] | pair | {"label": label})
        ax.plot(*ends.mean(axis=0), **LOOK["error"] | ring)
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    # Walls are everywhere: the legend goes below, clear of the label.
    below = {"loc": "upper center", "bbox_to_anchor": (0.5, 0), "borderaxespad": 3.4}
    ax.legend(**below, ncols=3, columnspacing=1, handletextpad=0.6, markerscale=2)


def error_plan(ax, reference, estimate, error, unit="m"):
    """Draw an aligned estimate from above, its error as color, and the reference below it.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    reference, estimate : (N, d) array
        Positions in meters, in one frame.
    error : (N,) array
        One for each position, such as the `series` of an ATE.
    unit : str
        Of the error.
    """
    reference, estimate = np.asarray(reference), np.asarray(estimate)
    ax.plot(*reference.T[:2], **LOOK["truth"] | {"linewidth": 1, "color": "0.6"})
    # Dark is large: it reads in gray, and on white paper.
    dots = ax.scatter(*estimate.T[:2], c=error, s=6, cmap="viridis_r", zorder=3)
    ax.figure.colorbar(dots, ax=ax, label=f"error [{unit}]", shrink=0.8)
    ax.plot(*estimate[0, :2], **LOOK["measured"] | {"label": "start", "zorder": 4})
    ax.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
    ax.legend(fontsize=9, loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)


def error_series(ax, summary, along=None, label="time [s]"):
    """Draw the errors of an ErrorSummary one after the other, with rmse and median.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    summary : amrmetrics.ErrorSummary
        Of an ATE or a part of an RPE; angles are drawn in degrees.
    along : (n,) array, optional
        Where each error belongs, such as its stamp or its distance along the path; the number
        of the sample if not given.
    label : str
        What `along` is, with its unit.
    """
    factor, unit = (np.degrees(1), "deg") if summary.unit == "rad" else (1.0, summary.unit)
    label = "sample" if along is None else label
    along = np.arange(summary.n) if along is None else np.asarray(along)
    ax.plot(along, factor * summary.series, **LOOK["error"] | {"linewidth": 1})
    rmse, median = factor * summary.rmse, factor * summary.median
    ax.axhline(rmse, color=BLUE, linestyle="--", label=f"rmse {rmse:.3g} {unit}")
    ax.axhline(median, color=GREEN, linestyle="-.", label=f"median {median:.3g} {unit}")
    ax.set(xlabel=label, ylabel=f"{summary.metric} {summary.quantity} [{unit}]", ylim=(0, None))
    ax.legend(fontsize=9, loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3)


def error_histogram(ax, summary):
    """Draw how often which error of an ErrorSummary occurs, with its rmse and P95.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    summary : amrmetrics.ErrorSummary
        Of an ATE or a part of an RPE; angles are drawn in degrees.
    """
    factor, unit = (np.degrees(1), "deg") if summary.unit == "rad" else (1.0, summary.unit)
    bins = int(np.clip(np.sqrt(summary.n), 5, 60))
    ax.hist(factor * summary.series, bins=bins, color=SKY, edgecolor="white", linewidth=0.4)
    for name, color, style in (("rmse", BLUE, "--"), ("p95", RED, ":")):
        value = factor * getattr(summary, name)
        text = f"{'P95' if name == 'p95' else name} {value:.3g} {unit}"
        ax.axvline(value, color=color, linestyle=style, label=text)
    ax.set(xlabel=f"{summary.metric} {summary.quantity} [{unit}]", ylabel="samples")
    ax.legend(fontsize=9, loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)


def relative_errors(ax, deltas, translation, unit="m"):
    """Draw the RPE over the length of the stretch, both logarithmic.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    deltas : (K,) array
        Lengths of the stretches, > 0.
    translation : (K,) array
        Root mean square of the translation error for each, meters.
    unit : str
        Of the stretches.
    """
    ax.loglog(deltas, translation, **LOOK["measured"] | {"linestyle": "-"})
    ax.set(xlabel=f"length of the stretch [{unit}]", ylabel="RPE translation rmse [m]")


def coverage(ax, match):
    """Draw when a match has pairs, as a bar over the time of the reference.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    match : amrmetrics.Match
        With stamps; time counts from its first pair.
    """
    stamps = match.reference.stamps
    t = stamps - stamps[0]
    steps = np.diff(t)
    usual = np.median(steps) if len(steps) else 0.0
    breaks = np.flatnonzero(steps > 5 * usual) + 1
    for part in np.split(t, breaks):
        ax.barh(0, max(part[-1] - part[0], usual), left=part[0], color=BLUE, height=0.5)
    ax.set(xlabel="time [s]", yticks=[], ylim=(-0.6, 0.6), title=repr(match.coverage))


# Systems of a comparison: every two differ by color, by line and by marker. The dashes of a line
# are told apart better than the names for them allow.
DASHES = ("-", (0, (6, 2)), (0, (1, 1.3)), (0, (8, 2, 1, 2)), (0, (3, 1)), (0, (8, 2, 1, 2, 1, 2)))
COLORS = (BLUE, RED, GREEN, PINK, ORANGE, SKY, "0.45")
MARKERS = "os^DvXP*"


def looks(names):
    """Return a color, a line and a marker for each name, no two alike up to 168 names.

    Parameters
    ----------
    names : sequence of str
        In the order in which they get their looks.

    Returns
    -------
    dict of str to dict
        For `Axes.plot`, the label included.
    """
    return {
        name: {
            "color": COLORS[k % len(COLORS)],
            "linestyle": DASHES[k % len(DASHES)],
            "marker": MARKERS[k % len(MARKERS)],
            "label": name,
        }
        for k, name in enumerate(names)
    }


def _sparse(look, k, n, marks=6):
    """Return a look with a few markers, shifted so that those of several lines do not meet."""
    step = max(1, n // marks)
    return look | {"markevery": (k * step // len(MARKERS), step), "linewidth": 1.5, "markersize": 5}


def _plain_numbers(axis):
    """Label the ticks of a logarithmic axis 0.2, 1 and 30, not by powers of ten."""
    from matplotlib.ticker import LogFormatter, StrMethodFormatter

    class Plain(LogFormatter):
        """Chooses like its base which ticks get a label."""

        def __call__(self, x, pos=None):
            return f"{x:g}" if super().__call__(x, pos) else ""

    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(Plain(minor_thresholds=(1.2, 0.4)))


def plans(ax, truth, paths, look):
    """Draw the paths of several systems from above, and the truth below them.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    truth : (N, 2) array
        Positions in meters.
    paths : dict of str to (M, 2) array
        Of each system, in the frame of the truth.
    look : dict
        As `looks` returns it.
    """
    wide = {"linewidth": 4, "alpha": 0.25, "zorder": 1}
    ax.plot(*np.asarray(truth).T, **LOOK["truth"] | wide)
    for k, name in enumerate(look):
        if name in paths:
            xy = np.asarray(paths[name])
            ax.plot(*xy.T, **_sparse(look[name], k, len(xy)))
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal", adjustable="datalim")


def series(ax, x, values, look, xlabel, ylabel, log=False):
    """Draw one line per system.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    x : (T,) array
        Abscissas of all.
    values : dict of str to (T,) array
        Of each system; gaps where nan.
    look : dict
        As `looks` returns it.
    xlabel, ylabel : str
        With units.
    log : bool
        Whether the vertical axis is logarithmic.
    """
    for k, name in enumerate(look):
        if name in values:
            ax.plot(x, values[name], **_sparse(look[name], k, len(x)))
    ax.set(xlabel=xlabel, ylabel=ylabel)
    if log:
        ax.set_yscale("log")
        _plain_numbers(ax.yaxis)
    else:
        ax.set_ylim(0, None)


def band(ax, x, lower, upper, expected, confidence=0.95):
    """Draw a band, its limits and what is expected in it, below what else is drawn.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    x : (T,) array
        Abscissas.
    lower, upper : (T,) array
        Limits of the band.
    expected : float
        Drawn as a line.
    confidence : float
        For the legend.
    """
    ax.fill_between(x, lower, upper, color=LOOK["bound"]["color"], alpha=0.25, linewidth=0)
    label = f"{100 * confidence:g} % band"
    thin = {"linewidth": 1, "zorder": 1.5}
    ax.plot(x, lower, **LOOK["bound"] | thin | {"label": label})
    ax.plot(x, upper, **LOOK["bound"] | thin | {"label": "_"})
    ax.axhline(expected, color=BLACK, linewidth=0.8, zorder=1.5, label="expected")


def closure_curves(ax, recall, precision, accepted, look):
    """Draw precision over recall of several systems, and where each one works.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    recall : (R,) array
        Levels, increasing.
    precision : dict of str to (R,) array
        Of each system.
    accepted : dict of str to (float, float)
        Recall and precision of what a system accepted.
    look : dict
        As `looks` returns it.
    """
    for k, name in enumerate(look):
        if name in precision:
            ax.plot(recall, precision[name], **_sparse(look[name], k, len(recall)))
        if name in accepted:
            point = {"linestyle": "none", "markersize": 11, "markerfacecolor": "none"}
            ax.plot(*accepted[name], **look[name] | point | {"label": "_", "markeredgewidth": 2})
    ax.set(xlabel="recall", ylabel="precision", xlim=(-0.02, 1.02), ylim=(-0.02, 1.05))


def latency_tails(ax, tails, look):
    """Draw which part of the frames takes longer than a time, both axes logarithmic.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    tails : dict of str to ((T,) array, (T,) array)
        Of each system: milliseconds, increasing, and the part of the frames above them.
    look : dict
        As `looks` returns it.
    """
    for k, name in enumerate(look):
        if name in tails:
            ms, part = tails[name]
            steps = {"drawstyle": "steps-post"}
            ax.plot(ms, part, **_sparse(look[name], k, len(ms)) | steps)
    for part, text in ((0.05, "P95"), (0.01, "P99")):
        ax.axhline(part, color="0.45", linewidth=1, linestyle=":")
        ax.text(1, part, f" {text}", transform=ax.get_yaxis_transform(), va="center", fontsize=9)
    ax.set(xscale="log", yscale="log", ylim=(1e-3, 1.2))
    _plain_numbers(ax.xaxis)
    _plain_numbers(ax.yaxis)
    ax.set(xlabel="time of a frame [ms]", ylabel="part of the frames above")


def intervals(ax, groups, values, look, xlabel, log=False):
    """Draw numbers with intervals, a row for each group and a marker for each system in it.

    Parameters
    ----------
    ax : matplotlib.axes.Axes
        Where to draw.
    groups : sequence of str
        From top to bottom.
    values : dict of (str, str) to (float, float, float)
        For group and system the number and its limits; nan where there is none.
    look : dict
        As `looks` returns it.
    xlabel : str
        With its unit.
    log : bool
        Whether the horizontal axis is logarithmic.
    """
    places = {name: k for k, name in enumerate(look)}
    height = 0.7 / max(1, len(places))
    for name, k in places.items():
        rows = [
            (j, *values[group, name]) for j, group in enumerate(groups) if (group, name) in values
        ]
        if not rows:
            continue
        j, x, low, high = np.array(rows).T
        y = j + (k - (len(places) - 1) / 2) * height
        reach = np.nan_to_num([x - low, high - x])
        ax.errorbar(x, y, xerr=reach, capsize=2, **look[name] | {"linestyle": "none"})
    ax.set(yticks=range(len(groups)), yticklabels=groups, xlabel=xlabel)
    ax.set_ylim(len(groups) - 0.5, -0.5)
    if log:
        ax.set_xscale("log")
        _plain_numbers(ax.xaxis)
    else:
        ax.set_xlim(0, None)
    for j in range(len(groups) - 1):
        ax.axhline(j + 0.5, color="0.8", linewidth=0.8)
