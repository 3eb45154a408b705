"""The alignment is the optimum, agrees with others, and refuses what has none."""

import copy
import pickle
import re

import numpy as np
import pytest
from evo.core import geometry
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

import amrmetrics as am
from amrmetrics.alignment import _planar_rotation, _rotation

SEEDS = st.integers(0, 2**32 - 1)
MODES = ["rigid", "similarity", "yaw"]


def random_rotation(rng, d, mode="rigid"):
    if d == 2 or mode == "yaw":
        return Rotation.from_euler("z", rng.uniform(-np.pi, np.pi)).as_matrix()[:d, :d]
    return Rotation.random(rng=rng).as_matrix()


def random_case(rng, d, mode, n=None, noise=0.0):
    """Return (p, q, s, R, t) with p = s R q + t up to noise."""
    n = n or int(rng.integers(3 if d == 2 else 4, 40))
    q = rng.normal(size=(n, d)) * 10 ** rng.uniform(-3, 3)
    s = 10 ** rng.uniform(-2, 2) if mode == "similarity" else 1.0
    R, t = random_rotation(rng, d, mode), rng.normal(size=d) * np.abs(q).max()
    p = s * q @ R.T + t
    return p + noise * np.std(p) * rng.normal(size=p.shape), q, s, R, t


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("mode", MODES)
class TestOptimum:
    @given(seed=SEEDS)
    def test_recovers_a_known_transform(self, d, mode, seed):
        rng = np.random.default_rng(seed)
        p, q, s, R, t = random_case(rng, d, mode)
        # Well-conditioned clouds: the bound is on the method, not on the data.
        spread = np.linalg.svd(q - q.mean(0), compute_uv=False)
        assume(spread[-1] > 0.1 * spread[0])
        a = am.align(p, q, mode)
        size = np.abs(p).max()
        assert np.abs(a.apply(q) - p).max() <= 1e-12 * size
        assert np.abs(a.rotation - R).max() <= 1e-12
        assert abs(a.scale / s - 1) <= 1e-12
        assert np.abs(a.translation - t).max() <= 1e-12 * size

    @given(seed=SEEDS)
    def test_is_a_rotation_never_a_reflection(self, d, mode, seed):
        rng = np.random.default_rng(seed)
        p, q = rng.normal(size=(2, d + 2, d))
        R = am.align(p, q * ([1] * (d - 1) + [-1]), mode).rotation
        assert np.allclose(R @ R.T, np.eye(d), atol=1e-12)
        assert np.linalg.det(R) == pytest.approx(1)

    @given(seed=SEEDS)
    def test_moving_either_side_moves_the_answer_with_it(self, d, mode, seed):
        rng = np.random.default_rng(seed)
        p, q, *_ = random_case(rng, d, mode, noise=0.1)
        G, H = random_rotation(rng, d, mode), random_rotation(rng, d, mode)
        a = am.align(p, q, mode)
        b = am.align(p @ G.T + 1, q @ H.T - 2, mode)
        assert np.allclose(b.rotation, G @ a.rotation @ H.T, atol=1e-9)
        assert b.rmse == pytest.approx(a.rmse, rel=1e-6)

    @pytest.mark.parametrize("seed", range(20))
    def test_no_optimizer_finds_a_better_one(self, d, mode, seed):
        rng = np.random.default_rng(seed)
        p, q, *_ = random_case(rng, d, mode, n=12, noise=0.3)
        a = am.align(p, q, mode)
        turns = 1 if d == 2 or mode == "yaw" else 3

        def cost(x):
            w = np.zeros(3)
            w[3 - turns :] = x[:turns]
            R = Rotation.from_rotvec(w).as_matrix()[:d, :d]
            s = abs(x[turns]) if mode == "similarity" else 1.0
            rest = p - p.mean(0) - s * (q - q.mean(0)) @ R.T - np.std(p) * x[turns + 1 :]
            return (rest**2).sum() / a.residual

        starts = rng.normal(size=(4, turns + 1 + d)) * ([2] * turns + [1] * (1 + d))
        best = min(minimize(cost, x).fun for x in starts)
        assert best >= 1 - 1e-7
        assert best == pytest.approx(1, abs=1e-4)

    def test_residual_is_what_is_left(self, rng, d, mode):
        p, q, *_ = random_case(rng, d, mode, noise=0.2)
        a = am.align(p, q, mode)
        left = ((p - a.apply(q)) ** 2).sum()
        assert a.residual == pytest.approx(left)
        assert a.rmse == pytest.approx(np.sqrt(left / len(p)))


@pytest.mark.parametrize("seed", range(20))
def test_closed_form_and_svd_agree_in_the_plane(seed):
    rng = np.random.default_rng(seed)
    K = rng.normal(size=(2, 2))
    R, A = _planar_rotation(K)
    R_svd, _, free = _rotation(K)
    assert np.allclose(R, R_svd)
    assert free == pytest.approx(A)
    assert np.trace(R.T @ K) == pytest.approx(A)


@pytest.mark.parametrize("d", [2, 3])
@pytest.mark.parametrize("with_scale", [False, True])
@pytest.mark.parametrize("seed", range(20))
def test_agrees_with_evo(d, with_scale, seed):
    rng = np.random.default_rng(seed)
    p, q = rng.normal(size=(2, 30, d))
    a = am.align(p, q, "similarity" if with_scale else "rigid")
    R, t, s = geometry.umeyama_alignment(q.T, p.T, with_scale)
    assert np.allclose(a.rotation, R, atol=1e-9)
    assert np.allclose(a.translation, t, atol=1e-9)
    assert a.scale == pytest.approx(s, rel=1e-9)


@pytest.mark.parametrize("seed", range(20))
def test_agrees_with_scipy(seed):
    rng = np.random.default_rng(seed)
    p, q, *_ = random_case(rng, 3, "rigid", noise=0.2)
    R, rssd = Rotation.align_vectors(p - p.mean(0), q - q.mean(0))
    a = am.align(p, q)
    assert np.allclose(a.rotation, R.as_matrix(), atol=1e-9)
    assert np.sqrt(a.residual) == pytest.approx(rssd)


class TestAlignment:
    def test_poses_and_positions_give_the_same(self, rng):
        X = am.planar_poses(rng.normal(size=(9, 2)), rng.normal(size=9))
        Y = am.planar_poses(rng.normal(size=(9, 2)), rng.normal(size=9))
        a, b = am.align(X, Y), am.align(am.positions(X), am.positions(Y))
        assert a.residual == b.residual

    def test_apply_moves_poses_and_scales_only_positions(self, rng):
        q = Rotation.random(9, rng=rng).as_quat()
        Y = am.spatial_poses(rng.normal(size=(9, 3)), q)
        G = am.spatial_poses([[1, 2, 3]], Rotation.random(1, rng=rng).as_quat())[0]
        X = G @ Y
        X[:, :3, 3] *= 2.0
        a = am.align(X, Y, "similarity")
        assert a.scale == pytest.approx(2)
        moved = a.apply(Y)
        assert np.allclose(moved, X, atol=1e-12)
        assert np.allclose(am.rotation_angle(am.relative(moved, X)), 0, atol=1e-12)

    def test_none_changes_nothing(self, rng):
        p, q = rng.normal(size=(2, 5, 3))
        a = am.align(p, q, "none")
        assert np.array_equal(a.apply(q), q)
        assert a.residual == pytest.approx(((p - q) ** 2).sum())
        assert am.align([[1, 2]], [[1, 3]], "none").rmse == 1.0

    def test_angle(self):
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])
        back = Rotation.from_euler("z", -2.0).as_matrix()
        assert am.align(square @ back.T, square, "yaw").angle == pytest.approx(-2)
        assert am.align(square @ back.T, square).angle == pytest.approx(2)
        flat = square[:, :2]
        assert am.align(flat @ back[:2, :2].T, flat).angle == pytest.approx(-2)

    def test_repr_says_how(self):
        p = np.array([[0, 0], [4, 0], [4, 2.0]])
        a = am.align(p, p + [1, 0])
        expected = (
            "Alignment(rigid 2-D, n=3, angle=0 deg, translation=(-1, 0) m, scale=1, rmse=0 m)"
        )
        assert repr(a) == expected
        assert "<td>rigid 2-D</td>" in a._repr_html_()

    def test_inputs_are_not_changed(self, rng):
        X = am.planar_poses(rng.normal(size=(9, 2)), rng.normal(size=9))
        Y = X.copy()
        am.align(X, Y, "similarity").apply(Y)
        assert np.array_equal(X, Y)

    def test_map_coordinates_keep_their_digits(self, rng):
        q = rng.normal(size=(10_000, 2))
        R = random_rotation(rng, 2)
        a = am.align(q @ R.T + [5e6, 4e6], q)
        assert np.abs(a.rotation - R).max() < 1e-11
        assert np.abs(a.translation - [5e6, 4e6]).max() < 2e-9

    def test_apply_refuses_the_wrong_dimension(self):
        a = am.align(np.eye(3)[:, :2], np.eye(3)[:, :2])
        with pytest.raises(am.AmrError, match="estimate is 3-D, but the alignment was made in 2-D"):
            a.apply(np.eye(3))


def corridor(rng, length, n, noise, both):
    line = np.outer(np.linspace(0, length, n), [0.6, 0.8, 0.0])
    p = line + both * noise * rng.normal(size=line.shape)
    R = random_rotation(rng, 3)
    return p, (line + noise * rng.normal(size=line.shape)) @ R, R


class TestDegenerate:
    @pytest.mark.parametrize("both", [0, 1])
    @pytest.mark.parametrize(("length", "n"), [(10, 100), (100, 20), (100, 1000), (1000, 5000)])
    @pytest.mark.parametrize("seed", range(5))
    def test_straight_corridor_with_millimeter_noise(self, length, n, both, seed):
        p, q, _ = corridor(np.random.default_rng(seed), length, n, 1e-3, both)
        with pytest.raises(am.DegenerateAlignmentError, match="straight line") as caught:
            am.align(p, q)
        assert caught.value.motion == "the rotation about the direction (0.60, 0.80, 0.00)"

    def test_evo_accepts_that_corridor_and_lets_noise_choose_the_roll(self, rng):
        errors = []
        for _ in range(20):
            p, q, R = corridor(rng, 100, 1000, 1e-3, both=1)
            found = geometry.umeyama_alignment(q.T, p.T)[0]
            errors.append(Rotation.from_matrix(found @ R.T).magnitude())
        assert np.degrees(np.median(errors)) > 30

    def test_a_gently_winding_road_is_accepted(self, rng):
        s = np.linspace(0, 1, 500)
        p = np.c_[1000 * s, 0.5 * np.sin(20 * s), 0.2 * np.cos(9 * s)]
        R = random_rotation(rng, 3)
        a = am.align(p, p @ R + 0.02 * rng.normal(size=p.shape))
        assert Rotation.from_matrix(a.rotation @ R.T).magnitude() < 0.02

    def test_a_nanometer_loop_is_accepted(self, rng):
        angle = np.linspace(0, 6, 50)
        p = 1e-9 * np.c_[np.cos(angle), np.sin(angle), 0 * angle]
        R = random_rotation(rng, 3)
        assert np.allclose(am.align(p, p @ R).rotation, R, atol=1e-9)

    CASES = {
        "one point": ([[1, 2]], [[3, 4]], "rigid", "reference is a single position", "any"),
        "all equal": ([[1, 2]] * 3, [[1, 2], [2, 3], [5, 1]], "rigid", "3 positions that", "any"),
        "all equal, far": (
            np.full((5, 3), 4e6) + 1e-9 * np.eye(5, 3),
            np.eye(5, 3),
            "rigid",
            "coincide",
            "any rotation",
        ),
        "estimate equal": ([[1, 2], [2, 3]], [[1, 2]] * 2, "similarity", "estimate is 2", "any"),
        "line in space": (
            np.outer(range(5), [0, 0, 1]),
            np.outer(range(5), [0, 1, 0]),
            "rigid",
            "straight line",
            r"direction \(0.00, 0.00, 1.00\)",
        ),
        "mirrored isotropic cloud": (
            [[1, 0], [0, 1], [-1, 0], [0, -1]],
            [[1, 0], [0, -1], [-1, 0], [0, 1]],
            "rigid",
            "mirrors",
            "the rotation angle",
        ),
        "mirrored octahedron": (
            np.vstack([np.eye(3), -np.eye(3)]),
            np.vstack([np.eye(3), -np.eye(3)]) * [1, 1, -1],
            "rigid",
            "mirrors",
            "rotation about",
        ),
        "elevator": (
            np.outer(range(5), [0, 0, 1]),
            np.outer(range(5), [0, 0, 1]),
            "yaw",
            "vertical line",
            "yaw",
        ),
    }

    @pytest.mark.parametrize("case", CASES)
    def test_names_the_motion(self, case):
        p, q, mode, message, motion = self.CASES[case]
        with pytest.raises(am.DegenerateAlignmentError, match=message) as caught:
            am.align(p, q, mode)
        assert re.search(motion, caught.value.motion)

    def test_a_straight_line_is_enough_in_the_plane(self):
        p = np.outer(range(5), [1, 2])
        assert am.align(p, p[:, ::-1] * [1, -1]).rmse == pytest.approx(0, abs=1e-12)

    def test_the_error_survives_a_trip_between_processes(self):
        error = am.DegenerateAlignmentError("message", "motion")
        for twin in (copy.copy(error), pickle.loads(pickle.dumps(error))):
            assert (str(twin), twin.motion) == ("message", "motion")


class TestRefused:
    SQUARE = np.array([[0, 0], [1, 0], [1, 1.0]])
    CASES = {
        "nan": ([[0, np.nan], [1, 0], [1, 1]], SQUARE, "rigid", r"reference\[0, 1\] is nan"),
        "inf": (SQUARE, SQUARE + np.inf, "rigid", r"estimate\[0, 0\] is inf"),
        "lengths": (SQUARE, SQUARE[:2], "rigid", "reference has 3 samples and estimate has 2"),
        "dimensions": (SQUARE, np.eye(3), "rigid", "reference is 2-D and estimate is 3-D"),
        "shape": (np.zeros((3, 4)), SQUARE, "rigid", r"reference has shape \(3, 4\)"),
        "no matrix": (np.zeros((3, 2, 5)), SQUARE, "rigid", r"shape \(3, 2, 5\)"),
        "empty": (np.zeros((0, 2)), np.zeros((0, 2)), "rigid", "reference is empty"),
        "text": ("abc", SQUARE, "rigid", "real numbers"),
        "nothing": (None, SQUARE, "rigid", "real numbers"),
        "ragged": ([[1, 2], [3]], SQUARE, "rigid", "different lengths"),
        "huge": (SQUARE * 1e200, SQUARE, "rigid", "cannot be squared"),
        "mode": (SQUARE, SQUARE, "se3", "mode is 'se3'; expected one of 'rigid'"),
    }

    @pytest.mark.parametrize("case", CASES)
    def test_with_a_message(self, case):
        p, q, mode, message = self.CASES[case]
        with pytest.raises(am.AmrError, match=message):
            am.align(p, q, mode)
