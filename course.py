"""The command line of the course. It needs Python 3.11 or newer, and nothing else.

    python3 course.py lab [...]         open JupyterLab, which gets the other arguments
    python3 course.py test [...]        run every test; pytest gets the other arguments
    python3 course.py release [FOLDER]  write exercises/ (or a new FOLDER) from solutions/
    python3 course.py refresh [...]     run lectures and solutions again and store what they show
    python3 course.py grade SUBMITTED   grade a class: a folder of notebooks, or a platform's zip
    python3 course.py bench [N ...]     time the library beside others (minutes; 1000 10000: short)
    python3 course.py doctor            say what works on this machine, for whoever helps you

On Windows, write `py` for `python3`. The first call sets up everything in the folder `.venv`
beside this file; later calls start at once. Your answers to the problem sets are in `my_work`,
and nothing here ever overwrites a file there.
"""

import contextlib
import hashlib
import json
import os
import platform
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
WINDOWS = os.name == "nt"
PYTHON = VENV / ("Scripts/python.exe" if WINDOWS else "bin/python")
STAMP = VENV / "set-up-complete"
DOWNLOADS = "https://www.python.org/downloads/"
SELF = "py course.py" if WINDOWS else "python3 course.py"

# Robot software sets PYTHONPATH, and then another system's packages shadow the ones in .venv.
FOREIGN = {"PYTHONPATH", "PYTHONHOME", "PIP_USER", "PIP_TARGET", "PIP_PREFIX"}
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in FOREIGN}

# A student's JupyterLab: no news, no panels for graders, no log of what went well.
GRADERS = ("formgrader", "validate_assignment", "assignment_list", "course_list")
UNUSED = {f"nbgrader.server_extensions.{name}": False for name in GRADERS}
QUIET = {"log_level": "WARN"}
NO_NEWS = {"fetchNews": "false", "checkForUpdates": False}
LAB_SETTINGS = {
    "etc/jupyter/jupyter_server_config.json": {
        "ServerApp": {"jpserver_extensions": UNUSED, **QUIET},
        "LabApp": QUIET,
    },
    "etc/jupyter/labconfig/page_config.json": {"disabledExtensions": {"@jupyter/nbgrader": True}},
    "share/jupyter/lab/settings/overrides.json": {
        "@jupyterlab/apputils-extension:notification": NO_NEWS
    },
}

# What pip, uv, venv and the system print, and what to say instead: the first that fits.
DISK_FULL = "the disk, or your quota, is full. Free 1 GB, then repeat the command."
OFFLINE = "no package server can be reached. Go online, or set your proxy, then repeat the command."
IN_USE = f"cannot write in {ROOT}. Close JupyterLab, or move the course to a folder of yours."
TOO_LONG = "the path is too long for Windows. Move the course to a shorter one."
CAUSES = {
    r"no space left|not enough space|quota exceeded|os error 112\b": DISK_FULL,
    r"permission denied|access is denied|read-only file system|used by another process": IN_USE,
    r"file ?name or extension is too long|path too long": TOO_LONG,
    r"name resolution|getaddrinfo|dns error|unreachable|connection (error|refused|reset|aborted)|"
    r"new connection|sending request|timed out|proxy|certificate|failed to fetch": OFFLINE,
}


class Stop(Exception):
    """What is wrong and what to do about it, in one line."""


class Failed(Stop):
    """A step failed: its message says why, or is preceded by the last lines that it printed."""

    def __init__(self, step, output):
        known = (advice for pattern, advice in CAUSES.items() if re.search(pattern, output, re.I))
        last = "".join(f"  | {line[:300]}\n" for line in output.strip().splitlines()[-8:])
        advice = next(known, None)
        super().__init__(f"{step}: {advice}" if advice else f"{last}{step} failed, as shown above.")


# ---- running programs ------------------------------------------------------------------------


def quietly(step, *command):
    """Run a program to its end and return what it printed; `Failed` if it fails."""
    try:
        done = subprocess.run(
            command,
            cwd=ROOT,
            env=ENVIRONMENT,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
            close_fds=False,  # the set-up lock goes along, see `one_at_a_time`
        )
    except OSError as error:
        raise Failed(step, str(error)) from None
    if done.returncode:
        raise Failed(step, done.stdout)
    return done.stdout


def in_front(*arguments, folder=ROOT):
    """Run the Python of `.venv` in this terminal and return its exit code."""
    process = subprocess.Popen([PYTHON, *arguments], cwd=folder, env=ENVIRONMENT)
    signal.signal(signal.SIGTERM, lambda *_: process.terminate())
    while True:
        try:
            return process.wait()
        except KeyboardInterrupt:
            pass  # the program has received it too, and ends in its own way


def write(path, data):
    """Write a file whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_bytes(data)
    os.replace(part, path)


@contextlib.contextmanager
def one_at_a_time():
    """Hold the lock of this folder. The system releases it, however this process ends.

    Installers inherit it: one that outlives a killed `course.py` keeps the next one waiting.
    """
    with open(ROOT / ".course.lock", "a") as file:
        os.set_inheritable(file.fileno(), True)
        if not locked(file):
            print("Another course.py is at work in this folder; waiting for it.", flush=True)
            while not locked(file):
                time.sleep(0.2)
        yield


def locked(file):
    """Try to lock an open file; a file system that knows no locks counts as locked."""
    try:
        if WINDOWS:
            import msvcrt

            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:
        pass
    return True


# ---- set-up ----------------------------------------------------------------------------------


def wanted(test):
    """Lines of the stamp of a complete set-up: one for `lab`, a second one for `test`.

    They change with the folder, the Python and the files; they are `None` if `.venv` does not run.
    """
    try:
        place = quietly("", PYTHON, "-c", "import sys; print(sys.prefix, sys.version_info[:2])")
    except Failed:
        return None
    files = ["environment.txt", "pyproject.toml"] + ["tests/environment.txt"] * test
    data = [place.encode(), *((ROOT / name).read_bytes() for name in files)]
    return [hashlib.sha256(b"\0".join(data[:end])).hexdigest() for end in range(3, len(data) + 1)]


def is_current(test=False):
    lines = wanted(test)
    found = STAMP.read_text(encoding="utf-8").split() if STAMP.is_file() else []
    return lines is not None and found[: len(lines)] == lines


def set_up(test=False):
    """Make `.venv` what the lock files say. Nothing in it is trusted without its stamp."""
    if is_current(test):
        return
    with one_at_a_time():
        if is_current(test):  # the one we waited for did it
            return
        start = time.monotonic()
        usable = is_current()
        STAMP.unlink(missing_ok=True)
        if not usable:
            create()
        install("environment.txt", *["tests/environment.txt"] * test)
        write(STAMP, "\n".join(wanted(test)).encode())
        print(f"Set up in {time.monotonic() - start:.0f} s.", flush=True)


def create():
    """Begin a new `.venv`, with pip and JupyterLab's settings in it."""
    try:
        import ensurepip  # noqa: F401
        import venv  # noqa: F401
    except ImportError:
        version = "{}.{}".format(*sys.version_info)
        raise Stop(
            f"this Python {version} cannot make a virtual environment. On Debian or Ubuntu: "
            f"sudo apt install python{version}-venv. Elsewhere, a full Python: {DOWNLOADS}"
        ) from None
    print("Setting up .venv (once: 20 s, or some minutes on a slow line)", flush=True)
    # The interpreter that ours was made from: `.venv` may be what runs us, and is about to go.
    base = getattr(sys, "_base_executable", None) or sys.executable
    quietly("making .venv", base, "-m", "venv", "--clear", "--without-pip", VENV)
    quietly("making .venv", PYTHON, "-m", "ensurepip", "--default-pip")
    for name, settings in LAB_SETTINGS.items():
        write(VENV / name, json.dumps(settings, indent=1).encode())


def install(*locks):
    """Install with uv, which takes seconds; with pip where uv does not install or run."""
    pip = [PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    uv = [PYTHON, "-m", "uv", "pip", "install", "--quiet", "--python", PYTHON]
    packages = [part for lock in locks for part in ("-r", lock)]
    course = ["--no-deps", "--no-build-isolation", "-e", "."]
    print("  installing packages", flush=True)
    try:
        quietly("installing uv", *pip, "uv")
        quietly("installing packages", *uv, *packages)
        quietly("installing amrmetrics", *uv, *course)
    except Failed as failed:
        if DISK_FULL in str(failed) or str(failed) == f"installing uv: {OFFLINE}":
            raise  # pip would not do better
        print("  uv does not work here; the same with pip, in a few minutes", flush=True)
        quietly("installing packages", *pip, *packages)
        quietly("installing amrmetrics", *pip, *course)


# ---- commands --------------------------------------------------------------------------------


def lab(extra):
    set_up()
    hand_out()
    ours = ["-y", f"--ServerApp.root_dir={ROOT}"]
    ours += ["--LabApp.default_url=/lab/tree/notebooks/00_start_here.ipynb"]
    if not any(re.match(r"--(ServerApp\.)?ip\b", argument) for argument in extra):
        ours += ["--ServerApp.ip=127.0.0.1"]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        ours += ["--allow-root"]
    return in_front("-m", "jupyterlab", *ours, *extra)


def hand_out():
    """Copy to `my_work` what it lacks of `exercises`. A file that is there stays as it is."""
    with one_at_a_time():
        for source in sorted((ROOT / "exercises").glob("[0-9]*/**/*")):
            name = source.relative_to(ROOT / "exercises")
            target = ROOT / "my_work" / name
            ours = source.is_file() and ".ipynb_checkpoints" not in name.parts
            if ours and not os.path.lexists(target):
                write(target, source.read_bytes())
                print(f"New in my_work: {name.as_posix()}", flush=True)


def test(extra):
    set_up(test=True)
    return in_front("-m", "pytest", *extra)


def release(extra):
    set_up()
    return in_front(ROOT / "tools" / "release.py", *extra, folder=None)


def refresh(extra):
    set_up()
    return in_front(ROOT / "tools" / "refresh.py", *extra, folder=None)


def grade(extra):
    set_up()
    return in_front(ROOT / "tools" / "grade.py", *extra, folder=None)


def bench(extra):
    set_up(test=True)
    return in_front(ROOT / "tools" / "bench.py", *extra)


def doctor(extra):
    """Say what works. The exit code is 0 if everything does."""
    print(f"system: {platform.platform()}\nPython: {platform.python_version()}, {sys.executable}")
    if is_current():
        print("set-up: ok", flush=True)
        return in_front(ROOT / "tools" / "doctor.py")
    print(f"set-up: FAILED  missing, unfinished or out of date. Run: {SELF} lab")
    return 1


COMMANDS = {
    "lab": lab,
    "test": test,
    "release": release,
    "refresh": refresh,
    "grade": grade,
    "bench": bench,
    "doctor": doctor,
}


def main(arguments):
    name, extra = arguments[0] if arguments else "", arguments[1:]
    try:
        if sys.version_info < (3, 11):
            raise Stop(old_python())
        if name in COMMANDS:
            return COMMANDS[name](extra)
        asked = name in ("-h", "--help", "help")
        print("" if asked or not name else f"There is no command {name!r}.\n", __doc__.strip())
        return 0 if asked else 2
    except KeyboardInterrupt:
        print("\nStopped. Repeat the command to go on.", file=sys.stderr)
        return 130
    except OSError as error:
        problem = Failed(name, str(error))
    except Stop as stop:
        problem = stop
    print(problem, file=sys.stderr)
    return 2


def old_python():
    """Say which Python to use instead."""
    names = (f"python3.{minor}" for minor in (14, 13, 12, 11))
    newer = next(filter(shutil.which, names), None)
    advice = f"You have one: {newer} course.py" if newer else f"Get it: {DOWNLOADS}"
    version = "{}.{}".format(*sys.version_info)
    return f"this is Python {version}, and the course needs 3.11 or newer. {advice}"


if __name__ == "__main__":
    for stream in (sys.stdout, sys.stderr):
        stream.reconfigure(errors="replace")  # what a terminal cannot show must not end the program
    sys.exit(main(sys.argv[1:]))
