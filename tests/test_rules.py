"""The rules for notebooks find the fault that is planted, in its place, and no other."""

import copy
import re

import nbformat
import pytest
import rules
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

GOOD = """
%% prose title
# 42 · A lecture

**Time**: 20 minutes, for Parts 1 and 2 and the questions. *Going deeper* takes 10 minutes more.

**Prerequisites.** Lecture [41](41_before.ipynb).

**Afterwards you are able to** double a number.

Practice: [problem set](../exercises/42_good/42_good.ipynb). After it: [43](43_after.ipynb).
%% code setup
import numpy as np

from amrmetrics import plotting
from amrmetrics.derivation import declare

derive = declare("")
%% prose part-1
## Part 1 · Doubling (10 minutes)

| Symbol | Meaning | Python |
|---|---|---|
| $x$ | a number | `x` |
| $\\sigma$ | deviation of what is drawn [below](#Part-2-·-Drawing-(8-minutes)) | `draws.std()` |
%% code letters
derive.more('''
    y   real
''')
%% code d1
derive('''
    D1: y + y
    = 2*y     # count
''')
%% prose numbers-why
So the double of $x$, which is $x+x$, is:
%% code numbers
x = 3
double = 2 * x
print("double:", double)
assert double == 6
%% prose part-2
## Part 2 · Drawing (8 minutes)

Numbers with the deviation $\\sigma$.
%% code draws
rng = np.random.default_rng(1)
draws = rng.normal(size=100)
print(draws.mean().round(3))
assert abs(draws.mean()) < 0.5
%% prose figure-why
They look like this.
%% code figure
fig, ax = plotting.plt.subplots()
ax.plot(draws)
plotting.show(fig, alt="A line that goes up and down.")
%% prose questions
## Check yourself (2 minutes)

**1.** Why?

<details><summary>Answer</summary>Because.</details>
%% prose summary
## Summary

Twice.

## Going deeper A (10 minutes)

Thrice.
%% code deeper
rng = np.random.default_rng(2)
print(3 * x)
%% prose next
## References

None.

## Next

[Practice](../exercises/42_good/42_good.ipynb), then [43](43_after.ipynb).
"""


@pytest.fixture
def good(tmp_path):
    """A lecture of a few cells that keeps every rule, among its neighbors."""
    folder = tmp_path / "notebooks"
    practice = tmp_path / "exercises" / "42_good" / "42_good.ipynb"
    folder.mkdir()
    practice.parent.mkdir(parents=True)
    for path in (practice, *(folder / f"{name}.ipynb" for name in ("41_before", "43_after"))):
        path.write_text(nbformat.writes(new_notebook()), encoding="utf-8")
    nb = new_notebook()
    nb.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    for kind, cell_id, source in re.findall(r"^%% (\w+) (\S+)\n(.*?)(?=^%%|\Z)", GOOD, re.M | re.S):
        make = new_code_cell if kind == "code" else new_markdown_cell
        nb.cells.append(make(source.rstrip(), id=cell_id))
    notebook = rules.Notebook(folder / "42_good.ipynb", nb)
    for number, code in enumerate(notebook.code, 1):
        code.execution_count = number
    return stored(notebook)


def stored(notebook):
    notebook.path.write_text(nbformat.writes(notebook.nb), encoding="utf-8")
    return notebook


def faults(notebook):
    """{rule: its faults} of a notebook, without the rules that it keeps."""
    groups = rules.STORED | rules.LECTURE | rules.AGAIN
    found = {name: list(rule(notebook)) for name, rule in groups.items()}
    return {name: texts for name, texts in found.items() if texts}


def cell(notebook, cell_id):
    (found,) = (cell for cell in notebook.nb.cells if cell.id == cell_id)
    return found


def changed(notebook, cell_id, old, new):
    """Return a copy of the notebook with a text in one cell replaced, and store it."""
    notebook = rules.Notebook(notebook.path, copy.deepcopy(notebook.nb))
    source = cell(notebook, cell_id).source
    assert old in source
    cell(notebook, cell_id).source = source.replace(old, new, 1)
    return stored(notebook)


def test_a_good_lecture_has_no_faults(good):
    assert faults(good) == {}


PLANTED = {
    # rule: [(cell, what stands there, what is put there, what the fault says)]
    "spelling and tone": [
        ("figure-why", "They", "Clearly, they", "Clearly"),
        ("figure-why", "They", "In color and colour, they", "colour"),
        ("figure-why", "this.", "this \U0001f600.", "\U0001f600"),
    ],
    "links lead somewhere": [
        ("figure-why", "this", "[this](../nowhere.md)", r"no \.\./nowhere.md"),
        ("figure-why", "this", "[this](43_after.ipynb#Part-1)", "43_after.ipynb#Part-1 is no"),
        ("figure-why", "this", "[this](#Part-3)", "#Part-3 is no heading"),
        ("figure-why", "this", '<img src="picture.png">', "no picture.png"),
    ],
    "cells are short": [
        ("numbers", "x = 3", "x = 3\n" + "\n".join(f"x_{k} = {k}" for k in range(13)), "17 lines"),
        ("numbers", '"double:"', '"double:"' + ",\n    1" * 12, "16 lines"),
    ],
    "code fits the column": [("numbers", "assert", "# " + "long" * 20 + "\nassert", "82 columns")],
    "one statement a line": [
        ("numbers", "x = 3\n", "x, z = 3, 4\n", "several assignments: x, z = 3, 4"),
        ("numbers", "x = 3\n", "x = z = 3\n", "several assignments: x = z = 3"),
        ("numbers", "x = 3\n", "x = 3; z = 4\n", "semicolon"),
        ("numbers", "double == 6", "double == 6;", "semicolon"),
        ("numbers", "assert", "if x: print()\nassert", "two statements: if x: print()"),
        ("numbers", "assert", "if x > 3:\n    pass\nelse: pass\nassert", "two statements: else:"),
    ],
    "no parser and no helper for derivations": [
        ("numbers", "x = 3", 'def show():\n    return derive("y")\n\n\nx = 3', "calls derive"),
        ("numbers", "x = 3", 'show = lambda: derive.wrong("y")\nx = 3', "derive.wrong"),
        ("numbers", "x = 3", "def names(text):\n    return text.split()\n\n\nx = 3", "split"),
        ("numbers", "x = 3", "import re\n\nx = 3", "imports re"),
        ("numbers", "x = 3", 'x = eval("3")', "calls eval"),
    ],
    "declarations last": [
        ("setup", 'declare("")', "declare('x real')", "setup: run again, it forgets what letters"),
    ],
    "derivations are written out": [
        ("d1", "derive('''", "derive(f'''", "d1: derive"),
        ("d1", "derive('''", "derive('' + '''", "d1: derive"),
        ("d1", "derive('''", "derive.more('z real' * 1)\nderive('''", "d1: derive.more"),
        ("letters", "derive.more('''", "derive.more('x real' + '''", "letters: derive.more"),
        ("setup", 'declare("")', 'declare("" * 1)', "setup: declare"),
    ],
    "sliders do not stall": [
        ("setup", "import numpy", "from ipywidgets import interact\nimport numpy", "interact"),
    ],
    "opens with what it takes": [
        ("title", "# 42", "42", "no title"),
        ("title", "Prerequisites", "Before", "'Prerequisites'"),
        ("title", "able to", "ready to", "'able to'"),
    ],
    "closes with questions and sources": [
        ("questions", "Check yourself", "Questions", "no heading 'Check yourself'"),
        ("next", "## References", "**References**", "no heading 'References'"),
        ("questions", "</details>", "", "not closed"),
    ],
    "leads to its neighbors": [
        ("title", "[41](41_before.ipynb)", "41", "header has no link to 41_before"),
        ("title", "(43_after.ipynb)", "(41_before.ipynb)", "header has no link to 43_after"),
        ("next", "[Practice](../exercises/42_good/42_good.ipynb)", "Practice", "Next has no link"),
    ],
    "minutes add up": [
        ("title", "20 minutes", "25 minutes", "take 20 minutes, the header says 25"),
        ("part-1", " (10 minutes)", "", "states no minutes"),
        ("summary", "(10 minutes)", "(15 minutes)", "takes 15 minutes, the header says 10"),
        ("title", "takes 10 minutes", "takes some time", "the header says None"),
    ],
    "figures are asserted and said": [
        ("draws", "assert abs(draws.mean()) < 0.5", "", "figure: no assert near"),
    ],
    "symbols have a table": [("part-1", "| Python |", "| Code |", "no table has a column Python")],
    "letters are explained": [
        ("figure-why", "this", "$\\omega$ and $x_{12}$", "omega is in no table"),
        ("figure-why", "this", "$$\\operatorname{tr}Q = 3$$", "Q is in no table"),
    ],
    "each cell that draws has its own seed": [
        ("deeper", "rng = np.random.default_rng(2)", "rng = np.random.default_rng(1)", "of draws"),
        ("deeper", "default_rng(2)", "default_rng()", "the seed is missing"),
    ],
    "cells can be run again": [
        # Each is run at the end …
        ("deeper", "print(", "draws = -draws\nprint(", "figure: run again"),
        ("deeper", "print(", "del plotting\nprint(", "figure: run again .*NameError"),
        # … and twice in a row.
        ("figure", "ax.plot", "double += 1\nprint(double)\nax.plot", "figure: run"),
        ("numbers", "x = 3", 'x = globals().get("x", 2) + 1', "numbers: run"),
        ("draws", "draws.mean().round(3))", "next(counter))\n", "draws: run"),
        ("draws", "rng = np", "sizes.append(1)\nprint(len(sizes))\nrng = np", "draws: run"),
    ],
    "names keep their kind": [
        ("deeper", "print(", "double = np.zeros(2)\nprint(", "an array of 1 axes, and a number"),
    ],
    "names of the symbol tables exist": [
        ("part-1", "`draws.std()`", "`draws.spread()`", "no attribute 'spread'"),
    ],
}  # fmt: skip
EARLIER = {  # what a planted cell needs in a cell above it
    "counter": "counter = iter(range(100))",
    "sizes": "sizes = []",
}


@pytest.mark.parametrize(
    ("rule", "cell_id", "old", "new", "says"),
    [(rule, *case) for rule, cases in PLANTED.items() for case in cases],
)
def test_finds_the_planted_fault_and_no_other(good, rule, cell_id, old, new, says):
    for word, line in EARLIER.items():
        if word in new:
            good = changed(good, "setup", "\n\nfrom", f"\n\n{line}\nfrom")
    found = faults(changed(good, cell_id, old, new))
    assert list(found) == [rule], found
    assert re.search(says, "\n".join(found[rule])), found


def test_a_lecture_may_read_a_file_that_lies_beside_it(good):
    (good.path.parent / "log.csv").write_text("1,2", encoding="utf-8")
    assert faults(changed(good, "draws", "print(", 'open("log.csv").close()\nprint(')) == {}


@pytest.mark.parametrize(
    ("line", "says"),
    [("print(next(counter))", None), ("assert next(counter) == 0", "AssertionError")],
)
def test_a_cell_that_shows_times_has_to_run_again_and_no_more(good, line, says):
    good = changed(good, "setup", "\n\nfrom", f"\n\n{EARLIER['counter']}\nfrom")
    timed = changed(good, "draws", "print(", f"{line}\nprint(")
    assert list(faults(timed)) == ["cells can be run again"]
    cell(timed, "draws").metadata.tags = ["nbval-ignore-output"]
    found = "\n".join(faults(stored(timed)).get("cells can be run again", ()))
    assert re.search(says, found) if says else found == ""


def figure(alt):
    return new_output("display_data", {"image/png": "AA=="}, metadata={"image/png": {"alt": alt}})


OUTPUTS = {
    "no errors or warnings": [
        (new_output("stream", name="stderr", text="FutureWarning: old\n"), "a warning"),
        (new_output("error", ename="KeyError", evalue="x", traceback=[]), "draws: KeyError"),
    ],
    "pictures have a text": [
        (figure("A line."), "draws: the alt text is 'A line.'"),
        (figure(""), "draws: the alt text is ''"),
    ],
    "nothing that differs from run to run": [
        (new_output("stream", text="/home/me/course"), "/home/"),
        (new_output("stream", text="<object at 0x7f3a12b4c5d6>"), "0x7f3a12b4c5d6"),
    ],
    "small enough to mail": [(new_output("stream", text="x" * 1_500_000), "1.5 MB")],
}


@pytest.mark.parametrize(
    ("rule", "output", "says"), [(rule, *case) for rule, cases in OUTPUTS.items() for case in cases]
)
def test_finds_what_must_not_be_stored(good, rule, output, says):
    cell(good, "draws").outputs = [output]
    found = faults(stored(good))
    assert list(found) == [rule]
    assert says in "\n".join(found[rule])


def test_finds_what_was_not_executed_in_order(good):
    cell(good, "draws").execution_count = 3
    cell(good, "figure").execution_count = None
    late, never = faults(stored(good))["executed in order"]
    assert late == "draws: is number 5, was executed as 3"
    assert never == "figure: is number 6, was executed as None"


def test_finds_metadata_that_differ_between_runs(good):
    cell(good, "draws").metadata.execution = {"iopub.status.busy": "2026-11-01"}
    good.nb.metadata.widgets = {}
    found = faults(stored(good))["nothing that differs from run to run"]
    assert found == ["metadata of the notebook: widgets", "draws: metadata execution"]


def test_finds_an_id_that_occurs_twice(good):
    text = good.path.read_text(encoding="utf-8").replace('"id": "draws"', '"id": "figure"')
    good.path.write_text(text, encoding="utf-8")
    assert faults(good) == {
        "valid with an id for each cell": ["figure: a second cell has this id"],
    }


def test_only_the_check_of_a_problem_set_may_be_long(good):
    rule = rules.STORED["cells fit the screen"]
    cell(good, "deeper").source += "\nprint(x)" * 19
    assert list(rule(good)) == ["deeper: 21 lines of code"]
    cell(good, "deeper").metadata.nbgrader = {"grade": True}
    assert list(rule(good)) == []


def test_finds_the_third_code_cell_without_a_word(good):
    good.nb.cells.remove(cell(good, "numbers-why"))
    found = faults(stored(good))
    assert found == {"prose introduces code": ["numbers: the third code cell without a word"]}


def test_what_is_allowed(good):
    """A pair from a function, a swap, a long text, splitting it outside of a function."""
    pair = "whole, rest = divmod(x, 2)\nwhole, rest = rest, whole\n"
    text = 'text = """' + "\n a; b = 1, 2" * 20 + '"""\nprint(text.split()[0])\n'
    good = changed(good, "numbers", "double = ", pair + "double = ")
    assert faults(changed(good, "deeper", "print(", text + "print(")) == {}


def test_another_seed_gives_every_cell_other_numbers(good):
    good = changed(good, "deeper", "print(", "others = rng.normal(size=100)\nprint(")
    means = set()
    for seed in (None, 0, 1):
        with rules.Session(good, seed) as session:
            for code in good.code:
                session.run(code)
        means |= {session.names["draws"].mean(), session.names["others"].mean()}
    assert len(means) == 6


def test_a_picture_is_compared_as_well(good):
    """It shows what no line prints: here, how often the cell above has run."""
    good = changed(good, "setup", "\n\nfrom", "\n\nsizes = [1, 2]\nfrom")
    good = changed(good, "numbers", "double = ", "sizes.append(3)\ndouble = ")
    good = changed(good, "figure", "plot(draws)", "plot(sizes)")
    (found,) = faults(good).values()
    assert any(text.startswith("figure: when the cells above have run twice") for text in found)
