"""Put answers into a problem set and run its checks, as a student and a grader would.

The answers that students give stand in ``tests/answers/NN_name/<grade_id>.py``: whole cells,
separated by ``# %% wrong: <misconception>`` and ``# %% right: <how it differs>``. What a student
reads for each of them, for whoever writes a problem set::

    python3 tools/exercise.py 02_alignment part-d
"""

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

    def run(self, answers, hidden=False):
        """Run the solved problem set with `answers` (cells by grade_id) in the solution's place.

        With `hidden`, the checks are those of the grader. Returns, for each part, what its check
        raised, or None. A cell that fails does not stop the next, as in nbgrader.
        """
        with contextlib.chdir(self.folder):
            return run(self.solution if hidden else self.exercise, self.official | answers)

    def run_untouched(self):
        """Run the exercise as it was handed out."""
        with contextlib.chdir(self.folder):
            return run(self.exercise, {})


def run(notebook, answers):
    """Run all code cells in one fresh namespace and return what each part's check raised."""
    namespace, verdicts, part = {"__name__": "__main__"}, {}, None
    for cell in notebook.cells:
        if cell.cell_type != "code":
            continue
        error = execute(answers.get(grade_id(cell), cell.source), grade_id(cell), namespace)
        if is_part(cell):
            part = grade_id(cell)
        elif is_check(cell):
            verdicts[part] = error
    return verdicts


def execute(source, name, namespace):
    try:
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings(action="ignore"):
            exec(compile(source, name, "exec"), namespace)
    except (Exception, SystemExit) as error:
        return error
    return None


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
    blocks = re.split(r"^# %% (wrong|right): (.+)\n", text, flags=re.MULTILINE)[1:]
    return [
        Answer(path.stem, kind, what.strip(), source.strip() + "\n")
        for kind, what, source in zip(blocks[::3], blocks[1::3], blocks[2::3], strict=True)
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
            error = problem_set.run({part: answer.source})[part]
            print(f"{answer.kind}: {answer.what}\n    {error or 'passes'}\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
