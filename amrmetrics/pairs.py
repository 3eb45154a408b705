"""Pairs of samples a given stretch apart, and the errors of the motion between them.

Poses are worked on in blocks that stay in the processor's cache, each entry of a pose a
row of its own (as in `_arguments.in_blocks`): NumPy is several times faster on a few long
rows than on many small matrices, and no intermediate result grows with N. This is the one
place where the relative metrics get their speed.
"""

import numpy as np

from amrmetrics._arguments import as_numbers, as_stamps, blocks, lengths
from amrmetrics.errors import AmrError
from amrmetrics.poses import angle_of

UNITS = {
    "frames": "frames",
    "m": "m",
    "metres": "m",
    "meters": "m",
    "s": "s",
    "seconds": "s",
    "deg": "deg",
    "degrees": "deg",
}
TOLERANCE = 0.1
# A hair, so that ten steps of 0.1 are one whole in floating point, too.
ROUNDING = 1e-9


def find_pairs(X, delta, unit, pairs, stamps):
    """Return the pairs (2, M), what each spans, and how many were left out, for `rpe`."""
    unit = as_unit(unit)
    delta = _as_delta(delta, unit, pairs)
    if unit == "frames":
        return _frames_apart(len(X), int(delta), pairs)
    if unit == "deg" and pairs == "all":
        return _degrees_apart(X, delta)
    measure = _measure(X, unit, stamps)
    found = np.array((_chain if pairs == "consecutive" else _nearest)(measure, delta), dtype=int)
    lengths = np.diff(measure[found], axis=0)[0]
    # A sum of single turns overshoots by up to one of them, and nothing better is there.
    tolerance = np.inf if unit == "deg" else TOLERANCE + ROUNDING
    kept = np.abs(lengths - delta) <= tolerance * delta
    if not kept.any():
        raise AmrError(_no_pairs(measure, delta, unit))
    return found[:, kept], lengths[kept], int(len(kept) - kept.sum())


def as_unit(unit):
    """Return the unit of delta: "frames", "m", "s" or "deg"."""
    if unit not in UNITS:
        raise AmrError(f"unit is {unit!r}; expected one of {', '.join(map(repr, UNITS))}.")
    return UNITS[unit]


def _as_delta(delta, unit, pairs):
    if pairs not in ("all", "consecutive"):
        raise AmrError(f"pairs is {pairs!r}; expected 'all' or 'consecutive'.")
    delta = as_numbers(delta, "delta")
    if delta.ndim or delta <= 0:
        raise AmrError(f"delta is {delta}; expected one number of {unit}, greater than 0.")
    if unit == "frames" and delta != np.floor(delta):
        raise AmrError(f"delta is {delta} frames; expected a whole number.")
    if unit == "deg" and delta > 180:
        raise AmrError(f"delta is {delta} deg; a rotation angle is at most 180 degrees.")
    return float(delta)


def _frames_apart(n, delta, pairs):
    if delta >= n:
        raise AmrError(f"delta is {delta} frames, but the recording has {n} samples.")
    i = np.arange(0, n - delta, 1 if pairs == "all" else delta)
    return i + [[0], [delta]], np.broadcast_to(float(delta), len(i)), 0


def _degrees_apart(X, delta):
    """Return all pairs whose orientations differ by delta degrees within the tolerance."""
    R = _columns(X, slice(None))[:-1]
    within = (TOLERANCE + ROUNDING) * delta
    low, high = _chord(np.radians([delta - within, min(delta + within, 180)]))
    ends = []
    for i in range(len(X) - 1):
        chord = _distance(R[..., i + 1 :], R[..., i, None])
        ends.append(i + 1 + np.flatnonzero((chord >= low) & (chord <= high)))
    if not sum(map(len, ends)):
        raise AmrError(f"no two orientations are {delta:g} degrees apart, within 10 %.")
    found = np.array([np.repeat(np.arange(len(ends)), list(map(len, ends))), np.concatenate(ends)])
    return found, np.degrees(_turns(X, *found)), 0


def _measure(X, unit, stamps):
    """Return what grows along the reference: meters, seconds or degrees turned."""
    if unit == "m":
        return travelled(X)
    if unit == "deg":
        i = np.arange(len(X) - 1)
        return np.concatenate([[0], np.degrees(_turns(X, i, i + 1)).cumsum()])
    if stamps is None:
        raise AmrError("stamps are missing; unit='s' needs the time of each sample.")
    stamps = as_stamps(stamps, "stamps")
    if len(stamps) != len(X):
        raise AmrError(f"stamps has {len(stamps)} entries for {len(X)} poses; one each is needed.")
    return stamps - stamps[0]


def _nearest(measure, delta):
    """Return for each i the j whose distance is nearest to delta, the first of equals.

    Samples from which the recording does not reach delta any more begin no pair.
    """
    i = np.flatnonzero(measure[-1] - measure >= delta * (1 - ROUNDING))
    j = np.searchsorted((measure[1:] + measure[:-1]) / 2, measure[i] + delta)
    # Equals are samples where the robot stands still. A j before i comes out as too short.
    return i, np.searchsorted(measure, measure[j])


def _chain(measure, delta):
    """Return pairs end to start, each ending at the first sample that reaches delta."""
    following = np.searchsorted(measure, measure + delta * (1 - ROUNDING)).tolist()
    k, chain = 0, [0]
    while (k := following[k]) < len(following):
        chain.append(k)
    return np.array(chain[:-1], dtype=int), np.array(chain[1:], dtype=int)


def _no_pairs(measure, delta, unit):
    steps = np.diff(measure)
    if not len(steps):
        return "the trajectory has one sample; a relative error needs at least two."
    return (
        f"no pair of samples spans delta={delta:g} {unit} within {100 * TOLERANCE:g} %: the "
        f"reference covers {measure[-1]:.6g} {unit} in steps of {np.median(steps):.6g} (median) to "
        f"{steps.max():.6g}. Choose a delta of several steps and less than the whole."
    )


def travelled(X):
    """Return the length of the reference's path up to each sample, meters."""
    return np.concatenate([[0], lengths(np.diff(X[:, :-1, -1].T)).cumsum()])


def pair_errors(X, Y, i, j):
    """Return the translation and rotation errors of the pairs (i, j), meters and radians.

    E = inv(A) @ B with A and B the motions of the two trajectories, so its translation is
    as long as the difference of theirs, and it turns by the angle between their rotations.
    """
    translation, rotation = np.empty(len(i)), np.empty(len(i))
    for block in blocks(len(i)):
        (A, a), (B, b) = (_motions(P, Q) for P, Q in _columns_of_pairs((X, Y), i[block], j[block]))
        translation[block] = lengths(a - b)
        rotation[block] = _angle_between(A, B)
    return translation, rotation


def orientation_errors(X, Y, R):
    """Return the angles between the rotations of X and R times those of Y."""
    angles = np.empty(len(X))
    for block in blocks(len(X)):
        A, B = (_columns(Z, block)[:-1] for Z in (X, Y))
        angles[block] = _angle_between(A, np.einsum("ij,kjn->kin", R, B))
    return angles


def _turns(X, i, j):
    """Return the angles between the orientations i and j of X, radians."""
    turns = np.empty(len(i))
    for block in blocks(len(i)):
        ((P, Q),) = _columns_of_pairs([X], i[block], j[block])
        turns[block] = _angle_between(P[:-1], Q[:-1])
    return turns


def _motions(P, Q):
    """Return the columns of inv(P) @ Q: rotations (d, d, n) and translations (d, n)."""
    rotations = np.einsum("ikn,jkn->jin", P[:-1], Q[:-1])
    return rotations, np.einsum("ikn,kn->in", P[:-1], Q[-1] - P[-1])


def _angle_between(A, B):
    """Return the angles between rotations given by their columns, (d, d, n)."""
    half = np.minimum(_distance(A, B) / _chord(np.pi), 1)
    angle = 2 * np.arcsin(half)
    if half.max() > 0.99:  # near half a turn the arcsine has lost half of its digits
        flipped = np.flatnonzero(half > 0.99)
        angle[flipped] = angle_of(np.einsum("kin,kjn->ijn", A[..., flipped], B[..., flipped]))
    return angle


def _chord(angle):
    """Return ||R - I|| (Frobenius) of a rotation by this angle, in the plane and in space."""
    return np.sqrt(8) * np.sin(angle / 2)


def _columns_of_pairs(trajectories, i, j):
    """Yield for each trajectory the columns of its poses i and those of its poses j."""
    start, stop = i[0], j.max() + 1
    near = stop - start <= 2 * len(i)  # then one copy serves both
    i, j = (_as_slice(k - start if near else k) for k in (i, j))
    for X in trajectories:
        if near:
            columns = _columns(X, slice(start, stop))
            yield columns[..., i], columns[..., j]
        else:
            yield _columns(X, i), _columns(X, j)


def _columns(X, k):
    """Return the columns of the poses k with the samples along the last axis: (d+1, d, n)."""
    return X[k, :-1].transpose(2, 1, 0).copy()


def _as_slice(k):
    """Return neighboring indices as a slice, which makes a view and not a copy."""
    return slice(k[0], k[-1] + 1) if (np.diff(k) == 1).all() else k


def _distance(A, B):
    """Return ||A - B|| (Frobenius) of matrices (d, d, n)."""
    return lengths((A - B).reshape(len(A) ** 2, -1))
