"""The process in which one trial runs: ``python -m amrmetrics.benchmark._child FOLDER``.

Two processes where there is ``fork``. The first starts the second, waits no longer than the limit,
and ends it with all that it started; its standard input is the line to whoever wants the trial,
and when that is cut, it ends everything and cleans up. The second has limits, makes the world,
runs the system, and leaves its result in FOLDER. Where there is no ``fork``, one process does
without the first, and who started it has to watch the time.

In FOLDER stand ``code`` (pickled scenario and system), ``order.json``, and ``here``, in which the
system runs: what it writes there or removes is its own affair. What comes out is in
``out``: the files of the logs, ``made.json`` when the world is made, ``outcome.json`` at the end,
and ``ended.json`` by the first process.
"""

import contextlib
import json
import os
import random
import shutil
import signal
import sys
import threading
import time

POLL = 0.005  # seconds
SET_PARENT_DEATH_SIGNAL, SET_CHILD_SUBREAPER = 1, 36
LONGEST_REASON, LONGEST_DETAIL = 300, 2000


def main(folder):
    with open(os.path.join(folder, "order.json"), encoding="utf-8") as file:
        order = {**json.load(file), "folder": folder}
    os.mkdir(os.path.join(folder, "out"))
    if hasattr(os, "fork"):
        supervise(order)
    else:
        threading.Thread(target=end_when_unwanted, daemon=True).start()
        work(order)
        leave()


def end_when_unwanted():
    sys.stdin.buffer.read()
    os._exit(1)


def leave():
    """End at once, whatever threads and exit handlers a system left behind."""
    for stream in (sys.stdout, sys.stderr):
        with contextlib.suppress(Exception):
            stream.flush()
    os._exit(0)


# --- The first process --------------------------------------------------------------------------


def supervise(order):
    prctl(SET_CHILD_SUBREAPER, 1)  # a grandchild that lost its parent becomes a child
    parent = os.getpid()
    pid = os.fork()
    if pid == 0:
        os.setsid()
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        prctl(SET_PARENT_DEATH_SIGNAL, signal.SIGKILL)
        if os.getppid() == parent:
            limit(order["memory_limit"])
            work(order)
        leave()
    ended = wait(pid, order["time_limit"])
    kill_group(pid)
    kill_orphans()
    if ended is None:
        shutil.rmtree(order["folder"], ignore_errors=True)
    else:
        save(order, "ended.json", ended)


def prctl(option, value):
    """Set a property of this process; only Linux has these, and elsewhere nothing happens."""
    if sys.platform == "linux":
        import ctypes

        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None).prctl(option, value, 0, 0, 0)


def wait(pid, time_limit):
    """Return how a process ended, None if nobody wants to know any more."""
    import select

    deadline = time.monotonic() + time_limit
    slow = False
    while True:
        found, status, used = os.wait4(pid, os.WNOHANG)
        if found:
            scale = 1 if sys.platform == "darwin" else 1024  # of ru_maxrss
            code = os.waitstatus_to_exitcode(status)
            return {"exit": code, "slow": slow, "peak": scale * used.ru_maxrss}
        unwanted = select.select([sys.stdin], [], [], POLL)[0]
        slow = time.monotonic() > deadline
        if unwanted or slow:
            os.kill(pid, signal.SIGKILL)  # its group follows; before setsid it has none
        if unwanted:
            return None


def kill_group(pid):
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(pid, signal.SIGKILL)


def kill_orphans():
    """End what left the group. Their children become ours as they end, so ask until none is left.

    Without the right to adopt them (macOS) there is nothing to be found.
    """
    while True:
        for pid in children():
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        try:
            os.waitpid(-1, 0)
        except ChildProcessError:
            return


def children():
    """Yield the process ids of the children, as Linux lists them."""
    own = str(os.getpid())
    for name in os.listdir("/proc") if os.path.isdir("/proc/self") else ():
        with contextlib.suppress(OSError, ValueError):
            if name.isdigit():
                with open(f"/proc/{name}/stat", encoding="utf-8", errors="replace") as file:
                    parent = file.read().rpartition(")")[2].split()[1]
                if parent == own:
                    yield int(name)


# --- The second ---------------------------------------------------------------------------------


def limit(memory):
    """Hold this process to so many bytes of address space, and each file to as many."""
    import resource

    for name, value in (("RLIMIT_AS", memory), ("RLIMIT_FSIZE", memory), ("RLIMIT_CORE", 0)):
        kind = getattr(resource, name)
        _, hard = resource.getrlimit(kind)
        soft = int(value) if hard == resource.RLIM_INFINITY else min(int(value), hard)
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(kind, (soft, hard))


def unlimit():
    """Give room to write down that the memory ran out."""
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        _, hard = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(resource.RLIMIT_AS, (hard, hard))


def work(order):
    """Run the trial and write its outcome, whatever happens."""
    pid = os.getpid()
    try:
        outcome = trial(order)
    except BaseException as error:
        unlimit()
        outcome = failure(error, order)
    if os.getpid() != pid:  # the system forked, and this is the copy
        os._exit(0)
    save(order, "outcome.json", outcome)


class Setup(Exception):
    """The trial could not be run or written down; no fault of the system."""


class Nonsense(Exception):
    """The system returned something that is no estimate."""


def trial(order):
    """Return the outcome of a trial that did not raise."""
    scenario, system = load(order)
    import numpy as np

    from amrmetrics.benchmark import logs
    from amrmetrics.errors import AmrError

    random.seed(0)
    np.random.seed(0)  # noqa: NPY002 for systems that use it all the same
    log = make(scenario, order)
    start, used = time.perf_counter(), cpu_seconds()
    estimate = system.run(log, **system.settings)
    wall, cpu = time.perf_counter() - start, cpu_seconds() - used
    try:
        estimate = logs.checked_estimate(estimate, log.stamps)
    except AmrError as error:
        raise Nonsense(str(error)) from None
    for name, data in logs.estimate_files(estimate).items():
        write(order, name, data)
    write(order, logs.TIMES, logs.times_file(estimate.frame_seconds, wall, cpu))
    return {"status": "ok", **logs.shape_of(estimate.poses)}


def load(order):
    """Return scenario and system, with the modules of the process that sent them."""
    import pickle

    sys.path += [path for path in order["path"] if path not in sys.path]
    try:
        with open(os.path.join(order["folder"], "code"), "rb") as file:
            return pickle.load(file)
    except MemoryError:
        raise
    except Exception as error:
        raise Setup(
            f"cannot load the scenario or the system ({type(error).__name__}: {error}); its "
            "modules have to be there where the trial runs"
        ) from error


def make(scenario, order):
    """Make the world, write down the truth, and return what the system is given."""
    from zlib import crc32

    import numpy as np

    from amrmetrics.benchmark import logs
    from amrmetrics.benchmark.protocol import versions

    sequence = np.random.SeedSequence([order["seed"], crc32(scenario.name.encode())])
    log, truth = scenario.make(np.random.default_rng(sequence), **scenario.settings)
    for name, data in logs.truth_files(truth).items():
        write(order, name, data)
    made = {**logs.shape_of(truth.poses), "log": logs.digest_of_log(log), "versions": versions()}
    save(order, "made.json", made)
    return log


def cpu_seconds():
    """Return the computing time of this process and of those that it started and that ended."""
    return time.process_time() + sum(os.times()[2:4])


def failure(error, order):
    """Return the outcome of a trial that raised."""
    import traceback

    kind = {"MemoryError": "out of memory", "Setup": "setup", "Nonsense": "nonsense"}
    names = [c.__name__ for c in type(error).__mro__]
    kind = next((kind[name] for name in names if name in kind), "raised")
    said = one_line(error)
    own = kind in ("setup", "nonsense")
    reason = said if own else f"{type(error).__name__}: {said}".rstrip(": ")
    detail = "".join(traceback.format_exception(error)).replace(order["folder"], ".")
    return {
        "status": "failed",
        "kind": kind,
        "reason": reason[:LONGEST_REASON],
        "detail": detail[-LONGEST_DETAIL:],
    }


def one_line(error):
    """Return what an exception says, without what no file or terminal takes."""
    try:
        said = str(error)
    except Exception as why:  # its own __str__ raises
        said = f"its text cannot be had ({type(why).__name__})"
    said = " ".join(said.encode("utf-8", "replace").decode().split())
    return "".join(letter if letter.isprintable() else "?" for letter in said)


def write(order, name, data):
    try:
        with open(os.path.join(order["folder"], "out", name), "wb") as file:
            file.write(data)
    except OSError as error:
        raise Setup(f"cannot write into {order['folder']} ({error.strerror})") from error


def save(order, name, content):
    """Write a JSON file that is there as a whole or not at all."""
    write(order, name + ".part", json.dumps(content).encode())
    path = os.path.join(order["folder"], "out", name)
    os.replace(path + ".part", path)


if __name__ == "__main__":
    main(sys.argv[1])
