"""The frame log of problem set 08 is what the simulation below writes, and misleads as intended.

``python3 tests/test_runtime_log.py`` writes it again.
"""

from pathlib import Path

import numpy as np

import amrmetrics as am

PATH = Path(__file__).parents[1] / "solutions" / "08_runtime" / "frames.csv"
COLUMNS = "robot,image_s,start_s,end_s,cpu_s"
FORMATS = ["%d", "%.1f", "%.4f", "%.4f", "%.4f"]
PERIOD, IMAGES, WARM_UP = 0.1, 1200, 50

# Robot A is quick and keeps the newest image only; robot B is slower and keeps all in a queue.
# Each has frames that wait for the disk: frame and seconds.
ROBOTS = (
    {
        "median": 0.030,
        "warm_up": 4.5,
        "stalls": {150: 1.72, 420: 2.33, 655: 1.45, 910: 2.64, 1101: 1.97},
    },
    {
        "median": 0.062,
        "warm_up": 1.2,
        "stalls": {131: 0.29, 342: 0.35, 468: 0.26, 590: 0.31, 777: 0.38, 905: 0.27, 1040: 0.33},
    },
)


def drive(rng, robot, median, warm_up, stalls):
    """Return one row per image that was worked on."""
    image = PERIOD * np.arange(IMAGES)
    computing = median * np.exp(0.1 * rng.normal(size=IMAGES))
    computing[:WARM_UP] *= 1 + warm_up * np.exp(-np.arange(WARM_UP) / 12)
    rows, free = [], 0.0
    for k, due in enumerate(image):
        newer = k + 1 < IMAGES and image[k + 1] <= free
        if robot == 0 and newer:
            continue  # when the computer is free, there is a newer image
        start = max(due, free) + rng.uniform(0.0005, 0.001)
        free = start + computing[k] + stalls.get(k, 0)
        rows.append([robot, due, start, free, computing[k] * rng.uniform(0.95, 1)])
    return rows


def frame_log():
    """Return the rows of both robots, one after the other."""
    rng = np.random.default_rng(3)
    return np.array([row for k, robot in enumerate(ROBOTS) for row in drive(rng, k, **robot)])


def numbers(log):
    """Return what part d asks, and what the rows alone say, for each robot."""
    found = {}
    for robot in (0, 1):
        _, image, start, end, cpu = log[(log[:, 0] == robot) & (log[:, 1] > 4.95)].T
        in_time = end - image <= PERIOD
        late = int(np.sum(~in_time))
        missing = IMAGES - WARM_UP - len(image)
        found[robot] = {
            "dropped": missing,
            "late": missing + late,
            "late by the rows": late,
            "slow by the rows": int(np.sum(end - start > PERIOD)),
            "slow by the processor": int(np.sum(cpu > PERIOD)),
            "mean": float(np.mean(end - start)),
            "median": float(np.median(end - start)),
            "p95": float(np.percentile(end - start, 95)),
            "p99": float(np.percentile(end - start, 99)),
        }
    return found


def test_is_reproduced():
    stored = np.loadtxt(PATH, delimiter=",", skiprows=1)
    assert np.allclose(stored, frame_log(), rtol=0, atol=5.1e-5)
    assert PATH.read_text(encoding="utf-8").splitlines()[0] == COLUMNS
    assert PATH.stat().st_size < 100_000


def test_the_obvious_summary_prefers_the_wrong_robot():
    a, b = numbers(np.loadtxt(PATH, delimiter=",", skiprows=1)).values()
    for name in ("mean", "median", "p95", "p99", "slow by the rows", "late by the rows"):
        assert a[name] < b[name], name
    assert a["late"] > 1.5 * b["late"]
    assert b["dropped"] == 0
    assert a["slow by the processor"] == b["slow by the processor"] == 0


def test_each_mistake_gives_another_number():
    log = np.loadtxt(PATH, delimiter=",", skiprows=1)
    for robot, found in numbers(log).items():
        cold = log[(log[:, 0] == robot) & (log[:, 1] < 4.95)]
        late_cold = np.sum(cold[:, 3] - cold[:, 1] > PERIOD) + WARM_UP - len(cold)
        assert late_cold > 0
        kinds = {found[k] for k in ("late", "late by the rows", "slow by the rows")}
        # In a queue no image is dropped.
        assert len(kinds) == (3, 2)[robot]
        assert found["late"] + late_cold not in kinds


def test_no_time_lies_on_the_deadline():
    log = np.loadtxt(PATH, delimiter=",", skiprows=1)
    for taken in (log[:, 3] - log[:, 1], log[:, 3] - log[:, 2], log[:, 4]):
        assert np.abs(taken - PERIOD).min() > 3e-4


def test_the_library_reads_it():
    log = np.loadtxt(PATH, delimiter=",", skiprows=1)
    a = log[log[:, 0] == 0]
    assert am.latency(a[:, 3] - a[:, 2], deadline=PERIOD, warm_up=WARM_UP).misses < 10


if __name__ == "__main__":
    np.savetxt(PATH, frame_log(), FORMATS, ",", header=COLUMNS, comments="", encoding="utf-8")
