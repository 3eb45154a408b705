"""The command line of the course. It needs Python 3.11 or newer, and nothing else.

    python3 course.py lab [...]         open JupyterLab, which gets the other arguments
    python3 course.py progress          say which parts of which problem sets hold
    python3 course.py reset 04          begin a problem set again; yours is kept beside the new one
    python3 course.py test [...]        run every test; pytest gets the other arguments
    python3 course.py release [FOLDER]  write exercises/ (or a new FOLDER) from solutions/
    python3 course.py refresh [...]     run lectures and solutions again and store what they show
    python3 course.py grade SUBMITTED   grade a class: a folder of notebooks, or a platform's zip
    python3 course.py bench [N ...]     time the library beside others (minutes; 1000 10000: short)
    python3 course.py doctor            say what works on this machine, for whoever helps you

On Windows, write `py` or `python` for `python3`, whichever you have. The first call sets up
everything in the folder `.venv` beside this file; later calls start at once. Lectures and problem
sets open as copies in `my_work`, and nothing here ever overwrites what you have written there. To
update the course, type `git pull`; then `lab` says what is new.
"""

import contextlib
import hashlib
import itertools
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

ROOT = Path(os.path.abspath(__file__)).parent  # `resolve` would leave a mapped drive of Windows
MY_WORK = ROOT / "my_work"
HANDED_OUT = MY_WORK / ".handed_out.json"
VENV = ROOT / ".venv"
WINDOWS = os.name == "nt"
PYTHON = VENV / ("Scripts/python.exe" if WINDOWS else "bin/python")
STAMP = VENV / "set-up-complete"
DOWNLOADS = "https://www.python.org/downloads/"

# Robot software sets PYTHONPATH, and then another system's packages shadow the ones in .venv.
FOREIGN = {"PYTHONPATH", "PYTHONHOME", "PIP_USER", "PIP_TARGET", "PIP_PREFIX"}
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in FOREIGN}
# A path that the code page of a terminal or a pipe cannot show must not end a program.
ENCODING = ENVIRONMENT.get("PYTHONIOENCODING", "").partition(":")[0]
ENVIRONMENT["PYTHONIOENCODING"] = ENCODING + ":replace"

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
TOO_LONG = "the path is too long for Windows. Move the course to a shorter one, such as C:\\course."
CAUSES = {
    r"no space left|not enough space|quota exceeded|os error 112\b": DISK_FULL,
    r"file ?name or extension is too long|path too long|enable-long-paths|long path support|"
    r"os error 206\b": TOO_LONG,
    r"permission denied|access is denied|read-only file system|used by another process": IN_USE,
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
            env=dict(ENVIRONMENT, PYTHONIOENCODING="utf-8:replace"),
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

    They change with the folder, the Python and the files; `Failed` if `.venv` does not run.
    """
    say = "import sys; print(sys.prefix, sys.version_info[:2])"
    place = quietly("starting the Python of .venv", PYTHON, "-c", say)
    files = ["environment.txt", "pyproject.toml"] + ["tests/environment.txt"] * test
    data = [place.encode(), *((ROOT / name).read_bytes() for name in files)]
    return [hashlib.sha256(b"\0".join(data[:end])).hexdigest() for end in range(3, len(data) + 1)]


def is_current(test=False):
    try:
        lines = wanted(test)
    except Failed:
        return False
    found = STAMP.read_text(encoding="utf-8").split() if STAMP.is_file() else []
    return found[: len(lines)] == lines


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
    # The interpreter that ours was made from: `.venv` may be what runs us, and is about to go.
    base = getattr(sys, "_base_executable", None) or sys.executable
    if WINDOWS and Path(sys.prefix) == VENV:  # Windows deletes no program that is running
        raise Stop(f'.venv is out of date, and it is what runs this. Type: "{base}" course.py lab')
    print("Setting up .venv (once: 20 s, or some minutes on a slow line)", flush=True)
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


# ---- what students get -----------------------------------------------------------------------

# Where a link of an original leads from its copy in `my_work`: to another copy, if there is one.
LINKS = {
    "notebooks": {rb"\]\(\.\./(?!exercises/)": b"](../../", rb"\]\(\.\./exercises/": b"](../"},
    "exercises": {rb"\]\(\.\./\.\./notebooks/": b"](../lectures/"},
}


def handouts():
    """Return what belongs in `my_work`, by its name there."""
    found = {}
    for house, links in LINKS.items():
        for path in sorted((ROOT / house).rglob("*")):
            name = path.relative_to(ROOT / house)
            numbered = name.parts[0][0].isdigit() and ".ipynb_checkpoints" not in name.parts
            if not numbered or not path.is_file():
                continue
            data = path.read_bytes()
            if path.suffix == ".ipynb":
                for link, target in links.items():
                    data = re.sub(link, target, data)
            room = "lectures/" if house == "notebooks" else ""
            found[room + name.as_posix()] = data
    return found


def version(data):
    """Return two digests in a row: of a file, and of its text, which is what people write in it.

    A notebook that was only run has another first one, and still the same second one.
    """
    text = data
    with contextlib.suppress(ValueError, LookupError, TypeError, AttributeError):
        cells = json.loads(data.decode("utf-8"))["cells"]
        parts = [[c["cell_type"], "".join(c["source"]), c.get("attachments") or {}] for c in cells]
        text = json.dumps([part for part in parts if part[1].strip()], sort_keys=True).encode()
    return "".join(hashlib.sha256(part).hexdigest()[:16] for part in (data, text))


def version_of(path):
    """Return the version of a file, or an empty one if it cannot be read."""
    try:
        return version(path.read_bytes())
    except OSError:
        return ""


def same_text(a, b):
    return a[16:] == b[16:] != ""


def remembered(path):
    """Return what a file of ours holds; a damaged one holds nothing."""
    try:
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def remember(path, notes):
    write(path, json.dumps(notes, indent=1).encode())


def beside(path, mark):
    """Yield names for another version of a file, the shortest first."""
    for number in itertools.count(1):
        again = f"-{number}" if number > 1 else ""
        yield path.with_name(f"{path.stem}.{mark}{again}{path.suffix}")


def hand_out():
    """Bring `my_work` up to date. A file that a student has written in stays as it is.

    A newer version takes the place of a file whose text is as it was handed out. Any other file
    gets it laid beside, once.
    """
    news = {"New": set(), "Updated": set()}
    with one_at_a_time():
        known = remembered(HANDED_OUT)
        for name, data in handouts().items():
            path, new, old = MY_WORK / name, version(data), str(known.get(name, ""))
            yours = version_of(path)
            if not os.path.lexists(path):
                write(path, data)
                news["New"].add(name.split("/")[0])
            elif old == new:
                continue
            elif same_text(yours, old):
                write(path, data)
                news["Updated"].add(name.split("/")[0])
            elif not same_text(yours, new) and not same_text(old, new):
                lay_beside(path, data, known)
            known[name] = new
        remember(HANDED_OUT, known)
    for what, names in news.items():
        if names:
            print(f"{what} in my_work: {', '.join(sorted(names))}", flush=True)


def lay_beside(path, data, known):
    """Lay a newer version beside a student's file, in place of an untouched earlier one."""
    for spare in beside(path, "new"):
        name = spare.relative_to(MY_WORK).as_posix()
        if not os.path.lexists(spare) or same_text(version_of(spare), str(known.get(name, ""))):
            break
    write(spare, data)
    known[name] = version(data)
    print(f"There is a newer my_work/{path.relative_to(MY_WORK).as_posix()}.")
    print(f"  Yours stays as it is; the newer one lies beside it: {spare.name}", flush=True)


# ---- commands --------------------------------------------------------------------------------


def lab(extra):
    set_up()
    hand_out()
    if (MY_WORK / "progress.json").exists():
        in_front("-m", "amrmetrics._progress")
    ours = ["-y", f"--ServerApp.root_dir={ROOT}"]
    ours += ["--LabApp.default_url=/lab/tree/my_work/lectures/00_start_here.ipynb"]
    # Whoever saves an original cannot `git pull` a newer one, so only the copies are listed.
    ours += [f"--ContentsManager.hide_globs={name}" for name in (*LINKS, "__pycache__")]
    if not any(re.match(r"--(ServerApp\.)?ip\b", argument) for argument in extra):
        ours += ["--ServerApp.ip=127.0.0.1"]
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        ours += ["--allow-root"]
    return in_front("-m", "jupyterlab", *ours, *extra)


def progress(extra):
    set_up()
    return in_front("-m", "amrmetrics._progress")


def reset(extra):
    """Lay out a problem set as new, and keep beside it what the student has made of it."""
    sets = sorted(path.name for path in (ROOT / "exercises").glob("[0-9]*"))
    chosen = next((name for name in sets if extra in ([name], [name[:2]])), None)
    if chosen is None:
        raise Stop(f"reset which problem set? Name one of: {', '.join(sets)}.")
    with one_at_a_time():
        known = remembered(HANDED_OUT)
        for name, data in handouts().items():
            path = MY_WORK / name
            if not name.startswith(chosen + "/") or version_of(path) == version(data):
                continue
            if os.path.lexists(path):
                spares = beside(path, time.strftime("%Y-%m-%d"))
                kept = next(spare for spare in spares if not os.path.lexists(spare))
                os.rename(path, kept)
                print(f"Kept as {kept.relative_to(ROOT).as_posix()}", flush=True)
            write(path, data)
            known[name] = version(data)
        remember(HANDED_OUT, known)
        notes = remembered(MY_WORK / "progress.json")
        if notes.pop(chosen, None):
            remember(MY_WORK / "progress.json", notes)
    print(f"my_work/{chosen} is new again. If JupyterLab shows it, close it there and open it.")
    return 0


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
    print(f"set-up: FAILED  missing, unfinished or out of date. Run: {this_command()} lab")
    return 1


COMMANDS = {
    "lab": lab,
    "progress": progress,
    "reset": reset,
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


def works(*command):
    """Tell whether a command starts a Python that is new enough; pyenv's may do nothing."""
    found = shutil.which(command[0])
    if found is None:
        return False
    question = "import sys; sys.exit(sys.version_info < (3, 11))"
    quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    try:
        return subprocess.run([found, *command[1:], "-c", question], **quiet).returncode == 0
    except OSError:
        return False


def this_command():
    """Return how to call this program: with a Python that is there, by a name that finds it."""
    mine = re.sub(r"\.exe$", "", os.path.basename(sys.executable), flags=re.I)
    name = next(filter(works, (mine, "python3", "python", "py")), f'"{sys.executable}"')
    return f"{name} course.py"


def old_python():
    """Say which Python to use instead."""
    commands = [(f"python3.{minor}",) for minor in (14, 13, 12, 11)]
    commands += [("py", f"-3.{minor}") for minor in (14, 13, 12, 11)]
    newer = next((" ".join(command) for command in commands if works(*command)), None)
    advice = f"You have one: {newer} course.py" if newer else f"Get it: {DOWNLOADS}"
    version = "{}.{}".format(*sys.version_info)
    return f"this is Python {version}, and the course needs 3.11 or newer. {advice}"


if __name__ == "__main__":
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):  # Python 3.6, too, has to be told what is needed
            stream.reconfigure(errors="replace")
    sys.exit(main(sys.argv[1:]))
