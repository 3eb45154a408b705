"""Two recordings on two clocks: match their samples, interpolate, estimate the clock offset."""

import numpy as np

from amrmetrics._arguments import as_numbers, as_poses, as_stamps
from amrmetrics.errors import AmrError
from amrmetrics.poses import inverse, planar_poses, rotation_angle


def associate(reference_stamps, estimate_stamps, max_difference=0.01, offset=0.0):
    """Match two lists of time stamps: each to its nearest, one-to-one, in order of time.

    Parameters
    ----------
    reference_stamps, estimate_stamps : (N,), (M,) array
        Seconds, increasing.
    max_difference : float
        Largest difference of a match in seconds, inclusive, >= 0.
    offset : float
        Seconds, added to the estimate's stamps first.

    Returns
    -------
    i, j : (K,) arrays of int
        Sample i[k] of the reference belongs to sample j[k] of the estimate. Each estimate
        takes its nearest reference stamp (the earlier of two equally near); where several
        take the same, the nearest of them keeps it.

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
    u = as_stamps(estimate_stamps, "estimate_stamps") + _as_seconds(offset, "offset")
    limit = _as_seconds(max_difference, "max_difference")
    if limit < 0:
        raise AmrError(f"max_difference is {limit} s; it must not be negative.")
    after = np.clip(np.searchsorted(t, u), 1, max(len(t) - 1, 1))
    after = np.minimum(after, len(t) - 1)
    before = np.maximum(after - 1, 0)
    i = np.where(u - t[before] <= t[after] - u, before, after)
    gap = np.abs(t[i] - u)
    # Nearest references of increasing stamps increase, so rivals stand side by side.
    j = np.flatnonzero(gap <= limit)
    if not len(j):
        raise AmrError(_no_match(t, u, gap, limit))
    start = np.flatnonzero(np.diff(i[j], prepend=-1))
    best = np.minimum.reduceat(gap[j], start)
    winner = gap[j] == np.repeat(best, np.diff(start, append=len(j)))
    j = j[winner]
    first = np.diff(i[j], prepend=-1) != 0
    return i[j[first]], j[first]


def _no_match(t, u, gap, limit):
    apart = f"the nearest two stamps are {gap.min():.6g} s apart"
    if u[-1] < t[0] or t[-1] < u[0]:
        help_ = (
            f"The ranges do not overlap: try offset={t[0] - u[0]:.6g} if both start together "
            "(clock_offset estimates it), and check that both are in seconds"
        )
    else:
        help_ = f"Try max_difference={1.01 * gap.min():.2g} or more, or another offset"
    gaps = [f"{np.median(np.diff(x)):.6g} s" if len(x) > 1 else "none" for x in (t, u)]
    return (
        f"no stamps match within max_difference={limit:g} s: {apart}. The reference runs from "
        f"{t[0]:.6f} to {t[-1]:.6f} s (typical gap {gaps[0]}), the estimate with its offset from "
        f"{u[0]:.6f} to {u[-1]:.6f} s (typical gap {gaps[1]}). {help_}."
    )


def interpolate(stamps, X, new_stamps):
    """Interpolate a trajectory: positions along straight lines, rotations along geodesics.

    Parameters
    ----------
    stamps : (N,) array
        Seconds, increasing.
    X : (N, d+1, d+1) array
        Poses, d = 2 or 3.
    new_stamps : (M,) array
        Seconds, increasing, from stamps[0] to stamps[-1].

    Returns
    -------
    (M, d+1, d+1) array
        Poses at the new stamps. Between two poses half a turn apart the shorter way is
        not unique; one is taken.

    Raises
    ------
    AmrError
        If a new stamp lies outside of the recording (nothing is extrapolated), or the
        stamps are not increasing or not as many as the poses.

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
    stamps, X = _as_recording(stamps, X, "stamps", "X")
    new = as_stamps(new_stamps, "new_stamps")
    if new[0] < stamps[0] or new[-1] > stamps[-1]:
        raise AmrError(
            f"new_stamps run from {new[0]:.6f} to {new[-1]:.6f} s, the recording from "
            f"{stamps[0]:.6f} to {stamps[-1]:.6f} s. Nothing is extrapolated: drop the stamps "
            "outside."
        )
    d = X.shape[-1] - 1
    k = np.clip(np.searchsorted(stamps, new, side="right") - 1, 0, max(len(stamps) - 2, 0))
    after = np.minimum(k + 1, len(stamps) - 1)
    duration = np.where(after > k, stamps[after] - stamps[k], 1.0)
    part = (new - stamps[k]) / duration
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


def clock_offset(reference_stamps, X, estimate_stamps, Xh):
    """Estimate how far the estimate's clock lags, from the two angular speeds.

    Parameters
    ----------
    reference_stamps, estimate_stamps : (N,), (M,) array
        Seconds on the two clocks, increasing, at least four each.
    X, Xh : (N, d+1, d+1), (M, d+1, d+1) array
        Poses, d = 2 or 3, of two frames on one rigid body. World frames may differ.

    Returns
    -------
    float
        Seconds to add to the estimate's stamps (the `offset` of `associate`).

    Raises
    ------
    AmrError
        If the angular speed does not vary, so that no offset can be told from another,
        or the input is malformed.

    References
    ----------
    Lecture 01: the peak of the cross-correlation, refined by the least-squares step
    sum(w' (w_est - w_ref)) / sum(w'^2). Rehder et al., A general approach to
    spatiotemporal calibration, IEEE T-RO 32 (2016), sec. VI, initializes the same way.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 20, 0.02)
    >>> X = am.planar_poses(np.zeros((len(t), 2)), np.sin(t) + 0.3 * np.sin(2.7 * t))
    >>> round(am.clock_offset(t, X, t - 0.35, X), 3)
    0.35
    """
    t, w = _angular_speed(*_as_recording(reference_stamps, X, "reference_stamps", "X"))
    u, v = _angular_speed(*_as_recording(estimate_stamps, Xh, "estimate_stamps", "Xh"))
    for name, speed in (("X", w), ("Xh", v)):
        if np.ptp(speed) <= 1e-6 * max(np.abs(speed).max(), 1e-12):
            raise AmrError(
                f"the angular speed of {name} does not vary, so every clock offset fits equally "
                "well. Record a motion that turns now faster, now slower."
            )
    step = min(np.median(np.diff(t)), np.median(np.diff(u)))
    lag = _coarse_lag(*(_resample(x, y, step) for x, y in ((t, w), (u, v)))) * step
    offset = float(t[0] - u[0] + lag)
    for _ in range(20):
        inside = (u + offset >= t[0]) & (u + offset <= t[-1])
        if inside.sum() < 3:
            break
        at = u[inside] + offset
        slope = (np.interp(at + step / 2, t, w) - np.interp(at - step / 2, t, w)) / step
        change = slope @ (v[inside] - np.interp(at, t, w)) / (slope @ slope)
        if not np.isfinite(change) or abs(change) > 2 * step:
            break
        offset += float(change)
        if abs(change) < 1e-12:
            break
    return offset


def _angular_speed(stamps, X):
    """Return the middles of the intervals and the turn per second in each.

    In the plane it has a sign; in space only its size does not depend on how the two
    sensors are mounted.
    """
    if len(stamps) < 4:
        raise AmrError(f"a recording has {len(stamps)} samples; a clock offset needs four or more.")
    turn = inverse(X[:-1]) @ X[1:]
    angle = np.arctan2(turn[:, 1, 0], turn[:, 0, 0]) if X.shape[-1] == 3 else rotation_angle(turn)
    return (stamps[1:] + stamps[:-1]) / 2, angle / np.diff(stamps)


def _resample(stamps, values, step):
    grid = stamps[0] + step * np.arange(int((stamps[-1] - stamps[0]) / step) + 1)
    resampled = np.interp(grid, stamps, values)
    return resampled - resampled.mean()


def _coarse_lag(w, v):
    """Return the shift of `v`, in steps, at which the two agree best."""
    from scipy.signal import correlate

    overlap = correlate(np.ones_like(w), np.ones_like(v), method="fft").round()
    energy = np.sqrt(
        correlate(w * w, np.ones_like(v), method="fft")
        * correlate(np.ones_like(w), v * v, method="fft")
    )
    match = correlate(w, v, method="fft") / np.maximum(energy, 1e-12 * energy.max())
    # A few samples that happen to agree must not win over half of the recording.
    match[overlap < min(len(w), len(v)) / 2] = -np.inf
    return int(np.argmax(match)) - (len(v) - 1)


def _as_recording(stamps, X, stamps_name, name):
    stamps, X = as_stamps(stamps, stamps_name), as_poses(X, name)
    if len(stamps) != len(X):
        raise AmrError(
            f"{stamps_name} has {len(stamps)} entries and {name} has {len(X)} poses; each pose "
            "needs one stamp."
        )
    return stamps, X


def _as_seconds(value, name):
    seconds = as_numbers(value, name)
    if seconds.ndim:
        raise AmrError(f"{name} has shape {seconds.shape}; one number of seconds is expected.")
    return float(seconds)
