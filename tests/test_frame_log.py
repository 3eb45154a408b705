"""The frame times of lecture 08 are what the simulation below writes, and show what is asked.

``python3 tests/test_frame_log.py`` writes them again.
"""

from pathlib import Path

import numpy as np

PATH = Path(__file__).parents[1] / "notebooks" / "08_frames.csv"
COLUMNS = "wall_s,cpu_s"
RATE, MINUTES, WARM_UP = 20, 5, 40


def frame_log():
    """Return the wall and CPU time of each frame of a pipeline, in seconds.

    A frame is log-normal with the median 18.5 ms, and one in 25 becomes a keyframe, which takes
    12 ms more. One in 1200 waits for the disk, 60 to 250 ms, in which the processor does nothing.
    In the first two seconds code is loaded and caches fill.
    """
    rng = np.random.default_rng(8)
    n = RATE * 60 * MINUTES + WARM_UP
    computing = 0.0185 * np.exp(0.2 * rng.normal(size=n))
    computing += 0.012 * (rng.random(n) < 1 / 25)
    computing[:WARM_UP] *= 1 + 9 * np.exp(-np.arange(WARM_UP) / 12)
    waiting = rng.uniform(0.060, 0.250, n) * (rng.random(n) < 1 / 1200)
    waiting[:WARM_UP] = 0
    wall = computing + waiting
    return np.column_stack([wall, computing * rng.uniform(0.9, 1.0, n)])


def test_is_reproduced():
    stored = np.loadtxt(PATH, delimiter=",", skiprows=1)
    assert np.allclose(stored, frame_log(), rtol=0, atol=5.1e-7)
    assert PATH.read_text(encoding="utf-8").splitlines()[0] == COLUMNS
    assert PATH.stat().st_size < 130_000


def test_shows_what_the_lecture_asks():
    wall, cpu = np.loadtxt(PATH, delimiter=",", skiprows=1)[WARM_UP:].T
    late = wall > 1 / RATE
    assert wall.mean() < 0.021
    assert np.percentile(wall, 99) < 1 / RATE
    assert 4 <= late.sum() <= 8
    assert late.reshape(MINUTES, -1).any(axis=1).sum() >= 3
    # Whoever looks at the processor sees no late frame at all.
    assert cpu.max() < 1 / RATE
    assert np.all(cpu <= wall)


if __name__ == "__main__":
    np.savetxt(PATH, frame_log(), "%.6f", ",", header=COLUMNS, comments="", encoding="utf-8")
