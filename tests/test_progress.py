"""What is noted of a student's attempts, and when a model answer may be seen."""

import json
import os

import pytest

from amrmetrics import _progress, check

SET = "04_consistency"
STUB_A = "z = (\n    ...  # your answer here\n)"
STUB_B = 'def twice(x):\n    """Return 2 x."""\n    ...  # your answer here'
STUB_F = "text = (\n    ...  # your answer here\n)"
QUESTION = "## g. In your own words\n\nWhich faults do you see? Four sentences."
MODEL_A = "z = (\n    ### BEGIN SOLUTION\n    (1, 2)  # by hand\n    ### END SOLUTION\n)"
MODEL_TEXT = "### BEGIN SOLUTION\n\nThe band has *two* sides.\n\n### END SOLUTION"


def notebook(path, cells):
    made = [
        {"metadata": {"nbgrader": {"grade_id": name}}, "source": source.splitlines(keepends=True)}
        for name, source in cells.items()
    ]
    path.parent.mkdir(parents=True, exist_ok=True)
    cells = [*made, {"metadata": {}, "source": []}]
    path.write_text(json.dumps({"cells": cells}), encoding="utf-8")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    stubs = {"part-a": STUB_A, "part-b": STUB_B, "part-f": STUB_F}
    checks = dict.fromkeys(("check-a", "check-b", "check-f"), "")
    handed_out = {**stubs, **checks, "prose-g": f"{QUESTION}\n\n*Your answer here.*"}
    notebook(tmp_path / "exercises" / SET / f"{SET}.ipynb", handed_out)
    models = {"part-a": MODEL_A, "part-b": STUB_B, "prose-g": f"{QUESTION}\n\n{MODEL_TEXT}"}
    notebook(tmp_path / "solutions" / SET / f"{SET}.ipynb", handed_out | models)
    folder = tmp_path / "my_work" / SET
    notebook(folder / f"{SET}.ipynb", handed_out)
    monkeypatch.chdir(folder)
    return folder


def attempt(part, cell, name, right):
    """Run a cell and the check of a part, as in a notebook; return what the check raises."""
    namespace = {}
    exec(cell, namespace)
    check.keep(namespace, "")
    body = f"def check_{part}({name}):\n    check.value('it', {right}, 1)"
    exec(body, namespace | {"check": check}, made := {})
    try:
        check.part(namespace)(made[f"check_{part}"])
    except check.NotYet as error:
        return str(error)


def noted(folder):
    return _progress.read(folder.parent)[SET]


def test_a_part_that_holds_is_noted_and_counted(folder, capsys):
    assert attempt("a", "z = 1", "z", "z") is None
    said = capsys.readouterr().out
    assert said.startswith("1 of 3 parts of set 04 hold.") and 'model_answer("a")' in said
    assert attempt("a", "z = 1", "z", "z") is None
    assert capsys.readouterr().out == "1 of 3 parts of set 04 hold.\n"
    assert noted(folder)["a"]["holds"]
    attempt("a", "z = 3", "z", "z")
    assert not noted(folder)["a"]["holds"] and noted(folder)["a"]["opened"]
    for part in "abf":
        said = _progress.record(part, "an answer", held=True)
    assert said.startswith("All 3 parts of set 04 hold.")


def test_three_different_answers_open_the_model_answer(folder, capsys):
    for k, left in ((2, "2 more different answers"), (3, "one more answer")):
        for _ in range(4):  # the same answer again is no other try
            assert attempt("a", f"z = {k}", "z", "z")
        _progress.model_answer("a")
        assert left in capsys.readouterr().out
    attempt("a", "z = 4", "z", "z")
    assert "shows the model answer" in capsys.readouterr().out
    _progress.model_answer("A")
    assert capsys.readouterr().out == "z = (\n    (1, 2)  # by hand\n)\n"


def test_the_attempt_that_opens_a_model_answer_says_so(folder):
    said = [_progress.record("a", f"answer {k}", held=False) for k in range(5)]
    assert said[2] == 'check.model_answer("a") shows the model answer.'
    assert [*said[:2], *said[3:]] == [None] * 4


@pytest.mark.parametrize("part, cell, name", [("a", STUB_A, "z"), ("b", STUB_B, "twice")])
def test_what_was_handed_out_is_no_try(folder, part, cell, name):
    right = "twice(1)" if part == "b" else name
    for _ in range(3):
        assert attempt(part, cell, name, right)
    assert noted(folder)[part] == {"holds": False, "opened": False, "tries": []}
    changed = cell.replace("...  # your answer here", "return 7" if part == "b" else "7")
    attempt(part, changed, name, right)
    assert len(noted(folder)[part]["tries"]) == 1


def test_a_model_text_opens_when_a_text_of_ones_own_is_saved(folder, capsys):
    _progress.model_answer("g")
    assert "write your own answer to part g" in capsys.readouterr().out
    own = "The mean lies below three, and nobody says how wide the band is. " * 3
    notebook(folder / f"{SET}.ipynb", {"prose-g": f"{QUESTION}\n\n{own}"})
    shown = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("IPython.display.display", shown.append)
        _progress.model_answer("g")
    assert [text.data for text in shown] == ["The band has *two* sides."]


@pytest.mark.parametrize("part, meaning", [("x", "There is no part x."), (3, "a, b, f, g")])
def test_a_part_that_does_not_exist_names_those_that_do(folder, capsys, part, meaning):
    _progress.model_answer(part)
    assert meaning in capsys.readouterr().out


def test_a_copy_without_solutions_says_so(folder, capsys):
    (folder.parents[1] / "solutions" / SET / f"{SET}.ipynb").unlink()
    _progress.model_answer("a")
    assert "no model answers" in capsys.readouterr().out


BROKEN = ["", "{", "[1]", '{"04_consistency": 3}', '{"04_consistency": {"a": []}}', "[" * 10**5]


@pytest.mark.parametrize("text", BROKEN, ids=range(len(BROKEN)))
def test_a_damaged_file_counts_as_an_empty_one(folder, text):
    (folder.parent / "progress.json").write_text(text, encoding="utf-8")
    assert _progress.record("a", "1", held=True).startswith("1 of 3")
    assert noted(folder)["a"]["holds"]


def test_a_file_that_cannot_be_written_breaks_no_check(folder, monkeypatch):
    def refuse(*args):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "replace", refuse)
    assert _progress.record("a", "1", held=True) is not None
    assert sorted(path.name for path in folder.parent.iterdir()) == [SET]


@pytest.mark.parametrize("place", [".", "my_work", "solutions/04_consistency", "my_work/lectures"])
def test_nothing_is_noted_elsewhere(folder, monkeypatch, capsys, place):
    root = folder.parents[1]
    (root / "my_work" / "lectures").mkdir()
    monkeypatch.chdir(root / place)
    before = sorted(root.rglob("*"))
    assert _progress.record("a", "1", held=True) is None
    assert sorted(root.rglob("*")) == before
    _progress.model_answer("a")
    assert "in the problem sets" in capsys.readouterr().out


def test_without_the_exercise_nothing_is_noted(folder):
    (folder.parents[1] / "exercises" / SET / f"{SET}.ipynb").unlink()
    assert _progress.record("a", "1", held=True) is None


def test_progress_is_one_line_a_set(folder, monkeypatch, capsys):
    monkeypatch.chdir(folder.parents[1])
    _progress.main()
    assert capsys.readouterr().out.splitlines()[0] == "04 consistency  . . .   not begun"
    monkeypatch.chdir(folder)
    _progress.record("b", "1", held=True)
    _progress.record("a", "2", held=False)
    monkeypatch.chdir(folder.parents[1])
    _progress.main()
    line = capsys.readouterr().out.splitlines()[0]
    assert line == "04 consistency  . b .   1 of 3 parts hold"
