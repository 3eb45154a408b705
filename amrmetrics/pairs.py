"""Pairs of samples a given stretch apart, and the errors of the motion between them.

Poses are worked on in blocks of rows that stay in the processor's cache (see
`_arguments.in_blocks`); this is the one place where the speed of the relative metrics
is made.
"""

import numpy as np

from amrmetrics._arguments import BLOCK, as_numbers, as_stamps
from amrmetrics.errors import AmrError
from amrmetrics.poses import angle_of

UNITS = ("frames", "metres", "seconds", "degrees")
TOLERANCE = 0.1


def find_pairs(X, delta, unit, pairs, stamps):
    """Return (i, j, lengths, left_out) for `rpe`."""
    if unit not in UNITS:
        raise AmrError(f"unit is {unit!r}; expected one of {', '.join(map(repr, UNITS))}.")
    if pairs not in ("all", "consecutive"):
        raise AmrError(f"pairs is {pairs!r}; expected 'all' or 'consecutive'.")
    delta = as_numbers(delta, "delta")
    if delta.ndim or delta <= 0:
        raise AmrError(f"delta is {delta}; expected one number of {unit}, greater than 0.")
    delta = float(delta)
    if unit == "frames" and delta != int(delta):
        raise AmrError(f"delta is {delta} frames; expected a whole number.")
    if unit == "degrees" and delta > 180:
        raise AmrError(f"delta is {delta} degrees; a rotation angle is at most 180 degrees.")
    if unit == "frames":
        i = np.arange(0, len(X) - delta, 1 if pairs == "all" else delta, dtype=int)
        if not len(i):
            raise AmrError(f"delta is {delta:g} frames, but the recording has {len(X)} samples.")
        return i, i + int(delta), np.full(len(i), delta), 0
    measure = _measure(X, unit, stamps)
    if unit == "degrees" and pairs == "all":
        return _pairs_at_angle(X, delta)
    if pairs == "consecutive":
        # A hair less, so that ten steps of 0.1 are one whole in floating point, too.
        after = np.searchsorted(measure, measure + delta * (1 - 1e-9))
        i = _chain(after)
        i, j = i[:-1], i[1:]
    else:
        i, j = _nearest(measure, delta)
    lengths = measure[j] - measure[i]
    # A sum of single turns overshoots by up to one of them, and nothing better is there.
    tolerance = np.inf if unit == "degrees" else TOLERANCE * (1 + 1e-9)
    off = np.abs(lengths - delta) > tolerance * delta
    if off.all():
        raise AmrError(_no_pairs(measure, delta, unit))
    return i[~off], j[~off], lengths[~off], int(off.sum())


def _measure(X, unit, stamps):
    """Return what grows along the reference: meters, seconds or degrees turned."""
    if unit == "metres":
        return travelled(X)
    if unit == "degrees":
        i = np.arange(len(X) - 1)
        return np.concatenate([[0], np.degrees(_turns(X, i, i + 1)).cumsum()])
    if stamps is None:
        raise AmrError("stamps are missing; unit='seconds' needs the time of each sample.")
    stamps = as_stamps(stamps, "stamps")
    if len(stamps) != len(X):
        raise AmrError(f"stamps has {len(stamps)} entries for {len(X)} poses; one each is needed.")
    return stamps - stamps[0]


def _nearest(measure, delta):
    """Return for each i the j > i whose distance is nearest to delta, the first of equals."""
    i = np.arange(len(measure) - 1)
    target = measure[:-1] + delta
    after = np.minimum(np.searchsorted(measure, target), len(measure) - 1)
    before = np.searchsorted(measure, measure[after - 1])
    after, before = np.maximum(after, i + 1), np.maximum(before, i + 1)
    nearer = np.abs(measure[before] - target) <= np.abs(measure[after] - target)
    return i, np.where(nearer, before, after)


def _chain(after):
    """Return 0, after[0], after[after[0]], ... as long as they are samples."""
    following, k, chain = after.tolist(), 0, [0]
    while (k := following[k]) < len(following):
        chain.append(k)
    return np.array(chain)


def _pairs_at_angle(X, delta):
    """Return all pairs whose orientations differ by delta degrees within the tolerance."""
    firsts, lasts, angles = [], [], []
    for i in range(len(X) - 1):
        j = np.arange(i + 1, len(X))
        turn = np.degrees(_turns(X, np.full(len(j), i), j))
        fits = np.abs(turn - delta) <= TOLERANCE * delta
        firsts.append(np.full(fits.sum(), i))
        lasts.append(j[fits])
        angles.append(turn[fits])
    if not sum(map(len, firsts)):
        raise AmrError(f"no two orientations are {delta:g} degrees apart, within 10 %.")
    return np.concatenate(firsts), np.concatenate(lasts), np.concatenate(angles), 0


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
    steps = np.diff(X[:, :-1, -1], axis=0)
    return np.concatenate([[0], np.sqrt(np.einsum("ij,ij->i", steps, steps)).cumsum()])


def pair_errors(X, Y, i, j):
    """Return the translation and rotation errors of the pairs (i, j), meters and radians."""
    d = X.shape[-1] - 1
    translation, rotation = np.empty(len(i)), np.empty(len(i))
    for block in _blocks(len(i)):
        (A, a), (B, b) = ((_relative_rows(Z, i[block], j[block], d)) for Z in (X, Y))
        translation[block] = norm(a - b)
        rotation[block] = angle_of(_transpose_times(A, B))
    return translation, rotation


def _relative_rows(X, i, j, d):
    """Return rotation (d, d, n) and translation (d, n) of inv(X[i]) @ X[j]."""
    P, Q = _rows(X, i, d), _rows(X, j, d)
    R = P[:, :d]
    return _transpose_times(R, Q[:, :d]), (R * (Q[:, d] - P[:, d])[:, None]).sum(0)


def _transpose_times(A, B):
    """Return A^T B for matrices whose entries come first, shape (d, d, n)."""
    return sum(A[k, :, None] * B[k, None, :] for k in range(len(A)))


def _turns(X, i, j):
    """Return the angles between the orientations i and j of X, radians."""
    d = X.shape[-1] - 1
    turn = np.empty(len(i))
    for block in _blocks(len(i)):
        P, Q = _rows(X, i[block], d), _rows(X, j[block], d)
        turn[block] = angle_of(_transpose_times(P[:, :d], Q[:, :d]))
    return turn


def orientation_errors(X, Y, R):
    """Return the angles between the rotations of X and R times those of Y."""
    d = len(R)
    angles = np.empty(len(X))
    for block in _blocks(len(X)):
        A, B = (np.moveaxis(Z[block, :d, :d], 0, -1).copy() for Z in (X, Y))
        turned = (R @ B.reshape(d, -1)).reshape(B.shape)
        angles[block] = angle_of(_transpose_times(A, turned))
    return angles


def _rows(X, k, d):
    """Return [R, t] of the poses k with the entries first, shape (d, d+1, n)."""
    if (np.diff(k) == 1).all():  # a slice is a view: half of the time of RPE over frames
        k = slice(k[0], k[-1] + 1)
    return np.moveaxis(X[k, :d], 0, -1).copy()


def _blocks(n):
    return [slice(k, k + BLOCK) for k in range(0, n, BLOCK)]


def norm(rows):
    return np.sqrt(np.einsum("kn,kn->n", rows, rows))
