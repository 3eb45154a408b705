"""Run notebooks from top to bottom and store what they show: ``python3 course.py refresh [...]``.

Without arguments: every lecture and every solution. A notebook that fails stays as it was. What
differs between two runs or two machines (times, widget ids, folders, versions) is not stored, so
that running an unchanged notebook again changes nothing.
"""

import argparse
import os
import subprocess
import sys
import time
import uuid
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

ROOT = Path(__file__).resolve().parent.parent
KERNEL = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
WIDGET = "application/vnd.jupyter.widget-view+json"


def notebooks(paths=()):
    """Every lecture and solution, or the notebooks that the paths name or contain."""
    folders = [Path(path) for path in paths] or [ROOT / "notebooks", ROOT / "solutions"]
    found = [[folder] if folder.is_file() else folder.rglob("*.ipynb") for folder in folders]
    return sorted({p for group in found for p in group if ".ipynb_checkpoints" not in p.parts})


def normalize(nb):
    """Make all of a notebook's metadata and ids what every run on every machine makes them."""
    nb.nbformat, nb.nbformat_minor = 4, 5
    nb.metadata.kernelspec = nbformat.from_dict(KERNEL)
    nb.metadata.language_info = nbformat.from_dict({"name": "python"})
    nb.metadata.pop("widgets", None)
    seen = set()
    for cell in nb.cells:
        if cell.get("id") in seen | {None, ""}:
            cell.id = uuid.uuid4().hex[:8]
        seen.add(cell.id)
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = [settle(output) for output in cell.outputs if not is_widget(output)]
    return nb


def is_widget(output):
    """Whether an output is a live widget: it has a new id in each run, and is nothing without."""
    return WIDGET in output.get("data", {})


def settle(output):
    """Keep of an error what it says: the stack names folders of this machine."""
    if output.output_type == "error":
        output.traceback = [f"{output.ename}: {output.evalue}"]
    return output


def write(path, nb):
    """Store a notebook, whole or not at all; return whether that changed the file."""
    text = (nbformat.writes(nb, version=4).rstrip("\n") + "\n").encode("utf-8")
    if path.read_bytes() == text:
        return False
    part = path.with_name(path.name + ".part")
    part.write_bytes(text)
    os.replace(part, path)
    return True


def refresh(path):
    """Run one notebook in its folder, in a fresh kernel, and store it; return what to report."""
    nb = normalize(nbformat.from_dict(nbformat.reader.reads(path.read_text(encoding="utf-8"))))
    client = NotebookClient(
        nb,
        kernel_name="python3",
        timeout=120,
        record_timing=False,
        coalesce_streams=True,
        resources={"metadata": {"path": str(path.parent)}},
    )
    client.execute(stderr=subprocess.DEVNULL)  # of the kernel program, not of the cells
    normalize(nb)
    nbformat.validate(nb)
    return "updated" if write(path, nb) else "unchanged", stderr_cells(nb)


def stderr_cells(nb):
    """The numbers, counted from 1, of the cells that print a warning."""
    return [
        number
        for number, cell in enumerate(nb.cells, 1)
        if any(output.get("name") == "stderr" for output in cell.get("outputs", []))
    ]


def main(arguments=None):
    """Refresh what the command line names, and return its exit code."""
    parser = argparse.ArgumentParser(prog="course.py refresh", description=__doc__)
    parser.add_argument("paths", nargs="*", help="notebooks or folders (default: all)")
    named = parser.parse_args(arguments).paths
    for path in named:
        if not Path(path).exists():
            parser.error(f"there is no {path} in {Path.cwd()}")
    paths = notebooks(named)
    for path in paths:
        start = time.perf_counter()
        print(f"{path.name}: ", end="", flush=True)
        try:
            result, noisy = refresh(path)
        except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
            print(f"FAILED, and left as it was\n{str(error).rstrip()}")
            return 1
        print(f"{result}, {time.perf_counter() - start:.1f} s")
        for number in noisy:
            print(f"  warning: cell {number} prints to stderr")
    return 0


if __name__ == "__main__":
    sys.exit(main())
