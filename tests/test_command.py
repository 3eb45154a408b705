"""The command gives the library's numbers, useful pages, honest exit codes and one-line errors."""

import csv
import html.parser
import io
import json
import os
import re
import subprocess
import sys

import numpy as np
import pytest

import amrmetrics as am
from amrmetrics.command import main

T = np.arange(0, 120, 0.1)


def drive(noise=0.0, seed=0, t=T):
    rng = np.random.default_rng(seed)
    xyz = np.c_[2 * t, 5 * np.sin(t / 3), 0 * t] + noise * rng.normal(size=(len(t), 3))
    half = np.arctan2(5 / 3 * np.cos(t / 3), 2) / 2
    q = np.c_[0 * t, 0 * t, np.sin(half), np.cos(half)]
    return am.Trajectory(t, am.spatial_poses(xyz, q))


@pytest.fixture
def files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    am.write_tum("truth.txt", drive())
    am.write_tum("good.txt", drive(0.02, 1))
    am.write_tum("bad.txt", drive(0.3, 2))
    return tmp_path


def run(capsys, *arguments):
    code = main(list(arguments))
    said = capsys.readouterr()
    return code, said.out, said.err


class TestNumbers:
    def test_are_the_librarys(self, files, capsys):
        code, said, _ = run(capsys, "truth.txt", "good.txt", "--json", "-")
        report = am.evaluate("truth.txt", "good.txt")
        assert code == 0
        assert json.loads(said) == report.as_dict()
        code, said, _ = run(capsys, "truth.txt", "good.txt")
        assert said == f"{report}\n"

    @pytest.mark.parametrize(
        ("arguments", "keywords"),
        [
            (["--align", "similarity"], {"align": "similarity"}),
            (["--align", "none"], {"align": "none"}),
            (["--first", "20"], {"first": 20}),
            (["--delta", "5", "--unit", "m"], {"deltas": [(5, "m")]}),
            (["--delta", "5", "--delta", "2", "--unit", "s"], {"deltas": [(5, "s"), (2, "s")]}),
            (["--delta", "4"], {"deltas": [(4, "frames")]}),
            (["--project", "xy"], {"plane": "xy"}),
            (["--interpolate", "--max-gap", "3"], {"interpolate": True, "max_gap": 3}),
            (["--max-difference", "0.03"], {"max_difference": 0.03}),
            (["--offset", "0.2"], {"offset": 0.2}),
        ],
    )
    def test_options_reach_the_library(self, files, capsys, arguments, keywords):
        code, said, _ = run(capsys, "truth.txt", "good.txt", *arguments, "--json", "-")
        assert code == 0
        assert json.loads(said) == am.evaluate("truth.txt", "good.txt", **keywords).as_dict()

    def test_body_skip_and_times(self, files, capsys):
        both = ("truth.txt", "good.txt", "--json", "-")
        _, said, _ = run(capsys, *both, "--body", "0 0.1 0 0 0 0 1")
        body = am.spatial_poses([[0, 0.1, 0]], [[0, 0, 0, 1]])[0]
        assert json.loads(said) == am.evaluate("truth.txt", "good.txt", body=body).as_dict()
        _, said, _ = run(capsys, *both, "--skip", "10")
        assert json.loads(said)["coverage"]["estimate"] == 120
        _, said, _ = run(capsys, *both, "--from", "5", "--to", "15")
        assert json.loads(said)["coverage"]["matched"] == 101

    def test_kitti_with_times(self, files, capsys):
        am.write_kitti("truth.kitti", drive())
        am.write_kitti("run.kitti", drive(0.02, 1))
        np.savetxt("times.txt", T)
        arguments = ("truth.kitti", "run.kitti", "--times", "times.txt", "--json", "-")
        for more in ((), ("--format", "kitti")):
            code, said, _ = run(capsys, *arguments, *more)
            assert code == 0
            assert json.loads(said)["coverage"]["duration"] == pytest.approx(119.9)

    def test_stated_columns_and_formats(self, files, capsys):
        for name in ("truth", "good"):
            rows = np.loadtxt(f"{name}.txt")
            np.savetxt(f"{name}_us.txt", np.c_[rows[:, 0] * 1e6 + 1e15, rows[:, 1:]], fmt="%.9f")
        columns = "us x y z qx qy qz qw"
        code, said, _ = run(
            capsys, "truth_us.txt", "good_us.txt", "--columns", columns, "--json", "-"
        )
        assert code == 0
        assert json.loads(said)["coverage"]["matched"] == 1200
        for name, expected in (("tum", 0), ("euroc", 2), ("kitti", 2)):
            assert run(capsys, "truth.txt", "good.txt", "--format", name)[0] == expected


class TestTables:
    def test_csv_has_one_line_per_estimate(self, files, capsys):
        code, said, _ = run(capsys, "truth.txt", "bad.txt", "good.txt", "--csv", "-")
        assert code == 0
        rows = list(csv.DictReader(io.StringIO(said)))
        assert [row["estimate"] for row in rows] == ["good.txt", "bad.txt"]
        expected = am.evaluate("truth.txt", "good.txt").ate.rmse
        assert float(rows[0]["ate_rmse_m"]) == expected

    def test_positions_and_poses_share_a_table(self, files, capsys):
        np.savetxt("prism.txt", np.c_[T, drive(0.001, 3).positions], fmt="%.9f")
        code, said, error = run(capsys, "truth.txt", "good.txt", "prism.txt")
        assert (code, error) == (0, "")
        assert len({len(line) for line in said.splitlines()[1:4]}) == 1
        for kind in ("--csv", "--latex", "--html"):
            code, said, _ = run(capsys, "truth.txt", "good.txt", "prism.txt", kind, "-")
            assert code == 0
            assert "rpe" in said

    def test_latex_has_balanced_rows(self, files, capsys):
        code, said, _ = run(capsys, "truth.txt", "bad.txt", "good.txt", "--latex", "-")
        assert code == 0
        lines = said.splitlines()
        assert re.fullmatch(r"\\begin\{tabular\}\{lr+\}", lines[0])
        assert lines[-1] == "\\end{tabular}"
        (separators,) = {line.count(" & ") for line in lines if "&" in line}
        assert separators == len(re.search(r"l(r+)", lines[0])[1])
        assert "rpe 1frames rmse m" in said

    def test_one_failure_of_several_is_in_the_table_and_in_the_exit_code(self, files, capsys):
        (files / "empty.txt").write_text("", encoding="utf-8")
        code, said, error = run(capsys, "truth.txt", "good.txt", "empty.txt", "--csv", "-")
        assert code == 2
        assert [row["estimate"] for row in csv.DictReader(io.StringIO(said))] == [
            "good.txt",
            "empty.txt",
        ]
        assert "empty.txt" in error
        assert "has no data" in error


class Page(html.parser.HTMLParser):
    """What a page refers to, and the tags that were not closed."""

    def __init__(self, text):
        super().__init__()
        self.links, self.alts, self.open = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.links += [values[name] for name in ("src", "href") if name in values]
        if tag == "img":
            self.alts.append(values.get("alt", ""))
        if tag not in ("meta", "img"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


class TestPage:
    def test_is_one_file_that_works_offline(self, files, capsys):
        code, _, _ = run(capsys, "truth.txt", "good.txt", "--html", "report.html")
        assert code == 0
        text = (files / "report.html").read_text(encoding="utf-8")
        page = Page(text)
        assert page.open == []
        assert len(page.alts) == 5
        assert all(len(alt.split()) > 8 for alt in page.alts)
        assert all(link.startswith("data:image/png;base64,") for link in page.links)
        assert "prefers-color-scheme: dark" in text
        assert "@media print" in text
        report = am.evaluate("truth.txt", "good.txt")
        for name, value in report._rows():
            assert name in text
            assert value.split(",")[0] in text

    def test_of_several_has_a_table_and_all_figures(self, files, capsys):
        (files / "empty.txt").write_text("", encoding="utf-8")
        names = ("bad.txt", "good.txt", "empty.txt")
        code, _, _ = run(capsys, "truth.txt", *names, "--html", "r.html")
        assert code == 2
        text = (files / "r.html").read_text(encoding="utf-8")
        assert len(Page(text).alts) == 10
        assert text.index("good.txt against") < text.index("bad.txt against")
        assert "Failed:" in text

    def test_of_many_draws_the_best(self, files, capsys, monkeypatch):
        monkeypatch.setattr("amrmetrics.report_page.DRAWN", 1)
        assert run(capsys, "truth.txt", "bad.txt", "good.txt", "--html", "r.html")[0] == 0
        text = (files / "r.html").read_text(encoding="utf-8")
        assert len(Page(text).alts) == 5
        assert "Figures are shown of the 1 best" in text
        assert text.index("<img") < text.index("<h2>bad.txt against")

    def test_names_are_escaped(self, tmp_path, capsys, monkeypatch):
        monkeypatch.chdir(tmp_path)
        am.write_tum("truth.txt", drive())
        name = "a<b>&'c.txt" if os.name != "nt" else "a&'c.txt"
        am.write_tum(name, drive(0.02, 1))
        assert run(capsys, "truth.txt", name, "--html", "r.html")[0] == 0
        text = (tmp_path / "r.html").read_text(encoding="utf-8")
        assert "<b>" not in text
        assert Page(text).open == []

    def test_numbers_are_the_same_without_stamps(self, files, capsys):
        am.write_kitti("a", drive())
        am.write_kitti("b", drive(0.02, 1))
        assert run(capsys, "a", "b", "--html", "r.html")[0] == 0
        assert len(Page((files / "r.html").read_text(encoding="utf-8")).alts) == 4


class TestErrors:
    @pytest.mark.parametrize(
        ("arguments", "says"),
        [
            (["none.txt", "good.txt"], "No such file"),
            (["truth.txt", "good.txt", "--offset", "soon"], "--offset is 'soon'"),
            (["truth.txt", "good.txt", "--unit", "m"], "--unit was given without --delta"),
            (["truth.txt", "good.txt", "--delta", "1", "--unit", "km"], "unit is 'km'"),
            (["truth.txt", "good.txt", "--body", "1 2"], "--body is '1 2'"),
            (["truth.txt", "good.txt", "--skip", "0"], "--skip is 0"),
            (["truth.txt", "good.txt", "--from", "1e9"], "no stamp lies between"),
            (["truth.txt", "run.bag"], "say which topic, such as run.bag:/odom"),
            (["truth.txt", "good.txt", "--times", "truth.txt"], "times were given, but"),
            (["truth.txt", "good.txt", "--html", "no/such/folder/r.html"], "No such file"),
            (["truth.txt", "good.txt", "--align", "rigid", "--first", "1"], "single position"),
        ],
    )
    def test_are_one_line_and_exit_code_2(self, files, capsys, arguments, says):
        code, _, error = run(capsys, *arguments)
        assert code == 2
        assert says in error
        assert error.startswith("amrmetrics: ")
        assert error.count("\n") == 1

    def test_advice_is_in_words_of_the_command(self, files, capsys):
        still = am.Trajectory(T, np.zeros((len(T), 3)))
        am.write_tum(
            "still.txt", am.Trajectory(T, am.spatial_poses(still.poses, [[0, 0, 0, 1]] * len(T)))
        )
        _, _, error = run(capsys, "still.txt", "good.txt")
        assert "or --align 'none'" in error
        assert run(capsys, "still.txt", "good.txt", "--align", "none")[0] == 0
        am.write_tum("late.txt", T[:-1] + 0.05, drive().poses[:-1])
        _, _, error = run(capsys, "truth.txt", "late.txt")
        advice = re.search(r"(--max-difference) ([\d.]+) or more", error)
        assert run(capsys, "truth.txt", "late.txt", *advice.groups())[0] == 0

    def test_advice_for_columns_that_the_numbers_do_not_tell(self, files, capsys):
        """A EuRoC file whose first orientation is nearly the identity with the scalar last."""
        T0 = 1403636580000000000
        turn = 0.05 * np.sin(T / 3)
        rows = zip((T * 1e9).round().astype(int), drive().positions, turn, strict=True)
        lines = [
            f"{T0 + t},{x},{y},{z},{s / 2},0.01,0,{(1 - s * s / 4 - 1e-4) ** 0.5}\n"
            for t, (x, y, z), s in rows
        ]
        with open("run.csv", "w", encoding="utf-8") as file:
            file.writelines(lines)
        code, _, error = run(capsys, "run.csv", "run.csv")
        assert code == 2
        assert "amrmetrics.read" not in error
        said = re.findall(r'--columns "([^"]*)"', error)
        assert said == ["run.csv=ns x y z qx qy qz qw", "run.csv=ns x y z qw qx qy qz"]
        am.write_tum("truth_1970.txt", T0 / 1e9 + T, drive().poses)  # needs no columns
        both = ("truth_1970.txt", "run.csv", "--json", "-")
        code, out, _ = run(capsys, *both, "--columns", said[0])
        assert code == 0
        assert json.loads(out)["coverage"]["matched"] == len(T)
        assert json.loads(out)["ate"]["rmse"] < 1e-4
        # What is said of one file goes before what is said of all.
        more = ("--columns", "s x y z", "--columns", said[0])
        found = json.loads(run(capsys, *both, *more)[1])
        assert found["ate"]["rmse"] < 1e-4
        assert found["rpe"] == []
        code, _, error = run(capsys, *both, "--columns", "other.csv=ns x y z")
        assert code == 2
        assert "--columns is given for other.csv, which is not one of the files" in error

    def test_advice_for_files_of_different_length_without_stamps(self, files, capsys):
        am.write_kitti("long.kitti", drive())
        am.write_kitti("short.kitti", drive(0.02, 1)[:900])
        _, _, error = run(capsys, "long.kitti", "short.kitti")
        n = int(re.search(r"early, leave the first (\d+) poses in the longer file\.", error)[1])
        text = (files / "long.kitti").read_text(encoding="utf-8").splitlines(keepends=True)
        (files / "cut.kitti").write_text("".join(text[:n]), encoding="utf-8")
        code, out, _ = run(capsys, "cut.kitti", "short.kitti", "--json", "-")
        assert code == 0
        assert json.loads(out)["ate"]["rmse"] < 0.05

    def test_no_clock_offset_in_words_of_the_command(self, files, capsys):
        np.savetxt("prism.txt", np.c_[T, drive().positions], fmt="%.9f")
        still = am.spatial_poses(drive().positions, [[0, 0, 0, 1]] * len(T))
        am.write_tum("still.txt", T, still)
        for name, says in (("prism", "has no orientations"), ("still", "does not vary")):
            for pair, who in (
                ((f"{name}.txt", "good.txt"), "the reference"),
                (("good.txt", f"{name}.txt"), "the estimate"),
            ):
                code, _, error = run(capsys, *pair, "--offset", "auto")
                assert code == 2
                assert "no clock offset could be estimated" in error
                assert re.search(rf"{who} {says}", error), error

    def test_advice_for_a_clock_of_its_own(self, files, capsys):
        rng = np.random.default_rng(0)
        yaw = np.cumsum(np.cumsum(rng.normal(size=len(T)))) * 1e-4
        X = am.planar_poses(np.c_[2 * T, np.sin(T)], yaw)
        am.write_tum("a.txt", 1.5e9 + T, X)
        am.write_tum("b.txt", T, X)
        _, _, error = run(capsys, "a.txt", "b.txt")
        advice = re.search(
            r"try (--offset) (\S+) if .* \((--offset) (auto) estimates it from", error
        )
        for option, value in (advice.groups()[:2], advice.groups()[2:]):
            code, out, _ = run(capsys, "a.txt", "b.txt", option, value, "--json", "-")
            assert code == 0
            assert json.loads(out)["ate"]["rmse"] < 1e-3

    def test_advice_for_frames_that_were_left_out(self, files, capsys):
        am.write_kitti("truth.kitti", drive())
        am.write_kitti("run.kitti", drive(0.02, 1)[::3])
        np.savetxt("times.txt", T)
        _, _, error = run(capsys, "truth.kitti", "run.kitti")
        assert "write their numbers before the poses" in error
        assert "times.txt for both: --times." in error
        rows = np.c_[np.arange(len(T))[::3], np.loadtxt("run.kitti")]
        np.savetxt("numbered.kitti", rows, fmt="%d" + 12 * " %.9f")
        arguments = ("truth.kitti", "numbered.kitti", "--times", "times.txt", "--json", "-")
        code, said, _ = run(capsys, *arguments)
        assert code == 0
        assert json.loads(said)["coverage"]["matched"] == 400
        assert json.loads(said)["ate"]["rmse"] < 0.05

    def test_what_would_not_be_used_is_refused(self, files, capsys):
        for more, says in (
            (["--format", "tum", "--columns", "s x y z"], "leave out --format"),
            (["--format", "tum", "--times", "times.txt"], "--times are the stamps of KITTI files"),
            (["--format", "euroc", "--times", "times.txt"], "and --format is euroc"),
        ):
            code, _, error = run(capsys, "truth.txt", "good.txt", *more)
            assert code == 2
            assert says in error

    def test_a_drive_is_no_bag(self, files, capsys):
        _, _, error = run(capsys, "truth.txt", "C:/data/run.txt")
        assert "'C:/data/run.txt'" in error
        _, _, error = run(capsys, "truth.txt", "C:/data/run.bag:/odom")
        assert "run.bag'" in error
        am.write_tum("12:30.txt", drive(0.02, 1))
        assert run(capsys, "truth.txt", "12:30.txt")[0] == 0

    def test_one_output_goes_to_the_terminal(self, files, capsys):
        code, said, error = run(capsys, "truth.txt", "good.txt", "--json", "-", "--csv", "-")
        assert (code, said) == (2, "")
        assert "only one of" in error

    def test_interrupted(self, files, capsys, monkeypatch):
        def interrupt(options):
            raise KeyboardInterrupt

        monkeypatch.setattr("amrmetrics.command._run", interrupt)
        assert run(capsys, "truth.txt", "good.txt") == (2, "", "amrmetrics: interrupted\n")

    @pytest.mark.skipif(os.name == "nt", reason="pipes are closed otherwise there")
    def test_a_closed_pipe_is_no_error(self, files):
        names = ["good.txt", "bad.txt"] * 200
        command = [sys.executable, "-m", "amrmetrics", "truth.txt", *names[:6], "--json", "-"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as job:
            job.stdout.close()
            assert job.stderr.read() == b""
            assert job.wait() == 0

    @pytest.mark.skipif(sys.platform != "linux", reason="names are text elsewhere")
    def test_names_that_are_no_text(self, files, capsys):
        name = os.fsdecode(b"bad\xff.txt")
        os.rename("good.txt", name)
        command = [sys.executable, "-m", "amrmetrics", "truth.txt", name, "--csv", "t.csv"]
        done = subprocess.run(command, capture_output=True, env=os.environ | {"LC_ALL": "C"})
        assert (done.returncode, done.stderr) == (0, b"")
        assert done.stdout.startswith(b"bad")
        assert "bad\\udcff.txt" in (files / "t.csv").read_text(encoding="utf-8")

    def test_usage(self, capsys):
        cases = ((["--help"], 0), (["--version"], 0), ([], 2), (["a", "b", "--x"], 2))
        for arguments, code in cases:
            with pytest.raises(SystemExit) as caught:
                main(arguments)
            assert caught.value.code == code
        assert f"amrmetrics {am.__version__}" in capsys.readouterr().out

    def test_help_shows_commands_that_parse(self):
        from amrmetrics.command import EXAMPLES, _parser

        commands = re.findall(r"^  amrmetrics (.*?)(?:   .*)?$", EXAMPLES, re.M)
        assert len(commands) == 8
        for command in commands:
            _parser().parse_args(command.split())


def test_runs_as_a_module_and_imports_nothing_slow(files):
    command = [sys.executable, "-X", "importtime", "-m", "amrmetrics", "truth.txt", "good.txt"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=files)
    assert done.returncode == 0
    assert done.stdout.startswith("good.txt against truth.txt")
    loaded = {line.split("|")[-1].strip() for line in done.stderr.splitlines() if "|" in line}
    assert not loaded & {"matplotlib", "sympy", "pandas", "scipy.stats", "rosbags"}
