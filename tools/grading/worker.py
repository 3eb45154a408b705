"""Grade one submission after another: ``python -P -m grading.worker``, orders on standard input.

The worker imports the library, forks the zygote of the students' processes, and only then reads
the solutions. Each submission is checked in a fork, so that whatever an answer does to a check
(memory, time) ends with it, and the next one begins with everything as it was.
"""

import base64
import contextlib
import json
import os
import pickle
import select
import signal
import socket
import sys
import time
from pathlib import Path

from grading import checker, isolation, material, student

CHECKER_MEMORY = 6 << 30
STALLED = 200  # seconds in which a checker says nothing


def main():
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    first = json.loads(sys.stdin.readline())
    student.preload()
    zygote, other = socket.socketpair()
    if os.fork() == 0:
        zygote.close()
        os.close(0)
        os.open(os.devnull, os.O_RDONLY)
        student.zygote(other)
    other.close()
    level = tried(zygote, first["order"])
    answer({"ready": level})
    STEPS.install()
    known = {}
    for line in sys.stdin:
        task = json.loads(line)
        name = task["set"]
        try:
            if name not in known:
                loaded = material.load(Path(first["root"]), name)
                solve(loaded)
                known[name] = loaded
            order = {**first["order"], "data": str(known[name].data)}
            answer({"task": task["task"], **graded(task, known[name], zygote, order)})
        except Exception as error:
            said = f"the grader stumbled: {type(error).__name__}: {error}"
            answer({"task": task["task"], "parts": {}, "notes": [], "failed": said})


def answer(said):
    sys.__stdout__.write(json.dumps(said) + "\n")
    sys.__stdout__.flush()


def tried(zygote, order):
    """Start a student's process, and return how well it is isolated; raise if it does not work."""
    process = checker.Process(zygote, order)
    try:
        said = process.ask({"do": "run", "source": "x = 1"}, 60)
        if said.get("error"):
            raise RuntimeError(f"a student's process does not work: {said['error']}")
        process.control.settimeout(5)
        return json.loads(process.control.recv(4096).splitlines()[0])["level"]
    except BaseException as gone:
        raise RuntimeError(f"a student's process cannot be started: {gone!r}") from None
    finally:
        process.end()


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


def solve(known):
    """Run the official solution: it proves the usual steps, and shows that its own checks hold."""
    try:
        own = checker.Checker(known, None, None, None)
        space = own.official()
        with own.quiet():
            for part in known.parts.values():
                if not part.by_hand:
                    exec(compile(known.answers[part.name], part.name, "exec"), space)
                    exec(compile(part.check, part.check_id, "exec"), space)
    except Exception as error:
        raise ValueError(f"the official solution fails its own check: {error}") from error


def graded(task, known, zygote, order):
    """Check a submission in forks: one, and another one for the rest if a check ends the first."""
    data = Path(task["file"]).read_bytes()
    result = {"parts": {}, "notes": [], "answers": {}}
    done = {}
    start = time.monotonic()
    while True:
        begun, ended = attempt(data, known, zygote, order, result, done)
        if ended:
            break
        if begun is None or begun in done:
            result["failed"] = "the checker ended before any part: the file may be too large"
            break
        done[begun] = [None, "its check did not end, or took too much memory", ""]
        result["parts"][begun] = done[begun]
    result["seconds"] = round(time.monotonic() - start, 2)
    return result


def attempt(data, known, zygote, order, result, done):
    read, write = os.pipe()
    pid = os.fork()
    if pid == 0:
        with contextlib.suppress(BaseException):
            os.setpgid(0, 0)
            os.close(read)
            signal.signal(signal.SIGINT, signal.SIG_DFL)
            isolation.limit_checker(CHECKER_MEMORY)

            def say(said):
                if "part" in said and STEPS.found:
                    said["steps"] = STEPS.handed_back()
                left = json.dumps(said).encode() + b"\n"
                while left:
                    left = left[os.write(write, left) :]

            checker.grade(data, known, zygote, order, say, tuple(done))
        os._exit(0)
    os.close(write)
    begun, ended, rest = None, False, b""
    while True:
        if not select.select([read], [], [], 20 if ended else STALLED)[0]:
            break
        part = os.read(read, 1 << 16)
        if not part:
            break
        *lines, rest = (rest + part).split(b"\n")
        for line in lines:
            said = json.loads(line)
            if "begin" in said:
                begun = said["begin"]
            elif "part" in said:
                STEPS.take(said.pop("steps", ""))
                done[said["part"]] = [said["points"], said["said"], said["shown"]]
                result["parts"][said["part"]] = done[said["part"]]
            elif "note" in said:
                if said["note"] not in result["notes"]:
                    result["notes"].append(said["note"])
            elif "answer" in said:
                result["answers"][said["answer"]] = {
                    k: said[k] for k in ("source", "there", "touched")
                }
            elif "html" in said:
                result["answers"][said["html"]]["html"] = said["text"]
            elif "unreadable" in said:
                result["unreadable"] = said["unreadable"]
                ended = True
            elif "end" in said:
                ended = True
    os.close(read)
    with contextlib.suppress(OSError):
        os.killpg(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
    return begun, ended


if __name__ == "__main__":
    main()
