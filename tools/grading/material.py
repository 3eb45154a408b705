"""What a grader knows of a problem set: the official cells, and which names are answers."""

import ast
import json
import re
import symtable
from dataclasses import dataclass, field
from pathlib import Path

MARKER = re.compile(r"^\s*### (BEGIN|END) (SOLUTION|HIDDEN TESTS)", re.MULTILINE)


@dataclass
class Part:
    """A part that is checked by code, or waits for a person (then there is no check)."""

    name: str
    points: float
    title: str = ""
    stub: str = ""
    check_id: str = ""
    check: str = ""
    shown_check: str = ""
    names: tuple = ()
    rubric: str = ""
    by_hand: bool = False
    broken: str = ""


@dataclass
class Material:
    name: str
    data: Path
    setup: dict = field(default_factory=dict)
    parts: dict = field(default_factory=dict)
    released: list = field(default_factory=list)
    texts: dict = field(default_factory=dict)
    answers: dict = field(default_factory=dict)
    space: dict = field(default_factory=dict)

    @property
    def points(self):
        return sum(part.points for part in self.parts.values())

    @property
    def by_check(self):
        return {part.check_id: part for part in self.parts.values() if part.check_id}


def load(root, name):
    """Return the material of a problem set in solutions/ and exercises/."""
    solution = cells_of(root / "solutions" / name / f"{name}.ipynb")
    exercise = {c["id"]: c for c in cells_of(root / "exercises" / name / f"{name}.ipynb")}
    material = Material(name, root / "exercises" / name)
    part, title, answers = None, "", {}
    for cell in solution:
        shown = exercise.get(cell["id"], {"source": ""})["source"]
        material.released.append((cell["id"], cell["kind"], shown))
        headings = re.findall(r"^## (.+)$", cell["source"], re.MULTILINE)
        title = headings[-1] if cell["kind"] == "markdown" and headings else title
        if cell["kind"] == "markdown":
            material.texts[title] = shown
        if cell["grade"] and cell["solution"]:
            rubric = "\n\n".join(regions(cell["source"], "SOLUTION"))
            material.parts[cell["id"]] = Part(
                cell["id"], cell["points"], title, shown, rubric=rubric, by_hand=True
            )
        elif cell["solution"]:
            part = Part(cell["id"], 0, title, shown)
            material.parts[part.name] = part
            answers[part.name] = bound(cell["source"])
            material.answers[part.name] = cell["source"]
        elif cell["grade"]:
            part.points, part.check_id = cell["points"], cell["id"]
            part.check, part.shown_check = cell["source"], shown
        elif cell["kind"] == "code":
            material.setup[cell["id"]] = cell["source"]
    given = set().union(*map(bound, material.setup.values())) if material.setup else set()
    # An answer may be used by a later check, under the name that its own part gave it.
    known = set()
    for part in material.parts.values():
        known |= answers.get(part.name, set()) - given
        part.names = asked(part.check) or tuple(sorted(used(part.check) & known))
    return material


def cells_of(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    return [
        {
            "id": about.get("grade_id"),
            "kind": cell["cell_type"],
            "source": "".join(cell["source"]),
            "grade": about.get("grade", False),
            "solution": about.get("solution", False),
            "points": about.get("points", 0),
        }
        for cell in notebook["cells"]
        for about in [cell["metadata"].get("nbgrader", {})]
    ]


def regions(source, what):
    pattern = rf"^[ \t]*### BEGIN {what}\n(.*?)^[ \t]*### END {what}"
    return re.findall(pattern, source, re.DOTALL | re.MULTILINE)


def top_level(source):
    try:
        return symtable.symtable(source, "cell", "exec")
    except (SyntaxError, ValueError, RecursionError):
        return None


def bound(source):
    """Return the names that a cell binds at its top level."""
    table = top_level(source)
    if table is None:
        return set()
    return {s.get_name() for s in table.get_symbols() if s.is_assigned() or s.is_imported()}


def used(source):
    """Return the names that a cell reads from the notebook, also within functions."""
    found, todo = set(), [top_level(source)]
    while todo:
        table = todo.pop()
        if table is None:
            continue
        top = table.get_type() == "module"
        for s in table.get_symbols():
            if s.is_referenced() and (top or s.is_global()):
                found.add(s.get_name())
        todo += table.get_children()
    return found


def asked(source):
    """Return the names that a check asks for as the parameters of its function."""
    found = []
    for node in ast.parse(source).body if source else ():
        if isinstance(node, ast.FunctionDef):
            calls = [d.func for d in node.decorator_list if isinstance(d, ast.Call)]
            if any(ast.unparse(call) == "check.part" for call in calls):
                found += [a.arg for a in node.args.posonlyargs + node.args.args]
    return tuple(found)
