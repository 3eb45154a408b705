"""Why an ATE is large: common mistakes, each tested by undoing it (lecture 03).

A cause is named only if undoing it takes away four fifths of the error (half of it, for a clock
offset), compared with an estimate that may turn freely, and if little is left against the path.
"""

import numpy as np

from amrmetrics.alignment import fit, nearest_rotation
from amrmetrics.errors import AmrError
from amrmetrics.extrinsics import solve
from amrmetrics.pairs import orientation_errors
from amrmetrics.poses import angle_of, inverse, positions
from amrmetrics.stamps import as_gap, between_samples, in_gap

# An ATE below this part of the size of the path is not large, nor a rotation error below this.
LARGE = 0.01
LARGE_ANGLE = np.radians(5)
# What undoing a mistake may leave of an error at most. Drift, too, is often halved by another
# scale or by turning a path; a clock offset is told from it by the velocity.
FIFTH = 0.2
HALF = 0.5
# What it may leave at most, as a part of the size of the path and as an angle: an estimate that
# stays far off after it was not off because of it.
FITS = 0.1
FITS_ANGLE = np.radians(10)
# What is left by rotations that the positions do not allow, as a part of the size of the path.
FAR_OFF = 0.5
# Fewer poses fit anything by chance.
ENOUGH = 10
# A similarity with a larger factor, or a smaller one than its inverse, was no small correction.
FAR_SCALE = 2.0
# Orientations that agree to this are the same, radians.
SAME_ANGLE = 1e-6
# A path with less motion sideways than this part of its size is straight.
STRAIGHT = 1e-3
# Axes that differ by less are called the same in the words of a note.
ALONG = np.cos(np.radians(10))
# Slope of the steepest drift in height that is tried, and parts of it.
STEEPEST = 0.5
SLOPES = np.linspace(-1, 1, 41)
# Samples that a drift, and a lever arm, is found from.
SOME, MANY = 1000, 10_000
# Steps of the search for a clock offset.
STEPS = 20


def likely_causes(summary):
    """Return sentences, one for each mistake that explains most of the error."""
    X, Y = summary.compared.pair
    p, q = (x if x.ndim == 2 else x[:, :-1, -1].copy() for x in (X, Y))
    notes = []
    size = _size(p)
    scale = summary.alignment.scale
    if not 1 / FAR_SCALE < scale < FAR_SCALE:
        notes.append(f"the similarity scaled the estimate by {scale:.3g}")
    best = _best_fit(summary, p, q)
    mirrored = None
    if summary.rmse > LARGE * size and len(p) >= ENOUGH and best:
        off = min(summary.rmse, best.rmse)
        left = min(FIFTH * off, FITS * size)
        mirrored = _mirrored(best, left, p, q)
        found = [
            mirrored,
            _other_frame(summary, best, size, p, q),
            _other_scale(summary, best, left, p, q),
            _other_point(summary, best, left, size, p, q),
            _inverse_poses(best, left, p, Y),
            _late(summary.compared.stamps, best, min(HALF * off, FITS * size), p, q),
        ]
        notes += [note for note in found if note]
    if X.ndim == Y.ndim == 3:
        notes += _about_orientations(summary, best, X, Y, size, mirrored)
    return tuple(notes)


def _size(p):
    return np.sqrt(((p - p.mean(axis=0)) ** 2).sum(axis=1).mean())


def _best_fit(summary, p, q):
    """Return the Alignment that is free to turn, at least: no mistake explains what it does."""
    mode = summary.alignment.mode
    return _fitted(p, q, "similarity" if mode == "similarity" else "rigid")


def _fitted(p, q, mode, first=None):
    try:
        return fit(p, q, mode, first)[0]
    except AmrError:
        return None


def _rest(alignment, p, q):
    return np.sqrt(((alignment.apply(q) - p) ** 2).sum(axis=1).mean())


def _mirrored(best, left, p, q):
    found = _fitted(p, q * np.r_[np.ones(q.shape[1] - 1), -1], best.mode)
    if found and found.rmse <= left:
        return (
            f"the mirrored estimate fits to {found.rmse:.3g} m: one of the two has a left-handed "
            "frame, or two axes swapped"
        )
    return None


def _other_frame(summary, best, size, p, q):
    if summary.alignment.mode not in ("none", "yaw"):
        return None
    # Frames differ from the beginning; drift does not.
    half = _fitted(p, q, "rigid", len(p) // 2)
    if not half or _rest(half, p, q) > min(FIFTH * summary.rmse, FITS * size):
        return None
    if best.rmse > HALF * _drift_in_height(summary, summary.alignment.mode, p, q):
        return None
    names, R = "xyz"[: len(best.rotation)], best.rotation
    axes = [_named(column, names) for column in R.T]
    turn = float(angle_of(R @ summary.alignment.rotation.T))
    how = f"turned by {_rounded(np.degrees(turn))} deg"
    if summary.alignment.mode == "none":
        how += f" and shifted by ({', '.join(map(_rounded, best.translation))}) m"
    if all(axes) and axes != list(names):
        how += f"; the estimate's {', '.join(names)} are the reference's {', '.join(axes)}"
    return f"a rigid alignment fits to {best.rmse:.3g} m: the world frames differ, {how}"


def _rounded(x):
    """Return millimeters, or thousandths of a degree, as text."""
    return f"{round(float(x), 3) + 0:g}"


def _named(column, names):
    """Return the axis along which a column points, such as -y, or None."""
    k = int(np.abs(column).argmax())
    return None if abs(column[k]) < ALONG else ("-" if column[k] < 0 else "") + names[k]


def _other_scale(summary, best, left, p, q):
    if best.mode == "similarity":
        return None
    found = _fitted(p, q, "similarity")
    if not found or found.rmse > left:
        return None
    if found.rmse > HALF * _drift_in_height(summary, best.mode, p, q):
        return None
    return (
        f"scaled by {found.scale:.4g}, the estimate fits to {found.rmse:.3g} m: its unit or its "
        "scale is wrong"
    )


def _drift_in_height(summary, mode, p, q):
    """Return what is left, in meters, if the height drifts with the time or with the way.

    Along a nearly straight path that looks like a tilted frame, and then like another scale.
    """
    if p.shape[1] == 2:
        return np.inf
    some = slice(None, None, max(1, len(p) // SOME))
    t, (p, q) = summary.compared.stamps, (x[some] for x in (p, q))
    way = np.linalg.norm(np.diff(p, axis=0, prepend=p[:1]), axis=1).cumsum()
    time = np.arange(len(p)) if t is None else t[some] - t[0]
    return min(_left_by_drift(way[-1] * x / x[-1], mode, p, q) for x in (time, way))


def _left_by_drift(drift, mode, p, q):
    def left(slope):
        found = _fitted(p + np.multiply.outer(slope * drift, (0, 0, 1)), q, mode)
        return found.rmse if found else np.inf

    best, width = 0.0, STEEPEST
    for _ in range(3):
        best = min(best + width * SLOPES, key=left)
        width *= SLOPES[-1] - SLOPES[-2]
    return left(best)


def _other_point(summary, best, left, size, p, q):
    """Test a lever arm on the first half of the run: drift fits there and not after it."""
    X, Y = summary.compared.pair
    if X.ndim == 2:
        return None
    some = slice(None, None, max(1, len(p) // MANY))
    try:
        oriented = Y[some] if Y.ndim == 3 else None
        arm = solve(X[some], p[some], q[some], best.mode, oriented)
        if arm.rmse > left or np.linalg.norm(arm.offset) > HALF * size:
            return None
        half = slice(None, len(p) // 2, some.step)
        first = solve(X[half], p[half], q[half], best.mode)
    except AmrError:
        return None
    if _rest(first.alignment, positions(first.apply(X)), q) > left:
        return None
    axes = ", ".join(map(_rounded, arm.offset))
    text = (
        f"the estimate's point lies at ({axes}) m in the reference's body frame, a lever arm; "
        f"without it, the estimate fits to {arm.rmse:.3g} m"
    )
    if arm.turn is None:
        return f"{text} (see lever_arm)"
    given = summary.compared.body
    if given is None:
        how, body = "body=arm.body", arm.body
    else:
        how, body = "body=body @ arm.body", given @ arm.body
    return (
        f"{text}: {how} with arm = lever_arm(reference, estimate, {best.mode!r}), --body "
        f'"{_spoken(body)}"'
    )


def _spoken(body):
    """Return a pose as the command takes it."""
    from scipy.spatial.transform import Rotation

    if len(body) == 4:
        turn = Rotation.from_matrix(body[:3, :3]).as_quat()
    else:
        turn = [np.arctan2(body[1, 0], body[0, 0])]
    return " ".join(f"{x:.6g}" for x in (*body[:-1, -1].round(4), *turn))


def _inverse_poses(best, left, p, Y):
    if Y.ndim == 2:
        return None
    found = _fitted(p, inverse(Y)[:, :-1, -1], best.mode)
    if found and found.rmse <= left:
        return f"the inverse poses fit to {found.rmse:.3g} m: one of the two maps world to body"
    return None


def _late(t, best, left, p, q):
    """Shift the estimate in time: by the least-squares step along the velocity, repeated."""
    if t is None:
        return None
    offset = 0.0
    velocity = np.gradient(p, t, axis=0)
    for _ in range(STEPS):
        inside = (t + offset >= t[0]) & (t + offset <= t[-1])
        inside &= ~in_gap(t, t + offset, as_gap(None, t))
        if inside.sum() < len(t) / 2:
            return None
        r, v = (between_samples(t, x, (t + offset)[inside]) for x in (p, velocity))
        found = _fitted(r, q[inside], best.mode)
        if not found:
            return None
        e = found.apply(q[inside]) - r
        step = float((v * e).sum() / max((v * v).sum(), np.finfo(float).tiny))
        offset += step
        if abs(step) < 1e-4 * np.median(np.diff(t)):
            break
    # The part that is left out may be the bad one: the others have to improve.
    without = _fitted(p[inside], q[inside], best.mode)
    if found.rmse > left or not without or found.rmse > HALF * without.rmse:
        return None
    return (
        f"with {offset:+.4g} s added to the offset of match (--offset), the estimate fits to "
        f"{found.rmse:.3g} m: the clocks differ"
    )


def _about_orientations(summary, best, X, Y, size, mirrored):
    same = [name for name, Z in (("reference", X), ("estimate", Y)) if _should_turn(Z)]
    if same:
        return [
            f"all orientations of the {' and of the '.join(same)} are equal although it moves: "
            "they were probably never measured, so no rotation error and no RPE means anything"
        ]
    R = best.rotation if best else summary.alignment.rotation
    before = _mean_turn(X, Y, R)
    if before < LARGE_ANGLE or len(X) < ENOUGH:
        return []
    d = len(R)
    turn = _constant_turn(X, Y, R)
    Z = np.array(Y)
    Z[:, :d, :d] = np.einsum("nij,jk->nik", Y[:, :d, :d], turn)
    rest = _mean_turn(X, Z, R)
    world = _nearest_turn(X, Y)
    by_world = _mean_turn(X, Y, world)
    inverted = np.array(Y)
    inverted[:, :d, :d] = np.swapaxes(Y[:, :d, :d], 1, 2)
    off = min(before, rest, by_world)
    left = _mean_turn(X, inverted, _nearest_turn(X, inverted))
    if off > LARGE_ANGLE and left <= min(FIFTH * off, FITS_ANGLE) and not mirrored:
        return ["the inverse rotations fit: those of one of the two turn world to body"]
    reordered = _reordered(X, Y, min(FIFTH * off, FITS_ANGLE)) if off > LARGE_ANGLE else None
    if reordered and not mirrored:
        return [reordered]
    if rest > min(HALF * before, FITS_ANGLE):
        return []
    # Another rotation of the world explains it as well, unless the positions speak against it.
    if by_world < max(rest / HALF, LARGE_ANGLE) and not (
        best and _speak_against(world, best, X, Y, size)
    ):
        return []
    return [
        f"all orientations are off by the same {np.degrees(float(angle_of(turn))):.3g} deg, to "
        f"{np.degrees(rest):.2g} deg: the two describe different frames of the body (see body=, "
        "--body)"
    ]


def _reordered(X, Y, left):
    """Test if the quaternions of one of the two were read with the scalar in the wrong place."""
    if X.shape[1] == 3:
        return None
    from scipy.spatial.transform import Rotation

    some = slice(None, None, max(1, len(X) // MANY))
    pair = {"estimate": Y[some], "reference": X[some]}
    fits = []
    for name, given in pair.items():
        q = Rotation.from_matrix(given[:, :3, :3]).as_quat()
        for order, by in (("qw qx qy qz", -1), ("qx qy qz qw", 1)):
            Z = np.array(given)
            Z[:, :3, :3] = Rotation.from_quat(np.roll(q, by, axis=1)).as_matrix()
            B, A = (pair | {name: Z}).values()
            off = _mean_turn(A, B, _nearest_turn(A, B))
            if off <= left:
                to = f"{np.degrees(off):.2g} deg"
                fits.append(f"the {name}'s quaternions, read as {order}, fit to {to}")
    if not fits:
        return None
    why = "the scalar was taken from the wrong column (see columns=, --columns)"
    return f"{' or '.join(fits)}: {why}"


def _speak_against(rotation, best, X, Y, size):
    """Say if the positions fit, and no longer do with this rotation of the world."""
    p, q = (Z[:, :-1, -1] - Z[:, :-1, -1].mean(axis=0) for Z in (X, Y))
    off = _size(p - best.scale * np.einsum("ij,nj->ni", rotation, q))
    return best.rmse < FITS * size and off > FAR_OFF * size


def _should_turn(X):
    """Say if the orientations are all the same, although the path is no straight line."""
    still = orientation_errors(X, X[:1].repeat(len(X), 0), np.eye(len(X[0]) - 1))
    p = X[:, :-1, -1] - X[:, :-1, -1].mean(axis=0)
    squares = np.linalg.eigvalsh(np.einsum("ni,nj->ij", p, p))
    return still.max() < SAME_ANGLE and squares[-2] > STRAIGHT**2 * squares[-1]


def _mean_turn(X, Y, R):
    """Return the root mean square of the angles between the orientations of X and R Y."""
    return np.sqrt((orientation_errors(X, Y, R) ** 2).mean())


def _constant_turn(X, Y, R):
    """Return the rotation of the body frame that brings R Y closest to X."""
    d = len(R)
    return nearest_rotation(np.einsum("nji,jk,nkl->il", Y[:, :d, :d], R.T, X[:, :d, :d]))


def _nearest_turn(X, Y):
    """Return the rotation of the world that brings the orientations of Y closest to X."""
    d = X.shape[1] - 1
    return nearest_rotation(np.einsum("nij,nkj->ik", X[:, :d, :d], Y[:, :d, :d]))
