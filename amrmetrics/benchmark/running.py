"""Run every system on every scenario at every seed, each trial in a process of its own."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from concurrent.futures import FIRST_COMPLETED, Executor, ThreadPoolExecutor, wait
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING
from uuid import uuid4

from amrmetrics._results import Result
from amrmetrics.benchmark import logs
from amrmetrics.benchmark import protocol as protocols
from amrmetrics.benchmark.data import Protocol, Scenario, System
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from collections.abc import Iterable

    from amrmetrics._types import Path

DEFAULT = Protocol()
# Trials that are with the executor at a time: enough for many machines, and little to hold.
WINDOW = 256
# What is kept of all that a system prints, bytes.
OUTPUT_KEPT = 4096
# Seconds after the time limit until the process that watches it is thought dead itself.
GRACE = 30
# What a trial leaves in "out". A system's own files are elsewhere: in "here", where it runs.
LEFT = ("truth.tum", "truth.npz", "estimate.tum", "estimate.npz", logs.TIMES)
LEFT += ("made.json", "outcome.json", "ended.json")
# Bytes of a temporary folder with less of which a trial cannot write what it found.
LEAST_ROOM = 1 << 20
NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EACCES, errno.EPERM, errno.EROFS)
SINGLE_THREAD = dict.fromkeys(
    (
        "OMP_NUM_THREADS",
        "OPENBLAS_NUM_THREADS",
        "MKL_NUM_THREADS",
        "BLIS_NUM_THREADS",
        "VECLIB_MAXIMUM_THREADS",
        "NUMEXPR_NUM_THREADS",
        "NUMBA_NUM_THREADS",
    ),
    "1",
)
REPEATABLE = {
    **SINGLE_THREAD,
    "PYTHONHASHSEED": "0",
    "PYTHONUNBUFFERED": "1",
    "PYTHONFAULTHANDLER": "1",
    "MPLBACKEND": "Agg",
}


@dataclass(frozen=True, repr=False)
class Run(Result):
    """What `run` did.

    Attributes
    ----------
    folder : str
        Where the logs are.
    trials : int
        Of the whole protocol; all of them are logged.
    done : int
        Trials that ran now.
    resumed : int
        Trials that were complete already and were left alone.
    failed : int
        Failed ones among all.
    kinds : dict
        How many failed in which way.
    """

    folder: str
    trials: int
    done: int
    resumed: int
    failed: int
    kinds: dict

    def __repr__(self):
        kinds = ", ".join(f"{n} {kind}" for kind, n in self.kinds.items())
        return (
            f"{self.trials} trials: {self.done} run now, {self.resumed} complete before, "
            f"{self.failed} failed{f' ({kinds})' if kinds else ''}; logs in {self.folder}"
        )


def run(
    systems: System | Iterable[System],
    scenarios: Scenario | Iterable[Scenario],
    seeds: int | Iterable[int],
    folder: Path,
    executor: Executor | None = None,
    progress: bool = True,
    *,
    protocol: Protocol = DEFAULT,
) -> Run:
    """Run every system on every scenario at every seed, and log what happens.

    A trial runs in a process of its own, with a time limit, in a folder that is thrown away. If
    it raises, hangs, dies, takes too much memory or returns nonsense, that is recorded as a
    failure with its reason, and the others go on. A run that was killed is resumed by the same
    call: trials that are complete are left alone.

    Parameters
    ----------
    systems : System or sequence of System
        What is compared, each with a name of its own.
    scenarios : Scenario or sequence of Scenario
        The worlds, each with a name of its own.
    seeds : int or sequence of int
        Of the repetitions; n stands for 0 ... n-1. They are fixed before the first trial.
    folder : str or Path
        For the logs; made if it is not there.
    executor : concurrent.futures.Executor, optional
        What the trials are handed to: a pool of processes or threads,
        ``dask.distributed.Client(...).get_executor()``, ``mpi4py.futures.MPIPoolExecutor()``.
        It is not shut down. By default as many processes run as there are cores. Whatever it is
        and in whatever order trials end, the logs are the same to the bit, measured times aside.
    progress : bool
        Write one line about how far it is to the standard error stream.
    protocol : Protocol
        Decisions taken before the first trial; `folder` remembers them.

    Returns
    -------
    Run
        How many trials ran now, were there before, and failed.

    Raises
    ------
    AmrError
        If the folder was begun under another protocol (the message names the field), cannot be
        written (what is complete is kept), or a trial cannot be started at all.

    References
    ----------
    Lecture 10. What is protected on which operating system: `amrmetrics.benchmark`.

    Examples
    --------
    >>> import tempfile
    >>> import amrmetrics as am
    >>> systems, scenarios = am.benchmark.systems()[:1], am.benchmark.scenarios()[:1]
    >>> am.benchmark.run(systems, scenarios, 1, tempfile.mkdtemp(), progress=False).failed
    0
    """
    systems, scenarios = protocols.as_systems(systems), protocols.as_scenarios(scenarios)
    seeds, protocol = protocols.as_seeds(seeds), protocols.as_protocol(protocol)
    if executor is not None and not hasattr(executor, "submit"):
        raise AmrError(f"executor is {type(executor).__name__}; expected one with submit().")
    codes = _pickled(systems, scenarios)
    content = protocols.written(systems, scenarios, seeds, protocol)
    folder = pathlib.Path(folder)
    with said_clearly(folder):
        content = logs.begin(folder, content, protocols.refuse_other)
        with logs.locked(folder), logs.without_unfinished(folder):
            return _run(folder, content, codes, protocol, executor, progress)


@contextlib.contextmanager
def said_clearly(folder):
    """Turn what the operating system refuses into one sentence that says what to do."""
    try:
        yield
    except OSError as error:
        done = len(list(folder.glob(f"trials/*/*/*/{logs.TRIAL}"))) if folder.is_dir() else 0
        kept = f"The {done} trials that are complete are kept" if done else "No trial is complete"
        raise AmrError(
            f"cannot write the logs into {folder}: {error.strerror or error}"
            f"{f' ({error.filename})' if error.filename else ''}. {kept}, and nothing half-written "
            "counts. Make room or get the permission, and make the same call again: it goes on "
            "from there."
        ) from error


def _pickled(systems, scenarios):
    """Return the bytes that stand for each (scenario, system)."""
    try:
        import cloudpickle as pickler
    except ImportError:
        pickler = pickle
    return {
        (scenario.name, system.name): _dumps(pickler, scenario, system)
        for scenario in scenarios
        for system in systems
    }


def _dumps(pickler, scenario, system):
    if pickler is pickle:
        for what, function in ((scenario, scenario.make), (system, system.run)):
            if getattr(function, "__module__", None) == "__main__":
                _refuse_pickle(what, "it is defined in a notebook or script")
    for what in (scenario, system):
        try:
            pickler.dumps(what)
        except Exception as error:
            _refuse_pickle(what, error)
    return pickler.dumps((scenario, system))


def _refuse_pickle(what, why):
    raise AmrError(
        f"{type(what).__name__} {what.name} cannot be sent to another process: {why}. Install the "
        "package cloudpickle (pip install 'amrmetrics[benchmark]'), or put the function into a "
        "module of its own, and leave open files, locks and the like out of it."
    ) from (why if isinstance(why, Exception) else None)


def _run(folder, content, codes, protocol, executor, progress):
    entries = logs.index(folder).entries
    missing = _to_be_run(entries)
    line = _Progress(len(entries), len(entries) - len(missing), progress)
    own = None if executor is not None else _Processes(os.cpu_count() or 1)
    # In the folder of the logs a killed run's leftovers are found again; other machines have none.
    home = str(folder.resolve() / logs.UNFINISHED) if own else ""
    name = uuid4().hex
    jobs = (
        (entry, codes[entry.scenario, entry.system], _order(entry, protocol)) for entry in missing
    )
    try:
        for entry, result in _results(executor or own, jobs, name, home):
            line.add(_record(folder, content, entry, result))
    finally:
        line.close()
        if own:
            own.stop(name)
    kinds = Counter(e.kind for e in logs.index(folder).entries if e.status == "failed")
    done = len(missing)
    failed = sum(kinds.values())
    return Run(str(folder), len(entries), done, len(entries) - done, failed, dict(kinds))


def _to_be_run(entries):
    """Return the trials that are missing or damaged, and make room for their worlds."""
    found = {e for e in entries if e.status == "missing" or not logs.is_intact(e)}
    worlds = {e.world: e for e in entries if e.world.exists()}
    for world, entry in worlds.items():
        if not logs.has_intact_world(entry):
            shutil.rmtree(world)
    found |= {e for e in entries if e.status == "ok" and not e.world.exists()}
    return [e for e in entries if e in found]


def _order(entry, protocol):
    order = {
        "seed": entry.seed,
        "time_limit": protocol.time_limit,
        "memory_limit": protocol.memory_limit,
        "path": [os.path.abspath(path) for path in sys.path],
    }
    return json.dumps(order)


def _results(executor, jobs, name, home):
    """Yield (entry, result) in the order in which trials end."""
    pending = {}
    try:
        while True:
            for entry, code, order in islice(jobs, WINDOW - len(pending)):
                pending[executor.submit(trial, code, order, name, home)] = entry
            if not pending:
                return
            for future in wait(pending, return_when=FIRST_COMPLETED).done:
                yield pending.pop(future), _result(future)
    finally:
        for future in pending:
            future.cancel()


def _result(future):
    try:
        return future.result()
    except Exception as error:
        if getattr(error, "errno", None) in NO_ROOM:
            raise
        raise AmrError(
            f"the executor failed ({type(error).__name__}: {error}). What is complete is kept; "
            "make the same call again. In a script, a pool of processes needs: "
            "if __name__ == '__main__'."
        ) from error


class _Processes(ThreadPoolExecutor):
    """A pool of processes: each trial starts one, and a thread waits for its end.

    A ProcessPoolExecutor does as well, but has a second process wait in place of a thread, needs
    ``if __name__ == "__main__"`` in scripts, and leaves its processes behind when it is killed.
    """

    def stop(self, name):
        """End the trials of a run that was given up."""
        for process in list(_started.get(name, ())):
            with contextlib.suppress(OSError):
                process.stdin.close()
        self.shutdown(cancel_futures=True)
        _started.pop(name, None)


_started: dict[str, set] = {}


class _Progress:
    """One line on the standard error stream."""

    def __init__(self, total, before, wanted):
        self.total, self.count, self.failed = total, before, 0
        self.wanted, self.start, self.shown = wanted, time.monotonic(), 0.0

    def add(self, status):
        self.count += 1
        self.failed += status == "failed"
        if self.wanted and (time.monotonic() - self.shown > 0.5 or self.count == self.total):
            self.shown = time.monotonic()
            seconds = self.shown - self.start
            line = f"\rtrial {self.count} of {self.total}, {self.failed} failed, {seconds:.0f} s"
            print(line, end="", file=sys.stderr, flush=True)

    def close(self):
        if self.wanted and self.shown:
            print(file=sys.stderr)


# --- What comes back is written by one process, the one that called `run` ------------------------


def _record(folder, content, entry, result):
    """Log a trial that has ended; return its status."""
    outcome, files = result["outcome"], result["files"]
    if outcome["kind"] == "setup":
        raise AmrError(
            f"the trial of {entry.system} on {entry.scenario} could not be run on "
            f"{result['machine']}: {outcome['reason']}. What is complete is kept; make the same "
            "call again when that is mended."
        )
    if result["made"]:
        _record_world(folder, content, entry, result)
    kept = {name: files[name] for name in ("estimate.tum", "estimate.npz") if name in files}
    if outcome["status"] != "ok":
        kept = {}
    said = {
        "system": entry.system,
        "scenario": entry.scenario,
        "seed": entry.seed,
        "protocol": content["digest"],
        **outcome,
    }
    measured = {name: files[name] for name in (logs.TIMES, logs.OUTPUT) if name in files}
    logs.put_folder(folder, entry.path, measured | logs.with_digests(kept, logs.TRIAL, said))
    return outcome["status"]


def _record_world(folder, content, entry, result):
    """Write the truth when the first system has been there, and compare it from then on."""
    made = dict(result["made"])
    _refuse_versions(made.pop("versions"), content["versions"], result["machine"])
    files = {name: result["files"][name] for name in ("truth.tum", "truth.npz")}
    said = {
        "scenario": entry.scenario,
        "seed": entry.seed,
        "protocol": content["digest"],
        **made,
    }
    there = logs.read_sealed(entry.world / logs.WORLD)
    files = logs.with_digests(files, logs.WORLD, said)
    if there is None:
        logs.put_folder(folder, entry.world, files)
    elif logs.sealed(there) != files[logs.WORLD]:
        raise AmrError(
            f"scenario {entry.scenario} made another world of seed {entry.seed} than before: its "
            "function takes something random from elsewhere than its argument rng (or machines "
            f"differ; the last was {result['machine']}). Systems could not be compared on it."
        )


def _refuse_versions(found, expected, machine):
    for name, version in expected.items():
        if found[name] != version:
            raise AmrError(
                f"{machine} has {name} {found[name]}, and the protocol was begun with {version}. "
                "Results would not be repeatable to the bit; install the same on all machines."
            )


# --- What an executor runs ----------------------------------------------------------------------


def trial(code: bytes, order: str, run: str = "", home: str = "") -> dict:
    """Run one trial in a process of its own and return its files; arguments are plain bytes.

    Parameters
    ----------
    code : bytes
        Pickled scenario and system.
    order : str
        Seed and limits, in JSON.
    run : str
        Name of the run that wants it.
    home : str
        Folder for the trial's own folder; the system's one for temporary files if empty.

    Returns
    -------
    dict
        "files" (name to bytes), "outcome", "made" (of the world, or None), "machine".
    """
    scratch = os.path.realpath(tempfile.mkdtemp(prefix="amrmetrics-", dir=home or None))
    try:
        pathlib.Path(scratch, "here").mkdir()
        pathlib.Path(scratch, "code").write_bytes(code)
        pathlib.Path(scratch, "order.json").write_text(order, encoding="utf-8")
        output, gave_up = _in_a_process(scratch, json.loads(order)["time_limit"], run)
        _refuse_full_disk(scratch)
        return _collected(pathlib.Path(scratch, "out"), json.loads(order), output, gave_up)
    finally:
        shutil.rmtree(scratch, ignore_errors=True)


def _refuse_full_disk(scratch):
    """Do not blame the system when the trial could not write down how it ended."""
    ended = os.path.exists(os.path.join(scratch, "out", "ended.json"))
    if not ended and shutil.disk_usage(os.path.dirname(scratch)).free < LEAST_ROOM:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), os.path.dirname(scratch))


def _in_a_process(scratch, time_limit, run):
    """Start the process, wait for it, and return the end of its output, and if it was too slow."""
    here = os.path.join(scratch, "here")
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", "amrmetrics.benchmark._child", scratch],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        bufsize=0,
        cwd=here,
        env=_environment(here),
        start_new_session=True,
    )
    running = _started.setdefault(run, set())
    running.add(process)
    output = bytearray()
    reader = threading.Thread(target=_keep_the_end, args=(process.stdout, output), daemon=True)
    reader.start()
    try:
        process.wait(time_limit + (GRACE if hasattr(os, "fork") else 0))
        gave_up = False
    except subprocess.TimeoutExpired:
        gave_up = True
    finally:
        running.discard(process)
        _kill(process)
        reader.join(GRACE)
        process.stdin.close()
        process.stdout.close()
    return bytes(output), gave_up


def _environment(here):
    package = str(pathlib.Path(__file__).resolve().parents[2])
    path = os.pathsep.join([package, *filter(None, [os.environ.get("PYTHONPATH")])])
    temporary = dict.fromkeys(("TMPDIR", "TEMP", "TMP"), here)
    return {**os.environ, **REPEATABLE, **temporary, "PYTHONPATH": path}


def _keep_the_end(stream, output):
    """Read a stream to its end and keep the last of it."""
    with contextlib.suppress(OSError, ValueError):
        while data := stream.read(1 << 16):
            output += data
            del output[:-OUTPUT_KEPT]


def _kill(process):
    """End a process with its group; after its own end there is nothing left to do."""
    if process.poll() is None and os.name == "nt":
        command = ["taskkill", "/F", "/T", "/PID", str(process.pid)]
        subprocess.run(command, capture_output=True, check=False)
    elif process.poll() is None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def _collected(out, order, output, gave_up):
    """Return the files that a trial left and how it ended."""
    files = {name: (out / name).read_bytes() for name in LEFT if (out / name).is_file()}
    ended, outcome, made = (
        json.loads(files.pop(name, b"null")) for name in ("ended.json", "outcome.json", "made.json")
    )
    ended = ended or {"slow": gave_up, "exit": None, "peak": None}
    if ended["slow"] or outcome is None:
        outcome = _abrupt_end(ended, order)
    outcome = {"kind": "", "reason": "", "detail": "", **outcome}
    if output:
        files[logs.OUTPUT] = output
    if ended["peak"] is not None:
        files[logs.TIMES] = logs.with_peak(files.get(logs.TIMES), ended["peak"])
    return {"files": files, "outcome": outcome, "made": made, "machine": _machine()}


def _machine():
    import platform

    return platform.node() or "this machine"


def _abrupt_end(ended, order):
    """Return the outcome of a trial that wrote none."""
    if ended["slow"]:
        limit = f"{order['time_limit']:g} s"
        return {"status": "failed", "kind": "too slow", "reason": f"still running after {limit}"}
    code = ended["exit"]
    if code is None:
        how = "its process vanished"
    elif code < 0:
        how = f"its process was killed by {_signal_name(-code)}"
    else:
        how = f"its process ended with exit code {code} and without a result"
    return {"status": "failed", "kind": "died", "reason": how}


def _signal_name(number):
    try:
        name = signal.Signals(number).name
    except ValueError:
        return f"signal {number}"
    often = {"SIGKILL": ", as the system does when memory runs out", "SIGSEGV": ", a memory fault"}
    return name + often.get(name, "")
