"""Check one submission: run the official checks on what the student's process hands over."""

import base64
import builtins
import contextlib
import functools
import io
import json
import os
import shutil
import socket
import tempfile
import time
import warnings
from pathlib import Path

from grading import notebooks, pages, wire

CELL_SECONDS = 10  # of processor time, of one cell or one call of a student's function
LONGER = 3  # times as long may it take by the clock: it may wait, or the machine may be busy
CHECK_SECONDS = 120  # of one check, with all calls of the student's functions
TOTAL_SECONDS = 300  # of a submission
MOST_STARTS = 12  # of students' processes
VERBS = ("sends", "hands", "asks", "has", "does")  # with which a `Gone` tells of the process
KEPT = 1500  # characters of a message


class Process:
    """A student's process, from its start to its end, and the line to it."""

    def __init__(self, zygote, order):
        here, there = socket.socketpair()
        self.control, control = socket.socketpair()
        socket.send_fds(zygote, [json.dumps(order).encode()], [there.fileno(), control.fileno()])
        there.close()
        control.close()
        self.peer = wire.Peer(here, self.answer)
        self.heard, self.calls = b"", None

    @functools.cached_property
    def about(self):
        """What the guard says of the process when it starts: its isolation and its number."""
        return self.line_with("level", 5)

    def line_with(self, name, seconds):
        """Return what the guard says in a line with this name in it; nothing if it says nothing."""
        self.control.settimeout(seconds)
        with contextlib.suppress(OSError):
            while name.encode() not in self.heard:
                part = self.control.recv(4096)
                if not part:
                    break
                self.heard += part
        for line in self.heard.splitlines():
            with contextlib.suppress(ValueError):
                if name in (said := json.loads(line)):
                    return said
        return {}

    def worked(self):
        """Return the seconds of processor time it has taken, as far as the system says them."""
        try:
            said = Path(f"/proc/{self.about['pid']}/stat").read_text()
            ticks = map(int, said.rpartition(")")[2].split()[11:15])  # its own, and its children's
            return sum(ticks) / os.sysconf("SC_CLK_TCK")
        except (OSError, ValueError, KeyError):
            return 0.0

    def limit(self, seconds, until):
        """Give the process so many seconds of work from now on, until then by the clock."""
        most = None

        def tired():
            nonlocal most
            most = self.worked() + seconds if most is None else most
            return self.worked() > most

        self.peer.tired, self.peer.deadline = tired, until

    def answer(self, asked):
        if asked.get("do") != "call" or asked.get("of") not in self.peer.own:
            raise wire.Gone("asks for what there is not")
        return self.peer.answer_call(self.peer.own[asked["of"]], asked)

    def ask(self, message, seconds):
        self.limit(seconds, time.monotonic() + LONGER * seconds)
        return self.peer.ask(message)

    def end(self):
        """End it, and return how it had ended, if it had."""
        code = self.line_with("exit", 0.3).get("exit")
        self.control.close()
        self.peer.line.close()
        return code


class Checker:
    """Goes through a submission's cells, in order, and checks each part where its check stands."""

    def __init__(self, material, zygote, order, say, done=()):
        self.material, self.zygote, self.order, self.say = material, zygote, order, say
        self.done = set(done)
        self.cell_seconds = (order or {}).get("cell_seconds", CELL_SECONDS)
        self.end_by = time.monotonic() + TOTAL_SECONDS
        self.ran = []  # what the student's process has done, but what ended it
        self.starts = 0
        self.sessions = {}
        self.forbidden = ()
        self.deadly = {}
        self.raised = {}

    # --- the student's processes ---

    def session(self, without=()):
        """Return the process without these functions of the library; start it where needed."""
        key = tuple(sorted(without))
        if key not in self.sessions:
            if self.starts >= MOST_STARTS:
                raise wire.Gone("has ended too often")
            self.starts += 1
            process = Process(self.zygote, self.order)
            self.sessions[key] = process
            for source in self.material.setup.values():
                process.ask({"do": "run", "source": source}, self.cell_seconds)
            if key:
                process.ask({"do": "take_away", "names": list(key)}, self.cell_seconds)
            for message in self.ran:  # it ended in time before; the machine may be busy now
                process.ask(message, 2 * self.cell_seconds)
        return self.sessions[key]

    def drop(self, key=None):
        """End processes; return how the first one had ended."""
        ended = [self.sessions.pop(k).end() for k in list(self.sessions) if key in (None, k)]
        return next((code for code in ended if code is not None), None)

    def run(self, source):
        """Run a cell; return what it raised. `Gone` if it ends or hangs the process."""
        if time.monotonic() > self.end_by:
            raise wire.Gone(f"the submission as a whole took more than {TOTAL_SECONDS} s")
        for key in list(self.sessions):
            if key:
                self.drop(key)  # it would have to run this cell, too
        message = {"do": "run", "source": source}
        try:
            said = self.session().ask(message, self.cell_seconds)
        except wire.Gone as gone:
            raise wire.Gone(self.how(gone, self.drop())) from None
        error = said.get("error")
        if error and "MemoryError" in error.get("kinds", ()):
            self.drop()  # what it holds would be missed by the cells after it
            raise wire.Gone("it took more memory than there is for a submission")
        self.ran.append(message)
        return error

    def restore(self):
        """Give what the set gives its values again, as a check cell does in the notebook."""
        running, message = self.sessions.get(()), {"do": "restore"}
        self.ran.append(message)
        try:
            if running:
                running.ask(message, self.cell_seconds)
        except wire.Gone:
            self.drop()

    def how(self, gone, code):
        said = str(gone)
        if said == "tired":
            return f"it was still running after {self.cell_seconds:g} s of processor time"
        if said == "slow":
            return f"it was still running after {LONGER * self.cell_seconds:g} s"
        if said == "ended":
            how = {None: "", -9: " (killed: SIGKILL, or out of memory)"}
            return f"it ended its process{how.get(code, f' (exit code {code})')}"
        return f"it {said}" if said.split(" ")[0] in VERBS else said

    # --- a part ---

    def check(self, part):
        """Return (points or None, what is said of it, and to the student if that differs)."""
        if part.broken:
            return None, part.broken, ""
        if part.name in self.deadly:
            return None, f"its cell could not be run: {self.deadly[part.name]}", ""
        error = self.judge(part, part.check)
        if error is None:
            return part.points, "", ""
        said = self.words(part, error)
        if isinstance(error, wire.Gone | MemoryError | OSError):
            return None, said, ""
        if not isinstance(error, AssertionError):  # the official answer passed this check
            self.say({"note": f"{part.name}: {said}. It counts as wrong: look at the answer"})
        shown = ""
        if part.check != part.shown_check:
            visible = self.judge(part, part.shown_check)
            if visible is None:
                shown = "passes the check of the exercise, and fails on data that only grading has."
            elif not isinstance(visible, wire.Gone):
                shown = self.words(part, visible)
        return 0, said, shown

    def words(self, part, error):
        raised = self.raised.get(part.name)
        first = f"The cell stops with {raised}. " if raised else ""
        if isinstance(error, AssertionError | wire.Gone):
            return (first + str(error))[:KEPT]
        return f"{first}the check stops with {type(error).__name__}: {error}"[:KEPT]

    def judge(self, part, source):
        """Return what the official check raises on the student's answers."""
        from amrmetrics.check import NotYet

        try:
            session = self.session()
            said = session.ask({"do": "names", "names": list(part.names)}, self.cell_seconds)
            values = said.get("values")
            if not isinstance(values, dict):
                raise wire.Gone("sends nonsense")
            values = self.with_folders(values, said.get("folders"))
            space = self.official()
            given = {n: values.get(n, ["dots"]) for n in part.names}
            answers = {n: self.called(session, n, given[n]) for n in part.names}
            if part.names and all(answer is ... for answer in answers.values()):
                raise NotYet("there is no answer yet.")
            space |= answers
            self.part_end = time.monotonic() + CHECK_SECONDS
            with self.quiet(), self.watched():
                exec(compile(source, part.check_id, "exec"), space)
        except wire.Gone as gone:
            return wire.Gone(self.how(gone, self.drop()))
        except (Exception, SystemExit, KeyboardInterrupt) as error:
            return error
        return None

    def with_folders(self, values, folders):
        """Return values that name folders here, in place of those of the student's process."""
        try:
            shutil.rmtree(self.order["handed"], ignore_errors=True)
            return wire.laid_out(values, folders, self.order["handed"])
        except (ValueError, TypeError, AttributeError, OSError):
            raise wire.Gone("hands over folders that cannot be read") from None

    def official(self):
        """Return a namespace in which the official setup has run: once, before the forks."""
        if not self.material.space:
            space = {"__name__": "__main__", "__builtins__": builtins}
            with self.quiet():
                for name, source in self.material.setup.items():
                    exec(compile(source, name, "exec"), space)
            self.material.space = space
        return dict(self.material.space)

    @contextlib.contextmanager
    def quiet(self):
        with (
            contextlib.chdir(self.material.data),
            contextlib.redirect_stdout(io.StringIO()),
            contextlib.redirect_stderr(io.StringIO()),
            warnings.catch_warnings(action="ignore"),
        ):
            yield

    @contextlib.contextmanager
    def watched(self):
        """Let the check's list of functions that must not be called reach the student's process."""
        from amrmetrics import check

        real = check._unavailable

        @contextlib.contextmanager
        def unavailable(forbidden, running=()):
            before, self.forbidden = self.forbidden, tuple(map(place_of, forbidden))
            try:
                yield
            finally:
                self.forbidden = before

        check._unavailable = unavailable
        try:
            yield
        finally:
            check._unavailable = real

    def called(self, session, name, data):
        """Return a value, or a function that is called in the student's process."""
        if not (isinstance(data, list) and data and data[0] == "call"):
            return session.peer.understood(data)

        def function(*arguments, **options):
            process = self.session(self.forbidden)
            number = data[1]
            if process is not session:
                there = process.ask({"do": "names", "names": [name]}, self.cell_seconds)["values"]
                if not (isinstance(there.get(name), list) and there[name][0] == "call"):
                    raise wire.Gone(f"does not define {name} without the library's function")
                number = there[name][1]
            files = files_in(arguments)
            if files:
                process.ask({"do": "files", "files": files}, self.cell_seconds)
            now = time.monotonic()
            until = min(now + LONGER * self.cell_seconds, self.part_end, self.end_by)
            process.limit(self.cell_seconds, until)
            try:
                return process.peer.call(number, arguments, options)
            except wire.Gone as gone:
                raise wire.Gone(self.how_slow(name, gone)) from None

        function.__name__ = function.__qualname__ = str(data[2]) or name
        # What the student has run so far says what the function does, wherever it is defined.
        function.__answer__ = "\n".join(m.get("source", "") for m in self.ran)
        return function

    def how_slow(self, name, gone):
        """Say that a call took too long, or all calls of the check together."""
        if str(gone) == "slow" and time.monotonic() >= min(self.part_end, self.end_by):
            return f"the check was still running after {CHECK_SECONDS} s, with calls of {name}"
        if str(gone) in ("slow", "tired"):
            return f"a call of {name}: {self.how(gone, None)}"
        return str(gone)

    # --- the whole ---

    def grade(self, submission):
        """Check every part and say each result as soon as it is there."""
        cells = [c for c in submission.cells if c.kind == "code"]
        stubs = {part.name: part.stub for part in self.material.parts.values()}
        last = {}
        for k, cell in enumerate(cells):
            part = self.material.by_check.get(cell.grade_id)
            if part:
                last[part.name] = max(last.get(part.name, 0), k)
            elif cell.grade_id in stubs:
                last[cell.grade_id] = max(last.get(cell.grade_id, 0), k)
        due = {}
        for name, k in last.items():
            due.setdefault(k, []).append(name)
        several = [n for n in stubs if sum(c.grade_id == n for c in cells) > 1]
        for k, cell in enumerate(cells):
            if cell.grade_id in self.material.setup:
                if not same_text(cell.source, self.material.setup[cell.grade_id]):
                    self.student_setup(cell)
            elif cell.grade_id not in self.material.by_check:
                copy = cell.grade_id in several and same_text(cell.source, stubs[cell.grade_id])
                if not copy and cell.source.strip():
                    self.student_cell(cell)
            for name in due.get(k, ()):
                self.one(self.material.parts[name], submission)
                self.restore()
        for part in self.material.parts.values():
            if part.name not in last and not part.by_hand:
                self.one(part, submission)
        self.drop()

    def one(self, part, submission):
        if part.name in self.done or part.by_hand:
            return
        self.say({"begin": part.name, "at": time.monotonic()})
        if not any(c.grade_id == part.name for c in submission.cells):
            why = "the file ends before it" if submission.cut_off else "its cell is missing"
            result = None, why, ""
        else:
            result = self.check(part)
        self.done.add(part.name)
        self.say({"part": part.name, "points": result[0], "said": result[1], "shown": result[2]})

    def student_setup(self, cell):
        for source in (cell.source, self.material.setup[cell.grade_id]):
            try:
                self.run(source)
            except wire.Gone as gone:
                self.say({"note": f"{cell.grade_id}, as edited, was left out: {gone}"})

    def student_cell(self, cell):
        name = cell.grade_id if cell.grade_id in self.material.parts else ""
        try:
            error = self.run(cell.source)
        except wire.Gone as gone:
            if name:
                self.deadly[name] = str(gone)
            self.say({"note": f"{name or 'a cell of its own'} was left out: {gone}"})
            return
        self.deadly.pop(name, None)
        self.raised.pop(name, None)
        if error and name:
            kinds = error.get("kinds") or ["an error"]
            text = " ".join(str(error.get("text", "")).split())[:200]
            self.raised[name] = f"{str(kinds[0])[:60]}: {text}".rstrip(": ")


def place_of(function):
    return f"{function.__module__}:{function.__qualname__}"


def same_text(a, b):
    return "\n".join(a.split()) == "\n".join(b.split())


def without_lines(text, known):
    """Return a text without the lines that were there before."""
    known = {line.strip() for line in known.splitlines() if line.strip()}
    return "\n".join(line for line in text.splitlines() if line.strip() not in known)


def files_in(arguments):
    """Return the files that a check made for the student's function to read."""
    found = {}
    temporary = os.path.realpath(tempfile.gettempdir())
    for a in arguments:
        if isinstance(a, str | Path) and os.path.isabs(a) and os.path.isfile(a):
            path = os.path.realpath(a)
            if path.startswith(temporary) and os.path.getsize(path) < wire.LARGEST // 4:
                found[str(a)] = base64.b64encode(Path(path).read_bytes()).decode()
    return found


def grade(data, material, zygote, order, say, done=()):
    """Read a notebook and check it; everything is told by `say`, piece by piece."""
    try:
        submission = notebooks.read(data)
    except notebooks.Unreadable as unreadable:
        say({"unreadable": str(unreadable)})
        return
    notes = submission.notes + notebooks.matched(submission, material)
    if not any(c.grade_id for c in submission.cells):
        say({"unreadable": "none of its cells belongs to this problem set"})
        return
    for name, part in material.parts.items():
        mine = [c for c in submission.cells if c.grade_id == name]
        if len(mine) > 1:
            notes.append(f"{len(mine)} cells for {name}: the last one with an answer counts")
        worked = [c for c in mine if not same_text(c.source, part.stub)]
        answer = (worked or mine or [notebooks.Cell("", "")])[-1].source
        say({"answer": name, "source": answer, "there": bool(mine), "touched": bool(worked)})
    checks = {name: part.shown_check for name, part in material.by_check.items()}
    edited = {
        c.grade_id
        for c in submission.cells
        if c.grade_id in checks and not same_text(c.source, checks[c.grade_id])
    }
    if edited:
        notes.append(f"edited, and replaced by the official one: {', '.join(sorted(edited))}")
    for c in submission.cells:
        if c.grade_id in material.setup and not same_text(c.source, material.setup[c.grade_id]):
            notes.append(f"{c.grade_id} is edited; checks use the official one")
    for note in notes + notebooks.suspicions(submission.cells, material):
        say({"note": note})
    Checker(material, zygote, order, say, done).grade(submission)
    say({"end": True})
    for name, part in material.parts.items():  # at the end: it may take long, and is no mark
        mine = [c for c in submission.cells if c.grade_id == name]
        worked = [c for c in mine if not same_text(c.source, part.stub)]
        if part.by_hand and worked:
            answer = worked[-1].source
            # A student's answer stands below the question, which need not be repeated.
            say({"html": name, "text": pages.prose(without_lines(answer, part.stub)[:20_000])})
