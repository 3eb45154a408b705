"""A likely cause is named when it is the cause, and never when it is not."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import amrmetrics as am

T = np.arange(0, 60, 0.1)
TURN = Rotation.from_euler("xyz", [40, -70, 130], degrees=True)


def flight(seed=0):
    """Return a path that turns about all axes, as seen by who flies it."""
    rng = np.random.default_rng(seed)
    waves = rng.normal(size=(3, 6)) @ np.sin(np.outer(rng.uniform(0.05, 0.5, 6), T))
    turns = Rotation.from_rotvec(
        0.7 * (rng.normal(size=(3, 5)) @ np.sin(np.outer(range(1, 6), T / 9))).T
    )
    return am.spatial_poses(3 * waves.T, turns.as_quat())


def noisy(X, seed=1, size=0.01, angle=0.005):
    rng = np.random.default_rng(seed)
    q = Rotation.from_rotvec(angle * rng.normal(size=(len(X), 3))).as_quat()
    return X @ am.spatial_poses(size * rng.normal(size=(len(X), 3)), q)


def notes(X, Y, align="rigid", stamped=False):
    if stamped:
        X, Y = am.Trajectory(T[: len(X)], X), am.Trajectory(T[: len(Y)], Y)
    return am.ate(X, Y, align).notes


def moved(X):
    """Return a trajectory in another world frame."""
    return am.spatial_poses([[3, -2, 5]], [TURN.as_quat()]) @ X


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("align", ["rigid", "similarity"])
def test_a_good_run_and_a_bad_one_have_no_cause(seed, align):
    X = flight(seed)
    assert notes(X, noisy(moved(X), seed), align, stamped=True) == ()
    drift = np.cumsum(np.random.default_rng(seed).normal(0, 0.15, size=(len(X), 3)), axis=0)
    Y = moved(X)
    Y[:, :3, 3] += drift
    found = notes(X, Y, align, stamped=True)
    assert am.ate(X, Y, align).rmse > 0.3
    assert not any("mirrored" in x or "inverse" in x or "frames" in x for x in found), found


def shapes(rng, n):
    """Return paths that are easy to take for something else, and rotations along them."""
    t = np.linspace(0, 0.2 * n, n)
    turn = np.cumsum(rng.normal(size=n)) * 0.03
    steps = np.diff(t, prepend=0)[:, None]
    drive = np.cumsum(np.c_[np.cos(turn), np.sin(turn), 0 * turn] * steps, axis=0)
    about_z = Rotation.from_rotvec(np.c_[0 * t, 0 * t, turn])
    tumble = Rotation.from_rotvec(np.cumsum(0.05 * rng.normal(size=(n, 3)), axis=0))
    straight = np.c_[t, 0 * t, 0 * t]
    return {
        "drive": (drive, about_z),
        "line": (straight + 0.01 * rng.normal(size=(n, 3)), about_z),
        "circle": (
            np.c_[5 * np.cos(t / 5), 5 * np.sin(t / 5), 0 * t],
            Rotation.from_rotvec(np.c_[0 * t, 0 * t, t / 5]),
        ),
        "walk": (np.cumsum(rng.normal(size=(n, 3)), axis=0), tumble),
        "noise": (rng.normal(size=(n, 3)), tumble),
        "still": (1e-3 * rng.normal(size=(n, 3)), tumble),
    }


def faults(rng, p, R):
    """Return estimates that are bad for no reason that a note names."""
    n, size = len(p), np.sqrt(((p - p.mean(axis=0)) ** 2).sum(axis=1).mean())
    small = Rotation.from_rotvec(0.02 * rng.normal(size=(n, 3)))
    wander = np.cumsum(rng.normal(size=p.shape), axis=0)
    k = n // 2
    after = (np.arange(n) >= k)[:, None]
    steps = np.diff(p, axis=0, prepend=p[:1])
    off = Rotation.from_rotvec(np.c_[np.zeros((n, 2)), np.cumsum(0.03 * rng.normal(size=n))])
    return {
        "good": (p + 0.002 * size * rng.normal(size=p.shape), small * R),
        "noisy": (p + 0.1 * size * rng.normal(size=p.shape), small * R),
        "drift": (p + 0.3 * size * wander / np.abs(wander).max(), R),
        "heading": (p[0] + np.cumsum(off.apply(steps), axis=0), off * R),
        "unrelated": (0.2 * size * wander, Rotation.from_rotvec(0.1 * wander)),
        "noise": (size * rng.normal(size=p.shape), Rotation.random(n, random_state=n)),
        "jump": (p + after * rng.normal(size=3) * size, R),
        "stuck": (np.where(after, p[k], p), R),
        "lost": (p + after * (np.arange(n) - k)[:, None] * size / n, R),
    }


@pytest.mark.parametrize("align", ["rigid", "similarity", "yaw", "origin"])
@pytest.mark.parametrize("n", [5, 12, 60])
def test_no_cause_where_there_is_none(n, align):
    """Other frames of the world are aligned away; the rest is drift, noise or a lost track."""
    said, tried = [], 0
    for seed in range(5):
        rng = np.random.default_rng(seed)
        t = np.linspace(0, 0.2 * n, n)
        for path, (p, R) in shapes(rng, n).items():
            for fault, (q, S) in faults(rng, p, R).items():
                X, Y = (am.spatial_poses(x, r.as_quat()) for x, r in ((p, R), (q, S)))
                for A, B in ((X, Y), (am.project(X), am.project(Y))):
                    try:
                        found = am.ate(am.Trajectory(t, A), am.Trajectory(t, B), align).notes
                    except am.DegenerateAlignmentError:
                        continue
                    tried += 1
                    said += [(path, fault, x) for x in found if "similarity scaled" not in x]
    assert tried > 300
    assert len(said) <= tried / 250, said


def test_a_shifted_world_is_neither_late_nor_inverse():
    """Along a straight corridor a shift in space looks like one in time."""
    X = am.spatial_poses(np.c_[T, 0 * T, 0 * T], np.tile([0, 0, 0, 1], (len(T), 1)))
    Y = X.copy()
    Y[:, 0, 3] += 1
    assert notes(X, Y, "none", stamped=True) == ()
    p = am.positions(flight())
    found = notes(p, p + [5, 0, 0], "none", stamped=True)
    assert len(found) == 1
    assert "the world frames differ, turned by 0 deg and shifted by (-5, 0, 0) m" in found[0]


def test_a_turned_world_is_no_other_body():
    t = T[:400]
    yaw = 0.2 * np.sin(t / 3)
    X = am.planar_poses(np.c_[t, 3 * np.sin(t / 4)], yaw)
    found = notes(X, am.planar_poses([[0, 0]], [0.7]) @ X, "none")
    assert len(found) == 1
    assert "turned by 40.107 deg" in found[0]


def test_another_body_frame_where_little_turns():
    """Steady orientations, transposed, are as steady: they are not the inverse ones."""
    t = T[:400]
    X = am.planar_poses(np.c_[t, 3 * np.sin(t / 4)], 0.05 * np.sin(t / 3))
    found = notes(X, X @ am.planar_poses([[0, 0]], [1.0]))
    assert len(found) == 1
    assert "the same 57.3 deg" in found[0]


def test_straight_path_may_keep_its_orientation():
    X = am.planar_poses(np.c_[T, 0 * T], 0 * T)
    rng = np.random.default_rng(0)
    Y = am.planar_poses(np.c_[T, 0 * T] + 0.1 * rng.normal(size=(len(T), 2)), 0 * T + 0.01)
    assert not any("all orientations of the reference" in x for x in notes(X, Y))


def test_another_body_frame():
    X = flight()
    body = am.spatial_poses([[0, 0, 0]], [Rotation.from_rotvec([0, 0, 2.32]).as_quat()])[0]
    found = notes(X, noisy(moved(X)) @ body)
    assert len(found) == 1
    assert "the same 133 deg" in found[0]
    Y = moved(X) @ body
    assert am.ate(X, Y, body=np.linalg.inv(body)).rotation.rmse < 1e-9
    assert am.ate(X, Y, body=np.linalg.inv(body)).notes == ()


def test_a_lever_arm_is_undone_by_body():
    X = flight()
    body = am.spatial_poses([[0.3, -0.5, 0.2]], [TURN.as_quat()])[0]
    Y = X @ np.linalg.inv(body)
    assert am.ate(X, Y).rmse > 0.05
    assert am.ate(X, Y, body=body).rmse < 1e-9
    assert am.rpe(X, Y, body=body).rotation.rmse < 1e-9
    assert am.segment_drift(X, Y, [5], body=body).translation_percent < 1e-7
    assert am.drift_rate(X, Y, body=body).rate < 1e-9


def test_world_to_body_poses():
    X = flight()
    found = notes(X, am.inverse(noisy(moved(X))))
    assert any("the inverse poses fit to 0.0" in x for x in found), found


def test_world_to_body_rotations_alone():
    X, Y = flight(), noisy(flight())
    Y[:, :3, :3] = Y[:, :3, :3].swapaxes(1, 2)
    found = notes(X, Y)
    assert len(found) == 1
    assert "the inverse rotations fit" in found[0]


def test_a_left_handed_frame():
    X = flight()
    p = am.positions(X)
    for flip in ([1, 1, -1], [-1, 1, 1]):
        found = notes(p, p * flip)
        assert len(found) == 1
        assert "mirrored estimate fits to" in found[0]
    found = notes(p, p[:, [1, 0, 2]])
    assert "two axes swapped" in found[0]
    q = p[:, :2]
    assert "mirrored" in notes(q, q * [1, -1])[0]


def test_swapped_axes_where_nothing_turns():
    X = am.positions(flight())
    found = notes(X, X[:, [2, 0, 1]], "none")
    assert len(found) == 1
    assert "the estimate's x, y, z are the reference's z, x, y" in found[0]
    found = notes(X, TURN.apply(X), "yaw")
    assert "the world frames differ, turned by 74.851 deg" in found[0]


def test_a_scale():
    X = am.positions(flight())
    found = notes(X, X / 3.281)
    assert len(found) == 1
    assert "scaled by 3.281, the estimate fits to" in found[0]
    found = notes(X, X / 3.281, "similarity")
    assert found == ("the similarity scaled the estimate by 3.28",)
    noise = np.random.default_rng(0).normal(size=X.shape)
    assert "the similarity scaled the estimate by" in notes(X, 1e3 * noise, "similarity")[0]
    assert notes(X, X / 1.9, "similarity") == ()


def test_a_clock_offset():
    X = flight()
    late = am.interpolate(T, X, T[20:-20] + 1.3, max_gap=1)
    reference = am.Trajectory(T[20:-20], X[20:-20])
    found = am.ate(reference, am.Trajectory(T[20:-20], late)).notes
    assert len(found) == 1
    assert "with offset=1.3 s in match (--offset)" in found[0]
    offset = float(found[0].split("offset=")[1].split(" ")[0])
    run = am.Trajectory(T[20:-20], late)
    pair = am.match(am.Trajectory(T, X), run, offset=offset, interpolate=True)
    assert am.ate(*pair).rmse < 0.02


def test_equal_orientations():
    X = flight()
    padded = am.spatial_poses(am.positions(X), np.tile([0, 0, 0, 1], (len(X), 1)))
    for pair, who in (((padded, X), "reference"), ((X, padded), "estimate")):
        found = notes(*pair)
        assert len(found) == 1
        assert f"all orientations of the {who} are equal although it moves" in found[0]
    still = np.tile(np.eye(4), (9, 1, 1))
    assert notes(still, still, "none") == ()


def test_changed_arrays_are_noticed():
    X = flight()
    Y = noisy(X)
    error = am.ate(X, Y)
    Y[:, :3, :3] = np.eye(3)
    with pytest.raises(am.AmrError, match="changed in place after ate"):
        _ = error.rotation
    with pytest.raises(am.AmrError, match="changed in place after ate"):
        _ = error.notes
