"""Problem sets tell right answers from wrong ones, part by part, and keep the rules of the house.

The answers stand in ``tests/answers``; `exercise` puts them in. Each meets the check that a student
sees and the one of the grader, with warnings on.
"""

import ast
import contextlib
import copy
import io
import re
import tokenize

import pytest
from exercise import (
    ROOT,
    ProblemSet,
    bound,
    grade_id,
    is_check,
    is_part,
    nbgrader,
    steps_checked_once,
    trials_run_once,
)
from nbclient import NotebookClient

NAMES = sorted(path.parent.name for path in (ROOT / "solutions").glob("*/*.ipynb"))
SETS = {name: ProblemSet(name) for name in NAMES}
PARTS = [(name, part) for name in NAMES for part in SETS[name].official]
ANSWERS = [(name, answer) for name in NAMES for answer in SETS[name].answers()]

each_set = pytest.mark.parametrize("name", NAMES)
each_part = pytest.mark.parametrize(("name", "part"), PARTS, ids=lambda x: x)


def each_answer(kind):
    chosen = [(name, answer) for name, answer in ANSWERS if answer.kind == kind]
    ids = [f"{name}-{answer.part}-{answer.what}" for name, answer in chosen]
    return pytest.mark.parametrize(("name", "answer"), chosen, ids=ids)


@pytest.fixture(scope="module", autouse=True)
def remember():
    with steps_checked_once(), trials_run_once():
        yield


@each_answer("wrong")
def test_wrong_answer_fails_and_is_told_why(name, answer):
    problem_set = SETS[name]
    error = problem_set.judge(answer.part, answer.source)
    assert isinstance(error, AssertionError), repr(error)
    assert len(answer.says) >= 12, "say which kind of message is expected"
    assert answer.says in str(error)
    for secret in secrets(problem_set, answer.part):
        assert secret in answer.source or secret not in str(error)
    graded = problem_set.judge(answer.part, answer.source, hidden=True)
    assert isinstance(graded, AssertionError), repr(graded)


@each_answer("right")
def test_right_answer_passes(name, answer):
    assert SETS[name].judge(answer.part, answer.source) is None
    verdicts = SETS[name].run({answer.part: answer.source}, hidden=True)
    assert [error for error in verdicts.values() if error] == []


@each_set
def test_untouched_exercise_fails_in_every_part(name):
    verdicts = SETS[name].run_untouched()
    assert list(verdicts) == list(SETS[name].official)
    for part, error in verdicts.items():
        assert "there is no answer yet" in str(error), part


@each_set
def test_untouched_exercise_in_a_kernel(name):
    notebook = copy.deepcopy(SETS[name].exercise)
    NotebookClient(notebook, allow_errors=True, timeout=60).execute(cwd=SETS[name].folder)
    for cell in notebook.cells:
        failed = [out for out in cell.get("outputs", []) if out.output_type == "error"]
        assert bool(failed) == is_check(cell), grade_id(cell)
        for out in failed:
            assert out.traceback == [f"Not yet: {out.evalue}"]


@each_part
class TestPart:
    def test_is_told_from_wrong_answers(self, name, part):
        kinds = [a.kind for n, a in ANSWERS if (n, a.part) == (name, part)]
        assert kinds.count("wrong") >= 8
        assert kinds.count("right") >= 4

    def test_the_exercise_does_not_show_the_answer(self, name, part):
        assert secrets(SETS[name], part)

    def test_functions_are_typed_and_say_what_they_return(self, name, part):
        cell = next(c for c in SETS[name].exercise.cells if grade_id(c) == part)
        for node in ast.parse(cell.source).body:
            if isinstance(node, ast.FunctionDef):
                assert ast.get_docstring(node)
                assert node.returns


@each_set
class TestProblemSet:
    def test_every_part_has_two_hints(self, name):
        prose = "\n".join(c.source for c in SETS[name].exercise.cells if c.cell_type == "markdown")
        for section in re.split(r"^## ", prose, flags=re.MULTILINE)[1:]:
            assert section.count("<details>") == section.count("</details>") == 2, section[:40]

    def test_every_answer_stands_between_markers(self, name):
        for cell in SETS[name].solution.cells:
            if nbgrader(cell).get("solution"):
                begins = cell.source.count("### BEGIN SOLUTION")
                assert begins == cell.source.count("### END SOLUTION") > 0, grade_id(cell)

    def test_every_part_has_its_check_and_its_points(self, name):
        graded = [c for c in SETS[name].solution.cells if nbgrader(c).get("grade")]
        assert all(nbgrader(c)["points"] > 0 for c in graded)
        header = SETS[name].solution.cells[0].source
        assert f"{sum(nbgrader(c)['points'] for c in graded)} points" in header
        code = [c for c in SETS[name].solution.cells if is_part(c) or is_check(c)]
        assert [is_part(c) for c in code] == [True, False] * (len(code) // 2)

    def test_no_check_ends_in_a_value(self, name):
        """To nbgrader the value of a check cell is the number of points."""
        for cell in filter(is_check, SETS[name].solution.cells):
            kinds = [output.output_type for output in cell.outputs]
            assert "execute_result" not in kinds, f"{grade_id(cell)}: print or display it"

    def test_checks_see_no_name_of_the_student(self, name):
        cells = [c for c in SETS[name].solution.cells if c.cell_type == "code"]
        given = set()
        for cell in cells:
            if not (is_part(cell) or is_check(cell)):
                *before, last = ast.parse(cell.source).body
                assert ast.unparse(last.value.func) == "check.keep"
                kept = last.value.args[1].value.split()
                assert sorted(kept) == sorted(set().union(*map(bound, before)))
                given |= set(kept)
        for cell in filter(is_check, cells):
            assert cell.metadata["jupyter"] == {"source_hidden": True}, grade_id(cell)
            imported, run = ast.parse(cell.source).body
            assert ast.unparse(imported) == "from amrmetrics import check"
            assert [ast.unparse(d) for d in run.decorator_list] == ["check.part(globals())"]
            letter = grade_id(cell).removeprefix("check-")
            assert run.name == f"check_{letter}"
            part = next(c for c in cells if grade_id(c) == f"part-{letter}")
            asked = {argument.arg for argument in run.args.args}
            assert asked <= set().union(*map(bound, ast.parse(part.source).body))
            assert not asked & given

    def test_every_cell_has_its_own_grade_id_and_no_checksum(self, name):
        cells = [c for c in SETS[name].solution.cells if nbgrader(c)]
        assert len({grade_id(c) for c in cells}) == len(cells)
        assert not [grade_id(c) for c in cells if "checksum" in nbgrader(c)]

    def test_has_every_kind_of_question(self, name):
        checks = "\n".join(c.source for c in SETS[name].solution.cells if is_check(c))
        for call in ("value", "derivation", "function", "wrong_line", "test_function"):
            assert f"check.{call}(" in checks, call
        by_hand = [c for c in SETS[name].solution.cells if nbgrader(c).get("grade")]
        assert [c for c in by_hand if nbgrader(c)["solution"]], "no question answered in prose"


def secrets(problem_set, part):
    """Return the texts, numbers and lines of an official answer that the exercise does not show."""
    shown = "\n".join(cell.source for cell in problem_set.exercise.cells)
    regions = re.findall(
        r"### BEGIN SOLUTION\n(.*?)### END SOLUTION", problem_set.official[part], re.DOTALL
    )
    found = set()
    for region in regions:
        found |= {line.strip() for line in region.splitlines() if len(line.strip()) > 20}
        with contextlib.suppress(tokenize.TokenError, IndentationError):
            for token in tokenize.generate_tokens(io.StringIO(region).readline):
                if token.type in (tokenize.STRING, tokenize.NUMBER):
                    found.add(token.string.strip("\"'"))
    return {text for text in found if len(text) > 2 and text not in shown}
