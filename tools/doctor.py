"""Check this machine: ``python3 course.py doctor`` runs it with the Python of ``.venv``.

Each check is a function that returns what it found, or raises. Its docstring is the advice that is
printed when it fails. Imports stand inside, so that one broken package fails one check.
"""

import importlib.metadata
import io
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(os.path.abspath(__file__)).parent.parent
PACKAGES = "numpy scipy sympy matplotlib jupyterlab ipykernel ipywidgets nbgrader amrmetrics"


def versions():
    """Delete the folder .venv, then run: course.py lab"""
    found = [f"{name} {importlib.metadata.version(name)}" for name in PACKAGES.split()]
    return ", ".join([f"Python {sys.version.split()[0]}", *found])


def writing():
    """Move the course to a folder that belongs to you, outside of synchronized drives."""
    my_work = ROOT / "my_work"
    for folder in [ROOT, *([my_work] if my_work.exists() else [])]:
        with tempfile.TemporaryFile(dir=folder):
            pass
    return str(ROOT)


def disk():
    """Free some space: notebooks cannot be saved on a full disk."""
    free = shutil.disk_usage(ROOT).free / 1e9
    assert free > 0.2, f"only {free:.2f} GB are free"
    return f"{free:.1f} GB are free"


def fonts():
    """Matplotlib's own fonts are missing. Delete the folder .venv, then run: course.py lab"""
    from matplotlib import font_manager

    return Path(font_manager.findfont("DejaVu Sans", fallback_to_default=False)).name


def figure():
    """Delete the folder .venv, then run: course.py lab"""
    from matplotlib.figure import Figure

    fig = Figure()
    fig.subplots().plot([0, 1], [1, 0])
    fig.savefig(page := io.BytesIO(), format="png")
    assert page.getvalue().startswith(b"\x89PNG"), "no picture came out"
    return f"drawn, {len(page.getvalue()) // 1000} kB"


def kernel():
    """A security program or a proxy may block connections from this machine to itself."""
    from jupyter_client.kernelspec import KernelSpecManager
    from jupyter_client.manager import start_new_kernel

    folder = KernelSpecManager().get_kernel_spec("python3").resource_dir
    assert Path(folder).is_relative_to(sys.prefix), f"another Python's kernel is used: {folder}"
    answers = []
    manager, client = start_new_kernel(startup_timeout=20, stderr=subprocess.DEVNULL)
    try:
        client.execute_interactive(
            "print(1 + 1)", timeout=10, output_hook=lambda m: answers.append(m["content"])
        )
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
    assert {"name": "stdout", "text": "2\n"} in answers, f"1 + 1 gave {answers}"
    return "started, and 1 + 1 = 2"


def library():
    """The files of the course are damaged. See what changed: git status amrmetrics"""
    import numpy as np

    import amrmetrics as am

    truth = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]])
    c, s = np.cos(0.5), np.sin(0.5)
    moved = (truth - [1.0, 2.0]) @ np.array([[c, -s], [s, c]])
    found = am.align(truth, moved)
    assert np.isclose(found.angle, 0.5), f"the angle is {found.angle}, not 0.5"
    assert np.allclose(found.translation, [1.0, 2.0]), f"the translation is {found.translation}"
    return "align finds a known rotation and translation"


def derivation():
    """The files of the course are damaged. See what changed: git status amrmetrics"""
    from amrmetrics.derivation import check_step

    right = check_step("(x + 1)**2", "x**2 + 2*x + 1", {"x": "real"}).status
    wrong = check_step("(x + 1)**2", "x**2 + 1", {"x": "real"}).status
    assert (right, wrong) == ("proved", "refuted"), f"a right step: {right}, a wrong one: {wrong}"
    return "a right step is proved, a wrong one refuted"


CHECKS = (versions, writing, disk, fonts, figure, kernel, library, derivation)


def main(checks=CHECKS):
    """Run the checks; return 0 if all is well and 1 if something failed."""
    start, failed = time.perf_counter(), 0
    for check in checks:
        try:
            print(f"{check.__name__}: ok  {check()}", flush=True)
        except Exception as error:  # whatever it is, the next check still has something to say
            failed = 1
            print(f"{check.__name__}: FAILED  {type(error).__name__}: {error}")
            print(f"    {check.__doc__}", flush=True)
    print(
        f"{'Something FAILED' if failed else 'All is well'} ({time.perf_counter() - start:.1f} s)"
    )
    return failed


if __name__ == "__main__":
    sys.exit(main())
