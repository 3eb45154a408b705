"""Bring an estimated trajectory into the frame of the reference, in closed form.

`align` minimizes J(R, t) = sum_k ||p_k - (s R q_k + t)||^2 over what its mode leaves
free, p the reference and q the estimate. Lecture 02 derives every line.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import (
    BLOCK,
    as_count,
    as_pose_pair,
    as_poses,
    as_position_pair,
    as_positions,
    block_squares,
    blocks,
    lengths,
)
from amrmetrics._results import Result
from amrmetrics.errors import AmrError, DegenerateAlignmentError
from amrmetrics.poses import angle_of

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike

MODES = ("rigid", "similarity", "yaw", "origin", "none")

# A rotation is refused when turning it changes the match by less than this part of
# the whole: a millimeter sideways on a hundred meters.
UNDETERMINED = 1e-10
# A path with less sideways motion than this part of the whole (squared lengths) is nearly
# straight; its sideways motions must agree better than two noises do by chance.
NEARLY_STRAIGHT = 1e-3
# Samples whose mean stands for that of all, to center by.
SOME = 1000


@dataclass(frozen=True, eq=False, repr=False)
class Alignment(Result):
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
        "rigid", "similarity", "yaw", "origin" or "none".
    n : int
        Number of positions that it was found from.
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
        return float(angle_of(R))

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
        aligned = np.einsum("ij,nj->ni", self.scale * self.rotation, q) + self.translation
        if not poses:
            return aligned
        moved[:, :d, :d] = np.einsum("ij,njk->nik", self.rotation, moved[:, :d, :d])
        moved[:, :d, d] = aligned
        return moved

    def __repr__(self):
        rows = ", ".join(f"{name}={text}" for name, text in self._rows()[1:])
        return f"Alignment({self._rows()[0][1]}, {rows})"

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


def align(
    reference: ArrayLike, estimate: ArrayLike, mode: str = "rigid", first: int | None = None
) -> Alignment:
    """Find the transformation that brings the estimate closest to the reference.

    Parameters
    ----------
    reference, estimate : (N, d) or (N, d+1, d+1) array
        Positions or poses in meters, d = 2 or 3; sample k of one belongs to sample
        k of the other. Only positions are used.
    mode : {"rigid", "similarity", "yaw", "origin", "none"}
        What is free: rotation and translation; these and a scale (for a monocular
        camera); translation and the rotation about the vertical z axis (for an
        estimate that knows gravity); nothing, but the first poses are laid on each other;
        nothing. In the plane "yaw" is "rigid".
    first : int, optional
        How many of the first positions to use; all of them by default.

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
    Lecture 02, D1-D13 and D22-D28. Umeyama, Least-squares estimation of transformation parameters
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
    p, q = as_position_pair(reference, estimate)
    return fit(p, q, mode, first, first_poses(reference, estimate, mode))[0]


def first_poses(reference, estimate, mode):
    """Return the first poses if the mode is "origin", which is what it lays on each other."""
    if mode != "origin":
        return None
    X, Y = as_pose_pair(reference, estimate)
    return X[0], Y[0]


def fit(p, q, mode, first=None, origin=None):
    """Return the Alignment of (N, d) positions and the (N,) distances that it leaves.

    Only the `first` ones are used to find it, all of them by default; `origin` has the first
    poses for the mode of this name. Positions are worked on in blocks that stay in the
    processor's cache, and too few for the threads of BLAS, which wait for each other on a busy
    machine.
    """
    if mode not in MODES:
        raise AmrError(f"mode is {mode!r}; expected one of {', '.join(map(repr, MODES))}.")
    n, d = p.shape
    used = n if first is None else min(n, as_count(first, "first"))
    R, t, scale = np.eye(d), np.zeros(d), 1.0
    if mode == "origin":
        X, Y = origin
        R = X[:d, :d] @ Y[:d, :d].T
        t = X[:d, d] - R @ Y[:d, d]
    elif mode != "none":
        R, t, scale = _find(p[:used], q[:used], mode)
    distances = np.empty(n)
    for block, P, Q in _blocks_of(p, q, t, np.zeros(d)):
        P -= np.einsum("ij,jn->in", scale * R, Q)
        distances[block] = lengths(P)
    residual = float(np.einsum("n,n->", distances[:used], distances[:used]))
    return Alignment(R, t, scale, residual, mode, used), distances


def _find(p, q, mode):
    """Return rotation, translation and scale that bring q closest to p."""
    n, d = p.shape
    p_mean, q_mean, p_squares, q_squares, K = _moments(p, q)
    _refuse_point("reference", p_mean, p_squares, n)
    _refuse_point("estimate", q_mean, q_squares, n)
    if d == 2 or mode == "yaw":
        R = np.eye(d)
        R[:2, :2], free = _planar_rotation(K)
        axis = np.eye(3)[2, :d]
    else:
        R, axis, free = _rotation(K)
    whole = np.sqrt(p_squares * q_squares)
    if free < NEARLY_STRAIGHT * whole:
        centered = (p - p_mean).T, (q - q_mean).T
        _refuse_undetermined(*centered, R, axis, free, whole, mode)

    # Umeyama's trace(D S) equals trace(R^T K): the part of K that the rotation captures.
    scale = float((R * K).sum() / q_squares) if mode == "similarity" else 1.0
    return R, p_mean - scale * R @ q_mean, scale


def _moments(p, q):
    """Return the means, the sums of squares about them and K = sum (p - mean)(q - mean)^T."""
    n, d = p.shape
    # About a point near the mean no digits are lost, not even at map coordinates of 5e6 m.
    some = [np.ascontiguousarray(x[:: max(1, n // SOME)]) for x in (p, q)]
    near = [x[0] + (x - x[0]).mean(axis=0) for x in some]
    sums, squares, K = np.zeros((2, d)), np.zeros(2), np.zeros((d, d))
    for _, P, Q in _blocks_of(p, q, *near):
        sums += np.einsum("in->i", P), np.einsum("in->i", Q)
        squares += block_squares(P), block_squares(Q)
        K += np.vecdot(P[:, None], Q)
    rest = sums / n
    squares = np.maximum(squares - n * (rest**2).sum(axis=1), 0)
    return *(near + rest), *squares, K - n * np.outer(*rest)


def _blocks_of(p, q, p_center, q_center):
    """Yield slices of samples with the positions p and q in them, centered, as rows."""
    buffer = np.empty((2, p.shape[1], min(len(p), BLOCK)))
    for block in blocks(len(p)):
        P, Q = rows = buffer[:, :, : len(p[block])]
        np.subtract(p[block].T, p_center[:, None], out=P)
        np.subtract(q[block].T, q_center[:, None], out=Q)
        yield block, *rows


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


def nearest_rotation(K):
    """Return the rotation R that makes trace(R^T K) largest."""
    return _rotation(K)[0]


def _sum_of_squares(x):
    return float(np.einsum("kn,kn->", x, x))


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
