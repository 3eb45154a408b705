"""Grade submissions: ``python -P -m grading.worker``, orders and answers are lines of JSON.

The worker imports the library, forks the zygotes of the students' processes, and only then reads
the solutions. Each submission is checked in a fork, so that whatever an answer does to a check
(memory, time) ends with it, and the next one begins with everything as it was. All forks begin
with what this one process has imported and proved.
"""

import base64
import contextlib
import gc
import json
import os
import pickle
import select
import shutil
import signal
import socket
import sys
import time
import types
from collections import deque
from pathlib import Path

from grading import checker, isolation, material, student

CHECKER_MEMORY = 6 << 30
STALLED = 300  # seconds in which a checker says nothing: a part may be checked twice
LEFT_OVER = 20  # seconds for what is no mark


class Lines:
    """Messages that arrive on a file descriptor, one a line."""

    def __init__(self, source):
        self.source, self.rest = source, b""

    def fileno(self):
        return self.source

    def read(self):
        """Return the messages that are there, or None when there will be no more."""
        part = os.read(self.source, 1 << 16)
        if not part:
            return None
        *lines, self.rest = (self.rest + part).split(b"\n")
        return [json.loads(line) for line in lines]


def main():
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    lines, tasks = Lines(0), []
    while not tasks:
        tasks = lines.read()
    begun = tasks.pop(0)
    student.preload()
    gc.freeze()  # forks share what they never change
    slots = [Slot(order) for order in begun["orders"]]
    level = tried(slots[0])
    for slot in slots:
        slot.level = level
    answer({"ready": level})
    STEPS.install()
    by_work()
    serve(lines, Path(begun["root"]), deque(tasks), slots)


def answer(said):
    sys.__stdout__.write(json.dumps(said) + "\n")
    sys.__stdout__.flush()


class Slot:
    """Where one submission at a time is checked: a user, a folder and a zygote of its own."""

    def __init__(self, order):
        self.order, self.attempt, self.level = order, None, None
        self.zygote, other = socket.socketpair()
        if os.fork() == 0:
            os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
            line = other.fileno()
            os.closerange(3, line)
            os.closerange(line + 1, 4096)
            student.zygote(other)
        other.close()


def tried(slot):
    """Start a student's process, and return how well it is isolated; raise if it does not work."""
    process = checker.Process(slot.zygote, slot.order)
    try:
        said = process.ask({"do": "run", "source": "x = 1"}, 60)
        if said.get("error"):
            raise RuntimeError(f"a student's process does not work: {said['error']}")
        return process.about["level"]
    except BaseException as gone:
        raise RuntimeError(f"a student's process cannot be started: {gone!r}") from None
    finally:
        process.end()


def serve(lines, root, tasks, slots):
    """Check what is asked, as many submissions at a time as there are slots; end with the input."""
    known = {}
    while True:
        for slot in slots:
            if slot.attempt is None and tasks:
                begin(slot, tasks.popleft(), root, known)
        busy = [slot.attempt for slot in slots if slot.attempt is not None]
        ready = select.select([lines, *busy], [], [], 1)[0]
        if lines in ready:
            asked = lines.read()
            if asked is None:
                for attempt in busy:
                    attempt.end()
                return
            tasks.extend(asked)
        for slot in slots:
            attempt = slot.attempt
            if attempt is None or not attempt.over(attempt in ready):
                continue
            slot.attempt = attempt.next()
            if slot.attempt is None:
                answer({"task": attempt.task["task"], **attempt.result})


def begin(slot, task, root, known):
    name = task["set"]
    try:
        if name not in known:
            loaded = material.load(root, name)
            solve(loaded)
            known[name] = loaded
        slot.attempt = Attempt(slot, task, known[name])
    except Exception as error:
        said = f"the grader stumbled: {type(error).__name__}: {error}"
        answer({"task": task["task"], "parts": {}, "answers": {}, "notes": [], "failed": said})


class Steps:
    """Verdicts on steps of derivations: each depends on the step alone, and takes its time.

    Forks inherit what is known before them, and hand back what they have found.
    """

    def __init__(self):
        self.known, self.found = {}, {}

    def install(self):
        from amrmetrics import derivation
        from amrmetrics.derivation import chain

        real = derivation.check_step

        def check_step(before, after, domains, relation="iff", unknown=None, seed=0):
            given = before, after, domains, relation, unknown, seed
            try:
                kinds = type(before), type(after)
                key = (kinds, before, after, tuple(dict(domains).items()), relation, unknown, seed)
                if key in self.known:
                    return self.known[key]
            except (TypeError, ValueError):
                return real(*given)
            verdict = real(*given)
            if verdict.status in ("proved", "sampled", "refuted"):  # not what time decided
                self.known[key] = self.found[key] = verdict
            return verdict

        derivation.check_step = chain.check_step = check_step

    def handed_back(self):
        """Return what was found since the last call, as text."""
        found, self.found = self.found, {}
        with contextlib.suppress(Exception):
            return base64.b64encode(pickle.dumps(found)).decode()
        return ""

    def take(self, text):
        with contextlib.suppress(Exception):
            self.known |= pickle.loads(base64.b64decode(text))


STEPS = Steps()


def by_work():
    """Let proofs have their seconds as processor time: a busy machine must not cost a mark."""
    from amrmetrics.derivation import checking, limits, searching

    clock = types.SimpleNamespace(monotonic=time.process_time)
    for module in (checking, limits, searching):
        module.time = clock


def solve(known):
    """Run the official solution: it proves the usual steps, and shows which checks hold."""
    own = checker.Checker(known, None, None, None)
    space = own.official()
    for part in known.parts.values():
        if part.by_hand:
            continue
        try:
            with own.quiet():
                exec(compile(known.answers[part.name], part.name, "exec"), space)
                exec(compile(part.check, part.check_id, "exec"), dict(space))
        except Exception as error:
            part.broken = f"the official solution fails its own check ({error})"


class Attempt:
    """A fork that checks a submission. If one part ends it, the next one checks the others."""

    def __init__(self, slot, task, known, before=None):
        self.slot, self.task, self.known = slot, task, known
        self.start = before.start if before else time.monotonic()
        self.result = before.result if before else {"parts": {}, "notes": [], "answers": {}}
        self.begun, self.ended, self.heard = None, False, time.monotonic()
        shutil.rmtree(slot.order["home"], ignore_errors=True)
        read, write = os.pipe()
        self.pid = os.fork()
        if self.pid == 0:
            with contextlib.suppress(BaseException):
                os.close(read)
                self.check(write)
            os._exit(0)
        os.close(write)
        self.lines = Lines(read)

    def fileno(self):
        return self.lines.source

    def check(self, write):
        """Check the submission and say what comes of it, in the fork."""
        os.setpgid(0, 0)
        nothing = os.open(os.devnull, os.O_RDWR)
        os.dup2(nothing, 0)
        os.dup2(2, 1)
        signal.signal(signal.SIGINT, signal.SIG_DFL)
        isolation.limit_checker(CHECKER_MEMORY)

        def say(said):
            if "part" in said and STEPS.found:
                said["steps"] = STEPS.handed_back()
            left = json.dumps(said).encode() + b"\n"
            while left:
                left = left[os.write(write, left) :]

        data = Path(self.task["file"]).read_bytes()
        order = {**self.slot.order, "data": str(self.known.data)}
        checker.grade(data, self.known, self.slot.zygote, order, say, tuple(self.result["parts"]))

    def over(self, ready):
        """Hear what is there, if there is something; tell whether the fork is done or silent."""
        now = time.monotonic()
        if not ready:
            return now > self.heard + (LEFT_OVER if self.ended else STALLED)
        self.heard = now
        said = self.lines.read()
        for message in said or ():
            self.take(message)
        return said is None

    def take(self, said):
        if "begin" in said:
            self.begun = said["begin"]
        elif "part" in said:
            STEPS.take(said.pop("steps", ""))
            self.result["parts"][said["part"]] = [said["points"], said["said"], said["shown"]]
        elif "note" in said:
            if said["note"] not in self.result["notes"]:
                self.result["notes"].append(said["note"])
        elif "answer" in said:
            kept = {name: said[name] for name in ("source", "there", "touched")}
            self.result["answers"][said["answer"]] = kept
        elif "html" in said:
            self.result["answers"][said["html"]]["html"] = said["text"]
        elif "unreadable" in said:
            self.result["unreadable"] = said["unreadable"]
            self.ended = True
        elif "end" in said:
            self.ended = True

    def end(self):
        os.close(self.lines.source)
        for kill in (os.killpg, os.kill):
            with contextlib.suppress(OSError):
                kill(self.pid, signal.SIGKILL)
        os.waitpid(self.pid, 0)
        if self.slot.level == "another user":  # where namespaces do not end what was left running
            isolation.end_all(self.slot.order["user"])

    def next(self):
        """End the fork; return the one that goes on, or None if the submission is done."""
        self.end()
        self.result["seconds"] = round(time.monotonic() - self.start, 2)
        if self.ended:
            return None
        parts = self.result["parts"]
        if self.begun is None or self.begun in parts:
            said = "the checker ended before any part: the file may be too large"
            self.result["failed"] = said
            return None
        parts[self.begun] = [None, "its check did not end, or took too much memory", ""]
        return Attempt(self.slot, self.task, self.known, self)


if __name__ == "__main__":
    main()
