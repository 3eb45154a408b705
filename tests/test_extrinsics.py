"""The lever arm is what a general optimizer finds, and refused where the motion hides it."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import amrmetrics as am

T = np.linspace(0, 60, 600)
ARM = np.array([0.3, -0.5, 0.2])
WORLD = am.spatial_poses([[3, -2, 5]], [Rotation.from_euler("xyz", [0.7, -1.2, 2.3]).as_quat()])
UPRIGHT = am.spatial_poses([[3, -2, 5]], [Rotation.from_euler("z", 2.3).as_quat()])


def flight(seed=0, angles=1.0):
    rng = np.random.default_rng(seed)
    waves = rng.normal(size=(3, 6)) @ np.sin(np.outer(rng.uniform(0.05, 0.5, 6), T))
    turns = 0.7 * rng.normal(size=(3, 5)) @ np.sin(np.outer(range(1, 6), T / 9))
    return am.spatial_poses(3 * waves.T, Rotation.from_rotvec(angles * turns.T).as_quat())


def drive(seed=0):
    return am.project(flight(seed))


def tip(X, offset, noise=0.0, seed=1):
    """Return where a point of the body is."""
    rng = np.random.default_rng(seed)
    X = np.asarray(X)
    return (
        am.positions(X)
        + X[:, :-1, :-1] @ offset
        + noise * rng.normal(size=(len(X), X.shape[1] - 1))
    )


def by_least_squares(X, q, mode):
    """Return the offset that a general optimizer finds, all unknowns at once."""
    d = X.shape[1] - 1

    def residuals(unknowns):
        offset, shift = unknowns[:d], unknowns[d : 2 * d]
        turn, scale = unknowns[2 * d :], 1.0
        if mode == "none":
            shift, turn = np.zeros(d), np.zeros(3)
        if mode == "similarity":
            turn, scale = turn[:-1], np.exp(turn[-1])
        if d == 2:
            c, s = np.cos(turn[0]), np.sin(turn[0])
            R = np.array([[c, -s], [s, c]])
        else:
            R = Rotation.from_rotvec([0, 0, turn[0]] if mode == "yaw" else turn).as_matrix()
        return (tip(X, offset) - scale * q @ R.T - shift).ravel()

    start = am.align(X, q, mode)
    if d == 2 or mode == "yaw":
        turn = [start.angle]
    else:
        turn = Rotation.from_matrix(start.rotation).as_rotvec()
    first = [*np.zeros(d), *start.translation, *turn]
    first += [np.log(start.scale)] if mode == "similarity" else []
    return least_squares(residuals, first, xtol=1e-15, ftol=1e-15, gtol=1e-15).x[:d]


@pytest.mark.parametrize("mode", ["rigid", "similarity", "yaw", "none"])
@pytest.mark.parametrize("d", [2, 3])
def test_is_what_a_general_optimizer_finds(mode, d):
    X, noise = (drive(), 0.3) if d == 2 else (flight(), 0.3)
    world = {"none": np.eye(4)[None], "yaw": UPRIGHT}.get(mode, WORLD)
    world = world if d == 3 else am.project(world)
    q = tip(world @ X, ARM[:d], noise) * (0.7 if mode == "similarity" else 1)
    arm = am.lever_arm(X, q, mode)
    assert arm.offset == pytest.approx(by_least_squares(X, q, mode), abs=1e-6)
    assert (np.abs(arm.offset - ARM[:d]) < 4 * arm.standard_error).all()
    assert arm.rmse < arm.rmse_without


@pytest.mark.parametrize("mode", ["rigid", "similarity", "yaw", "none"])
def test_is_exact_without_noise_and_undone_by_body(mode):
    X = flight()
    body = am.spatial_poses([ARM], [Rotation.from_euler("xyz", [0.2, 0.4, -0.1]).as_quat()])[0]
    Y = {"none": np.eye(4)[None], "yaw": UPRIGHT}.get(mode, WORLD) @ X @ body
    Y[:, :3, 3] *= 0.5 if mode == "similarity" else 1
    arm = am.lever_arm(X, Y, mode)
    assert arm.offset == pytest.approx(ARM, abs=1e-9)
    assert arm.rmse < 1e-9
    assert arm.rmse_without == am.ate(X, Y, mode).rmse > 0.1
    found = am.ate(X, Y, mode, body=arm.body)
    assert found.rmse < 1e-9
    assert np.array_equal(arm.body[:3, :3], np.eye(3))
    assert am.ate(arm.apply(X), Y, mode).rmse < 1e-9
    assert np.array_equal(arm.apply(X)[:, :3, :3], X[:, :3, :3])


def test_the_standard_error_is_the_scatter_of_the_offset():
    for lasting in (0.0, 0.8):
        off = []
        for seed in range(80):
            rng = np.random.default_rng(seed)
            white = rng.normal(size=(len(T), 2))
            noise = np.empty_like(white)
            noise[0] = white[0]
            for k in range(1, len(T)):
                noise[k] = lasting * noise[k - 1] + (1 - lasting**2) ** 0.5 * white[k]
            X = drive(3)
            arm = am.lever_arm(X, tip(X, ARM[:2]) + 0.1 * noise)
            off.append((arm.offset - ARM[:2]) / arm.standard_error)
        spread = np.std(off, axis=0)
        assert (spread > 0.7).all(), spread
        assert (spread < 1.6).all(), spread  # thrice, sqrt(1.8 / 0.2), if each error counted


def test_the_place_of_the_world_does_not_matter():
    X = flight()
    q = tip(X, ARM, 0.1)
    here, there = am.lever_arm(X, q), am.lever_arm(X, q + [1e4, -2e4, 5e3])
    assert there.offset == pytest.approx(here.offset, abs=1e-8)
    assert there.standard_error == pytest.approx(here.standard_error, rel=1e-6)


def test_a_prism_beside_an_estimate_with_orientations():
    """Where only the estimate has orientations, the two are exchanged."""
    X = flight()
    prism, Y = tip(X, ARM), WORLD @ X
    with pytest.raises(am.AmrError, match=r"reference has no orientations: .* exchange the two"):
        am.lever_arm(am.Trajectory(T, prism), Y)
    arm = am.lever_arm(Y, prism)
    body = np.eye(4)
    body[:3, 3] = arm.offset
    assert am.ate(prism, Y, body=body).rmse < 1e-9
    with pytest.raises(am.AmrError, match=r"arm\.apply"):
        _ = arm.body
    assert am.ate(arm.apply(Y), prism).rmse < 1e-9


def test_takes_recordings():
    truth = am.Trajectory(T, flight())
    run = am.Trajectory(T, tip(flight(), ARM))
    arm = am.lever_arm(truth, run)
    moved = arm.apply(truth)
    assert isinstance(moved, am.Trajectory)
    assert am.ate(moved, run).rmse < 1e-9
    with pytest.raises(am.AmrError, match="Match them first"):
        am.lever_arm(truth, run[:100])


def test_says_what_it_found():
    X = drive()
    arm = am.lever_arm(X, tip(X, ARM[:2], 0.01))
    assert repr(arm).startswith("lever arm: offset (0.2994 ± 0.00078, -0.4987 ± ")
    assert "alignment rigid, n 600" in repr(arm)
    assert arm.as_dict()["offset"] == arm.offset.tolist()
    assert "turn" not in arm.as_dict()


class TestRefuses:
    def test_a_robot_that_never_turns(self):
        X = flight(angles=0)
        with pytest.raises(am.DegenerateAlignmentError, match="hardly turns") as caught:
            am.lever_arm(X, tip(X, ARM))
        assert caught.value.motion == "the offset"
        known = am.lever_arm(X, tip(X, ARM), "none")  # as the message advises
        assert known.offset == pytest.approx(ARM)

    @pytest.mark.parametrize(("angle", "refused"), [(0.045, True), (0.055, False)])
    def test_small_turns(self, angle, refused):
        """Three degrees, root mean square, are where noise and turns part."""
        yaw = 2**0.5 * angle * np.sin(np.linspace(0, 20 * np.pi, len(T), endpoint=False))
        X = am.planar_poses(am.positions(drive()), yaw)
        if not refused:
            assert am.lever_arm(X, tip(X, ARM[:2])).offset == pytest.approx(ARM[:2])
            return
        with pytest.raises(am.DegenerateAlignmentError, match="hardly turns"):
            am.lever_arm(X, tip(X, ARM[:2]))

    def test_a_straight_path(self):
        X = am.planar_poses(np.c_[T, 0 * T], 0 * T)
        with pytest.raises(am.DegenerateAlignmentError, match="hardly turns"):
            am.lever_arm(X, tip(X, ARM[:2]))
        turning = am.planar_poses(np.c_[T, 0 * T], np.sin(T))
        assert am.lever_arm(turning, tip(turning, ARM[:2])).offset == pytest.approx(ARM[:2])

    def test_turns_about_one_axis(self):
        flat = drive()
        X = np.tile(np.eye(4), (len(T), 1, 1))
        X[:, :2, :2], X[:, :2, 3] = flat[:, :2, :2], flat[:, :2, 2]
        X[:, 2, 3] = np.sin(T)
        with pytest.raises(am.DegenerateAlignmentError, match="project both") as caught:
            am.lever_arm(X, tip(X, ARM))
        assert caught.value.motion == "the offset along (0.00, 0.00, 1.00) of the body"
        arm = am.lever_arm(am.project(X), tip(X, ARM)[:, :2])  # as the message advises
        assert arm.offset == pytest.approx(ARM[:2])

    def test_a_circle(self):
        """Every arm gives a circle, and turning the world makes them all alike."""
        X = am.planar_poses(np.c_[np.cos(T), np.sin(T)], T + np.pi / 2)
        for q in (tip(X, ARM[:2]), tip(X, ARM[:2], 0.01)):
            with pytest.raises(am.DegenerateAlignmentError, match="as on a circle") as caught:
                am.lever_arm(X, q)
            assert caught.value.motion.startswith("the offset along (")
        assert am.lever_arm(X, tip(X, ARM[:2]), "none").offset == pytest.approx(ARM[:2])

    def test_an_estimate_scaled_to_nothing(self):
        X = am.planar_poses(np.c_[5 * np.cos(T), 5 * np.sin(T)], T + np.pi / 2)
        q = tip(X, ARM[:2], 0.5) + np.c_[T, 0 * T]
        with pytest.raises(am.DegenerateAlignmentError, match=r"mode='rigid' if the scale"):
            am.lever_arm(X, 0.001 * q, "similarity")

    def test_a_point_that_does_not_move(self):
        X = flight()
        with pytest.raises(am.DegenerateAlignmentError, match="estimate is 600 positions that all"):
            am.lever_arm(X, np.zeros((600, 3)))

    def test_other_things(self):
        X = flight()
        with pytest.raises(am.AmrError, match="mode is 'origin'; expected one of 'rigid'"):
            am.lever_arm(X, X, "origin")
        with pytest.raises(am.AmrError, match="poses need shape"):
            am.lever_arm(am.positions(X), X)
        with pytest.raises(am.AmrError, match="Project the spatial one"):
            am.lever_arm(X, drive())
        with pytest.raises(am.AmrError, match=r"expected \(N, 4, 4\)"):
            am.lever_arm(X, tip(X, ARM)).apply(drive())
