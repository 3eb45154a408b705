"""Poses of a robot in the plane, SE(2), and in space, SE(3).

A pose X is a homogeneous matrix [[R, t], [0, 1]] that takes coordinates in the
robot's frame to coordinates in the world frame. A trajectory is an array of
them, shape (N, d + 1, d + 1); every function here works for d = 2 and d = 3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._arguments import as_numbers, as_poses, as_positions, as_rows
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import Array, ArrayLike

UNIT_QUATERNION_WITHIN = 1e-3


def wrap(angle: ArrayLike) -> Any:
    """Bring angles to [-pi, pi).

    Parameters
    ----------
    angle : float or array
        Angles in radians, any shape, any finite size.

    Returns
    -------
    float or array
        The same directions in [-pi, pi). Angles already there come back
        unchanged, to the last bit; pi becomes -pi.

    Raises
    ------
    AmrError
        If an angle is NaN or infinite.

    References
    ----------
    Lecture 01. ``fmod`` and both shifts are exact in floating point (Sterbenz's
    lemma), which ``mod(angle + pi, 2 pi) - pi`` is not: it returns +pi for angles
    just below -pi, and 0 for 1e-20.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> round(am.wrap(np.radians(350)), 6)
    -0.174533
    >>> am.wrap([0.5, np.pi, -np.pi]).round(4).tolist()
    [0.5, -3.1416, -3.1416]
    """
    turn = 2 * np.pi
    rest = np.fmod(as_numbers(angle, "angle"), turn)
    rest = np.where(rest >= np.pi, rest - turn, rest)
    rest = np.where(rest < -np.pi, rest + turn, rest)
    return rest if rest.ndim else float(rest)


def planar_poses(xy: ArrayLike, yaw: ArrayLike) -> Array:
    """Make SE(2) poses from positions and headings.

    Parameters
    ----------
    xy : (N, 2) array
        Positions in the world frame, metres.
    yaw : (N,) array
        Headings in radians, counterclockwise from the world's x axis; any size.

    Returns
    -------
    (N, 3, 3) array
        Homogeneous matrices, robot frame to world frame.

    Raises
    ------
    AmrError
        If a shape is wrong, the lengths differ, or an entry is not finite.

    References
    ----------
    Lecture 01; Barfoot, State Estimation for Robotics (2017), section 7.1.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.planar_poses([[2.0, 1.0]], [0.0]).tolist()
    [[[1.0, -0.0, 2.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]]
    """
    xy = as_rows(xy, "xy", (2,), "planar positions")
    yaw = as_numbers(yaw, "yaw")
    if yaw.shape != (len(xy),):
        raise AmrError(
            f"yaw has shape {yaw.shape} and xy has {len(xy)} rows; one heading per position is "
            f"needed, shape ({len(xy)},)."
        )
    c, s = np.cos(yaw), np.sin(yaw)
    X = np.zeros((len(xy), 3, 3))
    X[:, 0, 0], X[:, 0, 1] = c, -s
    X[:, 1, 0], X[:, 1, 1] = s, c
    X[:, :2, 2] = xy
    X[:, 2, 2] = 1
    return X


def spatial_poses(xyz: ArrayLike, quaternions: ArrayLike) -> Array:
    """Make SE(3) poses from positions and unit quaternions.

    Parameters
    ----------
    xyz : (N, 3) array
        Positions in the world frame, metres.
    quaternions : (N, 4) array
        Rotations as x, y, z, w (the scalar last, as in TUM files). Lengths within
        1e-3 of one are normalized.

    Returns
    -------
    (N, 4, 4) array
        Homogeneous matrices, robot frame to world frame.

    Raises
    ------
    AmrError
        If a shape is wrong, the lengths differ, an entry is not finite, or a
        quaternion is zero or not of unit length.

    References
    ----------
    Barfoot, State Estimation for Robotics (2017), section 6.2.3.

    Examples
    --------
    A quarter turn about the vertical takes the robot's x axis to the world's y.

    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.spatial_poses([[0, 0, 0]], [[0, 0, 0.5**0.5, 0.5**0.5]])
    >>> np.allclose(X[0, :3, 0], [0, 1, 0])
    True
    """
    xyz = as_rows(xyz, "xyz", (3,), "spatial positions")
    q = as_rows(quaternions, "quaternions", (4,), "quaternions x, y, z, w")
    if len(q) != len(xyz):
        raise AmrError(
            f"xyz has {len(xyz)} rows and quaternions has {len(q)}; one rotation per position is "
            "needed."
        )
    length = np.linalg.norm(q, axis=1)
    off = np.abs(length - 1) > UNIT_QUATERNION_WITHIN
    if off.any():
        k = int(np.argmax(off))
        what = "is zero" if length[k] == 0 else f"has length {length[k]:.6g}"
        raise AmrError(
            f"quaternions[{k}] {what}; a rotation needs length 1 within "
            f"{UNIT_QUATERNION_WITHIN:g}. The order is x, y, z, w."
        )
    x, y, z, w = (q / length[:, None]).T
    X = np.zeros((len(xyz), 4, 4))
    X[:, 0, 0] = 1 - 2 * (y * y + z * z)
    X[:, 0, 1] = 2 * (x * y - z * w)
    X[:, 0, 2] = 2 * (x * z + y * w)
    X[:, 1, 0] = 2 * (x * y + z * w)
    X[:, 1, 1] = 1 - 2 * (x * x + z * z)
    X[:, 1, 2] = 2 * (y * z - x * w)
    X[:, 2, 0] = 2 * (x * z - y * w)
    X[:, 2, 1] = 2 * (y * z + x * w)
    X[:, 2, 2] = 1 - 2 * (x * x + y * y)
    X[:, :3, 3] = xyz
    X[:, 3, 3] = 1
    return X


def inverse(X: ArrayLike) -> Array:
    """Invert poses: [[R, t], [0, 1]] becomes [[R^T, -R^T t], [0, 1]].

    Parameters
    ----------
    X : (..., d+1, d+1) array
        Poses, d = 2 or 3.

    Returns
    -------
    array
        The inverses, of the same shape.

    Raises
    ------
    AmrError
        If X does not hold rigid motions.

    References
    ----------
    Lecture 01; Barfoot, State Estimation for Robotics (2017), eq. (6.40).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.planar_poses([[1.0, 2.0]], [0.3])
    >>> np.allclose(am.inverse(X) @ X, np.eye(3))
    True
    """
    return _inverse(as_poses(X, "X", batch=True))


def relative(A: ArrayLike, B: ArrayLike) -> Array:
    """Express pose B in the frame of pose A: ``inverse(A) @ B``.

    Parameters
    ----------
    A, B : (..., d+1, d+1) array
        Poses in one world frame; leading axes broadcast.

    Returns
    -------
    array
        The motions that lead from A to B, in the frame of A.

    Raises
    ------
    AmrError
        If A or B does not hold rigid motions, or their shapes do not broadcast.

    References
    ----------
    Kuemmerle et al., On measuring the accuracy of SLAM algorithms, Autonomous
    Robots 27 (2009), eq. (2).

    Examples
    --------
    A robot facing north that moves one meter north has moved one meter ahead.

    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.planar_poses([[0, 0], [0, 1]], [np.pi / 2, np.pi / 2])
    >>> am.positions(am.relative(X[0], X[1])).round(12).tolist()
    [1.0, 0.0]
    """
    A, B = as_poses(A, "A", batch=True), as_poses(B, "B", batch=True)
    try:
        np.broadcast_shapes(A.shape, B.shape)
    except ValueError:
        raise AmrError(
            f"A has shape {A.shape} and B has shape {B.shape}; they need the same dimension and "
            "as many poses each (or one)."
        ) from None
    return _inverse(A) @ B


def positions(X: ArrayLike) -> Array:
    """Return the positions of poses.

    Parameters
    ----------
    X : (..., d+1, d+1) array
        Poses, d = 2 or 3.

    Returns
    -------
    (..., d) array
        Positions in the world frame, metres; a copy.

    Raises
    ------
    AmrError
        If X does not hold rigid motions.

    References
    ----------
    Lecture 01.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.positions(am.planar_poses([[2.0, 1.0]], [0.3])).tolist()
    [[2.0, 1.0]]
    """
    return as_poses(X, "X", batch=True)[..., :-1, -1].copy()


def yaw(X: ArrayLike) -> Any:
    """Return the heading of poses: the direction of the robot's x axis seen from above.

    Parameters
    ----------
    X : (..., d+1, d+1) array
        Poses, d = 2 or 3; in space the world's z axis points up.

    Returns
    -------
    float or array
        Angles in radians, in [-pi, pi).

    Raises
    ------
    AmrError
        If X does not hold rigid motions, or a robot's x axis is vertical and so
        has no heading.

    References
    ----------
    Lecture 01.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.yaw(am.planar_poses([[0, 0], [0, 0]], [0.5, 4.0])).round(6).tolist()
    [0.5, -2.283185]
    """
    X = as_poses(X, "X", batch=True)
    x, y = X[..., 0, 0], X[..., 1, 0]
    vertical = np.hypot(x, y) < 1e-9
    if vertical.any():
        raise AmrError(
            f"{int(vertical.sum())} poses of X have a vertical x axis (gimbal lock); their yaw is "
            "undefined. Use rotation_angle, or another body axis as heading."
        )
    return wrap(np.arctan2(y, x))


def rotation_angle(X: ArrayLike) -> Any:
    """Return the angle of the rotation in each pose, without its axis.

    Parameters
    ----------
    X : (..., d+1, d+1) array
        Poses, d = 2 or 3, usually relative ones.

    Returns
    -------
    float or array
        Angles in radians, in [0, pi], accurate near both ends. The arccosine of
        the trace, found in most codes, loses half of the digits there.

    Raises
    ------
    AmrError
        If X does not hold rigid motions.

    References
    ----------
    Lecture 01: 2 sin(angle) = ||vee(R - R^T)||, 2 cos(angle) = trace(R) - 1 in space.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.rotation_angle(am.planar_poses([[0, 0], [0, 0]], [-0.5, 1e-9])).tolist()
    [0.5, 1e-09]
    """
    R = as_poses(X, "X", batch=True)[..., :-1, :-1]
    angle = angle_of(np.moveaxis(R, (-2, -1), (0, 1)))
    return angle if angle.ndim else float(angle)


def angle_of(R):
    """Return the rotation angle of matrices whose entries come first, shape (d, d, ...)."""
    if len(R) == 2:
        return np.arctan2(np.abs(R[1, 0] - R[0, 1]), R[0, 0] + R[1, 1])
    a, b, c = R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]
    return np.arctan2(np.sqrt(a * a + b * b + c * c), R[0, 0] + R[1, 1] + R[2, 2] - 1)


def path_length(X: ArrayLike) -> float:
    """Return the length of the path: the sum of the distances between successive positions.

    Parameters
    ----------
    X : (N, d+1, d+1) or (N, d) array
        Poses or positions in order of time, d = 2 or 3.

    Returns
    -------
    float
        Metres; 0.0 for one sample. Measurement noise makes a path longer, the
        more so the higher the sampling rate.

    Raises
    ------
    AmrError
        If X holds no samples, wrong shapes or entries that are not finite.

    References
    ----------
    Lecture 03.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.path_length([[0, 0], [3, 4], [3, 5]])
    6.0
    """
    steps = np.diff(as_positions(X, "X"), axis=0)
    return float(np.sqrt(np.einsum("ij,ij->i", steps, steps)).sum())


def project(X: ArrayLike, plane: str = "xy") -> Array:
    """Project spatial poses to a coordinate plane.

    Parameters
    ----------
    X : (N, 4, 4) array
        Poses in space.
    plane : {"xy", "xz", "yz"}
        The plane to keep, its first letter the horizontal axis of the result.

    Returns
    -------
    (N, 3, 3) array
        Planar poses: the two coordinates, meters, and as heading the direction of the
        projected body axis of the first letter. The heading keeps its full turn.

    Raises
    ------
    AmrError
        If X does not hold spatial poses, the plane is unknown, or a body axis is
        perpendicular to the plane and so has no heading there.

    References
    ----------
    Lecture 01. A heading taken from Euler angles (the pitch of roll, pitch, yaw) folds at
    90 degrees in the xz plane.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.spatial_poses([[1, 2, 3]], [[0, np.sin(1.2), 0, np.cos(1.2)]])
    >>> am.positions(am.project(X, "xz")).tolist()
    [[1.0, 3.0]]
    >>> am.yaw(am.project(X, "xz")).round(6).tolist()
    [-2.4]
    """
    if plane not in ("xy", "xz", "yz"):
        raise AmrError(f"plane is {plane!r}; expected 'xy', 'xz' or 'yz'.")
    X = as_poses(X, "X")
    if X.shape[-1] != 4:
        raise AmrError(f"X has shape {X.shape}; only spatial poses (N, 4, 4) can be projected.")
    a, b = ("xyz".index(letter) for letter in plane)
    along, across = X[:, a, a], X[:, b, a]
    upright = np.hypot(along, across) < 1e-9
    if upright.any():
        raise AmrError(
            f"the body's {plane[0]} axis is perpendicular to the {plane} plane in {upright.sum()} "
            f"poses of X, first at index {upright.argmax()}; it has no heading there. Choose "
            "another plane."
        )
    return planar_poses(X[:, [a, b], 3], np.arctan2(across, along))


def _inverse(X):
    d = X.shape[-1] - 1
    Y = np.zeros_like(X)
    Y[..., :d, :d] = np.swapaxes(X[..., :d, :d], -1, -2)
    Y[..., :d, d] = -np.einsum("...ji,...j->...i", X[..., :d, :d], X[..., :d, d])
    Y[..., d, d] = 1
    return Y
