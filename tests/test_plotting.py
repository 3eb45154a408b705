"""The palette can be told apart, and figures carry their text."""

import itertools

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_rgb

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
