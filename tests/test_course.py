"""The command line, the lock files, and the programs behind `release`, `refresh` and `doctor`.

Nothing here touches the network or the real `.venv`: course.py is loaded from a copy in an empty
folder, and the programs that it starts are played by `Programs`.
"""

import ast
import contextlib
import errno
import importlib.util
import json
import os
import re
import runpy
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


def test_the_file_is_python_3_6_and_imports_the_standard_library_only():
    tree = ast.parse(SOURCE, feature_version=(3, 6))
    imports = [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]
    names = {alias.name for node in imports for alias in node.names if alias.name != "Path"}
    assert names <= sys.stdlib_module_names
    newer = (ast.NamedExpr, ast.Match, ast.TryStar)  # which the parser lets pass
    assert not [node for node in ast.walk(tree) if isinstance(node, newer)]


@pytest.mark.parametrize("found, advice", [(None, "https://www.python.org"), ("/x", "python3.14")])
def test_an_old_python_is_told_which_one_to_use(course, monkeypatch, capsys, found, advice):
    monkeypatch.setattr(course.sys, "version_info", (3, 8, 18, "final", 0))
    monkeypatch.setattr(course.shutil, "which", lambda name: found)
    assert course.main(["lab"]) == 2
    told = capsys.readouterr().err
    assert "this is Python 3.8," in told and "3.11" in told and advice in told
    assert told.count("\n") == 1


def test_streams_of_python_3_6_do_not_keep_the_advice_back(monkeypatch):
    said = []
    stream = SimpleNamespace(write=said.append, flush=lambda: None)  # without `reconfigure`
    monkeypatch.setattr(sys, "version_info", (3, 6, 15, "final", 0))
    monkeypatch.setattr(sys, "stdout", stream)
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setattr(sys, "argv", ["course.py", "lab"])
    with pytest.raises(SystemExit) as stopped:
        runpy.run_path(str(ROOT / "course.py"), run_name="__main__")
    assert stopped.value.code == 2 and "this is Python 3.6," in "".join(said)


def interpreter(version):
    """Return a real Python of this version, also one that pyenv keeps but does not switch on."""
    kept = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv")) / "versions"
    found = [shutil.which(f"python{version}"), *kept.glob(f"{version}.*/bin/python")]
    for path in filter(None, found):
        if not subprocess.run([path, "--version"], capture_output=True).returncode:
            return path
    pytest.skip(f"there is no Python {version} on this machine")


@pytest.mark.parametrize("version", ["3.6", "3.8", "3.10"])
def test_a_real_old_python_says_so(version):
    done = subprocess.run(
        [interpreter(version), ROOT / "course.py", "lab"], capture_output=True, encoding="utf-8"
    )
    assert done.returncode == 2 and f"this is Python {version}," in done.stderr
    assert "3.11 or newer" in done.stderr and done.stderr.count("\n") == 1


@pytest.mark.skipif(os.name == "nt", reason="the programs of this test are scripts of a shell")
def test_a_python_that_is_advised_has_been_seen_to_run(course, tmp_path, monkeypatch):
    shims = tmp_path / "shims"
    for name, line in {
        "python3.14": "echo 'pyenv: python3.14: command not found'; exit 127",
        "python3.13": f'exec "{sys.executable}" -c "raise SystemExit(1)"',
        "python3.12": f'exec "{sys.executable}" "$@"',
    }.items():
        course.write(shims / name, f"#!/bin/sh\n{line}\n".encode())
        (shims / name).chmod(0o755)
    monkeypatch.setattr(course, "subprocess", subprocess)
    monkeypatch.setenv("PATH", str(shims))
    assert "You have one: python3.12 course.py" in course.old_python()
    (shims / "python3.12").unlink()
    assert "Get it: https://www.python.org" in course.old_python()
    assert course.this_command() == f'"{sys.executable}" course.py'
    os.symlink(shims / "python3.13", shims / "python3")
    course.write(shims / "python", f'#!/bin/sh\nexec "{sys.executable}" "$@"\n'.encode())
    (shims / "python").chmod(0o755)
    assert course.this_command() == "python course.py"


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


def loaded(path):
    spec = importlib.util.spec_from_file_location("course_again", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("code_page", ["cp1252", "ascii", None])
def test_a_path_that_the_code_page_lacks_is_read_and_shown(tmp_path, monkeypatch, code_page):
    monkeypatch.setenv("PYTHONUTF8", "0")
    monkeypatch.delenv("PYTHONIOENCODING", raising=False)
    if code_page:
        monkeypatch.setenv("PYTHONIOENCODING", code_page)
    module = loaded(shutil.copy(ROOT / "course.py", tmp_path))
    said = module.quietly("", sys.executable, "-c", "print('Mój kurs, książka, コース')")
    assert said.strip() == "Mój kurs, książka, コース"
    monkeypatch.setattr(module, "PYTHON", sys.executable)
    monkeypatch.setattr(module.signal, "signal", lambda *args: None)
    assert module.in_front("-c", "print('Mój kurs, książka, コース')") == 0


def test_a_mapped_drive_keeps_its_letter(tmp_path, monkeypatch):
    (tmp_path / "server").mkdir()
    shutil.copy(ROOT / "course.py", tmp_path / "server")
    os.symlink(tmp_path / "server", tmp_path / "drive")
    module = loaded(tmp_path / "drive" / "course.py")
    assert module.ROOT.name == "drive"


def test_a_program_that_runs_is_not_deleted_on_windows(course, monkeypatch, capsys):
    monkeypatch.setattr(course, "WINDOWS", True)
    monkeypatch.setattr(course.sys, "prefix", str(course.VENV))
    monkeypatch.setattr(course.sys, "_base_executable", "C:\\Python\\python.exe")
    monkeypatch.setattr(course, "one_at_a_time", contextlib.nullcontext)
    assert course.main(["lab"]) == 2
    told = capsys.readouterr()
    assert 'Type: "C:\\Python\\python.exe" course.py lab' in told.err
    assert told.err.count("\n") == 1 and not told.out and not course.programs.ran


def test_another_systems_packages_are_shut_out(monkeypatch):
    monkeypatch.setenv("PYTHONPATH", "/opt/robots/lib/python3/site-packages")
    module = loaded(ROOT / "course.py")
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
    ("error: failed to write: The system cannot find it. (os error 206)", "path is too long"),
    (
        "ERROR: Could not install packages due to an OSError: [Errno 2] No such file or directory\n"
        "HINT: This error might have occurred since this system does not have Windows Long Path "
        "support enabled. See https://pip.pypa.io/warnings/enable-long-paths",
        "path is too long",
    ),
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


@pytest.mark.parametrize("command", [["lab"], ["reset", "02"]])
def test_a_folder_that_cannot_be_written_costs_one_sentence(
    course, monkeypatch, capsys, exercise, command
):
    def refuse(path, mode="r", **options):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))

    monkeypatch.setattr(course, "open", refuse, raising=False)
    assert course.main(command) == 2
    told = capsys.readouterr()
    assert "cannot write in" in told.err and told.err.count("\n") == 1 and not told.out


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


SET = "02_alignment/02_alignment.ipynb"


def pages(*sources, output=""):
    """Return a notebook as it is saved."""
    cells = [
        {"cell_type": "code", "source": [source], "outputs": [output], "metadata": {"run": output}}
        for source in sources
    ]
    return json.dumps({"cells": cells, "metadata": {"shown": output}}).encode()


@pytest.fixture
def exercise(course):
    path = course.ROOT / "exercises" / SET
    course.write(path, pages("the exercise"))
    course.write(path.parent / "cloud.csv", b"1,2")
    course.write(path.parent / ".ipynb_checkpoints" / "x.ipynb", b"")
    course.write(course.ROOT / "notebooks" / "02_alignment.ipynb", pages("the lecture"))
    course.write(course.ROOT / "notebooks" / "02_picture.png", b"a picture")
    course.write(course.ROOT / "notebooks" / "ruff.toml", b"")
    return course.ROOT / "my_work" / SET


def in_my_work(course):
    return sorted(name for name in tree(course.ROOT / "my_work") if not name.startswith("."))


def test_my_work_gets_lectures_and_exercises(course, exercise, capsys):
    course.hand_out()
    assert exercise.read_bytes() == pages("the exercise")
    assert (exercise.parent / "cloud.csv").read_bytes() == b"1,2"
    lectures = ["lectures/02_alignment.ipynb", "lectures/02_picture.png"]
    assert in_my_work(course) == [SET, "02_alignment/cloud.csv", *lectures]
    assert capsys.readouterr().out == "New in my_work: 02_alignment, lectures\n"
    (exercise.parent / "cloud.csv").unlink()
    course.hand_out()
    assert (exercise.parent / "cloud.csv").exists(), "what was deleted comes back"
    course.hand_out()
    assert capsys.readouterr().out == "New in my_work: 02_alignment\n"


def test_work_is_never_overwritten_and_the_newer_version_is_told_once(course, exercise, capsys):
    course.hand_out()
    exercise.write_bytes(pages("my answer"))
    (exercise.parent / "cloud.csv").write_bytes(b"my data")
    course.write(course.ROOT / "exercises" / SET, pages("version 2"))
    course.write(course.ROOT / "exercises/02_alignment/cloud.csv", b"3,4")
    course.write(course.ROOT / "exercises/03_trajectory/03_trajectory.ipynb", pages("a new one"))
    capsys.readouterr()
    course.hand_out()
    told = capsys.readouterr().out
    assert f"There is a newer my_work/{SET}." in told and "02_alignment.new.ipynb" in told
    assert "cloud.new.csv" in told and "New in my_work: 03_trajectory" in told
    newer = exercise.with_name("02_alignment.new.ipynb")
    assert exercise.read_bytes() == pages("my answer") and newer.read_bytes() == pages("version 2")
    assert (exercise.parent / "cloud.csv").read_bytes() == b"my data"
    newer.unlink()
    course.hand_out()
    assert not newer.exists() and not capsys.readouterr().out


def test_a_third_version_takes_the_place_of_the_second_if_nobody_has_written_in_it(
    course, exercise
):
    course.hand_out()
    exercise.write_bytes(pages("my answer"))
    source, newer = course.ROOT / "exercises" / SET, exercise.with_name("02_alignment.new.ipynb")
    for number in (2, 3):
        course.write(source, pages(f"version {number}"))
        course.hand_out()
        assert newer.read_bytes() == pages(f"version {number}")
    newer.write_bytes(pages("my second answer"))
    course.write(source, pages("version 4"))
    course.hand_out()
    assert newer.read_bytes() == pages("my second answer")
    second = exercise.with_name("02_alignment.new-2.ipynb")
    assert second.read_bytes() == pages("version 4")
    assert exercise.read_bytes() == pages("my answer")


@pytest.mark.parametrize("run", [False, True], ids=["unopened", "run and saved"])
def test_a_copy_without_a_word_of_the_students_is_replaced(course, exercise, capsys, run):
    course.hand_out()
    if run:  # JupyterLab adds an empty cell at the end
        exercise.write_bytes(pages("the exercise", "", output="what it shows"))
    course.hand_out()
    assert (b"what it shows" in exercise.read_bytes()) == run, "nothing is newer yet"
    course.write(course.ROOT / "exercises" / SET, pages("version 2"))
    course.write(course.ROOT / "exercises/02_alignment/cloud.csv", b"3,4")
    capsys.readouterr()
    course.hand_out()
    assert exercise.read_bytes() == pages("version 2")
    assert (exercise.parent / "cloud.csv").read_bytes() == b"3,4"
    assert capsys.readouterr().out == "Updated in my_work: 02_alignment\n"
    assert not list(exercise.parent.glob("*.new*"))


def test_new_outputs_alone_are_no_news_to_who_has_answered(course, exercise, capsys):
    course.hand_out()
    exercise.write_bytes(pages("my answer"))
    course.write(course.ROOT / "exercises" / SET, pages("the exercise", output="other"))
    capsys.readouterr()
    course.hand_out()
    assert not capsys.readouterr().out and exercise.read_bytes() == pages("my answer")


@pytest.mark.parametrize("damage", [b"", b"[]", b'{"02_alignment/02_alignment.ipynb": 3}'])
def test_without_knowing_what_was_handed_out_nothing_is_overwritten(course, exercise, damage):
    course.hand_out()
    course.write(course.HANDED_OUT, damage)
    course.hand_out()
    assert not list(exercise.parent.glob("*.new*")), "what is as in exercises/ is not newer"
    exercise.write_bytes(pages("my answer"))
    course.write(course.HANDED_OUT, damage)
    course.hand_out()
    assert exercise.read_bytes() == pages("my answer")


def links(path):
    for cell in json.loads(path.read_bytes())["cells"]:
        if cell["cell_type"] == "markdown":
            yield from re.findall(r"\]\(([^)#]+)", "".join(cell["source"]))


def test_links_of_the_copies_lead_to_copies_and_to_files_that_exist(course):
    for name in ("exercises", "notebooks"):
        shutil.copytree(ROOT / name, course.ROOT / name)
    course.hand_out()
    copies = [*(course.ROOT / "my_work").rglob("*.ipynb")]
    assert len(copies) == len(
        [*(ROOT / "exercises").rglob("*.ipynb"), *ROOT.glob("notebooks/*.ipynb")]
    )
    seen = set()
    for copy in copies:
        for link in links(copy):
            if "://" in link:
                continue
            target = Path(os.path.normpath(copy.parent / link)).relative_to(course.ROOT)
            assert (course.ROOT / target).exists() or (ROOT / target).exists(), (copy.name, link)
            assert target.parts[0] not in course.LINKS, (copy.name, link)
            seen.add("/".join(target.parts[:2]))
    assert {"my_work/lectures", "my_work/04_consistency", "README.md"} <= seen


def git(folder, *arguments):
    done = subprocess.run(
        ["git", "-c", "user.name=A", "-c", "user.email=a@b", *arguments],
        cwd=folder,
        capture_output=True,
        encoding="utf-8",
    )
    assert not done.returncode, done.stderr
    return done.stdout


@pytest.mark.skipif(not shutil.which("git"), reason="there is no git on this machine")
def test_a_lecture_that_was_opened_and_saved_does_not_block_git_pull(tmp_path, started, course):
    course.main(["lab"])
    opened = next(part for part in started[-1] if "default_url" in part)
    opened = opened.partition("/lab/tree/")[2]  # what JupyterLab shows, and saves
    lecture = f"notebooks/{Path(opened).name}"
    upstream, mine = tmp_path / "upstream", tmp_path / "mine"
    upstream.mkdir()
    git(upstream, "init", "--initial-branch=main")
    shutil.copy(ROOT / ".gitignore", upstream)
    shutil.copy(ROOT / "course.py", upstream)
    course.write(upstream / lecture, pages("the lecture"))
    course.write(upstream / "exercises" / SET, pages("the exercise"))
    git(upstream, "add", ".")
    git(upstream, "commit", "--message=1")
    git(tmp_path, "clone", str(upstream), str(mine))
    clone = loaded(mine / "course.py")
    clone.hand_out()
    saved = pages("the lecture", "my own notes", output="42")
    course.write(mine / opened, saved)
    course.write(mine / "my_work" / SET, pages("my answer"))
    course.write(upstream / lecture, pages("a better lecture"))
    course.write(upstream / "exercises" / SET, pages("a better exercise"))
    git(upstream, "commit", "--all", "--message=2")
    git(mine, "pull")
    assert (mine / lecture).read_bytes() == pages("a better lecture")
    clone.hand_out()
    assert (mine / opened).read_bytes() == saved
    assert (mine / opened.replace(".ipynb", ".new.ipynb")).read_bytes() == pages("a better lecture")
    assert (mine / "my_work" / SET).read_bytes() == pages("my answer")
    assert not git(mine, "status", "--porcelain")


# ---- reset and progress ----------------------------------------------------------------------


@pytest.mark.parametrize("name", ["02", "02_alignment"])
def test_reset_lays_a_fresh_copy_and_keeps_the_old_one(course, exercise, capsys, name):
    course.hand_out()
    notes = {"02_alignment": {"a": {"holds": True}}, "03_trajectory": {"b": {"holds": True}}}
    progress = course.ROOT / "my_work" / "progress.json"
    for number in (1, 2):
        exercise.write_bytes(pages(f"answer {number}"))
        course.write(progress, json.dumps(notes).encode())
        assert course.main(["reset", name]) == 0
        assert exercise.read_bytes() == pages("the exercise")
        assert json.loads(progress.read_bytes()) == {"03_trajectory": notes["03_trajectory"]}
    today = course.time.strftime("%Y-%m-%d")
    kept = [f"02_alignment.{today}.ipynb", f"02_alignment.{today}-2.ipynb"]
    assert [exercise.with_name(name).read_bytes() for name in kept] == [
        pages("answer 1"),
        pages("answer 2"),
    ]
    assert f"Kept as my_work/02_alignment/{kept[0]}" in capsys.readouterr().out
    assert course.main(["reset", name]) == 0 and len(list(exercise.parent.glob("*.ipynb"))) == 3
    exercise.unlink()
    assert course.main(["reset", name]) == 0 and exercise.exists()
    course.write(course.ROOT / "exercises" / SET, pages("version 2"))
    course.hand_out()
    assert exercise.read_bytes() == pages("version 2"), "a reset set is as it was handed out"


def test_reset_touches_no_other_set_and_no_lecture(course, exercise):
    course.write(course.ROOT / "exercises/03_trajectory/03_trajectory.ipynb", pages("three"))
    course.hand_out()
    others = [course.ROOT / "my_work" / name for name in in_my_work(course) if "02_a" not in name]
    for path in others:
        path.write_bytes(b"mine")
    course.main(["reset", "02"])
    assert {path.read_bytes() for path in others} == {b"mine"}


@pytest.mark.parametrize("arguments", [[], ["2"], ["99"], ["alignment"], ["02", "03"], ["../02"]])
def test_reset_of_an_unknown_set_names_the_sets(course, exercise, capsys, arguments):
    course.hand_out()
    before = tree(course.ROOT / "my_work")
    assert course.main(["reset", *arguments]) == 2
    told = capsys.readouterr().err
    assert "Name one of: 02_alignment." in told and told.count("\n") == 1
    assert tree(course.ROOT / "my_work") == before


def test_progress_is_shown_on_request_and_before_lab_opens(course, started, exercise):
    course.main(["progress"])
    shown = ["-m", "amrmetrics._progress"]
    assert started == [shown]
    course.main(["lab"])
    assert len(started) == 2 and started[-1][1] == "jupyterlab", "there is nothing to show yet"
    course.write(course.ROOT / "my_work" / "progress.json", b"{}")
    course.main(["lab"])
    assert started[-2] == shown and started[-1][1] == "jupyterlab"


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
    assert exercise.read_bytes() == pages("the exercise")


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
    assert "--LabApp.default_url=/lab/tree/my_work/lectures/00_start_here.ipynb" in line
    assert "--ContentsManager.hide_globs=notebooks" in line
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
    assert not [*house.glob("build/*"), *house.glob("gradebook.db")]


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
    assert "set-up: FAILED" in said and "course.py lab" in said
    assert not course.programs.count("-m venv") and not course.programs.count("install")
