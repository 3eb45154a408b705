"""Put answers into a problem set and run its checks, as a student and a grader would.

The answers that students give stand in ``tests/answers/NN_name/<grade_id>.py``, separated by
``# %% wrong: <misconception>`` and ``# %% right: <how it differs>``. Below a wrong one stands what
its message has to say, ``# says: <a piece of it>``. An answer holds the statements that it changes;
the rest of the cell is the official one. What a student reads for each of them, for whoever writes
a problem set::

    python3 tools/exercise.py 02_alignment part-d
"""

import ast
import contextlib
import functools
import io
import re
import sys
import warnings
from dataclasses import dataclass
from pathlib import Path
from unittest import mock

import nbformat

ROOT = Path(__file__).parents[1]


@dataclass(frozen=True)
class Answer:
    """A cell that a student may hand in, and what is wrong with it or how it differs."""

    part: str
    kind: str
    what: str
    says: str
    source: str


class ProblemSet:
    """The exercise and the solution of one problem set, and the answers kept for it."""

    def __init__(self, name):
        self.name, self.folder = name, ROOT / "exercises" / name
        self.solution = nbformat.read(ROOT / "solutions" / name / f"{name}.ipynb", 4)
        self.exercise = nbformat.read(self.folder / f"{name}.ipynb", 4)
        self.official = {
            grade_id(cell): cell.source for cell in self.solution.cells if is_part(cell)
        }

    def answers(self):
        """Every answer that is kept for this problem set, in the order of the parts."""
        folder = ROOT / "tests" / "answers" / self.name
        return [answer for part in self.official for answer in read(folder / f"{part}.py")]

    def judge(self, part, source, hidden=False):
        """Return what a part's check raises on an answer, or None: without the other parts.

        With `hidden`, the check is the one of the grader.
        """
        notebook = self.solution if hidden else self.exercise
        cells = [c for c in notebook.cells if c.cell_type == "code"]
        place = next(k for k, cell in enumerate(cells) if grade_id(cell) == part)
        given = [c for c in cells[:place] if not (is_part(c) or is_check(c))]
        with contextlib.chdir(self.folder):
            return run([*given, *cells[place : place + 2]], self.filled({part: source}))[part]

    def run(self, answers, hidden=False):
        """Run the solved problem set with `answers` (cells by grade_id) in the solution's place.

        With `hidden`, the checks are those of the grader. Returns, for each part, what its check
        raised, or None. A cell that fails does not stop the next, as in nbgrader.
        """
        notebook = self.solution if hidden else self.exercise
        with contextlib.chdir(self.folder):
            return run(notebook.cells, self.official | self.filled(answers))

    def run_untouched(self):
        """Run the exercise as it was handed out."""
        with contextlib.chdir(self.folder):
            return run(self.exercise.cells, {})

    def filled(self, answers):
        return {part: filled(source, self.official[part]) for part, source in answers.items()}


def filled(changed, official):
    """Return an official cell with an answer in the place of the statements for the same names."""
    try:
        mine = set().union(*map(bound, ast.parse(changed).body))
    except SyntaxError:
        return changed
    lines = official.splitlines(keepends=True)
    before, after = [], []
    replaced = False
    for statement in ast.parse(official).body:
        names = bound(statement)
        if names and names <= mine:
            replaced = True
            continue
        text = "".join(lines[start_of(statement) - 1 : statement.end_lineno])
        (after if replaced else before).append(text)
    if not replaced:  # it only adds something, which then stands first
        before, after = [], before
    return "\n".join(["".join(before), changed, "".join(after)])


def start_of(statement):
    decorators = getattr(statement, "decorator_list", [])
    return min([statement.lineno, *(d.lineno for d in decorators)])


def bound(statement):
    """Return the names that a statement gives a value."""
    if isinstance(statement, ast.FunctionDef | ast.ClassDef):
        return {statement.name}
    if isinstance(statement, ast.Import | ast.ImportFrom):
        return {alias.asname or alias.name for alias in statement.names}
    inner = {
        node
        for found in ast.walk(statement)
        if isinstance(
            found, ast.ListComp | ast.SetComp | ast.DictComp | ast.GeneratorExp | ast.Lambda
        )
        for node in ast.walk(found)
    }
    stored = (n for n in ast.walk(statement) if isinstance(n, ast.Name) and n not in inner)
    return {node.id for node in stored if isinstance(node.ctx, ast.Store)}


def run(cells, answers):
    """Run all code cells in one fresh namespace and return what each part's check raised."""
    namespace, verdicts, part = {"__name__": "__main__"}, {}, None
    for cell in cells:
        if cell.cell_type != "code":
            continue
        error, written = execute(
            answers.get(grade_id(cell), cell.source), grade_id(cell), namespace
        )
        if is_part(cell):
            part = grade_id(cell)
        elif is_check(cell):
            costs = f"nbgrader gives no marks for a check that writes to stderr: {written}"
            verdicts[part] = error or (RuntimeError(costs) if written else None)
    return verdicts


def execute(source, name, namespace):
    """Run a cell; return what it raises, or None, and what it writes to stderr."""
    written = io.StringIO()
    try:
        with (
            contextlib.redirect_stdout(io.StringIO()),
            contextlib.redirect_stderr(written),
            warnings.catch_warnings(action="always"),
        ):
            exec(compile(source, name, "exec"), namespace)
    except (Exception, SystemExit) as error:
        return error, written.getvalue()
    return None, written.getvalue()


def nbgrader(cell):
    return cell.metadata.get("nbgrader", {})


def grade_id(cell):
    return nbgrader(cell).get("grade_id")


def is_part(cell):
    """Whether this is a code cell that a student fills in."""
    return cell.cell_type == "code" and nbgrader(cell).get("solution", False)


def is_check(cell):
    return cell.cell_type == "code" and nbgrader(cell).get("grade", False)


def read(path):
    """Return the answers in a file; none if there is no such file."""
    text = path.read_text(encoding="utf-8") if path.is_file() else ""
    blocks = re.split(r"^# %% (wrong|right): (.+)\n(?:# says: (.+)\n)?", text, flags=re.MULTILINE)
    return [
        Answer(path.stem, kind, what.strip(), (says or "").strip(), source.strip() + "\n")
        for kind, what, says, source in zip(*(blocks[k::4] for k in range(1, 5)), strict=True)
    ]


@contextlib.contextmanager
def steps_checked_once():
    """Remember the verdict on each step of a derivation: it depends on the step alone.

    The lines of the parts that an answer leaves as they are need not be proved again each time.
    """
    from amrmetrics import derivation
    from amrmetrics.derivation import chain

    real = derivation.check_step

    @functools.cache
    def remembered(before, after, domains, *rest):
        return real(before, after, dict(domains), *rest)

    def check_step(before, after, domains, relation="iff", unknown=None, seed=0):
        return remembered(before, after, tuple(dict(domains).items()), relation, unknown, seed)

    with (
        mock.patch.object(derivation, "check_step", check_step),
        mock.patch.object(chain, "check_step", check_step),
    ):
        yield


@contextlib.contextmanager
def trials_run_once():
    """Remember what came of each trial of a benchmark: that depends on what it is given alone.

    Each takes a process of its own, and the parts that an answer leaves as they are run the same.
    Nor is a disk waited for, whose power nobody will cut.
    """
    from amrmetrics.benchmark import logs, running

    real = running.trial
    remembered = functools.cache(lambda code, order: real(code, order))
    with (
        mock.patch.object(running, "trial", lambda code, order, *_: remembered(code, order)),
        mock.patch.object(logs.os, "fsync"),
    ):
        yield


def main(name, part):
    """Print what a student reads for every answer that is kept for a part."""
    problem_set = ProblemSet(name)
    with steps_checked_once(), trials_run_once():
        for answer in read(ROOT / "tests" / "answers" / name / f"{part}.py"):
            student, grader = (problem_set.judge(part, answer.source, h) for h in (False, True))
            print(f"{answer.kind}: {answer.what}\n    {student or 'passes'}")
            if (student is None) != (grader is None):
                print(f"    to the grader: {grader or 'passes'}")


if __name__ == "__main__":
    main(*sys.argv[1:])
