"""The palette can be told apart, and figures carry their text."""

import itertools

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_rgb

import amrmetrics as am
from amrmetrics import plotting

# Full dichromacy in linear RGB: Machado, Oliveira and Fernandes, IEEE TVCG 15 (2009), table 1.
VISION = {
    "full color": np.eye(3),
    "protanopia": [[0.152, 1.053, -0.205], [0.115, 0.786, 0.099], [-0.004, -0.048, 1.052]],
    "deuteranopia": [[0.367, 0.861, -0.228], [0.280, 0.673, 0.047], [-0.012, 0.043, 0.969]],
    "tritanopia": [[1.256, -0.077, -0.179], [-0.078, 0.931, 0.148], [0.005, 0.691, 0.304]],
}


def lab(color, vision):
    """CIE L*a*b* (D65) of an sRGB color as seen with `vision`."""
    rgb = np.array(to_rgb(color))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    seen = np.clip(np.array(vision) @ linear, 0, 1)
    to_xyz = [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
    x, y, z = np.cbrt(np.array(to_xyz) @ seen / [0.9505, 1.0, 1.089])
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])


def colors():
    return {look["color"] for look in plotting.LOOK.values()} | set(
        plotting.STYLE["axes.prop_cycle"].by_key()["color"]
    )


@pytest.mark.parametrize("vision", VISION)
def test_every_two_colors_stay_apart(vision):
    for a, b in itertools.combinations(sorted(colors()), 2):
        distance = np.linalg.norm(lab(a, VISION[vision]) - lab(b, VISION[vision]))
        assert distance > 10, f"{a} and {b} look alike under {vision}: {distance:.1f}"


def test_the_measure_catches_red_against_green():
    far = np.linalg.norm(lab("#c0392b", np.eye(3)) - lab("#5a7d2a", np.eye(3)))
    near = np.linalg.norm(
        lab("#c0392b", VISION["deuteranopia"]) - lab("#5a7d2a", VISION["deuteranopia"])
    )
    assert near < far / 2


def test_looks_differ_without_color():
    marks = [
        (look["linestyle"], look.get("marker"), look["color"] in (plotting.BLACK, "0.45"))
        for look in (plotting.LOOK[name] for name in ("truth", "estimate", "aligned", "bound"))
    ]
    assert len(set(marks)) == len(marks)


def test_show_stores_the_alt_text_and_closes(monkeypatch):
    shown = []
    monkeypatch.setattr("IPython.display.display", lambda *a, **k: shown.append((a, k)))
    fig, ax = plt.subplots()
    plotting.plan(ax, truth=np.array([[0, 0], [1, 2.0]]))
    plotting.show(fig, alt='A path "north" & back.')
    (bundle,), options = shown[0]
    assert options["metadata"]["image/png"]["alt"] == 'A path "north" & back.'
    assert bundle["text/plain"] == 'Figure: A path "north" & back.'
    assert not plt.fignum_exists(fig.number)
    assert ax.get_xlabel() == "x [m]"


def test_show_refuses_a_figure_without_text():
    fig, _ = plt.subplots()
    with pytest.raises(ValueError, match="alt is empty"):
        plotting.show(fig, alt=" ")
    plt.close(fig)


def test_the_same_figure_gives_the_same_bytes(monkeypatch):
    shown = []
    monkeypatch.setattr("IPython.display.display", lambda *a, **k: shown.append(a[0]))
    for _ in range(2):
        fig, ax = plt.subplots()
        ax.plot([1, 2])
        plotting.show(fig, alt="A line.")
    assert shown[0] == shown[1]


@pytest.fixture
def ax():
    fig, ax = plt.subplots()
    yield ax
    fig.canvas.draw()  # nothing may warn when it is rendered
    plt.close(fig)


def line(ax, label):
    (found,) = (line for line in ax.get_lines() if line.get_label() == label)
    return found


class TestReliabilityDiagram:
    def test_draws_the_bins_that_have_cells(self, ax):
        parts = am.murphy([1, 0, 0, 1, 1], [0.1, 0.1, 0.6, 0.6, 0.95])
        plotting.reliability_diagram(ax, parts.forecast, parts.frequency, parts.count)
        x, y = line(ax, "measured").get_data()
        assert x[np.isfinite(x)] == pytest.approx([0.1, 0.6, 0.95])
        assert y[np.isfinite(x)] == pytest.approx([0.5, 0.5, 1])
        assert line(ax, "calibrated").get_xydata().tolist() == [[0, 0], [1, 1]]
        assert line(ax, "calibrated").get_color() == plotting.LOOK["theory"]["color"]
        (strip,) = ax.child_axes
        bars = [bar for bar in strip.patches if bar.get_height()]
        assert [bar.get_center()[0] for bar in bars] == pytest.approx([0.1, 0.6, 0.95])
        assert [bar.get_height() for bar in bars] == [2, 2, 1]
        assert strip.get_yscale() == "log" and strip.get_xlabel() == "forecast"
        assert strip.get_xlim() == ax.get_xlim()


class TestThresholdSweep:
    @pytest.mark.parametrize("largest", [0.9, 1.0])
    def test_the_steps_are_the_rates_at_each_threshold(self, ax, largest):
        y, p = [1, 1, 0, 0, 1], [largest, 0.3, 0.6, 0.1, 0.6]
        sweep = am.threshold_sweep(y, p)
        plotting.threshold_sweep(
            ax, sweep.thresholds, mark=0.6, recall=sweep.recall, precision=sweep.precision,
            iou=sweep.iou, false_positive_rate=sweep.false_positive_rate,
        )  # fmt: skip
        for label, name in [("recall", "recall"), ("precision", "precision"), ("IoU", "iou"),
                            ("false positive rate", "false_positive_rate")]:  # fmt: skip
            steps = line(ax, label)
            assert steps.get_drawstyle() == "steps-pre"
            x, rate = steps.get_data()
            assert x[0] == 0 and x[-1] == 1
            for threshold in (0.01, 0.1, 0.2, 0.3, 0.45, 0.6, 0.61, 0.9, 0.95, 1.0):
                drawn = rate[np.searchsorted(x, threshold)]  # a step reaches back to the last x
                expected = getattr(am.confusion(y, p, threshold), name)
                np.testing.assert_equal(drawn, expected, f"{name} at {threshold}")
        assert line(ax, "threshold 0.6").get_xdata() == [0.6, 0.6]

    def test_one_cell(self, ax):
        sweep = am.threshold_sweep([1], [0.3])
        plotting.threshold_sweep(ax, sweep.thresholds, f1=sweep.f1)
        assert line(ax, "F1").get_xydata().tolist() == [[0, 1], [0.3, 1], [1, 0]]


class TestGridMaps:
    def test_one_scale_and_rows_upward(self):
        fig, axes = plt.subplots(1, 2)
        truth = np.array([[True, False, False], [False, False, False]])
        estimate = np.array([[0.9, 0.2, np.nan], [0.4, 0.5, 0.1]])
        plotting.grid_maps(axes, [truth, estimate], (-1, 2, 4, 6), ["truth", "estimate"])
        for ax, grid in zip(axes, (truth, estimate), strict=True):
            (image,) = ax.get_images()
            assert image.get_clim() == (0, 1)
            assert image.origin == "lower" and image.get_extent() == [-1, 2, 4, 6]
            np.testing.assert_array_equal(image.get_array().filled(np.nan), grid)
            assert ax.patch.get_hatch()
        image = axes[1].get_images()[0]
        white, black, unknown = image.to_rgba(np.ma.masked_invalid([0, 1, np.nan]))
        assert white.tolist() == [1, 1, 1, 1] and black.tolist() == [0, 0, 0, 1]
        assert unknown[3] == 0  # the hatched ground shows
        assert [ax.get_title() for ax in fig.axes[:2]] == ["truth", "estimate"]
        assert fig.axes[2].get_ylabel() == "p(occupied)\nhatched: unknown"
        assert np.isnan(estimate).sum() == 1
        plt.close(fig)

    def test_no_unknown_cell_no_hatching_in_the_label(self, ax):
        plotting.grid_maps([ax], [np.eye(2)], (0, 1, 0, 1), ["truth"])
        assert ax.figure.axes[1].get_ylabel() == "p(occupied)"

    def test_one_title_for_each(self, ax):
        with pytest.raises(ValueError, match="zip"):
            plotting.grid_maps([ax], [np.eye(2)], (0, 1, 0, 1), ["truth", "estimate"])


class TestPointMaps:
    def test_worst_pair_is_joined(self, ax):
        P, Q = np.array([[0.0, 0], [1, 0], [2, 0]]), np.array([[0.0, 0.1], [1, 0.1], [2, 3]])
        plotting.point_maps(ax, P, Q, am.hausdorff(P, Q).worst)
        assert line(ax, "truth").get_xydata().tolist() == P.tolist()
        assert line(ax, "estimate").get_xydata().tolist() == Q.tolist()
        assert line(ax, "worst pair, 3.00 m").get_xydata().tolist() == [[2, 0], [2, 3]]
        assert ax.get_aspect() == 1
        looks = {(x.get_marker(), x.get_color()) for x in ax.get_lines()[:3]}
        assert len(looks) == 3

    def test_worst_pair_is_ringed_on_top(self, ax):
        P, Q = np.array([[0.0, 0], [1, 0], [20, 0]]), np.array([[0.0, 0.1], [1, 0.1], [20, 0.3]])
        plotting.point_maps(ax, P, Q, am.hausdorff(P, Q).worst)
        *maps, pair, ring = ax.get_lines()
        assert ring.get_xydata().tolist() == [[20, 0.15]]
        assert ring.get_markerfacecolor() == "none" and ring.get_markersize() > 20
        assert ring.get_color() == pair.get_color() == plotting.LOOK["error"]["color"]
        assert min(pair.zorder, ring.zorder) > max(line.zorder for line in maps)
        assert ring.get_label().startswith("_")

    def test_without_worst_pair(self, ax):
        plotting.point_maps(ax, [[0, 0]], np.empty((0, 2)))
        assert len(ax.get_lines()) == 2
