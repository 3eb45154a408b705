"""Files come back to the last digit, repairs are said aloud, other formats are told apart."""

import gzip
import json
import re
import sys
import tracemalloc
import warnings
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from evo.core import metrics, trajectory
from evo.tools import file_interface
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

import amrmetrics as am
from amrmetrics import _text

TUM = "0.5 1 2 3 0 0 0 1\n"
EUROC = "1403636580838555648,4.5,-1.7,0.7,1,0,0,0,0.1,0.2,0.3\n"
KITTI = "1 0 0 5 0 1 0 6 0 0 1 7\n"


def random_poses(rng, n):
    return am.spatial_poses(rng.normal(size=(n, 3)), Rotation.random(n, rng=rng).as_quat())


def write(path, text):
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def drive(n=40, start=1305031100.0, rate=30):
    """Return stamps, positions and quaternions of a curved path in space."""
    k = np.arange(n)
    xyz = np.c_[3 * np.cos(k / 9), 2 * np.sin(k / 7), 1 + k / 50]
    q = Rotation.from_euler("zyx", np.c_[0.5 + k / 8, 0.3 + k / 40, 0 * k + 0.4]).as_quat()
    return start + k / rate, xyz, q


def tum(n=40, **options):
    t, xyz, q = drive(n, **options)
    return [" ".join(f"{x:.9f}" for x in row) + "\n" for row in np.c_[t, xyz, q]]


def warned(reader, path, **options):
    """Return what a reader returns, and its one warning."""
    with pytest.warns(am.RecordingWarning) as caught:
        found = reader(path, **options)
    assert len(caught) == 1
    assert str(caught[0].message).startswith(f"{path}: ")
    assert caught[0].filename == __file__
    return found, str(caught[0].message)


@pytest.fixture(params=["pandas", "numpy", "line by line"])
def way(request, monkeypatch):
    """Read in each of the three ways that a table may be read."""
    if request.param == "pandas":
        monkeypatch.setattr(_text, "LARGE", -1)
    if request.param == "numpy":
        monkeypatch.setitem(sys.modules, "pandas", None)
        monkeypatch.setattr(_text, "LARGE", -1)
    if request.param == "line by line":
        monkeypatch.setattr(_text, "_read_at_once", lambda data, start: None)
    return request.param


class TestRoundTrip:
    @pytest.mark.parametrize("name", ["run.txt", "run.txt.gz"])
    def test_tum(self, rng, tmp_path, name):
        X, stamps = random_poses(rng, 100), 1.3e9 + np.cumsum(rng.uniform(1e-3, 1, 100))
        am.write_tum(tmp_path / name, stamps, X)
        back = am.read_tum(str(tmp_path / name))
        assert np.array_equal(back.stamps, stamps)
        assert np.array_equal(am.positions(back.poses), am.positions(X))
        assert np.abs(back.poses - X).max() < 4e-15
        assert (tmp_path / name).read_bytes()[:2] == (b"\x1f\x8b" if name[-1] == "z" else b"13")

    @pytest.mark.parametrize("name", ["run.txt", "run.txt.gz"])
    def test_kitti(self, rng, tmp_path, name):
        X = random_poses(rng, 100)
        am.write_kitti(tmp_path / name, X)
        back = am.read_kitti(tmp_path / name)
        assert back.stamps is None
        assert np.array_equal(back.poses, X)

    @settings(max_examples=50)
    @given(arrays(float, (3, 3), elements=st.floats(-1e90, 1e90)), st.floats(-1e9, 1e9))
    def test_every_number_to_the_last_digit(self, tmp_path_factory, xyz, start):
        path = tmp_path_factory.mktemp("run") / "run.txt"
        stamps = start + np.array([0, 1e-3, 2.5])
        am.write_tum(path, stamps, am.spatial_poses(xyz, [[0, 0, 0, 1]] * 3))
        back = am.read_tum(path)
        assert np.array_equal(back.stamps, stamps)
        assert np.array_equal(back.poses[:, :3, 3], xyz)

    def test_one_pose_lists_and_inputs_unchanged(self, tmp_path):
        X = np.eye(4)[None]
        X.flags.writeable = False
        am.write_tum(tmp_path / "a", [0], X)
        am.write_kitti(tmp_path / "b", X.tolist())
        assert np.array_equal(am.read_tum(tmp_path / "a").poses, X)
        assert np.array_equal(am.read_kitti(tmp_path / "b").poses, X)

    def test_lines_end_the_same_on_every_system(self, tmp_path):
        am.write_kitti(tmp_path / "a", np.eye(4)[None])
        assert (tmp_path / "a").read_bytes() == (
            b"1.0 0.0 0.0 0.0 0.0 1.0 0.0 0.0 0.0 0.0 1.0 0.0\n"
        )


class TestAgreesWithEvo:
    def error(self, X, Y, mode):
        aligned = trajectory.PosePath3D(poses_se3=list(Y.poses_se3))
        if mode != "none":
            aligned.align(X, correct_scale=mode == "similarity")
        metric = metrics.APE(metrics.PoseRelation.translation_part)
        metric.process_data((X, aligned))
        return metric.get_all_statistics()["rmse"]

    def pair(self, rng):
        X, stamps = random_poses(rng, 50), 1.3e9 + np.arange(50) / 30
        Y = random_poses(rng, 1) @ X
        Y[:, :3, 3] += 0.05 * rng.normal(size=(50, 3))
        return stamps, X, Y

    def assert_same_ate(self, ours, theirs):
        for mode in ("none", "rigid", "similarity"):
            expected = self.error(*theirs, mode)
            assert am.ate(*(x.poses for x in ours), mode).rmse == pytest.approx(expected, rel=1e-9)

    @pytest.mark.parametrize("kind", ["tum", "kitti"])
    def test_on_files_that_we_write(self, rng, tmp_path, kind):
        stamps, *pair = self.pair(rng)
        paths = [tmp_path / "reference", tmp_path / "estimate"]
        for path, X in zip(paths, pair, strict=True):
            if kind == "tum":
                am.write_tum(path, stamps, X)
            else:
                am.write_kitti(path, X)
        read = {
            "tum": (am.read_tum, file_interface.read_tum_trajectory_file),
            "kitti": (am.read_kitti, file_interface.read_kitti_poses_file),
        }[kind]
        ours, theirs = ([reader(path) for path in paths] for reader in read)
        assert np.allclose(ours[1].poses, theirs[1].poses_se3, atol=1e-14)
        self.assert_same_ate(ours, theirs)

    @pytest.mark.parametrize("kind", ["tum", "kitti"])
    def test_on_files_that_evo_writes(self, rng, tmp_path, kind):
        stamps, *pair = self.pair(rng)
        paths = [tmp_path / "reference", tmp_path / "estimate"]
        for path, X in zip(paths, pair, strict=True):
            if kind == "tum":
                run = trajectory.PoseTrajectory3D(poses_se3=list(X), timestamps=stamps)
                file_interface.write_tum_trajectory_file(path, run)
            else:
                run = trajectory.PosePath3D(poses_se3=list(X))
                file_interface.write_kitti_poses_file(path, run)
        ours = [(am.read_tum if kind == "tum" else am.read_kitti)(path) for path in paths]
        assert np.allclose(ours[0].poses, pair[0], atol=1e-14)
        if kind == "tum":
            assert np.array_equal(ours[0].stamps, stamps)
        self.assert_same_ate(ours, [trajectory.PosePath3D(poses_se3=list(X)) for X in pair])

    def test_on_euroc(self, rng, tmp_path):
        lines = ["#timestamp, p_RS_R_x [m], ...\n"]
        ticks = 1403636580838555648 + 5_000_000 * np.arange(20)
        for tick, q in zip(ticks, Rotation.random(20, rng=rng).as_quat(), strict=True):
            row = [*rng.normal(size=3), q[3], *q[:3], *rng.normal(size=9)]
            lines.append(",".join([str(tick), *(repr(float(x)) for x in row)]) + "\r\n")
        path = write(tmp_path / "data.csv", "".join(lines))
        ours, theirs = am.read_euroc(path), file_interface.read_euroc_csv_trajectory(path)
        assert np.array_equal(ours.stamps, theirs.timestamps)
        assert np.allclose(ours.poses, theirs.poses_se3, atol=1e-14)


@pytest.mark.parametrize(
    "text",
    [
        TUM,
        TUM.rstrip(),
        "\ufeff" + TUM,
        "# a comment\n\n  # another\n" + TUM + "   \n\t\n",
        TUM.replace(" ", ","),
        TUM.replace(" ", ", "),
        TUM.replace(" ", "\t"),
        TUM.replace("\n", "\r\n"),
        "  " + TUM.rstrip() + "   # comment\n",
        "5e-1 1.0 +2 3. 0 0 -0.0 1.0005\n",
        gzip.compress(TUM.encode(), mtime=0),
    ],
)
def test_reads_what_people_write(tmp_path, text, way):
    name = "run.txt.gz" if isinstance(text, bytes) else "run.txt"
    found = am.read_tum(write(tmp_path / name, text))
    assert found.stamps.tolist() == [0.5]
    assert np.allclose(found.poses[0], [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])


def test_four_digits_as_in_the_tum_benchmark(tmp_path):
    text = "1305031098.6659 1.3563 0.6305 1.6380 0.6132 0.5962 -0.3311 -0.3986\n"
    X = am.read_tum(write(tmp_path / "run.txt", text)).poses
    assert np.allclose(X[0, :3, :3] @ X[0, :3, :3].T, np.eye(3), atol=1e-15)


def test_seven_digits_as_in_kitti(tmp_path):
    text = (
        "9.999978e-01 5.272628e-04 -2.066935e-03 -4.690294e-02 -5.296506e-04 9.999992e-01 "
        "-1.154865e-03 -2.839928e-02 2.066324e-03 1.155958e-03 9.999971e-01 8.586941e-01\n"
    )
    X = am.read_kitti(write(tmp_path / "00.txt", text)).poses
    assert X[0, 2, 3] == 8.586941e-01
    assert am.rpe(np.r_[X, X], np.r_[X, X]).rotation.max == 0


def test_nanoseconds_are_divided_not_multiplied(tmp_path):
    found = am.read_euroc(write(tmp_path / "data.csv", EUROC))
    assert found.stamps[0] == 1403636580838555648 / 1e9
    assert am.positions(found.poses).tolist() == [[4.5, -1.7, 0.7]]


class TestRepairs:
    """What one sensible repair mends is mended, counted and said with its first line."""

    def repaired(self, tmp_path, lines, said, reader=am.read_tum, **options):
        path = write(tmp_path / "run.txt", "".join(lines))
        found, message = warned(reader, path, **options)
        assert re.fullmatch(rf"{re.escape(str(path))}: {said}\.", message)
        assert found.repairs == tuple(message.removeprefix(f"{path}: ")[:-1].split("; "))
        with pytest.raises(am.AmrError, match="Without strict=True it is read all the same") as no:
            reader(path, strict=True, **options)
        assert str(no.value).startswith(f"{path}: {found.repairs[0]}. ")
        return found

    def test_lines_in_falling_order(self, tmp_path):
        said = "stamps in falling order, turned round, line 1"
        found = self.repaired(tmp_path, tum()[::-1], said)
        assert np.abs(found.positions - drive()[1]).max() < 1e-8
        self.repaired(tmp_path, tum(11)[::-1], said)
        with pytest.raises(am.AmrError, match="several runs in one file"):
            am.read_tum(write(tmp_path / "run.txt", "".join(tum(10)[::-1])))

    @pytest.mark.parametrize("rest", [" 0 0 0 0 0 0 1\n", " 0 0 0\n"])
    def test_frames_that_were_lost_and_written_as_the_origin(self, tmp_path, rest):
        lines = tum() if len(rest) > 9 else [" ".join(x.split()[:4]) + "\n" for x in tum()]
        for k in (0, 1, 7, 8, 20):  # many begin at the origin
            lines[k] = lines[k].split()[0] + rest
        said = "3 poses exactly at the origin after it was left, as of frames that were lost; kept"
        path = write(tmp_path / "run.txt", "".join(lines))
        found, message = warned(am.read_tum, path)
        assert f"{said}, first in line 8" in message
        assert len(found) == 40
        turned = lines[:7] + [lines[7].replace(rest, " 0 0 0 0 0 1 0\n")] + tum()[8:]
        if len(rest) > 9:
            assert am.read_tum(write(path, "".join(turned))).repairs == ()

    @pytest.mark.parametrize(("north", "step"), [(4_949_000.0, 10), (123_456.0, 1)])
    def test_coordinates_that_lost_digits(self, tmp_path, north, step):
        t, xyz, q = drive()
        rows = np.c_[t, 30 * xyz + [0, north, 0], q]
        form = ["%.9f", "%.6g", "%.6g", "%.6g", *4 * ["%.9f"]]
        lines = [" ".join(f % x for f, x in zip(form, row, strict=True)) + "\n" for row in rows]
        self.repaired(tmp_path, lines, f"coordinates of six digits, in steps of {step} m, line 1")
        form[1:4] = 3 * ["%.8g"]
        lines = [" ".join(f % x for f, x in zip(form, row, strict=True)) + "\n" for row in rows]
        assert am.read_tum(write(tmp_path / "run.txt", "".join(lines))).repairs == ()
        rows[:, 2] = north  # a constant says nothing
        lines = [" ".join(f"{x:.9f}" for x in row) + "\n" for row in rows]
        assert am.read_tum(write(tmp_path / "run.txt", "".join(lines))).repairs == ()

    def test_columns_of_words(self, tmp_path):
        """As rostopic echo -p and ros2 topic echo --csv write them."""
        t, xyz, q = drive()
        names = "%time,field.header.seq,field.header.stamp,field.header.frame_id,"
        pose = "field.pose.pose.position.x,field.pose.pose.position.y,field.pose.pose.position.z"
        turn = ",".join(f"field.pose.pose.orientation.{x}" for x in "xyzw")
        ns = (t * 1e9).round().astype(int)
        numbers = [",".join(f"{x:.9f}" for x in row) for row in np.c_[xyz, q]]
        lines = [
            f"{s},{k},{s},odom,{x}\n" for k, (s, x) in enumerate(zip(ns, numbers, strict=True))
        ]
        said = "columns without numbers, such as odom in column 4, left out, line 2"
        header = f"{names}{pose},{turn}\n"
        found = self.repaired(tmp_path, [header, *lines], said, am.read)
        assert np.abs(found.stamps - t).max() < 1e-6
        assert np.abs(found.poses - am.spatial_poses(xyz, q)).max() < 1e-8
        split = [
            f"{s // 10**9},{s % 10**9},odom,base,{x}\n" for s, x in zip(ns, numbers, strict=True)
        ]
        said = "columns without numbers, such as odom in column 3, left out, line 1"
        found = self.repaired(tmp_path, split, said, am.read)
        assert np.abs(found.poses - am.spatial_poses(xyz, q)).max() < 1e-8

    def test_a_column_of_words_does_not_move_what_is_said_of_others(self, tmp_path):
        lines = [f"{2**60 + k},odom,{k % 3},2,3,1,0,0,0\n" for k in range(40)]
        path = write(tmp_path / "run.csv", "".join(lines))
        with pytest.raises(am.AmrError, match=rf"the stamps {2**60} and {2**60 + 1} differ"):
            am.read(path, columns="ns x y z qw qx qy qz")
        split = [f"odom,{line}" for line in lines]
        with pytest.raises(am.AmrError, match="has no data"):
            am.read(write(tmp_path / "run.csv", "".join(split)))

    def test_a_word_among_numbers_is_a_bad_line(self, tmp_path):
        lines = [line.replace(" ", ",") for line in tum()]
        lines[5] = lines[5].replace(lines[5].split(",")[2], "lost")
        said = r"1 lines left out \(lost in column 3 is no number\), first in line 6"
        assert len(self.repaired(tmp_path, lines, said)) == 39

    def test_nothing_to_repair_nothing_said(self, tmp_path, way):
        path = write(tmp_path / "run.txt", "".join(tum()))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = am.read_tum(path, strict=True)
        t, xyz, q = drive()
        assert found.repairs == ()
        assert np.abs(found.stamps - t).max() < 1e-6
        assert np.abs(found.poses - am.spatial_poses(xyz, q)).max() < 1e-8

    def test_a_stamp_written_twice(self, tmp_path, way):
        lines = ["# head\n", *tum()]
        lines[9:9] = [lines[8].replace(lines[8].split()[1], "99.0")]
        lines.append(lines[-1])
        said = "2 stamps that were there already, left out, first in line 10"
        found = self.repaired(tmp_path, lines, said)
        assert np.abs(found.positions - drive()[1]).max() < 1e-8

    @pytest.mark.parametrize(("start", "end"), [(4, 20), (20, 4), (0, 39), (39, 0)])
    def test_stamps_out_of_order(self, tmp_path, start, end, way):
        lines = tum()
        lines.insert(end, lines.pop(start))
        said = f"1 stamps out of order, sorted, first in line {end + 1}"
        found = self.repaired(tmp_path, lines, said)
        assert np.abs(found.positions - drive()[1]).max() < 1e-8
        assert (np.diff(found.stamps) > 0).all()

    @pytest.mark.parametrize(
        "row", ["nan", "NaN", "-inf", "1e999", "x", "2_0", "2j", "２", "1.2.3", '"5"']
    )
    def test_a_row_without_numbers(self, tmp_path, row, way):
        lines = tum()
        words = lines[6].split()
        lines[6] = " ".join([*words[:2], row, *words[3:]]) + "\n"
        what = "is too large" if row == "1e999" else "is no number"
        said = rf"1 lines left out \({re.escape(row)} in column 3 {what}\), first in line 7"
        found = self.repaired(tmp_path, lines, said)
        assert len(found) == 39
        assert np.abs(found.positions - np.delete(drive()[1], 6, axis=0)).max() < 1e-8

    @pytest.mark.parametrize("n", [1, 7, 9, 16])
    def test_a_line_of_another_length(self, tmp_path, n, way):
        lines = tum()
        lines[-1] = " ".join((lines[-1].split() * 2)[:n]) + "\n"
        said = rf"1 lines left out \({n} columns, not 8\), first in line 40"
        assert len(self.repaired(tmp_path, lines, said)) == 39

    def test_an_empty_entry_is_no_separator(self, tmp_path, way):
        lines = [line.replace(" ", ",") for line in tum()]
        lines[3] = lines[3].replace(",", ",,", 1)
        said = r"1 lines left out \(nothing in column 2 is no number\), first in line 4"
        assert len(self.repaired(tmp_path, lines, said)) == 39

    def test_first_row_nan(self, tmp_path, way):
        lines = tum()
        lines[0] = lines[0].replace(lines[0].split()[0], "nan")
        said = r"1 lines left out \(nan in column 1 is no number\), first in line 1"
        assert len(self.repaired(tmp_path, lines, said)) == 39

    @pytest.mark.parametrize(
        ("length", "silent"), [(1.0009, True), (1.0011, False), (0.9901, False)]
    )
    def test_quaternions_nearly_of_unit_length(self, tmp_path, length, silent):
        lines = tum()
        for k in (8, 30):
            words = lines[k].split()
            words[4:] = (repr(length * float(word)) for word in words[4:])
            lines[k] = " ".join(words) + "\n"
        if silent:
            found = am.read_tum(write(tmp_path / "run.txt", "".join(lines)), strict=True)
        else:
            off = f"{abs(length - 1):.2g}"
            said = f"2 quaternions off unit length by up to {off}, normalized, first in line 9"
            found = self.repaired(tmp_path, lines, said)
        assert np.abs(found.poses - am.spatial_poses(*drive()[1:])).max() < 1e-8

    def test_a_header_line(self, tmp_path, way):
        lines = ["stamp,tx,ty,tz,qx,qy,qz,qw\n", *(x.replace(" ", ",") for x in tum())]
        assert len(self.repaired(tmp_path, lines, "header line without #, line 1")) == 40

    def test_semicolons(self, tmp_path, way):
        lines = [line.replace(" ", ";") for line in tum()]
        assert len(self.repaired(tmp_path, lines, "semicolons between the numbers, line 1")) == 40

    def test_a_letter_in_latin_1(self, tmp_path, way):
        path = write(tmp_path / "run.txt", b"# a\n# M\xfcnchen \x85\n" + "".join(tum()).encode())
        found, said = warned(am.read_tum, path)
        assert said == f"{path}: letters that are not UTF-8, read as Latin-1, line 2."
        assert len(found) == 40
        path.write_bytes(path.read_bytes() + b"1 2\n")
        assert warned(am.read_tum, path)[1].endswith("8), first in line 43.")

    def test_one_warning_for_everything(self, tmp_path):
        lines = ["t x y z qx qy qz qw\n", *(line.replace(" ", ";") for line in tum())]
        lines[5] = lines[6] = "nan" + lines[5][20:]
        lines.insert(30, lines[29])
        said = "header line without #, line 1; semicolons between the numbers, line 2; "
        said += r"2 lines left out \(nan in column 1 is no number\), first in line 6; "
        said += "1 stamps that were there already, left out, first in line 31"
        assert len(self.repaired(tmp_path, lines, said)) == 38

    @pytest.mark.parametrize("decimals", [3, 4])
    def test_rounded_matrices(self, tmp_path, decimals):
        X = am.spatial_poses(*drive()[1:])
        table = X[:, :3].reshape(-1, 12)
        lines = [" ".join(f"{x:.{decimals}f}" for x in row) + "\n" for row in table]
        said = r"\d+ rotation matrices rounded in the file \(off by up to 0.0+1\), repaired, "
        found = self.repaired(tmp_path, lines, said + r"first in line \d", am.read_kitti)
        assert np.abs(found.poses - X).max() < 10**-decimals
        R = found.poses[:, :3, :3]
        assert np.abs(R.swapaxes(1, 2) @ R - np.eye(3)).max() < 1e-14

    @pytest.mark.parametrize(("off", "silent"), [(0.9e-5, True), (1.1e-5, False), (1.9e-3, False)])
    def test_rounded_matrices_at_the_edge(self, tmp_path, off, silent):
        line = f"{(1 + off) ** 0.5!r} 0 0 5 0 1 0 6 0 0 1 7\n"
        path = write(tmp_path / "00.txt", KITTI * 5 + line)
        if silent:
            am.read_kitti(path, strict=True)
        else:
            found, said = warned(am.read_kitti, path)
            assert said.endswith("repaired, first in line 6.")
            assert np.abs(found.poses[5, :3, :3] - np.eye(3)).max() < 1e-15

    def test_repairs_of_a_file_of_times_are_said(self, tmp_path):
        times = write(tmp_path / "times.txt", "seconds\n0.0\n0.1\n")
        path = write(tmp_path / "00.txt", KITTI * 2)
        found, said = warned(am.read_kitti, path, times=times)
        assert said == f"{path}: {times}: header line without #, line 1."
        assert found.stamps.tolist() == [0, 0.1]

    @pytest.mark.parametrize(("bad", "fine"), [(4, True), (5, False)])
    def test_one_row_in_ten(self, tmp_path, bad, fine, way):
        lines = tum()
        for k in range(3, 3 + bad):
            lines[k] = "1 2 3\n"
        path = write(tmp_path / "run.txt", "".join(lines))
        if fine:
            assert len(warned(am.read_tum, path)[0]) == 36
            return
        with pytest.raises(am.AmrError, match=r"5 of 40 rows\. More than one row in ten") as error:
            am.read_tum(path)
        assert str(error.value).startswith(f"{path}, line 4: lines left out (3 columns, not 8), ")


LONG = "the quaternion has length 1.0101; a rotation needs 1, and within 0.01 it would be repaired"
SIX = [re.sub(r"^\S+", lambda word: f"{float(word[0]):g}", line) for line in tum()]
WHOLE = [re.sub(r"^(\d+)\.\d+", r"\1", line) for line in tum()]
CLOSE = [f"{1403636580000000000 + 50 * k} 1 2 3 1 0 0 0\n" for k in range(40)]


REFUSED = {
    "empty": (am.read_tum, "", " has no data: 0 lines"),
    "blank": (am.read_tum, "\n,\n;\n", " has no data: 3 lines, all blank, comments or words"),
    "comments": (am.read_tum, "# a\n\n# b\n", " has no data: 3 lines, all blank, comments"),
    "words": (am.read_tum, "no such file\n", " has no data: 1 lines, all blank, comments or words"),
    "few columns": (
        am.read_tum,
        "1 2 3\n4 5 6\n",
        r": expected .*\(TUM\); this file has 3 columns",
    ),
    "long quaternion": (
        am.read_tum,
        [*tum(), "1305031200 1 2 3 0 0 0 1.0101\n"],
        f", line 41: {LONG}",
    ),
    "one zero quaternion": (
        am.read_tum,
        [*tum(), "1305031200 1 2 3 0 0 0 0\n"],
        ", line 41: the quaternion has length 0; a rotation needs 1",
    ),
    "all long": (
        am.read_tum,
        [re.sub(r"\S+ \S+ \S+ \S+\n", "0 0 0 2\n", line) for line in tum()],
        ": .* 8 columns, the length of columns 5 to 8 is 2, where a quaternion has 1 .line 1: ",
    ),
    "two runs": (
        am.read_tum,
        tum(40) + tum(30),
        r", line 41: the stamp 1305031100.000000000 is before the one of line 40, and 30 lines are "
        "out of order with the rest: these are several runs in one file. Put each into a file of",
    ),
    "six digits": (
        am.read_tum,
        SIX,
        ", line 2: the stamp 1.30503e[+]09 repeats, as in 39 of 40 rows: the stamps lost digits "
        "when the file was written. Write them with 9 decimals",
    ),
    "whole seconds": (
        am.read_tum,
        WHOLE,
        ", line 2: the stamp 1305031100 repeats, as in 38 of 40 rows: they are whole seconds",
    ),
    "beyond doubles": (
        am.read_euroc,
        [line.replace(" ", ",") for line in CLOSE],
        ", line 2: the stamps 1403636580000000000 and 1403636580000000050 differ, but are equal "
        "as doubles, which hold 16 digits. Subtract a whole number of seconds from all",
    ),
    "binary": (am.read_tum, bytes(range(256)), " is not a text file: it holds zero bytes"),
    "utf-16": (am.read_tum, TUM.encode("utf-16"), " is not a text file in UTF-8 but in UTF-16"),
    "decimal commas": (
        am.read_tum,
        "0,5;1;2;3;0;0;0;1\n",
        " has decimal commas. Write its numbers",
    ),
    "euroc two": (
        am.read_euroc,
        [EUROC.replace(",1,0,0,0,", ",2,0,0,0,")],
        ": .* length of columns",
    ),
    "kitti scale": (
        am.read_kitti,
        ["# c\n", KITTI * 5, "2" + KITTI[1:], "3" + KITTI[1:]],
        ", line 7: the matrix is not a pose: its 3x3 block is not a rotation",
    ),
    "kitti all scaled": (
        am.read_kitti,
        "2 0 0 5 0 2 0 6 0 0 2 7\n" * 5,
        ", line 1: the matrix is not a pose: its 3x3 block is not a rotation",
    ),
    "kitti mirror": (
        am.read_kitti,
        [KITTI * 3, "-" + KITTI, KITTI],
        ", line 4: the matrix is a reflection",
    ),
    "kitti off": (
        am.read_kitti,
        [KITTI * 3, f"{1.0021**0.5} 0 0 5 0 1 0 6 0 0 1 7\n"],
        r", line 4: the matrix is not a pose: .*identity by 0.0021",
    ),
    "kitti far": (am.read_kitti, KITTI.replace("5", "1e150"), ": poses holds a coordinate"),
    "frames": (
        am.read_kitti,
        [f"{k} {KITTI}" for k in (*range(20), *range(20))],
        ", line 21: the stamp 0.000000000 is before the one of line 20, and 19 lines are out of",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_file_and_line(tmp_path, case):
    reader, text, message = REFUSED[case]
    text = text if isinstance(text, bytes | str) else "".join(text)
    path = write(tmp_path / "run.txt", text)
    with pytest.raises(am.AmrError, match=f"^{re.escape(str(path))}{message}"):
        reader(path)


class TestSecondRun:
    @pytest.mark.parametrize(("n", "refused"), [(9, False), (10, True)])
    def test_fewer_than_ten_lines_are_misplaced_ones(self, tmp_path, n, refused):
        text = tum(200)
        moved = text[50 : 50 + n]
        path = write(tmp_path / "run.txt", "".join([*text[:50], *text[50 + n :], *moved]))
        if refused:
            with pytest.raises(am.AmrError, match="several runs in one file"):
                am.read_tum(path)
        else:
            found, said = warned(am.read_tum, path)
            assert f"{n} stamps out of order, sorted, first in line {201 - n}" in said
            assert np.abs(found.positions - drive(200)[1]).max() < 1e-8

    def test_a_third_of_a_short_file(self, tmp_path):
        path = write(tmp_path / "run.txt", "".join([*tum(4), *tum(2)]))
        with pytest.raises(am.AmrError, match=r"line 5: .* 2 lines are out of order"):
            am.read_tum(path)

    def test_advice_each_into_a_file_of_its_own(self, tmp_path):
        for lines in (tum(40), tum(30)):
            assert len(am.read_tum(write(tmp_path / "run.txt", "".join(lines)))) == len(lines)


class TestStampsThatLostDigits:
    def test_advice_subtract_whole_seconds(self, tmp_path):
        lines = [line.replace("1403636580", "0", 1).replace(" ", ",") for line in CLOSE]
        path = write(tmp_path / "run.txt", "".join(lines))
        found = am.read(path, columns="ns x y z qw qx qy qz")
        assert np.allclose(np.diff(found.stamps), 50e-9, rtol=1e-6)

    def test_advice_nine_decimals(self, tmp_path):
        lines = [re.sub(r"^\S+", f"{t:.9f}", line) for t, line in zip(drive()[0], SIX, strict=True)]
        found = am.read_tum(write(tmp_path / "run.txt", "".join(lines)), strict=True)
        assert np.abs(found.stamps - drive()[0]).max() < 1e-6

    @pytest.mark.parametrize(("repeats", "lost"), [(4, False), (5, True)])
    def test_a_tenth_of_repeats_is_a_slip(self, tmp_path, repeats, lost):
        seconds = np.r_[np.arange(40 - repeats), np.full(repeats, 39 - repeats)] + 1.3e9
        lines = [f"{int(t)} 1 2 3 0 0 0 1\n" for t in seconds]
        path = write(tmp_path / "run.txt", "".join(lines))
        if lost:
            with pytest.raises(am.AmrError, match="5 of 40 rows: they are whole seconds"):
                am.read_tum(path)
        else:
            assert len(warned(am.read_tum, path)[0]) == 36

    def test_repeats_with_all_digits_lost_none(self, tmp_path):
        lines = [line for line in tum(40) for _ in range(2)]
        with pytest.raises(
            am.AmrError, match=r"left out, 40 of 80 rows.*written with too few digi"
        ):
            am.read_tum(write(tmp_path / "run.txt", "".join(lines)))


ZIPPED = gzip.compress(TUM.encode(), mtime=0)


@pytest.mark.parametrize(
    "data", [ZIPPED[:-6], TUM.encode(), ZIPPED[:12] + b"\xff\xff\xff" + ZIPPED[15:]]
)
def test_refuses_broken_archives(tmp_path, data):
    path = write(tmp_path / "run.txt.gz", data)
    with pytest.raises(am.AmrError, match="is not a whole gzip archive") as caught:
        am.read_tum(path)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize("reader", [am.read, am.read_tum, am.read_kitti, am.read_euroc])
def test_a_missing_file_is_the_systems_error(tmp_path, reader):
    with pytest.raises(FileNotFoundError):
        reader(tmp_path / "none.txt")


T, XYZ, Q = drive()
NS = [str(int(t)) + f"{round(t % 1 * 1e9):09d}" for t in T]
WXYZ = Q[:, [3, 0, 1, 2]]
X = am.spatial_poses(XYZ, Q)
MATRICES = X[:, :3].reshape(-1, 12)


def lines(*columns, join=" ", head=""):
    """Return the text of a table; columns are texts or arrays of numbers."""
    cells = [c if isinstance(c, list) else np.reshape(c, (40, -1)).tolist() for c in columns]
    table = [
        [w for c in row for w in (c if isinstance(c, list) else [c])]
        for row in zip(*cells, strict=True)
    ]
    return head + "".join(
        join.join(w if isinstance(w, str) else f"{w:.12f}" for w in row) + "\n" for row in table
    )


EUROC_HEAD = "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],"
EUROC_HEAD += "q_RS_z [],v_RS_R_x [m s^-1],v_RS_R_y [m s^-1],v_RS_R_z [m s^-1]\n"
OKVIS_HEAD = "timestamp, p_WS_W_x, p_WS_W_y, p_WS_W_z, q_WS_x, q_WS_y, q_WS_z, q_WS_w\n"
ROS_HEAD = (
    "%time,field.header.seq,field.header.stamp,"
    + ",".join(
        f"field.pose.pose.{name}"
        for name in (
            "position.x",
            "position.y",
            "position.z",
            "orientation.x",
            "orientation.y",
            "orientation.z",
            "orientation.w",
        )
    )
    + ",field.twist.twist.linear.x\n"
)
BAG_HEAD = "Time,header.seq,header.stamp.secs,header.stamp.nsecs,pose.position.x,pose.position.y,"
BAG_HEAD += "pose.position.z,pose.orientation.x,pose.orientation.y,pose.orientation.z,"
BAG_HEAD += "pose.orientation.w\n"
BOREAS_HEAD = "GPSTime,easting,northing,altitude,vel_east,vel_north,vel_up,roll,pitch,heading,"
BOREAS_HEAD += "angvel_z,angvel_y,angvel_x\n"
PCD_HEAD = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity roll pitch yaw time\nDATA ascii\n"
SEC, NSEC = [ns[:10] for ns in NS], [str(int(ns[10:])) for ns in NS]
US = [ns[:-3] for ns in NS]
COUNT = [str(k) for k in range(40)]
ONES, ROW4 = np.ones(40), np.tile([0, 0, 0, 1.0], (40, 1))

# Text, reader that takes it (None: only am.read), has stamps, has orientations, words of a warning
LAYOUTS = {
    "tum": (lines(T, XYZ, Q), am.read_tum, True, True, ""),
    "tum with covariances": (lines(T, XYZ, Q, XYZ, XYZ), am.read_tum, True, True, ""),
    "tum, header of more columns": (
        lines(T, XYZ, Q, head="# timestamp(s) tx ty tz qx qy qz qw Pr11 Pr12\n"),
        am.read_tum,
        True,
        True,
        "",
    ),
    "tum, prose": (
        lines(T, XYZ, Q, head="# timestamp_s tx ty tz qx qy qz qw. Trajectory in IMU frame\n"),
        am.read_tum,
        True,
        True,
        "",
    ),
    "split stamps": (lines(SEC, NSEC, XYZ, Q, join=","), am.read_tum, True, True, ""),
    "split stamps named": (
        lines(SEC, NSEC, XYZ, Q, join=",", head="#sec,nsec,x,y,z,qx,qy,qz,qw\n"),
        am.read_tum,
        True,
        True,
        "",
    ),
    "counter and split stamps": (
        lines(
            COUNT,
            SEC,
            NSEC,
            XYZ,
            Q,
            join=", ",
            head="# counter, sec, nsec, x, y, z, qx, qy, qz, qw\n",
        ),
        None,
        True,
        True,
        "",
    ),
    "positions": (lines(T, XYZ), am.read_tum, True, False, ""),
    "positions with zeros": (lines(T, XYZ, 0 * Q), am.read_tum, True, False, ""),
    "positions named": (
        lines(T, XYZ, head="Time,X,Y,Z\n", join=","),
        am.read_tum,
        True,
        False,
        "header line",
    ),
    "euroc": (lines(NS, XYZ, WXYZ, XYZ, join=",", head=EUROC_HEAD), am.read_euroc, True, True, ""),
    "euroc, no header": (lines(NS, XYZ, WXYZ, join=","), am.read_euroc, True, True, ""),
    "euroc with spaces": (
        lines(NS, XYZ, WXYZ, head=EUROC_HEAD.replace(",", " ")),
        am.read_euroc,
        True,
        True,
        "",
    ),
    "euroc positions": (
        lines(NS, XYZ, join=",", head=EUROC_HEAD[: EUROC_HEAD.index(",q")] + "\n"),
        am.read_euroc,
        True,
        False,
        "",
    ),
    "scalar last by the header": (
        lines(NS, XYZ, Q, join=", ", head=OKVIS_HEAD),
        None,
        True,
        True,
        "header line",
    ),
    "scalar first by the header": (
        lines(T, XYZ, WXYZ, head="# t x y z qw qx qy qz\n"),
        None,
        True,
        True,
        "",
    ),
    "vins, commas at the end": (
        lines(NS, XYZ, WXYZ, XYZ, [""] * 40, join=","),
        am.read_euroc,
        True,
        True,
        "",
    ),
    "nanoseconds in a tum file": (
        lines([f"{ns}.000000" for ns in NS], XYZ, Q),
        None,
        True,
        True,
        "stamps in nanoseconds, and quaternions read with the scalar last, as in TUM files, line 1",
    ),
    "microseconds in a tum file": (
        lines(US, XYZ, Q),
        None,
        True,
        True,
        "stamps in microseconds, and quaternions",
    ),
    "tum, header of fewer columns": (
        lines(T, XYZ, Q, head="# time x y z\n"),
        am.read_tum,
        True,
        True,
        "",
    ),
    "positions, header of other columns": (
        lines(T, XYZ, Q, head="# time x y z a b c d\n"),
        am.read_tum,
        True,
        False,
        "",
    ),
    "the last header counts": (
        lines(T, XYZ, WXYZ, head="# t x y z qx qy qz qw\n# t x y z qw qx qy qz\n"),
        None,
        True,
        True,
        "",
    ),
    "milliseconds in a tum file": (
        lines([f"{t * 1e3:.6f}" for t in T], XYZ, Q),
        None,
        True,
        True,
        "stamps in milliseconds, and quaternions",
    ),
    "seconds, nanoseconds by the header": (
        lines(T, XYZ, Q, head="# time[ns] x y z qx qy qz qw\n"),
        am.read_tum,
        True,
        True,
        "",
    ),
    "milliseconds by the header": (
        lines(
            [f"{(t - T[0]) * 1e3 + 1:.6f}" for t in T], XYZ, Q, head="# time_ms x y z qx qy qz qw\n"
        ),
        None,
        None,
        True,
        "",
    ),
    "nanoseconds from zero": (
        lines([str(int(ns) - int(NS[0])) for ns in NS], XYZ, WXYZ, join=","),
        am.read_euroc,
        None,
        True,
        "",
    ),
    "rostopic": (
        lines(NS, COUNT, NS, XYZ, Q, XYZ[:, 0], join=",", head=ROS_HEAD),
        None,
        True,
        True,
        "",
    ),
    "bag to csv": (
        lines(T, COUNT, SEC, NSEC, XYZ, Q, join=",", head=BAG_HEAD),
        None,
        True,
        True,
        "header line",
    ),
    "frame and stamp": (
        lines(COUNT, T, XYZ, Q, join=",", head="#frame,timestamp,tx,ty,tz,qx,qy,qz,qw\n"),
        None,
        True,
        True,
        "",
    ),
    "boreas": (
        lines(US, XYZ, XYZ, XYZ, XYZ, join=",", head=BOREAS_HEAD),
        None,
        True,
        False,
        "header line",
    ),
    "pcd": (
        lines(XYZ, ONES, XYZ, T, head=PCD_HEAD),
        None,
        True,
        False,
        "header line",
    ),
    "kitti": (lines(MATRICES), am.read_kitti, False, True, ""),
    "kitti of sixteen": (lines(MATRICES, ROW4), am.read_kitti, False, True, ""),
    "kitti with frames": (lines(COUNT, MATRICES), am.read_kitti, False, True, ""),
    "kitti with stamps": (lines(T, MATRICES), am.read_kitti, True, True, ""),
    "kitti with microseconds": (lines(US, MATRICES), am.read_kitti, True, True, ""),
    "rotation, then position": (
        lines(X[:, :3, :3].reshape(-1, 9), XYZ),
        None,
        False,
        True,
        "",
    ),
    "no stamps": (lines(XYZ, Q), None, False, True, ""),
}


@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.filterwarnings("ignore::amrmetrics.errors.RecordingWarning")
def test_every_layout_is_read_as_itself_and_as_nothing_else(tmp_path, name, way):
    text, own, stamped, oriented, said = LAYOUTS[name]
    path = write(tmp_path / "run.txt", text)
    readers = {am.read_tum, am.read_euroc, am.read_kitti}
    found, message = warned(am.read, path) if said else (am.read(path, strict=True), "")
    assert said in message
    if stamped is None:
        assert np.abs(np.diff(found.stamps) - 1 / 30).max() < 1e-6
    elif stamped:
        assert np.abs(found.stamps - T).max() < 1e-6
    else:
        assert found.stamps is None
    assert np.abs(found.positions - XYZ).max() < 1e-9
    if oriented:
        assert np.abs(found.poses - X).max() < 1e-9
    else:
        assert found.poses.shape == (40, 3)
        zeros = "every quaternion in the file is 0 0 0 0"
        assert found.why_no_orientation == (
            zeros if "zeros" in name else "the file has positions only"
        )
    if own:
        assert np.array_equal(own(path).poses, found.poses)
    for reader in readers - {own}:
        with pytest.raises(am.AmrError, match=r"expected .*; this file has .*") as error:
            reader(path)
        reads = re.search(r"amrmetrics\.(\w+) reads this format\.$", str(error.value))[1]
        assert np.array_equal(getattr(am, reads)(path).poses, found.poses)


def test_positions_say_why_they_have_no_orientation(tmp_path):
    prism = am.read_tum(write(tmp_path / "run.txt", LAYOUTS["positions with zeros"][0]))
    assert am.ate(prism, prism).rmse < 1e-14
    with pytest.raises(
        am.AmrError, match=r"no orientations.*every quaternion in the file is 0 0 0"
    ):
        am.rpe(prism, prism)


def test_frame_numbers_are_kept(tmp_path):
    path = write(tmp_path / "00.txt", "".join(f"{k} {KITTI}" for k in (0, 3, 7)))
    found = am.read_kitti(path)
    assert found.frames.tolist() == [0, 3, 7]
    times = np.arange(8) / 10
    assert am.read_kitti(path, times=times).stamps.tolist() == [0, 0.3, 0.7]
    with pytest.raises(am.AmrError, match=r"7 stamps, and .* has frames 0 to 7; the first stamp"):
        am.read_kitti(path, times=times[:7])
    with pytest.raises(am.AmrError, match="frames -1 to 7"):
        am.read_kitti(write(path, f"-1 {KITTI}7 {KITTI}"), times=times)


def test_kitti_with_times(tmp_path):
    path = write(tmp_path / "00.txt", KITTI * 3)
    times = write(tmp_path / "times.txt", "0.0e+00\n1.0e-01\n2.5e-01\n")
    for stamps in (times, str(times), [0, 0.1, 0.25]):
        for reader in (am.read, am.read_kitti):
            assert reader(path, times=stamps).stamps.tolist() == [0, 0.1, 0.25]
    for stamps, what in ((write(times, "0\n1\n"), "times.txt"), ([0, 1], "times")):
        with pytest.raises(am.AmrError, match=f"{what} has 2 stamps, and .*00.txt has 3 poses"):
            am.read_kitti(path, times=stamps)
    with pytest.raises(am.AmrError, match=r"times.txt has 2 columns; expected one, seconds"):
        am.read_kitti(path, times=write(times, "0 1\n" * 3))
    with pytest.raises(am.AmrError, match="stamps go back in time"):
        am.read_kitti(path, times=[0, 2, 1])
    for name in ("tum", "kitti with stamps"):
        with pytest.raises(am.AmrError, match=r"times were given, but .* has "):
            am.read(write(tmp_path / "a", LAYOUTS[name][0]), times=T)


class TestOrderOfTheQuaternion:
    """TUM has the scalar last and EuRoC first; nothing else is taken for granted unsaid."""

    def text(self, stamps, join, first):
        q = Rotation.from_rotvec([[0, 0, k / 20 + 0.01] for k in range(40)]).as_quat()
        q = q[:, [3, 0, 1, 2]] if first else q
        return lines(stamps, XYZ, q, join=join), am.spatial_poses(
            XYZ, q[:, [1, 2, 3, 0]] if first else q
        )

    def test_seconds_with_the_scalar_first(self, tmp_path):
        text, X = self.text(T, " ", first=True)
        path = write(tmp_path / "run.txt", text)
        for reader in (am.read, am.read_tum):
            found, said = warned(reader, path)
            assert "the first of which is 1 0 0 0, read with the scalar last, line 1" in said
            with pytest.raises(am.AmrError, match="the first of which is 1 0 0 0"):
                reader(path, strict=True)
        assert np.abs(found.poses - X).max() > 1
        stated = am.read(path, columns="s x y z qw qx qy qz", strict=True)
        assert np.abs(stated.poses - X).max() < 1e-9

    def test_nanoseconds_with_the_scalar_first_and_spaces(self, tmp_path):
        text, X = self.text(NS, " ", first=True)
        path = write(tmp_path / "run.txt", text)
        for reader in (am.read, am.read_euroc):
            found, said = warned(reader, path)
            assert "the first of which is 1 0 0 0, read with the scalar first, line 1" in said
            assert np.abs(found.poses - X).max() < 1e-9

    def test_nanoseconds_with_the_scalar_last_and_commas(self, tmp_path):
        text, X = self.text(NS, ",", first=False)
        path = write(tmp_path / "run.txt", text)
        for reader in (am.read, am.read_tum, am.read_euroc):
            with pytest.raises(am.AmrError, match="whose order the numbers do not tell") as error:
                reader(path)
        last, first = re.findall(r'columns="(.*?)"', str(error.value))
        assert np.abs(am.read(path, columns=last, strict=True).poses - X).max() < 1e-9
        assert np.abs(am.read(path, columns=first, strict=True).poses - X).max() > 1

    def test_the_quaternion_before_the_position(self, tmp_path):
        path = write(tmp_path / "run.txt", lines(T, Q, XYZ))
        with pytest.raises(am.AmrError, match="a quaternion in columns 2 to 5") as error:
            am.read(path)
        last, first = re.findall(r'columns="(.*?)"', str(error.value))
        assert (last, first) == ("s qx qy qz qw x y z", "s qw qx qy qz x y z")
        assert np.abs(am.read(path, columns=last).poses - X).max() < 1e-9

    @pytest.mark.parametrize(("scalar", "said"), [(0.989, False), (0.991, True)])
    def test_at_the_edge(self, tmp_path, scalar, said):
        first = f"{T[0] - 1} 1 2 3 {scalar} 0 0 {(1 - scalar**2) ** 0.5}\n"
        path = write(tmp_path / "run.txt", first + lines(T, XYZ, Q))
        if said:
            warned(am.read_tum, path)
        else:
            am.read_tum(path, strict=True)


NOT_RECOGNIZED = {
    "imu": (
        lines(
            NS,
            XYZ,
            XYZ,
            join=",",
            head="#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],"
            "w_RS_S_z [rad s^-1],a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n",
        ),
        "7 columns, nowhere among them four of unit length",
    ),
    "euler angles": (lines(T, XYZ, XYZ), "7 columns, nowhere among them four of unit length"),
    "unit elsewhere": (lines(T, XYZ, XYZ, Q), "11 columns, four of unit length in columns 8 to 11"),
    "rotation, position, velocity": (
        lines(X[:, :3, :3].reshape(-1, 9), XYZ, XYZ),
        "a rotation matrix in columns 1 to 9 and then a position",
    ),
    "long quaternions by the header": (
        lines(T, XYZ, 3 * Q, head="# t x y z qx qy qz qw\n"),
        "the length of columns 5 to 8 is 3, where",
    ),
    "four more than a matrix": (lines(MATRICES, XYZ, 7 * ONES), "16 columns, "),
    "two stamps and a matrix": (lines(US, US, MATRICES), "a pose matrix in columns 3 to 14"),
    "long quaternions": (lines(T, XYZ, 3 * Q), "the length of columns 5 to 8 is 3, where"),
    "no stamps that increase": (lines(XYZ, XYZ), "6 columns, nowhere among them"),
}


@pytest.mark.parametrize("name", NOT_RECOGNIZED)
def test_what_is_not_recognized_can_be_stated(tmp_path, name):
    text, why = NOT_RECOGNIZED[name]
    path = write(tmp_path / "run.txt", text)
    for reader in (am.read, am.read_tum, am.read_euroc, am.read_kitti):
        with pytest.raises(am.AmrError, match=re.escape(why)) as error:
            reader(path)
        columns = re.search(r'amrmetrics\.read\(path, columns="(.*)"\)\.$', str(error.value))[1]
        assert len(am.read(path, columns=columns)) == 40


PLANE = np.c_[10 * np.cos(np.arange(40) / 9), 10 * np.sin(np.arange(40) / 9)]
YAW = am.wrap(np.arange(40) / 9 + np.pi / 2 + 1 / 18)


class TestPathsInThePlane:
    """x, y and a heading are no position in space."""

    @pytest.mark.parametrize("head", ["", "# time x y theta\n", "index,x,y,yaw\n"])
    def test_refused_and_the_advice_works(self, tmp_path, head):
        path = write(tmp_path / "run.txt", lines(T, PLANE, YAW, head=head))
        for reader in (am.read, am.read_tum):
            with pytest.raises(am.AmrError, match="a path in the plane") as error:
                reader(path)
        advice = ". amrmetrics.Trajectory(stamps, amrmetrics.planar_poses(xy, yaw)) takes it."
        assert str(error.value).endswith(advice)
        run = am.Trajectory(T, am.planar_poses(PLANE, YAW))
        assert run.dimension == 2

    def test_a_height_is_no_heading(self, tmp_path):
        straight = np.c_[np.arange(40), 0 * np.arange(40)]
        for xy, z in (
            (straight, 0 * YAW),
            (straight, np.sin(YAW)),
            (PLANE, YAW + 7),
            (PLANE, -YAW),
        ):
            path = write(tmp_path / "run.txt", lines(T, xy, z))
            assert am.read_tum(path, strict=True).positions[:, 2] == pytest.approx(z)

    def test_standing_still(self, tmp_path):
        path = write(tmp_path / "run.txt", lines(T, 0 * PLANE, YAW))
        assert len(am.read_tum(path)) == 40


def test_latitude_and_longitude_are_no_meters(tmp_path):
    place = np.c_[22.2 + np.sin(T) / 1e4, 114.3 + np.cos(T) / 1e4, 7 + np.sin(T)]
    path = write(tmp_path / "gnss.txt", lines(T, place))
    found, said = warned(am.read_tum, path)
    assert "latitudes and longitudes, as it seems, read as meters, line 1" in said
    assert found.positions == pytest.approx(place)
    for meters in (place * (10, 10, 0.1), place - (22, 114, 0), place * (1, 10, 1)):
        am.read_tum(write(path, lines(T, meters)), strict=True)


STATED_REFUSED = {
    "": "expected names such as",
    "s x y z qx": "expected names such as",
    "s x x y z": "once",
    "t x y z": "expected names such as",
    "s x y": "x, y and z .or T. must be among them",
    "s x y z qx qy qz qw _": "9 columns; .* has 8",
    "T": "12 columns; .* has 8",
    7: "expected names such as",
}


@pytest.mark.parametrize("columns", STATED_REFUSED)
def test_stated_columns_that_cannot_be(tmp_path, columns):
    path = write(tmp_path / "run.txt", "".join(tum()))
    with pytest.raises(am.AmrError, match=f"columns is .*{STATED_REFUSED[columns]}"):
        am.read(path, columns=columns)


def test_stated_columns(tmp_path):
    path = write(tmp_path / "run.txt", lines(ONES, Q, T, XYZ))
    assert np.abs(am.read(path, columns="_ qx qy qz qw s x y z").poses - X).max() < 1e-9
    assert am.read(path, columns="_ _ _ _ _ _ x y z").stamps is None
    path = write(path, lines(US, ONES, MATRICES))
    found = am.read(path, columns="us _ T")
    assert np.abs(found.poses - X).max() < 1e-9
    assert np.abs(found.stamps - T).max() < 1e-5
    path = write(path, lines(XYZ, X[:, :3, :3].reshape(-1, 9)))
    assert np.abs(am.read(path, columns="x y z R").poses - X).max() < 1e-9


def test_comments_and_blank_lines_between_the_lines(tmp_path, way):
    text = tum()
    text[5:5] = ["# c\n", "\n", "% d 1 2\n", "// e\n", "   \n"]
    text[20] = text[20].rstrip() + " # f\n"
    text[30] = text[31]
    path = write(tmp_path / "run.txt", "".join(text))
    assert "first in line 32" in warned(am.read_tum, path)[1]


def test_quotation_marks_are_no_numbers(tmp_path, way):
    path = write(tmp_path / "run.csv", '"0.5","1","2","3","0","0","0","1"\n')
    with pytest.raises(am.AmrError, match="has no data"):
        am.read_tum(path)


def test_the_same_numbers_in_every_way(tmp_path, way):
    rng = np.random.default_rng(13)
    table = rng.normal(size=(200, 8)) * 10.0 ** rng.integers(-8, 8, (200, 8))
    table[:, 0] = 1.3e9 + np.arange(200) / 7
    table[:, 4:] /= np.linalg.norm(table[:, 4:], axis=1)[:, None]
    text = "".join(" ".join(map(repr, row)) + "\n" for row in table.tolist())
    found = am.read_tum(write(tmp_path / "run.txt", text))
    assert np.array_equal(found.stamps, table[:, 0])
    assert np.array_equal(found.positions, table[:, 1:4])


SPATIAL = np.tile(np.eye(4), (2, 1, 1))
WRITE_REFUSED = {
    "no stamps": (lambda p: am.write_tum(p, am.Trajectory(None, SPATIAL)), "has no stamps"),
    "stamps alone": (lambda p: am.write_tum(p, [0, 1]), "X is missing"),
    "no orientations": (
        lambda p: am.write_tum(p, am.Trajectory([0, 1], np.zeros((2, 3)))),
        "X has no orientations",
    ),
    "count": (lambda p: am.write_tum(p, [0], SPATIAL), "stamps has 1 entries and X has 2 poses"),
    "unsorted": (lambda p: am.write_tum(p, [1, 0], SPATIAL), "stamps go back in time"),
    "nan stamp": (lambda p: am.write_tum(p, [0, np.nan], SPATIAL), r"stamps\[1\] is nan"),
    "nan": (lambda p: am.write_kitti(p, SPATIAL * np.nan), r"X\[0, 0, 0\] is nan"),
    "scaled": (lambda p: am.write_tum(p, [0, 1], SPATIAL * 2), "last row"),
    "positions": (lambda p: am.write_kitti(p, np.zeros((5, 3))), "poses need shape"),
    "empty": (lambda p: am.write_kitti(p, SPATIAL[:0]), "X is empty"),
}


@pytest.mark.parametrize("case", WRITE_REFUSED)
def test_refuses_to_write(tmp_path, case):
    call, message = WRITE_REFUSED[case]
    path = Path(tmp_path / "run.txt")
    with pytest.raises(am.AmrError, match=message):
        call(path)
    assert not path.exists()


class TestLargeFiles:
    """Pandas reads a regular file from the disk; its text is looked at only where it must be."""

    @pytest.mark.parametrize("head", ["", "# a\n\n# b c\n", "\ufeff", "\ufeff# a\n"])
    @pytest.mark.parametrize("end", ["\n", "\r\n"])
    def test_no_text_is_read(self, tmp_path, monkeypatch, head, end):
        text = (head + "".join(tum())).replace("\n", end)
        expected = am.read_tum(write(tmp_path / "run.txt", text))
        monkeypatch.setattr(_text, "LARGE", -1)
        table = _text.Table(tmp_path / "run.txt")
        assert "_data" not in vars(table)
        found = am.read_tum(tmp_path / "run.txt", strict=True)
        assert np.array_equal(found.stamps, expected.stamps)
        assert np.array_equal(found.poses, expected.poses)

    def test_repairs_name_the_line_all_the_same(self, tmp_path, monkeypatch):
        monkeypatch.setattr(_text, "LARGE", -1)
        text = ["# a\n", "\n", *tum()]
        text.insert(9, text[8])
        found, said = warned(am.read_tum, write(tmp_path / "run.txt", "".join(text)))
        assert said.endswith("1 stamps that were there already, left out, first in line 10.")
        assert len(found) == 40

    @pytest.mark.parametrize(("size", "disk"), [(1, True), (0, False), (-1, False)])
    def test_only_large_files(self, tmp_path, monkeypatch, size, disk):
        path = write(tmp_path / "run.txt", "".join(tum()))
        monkeypatch.setattr(_text, "LARGE", path.stat().st_size - size)
        assert ("_data" not in vars(_text.Table(path))) == disk

    def test_a_beginning_without_numbers(self, tmp_path, monkeypatch):
        monkeypatch.setattr(_text, "LARGE", -1)
        path = write(tmp_path / "run.txt", "# much to say\n" * 6000 + "".join(tum()))
        assert np.array_equal(_text.Table(path).values.shape, (40, 8))

    @pytest.mark.parametrize("pandas", [True, False])
    def test_memory(self, tmp_path, monkeypatch, pandas):
        if not pandas:
            monkeypatch.setitem(sys.modules, "pandas", None)
        k = np.arange(30_000)
        q = Rotation.from_rotvec(np.c_[np.sin(k), np.cos(k), 0 * k]).as_quat()
        table = np.c_[1e9 + k / 7, np.sin(k), np.cos(k), 1 / (1 + k), q]
        path = tmp_path / "run.txt"
        write(path, "".join(" ".join(map(repr, row)) + "\n" for row in table.tolist()))
        assert path.stat().st_size > _text.LARGE
        am.read_tum(path)
        tracemalloc.start()
        run = am.read_tum(path)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        arrays = run.stamps.nbytes + run.poses.nbytes
        assert peak < 2 * arrays + path.stat().st_size
        if pandas:
            assert peak < 2 * arrays


class TestWriter:
    def test_with_orjson_the_same_text(self, tmp_path, monkeypatch):
        def dumps(table, option):
            assert table.flags.c_contiguous
            return json.dumps(table.tolist(), separators=(",", ":")).encode()

        rng = np.random.default_rng(5)
        stamps, X = np.cumsum(rng.uniform(0.01, 1, 9000)), random_poses(rng, 9000)
        monkeypatch.setitem(sys.modules, "orjson", None)
        am.write_tum(tmp_path / "a", stamps, X)
        am.write_kitti(tmp_path / "c", X)
        orjson = SimpleNamespace(dumps=dumps, OPT_SERIALIZE_NUMPY=1)
        monkeypatch.setitem(sys.modules, "orjson", orjson)
        am.write_tum(tmp_path / "b", stamps, X)
        am.write_kitti(tmp_path / "d", X)
        assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
        assert (tmp_path / "c").read_bytes() == (tmp_path / "d").read_bytes()
        assert len(am.read_tum(tmp_path / "b")) == 9000

    def test_every_rotation(self, tmp_path, rng):
        turns = [np.pi * np.eye(3), -np.pi * np.eye(3), np.zeros((1, 3)), 1e-9 * np.eye(3)]
        turns += [rng.normal(size=(500, 3)), (np.pi - 1e-9) * np.ones((1, 3)) / 3**0.5]
        R = Rotation.from_rotvec(np.vstack(turns))
        X = am.spatial_poses(np.zeros((len(R), 3)), R.as_quat())
        path = tmp_path / "run.txt"
        am.write_tum(path, np.arange(len(R)), X)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", am.RecordingWarning)
            back = am.read_tum(path)
        assert np.abs(back.poses - X).max() < 2e-15
        q = np.loadtxt(path)[:, 4:]
        assert np.abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-15
        assert np.abs(np.abs(np.einsum("nk,nk->n", q, R.as_quat())) - 1).max() < 1e-14
