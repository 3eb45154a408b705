"""A likely cause is named when it is the cause, and never when it is not."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import amrmetrics as am
from amrmetrics.command import _body

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


@pytest.mark.parametrize("align", ["rigid", "similarity", "yaw", "none"])
@pytest.mark.parametrize("d", [2, 3])
def test_a_lever_arm_is_named_and_its_advice_works(align, d):
    X = flight()
    offset = [1.2, -0.7, 0.9]
    body = am.spatial_poses([offset], [Rotation.from_euler("z", 0.06).as_quat()])[0]
    Y = noisy(X @ body)
    if d == 2:
        X, Y = am.project(X), am.project(X @ body)
        offset = offset[:2]
        Y[:, :2, 2] = am.positions(X) + X[:, :2, :2] @ offset
    Y = moved(Y) if align in ("rigid", "similarity") and d == 3 else Y
    before = am.ate(X, Y, align)
    (found,) = before.notes
    assert "a lever arm" in found
    said = [float(x) for x in found.split("lies at (")[1].split(")")[0].split(",")]
    assert said == pytest.approx(offset, abs=0.01)
    after = am.ate(X, Y, align, body=am.lever_arm(X, Y, align).body)
    assert after.rmse < 0.2 * before.rmse
    assert after.notes == ()
    text = found.split('--body "')[1].split('"')[0]
    assert am.ate(X, Y, align, body=_body(text)).rmse < 0.2 * before.rmse
    given = np.eye(d + 1)
    given[:d, d] = 0.1
    (more,) = am.evaluate(*(am.Trajectory(T, x) for x in (X, Y)), align=align, body=given).notes
    assert "body=body @ arm.body" in more
    text = more.split('--body "')[1].split('"')[0]
    assert am.ate(X, Y, align, body=_body(text)).rmse < 0.2 * before.rmse
    (positions_only,) = am.ate(X, am.positions(Y), align).notes
    assert positions_only.endswith("(see lever_arm)")


@pytest.mark.parametrize("seed", range(4))
def test_half_a_lever_arm_is_none(seed):
    """A point that is elsewhere in the second half only, or that wanders, is no constant one."""
    X = flight(seed)
    Y = X @ am.spatial_poses([[1.2, -0.7, 0.9]], [[0, 0, 0, 1]])
    late = (np.arange(len(X)) > 300)[:, None, None]
    assert not any("lever" in x for x in notes(X, np.where(late, Y, X)))
    assert not any("lever" in x for x in notes(X, np.where(late, X, Y)))
    wander = X.copy()
    wander[:, :3, 3] += 0.03 * np.cumsum(np.random.default_rng(seed).normal(size=(600, 3)), axis=0)
    assert not any("lever" in x for x in notes(X, wander))


@pytest.mark.parametrize("bend", [0, 0.005, 0.02])
@pytest.mark.parametrize("slope", [0.05, 0.2, 0.4])
def test_a_height_that_drifts_is_neither_a_tilt_nor_a_scale(bend, slope):
    """Along a nearly straight path all three are alike, and none is named."""
    rng = np.random.default_rng(5)
    yaw = np.cumsum(bend * rng.normal(size=len(T)))
    speed = 1 + 0.3 * np.sin(T / 5)
    p = np.cumsum(0.1 * np.c_[speed * np.cos(yaw), speed * np.sin(yaw), 0 * T], axis=0)
    p += 0.05 * np.c_[np.sin(T / 2), np.cos(T / 2), np.sin(T / 3)]
    way = np.linalg.norm(np.diff(p, axis=0, prepend=p[:1]), axis=1).cumsum()
    for drift in (way, way[-1] * T / T[-1]):
        q = p + np.outer(slope * drift, [0, 0, 1]) + 0.003 * rng.normal(size=p.shape)
        for align in ("rigid", "yaw", "none"):
            turned = TURN.apply(q) if align == "rigid" else q
            assert notes(p, turned, align, stamped=True) == ()
    # Where the path turns back, a tilt and a scale are what they are.
    p = am.positions(flight())
    tilted = Rotation.from_euler("xyz", [0.15, 0.1, 0]).apply(p)
    assert "the world frames differ, turned by" in notes(p, tilted, "yaw", stamped=True)[0]
    assert "scaled by 0.8333" in notes(p, 1.2 * p, stamped=True)[0]


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


@pytest.mark.parametrize(("by", "order"), [(1, "qw qx qy qz"), (-1, "qx qy qz qw")])
def test_a_quaternion_with_the_scalar_in_the_wrong_place(by, order):
    X, Y = flight(), noisy(moved(flight()))
    q = Rotation.from_matrix(Y[:, :3, :3]).as_quat()
    wrong = np.array(Y)
    wrong[:, :3, :3] = Rotation.from_quat(np.roll(q, by, axis=1)).as_matrix()
    why = "the scalar was taken from the wrong column (see columns=, --columns)"
    for name, pair in (("estimate", (X, wrong)), ("reference", (wrong, X))):
        found = f"the {name}'s quaternions, read as {order}, fit to 0.5 deg: {why}"
        assert notes(*pair) == (found,)
    # In one world frame, the numbers do not tell which of the two it is.
    q = Rotation.from_matrix(X[:, :3, :3]).as_quat()
    wrong = am.spatial_poses(am.positions(noisy(X)), np.roll(q, by, axis=1))
    (said,) = notes(X, wrong)
    assert said.startswith(f"the estimate's quaternions, read as {order}, fit to ")
    assert " or the reference's quaternions, read as q" in said


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
    assert "with +1.3 s added to the offset of match (--offset)" in found[0]
    offset = float(found[0].split("with ")[1].split(" ")[0])
    run = am.Trajectory(T[20:-20], late)
    pair = am.match(am.Trajectory(T, X), run, offset=offset, interpolate=True)
    assert am.ate(*pair).rmse < 0.02
    # What is said is added to an offset that was given, and the sum is right.
    shifted = am.Trajectory(run.stamps - 7, late)
    (said,) = am.evaluate(am.Trajectory(T, X), shifted, offset=7).notes
    more = float(said.split("with ")[1].split(" ")[0])
    assert am.evaluate(am.Trajectory(T, X), shifted, offset=7 + more).ate.rmse < 0.05


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


class TestEdges:
    """What is a little less than a rule asks for is not named, a little more is."""

    P = am.positions(flight())
    SIZE = float(np.sqrt(((P - P.mean(axis=0)) ** 2).sum(axis=1).mean()))

    def noise(self, seed=2):
        """Return noise of root mean square 1 that turns, shifts and scales nothing."""
        rng = np.random.default_rng(seed)
        e = rng.normal(size=self.P.shape)
        centered = self.P - self.P.mean(axis=0)
        alike = [centered.ravel(), *(np.cross(axis, centered).ravel() for axis in np.eye(3))]
        alike += [np.tile(axis, len(e)) for axis in np.eye(3)]
        columns = np.transpose(alike)
        e -= (columns @ np.linalg.lstsq(columns, e.ravel())[0]).reshape(e.shape)
        return e / np.sqrt((e**2).sum(axis=1).mean())

    @pytest.mark.parametrize(("more", "named"), [(0.0097, 0), (0.0103, 1)])
    def test_an_error_of_a_hundredth_is_large(self, more, named):
        assert len(notes(self.P, (1 + more) * self.P)) == named

    @pytest.mark.parametrize(("n", "named"), [(9, 0), (10, 1)])
    def test_ten_poses_are_enough(self, n, named):
        p = self.P[:: len(self.P) // n][:n]
        assert len(notes(p, 2 * p)) == named
        X = flight()[:: 600 // n][:n]
        Y = X @ am.spatial_poses([[0, 0, 0]], [TURN.as_quat()])[0]
        assert len(notes(X, Y)) == named

    @pytest.mark.parametrize(("left", "named"), [(0.19, 1), (0.21, 0)])
    def test_four_fifths_have_to_go(self, left, named):
        amount = left * 0.2 * self.SIZE / np.sqrt(1 - left**2)
        q = 1.2 * (self.P + amount * self.noise())
        fitted, before = am.align(self.P, q, "similarity").rmse, am.align(self.P, q).rmse
        assert fitted / before == pytest.approx(left, abs=0.008)
        assert len(notes(self.P, q)) == named

    @pytest.mark.parametrize(("left", "named"), [(0.094, 1), (0.106, 0)])
    def test_little_has_to_be_left_against_the_path(self, left, named):
        q = 3 * (self.P + left * self.SIZE * self.noise())
        assert am.align(self.P, q, "similarity").rmse == pytest.approx(left * self.SIZE, rel=0.02)
        assert len(notes(self.P, q)) == named

    @pytest.mark.parametrize(("left", "named"), [(0.45, 1), (0.55, 0)])
    def test_half_has_to_go_by_a_clock_offset(self, left, named):
        late = am.interpolate(am.Trajectory(T, flight()), T[20:-20] + 0.5).positions
        off = am.align(self.P[20:-20], late).rmse
        late += left * off / np.sqrt(1 - left**2) * self.noise()[20:-20]
        found = am.ate(*(am.Trajectory(T[20:-20], x) for x in (self.P[20:-20], late))).notes
        assert len(found) == named

    @pytest.mark.parametrize(("scale", "named"), [(1.9, 0), (2.1, 1), (1 / 1.9, 0), (1 / 2.1, 1)])
    def test_a_factor_of_two_is_far(self, scale, named):
        assert len(notes(self.P, self.P / scale, "similarity")) == named

    @pytest.mark.parametrize(("degrees", "named"), [(4.9, 0), (5.1, 1)])
    def test_five_degrees_are_large(self, degrees, named):
        body = Rotation.from_rotvec([0, 0, np.radians(degrees)]).as_quat()
        tumbling = Rotation.random(len(T), rng=np.random.default_rng(4)).as_quat()
        X = am.spatial_poses(self.P, tumbling)  # no turn of the world does the same
        assert len(notes(X, X @ am.spatial_poses([[0, 0, 0]], [body])[0])) == named

    @pytest.mark.parametrize(("degrees", "named"), [(9, 1), (11, 0)])
    def test_ten_degrees_may_be_left_of_a_turn(self, degrees, named):
        X = flight()
        body = am.spatial_poses([[0, 0, 0]], [Rotation.from_rotvec([0, 0, 2]).as_quat()])[0]
        axes = np.random.default_rng(3).normal(size=(len(X), 3))
        axes *= np.radians(degrees) / np.linalg.norm(axes, axis=1)[:, None]
        Y = X @ body
        Y[:, :3, :3] = Y[:, :3, :3] @ Rotation.from_rotvec(axes).as_matrix()
        assert len(notes(X, Y)) == named

    @pytest.mark.parametrize(("turn", "named"), [(1e-7, 1), (1e-5, 0)])
    def test_equal_orientations_are_equal(self, turn, named):
        X = am.spatial_poses(self.P, np.tile([0, 0, 0, 1], (len(T), 1)))
        X[300:] = X[300:] @ am.spatial_poses([[0, 0, 0]], [[0, 0, turn / 2, 1]])[0]
        assert len(notes(X, X)) == named

    @pytest.mark.parametrize(("bend", "named"), [(0.0005, 0), (0.002, 1)])
    def test_a_straight_path_may_keep_its_orientation(self, bend, named):
        side = bend * np.std(T) * np.sign(np.sin(T))
        X = am.planar_poses(np.c_[T, side], 0 * T)
        assert len(notes(X, X, "none")) == named
