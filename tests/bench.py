"""Time the library beside evo and beside a copy of the data: ``course.py bench [N ...]``.

What is timed: from arrays in memory to the RMSE, argument checks included, against evo from
prepared objects (their making is not timed) to the same RMSEs. ATE includes the alignment. ATE of
positions is the translation error alone, ATE of poses and RPE are translation and rotation, RPE
over all pairs. Both see the same numbers, in the same run; ours is timed before and after evo, and
all times are medians of processor time, which other programs disturb least. The copy of the input
is what memory allows: no method reads it faster.

evo gets a size only if ten times its last one is below a minute: longer rows have no ratio.
"""

import sys
import tempfile
import time
import tracemalloc
from functools import partial
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from evo.core import metrics, sync, trajectory, units
from evo.tools import file_interface
from scipy.spatial.transform import Rotation

import amrmetrics as am
from amrmetrics import plotting

SIZES = (1_000, 10_000, 100_000, 1_000_000)
PLOT = Path(__file__).resolve().parent.parent / "build" / "bench.png"
LONGEST = 60  # seconds that evo may be expected to take for a row
ENOUGH = 0.3  # seconds for which a call is repeated
METERS = units.Unit.meters
RELATIONS = (metrics.PoseRelation.translation_part, metrics.PoseRelation.rotation_angle_rad)
# At N = 100 000: how many times faster than evo, and how many bytes per pose beside the input.
TARGETS = {
    "ATE of positions": (500, 100),
    "ATE of poses": (500, 100),
    "RPE planar, 1 frame": (1500, 250),
    "RPE spatial, 1 frame": (500, 250),
    "associate": (150, None),
}


def walk(rng, n, d):
    """Return a smooth drive and a noisy estimate of it, poses (n, d+1, d+1)."""
    yaw = np.cumsum(0.02 * rng.normal(size=n))
    xyz = np.cumsum(0.07 * np.c_[np.cos(yaw), np.sin(yaw), 0.1 * np.sin(3 * yaw)], axis=0)
    moved = xyz + 0.02 * rng.normal(size=(n, 3))
    if d == 2:
        turned = yaw + 0.01 * rng.normal(size=n)
        return am.planar_poses(xyz[:, :2], yaw), am.planar_poses(moved[:, :2], turned)
    turn = Rotation.from_euler("zyx", np.c_[yaw, 0.1 * np.sin(yaw), 0.1 * np.cos(yaw)])
    turned = turn * Rotation.from_rotvec(0.01 * rng.normal(size=(n, 3)))
    return am.spatial_poses(xyz, turn.as_quat()), am.spatial_poses(moved, turned.as_quat())


def evo_path(X):
    d = X.shape[-1] - 1
    Y = np.tile(np.eye(4), (len(X), 1, 1))
    Y[:, :d, :d], Y[:, :d, 3] = X[:, :d, :d], X[:, :d, d]
    return trajectory.PosePath3D(poses_se3=list(Y))


def evo_rmse(metric, X, Y):
    metric.process_data((X, Y))
    return metric.get_statistic(metrics.StatisticsType.rmse)


def evo_ate(X, Y, relations=RELATIONS):
    Y.align(X)
    return [evo_rmse(metrics.APE(relation), X, Y) for relation in relations]


def evo_rpe(X, Y, delta, unit=units.Unit.frames):
    kinds = (metrics.RPE(relation, delta, unit, 0.1, True, True) for relation in RELATIONS)
    return [evo_rmse(metric, X, Y) for metric in kinds]


def our_ate(X, Y):
    error = am.ate(X, Y)
    return [error.rmse] + ([error.rotation.rmse] if error.rotation else [])


def our_rpe(X, Y, unit="frames"):
    error = am.rpe(X, Y, 1, unit)
    return [error.translation.rmse, error.rotation.rmse]


def jobs(rng, n, folder):
    """Yield (name, input arrays, our call, preparation of evo's input, evo's call)."""
    for d, space in ((2, "planar"), (3, "spatial")):
        X, Y = walk(rng, n, d)
        places = am.positions(X), am.positions(Y)
        prepare = partial(map, evo_path, (X, Y))
        translation = partial(evo_ate, relations=RELATIONS[:1])
        frame, meter = partial(evo_rpe, delta=1), partial(evo_rpe, delta=1.0, unit=METERS)
        yield f"ATE of positions {space}", places, our_ate, prepare, translation
        yield f"ATE of poses {space}", (X, Y), our_ate, prepare, evo_ate
        yield f"RPE {space}, 1 frame", (X, Y), our_rpe, prepare, frame
        yield f"RPE {space}, 1 m", (X, Y), partial(our_rpe, unit="metres"), prepare, meter
    t = 1.3e9 + np.arange(n) / 100
    u = np.sort(t + 0.002 * rng.normal(size=n))
    yield "associate", (t, u), am.associate, lambda: (u, t), sync.matching_time_indices
    path = folder / "run.txt"
    am.write_tum(path, t, X)
    theirs = file_interface.read_tum_trajectory_file
    yield "read_tum", (t, X), lambda *_: am.read_tum(path), lambda: [path], theirs


def seconds(call):
    """Return the times of some calls; one that takes long is made once."""
    times = []
    while not times or (times[0] < 1 and (len(times) < 5 or sum(times) < ENOUGH)):
        start = time.process_time()
        call()
        times.append(time.process_time() - start)
    return times


def evo_seconds(prepare, call):
    """Return the median time of evo's call, and its result; its input is made anew each time."""
    times = []
    while not times or (len(times) < 3 and sum(times) < 10 * ENOUGH):
        prepared = list(prepare())
        start = time.process_time()
        found = call(*prepared)
        times.append(time.process_time() - start)
    return float(np.median(times)), found


def extra_bytes(call):
    """Return the peak of what the call allocates, its result included."""
    tracemalloc.start()
    call()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak


def measure(sizes, folder):
    """Return {name: [(n, seconds, evo's seconds, copy's seconds, bytes per pose, bytes)]}."""
    rows = {}
    print(
        f"{'':26}{'N':>8} {'ours':>10} {'evo':>10} {'ratio':>7} {'copy':>10} {'ours/copy':>9}",
        end="",
    )
    print(f" {'GB/s':>6} {'B/pose':>7}")
    for n in sizes:
        for name, arrays, ours, prepare, theirs in jobs(np.random.default_rng(n), n, folder):
            done = rows.setdefault(name, [])
            ours, evo = partial(ours, *arrays), np.nan
            times = seconds(ours)
            if not done or 10 * done[-1][2] < LONGEST:
                evo, found = evo_seconds(prepare, theirs)
                if name[:3] in ("ATE", "RPE"):  # a time counts only if the number is the same
                    np.testing.assert_allclose(ours(), found, rtol=1e-9, err_msg=name)
            mine = float(np.median(times + seconds(ours)))
            copy = float(np.median(seconds(lambda arrays=arrays: [a.copy() for a in arrays])))
            size = sum(array.nbytes for array in arrays)
            done.append((n, mine, evo, copy, extra_bytes(ours) / n, size))
            show_row(name, *done[-1])
    return rows


def show_row(name, n, mine, evo, copy, per_pose, size):
    evo, ratio = (f"{evo:.4f} s", f"{evo / mine:.0f}") if evo == evo else ("", "")
    print(
        f"{name:26}{n:8} {1e3 * mine:7.2f} ms {evo:>10} {ratio:>7} {1e3 * copy:7.2f} ms "
        f"{mine / copy:9.1f} {size / mine / 1e9:6.2f} {per_pose:7.0f}",
        flush=True,
    )


def conclude(rows):
    """Print how time grows with N, and the targets."""
    for name, done in rows.items():
        ends = [row for row in done if row[0] >= 10_000]
        if len(ends) > 1:
            (n, first, *_), (m, last, *_) = ends[0], ends[-1]
            power = np.log(last / first) / np.log(m / n)
            print(f"{name}: from {n} to {m}, time grows like N^{power:.2f}")
    for name, done in rows.items():
        for n, mine, evo, _, per_pose, _ in done:
            wanted = [TARGETS[key] for key in TARGETS if name.startswith(key)]
            if n == 100_000 and wanted and evo == evo:
                ratio, most = wanted[0]
                met = evo / mine >= ratio and (most is None or per_pose <= most)
                within = f", {per_pose:.0f} bytes per pose (at most {most})" if most else ""
                print(
                    f"{'met   ' if met else 'MISSED'} {name}: {evo / mine:.0f} times evo "
                    f"(at least {ratio}){within}"
                )


def draw(rows, path):
    """Save a log-log plot of all times."""
    plotting.use_style()
    fig, axes = plt.subplots(2, 5, figsize=(16, 7), sharex=True, sharey=True)
    for ax, (name, done) in zip(axes.flat, rows.items(), strict=True):
        n, mine, evo, copy, *_ = np.array(done).T
        ax.loglog(n, mine, color=plotting.BLUE, ls="-", marker="o", label="amrmetrics")
        ax.loglog(n, evo, color=plotting.RED, ls="--", marker="s", label="evo 1.38.1")
        ax.loglog(n, copy, color=plotting.BLACK, ls=":", marker="^", label="copy of the data")
        ax.set_title(name, fontsize=11)
    axes[0, 0].legend(fontsize=9)
    for ax in axes[:, 0]:
        ax.set_ylabel("seconds")
    for ax in axes[-1]:
        ax.set_xlabel("N")
    path.parent.mkdir(parents=True, exist_ok=True)
    fig.savefig(path)
    plt.close(fig)
    print(f"plot: {path}")


def main(arguments, plot=PLOT):
    sizes = sorted({int(argument) for argument in arguments}) or SIZES
    print(__doc__.split("\n\n", 1)[1])
    with tempfile.TemporaryDirectory() as folder:
        rows = measure(sizes, Path(folder))
    conclude(rows)
    draw(rows, plot)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
