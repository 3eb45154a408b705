"""Grading gives each submission what it is worth, whatever it does, and nobody else's mark."""

import contextlib
import copy
import csv
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

import grade
import hostile
import nbformat
import pytest
from exercise import ROOT, ProblemSet, grade_id
from grading import checker, collecting, isolation, material, notebooks, pages, wire

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="grading needs fork")

KINDS = list(hostile.kinds())
QUICK = [kind for kind in KINDS if kind.quick]


def graded(folder, kinds, jobs=2):
    """Hand in one submission per student, grade them, and return rows of grades.csv by student."""
    for k, kind in enumerate(kinds):
        file = folder / "in" / f"s{k:03d}" / kind.file
        file.parent.mkdir(parents=True)
        file.write_bytes(kind.data)
    command = [sys.executable, ROOT / "tools" / "grade.py", folder / "in"]
    options = ["--out", folder / "out", "--jobs", str(jobs), "--cell-seconds", "3"]
    done = subprocess.Popen(
        [*command, *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )
    said, _ = done.communicate(timeout=1500)
    assert done.returncode == 0, said
    return rows_in(folder / "out"), said, done.pid


def rows_in(out):
    text = (out / "grades.csv").read_text(encoding="utf-8-sig")
    return {row["student"]: row for row in csv.DictReader(io.StringIO(text))}


@pytest.fixture(scope="module")
def chosen(request):
    return KINDS if request.config.getoption("--sweep", default=False) else QUICK


@pytest.fixture(scope="module")
def graded_class(tmp_path_factory, chosen):
    folder = tmp_path_factory.mktemp("class")
    rows, said, pid = graded(folder, chosen)
    rows = {kind.name: rows[f"s{k:03d}"] for k, kind in enumerate(chosen)}
    return folder, rows, said, pid


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_gets_what_it_is_worth_and_the_event_is_told(kind, graded_class, chosen):
    if kind not in chosen:
        pytest.skip("with --sweep")
    row = graded_class[1][kind.name]
    auto = {part: row[part] for part in hostile.POINTS}
    opened = tuple(part for part, mark in auto.items() if mark.startswith("not graded: "))
    assert opened == kind.opened, row
    assert sum(float(m) for p, m in auto.items() if p not in opened) == kind.points, row
    assert kind.says in " ".join(row.values()), row


def test_official_answers_get_all_marks_in_every_set(tmp_path, request):
    if not request.config.getoption("--sweep"):
        pytest.skip("with --sweep")
    for path in sorted((ROOT / "solutions").glob("*/*.ipynb")):
        problem_set = ProblemSet(path.stem)
        made = copy.deepcopy(problem_set.exercise)
        for cell in made.cells:
            cell.source = problem_set.official.get(grade_id(cell), cell.source)
        folder = tmp_path / "in" / f"student of {path.stem}" / path.stem
        folder.mkdir(parents=True)
        (folder / path.name).write_text(json.dumps(made), encoding="utf-8")
    command = [sys.executable, ROOT / "tools" / "grade.py", tmp_path / "in"]
    subprocess.run([*command, "--out", tmp_path / "out"], check=True, timeout=1500)
    for name, row in rows_in(tmp_path / "out").items():
        known = material.load(ROOT, name.removeprefix("student of "))
        marks = {p.name: float(row[p.name]) for p in known.parts.values() if not p.by_hand}
        assert marks == {p.name: p.points for p in known.parts.values() if not p.by_hand}, row


def test_says_how_well_submissions_are_isolated(graded_class):
    said = graded_class[2]
    assert any(level in said for level in isolation.LEVELS.values())


def test_prose_waits_for_a_person_and_is_no_zero(graded_class):
    row = graded_class[1]["good"]
    assert row["prose-g"] == "waits for a person"
    assert row["state"] == "waits for a person: prose-g"
    assert graded_class[1]["untouched"]["prose-g"] == "0"


def test_nothing_of_a_submission_goes_on_running(graded_class):
    first = isolation.FIRST_USER + graded_class[3] % 500 * 10
    users = {str(first + slot) for slot in range(4)}
    found = subprocess.run(["ps", "-eo", "uid="], capture_output=True, text=True).stdout.split()
    assert not users & set(found)


def test_feedback_shows_no_hidden_test_and_loads_nothing(graded_class):
    for path in graded_class[0].glob("out/feedback/*/*.html"):
        text = path.read_text(encoding="utf-8")
        for secret in ("hidden cloud", "BEGIN HIDDEN", "check.function("):
            assert secret not in text
        assert "http" not in text.replace("http-equiv", "").replace("http://www.w3.org", "")


def test_goes_on_after_it_was_killed_and_takes_marks_for_prose(graded_class, chosen, tmp_path):
    folder, before, _, _ = graded_class
    out = folder / "out"
    (out / "records" / "s000" / "02_alignment.json").unlink()
    marks = 'student,set,part,points,comment\ns000,02_alignment,prose-g,"1,5",Why a half?\n'
    (out / "prose.csv").write_text(marks, encoding="utf-8")
    command = [sys.executable, ROOT / "tools" / "grade.py", folder / "in", "--out", out]
    environment = dict(os.environ, TMPDIR=str(tmp_path))
    killed = subprocess.Popen(command, stdout=subprocess.PIPE, env=environment)
    assert killed.stdout.readline().startswith(b"Each submission runs with")
    killed.kill()
    killed.communicate()
    (left,) = tmp_path.iterdir()
    end = time.monotonic() + 60
    while any(str(left) in said for said in command_lines()):
        assert time.monotonic() < end, "what a killed run has started goes on running"
        time.sleep(0.2)

    said = in_a_terminal([*command, "--jobs", "1"], environment)
    assert f"\r{len(chosen)} of {len(chosen)} submissions, " in said
    assert not list(tmp_path.iterdir())
    after = rows_in(out)
    assert after["s000"]["prose-g"] == "1.5"
    assert after["s000"]["state"] == "complete"
    for k, kind in enumerate(chosen[1:], 1):
        assert after[f"s{k:03d}"]["points"] == before[kind.name]["points"]
    assert "Why a half?" in (out / "feedback" / "s000" / "02_alignment.html").read_text()


def command_lines():
    for path in Path("/proc").glob("[0-9]*/environ"):
        try:
            yield path.read_text(errors="replace")
        except OSError:
            continue


def in_a_terminal(command, environment):
    """Run a command whose standard error is a terminal, and return what it writes there."""
    master, slave = os.openpty()
    started = subprocess.Popen(command, stderr=slave, stdout=subprocess.DEVNULL, env=environment)
    os.close(slave)
    said = b""
    with contextlib.suppress(OSError):  # Linux's word for the end
        while part := os.read(master, 1 << 12):
            said += part
    os.close(master)
    assert started.wait(60) == 0, said
    return said.decode()


def test_removes_what_killed_runs_have_left_and_nothing_else(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    for name in ("grading-dead", "grading-other"):
        (tmp_path / name / "work").mkdir(parents=True)
    (tmp_path / "grading-dead" / "lock").touch()
    (tmp_path / "grading-link").symlink_to(tmp_path / "grading-dead")
    with grade.workplace() as running, grade.workplace() as second:
        found = {path.name for path in tmp_path.iterdir()}
        assert found == {running.name, second.name, "grading-other", "grading-link"}
    assert {path.name for path in tmp_path.iterdir()} == {"grading-other", "grading-link"}


def test_says_on_windows_what_to_use_instead(monkeypatch, capsys, tmp_path):
    monkeypatch.delattr(os, "fork")
    assert grade.main([str(tmp_path)]) == 2
    assert "WSL" in capsys.readouterr().err


def test_without_namespaces_it_says_what_is_not_protected(monkeypatch):
    monkeypatch.setattr(sys, "platform", "darwin")
    for user, level in ((501, "limits"), (0, "another user")):
        monkeypatch.setattr(os, "geteuid", lambda user=user: user)
        assert isolation.separate() == level
    assert "could read and change what you can" in isolation.LEVELS["limits"]
    monkeypatch.setattr(os, "geteuid", lambda: 501)
    monkeypatch.setattr(os, "scandir", lambda path: os.listdir("/nowhere"))
    assert isolation.running() > 100


def test_results_and_downloads_are_not_for_git():
    names = ["build/grades/grades.csv", "grades.csv", "downloaded/class.zip", "build/gradebook.db"]
    done = subprocess.run(["git", "check-ignore", *names], cwd=ROOT, capture_output=True, text=True)
    if "not a git repository" in done.stderr:
        pytest.skip("this copy of the course is no git repository")
    assert done.stdout.split() == names


PLAIN = r"""
import os, sys, time
from pathlib import Path
from grading import checker, isolation, student, worker

student.preload()
isolation.separate = isolation.plain_level
root, data, user = sys.argv[1:]
order = {"data": data, "root": root, "home": root + "/home", "hidden": [], "user": int(user)}
order |= {"limits": {"memory": 4 << 30, "processes": 64, "seconds": 60}}
slot = worker.Slot(order)
process = checker.Process(slot.zygote, order)


def run(source):
    said = process.ask({"do": "run", "source": source}, 20)
    assert not said["error"], said


def value(name):
    said = process.ask({"do": "names", "names": [name]}, 20)
    return process.peer.understood(said["values"][name])


def of_user():
    return [p for p in Path("/proc").glob("[0-9]*") if p.stat().st_uid == int(user)]


run("import os\nfrom amrmetrics import check\nx = [1, 2]\ncheck.keep(globals(), 'x')")
run("x.append(3)\nfound = os.getuid(), open('points.csv').read(), os.environ.get('SECRET')")
process.ask({"do": "restore"}, 20)
assert value("x") == [1, 2], value("x")
assert value("found") == (int(user), "1,2", None), value("found")
run("import time\nif os.fork() == 0:\n    os.setsid()\n    time.sleep(999)")
process.end()
assert of_user()
isolation.end_all(int(user))
end = time.monotonic() + 20
while of_user():
    assert time.monotonic() < end
    time.sleep(0.1)
print("fine")
"""


TRIALS = """
import sys
import amrmetrics as am
from amrmetrics.benchmark import Scenario, System, estimators, running, worlds
from grading import student


def stops(log):
    raise RuntimeError("stopped")


started = []
real = running.subprocess.Popen
running.subprocess.Popen = lambda *a, **k: started.append(a) or real(*a, **k)
systems = [System("ekf", estimators.ekf_slam), System("stops", stops)]
hall = Scenario("hall", worlds.make, {"steps": 20}, "test")
found = []
for replaced in (True, False):
    if replaced:
        real_one, running._in_a_process = running._in_a_process, student.in_a_fork
    else:
        running._in_a_process = real_one
    folder = sys.argv[1] + f"/{replaced}"
    am.benchmark.run(systems, [hall], [0], folder, progress=False)
    rows = am.benchmark.evaluate(folder, jobs=1).rows
    found.append([(r["system"], r["status"], r["reason"], r["ate"]) for r in rows])
    assert bool(started) is not replaced
assert found[0] == found[1], found
print("fine")
"""


def test_trials_of_a_benchmark_run_in_forks_as_they_do_in_programs(tmp_path):
    done = scripted(TRIALS, tmp_path)
    assert done.stdout == "fine\n", done.stderr


def scripted(script, *arguments):
    path = os.pathsep.join([str(ROOT), str(ROOT / "tools")])
    return subprocess.run(
        [sys.executable, "-c", script, *arguments],
        env=dict(os.environ, PYTHONPATH=path, SECRET="1"),
        capture_output=True,
        text=True,
        timeout=120,
    )


@pytest.mark.skipif(not Path("/proc").is_dir() or os.geteuid() != 0, reason="only root can")
def test_without_namespaces_root_lends_another_user_and_leaves_nothing_running(tmp_path):
    for folder in (tmp_path, *tmp_path.parents[:2]):
        folder.chmod(0o755)
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "points.csv").write_text("1,2")
    user = str(isolation.FIRST_USER + 6000 + os.getpid() % 1000)
    done = scripted(PLAIN, tmp_path, tmp_path / "data", user)
    assert done.stdout == "fine\n", done.stderr


def test_nbgrader_makes_the_same_exercise_on_a_fresh_clone(tmp_path):
    name = hostile.NAME
    shutil.copy(ROOT / "nbgrader_config.py", tmp_path)
    for house in ("solutions", "exercises"):
        shutil.copytree(ROOT / house / name, tmp_path / house / name)
    command = [sys.executable, "-m", "nbgrader", "generate_assignment", name, "--force"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    made, released = (base / "exercises" / name / f"{name}.ipynb" for base in (tmp_path, ROOT))
    assert json.loads(made.read_text()) == json.loads(released.read_text())
    assert (tmp_path / "build" / "gradebook.db").is_file()


# --- checks ---------------------------------------------------------------------------------------

CHECK = """
@check.part(globals())
def check_a(map_score, other):
    def inner(not_asked):
        return used
    check.value("a", map_score, inner(1))
"""


def test_a_check_asks_for_what_its_parameters_name():
    assert material.asked(CHECK) == ("map_score", "other")
    assert material.asked("check.value('a', yours, 3)") == ()


def test_what_a_function_says_of_itself_does_not_choose_its_cases():
    own = checker.Checker(None, None, None, None)
    own.ran = [{"do": "run", "source": "def f(): pass"}, {"do": "restore"}]
    function = own.called(None, "f", ["call", 0, "f"])
    assert "def f(): pass" in function.__answer__


def test_a_check_that_stumbles_over_an_answer_gives_no_mark_and_says_so(monkeypatch):
    said = []
    own = checker.Checker(None, None, None, said.append)
    part = material.Part("part-a", 3, check="hidden", shown_check="shown")
    for error, points in ((TypeError("odd"), 0), (MemoryError(), None), (wire.Gone("slow"), None)):
        monkeypatch.setattr(own, "judge", lambda part, source, error=error: error)
        assert own.check(part)[0] == points
    (note,) = said
    assert "TypeError: odd" in note["note"]


@pytest.mark.parametrize(
    ("results", "asked"),
    [([2, 2, 2, 5], 3), ([2, 2, 5, 2, 2, 2], 6), ([[2], [2], [2], [2], [2], [2]], 6)],
)
def test_a_result_is_asked_again_until_it_was_three_times_the_same(results, asked):
    given = []

    class Peer(wire.Peer):
        def ask(self, message):
            given.append(results[len(given)])
            return {"value": self.write(given[-1])}

    peer = Peer(None, None)
    peer.memory = {}
    said = [peer.call(0, (0.5, [1, "x"]), {}) for _ in range(6)]
    assert len(given) == asked
    assert said == (given + [2] * 6)[:6]


LIBRARY = {
    "01_poses": (
        "part-c",
        "def pose_between(a, b, s):\n    return am.interpolate([0, 1], [a, b], s)",
    ),
    "04_consistency": (
        "part-c",
        "def nees(errors, covariances):\n    return am.nees(errors, covariances)",
    ),
    "05_scoring": (
        "part-c",
        "def map_score(y, p, unknown, score=am.cross_entropy):\n"
        "    return score(y[~unknown], p[~unknown]).value",
    ),
}


@pytest.mark.parametrize("name", LIBRARY)
def test_what_the_library_did_gets_no_mark(name, tmp_path):
    """The check watches its own process; in the student's, the functions have to be taken away."""
    part, source = LIBRARY[name]
    notebook = copy.deepcopy(ProblemSet(name).exercise)
    next(cell for cell in notebook.cells if grade_id(cell) == part).source = source
    file = tmp_path / "in" / "anna" / name / f"{name}.ipynb"
    file.parent.mkdir(parents=True)
    nbformat.write(notebook, file)
    command = [sys.executable, ROOT / "tools" / "grade.py", tmp_path / "in"]
    done = subprocess.run([*command, "--out", tmp_path / "out"], capture_output=True, timeout=600)
    assert done.returncode == 0, done.stdout
    assert rows_in(tmp_path / "out")["anna"][part] == "0"
    page = (tmp_path / "out" / "feedback" / "anna" / f"{name}.html").read_text(encoding="utf-8")
    assert "would do your work here" in page


# --- finding -------------------------------------------------------------------------------------

SETS = ["01_poses", "02_alignment"]


def archive(names):
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as file:
        for name in names:
            file.writestr(name, "{}")
    return made.getvalue()


@pytest.mark.parametrize(
    ("name", "student"),
    [
        ("anna/02_alignment/02_alignment.ipynb", "anna"),
        ("anna/02_alignment.ipynb", "anna"),
        ("Anna_02_alignment.ipynb", "Anna"),
        ("Ada L_123_assignsubmission_file/02_alignment.ipynb", "Ada L 123"),
        ("Ada L_123_assignsubmission_file_/02_alignment (2).ipynb", "Ada L 123"),
        ("Ada L_123_assignsubmission_file_02_alignment.ipynb", "Ada L 123"),
        ("lovelaceada_4711_815_02_alignment-2.ipynb", "lovelaceada"),
        ("lovelaceada_LATE_4711_815_02_alignment.ipynb", "lovelaceada"),
    ],
)
def test_file_names_of_folders_and_learning_platforms(tmp_path, name, student):
    plain, zipped = tmp_path / "plain", tmp_path / "class.zip"
    (plain / name).parent.mkdir(parents=True)
    (plain / name).write_text("{}")
    zipped.write_bytes(archive([name]))
    for place in (plain, zipped):
        (found,) = collecting.find(place, SETS)
        assert (found.student, found.set, found.problem) == (student, "02_alignment", "")
        assert found.data() == b"{}"


def test_follows_no_link_and_leaves_no_folder(tmp_path):
    folder = tmp_path / "in" / "eve" / "02_alignment"
    folder.mkdir(parents=True)
    (tmp_path / "other.ipynb").write_text("{}")
    (folder / "02_alignment.ipynb").symlink_to(tmp_path / "other.ipynb")
    (found,) = collecting.find(tmp_path / "in", SETS)
    assert "link" in found.problem
    assert found.data is None
    (tmp_path / "a.zip").write_bytes(archive(["../../eve/02_alignment/02_alignment.ipynb"]))
    assert [f.place for f in collecting.find(tmp_path / "a.zip", SETS)] == [
        "eve/02_alignment/02_alignment.ipynb"
    ]


def test_spreadsheets_and_pages_take_names_for_names(tmp_path):
    assert grade.safe("=cmd()").startswith("'")
    assert "<script>" not in pages.prose("<script>alert(1)</script> **a** $x^2$")
    shown = pages.prose("It is $s=A/Q$, *always*.\n\nSo $J<0$.")
    assert shown.count("</svg>") == 2
    assert shown.endswith(".</p>")
    assert "<em>always</em>" in shown
    assert "<br>" not in shown
    assert grade.file_name("../../etc") != grade.file_name("../..//etc")
    assert "/" not in grade.file_name("../../etc")


# --- what crosses --------------------------------------------------------------------------------


def crossed(x):
    import json

    def refuse(*_):
        raise AssertionError("no function here")

    data = json.loads(json.dumps(wire.Writer({}, {})(x)))
    return wire.Reader({}, refuse)(data)


def test_plain_values_cross_unchanged():
    import numpy as np
    import sympy as sp

    x, y = sp.symbols("x y", positive=True)
    k = sp.Symbol("k", integer=True)
    values = [
        None, True, 3, -(10**30), 2.5, float("inf"), "text", 1j, b"raw", ..., range(3),
        [1, (2, {"a": {3}})], np.float64(0.1), np.arange(6.0).reshape(2, 3), np.array("a"),
        sp.Add(x, x, evaluate=False), sp.Eq(x, y, evaluate=False), sp.Sum(x**k, (k, 1, 3)),
        sp.Derivative(sp.sin(x) / y, x), sp.Rational(1, 3), sp.Float("0.25"), sp.oo, sp.pi,
        sp.Function("f")(x), sp.IndexedBase("p")[k], sp.atan2(y, x), sp.Limit(1 / x, x, sp.oo),
        sp.Piecewise((x, x > 1), (y, True)), sp.Matrix([[x, 1]]),
    ]  # fmt: skip
    for value in values:
        found = crossed(value)
        assert type(found) is type(value)
        same = np.array_equal(found, value) if isinstance(value, np.ndarray) else found == value
        assert same, value


def test_folders_of_answers_cross_and_stay_where_they_are_put(tmp_path):
    home, place = tmp_path / "home", tmp_path / "place"
    (home / "logs" / "a").mkdir(parents=True)
    (home / "logs" / "a" / "b.csv").write_text("1,2")
    (home / "logs" / "link").symlink_to(__file__)
    values = {"folder": wire.Writer({}, {})(home / "logs"), "verdict": "logs", "other": "/etc"}
    folders = wire.folders_in(values, str(home))
    moved = wire.laid_out(values, folders, str(place))
    there = wire.Reader({}, None)(moved["folder"])
    assert [path.relative_to(place) for path in sorted(place.rglob("*.*"))] == [Path("0/a/b.csv")]
    assert (there / "a" / "b.csv").read_text() == "1,2"
    assert (moved["verdict"], moved["other"]) == ("logs", "/etc")
    for name in ("../x", "/etc/x", "a/../../x"):
        with pytest.raises(wire.Gone):
            wire.laid_out({}, {"logs": {name: ""}}, str(place))


def test_what_could_run_does_not_cross():
    class Pretender(float):
        def __eq__(self, other):
            return True

        def __hash__(self):
            return 0

    assert type(crossed(Pretender(2))) is float
    assert isinstance(crossed(object()), wire.Opaque)
    for data in (["sympy", ["of", "sympify", []]], ["ours", "os:system", []], ["nothing"]):
        with pytest.raises((ValueError, AttributeError, TypeError)):
            wire.Reader({}, None)(data)


def test_a_damaged_file_keeps_its_whole_cells():
    text = '{"cells": [{"cell_type": "code", "source": "a = 1"}, {"cell_type": "co'
    found = notebooks.read(text.encode())
    assert [cell.source for cell in found.cells] == ["a = 1"]
    assert found.cut_off
