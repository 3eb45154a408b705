"""Systems and scenarios for the tests of benchmark runs: quick to import, as each trial does."""

import ctypes
import os
import shutil
import signal
import sys
import threading
import time
from pathlib import Path

import numpy as np

import amrmetrics as am
from amrmetrics.benchmark import Estimate, Scenario, SensorLog, System, Truth

SIGHTING = np.dtype([("step", int), ("landmark", int), ("range", float), ("bearing", float)])


def drive(rng, steps=20):
    """A straight drive with noise in the speed."""
    stamps = np.arange(steps + 1) * 0.1
    speed = 1 + 0.1 * rng.standard_normal(steps)
    x = np.r_[0, np.cumsum(speed * 0.1)]
    heading = rng.normal(0, 0.1, steps + 1)
    log = SensorLog(
        stamps=stamps,
        odometry=np.c_[speed, np.zeros(steps)],
        odometry_std=np.array([0.1, 0.01]),
        sightings=np.zeros(0, SIGHTING),
        sighting_std=np.array([0.1, 0.01]),
        landmarks=np.zeros((0, 2)),
        prior=np.zeros(3),
        prior_covariance=np.eye(3),
        candidates=np.zeros((2, 2), int),
        closures=np.tile(np.eye(3), (2, 1, 1)),
        closure_information=np.eye(3),
        scores=np.array([0.2, 0.9]),
        seed=7,
    )
    truth = Truth(stamps, am.planar_poses(np.c_[x, 0 * x], heading), labels=np.array([True, False]))
    return log, truth


def straight(log, bias=0.0):
    """Integrate the speed."""
    x = np.r_[0, np.cumsum(log.odometry[:, 0] * 0.1)] + bias
    return Estimate(
        am.planar_poses(np.c_[x, 0 * x], 0 * x),
        covariances=np.tile(np.eye(3), (len(x), 1, 1)),
        accepted=np.array([True, False]),
        frame_seconds=np.full(len(x), 1e-3),
    )


def noisy(log):
    """Use the global generators, which are the same in every trial."""
    x = np.random.standard_normal((len(log.stamps), 2))  # noqa: NPY002
    names = sorted({str(k) for k in range(9)}, key=hash)
    return Estimate(am.planar_poses(x, 0 * x[:, 0] + int(names[0])))


DRIVE = Scenario("drive", drive)
STRAIGHT = System("straight", straight)
SMALL = ([STRAIGHT, System("noisy", noisy)], [DRIVE, Scenario("long", drive, {"steps": 40})], 2)
MATRIX = ([STRAIGHT, System("biased", straight, {"bias": 0.5})], [DRIVE], 14)


def quietly(*arguments, **options):
    return am.benchmark.run(*arguments, progress=False, **options)


# --- Systems that do what they should not ---


def raises(log):
    raise ValueError("no fix\nfor this log")


def exits(log):
    raise SystemExit(3)


def interrupts(log):
    raise KeyboardInterrupt


def leaves(log):
    print("last words")
    os._exit(3)


def faults(log):
    ctypes.string_at(0)


def hangs(log):
    if os.name == "posix":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    while True:
        time.sleep(1)


def chatters(log):
    """Print a gigabyte."""
    line = b"x" * (1 << 20)
    for _ in range(1 << 10):
        os.write(1, line)
    return straight(log)


def eats(log):
    held = []
    while True:
        held.append(np.ones(1 << 24))


def forks(log):
    os.fork()
    return straight(log)


def daemonizes(log, marker=""):
    """Leave a process behind that has a session of its own and no parent."""
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            Path(marker).write_text(str(os.getpid()), encoding="utf-8")
            time.sleep(600)
        os._exit(0)
    while not Path(marker).exists() or not Path(marker).read_text(encoding="utf-8"):
        time.sleep(0.01)
    return straight(log)


def lingers(log):
    threading.Thread(target=time.sleep, args=(600,)).start()
    return straight(log)


def recurses(log):
    return recurses(log)


def undefined(log):
    estimate = straight(log)
    estimate.poses[3, 0, 2] = np.nan
    return estimate


def nothing(log):
    return None


def stretched(log):
    estimate = straight(log)
    estimate.poses[:, 0, 0] *= 1.1
    return estimate


def backwards(log):
    return Estimate(straight(log).poses, log.stamps[::-1])


def too_many(log):
    return Estimate(np.tile(np.eye(3), (500, 1, 1)))


def negative(log):
    return Estimate(straight(log).poses, covariances=np.tile(-np.eye(3), (21, 1, 1)))


def asks(log):
    return straight(log, bias=float(input() or 0))


def wrecks(log):
    """Change all that is global, and throw away what lies around."""
    sys.stdout.close()
    sys.path.clear()
    os.environ.clear()
    np.random.seed(3)  # noqa: NPY002
    np.seterr(all="raise")
    log.stamps[:] += 1
    open("litter", "w").close()
    os.chdir("/")
    return straight(log)


def own_folder(log):
    shutil.rmtree(os.getcwd())
    return straight(log)
