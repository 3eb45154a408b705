"""Two recordings on two clocks: match their samples, interpolate, estimate the clock offset."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import BLOCK, as_array, as_numbers, as_stamps
from amrmetrics.errors import AmrError
from amrmetrics.poses import inverse, planar_poses, rotation_angle
from amrmetrics.recording import Trajectory, as_recording

if TYPE_CHECKING:
    from amrmetrics._types import Array, ArrayLike

# Seconds over which a turn is measured: longer than noise, shorter than a robot's maneuver.
SMOOTHING = 0.2
# Samples of the resampled recordings, which bounds memory.
LONGEST = 4_000_000
# Stamps matched at a time; one is a number where a pose is up to sixteen.
STRETCH = 8 * BLOCK
# A longer time between two samples is a gap: this many usual ones, and at least so many seconds.
USUAL_GAPS = 10
SHORTEST_GAP = 1.0


def associate(
    reference_stamps: ArrayLike,
    estimate_stamps: ArrayLike,
    max_difference: float = 0.01,
    offset: float = 0.0,
) -> tuple[Array, Array]:
    """Match two lists of time stamps: each to its nearest, one-to-one, in order of time.

    Parameters
    ----------
    reference_stamps, estimate_stamps : (N,), (M,) array
        Seconds, increasing.
    max_difference : float
        Largest difference of a match in seconds, >= 0; inclusive up to the rounding of the
        stamps.
    offset : float
        Seconds, added to the estimate's stamps first.

    Returns
    -------
    i, j : (K,) arrays of int
        Sample i[k] of the reference belongs to sample j[k] of the estimate, both in order of
        time. Each estimate takes its nearest reference stamp (the earlier of two equally
        near); where several take the same, the nearest of them keeps it, and the others look
        among the stamps that are still free, until none of those is within reach.

    Raises
    ------
    AmrError
        If stamps are not increasing, or nothing matches: the message gives both time
        ranges and what would help.

    References
    ----------
    Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012, sec. VI.

    Examples
    --------
    >>> import amrmetrics as am
    >>> i, j = am.associate([0.0, 0.1, 0.2, 0.3], [0.101, 0.104, 0.296])
    >>> i.tolist(), j.tolist()
    ([1, 3], [0, 2])
    """
    t = as_stamps(reference_stamps, "reference_stamps")
    u = as_stamps(estimate_stamps, "estimate_stamps")
    offset, limit = _as_seconds(offset, "offset"), _as_seconds(max_difference, "max_difference")
    if limit < 0:
        raise AmrError(f"max_difference is {limit} s; it must not be negative.")
    i, j = _match(t, u, offset, limit)
    if not len(j):
        raise AmrError(_no_match(t, u, offset, limit))
    return _with_the_rest(t, u, offset, limit, i, j)


def _with_the_rest(t, u, offset, limit, i, j):
    """Match also those that lost their nearest partner to a rival, as long as any can be."""
    matched_i, matched_j = [i], [j]
    free_t, free_u = np.ones(len(t), bool), np.ones(len(u), bool)
    while len(j):
        free_t[i], free_u[j] = False, False
        rest_t, rest_u = np.flatnonzero(free_t), np.flatnonzero(free_u)
        if not len(rest_t) or not len(rest_u):
            break
        i, j = _match(t[rest_t], u[rest_u], offset, limit)
        i, j = rest_t[i], rest_u[j]
        matched_i.append(i)
        matched_j.append(j)
    # Two matches that cross are exchanged, which brings no partners farther apart.
    return np.sort(np.concatenate(matched_i)), np.sort(np.concatenate(matched_j))


def _match(t, u, offset, limit):
    """Return the indices of matches between t and u + offset."""
    limit += 2 * np.spacing(np.abs([t[0], t[-1], u[0], u[-1]]).max())  # what rounding may add
    blocks = []
    for start in range(0, len(u), STRETCH):
        v = u[start : start + STRETCH]
        low, high = np.searchsorted(t, v[[0, -1]] + offset)
        low = max(low - 1, 0)
        # Times since t[low] are short, so that their sums and halves are exact.
        v, near = v - t[low] + offset, t[low : high + 1] - t[low]
        i = _nearest(near, v)
        j = np.flatnonzero(np.abs(near[i] - v) <= limit)
        blocks.append((i[j] + low, j + start))
    i, j = map(np.concatenate, zip(*blocks, strict=True))
    return _one_to_one(t, u, offset, i, j)


def _nearest(t, u):
    """Return for each u the index of the nearest t, the earlier of two equally near."""
    # t[i] is the nearest of what lies in (edges[i], edges[i + 1]].
    edges = np.concatenate([[-np.inf], (t[1:] + t[:-1]) / 2, [np.inf]])
    # Two recordings at one rate advance together; what does not is searched for.
    first = int(np.searchsorted(edges, u[0])) - 1
    i = np.arange(first, first + len(u))
    m = min(len(u), len(t) - first)
    astray = np.ones(len(u), bool)
    astray[:m] = (u[:m] <= edges[first:][:m]) | (u[:m] > edges[first + 1 :][:m])
    other = np.flatnonzero(astray)
    i[other] = np.searchsorted(edges, u[other]) - 1
    return i


def _one_to_one(t, u, offset, i, j):
    """Leave each t[i] the nearest of its u[j] + offset: rivals stand side by side."""
    k = np.flatnonzero(i[1:] == i[:-1])
    if not len(k):
        return i, j
    at, earlier, later = t[i[k]], u[j[k]] + offset, u[j[k + 1]] + offset
    kept = np.ones(len(i), bool)
    kept[np.where(later - at < at - earlier, k, k + 1)] = False
    return i[kept], j[kept]


def _no_match(t, u, offset, limit):
    i, j = _match(t, u, offset, np.inf)
    apart = np.abs(t[i] - u[j] - offset).min()
    if u[-1] + offset < t[0] or t[-1] < u[0] + offset:
        start = float(t[0] - u[0])
        help_ = (
            f"The ranges do not overlap: try offset={start!r} if both start together "
            "(clock_offset estimates it from their turns), and check that both are in seconds"
        )
    else:
        help_ = (
            f"Try max_difference={_rounded_up(apart)} or more, or another offset "
            "(clock_offset estimates it from their turns)"
        )
    gaps = [f"{np.median(np.diff(x)):.6g} s" if len(x) > 1 else "none" for x in (t, u)]
    return (
        f"no stamps match within max_difference={limit:g} s: the nearest two are {apart:.6g} s "
        f"apart. The reference runs from {t[0]:.6f} to {t[-1]:.6f} s (typical gap {gaps[0]}), the "
        f"estimate with offset={offset:g} from {u[0] + offset:.6f} to {u[-1] + offset:.6f} s "
        f"(typical gap {gaps[1]}). {help_}."
    )


def _rounded_up(x):
    """Return a number of two digits that is not less than x, as text."""
    digit = 10.0 ** (np.floor(np.log10(x)) - 1)
    return f"{np.ceil(x / digit * (1 + 1e-9)) * digit:.2g}"


def interpolate(
    stamps: ArrayLike,
    X: ArrayLike,
    new_stamps: ArrayLike | None = None,
    max_gap: float | None = None,
) -> Array | Trajectory:
    """Interpolate a trajectory: positions along straight lines, rotations along geodesics.

    Parameters
    ----------
    stamps : (N,) array
        Seconds, increasing. Or a Trajectory, followed by the new stamps.
    X : (N, d+1, d+1) array
        Poses, d = 2 or 3.
    new_stamps : (M,) array
        Seconds, increasing, from stamps[0] to stamps[-1].
    max_gap : float, optional
        Longest time in seconds between two samples that is bridged. By default ten times the
        usual one and at least 1 s, which no continuous recording reaches.

    Returns
    -------
    (M, d+1, d+1) array
        Poses at the new stamps. Between two poses half a turn apart the shorter way is
        not unique; one is taken. Of a Trajectory, a Trajectory: what lies in a gap is left out
        of it and counted in its `repairs`.

    Raises
    ------
    AmrError
        If a new stamp lies outside of the recording (nothing is extrapolated) or, given
        arrays, in a gap; or the stamps are not increasing or not as many as the poses.

    References
    ----------
    Lecture 01; Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.planar_poses([[0, 0], [2, 0]], np.radians([170, -170]))
    >>> half = am.interpolate([0, 1], X, [0.5])
    >>> am.positions(half).tolist(), np.degrees(am.yaw(half)).round(9).tolist()
    ([[1.0, 0.0]], [-180.0])
    """
    recording = stamps if isinstance(stamps, Trajectory) and new_stamps is None else None
    if recording is not None:
        X, new_stamps = None, X
    stamps, X = as_recording(stamps, X, "stamps", "X")
    new = as_stamps(new_stamps, "new_stamps")
    if new[0] < stamps[0] or new[-1] > stamps[-1]:
        raise AmrError(
            f"new_stamps run from {new[0]:.6f} to {new[-1]:.6f} s, the recording from "
            f"{stamps[0]:.6f} to {stamps[-1]:.6f} s. Nothing is extrapolated: drop the stamps "
            "outside."
        )
    limit = as_gap(max_gap, stamps)
    lost = in_gap(stamps, new, limit)
    if recording is None:
        if lost.any():
            raise AmrError(_in_gaps(stamps, new, lost, limit))
        return between_samples(stamps, X, new)
    if lost.all():
        raise AmrError(_in_gaps(stamps, new, lost, limit))
    repairs = recording.repairs
    if lost.any():
        repairs = (*repairs, f"{lost.sum()} of {len(new)} stamps in gaps left out")
    poses = between_samples(stamps, X, new[~lost])
    return replace(recording, stamps=new[~lost], poses=poses, repairs=repairs, frames=None)


def as_gap(max_gap, stamps):
    """Return the longest gap that is bridged, in seconds."""
    if max_gap is None:
        usual = np.median(np.diff(stamps)) if len(stamps) > 1 else 0.0
        return max(SHORTEST_GAP, USUAL_GAPS * float(usual))
    limit = as_array(max_gap, "max_gap")
    if limit.shape or limit.dtype.kind not in "fiu" or not limit > 0:
        raise AmrError(f"max_gap is {max_gap!r}; expected a number of seconds, > 0.")
    return float(limit)


def in_gap(stamps, new, limit):
    """Say which new stamps lie between two samples that are farther apart than the limit."""
    if len(stamps) == 1:
        return np.zeros(len(new), bool)
    k = np.clip(np.searchsorted(stamps, new, side="right") - 1, 0, len(stamps) - 2)
    wide = stamps[k + 1] - stamps[k] > limit
    return wide & (new != stamps[k]) & (new != stamps[k + 1])


def _in_gaps(stamps, new, lost, limit):
    first = int(lost.argmax())
    k = int(np.searchsorted(stamps, new[first])) - 1
    return (
        f"{lost.sum()} of {len(new)} new_stamps lie where the recording has a gap of more than "
        f"max_gap={limit:g} s, first between {stamps[k]:.6f} and {stamps[k + 1]:.6f} s; what "
        "happened there is not known. Leave them out, as match(interpolate=True) does, or give a "
        "larger max_gap."
    )


def between_samples(stamps, X, new):
    """Return interpolated poses at stamps inside the recording."""
    d = X.shape[-1] - 1
    k = np.clip(np.searchsorted(stamps, new, side="right") - 1, 0, max(len(stamps) - 2, 0))
    after = np.minimum(k + 1, len(stamps) - 1)
    duration = np.where(after > k, stamps[after] - stamps[k], 1.0)
    part = (new - stamps[k]) / duration
    if X.ndim == 2:
        return X[k] + part[:, None] * (X[after] - X[k])
    turn = inverse(X[k]) @ X[after]
    if d == 2:
        angle = part * np.arctan2(turn[:, 1, 0], turn[:, 0, 0])
        Y = X[k] @ planar_poses(np.zeros((len(new), 2)), angle)
    else:
        from scipy.spatial.transform import Rotation

        Y = X[k].copy()
        vector = Rotation.from_matrix(turn[:, :3, :3]).as_rotvec()
        Y[:, :3, :3] = X[k, :3, :3] @ Rotation.from_rotvec(part[:, None] * vector).as_matrix()
    p, q = X[k, :d, d], X[after, :d, d]
    Y[:, :d, d] = p + part[:, None] * (q - p)
    return Y


def clock_offset(
    reference_stamps: ArrayLike,
    X: ArrayLike,
    estimate_stamps: ArrayLike | None = None,
    Xh: ArrayLike | None = None,
) -> ClockOffset:
    """Estimate how far the estimate's clock lags, from the two angular speeds.

    Parameters
    ----------
    reference_stamps, estimate_stamps : (N,), (M,) array
        Seconds on the two clocks, increasing, at least four each. Two Trajectories alone,
        reference and estimate, have all four.
    X, Xh : (N, d+1, d+1), (M, d+1, d+1) array
        Poses, d = 2 or 3, of two frames on one rigid body. World frames may differ.

    Returns
    -------
    ClockOffset
        Seconds to add to the estimate's stamps (the `offset` of `associate`), a float. Its
        `standard_error` says what it is worth: with key frames it may be tenths of a second.

    Raises
    ------
    AmrError
        If no offset can be told from another, because the angular speed does not vary or
        the motion repeats itself; if the two agree at none (correlation below 0.71), as of
        key frames too far apart for the turns between them; or if the input is malformed.

    References
    ----------
    Lecture 01: the peak of the cross-correlation, refined by the least-squares step
    sum(w' (w_est - w_ref)) / sum(w'^2). Rehder et al., A general approach to
    spatiotemporal calibration, IEEE T-RO 32 (2016), sec. VI, initializes the same way. The
    standard error allows for correlation in time as Newey and West, Econometrica 55 (1987).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 20, 0.02)
    >>> X = am.planar_poses(np.zeros((len(t), 2)), np.sin(t) + 0.3 * np.sin(2.7 * t))
    >>> round(am.clock_offset(t, X, t - 0.35, X), 3)
    0.35
    """
    if estimate_stamps is None:
        reference_stamps, X, estimate_stamps, Xh = reference_stamps, None, X, None
    t, X = as_recording(reference_stamps, X, "reference_stamps", "X")
    u, Y = as_recording(estimate_stamps, Xh, "estimate_stamps", "Xh")
    if X.shape[1] != Y.shape[1]:
        raise AmrError("one of X and Xh is 2-D, the other 3-D; project the spatial one first.")
    if min(len(t), len(u)) < 4:
        raise AmrError(
            f"X has {len(t)} and Xh {len(u)} samples; a clock offset needs four or more."
        )
    step, slower = np.sort([np.median(np.diff(t)), np.median(np.diff(u))])
    stretch = max(slower, SMOOTHING)
    (t, w), (u, v) = _angular_speed(t, X, stretch), _angular_speed(u, Y, stretch)
    for name, speed in (("X", w), ("Xh", v)):
        if np.ptp(speed) <= 1e-6 * np.abs(speed).max():
            raise AmrError(
                f"the angular speed of {name} does not vary, so every clock offset fits equally "
                "well. Record a motion that turns now faster, now slower."
            )
    step = max(step, np.ptp(t) / LONGEST, np.ptp(u) / LONGEST)
    lag = _coarse_lag(_resample(t, w, step), _resample(u, v, step), stretch / step, slower)
    offset = float(t[0] - u[0] + lag * step)
    offset, error = _refined(offset, t, w, u, v, stretch)
    return ClockOffset(offset, error)


def _refined(offset, t, w, u, v, stretch):
    """Repeat the least-squares step from a coarse offset; return it and its standard error."""
    for _ in range(20):
        at = u + offset
        inside = (at >= t[0]) & (at <= t[-1])
        at = at[inside]
        # Over a whole stretch, the noise of the slope has nothing to do with that of w(at).
        slope = np.interp(at + stretch / 2, t, w) - np.interp(at - stretch / 2, t, w)
        slope /= stretch
        squares = slope @ slope
        rest = v[inside] - np.interp(at, t, w)
        change = float(slope @ rest / squares) if squares else 0.0
        if abs(change) > stretch:
            break
        offset += change
        if abs(change) < 1e-12:
            break
    # Stretches overlap, so that what is left of neighbors is alike.
    pull = slope * (rest - change * slope)
    lags = min(len(pull) - 1, 4 * int(np.ceil(stretch / np.median(np.diff(u)))))
    weights = 2 * (1 - np.arange(1, lags + 1) / (lags + 1))
    products = [pull[k:] @ pull[:-k] for k in range(1, lags + 1)]
    total = pull @ pull + weights @ products
    return offset, float(np.sqrt(total) / squares)


class ClockOffset(float):
    """Seconds to add to the estimate's stamps: a float that knows its standard error.

    Attributes
    ----------
    standard_error : float
        Seconds, one standard deviation.
    """

    def __new__(cls, seconds, standard_error):
        offset = super().__new__(cls, seconds)
        offset.standard_error = standard_error
        return offset

    def __getnewargs__(self):
        return float(self), self.standard_error

    def __repr__(self):
        return f"{float(self):.6g} s, standard error {self.standard_error:.2g} s"


def _angular_speed(stamps, X, stretch):
    """Return the middles of stretches of this many seconds, and the turn per second in each.

    In the plane it has a sign; in space only its size does not depend on how the two
    sensors are mounted.
    """
    m = int(np.clip(round(stretch / np.median(np.diff(stamps))), 1, len(stamps) // 4))
    turn = inverse(X[:-m]) @ X[m:]
    angle = np.arctan2(turn[:, 1, 0], turn[:, 0, 0]) if X.shape[-1] == 3 else rotation_angle(turn)
    return (stamps[m:] + stamps[:-m]) / 2, angle / (stamps[m:] - stamps[:-m])


def _resample(stamps, values, step):
    grid = np.arange(stamps[0], stamps[-1], step)
    resampled = np.interp(grid, stamps, values)
    return resampled - resampled.mean()


def _coarse_lag(w, v, width, slower):
    """Return the shift of `v`, in steps, at which the two agree best by far."""
    from scipy.signal import correlate

    overlap = correlate(np.ones_like(w), np.ones_like(v), method="fft").round()
    energy = np.sqrt(
        correlate(w * w, np.ones_like(v), method="fft")
        * correlate(np.ones_like(w), v * v, method="fft")
    )
    match = correlate(w, v, method="fft") / np.maximum(energy, 1e-12 * energy.max())
    # A few samples that happen to agree must not win over half of the recording.
    match[overlap < min(len(w), len(v)) / 2] = -np.inf
    best = int(np.argmax(match))
    if match[best] ** 2 < 0.5:
        raise AmrError(
            f"the angular speeds of the two agree at no offset (correlation {match[best]:.2f} at "
            "best). Are they one motion, recorded at the same time, and is enough of it turning? "
            f"One of them has a pose every {slower:.2g} s, which must be short against the turns."
        )
    if (np.diff(np.flatnonzero(match > 0.99 * match[best])) > width).any():
        raise AmrError(
            "the motion repeats itself, so that several clock offsets fit equally well. Record a "
            "motion that turns irregularly."
        )
    return best - (len(v) - 1)


def _as_seconds(value, name):
    seconds = as_numbers(value, name)
    if seconds.ndim:
        raise AmrError(f"{name} has shape {seconds.shape}; one number of seconds is expected.")
    return float(seconds)
