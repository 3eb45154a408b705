"""Find submissions: folders, flat folders, and the zip files of Moodle and Canvas.

Nothing is unpacked to a path that an archive names, and no link is followed.
"""

import io
import re
import zipfile
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

LARGEST = 400 << 20  # bytes of a file
LARGEST_TOGETHER = 4 << 30  # bytes of an archive, unpacked
OTHERS = {".ipynb_checkpoints", "__MACOSX", ".git"}
MOODLE = re.compile(r"^(?P<who>.+?)_(?P<number>\d+)_assignsubmission_\w+?_?(?P<rest>[^_].*)?$")
CANVAS = re.compile(r"^(?P<who>[^_]+)_(?:LATE_)?\d+_\d+_(?P<rest>.+)$")


@dataclass
class Found:
    """A file that was handed in, or why there is none."""

    student: str
    set: str
    place: str
    data: object = None  # a function that returns the bytes
    problem: str = ""
    notes: list = field(default_factory=list)


def find(folder, sets):
    """Return what each student handed in for each problem set, in the order of names."""
    found = [entry for path in entries(Path(folder)) if (entry := recognized(*path, sets))]
    chosen = {}
    for entry in found:
        chosen.setdefault((entry.student, entry.set), []).append(entry)
    return [one_of(chosen[key]) for key in sorted(chosen)]


def entries(path):
    """Yield (parts of the name, function that reads it, problem) of every file."""
    if path.is_file() and path.suffix.lower() == ".zip":
        yield from in_archive(path.read_bytes(), ())
        return
    for file in sorted(path.rglob("*")):
        parts = file.relative_to(path).parts
        if OTHERS & set(parts) or file.name.startswith("."):
            continue
        linked = any(p.is_symlink() for p in (file, *file.parents) if p.is_relative_to(path))
        if linked and path not in (file,):
            if file.suffix.lower() == ".ipynb" or file.is_symlink():
                yield parts, None, "it is a link, and links are not followed"
        elif not file.is_file():
            continue
        elif file.suffix.lower() == ".zip":
            yield from in_archive(file.read_bytes(), parts[:-1] + (file.stem,))
        elif file.stat().st_size > LARGEST:
            yield parts, None, f"the file has {file.stat().st_size >> 20} MB"
        else:
            yield parts, file.read_bytes, ""


def in_archive(data, before, depth=0):
    try:
        archive = zipfile.ZipFile(io.BytesIO(data))
        members = archive.infolist()
    except (zipfile.BadZipFile, ValueError, NotImplementedError, OSError):
        yield (*before, "archive.zip"), None, "the archive is damaged"
        return
    if sum(m.file_size for m in members) > LARGEST_TOGETHER:
        yield (*before, "archive.zip"), None, "the archive is too large when unpacked"
        return
    for member in members:
        name = member.filename.replace("\\", "/")
        parts = tuple(p for p in PurePosixPath(name).parts if p not in ("/", "..", "."))
        if member.is_dir() or OTHERS & set(parts) or not parts or parts[-1].startswith("."):
            continue
        if member.file_size > LARGEST:
            yield (*before, *parts), None, f"the file has {member.file_size >> 20} MB"
        elif name.lower().endswith(".zip") and depth < 2:
            with archive.open(member) as file:
                inner = file.read(LARGEST)
            yield from in_archive(
                inner, (*before, *parts[:-1], PurePosixPath(name).stem), depth + 1
            )
        else:
            yield (*before, *parts), reading(archive, member), ""


def reading(archive, member):
    def read():
        with archive.open(member) as file:
            return file.read(LARGEST)

    return read


def recognized(parts, data, problem, sets):
    """Return whose file this is and for which problem set; None for what is no submission."""
    name = parts[-1]
    notebook = bool(re.search(r"\.ipynb(\W*\w{0,4})?$", name, re.IGNORECASE))
    if not notebook and not problem and not looks_handed_in(name):
        return None
    student, rest = whose(parts)
    own = "/".join((*parts[:-1], rest))
    numbers = [s for s in sets if s in own] or [
        s
        for s in sets
        if re.search(rf"(?<!\d){s[:2]}[ _-]?{s[3:]}|{s[3:]}|(?<!\d){s[:2]}(?!\d)", own, re.I)
    ]
    entry = Found(student, numbers[0] if len(numbers) == 1 else "", "/".join(parts), data, problem)
    if not notebook and not problem:
        entry.problem = f"{name} is no notebook"
    if not entry.set and len(sets) == 1:
        entry.set = sets[0]
    if entry.set and PurePosixPath(rest).name != f"{entry.set}.ipynb" and notebook:
        entry.notes.append(f"the file is called {name}")
    return entry


def looks_handed_in(name):
    return name.lower().endswith((".pdf", ".html", ".docx", ".py", ".txt.ipynb", ".7z", ".rar"))


def whose(parts):
    """Return the student's name and the file's, as folders and learning platforms write them."""
    for k, part in enumerate(parts):
        moodle = MOODLE.match(part)
        if moodle:
            rest = moodle["rest"] if k == len(parts) - 1 and moodle["rest"] else parts[-1]
            return f"{moodle['who']} {moodle['number']}", rest
    if len(parts) > 1:
        return parts[0], parts[-1]
    canvas = CANVAS.match(parts[0])
    if canvas:
        return canvas["who"], re.sub(r"-\d+(?=\.\w+$)", "", canvas["rest"])
    stem = re.sub(r"\.ipynb.*$", "", parts[0], flags=re.IGNORECASE)
    who = re.sub(r"[ _-]*\d\d[_ -][a-z_]+?[ _-]*(?:\(\d+\))?$", "", stem)
    return who.strip(" _-") or stem, parts[0]


def one_of(entries):
    """Return the file that counts: the one with the official name, else the newest by its name."""
    readable = [e for e in entries if not e.problem]
    if not readable:
        return entries[0]
    official = [e for e in readable if e.place.endswith(f"{e.set}.ipynb")]
    notebooks = [e for e in readable if not e.problem]
    chosen = (official or sorted(notebooks, key=lambda e: (len(e.place), e.place)))[-1]
    if len(entries) > 1:
        places = ", ".join(e.place for e in entries if e is not chosen)
        chosen.notes.append(f"of {len(entries)} files, {chosen.place} counts; not: {places}")
    return chosen
