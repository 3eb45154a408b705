"""Files come back to the last digit, as others write them too, and errors name the line."""

import gzip
from pathlib import Path

import numpy as np
import pytest
from evo.core import metrics, trajectory
from evo.tools import file_interface
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

import amrmetrics as am

TUM = "0.5 1 2 3 0 0 0 1\n"
EUROC = "1403636580838555648,4.5,-1.7,0.7,1,0,0,0,0.1,0.2,0.3\n"
KITTI = "1 0 0 5 0 1 0 6 0 0 1 7\n"


def random_poses(rng, n):
    return am.spatial_poses(rng.normal(size=(n, 3)), Rotation.random(n, rng=rng).as_quat())


def write(path, text):
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


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
def test_reads_what_people_write(tmp_path, text):
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


REFUSED = {
    "empty": (am.read_tum, "", "has no data: 0 lines"),
    "comments only": (am.read_tum, "# a\n\n# b\n", "has no data: 3 lines, all blank or comments"),
    "few columns": (am.read_tum, TUM + "\n1 2 3\n", "line 3: 3 columns, expected 8 .stamp tx ty"),
    "many columns": (am.read_tum, TUM + "1 2 3 4 0 0 0 1 5\n", "line 2: 9 columns, expected 8"),
    "all few": (am.read_tum, "1 2 3\n4 5 6\n", "line 1: 3 columns, expected 8"),
    "text": (am.read_tum, TUM + "1 2 x 4 0 0 0 1\n", "line 2, column 3: 'x' is not a number"),
    "header": (am.read_tum, "stamp tx ty tz qx qy qz qw\n" + TUM, "line 1, column 1: 'stamp'"),
    "underscore": (am.read_tum, "1 2_0 3 4 0 0 0 1\n", "line 1, column 2: '2_0' is not a number"),
    "other digits": (am.read_tum, "1 ２ 3 4 0 0 0 1\n", "line 1, column 2: '２' is not a number"),
    "complex": (am.read_tum, "1 2j 3 4 0 0 0 1\n", "'2j' is not a number"),
    "nan": (am.read_tum, TUM + "# c\n1 2 nan 4 0 0 0 1\n", "line 3, column 3: nan. Drop such"),
    "inf": (am.read_tum, "1 2 3 -inf 0 0 0 1\n", "line 1, column 4: -inf"),
    "overflow": (am.read_tum, "1 2 3 1e999 0 0 0 1\n", "line 1, column 4: 1e999"),
    "duplicate": (am.read_tum, TUM + TUM, "line 2: the stamp 0.500000000 repeats the one of line"),
    "unsorted": (
        am.read_tum,
        "# c\n2 2 3 4 0 0 0 1\n" + TUM,
        "line 3: the stamp 0.500000000 is before the one of line 2",
    ),
    "zero quaternion": (am.read_tum, "1 2 3 4 0 0 0 0\n", "line 1: the quaternion has length 0"),
    "long quaternion": (am.read_tum, TUM + "1 2 3 4 0 0 0 1.01\n", "line 2: .* length 1.01; a rot"),
    "binary": (am.read_tum, bytes(range(256)), "is not a text file in UTF-8"),
    "zeros": (am.read_tum, b"\0\1\2\n", "line 1: 1 columns"),
    "utf-16": (am.read_tum, TUM.encode("utf-16"), "is not a text file in UTF-8"),
    "semicolons": (am.read_tum, TUM.replace(" ", ";"), "line 1: 1 columns, expected 8"),
    "euroc columns": (am.read_euroc, "1,2,3,4\n", r"4 columns, expected 8 or more \(stamp.ns. px"),
    "euroc ragged": (am.read_euroc, EUROC + "1403636590838555648,4,1,0,1,0,0,0\n", "lines differ"),
    "euroc order": (am.read_euroc, "1,0,0,0,0,0,0,2\n", "the quaternion has length 2"),
    "euroc duplicate": (am.read_euroc, EUROC * 2, "line 2: the stamp 1403636580.8385.* repeats"),
    "kitti columns": (am.read_kitti, KITTI + TUM, "line 2: 8 columns, expected 12 .r11 r12"),
    "kitti scale": (
        am.read_kitti,
        "# c\n" + KITTI * 5 + "2" + KITTI[1:] + "3" + KITTI[1:],
        "line 7: the matrix is not a pose: its 3x3 block is not a rotation",
    ),
    "kitti mirror": (
        am.read_kitti,
        KITTI * 3 + "-" + KITTI + KITTI,
        "line 4: the matrix is a reflection",
    ),
    "kitti far": (am.read_kitti, KITTI.replace("5", "1e150"), "line 1: the matrix holds a coord"),
    "kitti nan": (am.read_kitti, KITTI + KITTI.replace("7", "nan"), "line 2, column 12: nan"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_file_and_line(tmp_path, case):
    reader, text, message = REFUSED[case]
    path = write(tmp_path / "run.txt", text)
    with pytest.raises(am.AmrError, match=message) as caught:
        reader(path)
    assert str(caught.value).startswith(str(path))


ZIPPED = gzip.compress(TUM.encode(), mtime=0)


@pytest.mark.parametrize(
    "data", [ZIPPED[:-6], TUM.encode(), ZIPPED[:12] + b"\xff\xff\xff" + ZIPPED[15:], b""]
)
def test_refuses_broken_archives(tmp_path, data):
    path = write(tmp_path / "run.txt.gz", data)
    with pytest.raises(am.AmrError, match=r"not a text file|has no data") as caught:
        am.read_tum(path)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize("reader", [am.read_tum, am.read_kitti, am.read_euroc])
def test_a_missing_file_is_the_systems_error(tmp_path, reader):
    with pytest.raises(FileNotFoundError):
        reader(tmp_path / "none.txt")


SPATIAL = np.tile(np.eye(4), (2, 1, 1))
WRITE_REFUSED = {
    "planar": (lambda p: am.write_tum(p, [0], np.eye(3)[None]), "the format holds spatial poses"),
    "planar kitti": (
        lambda p: am.write_kitti(p, np.eye(3)[None]),
        "the format holds spatial poses",
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
