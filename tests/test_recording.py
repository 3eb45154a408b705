"""A Trajectory is cut along time, says what it is, and is taken wherever poses are."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import amrmetrics as am


def spatial(n=60):
    t = np.arange(n) / 10
    q = Rotation.from_euler("zyx", np.c_[t / 2, 0.3 * np.sin(t), 0.2 * np.cos(t)]).as_quat()
    return t, am.spatial_poses(np.c_[4 * np.cos(t), 3 * np.sin(t), t / 3], q)


def planar(n=60):
    t = np.arange(n) / 10
    return t, am.planar_poses(np.c_[4 * np.cos(t), 3 * np.sin(t)], t / 2)


@pytest.fixture(params=[spatial, planar])
def run(request):
    return am.Trajectory(*request.param(), "a run", repairs=("two stamps left out",))


class TestSlicing:
    @pytest.mark.parametrize(
        "index",
        [
            slice(10, 20),
            slice(None, None, 7),
            slice(-5, None),
            [3, 5, 9],
            np.array([0, 59]),
            np.arange(60) % 4 == 1,
            range(4, 8),
            slice(59, 60),
        ],
    )
    def test_along_time(self, run, index):
        some = run[index]
        assert isinstance(some, am.Trajectory)
        assert np.array_equal(some.stamps, run.stamps[index])
        assert np.array_equal(some.poses, run.poses[index])
        assert (some.source, some.repairs) == (run.source, run.repairs)
        assert len(some) == len(run.stamps[index])

    @pytest.mark.parametrize("index", [0, 7, -1, np.int64(3)])
    def test_one_pose(self, run, index):
        assert np.array_equal(run[index], run.poses[index])

    def test_frames_go_along(self):
        run = am.Trajectory(None, spatial(5)[1], frames=[0, 2, 4, 6, 9])
        assert run[1:3].frames.tolist() == [2, 4]
        assert run[[0, 4]].frames.tolist() == [0, 9]

    @pytest.mark.parametrize(
        ("index", "message"),
        [
            (60, "the trajectory has 60 poses"),
            (-61, "the trajectory has 60 poses"),
            ([3, 60], "the trajectory has 60 poses"),
            (np.ones(59, bool), "the trajectory has 60 poses"),
            (0.5, "the trajectory has 60 poses"),
            ("a", "the trajectory has 60 poses"),
            (slice(20, 20), "nothing is left of the 60 poses"),
            (np.zeros(60, bool), "nothing is left of the 60 poses"),
            ([], "nothing is left of the 60 poses"),
            ((slice(None), 0), "is sliced along time only"),
            ((slice(None), slice(2)), "is sliced along time only"),
            (None, "is sliced along time only"),
            (slice(None, None, -1), "stamps go back in time"),
            ([3, 3], "stamps repeat"),
        ],
    )
    def test_what_cannot_be(self, run, index, message):
        with pytest.raises(am.AmrError, match=message):
            run[index]

    def test_the_advice_to_slice_poses(self, run):
        assert run.poses[:, 0].shape[0] == 60
        assert isinstance(run[10:20], am.Trajectory)

    def test_between(self, run):
        assert run.between(1.0, 2.0).stamps == pytest.approx(np.arange(10, 21) / 10)
        assert run.between(end=0.35).stamps == pytest.approx([0, 0.1, 0.2, 0.3])
        assert run.between(5.8).stamps == pytest.approx([5.8, 5.9])
        assert run.between(0).duration == run.duration
        with pytest.raises(
            am.AmrError, match=r"between 6\.0+ and inf s; a run runs from 0\.0+ to 5"
        ):
            run.between(6)
        with pytest.raises(am.AmrError, match=r"the trajectory has no stamps; slice it by index"):
            am.Trajectory(None, run.poses).between(1, 2)


class TestWhatItSays:
    def test_repr(self, run):
        where = "in space" if run.dimension == 3 else "in the plane"
        path = am.path_length(run.poses)
        assert repr(run) == (
            f"a run: 60 poses {where}, 5.9 s, 10 per second, path {path:.6g} m, "
            "repaired: two stamps left out"
        )

    def test_repr_of_less(self):
        assert repr(am.Trajectory(None, np.zeros((3, 2)))) == (
            "trajectory: 3 positions in the plane, no stamps, path 0 m"
        )
        assert repr(am.Trajectory([5.0], np.eye(4)[None], "one")) == (
            "one: 1 poses in space, 0 s, path 0 m"
        )

    def test_numbers(self, run):
        assert run.duration == pytest.approx(5.9)
        assert run.rate == pytest.approx(10)
        assert run.path_length == am.path_length(run) == am.path_length(run.positions)
        assert run.positions.shape == (60, run.dimension)
        assert np.array_equal(run.positions, am.positions(run.poses))

    def test_the_rate_is_that_of_most(self):
        t = np.r_[np.arange(10) / 10, 100.0]
        assert am.Trajectory(t, np.zeros((11, 3))).rate == pytest.approx(10)

    def test_nothing_known(self):
        run = am.Trajectory(None, np.zeros((3, 3)))
        assert np.isnan([run.duration, run.rate]).all()
        assert np.isnan(am.Trajectory([1.0], np.zeros((1, 3))).rate)

    def test_positions_are_a_copy(self, run):
        run.positions[:] = 0
        assert np.abs(run.poses[:, 0, -1]).max() > 1
        points = am.Trajectory(None, np.ones((3, 2)))
        points.positions[:] = 0
        assert points.poses.min() == 1


REFUSED = {
    "empty": (lambda X: am.Trajectory([], X[:0]), "poses is empty"),
    "lengths": (lambda X: am.Trajectory([0, 1], X), "stamps has 2 entries for 60 poses; one each"),
    "frames": (lambda X: am.Trajectory(None, X, frames=[1]), "frames has 1 entries for 60 poses"),
    "frames back": (
        lambda X: am.Trajectory(None, X[:3], frames=[1, 5, 5]),
        "frames must increase; 5 comes after 5",
    ),
    "unsorted": (lambda X: am.Trajectory([0, 2, 1], X[:3]), "stamps go back in time"),
    "repeated": (lambda X: am.Trajectory([0, 0, 1], X[:3]), "stamps repeat"),
    "nan stamp": (lambda X: am.Trajectory([0, np.nan, 1], X[:3]), r"stamps\[1\] is nan"),
    "one pose": (lambda X: am.Trajectory([0], X[0]), "single pose|shape"),
    "transposed": (lambda X: am.Trajectory(None, X.swapaxes(1, 2)), "Is it transposed"),
    "nan pose": (lambda X: am.Trajectory(None, X * np.nan), "is nan"),
    "ragged": (lambda X: am.Trajectory(None, [[1, 2], [1]]), "rows have different lengths"),
    "text": (lambda X: am.Trajectory(None, "run.txt"), "poses"),
}


@pytest.mark.parametrize("case", REFUSED)
@pytest.mark.parametrize("make", [spatial, planar])
def test_refuses(case, make):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call(make()[1])


def test_taken_apart(run):
    stamps, X = run
    assert stamps is run.stamps
    assert X is run.poses
    assert np.array_equal(np.asarray(run), X)
    assert np.asarray(run, np.float32).dtype == np.float32


class TestTakenWhereverPosesAre:
    def pair(self, run):
        X = run.poses
        moved = X.copy()
        moved[:, :-1, -1] += 0.01 * np.sin(np.arange(60) * 2)[:, None]
        return X, moved, am.Trajectory(run.stamps, moved)

    @pytest.mark.parametrize(
        "metric",
        [
            am.ate,
            am.rpe,
            am.align,
            am.drift_rate,
            lambda p, q: am.rpe(p, q, 1, "m"),
            lambda p, q: am.segment_drift(p, q, lengths=(2, 4)),
        ],
    )
    def test_as_the_array(self, run, metric):
        X, moved, estimate = self.pair(run)
        assert repr(metric(run, estimate)) == repr(metric(X, moved))

    def test_stamps_of_its_own(self, run):
        X, moved, estimate = self.pair(run)
        assert repr(am.rpe(run, estimate, 0.5, "s")) == repr(
            am.rpe(X, moved, 0.5, "s", stamps=run.stamps)
        )

    def test_path_length_project_and_associate(self, run):
        assert am.path_length(run) == am.path_length(run.poses)
        if run.dimension == 3:
            assert np.array_equal(np.asarray(am.project(run)), am.project(run.poses))
        i, j = am.associate(run, run[::2])
        assert i.tolist() == list(range(0, 60, 2))
        assert j.tolist() == list(range(30))

    def test_interpolate(self, run):
        new = np.array([0.55, 2.5])
        found = am.interpolate(run, new)
        assert isinstance(found, am.Trajectory)
        assert np.allclose(found.poses, am.interpolate(run.stamps, run.poses, new))
        assert np.array_equal(found.stamps, new)

    def test_clock_offset(self):
        t = np.arange(0, 60, 0.05)
        yaw = np.cumsum(np.sin(t) + np.sin(2.7 * t)) * 0.05
        X = am.planar_poses(np.c_[np.cos(yaw), np.sin(yaw)], yaw)
        later = am.Trajectory(t + 0.4, X)
        run = am.Trajectory(t, X)
        found = float(am.clock_offset(run, run, later, later))
        assert found == pytest.approx(-0.4, abs=0.01)
        assert found == float(am.clock_offset(t, X, t + 0.4, X))

    def test_what_needs_stamps_says_so(self, run):
        bare = am.Trajectory(None, run.poses)
        for call in (am.interpolate, am.associate):
            with pytest.raises(am.AmrError, match="has no stamps"):
                call(bare, np.array([0.5]))

    def test_what_needs_orientations_says_why(self, run):
        points = am.Trajectory(run.stamps, run.positions, why_no_orientation="a prism")
        assert am.ate(points, points).rmse < 1e-12
        for call in (am.rpe, am.segment_drift):
            with pytest.raises(
                am.AmrError, match="no orientations, which are needed here: a prism"
            ):
                call(points, points)

    def test_written_and_read_again(self, run, tmp_path):
        path = tmp_path / "run.txt"
        am.write_tum(path, run)
        back = am.read_tum(path)
        assert np.array_equal(back.stamps, run.stamps)
        assert repr(am.write_kitti(tmp_path / "00.txt", run)) == "None"
        kitti = am.read_kitti(tmp_path / "00.txt", times=run.stamps)
        if run.dimension == 2:
            back, kitti = (am.Trajectory(x.stamps, am.project(x.poses)) for x in (back, kitti))
        assert np.abs(back.poses - run.poses).max() < 4e-15
        assert np.abs(kitti.poses - run.poses).max() < 4e-15

    def test_a_planar_one_lies_in_the_plane(self, tmp_path):
        run = am.Trajectory(*planar())
        am.write_tum(tmp_path / "run.txt", run)
        X = am.read_tum(tmp_path / "run.txt").poses
        assert np.array_equal(X[:, 2], np.tile([0, 0, 1.0, 0], (60, 1)))
        assert np.array_equal(X[:, :2, 2], np.zeros((60, 2)))
        assert np.abs(am.yaw(X) - am.yaw(run.poses)).max() < 1e-15


def test_unmatched_recordings_are_no_pairs(run):
    with pytest.raises(am.AmrError, match="Match them first: reference, estimate ="):
        am.ate(run, run[:50])
    later = am.Trajectory(run.stamps + 0.06, run.poses)
    with pytest.raises(am.AmrError, match=r"are 0\.06 s apart"):
        am.ate(run, later)
    am.ate(run, am.Trajectory(run.stamps + 0.04, run.poses))
    reference, estimate = am.match(run, run[:50])
    assert len(reference) == 50
    assert am.ate(reference, estimate).rmse < 1e-12


class TestWhatIsNoPair:
    MATCH = r"Match them first: reference, estimate = am\.match"

    def test_the_shorter_one_may_be_either(self, run):
        for pair in ((run, run[:50]), (run[:50], run)):
            with pytest.raises(am.AmrError, match=self.MATCH):
                am.ate(*pair)

    def test_two_samples_are_looked_at(self, run):
        pair = run[:2], am.Trajectory(run.stamps[:2] + 0.06, run.poses[:2])
        with pytest.raises(am.AmrError, match=self.MATCH):
            am.ate(*pair, align="none")

    def test_a_gap_does_not_widen_the_tolerance(self, run):
        t = run.stamps + np.where(np.arange(60) > 30, 100, 0)
        pair = [am.Trajectory(x, run.poses) for x in (t, t + 0.06)]
        with pytest.raises(am.AmrError, match=r"a pose every 0\.1 s"):
            am.ate(*pair)

    def test_halves_of_two_matches(self, run):
        reference, _ = am.match(run, run[:50])
        _, estimate = am.match(run, run[10:])
        with pytest.raises(am.AmrError, match=self.MATCH):
            am.ate(reference, estimate)
