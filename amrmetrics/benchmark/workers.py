"""Measure many trials at once, in processes of their own, one world after the other.

The workers are started as programs: that works the same on every system, from a notebook and
from a script without a guard around its main part.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
import threading
import time
import traceback
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress

from amrmetrics.benchmark.running import SINGLE_THREAD
from amrmetrics.errors import AmrError

# Seconds that are worked alone first: what is done by then needs no other processes.
ALONE = 1.0
START = """
import sys
sys.path[:] = {path!r}
from amrmetrics.benchmark.workers import work
work()
"""


def measured(entries, decisions, first_seeds, jobs=None):
    """Return what `measuring.measure` finds of each entry, None where a trial has not run.

    Parameters
    ----------
    entries : list of TrialEntry
        Of any worlds.
    decisions : dict
        The fields of a `Protocol`.
    first_seeds : dict
        For each scenario the seed whose trajectories will be drawn.
    jobs : int, optional
        How many processes at most.
    """
    jobs = os.cpu_count() or 1 if jobs is None else jobs
    if not isinstance(jobs, int) or jobs < 1:
        raise AmrError(f"jobs is {jobs!r}; expected a whole number of processes, at least 1.")
    places = {}
    for k, entry in enumerate(entries):
        places.setdefault((entry.scenario, entry.seed), []).append(k)
    tasks = [
        ([entries[k] for k in place], decisions, first_seeds.get(scenario) == seed)
        for (scenario, seed), place in places.items()
    ]
    found = [None] * len(entries)
    for place, results in zip(places.values(), _all(tasks, jobs), strict=True):
        for k, result in zip(place, results, strict=True):
            found[k] = result
    return found


def _all(tasks, jobs):
    """Yield the results of the tasks in their order."""
    begin, done = time.perf_counter(), 0
    while done < len(tasks) and (jobs == 1 or time.perf_counter() - begin < ALONE):
        yield measure_world(*tasks[done])
        done += 1
    rest = tasks[done:]
    if not rest:
        return
    pool = _Workers(min(jobs, len(rest)))
    try:
        yield from pool.results(rest)
    finally:
        pool.close()


def measure_world(entries, decisions, traced):
    """Return what is found of the trials on one world."""
    from amrmetrics.benchmark import logs
    from amrmetrics.benchmark.measuring import measure

    found = []
    for entry in entries:
        if entry.status == "missing":
            found.append(None)
            continue
        try:
            trial = logs.read_trial(entry)
        except AmrError as error:
            name = f"{entry.scenario}/{entry.system}/{entry.seed}"
            raise AmrError(f"trial {name} cannot be evaluated: {error}") from None
        found.append(measure(trial, decisions, entry.split, traced))
    return found


class _Workers:
    """As many programs as there are threads here, each thread talking to its own."""

    def __init__(self, jobs):
        self._local = threading.local()
        self._programs = []
        self._threads = ThreadPoolExecutor(jobs)

    def results(self, tasks):
        return self._threads.map(self._ask, tasks)

    def _ask(self, task):
        program = getattr(self._local, "program", None) or self._start()
        try:
            pickle.dump(task, program.stdin)
            program.stdin.flush()
            result, error = pickle.load(program.stdout)
        except (OSError, EOFError, pickle.UnpicklingError):
            raise AmrError(
                "a process that evaluates trials has died, maybe for lack of memory. Try jobs=1."
            ) from None
        if error is not None:
            raise error
        return result

    def _start(self):
        # One thread each: there are as many processes as processors.
        environment = os.environ | SINGLE_THREAD
        program = subprocess.Popen(
            [sys.executable, "-c", START.format(path=sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=environment,
        )
        self._local.program = program
        self._programs.append(program)
        return program

    def close(self):
        self._threads.shutdown(wait=False, cancel_futures=True)
        for program in self._programs:
            program.kill()
        self._threads.shutdown()
        for program in self._programs:
            program.wait()
            with suppress(OSError):  # what it was still to be told, nobody reads any more
                program.stdin.close()
            program.stdout.close()


def work():
    """Answer tasks from the standard input until it ends; a worker runs this."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever is printed must not get between the answers
    while True:
        try:
            task = pickle.load(sys.stdin.buffer)
        except EOFError:
            return
        try:
            answer = measure_world(*task), None
        except AmrError as error:
            answer = None, error
        except Exception:
            answer = None, RuntimeError(traceback.format_exc())
        pickle.dump(answer, answers)
        answers.flush()
