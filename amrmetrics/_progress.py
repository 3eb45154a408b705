"""Which parts of which problem sets hold, and when a model answer may be seen.

One small file, ``my_work/progress.json``, notes the last outcome of each check and the answers that
were tried. It is for the student alone: nothing is graded by it, and without it everything works.
"""

import contextlib
import hashlib
import json
import os
import re
import types
from pathlib import Path

TRIES = 3  # different wrong answers until the model answer may be seen
WORDS = 20  # of the student's own, until the model text of a question in prose may be seen


def record(part, text, held):
    """Note an attempt at a part of the problem set in whose folder this runs.

    Parameters
    ----------
    part : str
        The letter of the part.
    text : str
        What the student's answers say, each in the words of `check`.
    held : bool
        Whether the check passed.

    Returns
    -------
    str or None
        What to tell the student; None outside of ``my_work``, or if there is nothing to tell.
    """
    try:
        return _recorded(_here(), part, text, held)
    except (OSError, ValueError, LookupError, TypeError):
        return None  # no place to note it, or no problem set of this name: the check is what counts


def _recorded(folder, part, text, held):
    if folder is None:
        return None
    notes = read(folder.parent)
    entry = notes.setdefault(folder.name, {}).setdefault(part, _entry({}))
    was_open = entry["opened"]
    answer = hashlib.sha256(text.encode(errors="replace")).hexdigest()[:16]
    if not held and answer not in entry["tries"] and not _is_stub(folder, part, text):
        entry["tries"] = [*entry["tries"], answer][-TRIES:]
    entry["holds"] = held
    entry["opened"] = was_open or held or len(entry["tries"]) >= TRIES
    _write(folder.parent / "progress.json", notes)
    parts = _checked_parts(_cells(folder, "exercises"))
    count = _count(parts, notes[folder.name]).capitalize()
    said = [f"{count} of set {folder.name[:2]} hold."] if held else []
    if entry["opened"] and not was_open:
        said.append(f'check.model_answer("{part}") shows the model answer.')
    return " ".join(said) or None


def model_answer(part):
    """Display the model answer of a part, or say what is needed before it may be seen.

    It may be seen when the part holds or after three different answers that did not; that of a
    question in prose when a text of the student's own is saved in its place.

    Parameters
    ----------
    part : str
        The letter of the part.
    """
    folder = _here()
    if folder is None:
        print("Model answers are shown in the problem sets of the folder my_work.")
        return
    try:
        cells = _cells(folder, "solutions")
    except (OSError, ValueError, LookupError):
        print("This copy of the course has no model answers.")
        return
    part = str(part).strip().lower()
    if f"prose-{part}" in cells:
        _show_prose(folder, cells, part)
    elif f"part-{part}" in cells:
        _show_code(folder, cells, part)
    else:
        letters = [name[-1] for name in cells if re.match("(part|prose)-", name)]
        print(f"There is no part {part}. The parts of this set: {', '.join(letters)}.")


def _show_code(folder, cells, part):
    entry = read(folder.parent).get(folder.name, {}).get(part, _entry({}))
    if not entry["opened"]:
        left = TRIES - len(entry["tries"])
        tries = "one more answer" if left == 1 else f"{left} more different answers"
        print(f"Not yet: try {tries} with the check of part {part}. Then the model answer opens.")
        return
    from IPython.display import Code, display

    marker = re.compile(r"\s*### (BEGIN|END) SOLUTION\s*")
    lines = [line for line in cells[f"part-{part}"].splitlines() if not marker.fullmatch(line)]
    display(Code("\n".join(lines), language="python"))


def _show_prose(folder, cells, part):
    name = f"prose-{part}"
    question = _cells(folder, "exercises")[name].splitlines()
    words = 0
    for path in folder.glob("*.ipynb"):
        with contextlib.suppress(OSError, ValueError, LookupError):
            own = [line for line in _cells_of(path)[name].splitlines() if line not in question]
            words = max(words, len(" ".join(own).split()))
    if words < WORDS:
        print(
            f"Not yet: write your own answer to part {part} first ({WORDS} words or more), and "
            "save the notebook. Then the model answer opens."
        )
        return
    from IPython.display import Markdown, display

    text = cells[name].partition("### BEGIN SOLUTION")[2].partition("### END SOLUTION")[0]
    display(Markdown(text.strip()))


def read(my_work):
    """Return what is noted, by set and part; a file that is damaged counts as an empty one."""
    try:
        notes = json.loads((my_work / "progress.json").read_text(encoding="utf-8"))
        return {
            name: {part: _entry(entry) for part, entry in parts.items()}
            for name, parts in notes.items()
        }
    except (OSError, ValueError, TypeError, AttributeError, RecursionError):
        return {}


def _entry(noted):
    return {
        "holds": bool(noted.get("holds")),
        "opened": bool(noted.get("opened")),
        "tries": [str(answer) for answer in noted.get("tries", ())],
    }


def _write(path, notes):
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    try:
        part.write_text(json.dumps(notes, indent=1), encoding="utf-8")
        os.replace(part, path)
    except OSError:
        with contextlib.suppress(OSError):
            part.unlink(missing_ok=True)


def _here():
    folder = Path.cwd()
    in_set = folder.parent.name == "my_work" and re.fullmatch(r"\d\d_\w+", folder.name)
    return folder if in_set else None


def _cells(folder, house):
    return _cells_of(folder.parents[1] / house / folder.name / f"{folder.name}.ipynb")


def _cells_of(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    return {
        cell["metadata"]["nbgrader"]["grade_id"]: "".join(cell["source"])
        for cell in notebook["cells"]
        if "nbgrader" in cell["metadata"]
    }


def _checked_parts(cells):
    return [name.removeprefix("check-") for name in cells if name.startswith("check-")]


def _is_stub(folder, part, text):
    """Tell whether each answer is one of the dots, or a function as it was handed out."""
    from amrmetrics import check

    cell = compile(_cells(folder, "exercises")[f"part-{part}"], "part", "exec")
    functions = [x for x in cell.co_consts if isinstance(x, types.CodeType)]
    return set(text.split("\n")) <= {repr(...), *map(check._text_of, functions)}


def _count(parts, noted):
    held = sum(part in noted and noted[part]["holds"] for part in parts)
    return f"all {held} parts" if held == len(parts) else f"{held} of {len(parts)} parts"


def main():
    """Print one line a problem set: the letters of the parts that hold."""
    my_work = Path.cwd() / "my_work"
    notes = read(my_work)
    for source in sorted((my_work.parent / "exercises").glob("[0-9]*")):
        folder = my_work / source.name
        noted = notes.get(source.name, {})
        parts = _checked_parts(_cells(folder, "exercises"))
        marks = [part if part in noted and noted[part]["holds"] else "." for part in parts]
        begun = any(entry["holds"] or entry["tries"] for entry in noted.values())
        said = f"{_count(parts, noted)} hold" if begun else "not begun"
        print(f"{source.name.replace('_', ' '):15} {' '.join(marks)}   {said}")
    print("A letter is a part whose check held when it last ran; texts are read by a person.")


if __name__ == "__main__":
    main()
