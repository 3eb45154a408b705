"""Grading gives each submission what it is worth, whatever it does, and nobody else's mark."""

import csv
import io
import os
import subprocess
import sys
import zipfile

import grade
import hostile
import pytest
from exercise import ROOT
from grading import collecting, isolation, notebooks, pages, wire

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
    options = ["--out", folder / "out", "--jobs", str(jobs), "--cell-seconds", "6"]
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


def test_goes_on_after_it_was_stopped_and_takes_marks_for_prose(graded_class, chosen):
    folder, before, _, _ = graded_class
    out = folder / "out"
    (out / "records" / "s000" / "02_alignment.json").unlink()
    marks = 'student,set,part,points,comment\ns000,02_alignment,prose-g,"1,5",Why a half?\n'
    (out / "prose.csv").write_text(marks, encoding="utf-8")
    command = [sys.executable, ROOT / "tools" / "grade.py", folder / "in", "--out", out]
    subprocess.run(command, check=True, capture_output=True, timeout=600)
    after = rows_in(out)
    assert after["s000"]["prose-g"] == "1.5"
    assert after["s000"]["state"] == "complete"
    for k, kind in enumerate(chosen[1:], 1):
        assert after[f"s{k:03d}"]["points"] == before[kind.name]["points"]
    assert "Why a half?" in (out / "feedback" / "s000" / "02_alignment.html").read_text()


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
