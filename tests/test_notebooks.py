"""The rules that every committed lecture and solution keeps, and every claim at many seeds.

nbval, which runs beside these tests, executes each notebook and compares its outputs.
It accepts a notebook that was never executed, compares no pictures and knows no rules
of style; that is what these tests are for.
"""

import base64
import csv
import json
import re
from pathlib import Path
from statistics import median

import nbformat
import pytest

import amrmetrics as am

ROOT = Path(__file__).parents[1]
LECTURES = sorted((ROOT / "notebooks").glob("*.ipynb"))
SOLUTIONS = sorted((ROOT / "solutions").glob("*/*.ipynb"))

each_lecture = pytest.mark.parametrize("path", LECTURES, ids=lambda path: path.stem)
each_notebook = pytest.mark.parametrize(
    "path", LECTURES + SOLUTIONS, ids=lambda path: f"{path.parent.name}/{path.stem}"
)


def read(path):
    return nbformat.read(path, as_version=4)


def cells(path, kind):
    return [cell for cell in read(path).cells if cell.cell_type == kind]


def outputs(path):
    return [(cell, output) for cell in cells(path, "code") for output in cell.outputs]


def test_there_are_notebooks():
    assert LECTURES
    assert SOLUTIONS


def test_the_picture_in_the_readme_is_the_map_of_lecture_00():
    pictures = [
        base64.b64decode(output.data["image/png"])
        for _, output in outputs(ROOT / "notebooks" / "00_start_here.ipynb")
        if "image/png" in output.get("data", {})
    ]
    assert (ROOT / "notebooks" / "00_start_here.png").read_bytes() == pictures[0]


@each_notebook
class TestCommittedState:
    def test_is_valid_and_every_cell_has_its_own_id(self, path):
        nbformat.validate(json.loads(path.read_text(encoding="utf-8")))
        ids = [cell["id"] for cell in read(path).cells]
        assert len(set(ids)) == len(ids)

    def test_was_executed_in_order_in_a_fresh_kernel(self, path):
        counts = [cell.execution_count for cell in cells(path, "code")]
        assert counts == list(range(1, len(counts) + 1))

    def test_has_no_errors_and_no_warnings(self, path):
        for cell, output in outputs(path):
            assert output.output_type != "error", cell["id"]
            assert output.get("name") != "stderr", cell["id"]
            assert "Warning" not in output.get("text", ""), cell["id"]

    def test_stores_no_time_stamps_and_no_widget_state(self, path):
        notebook = read(path)
        assert set(notebook.metadata) <= {"kernelspec", "language_info"}
        assert notebook.metadata.kernelspec.name == "python3"
        for cell in notebook.cells:
            assert set(cell.metadata) <= {"tags", "nbgrader", "slideshow"}, cell["id"]

    def test_names_no_place_of_one_machine(self, path):
        text = path.read_text(encoding="utf-8")
        assert not re.search(
            r"/(root|home|Users|tmp|work|opt)/|[A-Z]:\\\\Users|0x[0-9a-f]{6,}", text
        )

    def test_is_small_enough_to_mail(self, path):
        assert path.stat().st_size < 1.5e6

    def test_every_figure_has_alt_text(self, path):
        for cell, output in outputs(path):
            if "image/png" in output.get("data", {}):
                alt = output.metadata.get("image/png", {}).get("alt", "")
                assert len(alt.split()) >= 6, cell["id"]

    def test_every_cell_is_short(self, path):
        lines = {cell["id"]: code_lines(cell) for cell in cells(path, "code")}
        assert max(lines.values()) <= 20, max(lines, key=lines.get)

    def test_spelling_and_tone(self, path):
        banned = (
            r"\b(obviously|clearly|trivial(ly)?|of course|colour\w*|behaviour\w*|cent(re|red|res)|"
            r"(normal|minim|optim|linear|recogn|general)is(e|ed|es|ing|er|ation))\b"
        )
        for cell in cells(path, "markdown"):
            prose = re.sub(r"`[^`]*`|\$[^$]*\$", "", cell.source)
            found = re.search(banned, prose, re.IGNORECASE)
            assert not found, f"{cell['id']}: {found[0]}"
            emoji = re.search("[\U0001f000-\U0001faff\u2600-\u26ff]", prose)
            assert not emoji, f"{cell['id']}: {emoji[0]}"


def code_lines(cell):
    return len([line for line in cell.source.splitlines() if line.strip()])


@each_lecture
class TestLecture:
    def test_has_the_size_of_a_lecture(self, path):
        lines = [code_lines(cell) for cell in cells(path, "code")]
        words = sum(len(cell.source.split()) for cell in cells(path, "markdown"))
        assert 45 <= len(read(path).cells) <= 70
        assert 1800 <= words <= 3000
        assert 100 <= sum(lines) <= 180
        assert median(lines) <= 5

    def test_opens_with_a_header_and_a_setup(self, path):
        first, second = read(path).cells[0], cells(path, "code")[0]
        assert first.cell_type == "markdown"
        assert first.source.startswith("# ")
        for word in ("minutes", "Prerequisites", "able to"):
            assert word in first.source, word
        assert code_lines(second) <= 6

    def test_closes_with_questions_summary_and_references(self, path):
        prose = "\n".join(cell.source for cell in cells(path, "markdown"))
        for heading in ("Check yourself", "Summary", "References"):
            assert re.search(rf"^#+ {heading}", prose, re.MULTILINE), heading
        questions = prose.split("Check yourself")[-1].split("Summary")[0]
        assert questions.count("<details>") == questions.count("</details>") == 3

    def test_prose_introduces_the_code(self, path):
        kinds = [cell.cell_type for cell in read(path).cells]
        assert all(kinds[k : k + 3] != ["code"] * 3 for k in range(len(kinds)))

    def test_what_a_figure_claims_is_printed_and_asserted(self, path):
        for cell in cells(path, "code"):
            interactive = "nbval-ignore-output" in cell.metadata.get("tags", [])
            if "plotting.show" in cell.source and not interactive:
                near = "\n".join(
                    c.source for c in neighbours(cells(path, "code"), cell) if "assert" in c.source
                )
                assert near, f"{cell['id']}: no assertion near the figure"


def neighbours(all_cells, cell):
    k = all_cells.index(cell)
    return all_cells[max(k - 1, 0) : k + 2]


def run(path, seed=None):
    """Execute the code cells in one fresh namespace; with `seed`, the rng starts there."""
    namespace = {"__name__": "__main__"}
    for cell in cells(path, "code"):
        source = cell.source
        if seed is not None:
            source = re.sub(r"default_rng\(\d+\)", f"default_rng({seed})", source)
        exec(compile(source, f"{path.stem}, cell {cell['id']}", "exec"), namespace)
    return namespace


@each_lecture
def test_symbol_table_names_what_the_notebook_defines(path):
    table = next(
        cell.source for cell in cells(path, "markdown") if re.search(r"\|\s*Python", cell.source)
    )
    rows = [line.split("|")[-2] for line in table.splitlines() if line.strip().endswith("|")][2:]
    names = [name for row in rows for name in re.findall(r"`([^`]+)`", row)]
    assert names
    namespace = run(path)
    for name in names:
        try:
            eval(name, namespace)
        except Exception as error:
            pytest.fail(f"`{name}` of the symbol table: {error!r}")


@each_lecture
def test_claims_hold_at_other_seeds(path, request, capsys):
    if not any("default_rng(" in cell.source for cell in cells(path, "code")):
        return
    for seed in range(20 if request.config.getoption("--sweep") else 1):
        run(path, seed)


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
                ids = [cell["id"] for cell in read(ROOT / folder / pattern).cells]
                assert cell_id in ids, f"{room}: {place}"
        for name in row["implemented"].split():
            assert name == "-" or getattr(am, name)
