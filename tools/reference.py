"""Write the sheet that binds the lectures: ``.venv/bin/python tools/reference.py``.

It is made from what stands in the lectures (tables of symbols, summaries, minutes) and from
``tests/ledger.csv``, so that it says nothing that they do not say. A page and no notebook: there is
nothing in it to run, and JupyterLab, a browser and GitHub show it with its links.
"""

import csv
import re
import sys
from collections import defaultdict
from pathlib import Path

import nbformat

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "notebooks" / "reference.md"

# Which parts, by lecture: what is left out is named by the page.
PLANS = {
    "A talk of two hours": {"00": [2, 3], "03": [0, 2], "04": [0, 3, 4], "09": [0]},
    "A day": {"00": [2, 3, 4], "02": [0, 2], "03": [0, 2, 4], "04": [0, 1, 3, 4], "09": [0, 2, 6]},
}


def lectures():
    """Return the notebooks by their names, in order."""
    paths = sorted((ROOT / "notebooks").glob("[0-9]*.ipynb"))
    return {path.stem: nbformat.read(path, 4) for path in paths}


def tables(notebook, first):
    """Yield the rows of each table whose head begins with a word, as lists of columns."""
    for cell in notebook.cells:
        inside = False
        for line in cell.source.splitlines() if cell.cell_type == "markdown" else ():
            columns = [column.strip() for column in re.split(r"(?<!\\)\|", line.strip())[1:-1]]
            if not columns:
                inside = False
            elif inside and not set("".join(columns)) <= set("-: "):
                yield columns
            elif columns[0] == first:
                inside = True


def headings(notebook):
    """Yield (title, id of the first cell, ids of the cells) for each heading of level two."""
    title, ids = "", []
    for cell in notebook.cells:
        found = re.search(r"^## (.+)$", cell.source, re.M) if cell.cell_type == "markdown" else None
        if found:
            yield title, ids
            title, ids = found[1].strip(), []
        ids.append(cell.id)
    yield title, ids


def summary(notebook):
    """Return the anchor of the summary."""
    prose = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    return re.search(r"^#+ (Summary.*)$", prose, re.M)[1].strip().replace(" ", "-")


def parts(notebook):
    """Return the minutes of each numbered part."""
    found = {}
    for title, _ in headings(notebook):
        part = re.match(r"Part (\d+) .*\((\d+) minutes?\)", title)
        if part:
            found[int(part[1])] = int(part[2])
    return found


def symbols(notebooks):
    """Return {symbol: [(lecture, meaning, unit, Python)]}; a cell of a table may hold several."""
    found = defaultdict(list)
    for name, notebook in notebooks.items():
        for columns in tables(notebook, "Symbol"):
            if len(columns) == 4:
                found[columns[0]].append((name[:2], *columns[1:]))
    return found


def contradictions(notebooks):
    """Yield (lecture, symbol) for symbols that two tables of one lecture explain differently."""
    for symbol, rows in symbols(notebooks).items():
        for lecture in sorted({row[0] for row in rows}):
            meanings = {row[1] for row in rows if row[0] == lecture}
            if len(meanings) > 1:
                yield lecture, symbol


def place(notebooks, written, room):
    """Return a link for `02_alignment#d1` to the part that holds the cell."""
    name, cell = written.split("#")
    if room == "solutions":
        return f"[{name[:2]} {cell.removeprefix('part-')}](../exercises/{name}/{name}.ipynb)"
    for title, ids in headings(notebooks[name]):
        if cell in ids:
            anchor = f"#{title.replace(' ', '-')}" if title else ""
            return f"[{name[:2]} {cell}]({name}.ipynb{anchor})"
    raise LookupError(written)


def ledger(notebooks):
    """Yield the rows of the ledger with links."""
    rooms = {"derived": "notebooks", "verified": "notebooks", "practised": "solutions"}
    with (ROOT / "tests" / "ledger.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            links = [
                " ".join(place(notebooks, x, rooms[room]) for x in row[room].split() if x != "-")
                for room in rooms
            ]
            names = " ".join(f"`{x}`" for x in row["implemented"].split() if x != "-")
            yield [row["id"], row["statement"].replace("|", r"\|"), *links[:2], names, links[2]]


def plan(notebooks, chosen):
    """Yield one line a lecture, and the sum."""
    total = 0
    for name, notebook in notebooks.items():
        if name[:2] in chosen:
            minutes = parts(notebook)
            taken = [minutes[part] for part in chosen[name[:2]]]
            total += sum(taken)
            numbers = ", ".join(str(part) for part in chosen[name[:2]])
            yield f"- [{name[:2]}]({name}.ipynb), parts {numbers}: {sum(taken)} minutes"
    yield f"- Together {total} minutes, before questions and breaks."


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(columns)} |" for columns in lines)


def page(notebooks):
    """Return the whole page."""
    found = symbols(notebooks)
    letters = [
        [symbol, meaning, unit, python, lecture]
        for symbol, rows in sorted(found.items(), key=lambda item: item[0].lower())
        for lecture, meaning, unit, python in rows
    ]
    results = [
        [f"[{name[:2]}]({name}.ipynb#{summary(notebook)})", *columns[:3]]
        for name, notebook in notebooks.items()
        for columns in tables(notebook, "Result")
    ]
    cores = {name: sum(parts(notebook).values()) for name, notebook in notebooks.items()}
    half = [f"- [{name[:2]}]({name}.ipynb): {minutes} minutes" for name, minutes in cores.items()]
    chapters = [
        "# Reference: letters, results, places, plans",
        "Made from the tables of the lectures and from `tests/ledger.csv` by `tools/reference.py`.",
        "## Plans",
        *(f"### {name}\n\n" + "\n".join(plan(notebooks, parts)) for name, parts in PLANS.items()),
        "### Half a semester\n\nThe core of one lecture a week, with its problem set:\n\n"
        + "\n".join([*half, f"- Together {sum(cores.values())} minutes of lectures."]),
        "## Results",
        table(["Lecture", "Result", "Steps", "Status"], results),
        "## Where each formula of the source lesson stands",
        table(
            ["", "Formula", "Derived", "Verified", "In the library", "Practiced"], ledger(notebooks)
        ),
        "## Letters",
        "A letter has one meaning in a lecture; the last column says in which.",
        table(["Symbol", "Meaning", "Unit or range", "Python", "Lecture"], letters),
    ]
    return "\n\n".join(chapters) + "\n"


def main():
    PAGE.write_text(page(lectures()), encoding="utf-8", newline="\n")
    print(f"Written: {PAGE.relative_to(ROOT)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
