"""The command line, the lock files, and the programs behind `release`, `refresh` and `doctor`.

Nothing here touches the network or the real `.venv`: course.py is loaded from a copy in an empty
folder, and the programs that it starts are played by `Programs`.
"""

import ast
import errno
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path
from types import SimpleNamespace

import doctor
import nbformat
import pytest
import refresh
import release
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parent.parent
SOURCE = (ROOT / "course.py").read_text(encoding="utf-8")


class Programs:
    """Stands in for `subprocess.run`: keeps what was run, fails or stops where it is told to."""

    def __init__(self, course):
        self.course, self.ran = course, []
        self.place = "the folder, Python (3, 11)"
        self.failures, self.stop_at = {}, None

    def __call__(self, command, **options):
        line = " ".join(str(part) for part in command)
        if "sys.prefix" in line:
            works = self.course.PYTHON.exists()
            return SimpleNamespace(returncode=0 if works else 1, stdout=self.place)
        self.ran.append(line)
        if len(self.ran) == self.stop_at:
            raise KeyboardInterrupt
        for part, output in self.failures.items():
            if part in line:
                return SimpleNamespace(returncode=1, stdout=output)
        if "-m venv" in line:
            shutil.rmtree(self.course.VENV, ignore_errors=True)
            self.course.write(self.course.PYTHON, b"")
        return SimpleNamespace(returncode=0, stdout="")

    def count(self, part):
        return sum(part in line for line in self.ran)


@pytest.fixture
def course(tmp_path, monkeypatch):
    for name in ("environment.txt", "pyproject.toml", "tests/environment.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(f"as it was: {name}\n", encoding="utf-8")
    (tmp_path / "course.py").write_text(SOURCE, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("course_copy", tmp_path / "course.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    programs = module.programs = Programs(module)
    monkeypatch.setattr(
        module,
        "subprocess",
        SimpleNamespace(run=programs, DEVNULL=subprocess.DEVNULL, PIPE=-1, STDOUT=-2),
    )
    return module


# ---- which Python ----------------------------------------------------------------------------


def test_the_file_is_python_3_8_and_imports_the_standard_library_only():
    tree = ast.parse(SOURCE, feature_version=(3, 8))
    imports = [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]
    names = {alias.name for node in imports for alias in node.names if alias.name != "Path"}
    assert names <= sys.stdlib_module_names


@pytest.mark.parametrize("found, advice", [(None, "https://www.python.org"), ("/x", "python3.14")])
def test_an_old_python_is_told_which_one_to_use(course, monkeypatch, capsys, found, advice):
    monkeypatch.setattr(course.sys, "version_info", (3, 8, 18, "final", 0))
    monkeypatch.setattr(course.shutil, "which", lambda name: found)
    assert course.main(["lab"]) == 2
    told = capsys.readouterr().err
    assert "this is Python 3.8," in told and "3.11" in told and advice in told
    assert told.count("\n") == 1


def test_a_real_python_3_8_says_so(tmp_path):
    old = shutil.which("python3.8")
    if not old or subprocess.run([old, "--version"], capture_output=True).returncode:
        pytest.skip("there is no Python 3.8 on this machine")
    done = subprocess.run([old, ROOT / "course.py", "lab"], capture_output=True, encoding="utf-8")
    assert done.returncode == 2 and "3.11 or newer" in done.stderr


# ---- set-up ----------------------------------------------------------------------------------


def test_set_up_is_done_once(course):
    course.set_up()
    assert course.programs.count("-m venv") == 1
    assert course.programs.count("uv pip install") == 2
    steps = len(course.programs.ran)
    course.set_up()
    assert len(course.programs.ran) == steps


@pytest.mark.parametrize("name", ["environment.txt", "pyproject.toml"])
def test_set_up_is_redone_when_a_file_it_is_made_from_changed(course, name):
    course.set_up()
    (course.ROOT / "README.md").write_text("new", encoding="utf-8")
    (course.ROOT / "tests/environment.txt").write_text("new", encoding="utf-8")
    course.set_up()
    assert course.programs.count("-m venv") == 1
    (course.ROOT / name).write_text("new", encoding="utf-8")
    course.set_up()
    assert course.programs.count("-m venv") == 2


def test_test_adds_its_packages_and_lab_does_not_need_them(course):
    course.set_up()
    assert course.programs.count("tests/environment.txt") == 0
    course.set_up(test=True)
    assert course.programs.count("tests/environment.txt") == 1
    course.set_up()
    course.set_up(test=True)
    assert course.programs.count("tests/environment.txt") == 1
    assert course.programs.count("-m venv") == 1
    (course.ROOT / "tests/environment.txt").write_text("new", encoding="utf-8")
    assert course.is_current() and not course.is_current(test=True)


@pytest.mark.parametrize(
    "after_lab, step",
    [(False, step) for step in range(1, 6)] + [(True, step) for step in (1, 2, 3)],
)
def test_an_interrupted_set_up_is_begun_again_by_the_next_call(course, after_lab, step):
    if after_lab:
        course.set_up()
        course.programs.ran.clear()
    course.programs.stop_at = step
    with pytest.raises(KeyboardInterrupt):
        course.set_up(test=True)
    assert not course.is_current() and not course.is_current(test=True)
    course.programs.ran.clear()
    course.programs.stop_at = None
    course.set_up()
    assert course.programs.count("-m venv") == 1  # half-installed packages are not built upon
    assert len(course.programs.ran) == 5 and course.is_current()


def test_a_set_up_that_goes_back_to_an_old_lock_file_does_not_find_an_old_stamp(course):
    course.set_up()
    old = (course.ROOT / "environment.txt").read_bytes()
    (course.ROOT / "environment.txt").write_bytes(b"new")
    course.programs.ran.clear()
    course.programs.stop_at = 1
    with pytest.raises(KeyboardInterrupt):
        course.set_up()
    (course.ROOT / "environment.txt").write_bytes(old)
    assert not course.is_current()


def test_a_venv_whose_python_is_gone_or_another_or_moved_is_made_again(course):
    course.set_up()
    course.PYTHON.unlink()
    course.set_up()
    assert course.programs.count("-m venv") == 2
    for number, place in enumerate(("the folder, Python (3, 12)", "moved, Python (3, 12)"), 3):
        course.programs.place = place
        course.set_up()
        assert course.programs.count("-m venv") == number


@pytest.mark.parametrize("part", ["install --quiet --disable-pip-version-check uv", "-m uv"])
def test_pip_does_the_work_where_uv_cannot(course, part, capsys):
    course.programs.failures = {part: "no wheel for this system"}
    course.set_up()
    assert course.is_current()
    pip = [line for line in course.programs.ran if "-m pip install" in line and " uv" not in line]
    assert any("-r environment.txt" in line for line in pip) and any("-e ." in line for line in pip)
    assert "pip" in capsys.readouterr().out


@pytest.mark.parametrize(
    "part, output", [("check uv", "getaddrinfo failed"), ("-m uv", "No space left on device")]
)
def test_pip_is_not_tried_where_it_would_fail_like_uv(course, part, output):
    course.programs.failures = {part: output}
    assert course.main(["lab"]) == 2
    assert not [line for line in course.programs.ran if "-m pip install" in line and " -r " in line]


def test_another_systems_packages_are_shut_out(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", "/opt/robots/lib/python3/site-packages")
    spec = importlib.util.spec_from_file_location("course_again", ROOT / "course.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    assert "PYTHONPATH" not in module.ENVIRONMENT and "PATH" in module.ENVIRONMENT


def test_only_one_set_up_runs_in_a_folder_and_a_killed_one_lets_go(course):
    holder = "import sys, time; sys.path.insert(0, sys.argv[1]); import course\n"
    holder += "with course.one_at_a_time(): print('held', flush=True); time.sleep(60)"
    command = [sys.executable, "-c", holder, str(course.ROOT)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, encoding="utf-8") as other:
        assert other.stdout.readline() == "held\n"
        with open(course.ROOT / ".course.lock", "a", encoding="utf-8") as file:
            assert not course.locked(file)
        other.kill()
    with course.one_at_a_time():
        pass


# ---- what is said when something is wrong ----------------------------------------------------

NO_NETWORK = "no package server can be reached"
DISK_FULL = "the disk, or your quota, is full"
OUTPUTS = [
    ("ERROR: Could not install: [Errno 28] No space left on device", DISK_FULL),
    ("OSError: [Errno 122] Disk quota exceeded", DISK_FULL),
    ("error: There is not enough space on the disk. (os error 112)", DISK_FULL),
    ("Failed to establish a new connection: [Errno -2] Name or service not known", NO_NETWORK),
    ("Temporary failure in name resolution", NO_NETWORK),
    ("getaddrinfo failed", NO_NETWORK),
    ("error: error sending request for url: dns error", NO_NETWORK),
    ("SSLError: certificate verify failed", NO_NETWORK),
    ("Read timed out.", NO_NETWORK),
    ("[Errno 13] Permission denied: '.venv'", "cannot write in"),
    ("[WinError 5] Access is denied: 'python.exe'", "cannot write in"),
    ("[Errno 30] Read-only file system", "cannot write in"),
    ("The filename or extension is too long", "path is too long"),
]


@pytest.mark.parametrize("output, meaning", OUTPUTS)
def test_a_failed_set_up_ends_in_one_line_and_exit_code_2(course, capsys, output, meaning):
    course.programs.failures = {" install": output}
    assert course.main(["lab"]) == 2
    told = capsys.readouterr().err
    assert meaning in told and told.count("\n") == 1
    assert not course.is_current()


def test_a_failure_nobody_thought_of_shows_its_last_lines(course, capsys):
    course.programs.failures = {" install": "\n".join(f"line {i}" for i in range(50))}
    assert course.main(["lab"]) == 2
    told = capsys.readouterr().err.splitlines()
    assert told[-1].startswith("installing packages failed") and told[-2] == "  | line 49"
    assert len(told) == 9


@pytest.mark.parametrize("missing", ["venv", "ensurepip"])
def test_a_python_without_venv_is_told_what_to_install(course, monkeypatch, capsys, missing):
    monkeypatch.setitem(sys.modules, missing, None)
    assert course.main(["lab"]) == 2
    told = capsys.readouterr().err
    version = f"{sys.version_info[0]}.{sys.version_info[1]}"
    assert f"sudo apt install python{version}-venv" in told and told.count("\n") == 1
    assert not course.VENV.exists()


@pytest.mark.parametrize(
    "code, meaning",
    [
        (errno.ENOSPC, DISK_FULL),
        (errno.EACCES, "cannot write in"),
        (errno.EROFS, "cannot write in"),
    ],
)
def test_errors_of_the_system_end_in_one_line_too(course, monkeypatch, capsys, code, meaning):
    def refuse(*args):
        raise OSError(code, os.strerror(code))

    monkeypatch.setattr(course.os, "replace", refuse)
    assert course.main(["lab"]) == 2
    told = capsys.readouterr().err
    assert meaning in told and told.count("\n") == 1


def test_ctrl_c_is_no_traceback(course, capsys):
    course.programs.stop_at = 2
    assert course.main(["lab"]) == 130
    assert "Repeat the command" in capsys.readouterr().err


@pytest.mark.parametrize("arguments, code", [([], 2), (["labb"], 2), (["--help"], 0)])
def test_no_command_or_an_unknown_one_prints_the_list(course, capsys, arguments, code):
    assert course.main(arguments) == code
    told = capsys.readouterr().out
    assert all(f"course.py {name}" in told for name in course.COMMANDS)
    assert ("There is no command 'labb'" in told) == (arguments == ["labb"])
    assert not course.programs.ran


# ---- lab and test ----------------------------------------------------------------------------


@pytest.fixture
def exercise(course):
    path = course.ROOT / "exercises" / "02_alignment" / "02_alignment.ipynb"
    course.write(path, b"the exercise")
    course.write(path.parent / "data" / "cloud.csv", b"1,2")
    course.write(path.parent / ".ipynb_checkpoints" / "x.ipynb", b"")
    return course.ROOT / "my_work" / "02_alignment" / "02_alignment.ipynb"


def test_exercises_are_copied_once_and_work_is_never_overwritten(course, exercise):
    course.hand_out()
    assert exercise.read_bytes() == b"the exercise"
    assert (exercise.parent / "data" / "cloud.csv").read_bytes() == b"1,2"
    assert not list((course.ROOT / "my_work").rglob("*checkpoints*"))
    assert not list((course.ROOT / "my_work").rglob("*.part"))
    exercise.write_bytes(b"my answer")
    (course.ROOT / "exercises/02_alignment/02_alignment.ipynb").write_bytes(b"a newer exercise")
    course.write(course.ROOT / "exercises/03_trajectory/03_trajectory.ipynb", b"a new one")
    (exercise.parent / "data" / "cloud.csv").unlink()
    course.hand_out()
    assert exercise.read_bytes() == b"my answer"
    assert (exercise.parent / "data" / "cloud.csv").exists(), "what was deleted comes back"
    assert (course.ROOT / "my_work/03_trajectory/03_trajectory.ipynb").read_bytes() == b"a new one"


def test_an_empty_answer_is_an_answer(course, exercise):
    course.write(exercise, b"")
    course.hand_out()
    assert exercise.read_bytes() == b""


def test_a_copy_that_is_cut_short_leaves_no_half_file(course, exercise, monkeypatch):
    def refuse(*args):
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch, pytest.raises(OSError, match="No space"):
        patch.setattr(course.os, "replace", refuse)
        course.hand_out()
    assert not exercise.exists()
    course.hand_out()
    assert exercise.read_bytes() == b"the exercise"


@pytest.fixture
def started(course, monkeypatch):
    lines = []
    monkeypatch.setattr(course, "in_front", lambda *parts: lines.append([*map(str, parts)]) or 7)
    return lines


def test_lab_opens_the_first_notebook_on_this_machine_only(course, started, exercise, monkeypatch):
    monkeypatch.setattr(course.os, "geteuid", lambda: 0, raising=False)
    assert course.main(["lab", "--no-browser", "--port", "8877"]) == 7
    (line,) = started
    assert line[:2] == ["-m", "jupyterlab"] and line[-3:] == ["--no-browser", "--port", "8877"]
    assert "--LabApp.default_url=/lab/tree/notebooks/00_start_here.ipynb" in line
    assert "--ServerApp.ip=127.0.0.1" in line and "--allow-root" in line
    assert not [part for part in line if "token" in part or "password" in part]
    assert exercise.exists()
    monkeypatch.setattr(course.os, "geteuid", lambda: 1000)
    for mine in ("--ip=0.0.0.0", "--ServerApp.ip=0.0.0.0", "--ip"):
        course.main(["lab", mine])
        assert "--ServerApp.ip=127.0.0.1" not in started[-1] and "--allow-root" not in started[-1]


def test_lab_settings_stand_in_the_venv(course):
    course.set_up()
    page = json.loads((course.VENV / "etc/jupyter/labconfig/page_config.json").read_bytes())
    assert page["disabledExtensions"] == {"@jupyter/nbgrader": True}


def test_test_hands_its_arguments_to_pytest_and_returns_its_code(course, started):
    assert course.main(["test", "-k", "alignment"]) == 7
    assert started == [["-m", "pytest", "-k", "alignment"]]
    assert course.is_current(test=True)


def test_the_exit_code_is_the_programs(course, monkeypatch):
    monkeypatch.setattr(course, "PYTHON", sys.executable)
    monkeypatch.setattr(course, "subprocess", subprocess)
    monkeypatch.setattr(course.signal, "signal", lambda *args: None)
    assert course.in_front("-c", "raise SystemExit(5)") == 5


# ---- lock files ------------------------------------------------------------------------------

LOCKS = ("environment.txt", "tests/environment.txt")
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
SYSTEMS = [("linux", "Linux"), ("darwin", "Darwin"), ("win32", "Windows")]
MACHINES = [
    {
        "sys_platform": platform,
        "platform_system": system,
        "os_name": "nt" if platform == "win32" else "posix",
        "python_version": f"3.{minor}",
        "python_full_version": f"3.{minor}.0",
        "implementation_name": "cpython",
        "platform_python_implementation": "CPython",
    }
    for platform, system in SYSTEMS
    for minor in (11, 12, 13, 14)
]


def pins(name):
    lines = (ROOT / name).read_text(encoding="utf-8").splitlines()
    return [Requirement(line) for line in lines if line and not line.startswith("#")]


def versions(name, machine):
    """Name and version of what a lock file installs on a machine: one version of each."""
    active = [pin for pin in pins(name) if pin.marker is None or pin.marker.evaluate(machine)]
    found = {canonicalize_name(pin.name): str(pin.specifier)[2:] for pin in active}
    assert len(found) == len(active)
    return found


@pytest.mark.parametrize("name", LOCKS)
def test_a_lock_file_pins_everything_and_names_no_address(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    assert "://" not in text and not re.search(r"^-", text, re.M)
    assert "uv pip compile --universal --python-version 3.11" in text.splitlines()[1]
    for pin in pins(name):
        assert re.fullmatch(r"==[^=*,]+", str(pin.specifier)), pin


@pytest.mark.parametrize(
    "machine", MACHINES, ids=lambda m: f"{m['sys_platform']}-{m['python_version']}"
)
def test_the_locks_cover_the_direct_dependencies_and_agree(machine):
    base, extra = (versions(name, machine) for name in LOCKS)
    extras = PROJECT["project"]["optional-dependencies"]
    course = [line for line in extras["course"] if not line.startswith("amrmetrics[")]
    wanted = [(base, PROJECT["project"]["dependencies"] + extras["plot"] + course)]
    wanted += [(base | extra, extras["fast"] + extras["ros"])]
    wanted += [(base | extra, PROJECT["dependency-groups"]["test"])]
    for lock, dependencies in wanted:
        for dependency in map(Requirement, dependencies):
            if dependency.marker and not dependency.marker.evaluate(machine):
                continue
            version = lock.get(canonicalize_name(dependency.name))
            assert version and dependency.specifier.contains(version), (dependency, version)
    assert {name: base[name] for name in base.keys() & extra.keys()} == {
        name: extra[name] for name in base.keys() & extra.keys()
    }


def test_what_only_tests_need_is_not_in_the_students_lock():
    names = {canonicalize_name(pin.name) for pin in pins("environment.txt")}
    assert not names & {"hypothesis", "evo", "scikit-learn", "ruff", "scoringrules", "pandas"}


# ---- release ---------------------------------------------------------------------------------


def tree(folder):
    """Every file below a folder with its content."""
    files = [path for path in Path(folder).rglob("*") if path.is_file()]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def test_exercises_are_what_release_makes_of_solutions_byte_for_byte(tmp_path):
    assert release.generate(tmp_path / "a"), "solutions/ is empty"
    release.generate(tmp_path / "b")
    made, again, committed = tree(tmp_path / "a"), tree(tmp_path / "b"), tree(ROOT / "exercises")
    assert made == again
    shown = {name: text for name, text in committed.items() if ".ipynb_checkpoints" not in name}
    assert made.keys() == shown.keys(), "run: python3 course.py release"
    stale = [name for name in made if made[name] != shown[name]]
    assert not stale, f"run: python3 course.py release ({stale})"


def graded(name, source, **roles):
    roles = {"grade": False, "solution": False, "locked": False, "task": False, **roles}
    cell = new_code_cell(source, id=name)
    cell.metadata.nbgrader = {"schema_version": 3, "grade_id": name, **roles}
    return cell


@pytest.fixture
def house(tmp_path, monkeypatch):
    """A house with one problem set, and an exercise whose problem set is gone."""
    solution = "def f(x):\n    ### BEGIN SOLUTION\n    return 42 * x\n    ### END SOLUTION"
    cells = [graded("f", solution, solution=True)]
    cells += [graded("test_f", "assert f(1) == 42", grade=True, locked=True, points=1)]
    path = tmp_path / "solutions" / "02_alignment" / "02_alignment.ipynb"
    path.parent.mkdir(parents=True)
    nbformat.write(refresh.normalize(new_notebook(cells=cells)), path)
    (tmp_path / "exercises" / "99_gone").mkdir(parents=True)
    shutil.copy(ROOT / "nbgrader_config.py", tmp_path)
    monkeypatch.setattr(release, "ROOT", tmp_path)
    return tmp_path


def test_release_hides_answers_and_removes_what_has_no_source(house, capsys):
    assert release.main([]) == 0
    assert list(tree(house / "exercises")) == ["02_alignment/02_alignment.ipynb"]
    assert not (house / "exercises" / "99_gone").exists()
    text = (house / "exercises/02_alignment/02_alignment.ipynb").read_bytes()
    assert b"42 * x" not in text and b"def f(x)" in text and b"\r" not in text
    assert not (house / "build").exists() and not (house / "gradebook.db").exists()


def test_release_touches_nothing_when_it_cannot_do_all(house, capsys):
    assert release.main([str(house / "exercises")]) == 2  # a folder that exists is not replaced
    path = house / "solutions" / "02_alignment" / "02_alignment.ipynb"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("### END SOLUTION", "pass"), encoding="utf-8")
    assert release.main([]) == 1
    path.unlink()
    assert release.main([]) == 2
    assert (house / "exercises" / "99_gone").exists()


# ---- refresh ---------------------------------------------------------------------------------


def notebook(path, *sources, tags=()):
    cells = [new_code_cell(source, metadata={"tags": list(tags)}) for source in sources]
    nbformat.write(new_notebook(cells=[new_markdown_cell("# A lecture"), *cells]), path)
    return path


def test_refresh_stores_what_a_fresh_kernel_shows_and_is_stable(tmp_path, capsys):
    raising = "import sys; print('oh', file=sys.stderr); 1 / 0"
    slow = "import os, time; x = 6\nprint(os.path.basename(os.getcwd())); time.sleep(0.3); print(x)"
    sources = [slow, "x * 7", raising]
    path = notebook(tmp_path / "lecture.ipynb", *sources, tags=["raises-exception"])
    assert refresh.main([str(path)]) == 0
    said, first = capsys.readouterr().out, path.read_bytes()
    assert "updated" in said and "warning: cell 4 prints to stderr" in said
    where, answer, error = nbformat.reads(first.decode(), as_version=4).cells[1:]
    assert [output.text for output in where.outputs] == [f"{tmp_path.name}\n6\n"]
    assert answer.outputs[0].data == {"text/plain": "42"} and answer.execution_count == 2
    assert error.outputs[-1].traceback == ["ZeroDivisionError: division by zero"]
    assert (
        b"timestamp" not in first and b"iopub" not in first and str(tmp_path).encode() not in first
    )
    assert refresh.main([str(path)]) == 0
    assert "unchanged" in capsys.readouterr().out and path.read_bytes() == first


def test_refresh_leaves_a_notebook_that_fails_as_it_was(tmp_path, capsys):
    path = notebook(tmp_path / "lecture.ipynb", "x = 1", "undefined_name")
    before = path.read_bytes()
    assert refresh.main([str(path)]) == 1
    said = capsys.readouterr().out
    assert "lecture.ipynb: FAILED" in said and "NameError" in said and "undefined_name" in said
    assert path.read_bytes() == before and not list(tmp_path.glob("*.part"))


def test_refresh_keeps_nothing_that_differs_between_machines(tmp_path):
    widget = {"data": {refresh.WIDGET: {"model_id": "17"}, "text/plain": "interactive"}}
    figure = {"data": {"image/png": "AA=="}, "metadata": {"image/png": {"alt": "a line"}}}
    outputs = [{"output_type": "display_data", "metadata": {}, **data} for data in (widget, figure)]
    nb = new_notebook(cells=[new_code_cell("x", outputs=outputs), new_code_cell("y")])
    nb.metadata.update(widgets={"state": 1}, language_info={"name": "python", "version": "3.11.7"})
    nb.cells[1].id = nb.cells[0].id
    nb.cells[0].metadata.execution = {"iopub.execute_input": "2026-01-01"}
    done = refresh.normalize(nbformat.from_dict(nb))
    assert done.metadata == {"kernelspec": refresh.KERNEL, "language_info": {"name": "python"}}
    assert done.cells[0].id != done.cells[1].id and not done.cells[0].metadata
    assert [output.data for output in done.cells[0].outputs] == [{"image/png": "AA=="}]
    assert done.cells[0].outputs[0].metadata["image/png"]["alt"] == "a line"


def test_refresh_refuses_a_path_that_does_not_exist(capsys):
    with pytest.raises(SystemExit) as stopped:
        refresh.main(["notebooks/98_missing.ipynb"])
    assert stopped.value.code == 2 and "98_missing" in capsys.readouterr().err


# ---- doctor ----------------------------------------------------------------------------------


def test_doctor_finds_nothing_wrong_with_what_does_not_depend_on_the_installation(capsys):
    rest = [check for check in doctor.CHECKS if check not in (doctor.versions, doctor.kernel)]
    assert doctor.main(rest) == 0, capsys.readouterr().out
    assert capsys.readouterr().out.count(": ok  ") == len(rest) == 6


def test_doctor_goes_on_after_a_failure_and_gives_advice(capsys, monkeypatch):
    monkeypatch.setattr(doctor.shutil, "disk_usage", lambda path: SimpleNamespace(free=1e6))
    assert doctor.main([doctor.disk, doctor.figure]) == 1
    said = capsys.readouterr().out
    assert "disk: FAILED" in said and doctor.disk.__doc__ in said and "figure: ok" in said


def test_doctor_without_a_set_up_says_how_to_make_one(course, capsys):
    assert course.main(["doctor"]) == 1
    said = capsys.readouterr().out
    assert "set-up: FAILED" in said and "course.py lab" in said and not course.programs.ran
