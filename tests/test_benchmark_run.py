"""Benchmark runs: what happens to a trial stays in the trial, and a killed run goes on."""

import errno
import functools
import hashlib
import json
import os
import pickle
import shutil
import subprocess
import sys
import threading
import time
import zlib
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
from benchmark_systems import (
    DRIVE,
    MATRIX,
    SMALL,
    STRAIGHT,
    asks,
    backwards,
    chatters,
    daemonizes,
    drive,
    eats,
    exits,
    faults,
    forks,
    hangs,
    interrupts,
    leaves,
    lingers,
    negative,
    noisy,
    nothing,
    own_folder,
    quietly,
    raises,
    recurses,
    straight,
    stretched,
    too_many,
    undefined,
    wrecks,
)

import amrmetrics as am
from amrmetrics.benchmark import (
    Estimate,
    Protocol,
    Scenario,
    System,
    logs,
    running,
)
from amrmetrics.benchmark import protocol as protocols

POSIX = os.name == "posix"
LINUX = sys.platform == "linux"


def files_of(folder):
    """Return the digest of each file that has to be the same in every run."""
    found = (path for path in sorted(Path(folder).rglob("*")) if path.is_file())
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in found
        if path.name not in (logs.TIMES, logs.OUTPUT)
    }


def entry_of(folder, system, seed=0):
    return next(e for e in logs.index(folder).entries if (e.system, e.seed) == (system, seed))


@pytest.fixture(scope="module")
def small(tmp_path_factory):
    """The folder of a small benchmark, run by the default executor. Not to be changed."""
    folder = tmp_path_factory.mktemp("benchmark") / "small"
    assert quietly(*SMALL, folder).done == 8
    return folder


@pytest.fixture
def copy(small, tmp_path):
    return Path(shutil.copytree(small, tmp_path / "copy"))


# --- What is logged -----------------------------------------------------------------------------


def test_a_trial_reads_back_as_it_was(small):
    trial = logs.read_trial(entry_of(small, "straight", 1))
    rng = np.random.default_rng(np.random.SeedSequence([1, zlib.crc32(b"drive")]))
    log, truth = drive(rng)
    expected = straight(log)
    assert (trial.status, trial.scenario, trial.split) == ("ok", "drive", "test")
    assert np.array_equal(trial.truth.stamps, truth.stamps)
    assert np.array_equal(trial.truth.labels, truth.labels)
    assert np.array_equal(am.positions(trial.truth.poses), am.positions(truth.poses))
    assert np.abs(trial.truth.poses - truth.poses).max() < 1e-15
    assert trial.truth.landmarks is None
    assert np.array_equal(am.positions(trial.estimate.poses), am.positions(expected.poses))
    assert np.array_equal(trial.estimate.stamps, log.stamps)
    assert np.array_equal(trial.estimate.covariances, expected.covariances)
    assert np.array_equal(trial.estimate.accepted, expected.accepted)
    assert np.array_equal(trial.estimate.frame_seconds, expected.frame_seconds)
    assert trial.estimate.map_points is None
    assert 0 <= trial.seconds["wall"] < 60
    assert 1e6 < trial.seconds["peak"] < 4e9 or not POSIX


def test_poses_are_text_in_tum_format(small):
    entry = entry_of(small, "straight")
    recording = am.read_tum(entry.path / "estimate.tum")
    assert np.array_equal(
        recording.positions[:, :2], logs.read_trial(entry).estimate.poses[:, :2, 2]
    )


def test_numbers_survive_the_text(rng):
    stamps = 1.6e9 + np.cumsum(rng.uniform(0.01, 0.1, 500))
    quaternions = rng.normal(size=(500, 4))
    quaternions /= np.linalg.norm(quaternions, axis=1)[:, None]
    space = am.spatial_poses(
        rng.normal(size=(500, 3)) * 10 ** rng.uniform(-9, 6, (500, 1)), quaternions
    )
    plane = am.planar_poses(space[:, :2, 3], rng.uniform(-4, 4, 500))
    for poses in (space, plane, space[:, :3, 3], plane[:, :2, 2]):
        estimate = logs.checked_estimate(Estimate(poses, stamps))
        data = logs.estimate_files(estimate)["estimate.tum"]
        times, found = logs._from_tum(data, logs.shape_of(poses))
        assert np.array_equal(times, stamps)
        assert found.shape == poses.shape
        exact = (..., slice(None, -1), -1) if poses.ndim == 3 else ...
        assert np.array_equal(found[exact], poses[exact])
        assert np.abs(found - poses).max() < 2e-15


def test_the_world_depends_on_seed_and_scenario_alone(small):
    worlds = {e.world: logs.read_trial(e).truth.poses for e in logs.index(small).entries}
    assert len({x.tobytes() for x in worlds.values()}) == len(worlds) == 4


def test_the_protocol_has_all_that_is_needed_to_repeat_it(small):
    content = logs.read_protocol(small)
    assert content["versions"]["numpy"] == np.__version__
    assert content["seeds"] == [0, 1]
    assert content["scenarios"][1]["settings"] == {"steps": 40}
    assert content["systems"][0]["code"].endswith("benchmark_systems:straight")
    assert len(content["systems"][0]["source"]) == 64
    assert protocols.recorded(content) == Protocol()
    for name in ("align", "synchronization", "calibration", "failures", "statistic"):
        assert content["protocol"][name] == getattr(Protocol(), name)
    assert set(content["rules"]) == {
        "alignment",
        "synchronization",
        "failure",
        "aggregation",
        "splits",
    }
    assert "less than 90 % of the truth" in content["rules"]["failure"]
    assert "median over trials, 95 % intervals" in content["rules"]["aggregation"]


# --- Nothing gets out of a trial ----------------------------------------------------------------


FAILURES = {
    raises: ("raised", "ValueError: no fix for this log"),
    exits: ("raised", "SystemExit: 3"),
    interrupts: ("raised", "KeyboardInterrupt"),
    recurses: ("raised", "RecursionError: maximum recursion depth exceeded"),
    undefined: ("nonsense", "poses[3, 0, 2] is nan"),
    nothing: ("nonsense", "returned NoneType; expected an Estimate"),
    stretched: ("nonsense", "not a rotation"),
    backwards: ("nonsense", "stamps go back in time"),
    too_many: ("nonsense", "500 poses and no stamps"),
    negative: ("nonsense", "covariances[0] is not a covariance"),
    leaves: ("died", "exit code 3"),
    hangs: ("too slow", "still running after 8 s"),
}
if POSIX:
    FAILURES |= {
        asks: ("raised", "EOFError"),
        faults: ("died", "killed by SIGSEGV"),
        eats: ("out of memory", "MemoryError"),
    }
GOOD = [straight, chatters, lingers, wrecks] + ([forks] if POSIX else [])
LIMITS = Protocol(time_limit=8, memory_limit=1e9)


@pytest.fixture(scope="module")
def hostile(tmp_path_factory):
    """The folder of a benchmark of systems that do what they should not."""
    folder = tmp_path_factory.mktemp("hostile")
    systems = [System(f.__name__, f) for f in (hangs, *GOOD, *FAILURES) if f is not hangs]
    systems.insert(0, System("hangs", hangs))
    done = quietly(systems, DRIVE, 1, folder, protocol=LIMITS)
    assert (done.trials, done.failed) == (len(systems), len(FAILURES))
    return folder


@pytest.mark.parametrize("system", FAILURES, ids=lambda f: f.__name__)
def test_a_failure_is_recorded_with_its_reason(hostile, system):
    kind, reason = FAILURES[system]
    entry = entry_of(hostile, system.__name__)
    assert (entry.status, entry.kind) == ("failed", kind)
    assert reason in entry.reason
    assert "\n" not in entry.reason
    trial = logs.read_trial(entry)
    assert trial.estimate is None
    assert len(trial.truth.poses) == 21


@pytest.mark.parametrize("system", GOOD, ids=lambda f: f.__name__)
def test_what_a_system_does_besides_changes_nothing(hostile, system):
    expected = entry_of(hostile, "straight").path / "estimate.tum"
    found = entry_of(hostile, system.__name__).path / "estimate.tum"
    shift = 1.0 if system is wrecks else 0.0  # it moved its stamps
    times, poses = am.read_tum(found)
    assert np.array_equal(poses, am.read_tum(expected).poses)
    assert np.allclose(times - shift, am.read_tum(expected).stamps)


def test_only_the_end_of_the_output_is_kept(hostile):
    assert (entry_of(hostile, "chatters").path / "output.txt").stat().st_size == 4096
    assert (entry_of(hostile, "leaves").path / "output.txt").read_text().split() == [
        "last",
        "words",
    ]


def test_a_traceback_names_the_line(hostile):
    assert 'raise ValueError("no fix' in entry_of(hostile, "raises").detail


@pytest.mark.skipif(not LINUX, reason="only Linux lets a process adopt the orphans")
def test_a_daemon_is_ended_too(tmp_path):
    system = System("daemonizes", daemonizes, {"marker": str(tmp_path / "pid")})
    assert quietly(system, DRIVE, 1, tmp_path / "logs", protocol=LIMITS).failed == 0
    pid = int((tmp_path / "pid").read_text())
    assert not Path(f"/proc/{pid}").exists()


@pytest.mark.skipif(not POSIX, reason="needs fork")
def test_workers_of_a_killed_run_do_not_keep_the_folder(tmp_path):
    (tmp_path / logs.PROTOCOL).write_bytes(b"{}")
    mine, others = get_context("fork").Pipe()
    worker = get_context("fork").Process(target=lambda: (others.send("here"), time.sleep(60)))
    with logs.locked(tmp_path):
        worker.start()
        assert mine.recv() == "here"
        with pytest.raises(am.AmrError, match="another run"), logs.locked(tmp_path):
            pass
    try:
        with logs.locked(tmp_path):
            assert worker.is_alive()
    finally:
        worker.kill()
        worker.join()


def test_a_system_may_remove_its_folder(tmp_path):
    assert quietly(System("own_folder", own_folder), DRIVE, 1, tmp_path / "logs").failed == 0


def writes_where_results_go(log):
    import os

    os.makedirs("out/maps")
    for name in ("truth.tum", "outcome.json", "maps/map.txt"):
        with open(f"out/{name}", "w", encoding="utf-8") as file:
            file.write("mine")
    return straight(log)


def test_a_system_may_write_files_of_any_name_into_its_folder(tmp_path):
    system = System("writes", writes_where_results_go)
    assert quietly(system, DRIVE, 1, tmp_path / "logs").failed == 0


class Unsayable(Exception):
    def __str__(self):
        raise RuntimeError


def raises_what_cannot_be_said(log):
    raise Unsayable


def raises_bytes_and_codes(log):
    raise OSError("\x1b[31mno such file: m\udcff.bag\x00")


def one_number(log):
    return Estimate(5)


def test_the_order_of_seeds_is_no_decision():
    assert protocols.as_seeds((3, 1)) == protocols.as_seeds([1, 3]) == (1, 3)


def test_reasons_can_be_written_whatever_they_are(tmp_path):
    systems = [
        System(one.__name__, one)
        for one in (raises_what_cannot_be_said, raises_bytes_and_codes, one_number)
    ]
    quietly(systems, DRIVE, 1, tmp_path / "logs")
    said = {e.system: (e.kind, e.reason) for e in logs.index(tmp_path / "logs").entries}
    assert said == {
        "raises_what_cannot_be_said": (
            "raised",
            "Unsayable: its text cannot be had (RuntimeError)",
        ),
        "raises_bytes_and_codes": ("raised", "OSError: ?[31mno such file: m?.bag?"),
        "one_number": ("nonsense", "poses has 0 axes; expected (N, d+1, d+1)."),
    }


def test_nothing_is_left_in_the_temporary_folder(tmp_path, monkeypatch):
    monkeypatch.setattr(running.tempfile, "tempdir", str(tmp_path))
    with ThreadPoolExecutor(2) as other:
        quietly([STRAIGHT, System("leaves", leaves)], DRIVE, 2, tmp_path / "logs", executor=other)
    assert [path.name for path in tmp_path.iterdir()] == ["logs"]
    assert {path.name for path in (tmp_path / "logs").iterdir()} == {
        "protocol.json",
        "trials",
        "worlds",
    }


def test_without_fork_a_trial_runs_as_well(tmp_path):
    """As on Windows."""
    order = {"seed": 0, "time_limit": 60, "memory_limit": 1e9, "path": sys.path}
    Path(tmp_path, "order.json").write_text(json.dumps(order), encoding="utf-8")
    Path(tmp_path, "code").write_bytes(pickle.dumps((DRIVE, STRAIGHT)))
    program = (
        "import os\nif hasattr(os, 'fork'): del os.fork\n"
        f"from amrmetrics.benchmark import _child\n_child.main({str(tmp_path)!r})"
    )
    command = [sys.executable, "-c", program]
    environment = running._environment(str(tmp_path))
    with subprocess.Popen(command, stdin=subprocess.PIPE, env=environment) as process:
        assert process.wait(60) == 0
    assert json.loads((tmp_path / "out" / "outcome.json").read_bytes())["status"] == "ok"


def fails_to_make(rng):
    raise RuntimeError("no such world")


def test_a_world_that_cannot_be_made_is_a_failure_without_truth(tmp_path):
    done = quietly(STRAIGHT, Scenario("none", fails_to_make), 1, tmp_path)
    trial = logs.read_trial(logs.index(tmp_path).entries[0])
    assert (done.failed, trial.kind, trial.truth) == (1, "raised", None)
    assert "no such world" in trial.reason


def drifting(rng):
    return drive(np.random.default_rng())


def test_a_scenario_with_randomness_of_its_own_is_refused(tmp_path):
    systems = [STRAIGHT, System("noisy", noisy)]
    with pytest.raises(am.AmrError, match="another world of seed 0 than before"):
        quietly(systems, Scenario("drifting", drifting), 1, tmp_path)


# --- The same whatever runs it ------------------------------------------------------------------


class Backwards(Executor):
    """Runs what it was given in the opposite order, after a while."""

    def __init__(self):
        self.tasks = []

    def submit(self, function, *arguments):
        if not self.tasks:
            threading.Timer(0.3, self.work).start()
        self.tasks.append((Future(), function, arguments))
        return self.tasks[-1][0]

    def work(self):
        tasks, self.tasks = self.tasks[::-1], []
        with ThreadPoolExecutor(2) as pool:
            for future, result in [(f, pool.submit(g, *a)) for f, g, a in tasks]:
                future.set_result(result.result())


def test_a_process_pool_gives_the_same_bits(small, tmp_path):
    with ProcessPoolExecutor(2, get_context("spawn")) as pool:
        quietly(*SMALL, tmp_path, executor=pool)
    assert files_of(tmp_path) == files_of(small)


def test_the_order_of_the_trials_makes_no_difference(small, tmp_path):
    quietly(*SMALL, tmp_path, executor=Backwards())
    assert files_of(tmp_path) == files_of(small)


class Broken(Executor):
    """Loses every task."""

    def submit(self, function, *arguments):
        future = Future()
        future.set_exception(RuntimeError("a worker is gone"))
        return future


def test_a_broken_executor_is_no_failure_of_a_system(tmp_path):
    with pytest.raises(am.AmrError, match=r"the executor failed .RuntimeError: a worker is gone"):
        quietly(STRAIGHT, DRIVE, 1, tmp_path, executor=Broken())
    assert logs.index(tmp_path).entries[0].status == "missing"


DASK = """
import sys
sys.path.insert(0, {tests!r})
from distributed import Client, LocalCluster
from benchmark_systems import SMALL, quietly

if __name__ == "__main__":
    with {cluster} as cluster, Client(cluster) as client:
        client.wait_for_workers(2)
        print(quietly(*SMALL, {folder!r}, executor=client.get_executor()))
"""


def on_dask(folder, cluster):
    program = folder.parent / f"{folder.name}.py"
    tests = str(Path(__file__).parent)
    text = DASK.format(tests=tests, folder=str(folder), cluster=cluster)
    program.write_text(text, encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": tests}
    command = [sys.executable, str(program)]
    said = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120)
    assert "8 run now" in said.stdout, said.stderr


def test_a_local_dask_cluster_gives_the_same_bits(small, tmp_path):
    pytest.importorskip("distributed")
    cluster = "LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None)"
    on_dask(tmp_path / "logs", cluster)
    assert files_of(tmp_path / "logs") == files_of(small)


def test_a_dask_scheduler_and_its_workers_give_the_same_bits(small, tmp_path):
    """As on several machines, by the commands of the documentation."""
    pytest.importorskip("distributed")
    dask = [sys.executable, "-m", "dask"]
    file = tmp_path / "scheduler.json"
    options = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "cwd": tmp_path}
    scheduler = [*dask, "scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard"]
    worker = [*dask, "worker", "--scheduler-file", str(file), "--nthreads", "1", "--no-dashboard"]
    started = [subprocess.Popen([*scheduler, "--scheduler-file", str(file)], **options)]
    try:
        started += [subprocess.Popen(worker, **options) for _ in range(2)]
        while not file.exists():
            assert started[0].poll() is None
            time.sleep(0.05)
        address = json.loads(file.read_bytes())["address"]
        on_dask(tmp_path / "logs", f"__import__('contextlib').nullcontext({address!r})")
    finally:
        for process in started:
            process.terminate()
        for process in started:
            process.wait(20)
    assert files_of(tmp_path / "logs") == files_of(small)


# --- Killed, and on again -----------------------------------------------------------------------

KILLED = """
import os, sys
os.cpu_count = lambda: 2
sys.path.insert(0, {tests!r})
from benchmark_systems import MATRIX, quietly
quietly(*MATRIX, {folder!r})
"""


@pytest.mark.skipif(not POSIX, reason="kill -9")
def test_killed_ten_times_nothing_is_lost_and_nothing_done_twice(tmp_path):
    rng = np.random.default_rng(14)
    folder, scratch = tmp_path / "logs", tmp_path / "scratch"
    scratch.mkdir()
    program = KILLED.format(tests=str(Path(__file__).parent), folder=str(folder))
    seen = {}
    for _ in range(10):
        kill_at_random(program, folder, scratch, rng)
        for path in folder.glob(f"trials/*/*/*/{logs.TRIAL}"):
            state = (path.stat().st_ino, path.stat().st_mtime_ns)
            assert seen.setdefault(path, state) == state, f"{path} was done twice"
        assert all(path.exists() for path in seen), "lost"
    assert 10 <= len(seen) < 28
    done = quietly(*MATRIX, folder)
    assert (done.resumed, done.done) == (len(seen), 28 - len(seen))
    assert all((path.stat().st_ino, path.stat().st_mtime_ns) == seen[path] for path in seen)
    assert not (folder / logs.UNFINISHED).exists()
    assert not list(scratch.iterdir())
    quietly(*MATRIX, tmp_path / "at once")
    assert files_of(folder) == files_of(tmp_path / "at once")


def kill_at_random(program, folder, scratch, rng):
    """Start a run and kill it at a random moment after it has finished a trial."""
    before = len(list(folder.glob("trials/*/*/*")))
    environment = {**os.environ, "TMPDIR": str(scratch)}
    process = subprocess.Popen([sys.executable, "-c", program], env=environment)
    while len(list(folder.glob("trials/*/*/*"))) == before:
        assert process.poll() is None
        time.sleep(0.005)
    time.sleep(rng.uniform(0, 0.08))
    process.kill()
    process.wait()


def test_a_complete_folder_is_left_alone(copy):
    before = {path: path.stat().st_mtime_ns for path in copy.rglob("*")}
    done = quietly(*SMALL, copy)
    assert (done.done, done.resumed) == (0, 8)
    assert {path: path.stat().st_mtime_ns for path in copy.rglob("*")} == before


def test_what_was_damaged_is_repaired(copy, small):
    entry = entry_of(copy, "straight", 1)
    with open(entry.path / "estimate.tum", "ab") as file:
        file.write(b"1 2 3\n")
    (entry_of(copy, "noisy").world / "truth.npz").unlink()
    with pytest.raises(am.AmrError, match="not the file that was logged"):
        logs.read_trial(entry)
    assert quietly(*SMALL, copy).done == 3
    assert files_of(copy) == files_of(small)


def test_two_runs_at_a_time_are_refused(copy):
    with logs.locked(copy), pytest.raises(am.AmrError, match="another run is writing"):
        quietly(*SMALL, copy)


# --- No room, no permission ---------------------------------------------------------------------


@pytest.mark.parametrize("code", [errno.ENOSPC, errno.EACCES])
def test_a_full_disk_stops_with_one_clear_error(tmp_path, monkeypatch, small, code):
    write, count = logs._write, iter(range(100))

    def refuse(path, data):
        if next(count) > 12:
            write(path, data[: len(data) // 2])
            raise OSError(code, os.strerror(code), str(path))
        write(path, data)

    monkeypatch.setattr(logs, "_write", refuse)
    with pytest.raises(am.AmrError) as caught:
        quietly(*SMALL, tmp_path / "logs")
    kept = sum(e.status == "ok" for e in logs.index(tmp_path / "logs").entries)
    assert os.strerror(code) in str(caught.value)
    assert f"The {kept} trials that are complete are kept" in str(caught.value)
    assert 0 < kept < 8
    monkeypatch.undo()
    assert quietly(*SMALL, tmp_path / "logs").resumed == kept
    assert files_of(tmp_path / "logs") == files_of(small)


def test_a_file_that_may_not_grow_stops_the_run(tmp_path):
    """Writing the large estimate fails as on a full disk, in a process with such a limit."""
    pytest.importorskip("resource")
    program = f"""
import resource, sys
from concurrent.futures import ThreadPoolExecutor
sys.path.insert(0, {str(Path(__file__).parent)!r})
from benchmark_systems import STRAIGHT, Scenario, drive, quietly
resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, resource.RLIM_INFINITY))
scenarios = [Scenario("short", drive), Scenario("long", drive, {{"steps": 2000}})]
with ThreadPoolExecutor(1) as one:
    quietly(STRAIGHT, scenarios, 1, {str(tmp_path / "logs")!r}, executor=one)
"""
    command = [sys.executable, "-c", program]
    said = subprocess.run(command, capture_output=True, text=True).stderr
    assert "AmrError" in said
    assert "File too large" in said
    assert [e.status for e in logs.index(tmp_path / "logs").entries] == ["ok", "missing"]


def test_a_folder_that_cannot_be_made_is_one_clear_error(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(am.AmrError, match=r"cannot write the logs into .*file.logs"):
        quietly(STRAIGHT, DRIVE, 1, tmp_path / "file" / "logs")


# --- One folder, one protocol -------------------------------------------------------------------

OTHER = {
    "protocol.time_limit is 60.0 there and 5": {"protocol": Protocol(time_limit=5)},
    "seeds is [0, 1] there and [0, 1, 2] now.*optional stopping": {"seeds": 3},
    "systems.noisy is present there and missing now": {"systems": SMALL[0][:1]},
    "scenarios.long.settings.steps is 40 there and 41": {
        "scenarios": [DRIVE, Scenario("long", drive, {"steps": 41})]
    },
    "systems.straight.code": {"systems": [System("straight", noisy), *SMALL[0][1:]]},
    "scenarios.drive.split": {"scenarios": [Scenario("drive", drive, split="tuning"), SMALL[1][1]]},
}


@pytest.mark.parametrize("message", OTHER)
def test_another_protocol_is_refused_by_field(small, message):
    arguments = dict(zip(("systems", "scenarios", "seeds"), SMALL, strict=True))
    with pytest.raises(am.AmrError, match=message.replace("[", r"\[")):
        quietly(folder=small, **(arguments | OTHER[message]))


def test_another_version_is_refused(small, monkeypatch):
    monkeypatch.setattr(np, "__version__", "1.0")
    with pytest.raises(am.AmrError, match=r"versions.numpy is .* there and \"1.0\" now"):
        quietly(*SMALL, small)


def test_a_protocol_that_was_edited_is_refused(copy):
    path = copy / "protocol.json"
    path.write_text(path.read_text().replace('"rigid"', '"none"'))
    with pytest.raises(am.AmrError, match="not as it was written"):
        logs.index(copy)


def test_trials_of_another_protocol_are_refused(copy, tmp_path):
    quietly(STRAIGHT, DRIVE, 1, tmp_path / "other", protocol=Protocol(align="none"))
    shutil.rmtree(copy / "trials" / "drive" / "straight" / "000000")
    foreign = entry_of(tmp_path / "other", "straight").path
    shutil.copytree(foreign, copy / "trials" / "drive" / "straight" / "000000")
    with pytest.raises(am.AmrError, match="was logged under protocol"):
        logs.index(copy)


def test_folders_that_nobody_asked_for_are_named(copy):
    (copy / "trials" / "drive" / "straight" / "000009").mkdir()
    index = logs.index(copy)
    assert [Path(x).name for x in index.strangers] == ["000009"]
    assert len(index.entries) == 8


def test_a_folder_of_something_else_is_refused(tmp_path):
    with pytest.raises(am.AmrError, match=r"has no protocol.json"):
        logs.index(tmp_path)
    (tmp_path / "trials").mkdir()
    with pytest.raises(am.AmrError, match="nobody can tell how it came about"):
        quietly(STRAIGHT, DRIVE, 1, tmp_path)


WRONG = {
    "systems is empty": {"systems": []},
    r"systems\[0\] is function; expected a System": {"systems": [straight]},
    r"systems\[0\].name is 'a/b'": {"systems": System("a/b", straight)},
    "twice": {"systems": [System("A", straight), System("a", noisy)]},
    r"systems\[0\].run cannot be called": {"systems": System("a", 3)},
    "has the split 'train'": {"scenarios": Scenario("a", drive, split="train")},
    "the settings of system a cannot be written": {"systems": System("a", straight, {"x": drive})},
    "the settings of system b cannot be .*Out of range": {
        "systems": System("b", straight, {"x": np.inf})
    },
    r"seeds\[1\] is -1": {"seeds": [0, -1]},
    r"seeds\[0\] is 0.5": {"seeds": [0.5]},
    "seeds is empty": {"seeds": []},
    "seeds has a number twice": {"seeds": [1, 1]},
    "protocol is dict": {"protocol": {}},
    "executor is int": {"executor": 4},
    "protocol.align is 'best'": {"protocol": Protocol(align="best")},
    "protocol.time_limit is 0": {"protocol": Protocol(time_limit=0)},
    "protocol.minimum_coverage is 90": {"protocol": Protocol(minimum_coverage=90)},
    r"protocol.deltas is \(1, 's'\)": {"protocol": Protocol(deltas=(1, "s"))},
    r"protocol.deltas\[0\] has the unit 'km'": {"protocol": Protocol(deltas=((1, "km"),))},
    "protocol.metric is 'speed'": {"protocol": Protocol(metric="speed")},
    "protocol.confidence is 95": {"protocol": Protocol(confidence=95)},
    "cannot be sent to another process": {
        "systems": System("a", functools.partial(straight, threading.Lock()))
    },
}


@pytest.mark.parametrize("message", WRONG)
def test_wrong_arguments_are_refused(tmp_path, message):
    arguments = {"systems": STRAIGHT, "scenarios": DRIVE, "seeds": 1} | WRONG[message]
    with pytest.raises(am.AmrError, match=message):
        quietly(folder=tmp_path / "logs", **arguments)
    assert not (tmp_path / "logs").exists()


def test_without_cloudpickle_a_notebook_is_told_what_to_do(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "cloudpickle", None)
    with pytest.raises(am.AmrError, match=r"pip install 'amrmetrics\[benchmark\]'"):
        quietly(System("local", lambda log: straight(log)), DRIVE, 1, tmp_path)
    assert quietly(STRAIGHT, DRIVE, 1, tmp_path).failed == 0


def test_a_function_of_a_notebook_works(tmp_path):
    pytest.importorskip("cloudpickle")
    poses = np.tile(np.eye(3), (21, 1, 1))
    assert quietly(System("local", lambda log: Estimate(poses)), DRIVE, 1, tmp_path).failed == 0


def test_progress_is_one_line_of_standard_error(tmp_path, capsys):
    am.benchmark.run(STRAIGHT, DRIVE, 2, tmp_path)
    said = capsys.readouterr()
    assert not said.out
    assert "trial 2 of 2, 0 failed" in said.err


def test_a_run_says_what_it_did(hostile):
    done = running.Run("logs", 5, 2, 3, 1, {"died": 1})
    assert repr(done) == "5 trials: 2 run now, 3 complete before, 1 failed (1 died); logs in logs"
    assert done.as_dict()["kinds"] == {"died": 1}
