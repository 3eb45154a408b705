"""Every committed notebook keeps the rules of tests/rules.py, and every claim at many seeds.

nbval, which runs beside these tests, executes each notebook and compares its outputs.
It accepts a notebook that was never executed, compares no pictures and knows no rules
of style; that is what these tests are for.
"""

import base64
import csv
import functools
import tomllib
from pathlib import Path

import pytest
import rules

import amrmetrics as am

ROOT = Path(__file__).parents[1]
LECTURES = sorted((ROOT / "notebooks").glob("*.ipynb"))
SOLUTIONS = sorted((ROOT / "solutions").glob("*/*.ipynb"))

# Lectures that are still to be rewritten, and the rules that they may break until then.
OLD_FORM = {
    "03_trajectory",
}
FORGIVEN = {
    "code fits the column",
    "one statement a line",
    "no parser and no helper for derivations",
    "leads to its neighbors",
    "minutes add up",
    "letters are explained",
    "each cell that draws has its own seed",
    "cells can be run again",
    "names keep their kind",
}

read = functools.cache(rules.Notebook.read)


def label(value):
    return value.stem if isinstance(value, Path) else value


def old(path):
    return path.stem in OLD_FORM


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
    [
        (path, rule)
        for path in LECTURES
        for rule in rules.LECTURE | rules.AGAIN
        if not (old(path) and rule in FORGIVEN)
    ],
    ids=label,
)
def test_lecture(path, rule):
    assert not list((rules.LECTURE | rules.AGAIN)[rule](read(path)))


@pytest.mark.parametrize("name", sorted(OLD_FORM))
def test_what_is_listed_as_old_is_old(name):
    """A lecture that keeps the rules leaves the list, and is held to them from then on."""
    notebook = read(ROOT / "notebooks" / f"{name}.ipynb")
    kept = [rule for rule in FORGIVEN - set(rules.AGAIN) if not list(rules.LECTURE[rule](notebook))]
    assert len(kept) < len(FORGIVEN - set(rules.AGAIN)), f"take {name} off the list OLD_FORM"


def test_the_formatter_knows_the_same_old_lectures():
    settings = tomllib.loads((ROOT / "notebooks" / "ruff.toml").read_text(encoding="utf-8"))
    assert {Path(name).stem for name in settings["format"]["exclude"]} == OLD_FORM


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
