"""Grade what a class handed in: ``python3 course.py grade SUBMITTED [--out DIR] [--jobs N]``.

SUBMITTED is a folder {student}/{NN_name}/{NN_name}.ipynb, a flat folder, a zip file of Moodle or
Canvas, or a folder of such. In DIR (build/grades) appear grades.csv, summary.html, prose.html and
feedback/. A run that was stopped goes on where it was. Nothing here runs a student's code: see
`grading`.
"""

import argparse
import contextlib
import csv
import hashlib
import json
import os
import re
import select
import shutil
import signal
import stat
import subprocess
import sys
import tempfile
import time
from collections import Counter, deque
from pathlib import Path

from grading import collecting, isolation, material, notebooks, pages

ROOT = Path(__file__).resolve().parents[1]
START_SECONDS = 300
LIMITS = {"memory": 2 << 30, "processes": 64, "seconds": 400}


class Stopped(Exception):
    """The worker has ended."""


class Worker:
    """The process that checks submissions, so many at a time."""

    def __init__(self, run, jobs, cell_seconds):
        self.run, self.jobs, self.cell_seconds = run, jobs, cell_seconds
        self.process = None

    def start(self):
        """Start it, and return how well submissions are isolated."""
        first = isolation.FIRST_USER + os.getpid() % 500 * 10
        orders = [
            {
                "data": str(self.run / "empty"),
                "root": str(self.run / "root"),
                "home": str(self.run / "homes" / str(slot)),
                "handed": str(self.run / "handed" / str(slot)),
                "hidden": [str(ROOT), str(self.run)],
                "user": first + slot % 10,
                "limits": LIMITS,
                "cell_seconds": self.cell_seconds,
            }
            for slot in range(self.jobs)
        ]
        path = [str(self.run / "library"), str(self.run / "tools")]
        environment = {
            **os.environ,
            "PYTHONPATH": os.pathsep.join(path),
            "OPENBLAS_NUM_THREADS": "1",
            "OMP_NUM_THREADS": "1",
            "MPLBACKEND": "Agg",
            "MPLCONFIGDIR": str(self.run / "matplotlib"),
            "IPYTHONDIR": str(self.run / "ipython"),
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        with (self.run / "worker.log").open("ab") as log:
            self.process = subprocess.Popen(
                [sys.executable, "-P", "-m", "grading.worker"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=log,
                bufsize=0,
                env=environment,
                cwd=self.run / "empty",
                start_new_session=True,
            )
        self.rest = b""
        self.tell({"root": str(self.run / "course"), "orders": orders})
        said = self.hear(START_SECONDS)
        if said is None:
            raise Stopped("it is silent")
        return said["ready"]

    def tell(self, said):
        try:
            self.process.stdin.write(json.dumps(said).encode() + b"\n")
        except OSError as error:
            raise Stopped(str(error)) from None

    def hear(self, seconds):
        """Return what it says next, or None if it says nothing for so long."""
        end = time.monotonic() + seconds
        while b"\n" not in self.rest:
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
                return None
            part = self.process.stdout.read(1 << 16)
            if not part:
                raise Stopped("it has ended")
            self.rest += part
        line, _, self.rest = self.rest.partition(b"\n")
        return json.loads(line)

    def end(self):
        """Close its input, at which it ends; it takes with it what it has started."""
        if self.process is None:
            return
        with contextlib.suppress(OSError):
            self.process.stdin.close()
        try:
            self.process.wait(5)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()
        self.process = None


class Grading:
    """One run: what was found, what is graded, and what is written."""

    def __init__(self, found, out, jobs, run, cell_seconds):
        self.found, self.out, self.jobs, self.run = found, out, jobs, run
        self.worker = Worker(run, jobs, cell_seconds)
        self.materials, self.versions = {}, {}
        self.records = {}
        self.level = None
        self.shown = None

    def go(self):
        for name in sorted({entry.set for entry in self.found if entry.set}):
            self.know(name)
        waiting = deque(enumerate(self.found))
        asked, again = {}, deque()  # what the worker has, and what a worker has ended with
        try:
            while waiting or asked or again:
                self.progress()
                try:
                    self.hand_out(waiting, asked, again)
                    said = self.worker.hear(0.5) if asked else None
                except Stopped as stopped:
                    self.stopped(stopped, asked, again)
                    continue
                if said:
                    task = asked.pop(said.pop("task"))
                    self.graded(*task[:3], said)
        finally:
            self.worker.end()
            self.progress(last=True)
            self.write()

    def know(self, name):
        self.materials[name] = material.load(ROOT, name)
        self.versions[name] = version_of(name)

    def hand_out(self, waiting, asked, again):
        """Give the worker as much as it does at a time; one by one what may have ended it."""
        while again and not asked:
            self.ask(again.popleft(), asked)
        while waiting and not again and len(asked) < self.jobs:
            k, entry = waiting.popleft()
            record, data = self.begun(entry)
            if data is None:
                self.records[k] = record
                self.progress()
            else:
                file = self.run / "work" / f"{k}.ipynb"
                file.write_bytes(data)
                task = (k, entry, record, {"task": k, "set": entry.set, "file": str(file)})
                self.ask(task, asked)

    def ask(self, task, asked):
        asked[task[0]] = task
        if self.worker.process is None:
            self.started(self.worker.start())
        self.worker.tell(task[3])

    def stopped(self, stopped, asked, again):
        """Go on after the worker has ended: with what it had, one by one, and each once more."""
        self.worker.end()
        if self.level is None:
            log = (self.run / "worker.log").read_text(errors="replace")[-1500:]
            raise SystemExit(f"{log}\nThe grading process could not be started: {stopped}.")
        for k, task in list(asked.items()):
            if task[3].get("again"):
                said = f"the grader's process: {stopped}"
                self.graded(*task[:3], {"parts": {}, "answers": {}, "notes": [], "failed": said})
            else:
                task[3]["again"] = True
                again.append(task)
            del asked[k]

    def begun(self, entry):
        """Return a record and the bytes to grade, or None if nothing is left to do."""
        record = {"student": entry.student, "set": entry.set, "place": entry.place}
        record |= {"parts": {}, "answers": {}, "notes": list(entry.notes)}
        if entry.problem:
            return record | {"unreadable": entry.problem}, None
        try:
            data = entry.data()
        except Exception as error:
            said = f"it cannot be read ({type(error).__name__}: {error})"
            return record | {"unreadable": said}, None
        if not entry.set:
            entry.set = record["set"] = set_in(data)
            if not entry.set:
                return record | {"unreadable": "it does not say which problem set it is"}, None
            if entry.set not in self.materials:
                self.know(entry.set)
        record["digest"] = hashlib.sha256(data).hexdigest() + self.versions[entry.set]
        with contextlib.suppress(OSError, ValueError):
            old = json.loads(self.place_of(record).read_text(encoding="utf-8"))
            if old["digest"] == record["digest"] and not old.get("failed"):
                notes = record["notes"] + old["found_inside"]
                return old | {"notes": notes, "place": entry.place}, None
        return record, data

    def graded(self, k, entry, record, said):
        record |= said
        record["found_inside"] = record["notes"]
        record["notes"] = entry.notes + record["notes"]
        record["isolation"] = self.level
        write(self.place_of(record), json.dumps(record))
        self.records[k] = record
        (self.run / "work" / f"{k}.ipynb").unlink(missing_ok=True)

    def place_of(self, record):
        return self.out / "records" / file_name(record["student"]) / f"{record['set']}.json"

    def started(self, level):
        if self.level is None:
            print(f"Each submission runs with: {isolation.LEVELS[level]}.", flush=True)
        self.level = level

    def progress(self, last=False):
        """Say how far it is: in one line of a terminal, elsewhere once in ten submissions."""
        done, open_ = len(self.records), sum(map(trouble, self.records.values()))
        line = f"{done} of {len(self.found)} submissions, {open_} with parts not graded"
        terminal = sys.stderr.isatty()
        if last or done // (1 if terminal else 10) != self.shown:
            start, end = ("\r", "\n" if last else " ") if terminal else ("", "\n")
            print(line.join((start, end)), end="", file=sys.stderr, flush=True)
        self.shown = done // (1 if terminal else 10)

    # --- what is written ---

    def write(self):
        marks = read_marks(self.out / "prose.csv")
        records = [self.records[k] for k in sorted(self.records)]
        for record in records:
            if record["set"]:
                self.complete(record, marks)
        write_grades(self.out / "grades.csv", records, self.materials)
        for record in records:
            if record["set"]:
                page = pages.feedback(record, self.materials[record["set"]])
                write(
                    self.out / "feedback" / file_name(record["student"]) / f"{record['set']}.html",
                    page,
                )
        write(self.out / "summary.html", pages.summary(*summed(records, self.materials)))
        answers = {}
        for record in records:
            for part in self.materials[record["set"]].parts.values() if record["set"] else ():
                answer = record["answers"].get(part.name, {})
                if part.by_hand and answer.get("touched"):
                    shown = (
                        answer.get("html") or f"<pre>{pages.html.escape(answer['source'])}</pre>"
                    )
                    answers.setdefault((record["set"], part.name), []).append(
                        (record["student"], shown)
                    )
        write(self.out / "prose.html", pages.prose_page(answers, self.materials, marks))

    def complete(self, record, marks):
        """Add the parts that no check judges."""
        for part in self.materials[record["set"]].parts.values():
            if not part.by_hand or record.get("unreadable"):
                continue
            answer = record["answers"].get(part.name, {})
            mark = marks.get((record["student"], record["set"], part.name))
            if mark is not None:
                points = min(max(float(mark[0]), 0), part.points)
                record["parts"][part.name] = [points, mark[1], ""]
            elif not answer.get("there"):
                record["parts"][part.name] = [None, "its cell is missing", ""]
            elif not answer.get("touched"):
                record["parts"][part.name] = [0, "there is no answer", ""]
            else:
                record["parts"][part.name] = [None, "waits for a person", ""]


def set_in(data):
    """Return which problem set a notebook says that it is."""
    try:
        text = notebooks.decoded(data[: 1 << 20], [])
    except (notebooks.Unreadable, IndexError):
        return ""
    number = re.search(r"Problem set (\d\d)\b", text)
    names = [p.name for p in (ROOT / "solutions").iterdir() if number and p.name[:2] == number[1]]
    return names[0] if names else ""


def version_of(name):
    """Return a digest of everything that a mark depends on."""
    digest = hashlib.sha256()
    folders = ("amrmetrics", "tools/grading", f"solutions/{name}", f"exercises/{name}")
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts and path.suffix != ".pyc":
                digest.update(str(path.relative_to(ROOT)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def trouble(record):
    if record.get("unreadable") or record.get("failed"):
        return True
    return any(p[0] is None and p[1] != "waits for a person" for p in record["parts"].values())


def file_name(student):
    """Return a name for a folder that every file system takes, different for each student."""
    plain = re.sub(r"[^\w .-]", "_", student).strip(". ")[:60] or "student"
    if plain == student:
        return plain
    return f"{plain}-{hashlib.sha256(student.encode('utf-8', 'replace')).hexdigest()[:6]}"


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_text(text, encoding="utf-8", errors="replace", newline="")
    os.replace(part, path)


def read_marks(path):
    """Return (points, comment) that a person gave, by (student, set, part)."""
    marks = {}
    if not path.is_file():
        return marks
    with path.open(encoding="utf-8-sig", newline="") as file:
        for number, row in enumerate(csv.DictReader(file), 2):
            try:
                key = row["student"], row["set"], row["part"]
                marks[key] = float(row["points"].replace(",", ".")), row.get("comment") or ""
            except (KeyError, ValueError, AttributeError):
                print(f"{path}, line {number}: no mark can be read there.", file=sys.stderr)
    return marks


def safe(text):
    """Return text that a spreadsheet takes for no formula."""
    text = " ".join(str(text).split())
    return "'" + text if text[:1] in ("=", "+", "-", "@") else text


def shown_mark(entry, part, record):
    if record.get("unreadable"):
        return f"not graded: {record['unreadable']}"
    points, said, _ = entry or [None, record.get("failed") or "it was not reached", ""]
    if points is not None:
        return f"{points:g}"
    return said if said == "waits for a person" else f"not graded: {said}"


def write_grades(path, records, materials):
    names = sorted({name for m in materials.values() for name in m.parts})
    head = ["student", "set", "state", "points", "of", *names, "notes", "file"]
    rows = [head]
    for record in records:
        known = materials.get(record["set"])
        parts = known.parts if known else {}
        marks = {n: shown_mark(record["parts"].get(n), p, record) for n, p in parts.items()}
        got = [e[0] for e in record["parts"].values() if e[0] is not None]
        rows.append(
            [
                safe(record["student"]),
                record["set"] or "unknown",
                state(record, marks),
                f"{sum(got):g}" if got else "",
                f"{known.points:g}" if known else "",
                *(safe(marks.get(name, "")) for name in names),
                safe("; ".join(record["notes"])),
                safe(record["place"]),
            ]
        )
    out = "".join(
        ",".join(f'"{c.replace(chr(34), chr(34) * 2)}"' for c in r) + "\r\n" for r in rows
    )
    write(path, "\ufeff" + out)


def state(record, marks):
    if record.get("unreadable"):
        return f"not graded: {record['unreadable']}"
    opened = [name for name, mark in marks.items() if mark.startswith("not graded")]
    if opened:
        return f"not graded: {', '.join(opened)}"
    waiting = [name for name, mark in marks.items() if mark == "waits for a person"]
    return f"waits for a person: {', '.join(waiting)}" if waiting else "complete"


def summed(records, materials):
    """Return, by problem set, how each part went, and everything that was noticed."""
    tables = {}
    for name, known in materials.items():
        mine = [r for r in records if r["set"] == name]
        rows = []
        for part in known.parts.values():
            entries = [r["parts"].get(part.name, [None, "", ""]) for r in mine]
            none = [e for e in entries if e[0] == 0 and "there is no answer" in e[1]]
            fails = [
                e for e in entries if e[0] is not None and e[0] < part.points and e not in none
            ]
            holds = sum(e[0] == part.points for e in entries)
            opened = sum(e[0] is None for e in entries)
            common = Counter(kind_of(e[1]) for e in fails if e[1] and not part.by_hand)
            counts = holds, len(fails), len(none), opened
            rows.append((part.title, counts, common.most_common(3)))
        tables[name] = rows
    notes = []
    for r in records:
        said = [r["unreadable"]] if r.get("unreadable") else []
        said += [r["failed"]] if r.get("failed") else []
        said += [f"{n}: {e[1]}" for n, e in r["parts"].items() if e[0] is None and trouble(r)]
        notes += [(f"{r['student']}, {r['set']}", s) for s in said + r["notes"]]
    often = Counter(said for _, said in notes)
    many = max(3, len(records) / 2)
    common = [(f"{n} submissions", said) for said, n in often.items() if n > many]
    return tables, common + [(who, said) for who, said in notes if often[said] <= many]


def kind_of(said):
    """Return the misconception that a message names, or what is alike in messages of its kind."""
    named = re.search(r"It looks as if (.+?)\.(?:\s|$)", said)
    if named:
        return named[1]
    return re.sub(r"-?\d[\d.,e+-]*", "…", said)[:90]


@contextlib.contextmanager
def workplace():
    """Yield a folder of this run, and remove those of runs that were killed.

    A run holds a lock on a file in its folder, which the system releases however it ends.
    """
    import fcntl

    for old in Path(tempfile.gettempdir()).glob("grading-*"):
        if is_abandoned(old):
            shutil.rmtree(old, ignore_errors=True)
    with tempfile.TemporaryDirectory(prefix="grading-", ignore_cleanup_errors=True) as folder:
        lock = Path(folder, "lock")
        with lock.with_suffix(".new").open("w") as file:
            fcntl.flock(file, fcntl.LOCK_EX)
            os.rename(file.name, lock)  # so that nobody sees it unlocked
            yield Path(folder)


def is_abandoned(folder):
    """Tell whether a folder is one of ours, of a run that has certainly ended."""
    import fcntl

    try:
        about = folder.lstat()
        if not stat.S_ISDIR(about.st_mode) or about.st_uid != os.geteuid():
            return False
        with (folder / "lock").open() as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:  # there is none, or the run holds it
        return False
    return True


def prepared(run):
    """Copy what the checks need: neither a submission nor an editor changes it any more."""
    private = ("work", "handed", "course", "library", "tools")
    for name in ("empty", "root", "homes", "matplotlib", "ipython", *private):
        (run / name).mkdir()
    without = shutil.ignore_patterns("__pycache__", "*.pyc", ".ipynb_checkpoints")
    shutil.copytree(ROOT / "amrmetrics", run / "library" / "amrmetrics", ignore=without)
    shutil.copytree(ROOT / "tools" / "grading", run / "tools" / "grading", ignore=without)
    for name in ("solutions", "exercises"):
        shutil.copytree(ROOT / name, run / "course" / name, ignore=without)
    for name in private:
        (run / name).chmod(0o700)
    run.chmod(0o755)


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="course.py grade", description=__doc__.split("\n\n")[0])
    parser.add_argument("submitted", type=Path, help="folder or zip file with what was handed in")
    parser.add_argument(
        "--out", type=Path, default=ROOT / "build" / "grades", help="for the results"
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="at a time")
    parser.add_argument(
        "--cell-seconds", type=float, default=10, help="of work, for one cell or one call"
    )
    asked = parser.parse_args(arguments)
    if not hasattr(os, "fork"):
        print(
            "Grading needs Linux or macOS. On Windows, run it in WSL: a submission could not be "
            "kept from your files here.",
            file=sys.stderr,
        )
        return 2
    if not asked.submitted.exists():
        parser.error(f"there is no {asked.submitted}")
    sets = sorted(p.parent.name for p in (ROOT / "solutions").glob("*/*.ipynb"))
    found = collecting.find(asked.submitted, sets)
    if not found:
        print(f"No notebook was found in {asked.submitted}. Expected: NAME/NN_name/NN_name.ipynb")
        return 2
    asked.out.mkdir(parents=True, exist_ok=True)
    asked.out.chmod(0o700)
    jobs = max(1, min(asked.jobs, len(found)))
    start = time.monotonic()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        with workplace() as run:
            prepared(run)
            grading = Grading(found, asked.out, jobs, run, asked.cell_seconds)
            grading.go()
    except KeyboardInterrupt:
        print("\nStopped. The same command goes on from here.", file=sys.stderr)
        return 130
    records = list(grading.records.values())
    opened = sum(map(trouble, records))
    print(
        f"{len(records)} submissions in {time.monotonic() - start:.0f} s, {opened} with parts that "
        f"were not graded. Results: {asked.out / 'grades.csv'}, summary.html, prose.html, feedback/"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
