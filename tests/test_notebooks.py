"""Every committed notebook keeps the rules of tests/rules.py, and every claim at many seeds.

nbval, which runs beside these tests, executes each notebook and compares its outputs.
It accepts a notebook that was never executed, compares no pictures and knows no rules
of style; that is what these tests are for.
"""

import base64
import csv
import functools
from pathlib import Path

import pytest
import rules

import amrmetrics as am

ROOT = Path(__file__).parents[1]
LECTURES = sorted((ROOT / "notebooks").glob("*.ipynb"))
SOLUTIONS = sorted((ROOT / "solutions").glob("*/*.ipynb"))

read = functools.cache(rules.Notebook.read)


def label(value):
    return value.stem if isinstance(value, Path) else value


def test_there_are_notebooks():
    assert LECTURES
    assert SOLUTIONS


def test_the_picture_in_the_readme_is_the_map_of_lecture_00():
    pictures = [
        base64.b64decode(output.data["image/png"])
        for _, output in read(ROOT / "notebooks" / "00_start_here.ipynb").outputs
        if "image/png" in output.get("data", {})
    ]
    assert (ROOT / "notebooks" / "00_start_here.png").read_bytes() == pictures[0]


@pytest.mark.parametrize("path", LECTURES + SOLUTIONS, ids=lambda p: f"{p.parent.name}/{p.stem}")
@pytest.mark.parametrize("rule", rules.STORED)
def test_every_notebook(path, rule):
    assert not list(rules.STORED[rule](read(path)))


@pytest.mark.parametrize(
    ("path", "rule"),
    [(path, rule) for path in LECTURES for rule in rules.LECTURE | rules.AGAIN],
    ids=label,
)
def test_lecture(path, rule):
    assert not list((rules.LECTURE | rules.AGAIN)[rule](read(path)))


@pytest.mark.parametrize("path", SOLUTIONS, ids=label)
@pytest.mark.parametrize("rule", ["one statement a line", "code fits the column"])
def test_problem_set_is_read_aloud(path, rule):
    assert not list(rules.LECTURE[rule](read(path)))


@pytest.mark.parametrize("path", LECTURES, ids=label)
def test_claims_hold_at_other_seeds(path, request):
    if not any("default_rng(" in cell.source for cell in read(path).code):
        return
    for seed in range(20 if request.config.getoption("--sweep") else 1):
        with rules.Session(read(path), seed) as session:
            for cell in read(path).code:
                session.run(cell)


class TestLedger:
    """Every formula of the source lesson: derived, verified, implemented and practiced where."""

    TEXT = (ROOT / "tests" / "ledger.csv").read_text(encoding="utf-8")
    ROWS = list(csv.DictReader(TEXT.splitlines()))

    def test_has_a_row_for_every_formula_and_problem(self):
        expected = [f"F{k:02}" for k in range(1, 28)] + [f"P{k}" for k in range(1, 6)]
        assert [row["id"] for row in self.ROWS] == expected

    @pytest.mark.parametrize("row", ROWS, ids=lambda row: row["id"])
    def test_leads_to_places_that_exist(self, row):
        written = [path.stem for path in LECTURES if path.stem[:2] in row["lecture"].split()]
        for room, folder in (
            ("derived", "notebooks"),
            ("verified", "notebooks"),
            ("practised", "solutions"),
        ):
            places = row[room].split()
            if row["lecture"].split()[0] in [name[:2] for name in written]:
                assert places, f"{room}: the lecture exists, but no place is given"
            for place in places:
                if place == "-":
                    continue
                name, cell_id = place.split("#")
                pattern = f"{name}.ipynb" if folder == "notebooks" else f"{name}/{name}.ipynb"
                ids = [cell.id for cell in read(ROOT / folder / pattern).nb.cells]
                assert cell_id in ids, f"{room}: {place}"
        for name in row["implemented"].split():
            assert name == "-" or getattr(am, name)
