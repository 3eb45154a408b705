"""Make the students' version of every problem set: ``python3 course.py release [FOLDER]``.

What nbgrader's own command does, for all problem sets at once and without its database.
"""

import argparse
import logging
import shutil
import sys
import tempfile
from pathlib import Path

from nbgrader.converters import GenerateAssignment
from nbgrader.converters.base import NbGraderException
from nbgrader.coursedir import CourseDirectory
from traitlets.config import PyFileConfigLoader

ROOT = Path(__file__).resolve().parent.parent


def generate(folder):
    """Write all problem sets to a folder, byte for byte the same everywhere; return their names."""
    config = PyFileConfigLoader("nbgrader_config.py", path=str(ROOT)).load_config()
    config.CourseDirectory.root = str(ROOT)
    config.CourseDirectory.release_directory = str(folder)
    config.GenerateAssignment.no_database = True
    config.SaveCells.enabled = False
    names = sorted(path.parent.name for path in (ROOT / "solutions").glob("*/*.ipynb"))
    for name in names:
        course = CourseDirectory(config=config, assignment_id=name)
        GenerateAssignment(config=config, coursedir=course).start()
    for notebook in Path(folder).rglob("*.ipynb"):
        notebook.write_bytes(notebook.read_bytes().replace(b"\r\n", b"\n"))
    return names


def main(arguments=None):
    """Replace ``exercises/``, or fill the new folder that the command line names."""
    parser = argparse.ArgumentParser(prog="course.py release", description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, help="a new folder (default: exercises)")
    folder = parser.parse_args(arguments).folder
    target = folder or ROOT / "exercises"
    if folder and target.exists():
        print(f"{target} exists already. Name a new folder, or none for exercises/.")
        return 2
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder, "release")
        try:
            names = generate(made)
        except NbGraderException:
            return 1  # nbgrader has said which cell, and why
        if not names:
            print("solutions/ holds no problem set.")
            return 2
        if target.exists():
            shutil.rmtree(target)
        shutil.copytree(made, target)
    print(f"Released to {target}: {', '.join(names)}")
    return 0


if __name__ == "__main__":
    logging.basicConfig(format="%(message)s")
    sys.exit(main())
