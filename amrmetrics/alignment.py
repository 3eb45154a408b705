"""Bring an estimated trajectory into the frame of the reference, in closed form.

`align` minimizes J(R, t) = sum_k ||p_k - (s R q_k + t)||^2 over what its mode leaves
free, p the reference and q the estimate. Lecture 02 derives every line.
"""

from dataclasses import dataclass

import numpy as np

from amrmetrics._arguments import as_poses, as_position_pair, as_positions
from amrmetrics.errors import AmrError, DegenerateAlignmentError

MODES = ("rigid", "similarity", "yaw", "none")

# A rotation is refused when turning it changes the match by less than this part of
# the whole: a millimeter sideways on a hundred meters.
UNDETERMINED = 1e-10
# A path with less sideways motion than this part of the whole (squared lengths) is nearly
# straight; its sideways motions must agree better than two noises do by chance.
NEARLY_STRAIGHT = 1e-3


@dataclass(frozen=True, eq=False)
class Alignment:
    """The transformation that `align` found: p is close to scale * rotation @ q + translation.

    Attributes
    ----------
    rotation : (d, d) array
        From the estimate's frame to the reference's.
    translation : (d,) array
        Meters, in the reference's frame.
    scale : float
        1.0 unless the mode is "similarity".
    residual : float
        What is left: the sum of squared distances, square meters.
    mode : str
        "rigid", "similarity", "yaw" or "none".
    n : int
        Number of positions.
    """

    rotation: np.ndarray
    translation: np.ndarray
    scale: float
    residual: float
    mode: str
    n: int

    @property
    def angle(self):
        """Rotation angle in radians: signed in the plane and for yaw, in [0, pi] in space."""
        R = self.rotation
        if len(R) == 2 or self.mode == "yaw":
            return float(np.arctan2(R[1, 0], R[0, 0]))
        from amrmetrics.poses import rotation_angle

        X = np.eye(4)
        X[:3, :3] = R
        return rotation_angle(X)

    @property
    def rmse(self):
        """Root mean square distance after alignment, meters."""
        return float(np.sqrt(self.residual / self.n))

    def apply(self, estimate):
        """Move an estimate into the reference's frame.

        Parameters
        ----------
        estimate : (M, d) or (M, d+1, d+1) array
            Positions or poses, also ones that the alignment has not seen.

        Returns
        -------
        array
            Of the same shape. A similarity scales positions, never rotations.

        Raises
        ------
        AmrError
            If the estimate has the wrong dimension or shape.
        """
        d = len(self.translation)
        poses = np.ndim(estimate) == 3
        moved = np.array(as_poses(estimate, "estimate") if poses else estimate)
        q = as_positions(moved, "estimate")
        if q.shape[1] != d:
            raise AmrError(f"estimate is {q.shape[1]}-D, but the alignment was made in {d}-D.")
        aligned = self.scale * q @ self.rotation.T + self.translation
        if not poses:
            return aligned
        moved[:, :d, :d] = self.rotation @ moved[:, :d, :d]
        moved[:, :d, d] = aligned
        return moved

    def __repr__(self):
        rows = ", ".join(f"{name}={text}" for name, text in self._rows()[1:])
        return f"Alignment({self._rows()[0][1]}, {rows})"

    def _repr_html_(self):
        rows = "".join(f"<tr><th>{name}</th><td>{text}</td></tr>" for name, text in self._rows())
        return f"<table>{rows}</table>"

    def _rows(self):
        t = ", ".join(f"{x:.6g}" for x in self.translation)
        return [
            ("alignment", f"{self.mode} {len(self.translation)}-D"),
            ("n", f"{self.n}"),
            ("angle", f"{np.degrees(self.angle):.6g} deg"),
            ("translation", f"({t}) m"),
            ("scale", f"{self.scale:.9g}"),
            ("rmse", f"{self.rmse:.6g} m"),
        ]


def align(reference, estimate, mode="rigid"):
    """Find the transformation that brings the estimate closest to the reference.

    Parameters
    ----------
    reference, estimate : (N, d) or (N, d+1, d+1) array
        Positions or poses in meters, d = 2 or 3; sample k of one belongs to sample
        k of the other. Only positions are used.
    mode : {"rigid", "similarity", "yaw", "none"}
        What is free: rotation and translation; these and a scale (for a monocular
        camera); translation and the rotation about the vertical z axis (for an
        estimate that knows gravity); nothing. In the plane "yaw" is "rigid".

    Returns
    -------
    Alignment
        With `rotation`, `translation`, `scale`, `angle`, `residual`, `rmse` and
        `apply`.

    Raises
    ------
    DegenerateAlignmentError
        If the positions leave a motion undetermined; the message and `motion` name it.
    AmrError
        If the input is malformed: shapes, lengths, NaN, an unknown mode.

    References
    ----------
    Lecture 02, D1-D22. Umeyama, Least-squares estimation of transformation parameters
    between two point patterns, IEEE TPAMI 13 (1991), eqs. (39)-(43), with his c, R, t
    from estimate to reference. Yaw: Zhang and Scaramuzza, IROS 2018, section IV.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> truth = np.array([[0.0, 0.0], [4.0, 0.0], [4.0, 2.0]])
    >>> estimate = truth @ [[0, -1], [1, 0]] + [1, 5]  # turned by -90 deg, shifted
    >>> a = am.align(truth, estimate)
    >>> round(float(np.degrees(a.angle)), 9), a.translation.round(9).tolist()
    (90.0, [5.0, -1.0])
    >>> np.allclose(a.apply(estimate), truth)
    True
    """
    return fit(*as_position_pair(reference, estimate), mode)[0]


def fit(p, q, mode):
    """Return the Alignment of (N, d) positions and the (N,) squared distances that it leaves."""
    if mode not in MODES:
        raise AmrError(f"mode is {mode!r}; expected one of {', '.join(map(repr, MODES))}.")
    n, d = p.shape
    if mode == "none":
        squares = _squares((p - q).T)
        return Alignment(np.eye(d), np.zeros(d), 1.0, float(squares.sum()), mode, n), squares
    centered = np.empty((2, d, n))  # one piece of memory is had faster than two
    p_mean, q_mean = _center(p, centered[0]), _center(q, centered[1])
    p, q = centered
    p_squares, q_squares = map(_sum_of_squares, centered)
    _refuse_point("reference", p_mean, p_squares, n)
    _refuse_point("estimate", q_mean, q_squares, n)

    K = p @ q.T
    if d == 2 or mode == "yaw":
        R = np.eye(d)
        R[:2, :2], free = _planar_rotation(K)
        axis = np.eye(3)[2, :d]
    else:
        R, axis, free = _rotation(K)
    whole = np.sqrt(p_squares * q_squares)
    if free < NEARLY_STRAIGHT * whole:
        _refuse_undetermined(p, q, R, axis, free, whole, mode)

    # Umeyama's trace(D S) equals trace(R^T K): the part of K that the rotation captures.
    scale = float(np.vdot(R, K) / q_squares) if mode == "similarity" else 1.0
    p -= (scale * R) @ q
    squares = _squares(p)
    found = Alignment(R, p_mean - scale * R @ q_mean, scale, float(squares.sum()), mode, n)
    return found, squares


def _planar_rotation(K):
    """Return the best rotation in the plane and A = sqrt(C^2 + S^2) (lecture 02, D8)."""
    C = K[0, 0] + K[1, 1]
    S = K[1, 0] - K[0, 1]
    A = np.hypot(C, S)
    c, s = (C / A, S / A) if A > 0 else (1.0, 0.0)
    return np.array([[c, -s], [s, c]]), A


def _rotation(K):
    """Return the best rotation for any d, its least determined axis, and how much holds it.

    With K = U diag(sigma) V^T it is U diag(1, ..., 1, det(U V^T)) V^T (Umeyama 1991,
    eq. 43). What holds it about the axis U[:, 0] is the sum of the two last signed
    singular values; in the plane that is A.
    """
    U, sigma, Vt = np.linalg.svd(K)
    sign = np.sign(np.linalg.det(U) * np.linalg.det(Vt))
    U[:, -1] *= sign
    return U @ Vt, U[:, 0], sigma[-2] + sign * sigma[-1]


def _center(x, centered):
    """Write (N, d) positions without their mean to the (d, N) array, and return the mean."""
    centered[:] = x.T
    mean = centered.mean(axis=1)
    centered -= mean[:, None]
    # Far from the origin, as map coordinates of 5e6 m are, the mean has lost digits: once more.
    if np.abs(mean).max() > 1e3 * np.abs(x[0] - mean).max():
        rest = centered.mean(axis=1)
        centered -= rest[:, None]
        mean += rest
    return mean


def _squares(x):
    return np.einsum("kn,kn->n", x, x)


def _sum_of_squares(x):
    return float(np.vdot(x, x))


def _refuse_point(name, mean, squares, n):
    """Raise if all positions coincide, up to the rounding of their coordinates."""
    if np.sqrt(squares / n) <= 64 * np.finfo(float).eps * np.abs(mean).max():
        many = "a single position" if n == 1 else f"{n} positions that all coincide"
        raise DegenerateAlignmentError(
            f"{name} is {many}: any rotation about it fits equally well. Use data in which "
            "the robot moves, or mode='none'.",
            "any rotation",
        )


def _refuse_undetermined(p, q, R, axis, free, whole, mode):
    """Raise if turning the estimate further about `axis` hardly changes the residual.

    The cost of a turn by phi is 2 * free * (1 - cos phi), so `free` is compared with what
    it could be: the whole motion, and for a nearly straight path the motion sideways. There
    two unrelated noises still give free of order 1 / sqrt(n), hence the 4 / sqrt(n).
    """
    side = np.sqrt(_sum_of_squares(_sideways(p, axis)) * _sum_of_squares(_sideways(q, R.T @ axis)))
    straight = side < NEARLY_STRAIGHT * whole
    if free > UNDETERMINED * whole and not (
        straight and free < min(0.5, 4 / p.shape[1] ** 0.5) * side
    ):
        return
    if len(p) == 2:
        motion, line = "the rotation angle", "a point"
    elif mode == "yaw":
        motion, line = "the rotation about the vertical (yaw)", "a vertical line"
    else:
        axis = axis * np.sign(axis[np.abs(axis).argmax()])
        direction = ", ".join(f"{x:.2f}" for x in axis.round(2) + 0.0)
        motion = f"the rotation about the direction ({direction})"
        line = "a straight line, up to noise"
    why = (
        f"they lie on {line}"
        if straight
        else "all angles fit equally well, because one path mirrors the other (check the signs of "
        "the axes) or has nothing to do with it"
    )
    with_yaw = "mode='yaw' if both know the vertical, " if line.startswith("a straight") else ""
    raise DegenerateAlignmentError(
        f"the positions do not determine {motion}: {why}. Use data with more motion, {with_yaw}"
        "or mode='none'.",
        motion,
    )


def _sideways(x, axis):
    return x - np.outer(axis, axis @ x)
