"""Read what was handed in, whatever state it is in, and tell which cell is which.

Nothing of it is run here. What had to be repaired, and what a person should look at, comes back
as notes.
"""

import ast
import difflib
import json
import re
from dataclasses import dataclass, field

LARGEST = 400 << 20  # bytes of a file
LONGEST_CELL = 200_000  # characters
MOST_CELLS = 2000


class Unreadable(Exception):
    """Why a file cannot be graded, in words for the assistant."""


@dataclass
class Cell:
    kind: str
    source: str
    grade_id: str = ""


@dataclass
class Submission:
    cells: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    cut_off: bool = False


def read(data):
    """Return the cells of a notebook file, from bytes."""
    found = Submission()
    if not data.strip(b"\0 \t\r\n"):
        raise Unreadable("the file is empty")
    if len(data) > LARGEST:
        raise Unreadable(f"the file has {len(data) >> 20} MB")
    text = decoded(data, found.notes)
    try:
        notebook = json.loads(text)
    except RecursionError:
        raise Unreadable("its JSON is nested beyond reason") from None
    except ValueError:
        notebook = {"cells": whole_cells(text)}
        found.cut_off = True
        if not notebook["cells"]:
            raise Unreadable(not_a_notebook(text)) from None
        found.notes.append("the file is damaged: only its whole cells, up to there, were read")
    if not isinstance(notebook, dict):
        raise Unreadable("it is JSON, and no notebook")
    version = notebook.get("nbformat", 4)
    cells = notebook.get("cells")
    if cells is None and isinstance(notebook.get("worksheets"), list):
        cells = [c for sheet in notebook["worksheets"] for c in dict_of(sheet).get("cells", [])]
    if not isinstance(cells, list):
        raise Unreadable("it is JSON without cells, and no notebook")
    if version not in (3, 4):
        found.notes.append(f"nbformat {str(version)[:20]}: read as nbformat 4")
    if len(cells) > MOST_CELLS:
        raise Unreadable(f"it has {len(cells)} cells")
    for cell in map(dict_of, cells):
        source = cell.get("source", cell.get("input", ""))
        if isinstance(source, list):
            source = "".join(part for part in source if isinstance(part, str))
        source = source if isinstance(source, str) else ""
        source = source.encode("utf-8", "replace").decode()
        if len(source) > LONGEST_CELL:
            found.notes.append(f"a cell of {len(source)} characters was left out")
            continue
        about = dict_of(dict_of(cell.get("metadata")).get("nbgrader"))
        name = about.get("grade_id", "")
        kind = cell.get("cell_type")
        found.cells.append(Cell(str(kind), source, name if isinstance(name, str) else ""))
    return found


def dict_of(x):
    return x if isinstance(x, dict) else {}


def decoded(data, notes):
    """Return the text of a file; UTF-8 is expected, others are recognized."""
    marks = {b"\xef\xbb\xbf": "utf-8-sig", b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16"}
    encoding = next((name for mark, name in marks.items() if data.startswith(mark)), None)
    if encoding is None and data[:64].count(0) > 8:
        encoding = "utf-16-le" if data[1] == 0 else "utf-16-be"
    if encoding is None:
        try:
            return data.decode("utf-8")
        except UnicodeDecodeError as error:
            if error.end >= len(data) and error.reason == "unexpected end of data":
                return data.decode("utf-8", "replace")
            encoding = "cp1252"
    notes.append(f"the file is in {encoding.upper()}, not in UTF-8")
    return data.decode(encoding, "replace")


def whole_cells(text):
    """Return the cells of a damaged file that can still be read, in order."""
    start = re.search(r'"cells"\s*:\s*\[', text)
    cells, decoder = [], json.JSONDecoder()
    at = start.end() if start else len(text)
    while at < len(text):
        at = re.compile(r"[\s,]*").match(text, at).end()
        try:
            cell, at = decoder.raw_decode(text, at)
        except (ValueError, RecursionError):
            break
        cells.append(cell)
    return cells


def not_a_notebook(text):
    start = text.lstrip()[:200].lower()
    if start.startswith(("<!doctype", "<html")):
        return "it is a web page, and no notebook"
    if start.startswith("%pdf"):
        return "it is a PDF, and no notebook"
    if start.startswith("pk"):
        return "it is an archive, and no notebook"
    return "it is damaged: no whole cell can be read" if '"cells"' in text else "it is no notebook"


# --- Which cell is which ------------------------------------------------------------------------


def matched(submission, material):
    """Give each cell the name of the official one that it stands for; return notes."""
    notes = []
    official = {name for name, _, _ in material.released if name}
    for cell in submission.cells:
        if cell.grade_id not in official:
            cell.grade_id = ""
    kinds = {name: kind for name, kind, _ in material.released}
    for cell in submission.cells:
        if cell.grade_id and cell.kind != kinds[cell.grade_id]:
            notes.append(f"{cell.grade_id} is now a cell of another kind ({cell.kind})")
            cell.grade_id = ""
    there = {cell.grade_id for cell in submission.cells}
    lost = [entry for entry in material.released if entry[0] and entry[0] not in there]
    if lost:
        restored = [name for name, kind, source in lost if restore(submission, name, kind, source)]
        if restored:
            notes.append(f"recognized without their names: {', '.join(restored)}")
    return notes


def restore(submission, name, kind, source):
    """Find the cell that lost its name, by what it binds, says or is like."""
    names = bound(source)
    best, share = None, 0.0
    for cell in submission.cells:
        if cell.grade_id or cell.kind != kind or not cell.source.strip():
            continue
        by_names = kind == "code" and bool(names)
        like = len(names & bound(cell.source)) / len(names) if by_names else 0.0
        if like < 1:
            a, b = (" ".join(text.split())[:3000] for text in (source, cell.source))
            close = 1.0 if a == b else difflib.SequenceMatcher(None, a, b, False).quick_ratio()
            if kind == "markdown" and heading(source) and heading(source) == heading(cell.source):
                close = 1.0
            like = max(like, close if close > 0.9 else 0)
        if like > share:
            best, share = cell, like
    if best is None or share < 0.5:
        return False
    best.grade_id = name
    return True


def heading(source):
    found = re.search(r"^#+ .+$", source, re.MULTILINE)
    return found[0].strip() if found else None


def bound(source):
    """Return the names that a cell binds at its top level, also if its end does not parse."""
    from grading.material import bound as of_source

    return of_source(source) or set(re.findall(r"^(?:def )?(\w+)\s*(?:=(?!=)|\()", source, re.M))


# --- What a person should look at ---------------------------------------------------------------

REACHING = {
    r"\bsys\.modules\b": "sys.modules",
    r"_getframe|currentframe": "the frames of its callers",
    r"__code__|__globals__|__closure__|__builtins__": "the inside of functions",
    r"\bget_ipython\b|input_transformer|run_cell": "the notebook's machinery",
    r"\bimportlib\b|\breload\(": "the import of modules",
    r"\bsubprocess\b|\bos\.(system|popen|fork|kill|exec|_exit|spawn)|^\s*!": "other processes",
    r"\bsocket\b|\burllib\b|\brequests\b|\bhttp\.": "the network",
    r"\bctypes\b|\bgc\.|\binspect\b": "the interpreter",
    r"\bsignal\.": "signals",
    r"\b(exec|eval|compile)\(": "code made from text",
    r"""open\([^)]*,\s*["'][wax+]|\.write_(text|bytes)\(|\bshutil\.""": "files that it writes",
    r"gradebook|solutions/|\.\./\.\.|site-packages": "places outside its folder",
    r"__(given|answer)__|\bcheck\.(keep|part|restore|GIVEN)\b|progress\.json": (
        "the machinery of checks"
    ),
    r"def __(array|format|eq|float|index|repr|str|bool)\w*__": "objects that pretend",
}


def suspicions(cells, material):
    """Return what the code reaches for that no answer needs, and what it puts in others' place."""
    notes = []
    released = {name: source for name, _, source in material.released}
    for cell in cells:
        if cell.kind != "code" or cell.grade_id in material.by_check:
            continue
        if cell.grade_id and cell.source.split() == released[cell.grade_id].split():
            continue
        where = cell.grade_id or "a cell of its own"
        for pattern, what in REACHING.items():
            if re.search(pattern, cell.source, re.MULTILINE):
                notes.append(f"{where} reaches for {what}")
        replaced = replacements(cell.source)
        if replaced:
            notes.append(f"{where} replaces {', '.join(sorted(replaced))}")
    return notes


def replacements(source):
    """Return attributes of modules that a cell assigns to."""
    try:
        nodes = list(ast.walk(ast.parse(source)))
    except (SyntaxError, ValueError, RecursionError):
        return set()
    found = set()
    for node in nodes:
        targets = getattr(node, "targets", [getattr(node, "target", None)])
        for target in targets if isinstance(node, ast.Assign | ast.AugAssign) else ():
            root = target
            while isinstance(root, ast.Attribute | ast.Subscript):
                root = root.value
            attribute = isinstance(target, ast.Attribute) and isinstance(root, ast.Name)
            if attribute and root.id in ("am", "check", "np", "sp", "amrmetrics", "derivation"):
                found.add(ast.unparse(target))
    return found
