"""The look of the course's figures, and how they get into a page.

Nothing here computes a metric: the functions draw what they are given.
"""

import base64
import io

import matplotlib.pyplot as plt
import numpy as np

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


def consistency_band(ax, times, values, lower, upper, expected, confidence=0.95, name="NEES"):
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
    """
    lower, upper = np.broadcast_to(lower, len(times)), np.broadcast_to(upper, len(times))
    ax.fill_between(times, lower, upper, color=LOOK["bound"]["color"], alpha=0.15, linewidth=0)
    ax.plot(times, lower, **LOOK["bound"] | {"label": f"{100 * confidence:g} % band"})
    ax.plot(times, upper, **LOOK["bound"] | {"label": "_"})
    ax.axhline(expected, **LOOK["theory"] | {"label": "expected"})
    ax.plot(times, values, **LOOK["measured"] | {"markersize": 3})
    ax.set(xlabel="time [s]", ylabel=name, ylim=(0, None))
    ax.legend()


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
