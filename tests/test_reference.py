"""The sheet that binds the lectures says what they say, and its links lead somewhere."""

import re
from urllib.parse import unquote

import nbformat
import pytest
import reference
import rules

NOTEBOOKS = reference.lectures()


def test_the_page_is_made_from_the_lectures_as_they_are():
    page = reference.PAGE.read_text(encoding="utf-8")
    assert page == reference.page(NOTEBOOKS), "run .venv/bin/python tools/reference.py"


def test_no_letter_has_two_meanings_in_one_lecture():
    assert not list(reference.contradictions(NOTEBOOKS))


def test_a_second_meaning_in_one_lecture_is_found():
    head = "| Symbol | Meaning | Unit | Python |\n|---|---|---|---|\n"
    cells = [f"{head}| $q$ | {meaning} | m | - |" for meaning in ("a length", "a probability")]
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_markdown_cell(x) for x in cells])
    assert list(reference.contradictions({"03_made_up": notebook})) == [("03", "$q$")]


@pytest.mark.parametrize(("plan", "most"), [("A talk of two hours", 120), ("A day", 300)])
def test_a_plan_fits_its_time(plan, most):
    *lines, total = reference.plan(NOTEBOOKS, reference.PLANS[plan])
    minutes = [int(re.search(r"(\d+) minutes", line)[1]) for line in lines]
    assert f"Together {sum(minutes)} minutes" in total
    assert 0.7 * most <= sum(minutes) <= most


def test_links_lead_to_headings_that_exist():
    links = re.findall(
        r"\]\(([^()\s]+\.ipynb)(?:#((?:[^()\s]|\([^()\s]*\))+))?\)", reference.page(NOTEBOOKS)
    )
    assert len(links) > 100
    for target, anchor in links:
        path = (reference.PAGE.parent / target).resolve()
        assert path.is_file(), target
        if anchor:
            notebook = rules.Notebook.read(path)
            assert unquote(anchor) in rules.anchors(notebook), (target, anchor)
