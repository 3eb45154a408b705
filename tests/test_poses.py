"""Poses form a group, angles wrap, and bad input is named."""

import numpy as np
import pytest
from evo.core import trajectory
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

import amrmetrics as am

finite = st.floats(-1e6, 1e6)
angles = st.floats(-1e4, 1e4)


def random_poses(rng, n, d):
    if d == 2:
        return am.planar_poses(rng.normal(size=(n, 2)), rng.uniform(-9, 9, n))
    return am.spatial_poses(rng.normal(size=(n, 3)), Rotation.random(n, rng=rng).as_quat())


class TestWrap:
    @given(st.floats(allow_nan=False, allow_infinity=False))
    def test_every_float_lands_in_the_half_open_interval(self, angle):
        assert -np.pi <= am.wrap(angle) < np.pi

    @given(st.floats(-1e3, 1e3))
    def test_keeps_the_direction(self, angle):
        assert np.isclose(np.exp(1j * am.wrap(angle)), np.exp(1j * angle), atol=1e-12)

    @given(st.floats(-np.pi, np.nextafter(np.pi, 0)))
    def test_leaves_angles_inside_untouched(self, angle):
        assert am.wrap(angle) == angle

    @pytest.mark.parametrize("angle", [np.pi, -np.pi, 3 * np.pi, -3 * np.pi])
    def test_the_ends(self, angle):
        assert am.wrap(angle) == pytest.approx(-np.pi)

    def test_the_popular_formula_fails_just_below_minus_pi(self):
        angle = np.nextafter(-np.pi, -4)
        popular = np.mod(angle + np.pi, 2 * np.pi) - np.pi
        assert popular >= np.pi
        assert -np.pi <= am.wrap(angle) < np.pi

    def test_arrays_keep_their_shape_and_their_content(self):
        given_angles = np.array([[7.0, -7.0]])
        assert am.wrap(given_angles).shape == (1, 2)
        assert given_angles.tolist() == [[7.0, -7.0]]
        assert am.wrap([]).shape == (0,)
        assert isinstance(am.wrap(7), float)


@pytest.mark.parametrize("d", [2, 3])
class TestGroup:
    def test_inverse_from_both_sides(self, rng, d):
        X = random_poses(rng, 50, d)
        assert np.allclose(am.inverse(X) @ X, np.eye(d + 1), atol=1e-14)
        assert np.allclose(X @ am.inverse(X), np.eye(d + 1), atol=1e-14)

    def test_inverse_equals_the_general_matrix_inverse(self, rng, d):
        X = random_poses(rng, 50, d)
        assert np.allclose(am.inverse(X), np.linalg.inv(X), atol=1e-12)

    def test_relative_composes_back(self, rng, d):
        A, B = random_poses(rng, 50, d), random_poses(rng, 50, d)
        assert np.allclose(A @ am.relative(A, B), B, atol=1e-13)

    def test_relative_does_not_see_a_common_motion(self, rng, d):
        A, B, G = (random_poses(rng, 50, d) for _ in range(3))
        assert np.allclose(am.relative(G @ A, G @ B), am.relative(A, B), atol=1e-13)

    def test_relative_broadcasts_one_pose_over_many(self, rng, d):
        X = random_poses(rng, 5, d)
        assert np.allclose(am.relative(X[0], X), am.relative(X[[0] * 5], X))

    def test_rotation_angle_equals_scipy(self, rng, d):
        X = random_poses(rng, 200, d)
        R = np.tile(np.eye(3), (200, 1, 1))
        R[:, :d, :d] = X[:, :d, :d]
        assert np.allclose(am.rotation_angle(X), Rotation.from_matrix(R).magnitude(), atol=1e-12)

    @pytest.mark.parametrize("angle", [0.0, 1e-12, 1e-6, 1.0, np.pi - 1e-6, np.pi])
    def test_rotation_angle_keeps_its_digits_at_both_ends(self, rng, d, angle):
        if d == 2:
            X = am.planar_poses([[0, 0]], [angle])
        else:
            axis = rng.normal(size=3)
            q = Rotation.from_rotvec(angle * axis / np.linalg.norm(axis)).as_quat()
            X = am.spatial_poses([[0, 0, 0]], [q])
        assert am.rotation_angle(X)[0] == pytest.approx(angle, rel=1e-9, abs=1e-15)

    def test_single_poses_work_and_inputs_stay(self, rng, d):
        X = random_poses(rng, 1, d)
        before = X.copy()
        assert am.inverse(X[0]).shape == (d + 1, d + 1)
        assert isinstance(am.rotation_angle(X[0]), float)
        am.positions(X)[:] = 0
        assert np.array_equal(X, before)


def test_spatial_poses_equal_scipy(rng):
    q = Rotation.random(100, rng=rng).as_quat()
    X = am.spatial_poses(np.zeros((100, 3)), q * 1.0005)
    assert np.allclose(X[:, :3, :3], Rotation.from_quat(q).as_matrix(), atol=1e-14)


def test_yaw_reads_the_heading_in_plane_and_space(rng):
    heading = rng.uniform(-np.pi, np.pi, 50)
    xyz = rng.normal(size=(50, 3))
    assert np.allclose(am.yaw(am.planar_poses(xyz[:, :2], heading)), heading)
    tilted = Rotation.from_euler("ZYX", np.c_[heading, rng.uniform(-1, 1, (50, 2))])
    assert np.allclose(am.yaw(am.spatial_poses(xyz, tilted.as_quat())), heading)


@given(arrays(float, (7, 2), elements=finite))
def test_path_length_bounds_the_direct_way(xy):
    assert am.path_length(xy) >= np.linalg.norm(xy[-1] - xy[0]) * (1 - 1e-12)


def test_path_length_of_known_paths():
    circle = np.exp(1j * np.linspace(0, 2 * np.pi, 10_001))
    assert am.path_length(np.c_[circle.real, circle.imag]) == pytest.approx(2 * np.pi, rel=1e-6)
    assert am.path_length([[4.0, 5.0]]) == 0.0
    X = am.planar_poses([[0, 0], [3, 4]], [0, 1])
    assert am.path_length(X) == 5.0


NORMALS = {"xy": [0, 0, 1], "xz": [0, -1, 0], "yz": [1, 0, 0]}


class TestProject:
    @pytest.mark.parametrize("plane", NORMALS)
    def test_a_motion_in_the_plane_keeps_its_full_turn(self, rng, plane):
        heading = rng.uniform(-np.pi, np.pi, 50)
        xyz = rng.normal(size=(50, 3))
        q = Rotation.from_rotvec(np.outer(heading, NORMALS[plane])).as_quat()
        X = am.spatial_poses(xyz, q)
        X.flags.writeable = False
        found = am.project(X, plane)
        assert np.allclose(am.yaw(found), heading)
        assert np.array_equal(am.positions(found), xyz[:, ["xyz".index(a) for a in plane]])

    @pytest.mark.parametrize("plane", NORMALS)
    def test_motions_in_the_plane_project_to_planar_motions(self, rng, plane):
        turns = Rotation.from_rotvec(np.outer(rng.uniform(-3, 3, 20), NORMALS[plane])).as_quat()
        G = am.spatial_poses(rng.normal(size=(20, 3)), turns)
        X = random_poses(rng, 20, 3)
        expected = am.project(G, plane) @ am.project(X, plane)
        assert np.allclose(am.project(G @ X, plane), expected, atol=1e-12)

    def test_in_the_ground_plane_the_heading_is_the_yaw(self, rng):
        X = random_poses(rng, 50, 3)
        assert np.allclose(am.yaw(am.project(X)), am.yaw(X))

    def test_evo_folds_headings_beyond_a_right_angle(self):
        heading = np.radians([45, 135, -135])
        q = Rotation.from_euler("y", -heading[:, None]).as_quat()
        X = am.spatial_poses(np.zeros((3, 3)), q)
        path = trajectory.PosePath3D(poses_se3=list(X.copy()))
        path.project(trajectory.Plane.XZ)
        theirs = np.arctan2([P[2, 0] for P in path.poses_se3], [P[0, 0] for P in path.poses_se3])
        assert np.allclose(np.degrees(theirs), [45, 45, -45])
        assert np.allclose(am.yaw(am.project(X, "xz")), heading)


EYE = np.eye(3)[None]
REFUSED = {
    "project planar": (lambda: am.project(EYE), "only spatial poses"),
    "project plane": (lambda: am.project(np.eye(4)[None], "zx"), "plane is 'zx'; expected 'xy'"),
    "project upright": (
        lambda: am.project(
            am.spatial_poses([[0, 0, 0]] * 2, [[0, 0, 0, 1], [0, 0.5**0.5, 0, 0.5**0.5]])
        ),
        "x axis is perpendicular to the xy plane in 1 poses of X, first at index 1",
    ),
    "project one": (lambda: am.project(np.eye(4)), r"shape \(4, 4\)"),
    "huge position": (lambda: am.inverse(am.planar_poses([[1e200, 0]], [0])), "cannot be squared"),
    "wrap nan": (lambda: am.wrap([1, np.nan]), r"angle\[1\] is nan"),
    "wrap inf": (lambda: am.wrap(np.inf), "angle is inf"),
    "wrap text": (lambda: am.wrap("north"), "real numbers"),
    "wrap complex": (lambda: am.wrap(1j), "real numbers"),
    "poses shape": (lambda: am.inverse(np.zeros((2, 2))), r"shape \(2, 2\)"),
    "poses empty": (lambda: am.positions(np.zeros((0, 3, 3))), "empty"),
    "poses nan": (lambda: am.positions(EYE * np.nan), r"X\[0, 0, 0\] is nan"),
    "ragged": (lambda: am.path_length([[1, 2], [3]]), "different lengths"),
    "transposed": (
        lambda: am.inverse(am.planar_poses([[1, 2]], [0]).swapaxes(1, 2)),
        "Is it transposed",
    ),
    "scaled": (lambda: am.inverse(np.diag([2.0, 2.0, 1.0])), "not a rotation matrix"),
    "reflection": (lambda: am.inverse(np.diag([1.0, -1.0, 1.0])), "reflection"),
    "broadcast": (lambda: am.relative(EYE[[0] * 2], EYE[[0] * 3]), r"A has shape \(2, 3, 3\)"),
    "yaw count": (lambda: am.planar_poses([[0, 0]], [1, 2]), r"shape \(1,\)"),
    "xy width": (lambda: am.planar_poses([[0, 0, 0]], [1]), r"\(N, 2\)"),
    "zero quaternion": (lambda: am.spatial_poses([[0, 0, 0]], [[0, 0, 0, 0]]), "is zero"),
    "long quaternion": (
        lambda: am.spatial_poses([[0, 0, 0]] * 2, [[0, 0, 0, 1], [0, 0, 0, 1.01]]),
        r"quaternions\[1\] has length 1.01",
    ),
    "quaternion count": (
        lambda: am.spatial_poses([[0, 0, 0]] * 2, [[0, 0, 0, 1]]),
        "xyz has 2 rows and quaternions has 1",
    ),
    "vertical yaw": (
        lambda: am.yaw(
            am.spatial_poses([[0, 0, 0]], [Rotation.from_euler("y", 90, degrees=True).as_quat()])
        ),
        "gimbal",
    ),
    "path of text": (lambda: am.path_length(["a", "b"]), "real numbers"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()
