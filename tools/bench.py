"""Time the library beside its peers and a copy of the data: ``course.py bench [N ...]``.

What is timed: from arrays in memory to the RMSE, argument checks included, against evo from
prepared objects (their making is not timed) to the same RMSEs. ATE includes the alignment. ATE of
positions is the translation error alone, ATE of poses and RPE are translation and rotation, RPE
over all pairs. The peer of scores and threshold sweeps is scikit-learn, that of Hausdorff SciPy's
``directed_hausdorff``, both ways; Chamfer, which neither has, is held against that, too.
Both see the same numbers, in the same run; ours is timed before and after the peer, and
all times are medians of processor time, which other programs disturb least. The copy of the input
is what memory allows: no method reads it faster. NumPy has its default threads, as users have it.

Then the trajectories once more by the clock on the wall, first alone and then beside a process that
keeps a core busy: threads that wait for each other are slow there. The peers are evo and, where
they are installed, the compiled metrics of kiss-icp, which has ATE and segment errors of poses, and
pandas and polars, which read and write tables of numbers.

The peer of threshold curves of closures is scikit-learn, too. Pose graphs have a table of their
own: Manhattan worlds from dead reckoning, against gtsam's Levenberg-Marquardt optimizer from a
prepared graph, both with default settings; a time counts only if both end at the same chi-square.

Frame times and runs have a table, too: what `measure` adds to a frame (wall time), and summaries
of 1e6 frame times and of 1e4 bootstrap replicates beside NumPy, SciPy and statsmodels.

A peer gets a size only if ten times its last one is below a minute: longer rows have no ratio.
"""

import argparse
import contextlib
import subprocess
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
from scipy.spatial.distance import directed_hausdorff
from scipy.spatial.transform import Rotation
from scipy.stats import bootstrap, permutation_test, ttest_rel
from sklearn.metrics import (
    average_precision_score,
    brier_score_loss,
    log_loss,
    precision_recall_curve,
)
from statsmodels.duration.survfunc import SurvfuncRight

import amrmetrics as am
from amrmetrics import plotting

try:
    import gtsam
except ImportError:  # it has no wheel for every Python and system
    gtsam = None

try:
    from kiss_icp import metrics as kiss_icp
except ImportError:  # nothing else needs it, and no lock has it
    kiss_icp = None

try:
    import pandas
except ImportError:
    pandas = None

try:
    import polars
except ImportError:  # nothing else needs it, either
    polars = None

SIZES = (1_000, 10_000, 100_000, 1_000_000)
CLOCKED_SIZE = 100_000
PLOT = Path(__file__).resolve().parent.parent / "build" / "bench.png"
LONGEST = 60  # seconds that a peer may be expected to take for a row
GRAPHS = (1_600, 5_600, 16_000, 50_000, 100_000)  # edges, of which 5/8 are odometry
SCALE = 1  # by how much the frame times and runs are fewer than a million and a thousand
ENOUGH = 0.3  # seconds for which a call is repeated
METERS = units.Unit.meters
SAME = ("ATE", "RPE", "cross_entropy", "brier", "precision_recall", "hausdorff")
RELATIONS = (metrics.PoseRelation.translation_part, metrics.PoseRelation.rotation_angle_rad)
# At N = 100 000: how many times faster than evo, and how many bytes per sample beside the input.
TARGETS = {
    "ATE of positions": (300, 100),
    "ATE of poses planar": (1000, 100),
    "ATE of poses spatial": (500, 100),
    "RPE planar, 1 frame": (1500, 250),
    "RPE spatial, 1 frame": (600, 250),
    "associate": (150, None),
}
CLOCKED = tuple(TARGETS)[:5]
# The same by the clock on the wall, and against other peers: at least so many times faster.
CLOCKED_TARGETS = {
    ("ATE of poses spatial", "kiss-icp"): 1,
    ("segments", "kiss-icp"): 1,
    ("read_tum", "pandas"): 1 / 1.5,
    ("write_tum", "polars"): 1 / 3,
}
TRANSLATION = "ATE translation of poses"


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


def closure_precision(labels, scores):
    return am.precision_recall(labels, scores).average_precision


def both_ways(P, Q):
    return max(directed_hausdorff(P, Q)[0], directed_hausdorff(Q, P)[0])


def map_jobs(rng, n):
    """Yield the jobs of a map of n cells, and of two point maps of a wall, n points each."""
    p = rng.beta(0.4, 1.6, n)
    y = rng.random(n) < p
    cells = y, p
    yield "cross_entropy", cells, am.cross_entropy, lambda: cells, log_loss
    yield "brier", cells, am.brier, lambda: cells, brier_score_loss
    yield "threshold_sweep", cells, am.threshold_sweep, lambda: cells, precision_recall_curve
    yield "precision_recall", cells, closure_precision, lambda: cells, average_precision_score
    P, Q = (np.c_[rng.uniform(0, 100, n), 0.02 * rng.normal(size=(n, 2))] for _ in "PQ")
    yield "chamfer", (P, Q), am.chamfer, lambda: (P, Q), both_ways
    yield "hausdorff", (P, Q), am.hausdorff, lambda: (P, Q), both_ways


def jobs(rng, n, folder):
    """Yield (name, input arrays, our call, preparation of the peer's input, its call)."""
    for d, space in ((2, "planar"), (3, "spatial")):
        X, Y = walk(rng, n, d)
        places = am.positions(X), am.positions(Y)
        prepare = partial(map, evo_path, (X, Y))
        translation = partial(evo_ate, relations=RELATIONS[:1])
        frame, meter = partial(evo_rpe, delta=1), partial(evo_rpe, delta=1.0, unit=METERS)
        yield f"ATE of positions {space}", places, our_ate, prepare, translation
        yield f"ATE of poses {space}", (X, Y), our_ate, prepare, evo_ate
        yield f"RPE {space}, 1 frame", (X, Y), our_rpe, prepare, frame
        yield f"RPE {space}, 1 m", (X, Y), partial(our_rpe, unit="m"), prepare, meter
    t = 1.3e9 + np.arange(n) / 100
    u = np.sort(t + 0.002 * rng.normal(size=n))
    yield "associate", (t, u), am.associate, lambda: (u, t), sync.matching_time_indices
    path = folder / "run.txt"
    am.write_tum(path, t, X)
    theirs = file_interface.read_tum_trajectory_file
    yield "read_tum", (t, X), lambda *_: am.read_tum(path), lambda: [path], theirs
    yield from map_jobs(rng, n)


def gtsam_problem(graph):
    """Return the factors and the start of a planar graph, its first node held."""

    def pose(T):
        return gtsam.Pose2(T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0]))

    factors, start = gtsam.NonlinearFactorGraph(), gtsam.Values()
    rows = zip(graph.edges.tolist(), graph.measurements, graph.information, strict=True)
    for (i, j), Z, W in rows:
        noise = gtsam.noiseModel.Gaussian.Information(W)
        factors.add(gtsam.BetweenFactorPose2(i, j, pose(Z), noise))
    factors.add(gtsam.NonlinearEqualityPose2(0, pose(graph.poses[0])))
    for k, X in enumerate(graph.poses):
        start.insert(k, pose(X))
    return factors, start


def gtsam_seconds(graph):
    """Return the processor time of gtsam, once warm, and the chi-square where it ends."""
    factors, start = gtsam_problem(graph)
    times = []
    for _ in range(2 if len(graph.edges) < 20_000 else 1):
        optimizer = gtsam.LevenbergMarquardtOptimizer(factors, start)
        begin = time.process_time()
        found = optimizer.optimize()
        times.append(time.process_time() - begin)
    return min(times), 2 * factors.error(found)


def measure_graphs(sizes):
    """Print how fast pose graphs are optimized, and return [(edges, seconds, per iteration)]."""
    print(f"{'pose graph':26}{'edges':>8} {'ours':>10} {'gtsam':>10} {'ratio':>7}", end="")
    print(f" {'steps':>6} {'each':>10} {'chi-square':>12} {'difference':>11}")
    rows = []
    for edges in sizes:
        poses = round(edges * 5 / 8)
        run = am.simulation.city_run(
            np.random.default_rng(edges), poses, closures=edges - poses + 1, aliased=0, unlike=0
        )
        graph = run.graph()
        am.optimize(graph, max_iterations=1)  # what it imports is loaded now
        mine = min(seconds(lambda graph=graph: am.optimize(graph)))
        result = am.optimize(graph)
        each = mine / result.iterations
        peer, ratio, difference = "", "", ""
        if gtsam:
            theirs, chi_square = gtsam_seconds(graph)
            peer, ratio = f"{theirs:.4f} s", f"{theirs / mine:.2f}"
            difference = f"{result.chi_square / chi_square - 1:.1e}"
            if edges == 5_600:
                met = 3 * theirs >= mine and abs(result.chi_square / chi_square - 1) < 1e-6
                verdict = f"{'met   ' if met else 'MISSED'} pose graph of {edges} edges: "
                verdict += f"{mine / theirs:.2f} times gtsam's time (at most 3)"
        print(
            f"{'Manhattan world':26}{edges:8} {1e3 * mine:7.1f} ms {peer:>10} {ratio:>7} "
            f"{result.iterations:6} {1e3 * each:7.1f} ms {result.chi_square:12.6g} "
            f"{difference:>11}",
            flush=True,
        )
        rows.append((edges, mine, each))
    if gtsam and 5_600 in sizes:
        print(verdict)
    if len(rows) > 1:
        (n, _, first), (m, _, last) = rows[0], rows[-1]
        power = np.log(last / first) / np.log(m / n)
        print(f"pose graph: from {n} to {m} edges, time per iteration grows like N^{power:.2f}")
    return rows


def frame_cost(frames=20_000):
    """Return the wall seconds that `measure` adds to a frame, the best of five tries."""
    costs = []
    for _ in range(5):
        begin = time.perf_counter()
        for _ in range(frames):
            pass
        bare = time.perf_counter() - begin
        with am.measure() as log:
            for _ in range(frames):
                with log.frame():
                    pass
        costs.append((log.result.elapsed - bare) / frames)
    return min(costs)


def numpy_percentiles(times):
    return np.percentile(times, [50, 95, 99])


def scipy_bootstrap(a, b):
    return bootstrap((a - b,), np.mean, n_resamples=9999, rng=np.random.default_rng(0))


def scipy_10_000_flips(a, b):
    return permutation_test((a - b,), np.mean, permutation_type="samples")


def run_jobs(rng, scale):
    """Yield (name, input arrays, our call, the peer's) for frame times and runs."""
    frames, runs = 1_000_000 // scale, 1_000 // min(scale, 10)
    times = rng.gamma(4, 0.005, frames)
    slow = np.convolve(times, np.full(100, 0.01), "same")
    summarize = partial(am.latency, deadline=0.05)
    yield "latency", (times,), summarize, numpy_percentiles
    yield "latency, correlated", (slow,), summarize, numpy_percentiles
    lost = np.round(rng.exponential(10, frames // 100), 1) + 0.1
    yield "relocalization_time", (lost, lost < 15), am.relocalization_time, SurvfuncRight
    a, b = rng.normal(size=(2, runs))
    yield "compare_paired", (a, b), am.compare_paired, ttest_rel
    yield "compare_bootstrap, 1e4", (a, b), am.compare_bootstrap, scipy_bootstrap
    c, d = rng.normal(size=(2, 20))
    yield "compare_sign_flip, exact", (c, d), am.compare_sign_flip, scipy_10_000_flips


def measure_runs(scale=1):
    """Print the cost of a measured frame and the times of summaries; return {name: seconds}."""
    found = {"measure": frame_cost()}
    print(f"measure: {1e6 * found['measure']:.2f} microseconds a frame")
    print(f"{'frame times and runs':26}{'N':>8} {'ours':>10} {'peer':>10} {'ratio':>7}")
    for name, arrays, ours, theirs in run_jobs(np.random.default_rng(12), scale):
        found[name] = mine = float(np.median(seconds(partial(ours, *arrays))))
        peer = float(np.median(seconds(partial(theirs, *arrays))))
        print(
            f"{name:26}{len(arrays[0]):8} {1e3 * mine:7.2f} ms {peer:8.4f} s {peer / mine:7.2f} "
            f"{theirs.__name__}",
            flush=True,
        )
    return found


def seconds(call, clock=time.process_time):
    """Return the times of some calls; one that takes long is made once."""
    times = []
    while not times or (times[0] < 1 and (len(times) < 5 or sum(times) < ENOUGH)):
        start = clock()
        call()
        times.append(clock() - start)
    return times


def peer_seconds(prepare, call, clock=time.process_time):
    """Return the median time of a peer's call, and its result; its input is made anew each time."""
    times = []
    while not times or (len(times) < 3 and sum(times) < 10 * ENOUGH):
        prepared = list(prepare())
        start = clock()
        found = call(*prepared)
        times.append(clock() - start)
    return float(np.median(times)), found


def extra_bytes(call):
    """Return the peak of what the call allocates, its result included."""
    tracemalloc.start()
    call()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak


def measure(sizes, folder):
    """Return {name: [(n, seconds, peer's seconds, copy's seconds, bytes per sample, bytes)]}."""
    rows = {}
    print(
        f"{'':26}{'N':>8} {'ours':>10} {'peer':>10} {'ratio':>7} {'copy':>10} {'ours/copy':>9}",
        end="",
    )
    print(f" {'GB/s':>6} {'B each':>7}")
    for n in sizes:
        for name, arrays, ours, prepare, theirs in jobs(np.random.default_rng(n), n, folder):
            done = rows.setdefault(name, [])
            ours, peer = partial(ours, *arrays), np.nan
            times = seconds(ours)
            if not done or 10 * done[-1][2] < LONGEST:
                peer, found = peer_seconds(prepare, theirs)
                # Over 1 m evo counts pairs at the end of the path, too, that fall short of it.
                if name.startswith(SAME) and not name.endswith("1 m"):
                    mine = ours() if name[:3] in ("ATE", "RPE") else float(ours())
                    np.testing.assert_allclose(mine, found, rtol=1e-9, err_msg=name)
            mine = float(np.median(times + seconds(ours)))
            copy = float(np.median(seconds(lambda arrays=arrays: [a.copy() for a in arrays])))
            size = sum(array.nbytes for array in arrays)
            done.append((n, mine, peer, copy, extra_bytes(ours) / n, size))
            show_row(name, *done[-1])
    return rows


@contextlib.contextmanager
def busy_core():
    """Keep one core busy."""
    process = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        yield
    finally:
        process.kill()
        process.wait()


def measure_clocked(n, folder):
    """Print wall times of trajectories alone and beside a busy core, how many times faster they are
    than each peer, and the targets.
    """
    print(f"\nby the wall clock, N = {n}, alone and beside a process that keeps a core busy")
    print(f"{'':10} {'':24} {'ours':>10} {'peer':>12}  times faster than")
    verdicts = []
    for where, around in (("alone", contextlib.nullcontext), ("busy core", busy_core)):
        with around():
            found = {}
            for name, peer, arrays, ours, prepare, theirs in clocked_jobs(n, folder):
                mine = float(np.median(seconds(partial(ours, *arrays), time.perf_counter)))
                other, _ = peer_seconds(prepare, theirs, time.perf_counter)
                found[name, peer] = mine
                print(
                    f"{where:10} {name:24} {1e3 * mine:7.2f} ms {1e3 * other:9.1f} ms "
                    f"{other / mine:8.2f}  {peer}",
                    flush=True,
                )
                least = CLOCKED_TARGETS.get((name, peer)) or next(
                    (TARGETS[key][0] for key in CLOCKED if name.startswith(key)), None
                )
                if least and n == CLOCKED_SIZE:
                    met = "met   " if other / mine >= least else "MISSED"
                    verdicts.append(
                        f"{met} {where}, {name}: {other / mine:.2f} times faster than {peer} (at "
                        f"least {least:.3g})"
                    )
            places, poses = (
                found[f"{name} spatial", "evo"] for name in ("ATE of positions", TRANSLATION)
            )
            met = "met   " if poses <= 2 * places else "MISSED"
            verdicts.append(
                f"{met} {where}, {TRANSLATION} spatial: {poses / places:.2f} times the time of "
                "positions (at most 2)"
            )
    print("\n".join(verdicts))


def tum_table(t, X):
    """Return the numbers of a TUM file."""
    return np.column_stack([t, X[:, :3, 3], Rotation.from_matrix(X[:, :3, :3]).as_quat()])


def clocked_jobs(n, folder):
    """Yield (name, peer, arrays, our call, preparation, the peer's call) of trajectories and files.

    Peers other than evo are left out where they are not installed.
    """
    for name, *job in jobs(np.random.default_rng(n), n, folder):
        if name.startswith(CLOCKED):
            yield name, "evo", *job
    X, Y = walk(np.random.default_rng(n), n, 3)
    translation = partial(evo_ate, relations=RELATIONS[:1])
    prepare = partial(map, evo_path, (X, Y))
    yield f"{TRANSLATION} spatial", "evo", (X, Y), lambda *x: am.ate(*x).rmse, prepare, translation
    if kiss_icp is not None:
        for name, ours, theirs in (
            ("ATE of poses spatial", our_ate, kiss_icp.absolute_trajectory_error),
            ("segments", am.segment_drift, kiss_icp.sequence_error),
        ):
            yield name, "kiss-icp", (X, Y), ours, lambda: (X, Y), theirs
    t, path = 1.3e9 + np.arange(n) / 100, folder / "run.txt"
    am.write_tum(path, t, X)
    if pandas is not None:
        read = partial(pandas.read_csv, sep=" ", header=None)
        yield "read_tum", "pandas", (), lambda: am.read_tum(path), lambda: [path], read
    if polars is not None:
        table = polars.DataFrame(tum_table(t, X))
        copy = folder / "copy.txt"
        write = partial(table.write_csv, separator=" ", include_header=False)
        yield "write_tum", "polars", (path, t, X), am.write_tum, lambda: [copy], write


def show_row(name, n, mine, peer, copy, each, size):
    peer, ratio = (f"{peer:.4f} s", f"{peer / mine:.1f}") if peer == peer else ("", "")
    print(
        f"{name:26}{n:8} {1e3 * mine:7.2f} ms {peer:>10} {ratio:>7} {1e3 * copy:7.2f} ms "
        f"{mine / copy:9.1f} {size / mine / 1e9:6.2f} {each:7.0f}",
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
        for n, mine, peer, _, each, _ in done:
            wanted = [TARGETS[key] for key in TARGETS if name.startswith(key)]
            if n == 100_000 and wanted and peer == peer:
                ratio, most = wanted[0]
                met = peer / mine >= ratio and (most is None or each <= most)
                within = f", {each:.0f} bytes per pose (at most {most})" if most else ""
                print(
                    f"{'met   ' if met else 'MISSED'} {name}: {peer / mine:.0f} times evo "
                    f"(at least {ratio}){within}"
                )


def draw(rows, path):
    """Save a log-log plot of all times."""
    plotting.use_style()
    fig, axes = plt.subplots(4, 4, figsize=(14, 12), sharex=True, sharey=True)
    for ax, (name, done) in zip(axes.flat, rows.items(), strict=True):
        n, mine, peer, copy, *_ = np.array(done).T
        ax.loglog(n, mine, color=plotting.BLUE, ls="-", marker="o", label="amrmetrics")
        ax.loglog(n, peer, color=plotting.RED, ls="--", marker="s", label="peer")
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


def main(arguments=None, plot=PLOT):
    parser = argparse.ArgumentParser(prog="course.py bench", description=__doc__.split("\n\n")[0])
    parser.add_argument("sizes", nargs="*", type=int, metavar="N", help="numbers of samples")
    sizes = sorted({*parser.parse_args(arguments).sizes}) or SIZES
    print(__doc__.split("\n\n", 1)[1])
    with tempfile.TemporaryDirectory() as folder:
        rows = measure(sizes, Path(folder))
        conclude(rows)
        measure_clocked(CLOCKED_SIZE, Path(folder))
    measure_graphs(GRAPHS)
    measure_runs(SCALE)
    draw(rows, plot)
    return 0


if __name__ == "__main__":
    sys.exit(main())
