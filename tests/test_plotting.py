"""The palette can be told apart, and figures carry their text."""

import itertools

import matplotlib.pyplot as plt
import numpy as np
import pytest
from ipywidgets import IntSlider
from jupyter_core.utils import run_sync
from matplotlib.colors import to_rgb
from nbclient import NotebookClient
from nbformat.v4 import new_code_cell, new_notebook

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


class TestExplore:
    """The slider cell: live in a kernel, and nothing that stalls who executes a notebook."""

    @pytest.fixture
    def shown(self, monkeypatch):
        shown = []
        monkeypatch.setattr("IPython.display.display", shown.append)
        return shown

    @staticmethod
    def draw(turn=10, side="left"):
        if turn > 100:
            raise ValueError(f"{turn} > 100")
        print(f"<{turn}> {side}")

    def test_draws_again_when_a_control_moves(self, shown):
        plotting.explore(self.draw, turn=(-180, 180, 2), side=["left", "right"])
        slider, options, page = shown[0].children
        assert (slider.min, slider.max, slider.step, slider.value) == (-180, 180, 2, 10)
        assert (slider.description, options.description) == ("turn", "side")
        assert page.value == "<pre>&lt;10&gt; left\n</pre>"
        slider.value = 20
        options.value = "right"
        assert page.value == "<pre>&lt;20&gt; right\n</pre>"

    def test_shows_an_error_when_a_control_moves_and_raises_it_at_once(self, shown):
        plotting.explore(self.draw, turn=(-180, 180, 2))
        slider, page = shown[0].children
        slider.value = 102
        assert page.value == "<pre>ValueError: 102 &gt; 100</pre>"
        slider.value = 12
        assert page.value == "<pre>&lt;12&gt; left\n</pre>"
        with pytest.raises(ValueError, match="150 > 100"):
            plotting.explore(self.draw, turn=(150, 151))

    def test_takes_a_widget_and_starts_in_the_middle_without_a_default(self, shown):
        widget = IntSlider(7, 0, 9, description="angle")
        plotting.explore(lambda a, b, c: print(a, b, c), a=widget, b=(2.0, 6.0), c=True)
        assert shown[0].children[-1].value == "<pre>7 4.0 True\n</pre>"
        assert [w.description for w in shown[0].children[:3]] == ["angle", "b", "c"]

    def test_refuses_what_is_no_control(self, shown):
        with pytest.raises(ValueError, match=r"turn is None; give \(lowest, highest\)"):
            plotting.explore(self.draw, turn=None)

    def test_in_a_kernel_it_follows_the_slider_and_asks_its_client_for_no_answer(self):
        """`interact` does ask: nbclient then answers each figure while it awaits the cell's end.

        Its answer goes out on the channel where it waits, and sending takes the sign that the
        end has come with it: 7 of 40 executions on a busy core stalled to their time limit.
        """
        cell = """
from amrmetrics import plotting
def draw(turn):
    fig, ax = plotting.plt.subplots()
    plotting.show(fig, alt=f'A "turn" of {turn}.')
plotting.explore(draw, turn=(-180, 180, 2))
"""
        nb = new_notebook(cells=[new_code_cell(cell)])
        client = NotebookClient(nb, kernel_name="python3", timeout=60)
        with client.setup_kernel():
            client.execute_cell(nb.cells[0], 0)
            states = client.widget_state
            models = {state["_model_name"]: key for key, state in states.items()}
            assert {"IntSliderModel", "HTMLModel"} <= set(models)
            assert not set(client.comm_objects)  # nothing that nbclient would answer for
            first = states[models["HTMLModel"]]["value"]
            assert first.startswith('<img src="data:image/png;base64,')
            assert 'alt="A &quot;turn&quot; of 0."' in first
            # What a browser sends when the slider is moved.
            data = {"method": "update", "state": {"value": 30}, "buffer_paths": []}
            content = {"comm_id": models["IntSliderModel"], "data": data}
            client.kc.shell_channel.send(client.kc.session.msg("comm_msg", content))
            receive = run_sync(client.kc.iopub_channel.get_msg)
            message = receive(timeout=20)
            while message["content"].get("comm_id") != models["HTMLModel"]:
                message = receive(timeout=20)
        assert 'alt="A &quot;turn&quot; of 30."' in message["content"]["data"]["state"]["value"]


@pytest.fixture
def ax():
    fig, ax = plt.subplots()
    yield ax
    fig.canvas.draw()  # nothing may warn when it is rendered
    plt.close(fig)


def line(ax, label):
    (found,) = (line for line in ax.get_lines() if line.get_label() == label)
    return found


class TestConsistencyBand:
    def test_marks_and_counts_what_lies_outside(self, ax):
        values, lower = [3, 1, 9, 1.5, 4], [1.5, 1.5, 1.5, 1.5, 4.5]
        plotting.consistency_band(ax, np.arange(5.0), values, lower, 8, 3, mark_outside=True)
        inside, outside = line(ax, "measured"), line(ax, "3 of 5 outside")
        assert outside.get_ydata()[[1, 2, 4]].tolist() == [1, 9, 4]
        assert np.isnan(outside.get_ydata()[[0, 3]]).all()  # on the bound is inside
        assert inside.get_ydata()[[0, 3]].tolist() == [3, 1.5]
        assert np.isnan(inside.get_ydata()[[1, 2, 4]]).all()
        assert inside.get_marker() != outside.get_marker()
        assert inside.get_color() != outside.get_color()
        assert line(ax, "95 % band").get_zorder() > inside.get_zorder()


class TestCovarianceEllipse:
    def test_every_point_has_the_nees(self, ax):
        P = np.array([[4.0, 2.0], [2.0, 5.0]])
        plotting.covariance_ellipse(ax, P, 5, center=(1, -2), color="k", label="NEES 5")
        errors = line(ax, "NEES 5").get_xydata() - [1, -2]
        assert am.nees(errors, P) == pytest.approx(np.full(len(errors), 5))
        assert errors[0] == pytest.approx(errors[-1])
        assert len(np.unique(errors.round(6), axis=0)) == len(errors) - 1
        assert ax.get_aspect() == 1


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


class TestErrors:
    """What a report draws, each alone in a pair of axes."""

    ERROR = am.ate([[0, 0]] * 4, [[0, 0], [3, 4], [0, 10], [0, 5]], align="none")

    def test_series_over_samples_and_over_time(self, ax):
        plotting.error_series(ax, self.ERROR)
        line = ax.lines[0]
        assert line.get_xdata().tolist() == [0, 1, 2, 3]
        assert line.get_ydata().tolist() == [0, 5, 10, 5]
        labels = [text.get_text() for text in ax.get_legend().get_texts()]
        assert labels == ["error", "rmse 6.12 m", "median 5 m"]
        plotting.error_series(ax, self.ERROR, [0, 2, 4, 9], "distance [m]")
        assert ax.lines[3].get_xdata().tolist() == [0, 2, 4, 9]
        assert ax.get_xlabel() == "distance [m]"

    def test_angles_are_in_degrees(self, ax):
        X = am.planar_poses(np.zeros((3, 2)), [0, 0, 0])
        turned = am.planar_poses(np.zeros((3, 2)), np.radians([0, 10, -20]))
        plotting.error_series(ax, am.ate(X, turned, "none").rotation)
        assert np.allclose(ax.lines[0].get_ydata(), [0, 10, 20])
        assert ax.get_ylabel() == "ATE rotation [deg]"

    def test_histogram_counts_every_sample(self, ax):
        plotting.error_histogram(ax, self.ERROR)
        assert sum(bar.get_height() for bar in ax.patches) == 4
        assert [line.get_xdata()[0] for line in ax.lines] == [self.ERROR.rmse, self.ERROR.p95]

    def test_plan_colors_by_error(self, ax):
        p = np.array([[0.0, 0], [1, 0], [2, 1]])
        plotting.error_plan(ax, p, p + 0.1, [0.1, 0.2, 0.3])
        dots = ax.collections[0]
        assert np.allclose(dots.get_offsets(), p + 0.1)
        assert dots.get_array().tolist() == [0.1, 0.2, 0.3]
        assert ax.get_aspect() == 1

    def test_relative_errors_are_logarithmic(self, ax):
        plotting.relative_errors(ax, [1, 10], [0.01, 0.03])
        assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")

    def test_coverage_breaks_where_there_is_a_gap(self, ax):
        t = np.r_[np.arange(0, 3, 0.1), np.arange(8, 10, 0.1)]
        run = am.Trajectory(t, np.c_[t, t])
        plotting.coverage(ax, am.match(run, run))
        assert len(ax.patches) == 2
        assert "longest gap 5.1 s" in ax.get_title()
