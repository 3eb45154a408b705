"""Where on the robot an estimate is measured: its lever arm, from the two paths (lecture 03)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_poses, as_position_pair
from amrmetrics._results import Result
from amrmetrics.alignment import Alignment, fit, nearest_rotation
from amrmetrics.errors import AmrError, DegenerateAlignmentError
from amrmetrics.recording import Trajectory, coverage_of

if TYPE_CHECKING:
    from amrmetrics._types import Array, ArrayLike

MODES = ("rigid", "similarity", "yaw", "none")
# A robot whose orientations vary by less about an axis (root mean square, radians: three degrees)
# shows no offset there: noise of the orientations would pass for turns.
TURNS = 0.05
# Stretches of the run whose errors are taken as independent of each other.
STRETCHES = 20
STEPS = 100
# Steps are halved so often, and end when they are this part of the offset and of the distances.
HALVINGS = 20
CONVERGED = 1e-10
# A scale that shrinks to this part of itself on the way found a point that stands still.
COLLAPSED = 0.1


@dataclass(frozen=True, eq=False, repr=False)
class LeverArm(Result):
    """How far the estimate's point is from the reference's, in the reference's body frame.

    Attributes
    ----------
    offset : (d,) array
        Meters; the estimate's point is at ``X[k] @ [*offset, 1]``.
    standard_error : (d,) array
        Meters, one standard deviation of each. Errors that last are allowed for, as long as
        they last less than a twentieth of the run.
    rmse : float
        What is left of the distances, meters.
    rmse_without : float
        What the alignment alone leaves, meters.
    alignment : Alignment
        Of the estimate with the reference's poses moved to the estimate's point.
    n : int
        Number of samples.
    turn : (d, d) array or None
        The estimate's orientation in the reference's body frame, None if it has none.
    """

    offset: Array
    standard_error: Array
    rmse: float
    rmse_without: float
    alignment: Alignment
    n: int
    turn: Array | None = field(default=None, repr=False)

    @property
    def body(self) -> Array:
        """What `ate` and the others take as ``body=`` to measure at the reference's point.

        (d+1, d+1) array. It moves the point and leaves the orientation of the estimate as it is.
        """
        if self.turn is None:
            raise AmrError(
                "the estimate has no orientations, which body= needs. Move the reference to its "
                "point instead: arm.apply(reference)."
            )
        d = len(self.offset)
        body = np.eye(d + 1)
        body[:d, d] = -self.turn.T @ self.offset / self.alignment.scale
        return body

    def apply(self, reference: ArrayLike) -> Array | Trajectory:
        """Move poses of the reference to the estimate's point.

        Parameters
        ----------
        reference : (M, d+1, d+1) array or Trajectory
            Poses, also ones that were not used to find the offset.

        Returns
        -------
        array or Trajectory
            As given, with the orientations as they were.

        Raises
        ------
        AmrError
            If the dimension is another one, or these are no poses.
        """
        d = len(self.offset)
        body = np.eye(d + 1)
        body[:d, d] = self.offset
        poses = as_poses(reference, "reference")
        if poses.shape[1:] != body.shape:
            raise AmrError(f"reference has shape {poses.shape}; expected (N, {d + 1}, {d + 1}).")
        moved = poses @ body
        return replace(reference, poses=moved) if isinstance(reference, Trajectory) else moved

    def __repr__(self):
        return f"{self._title()}: {', '.join(f'{name} {text}' for name, text in self._rows())}"

    def _title(self):
        return "lever arm"

    def _rows(self):
        pairs = zip(self.offset, self.standard_error, strict=True)
        offset = ", ".join(f"{x:.4g} ± {e:.2g}" for x, e in pairs)
        return [
            ("offset", f"({offset}) m in the reference's body frame"),
            ("rmse", f"{self.rmse:.4g} m, without it {self.rmse_without:.4g} m"),
            ("alignment", self.alignment.mode),
            ("n", f"{self.n}"),
        ]


def lever_arm(reference: ArrayLike, estimate: ArrayLike, mode: str = "rigid") -> LeverArm:
    """Find the constant offset of the estimate's point in the reference's body frame.

    Parameters
    ----------
    reference : (N, d+1, d+1) array or Trajectory
        Poses, d = 2 or 3. Where only the estimate has orientations, as beside a prism or GNSS,
        exchange the two: the offset is then that of the prism in the estimate's body frame.
    estimate : (N, d+1, d+1) or (N, d) array or Trajectory
        Poses or positions, sample by sample at the same times.
    mode : {"rigid", "similarity", "yaw", "none"}
        What else is free, as in `align`.

    Returns
    -------
    LeverArm
        `offset` with its standard error, and `body` for the ``body=`` of `ate`.

    Raises
    ------
    DegenerateAlignmentError
        If the motion leaves a part of the offset undetermined; the message and `motion` name
        it. A robot that only turns about one axis shows no offset along it, one that never
        turns shows none at all.
    AmrError
        If the input is malformed.

    References
    ----------
    Lecture 03, D14-D15. The offset and the alignment minimize
    sum_k ||p_k + R_k l - (s R q_k + t)||^2: for a given l, R, t and s are Umeyama's, and l
    follows by Gauss-Newton steps with these eliminated (Golub and Pereyra, The differentiation of
    pseudo-inverses and nonlinear least squares problems, SIAM J. Numer. Anal. 10 (1973)). The
    standard error sums errors over stretches as Liang and Zeger, Biometrika 73 (1986).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 60, 0.1)
    >>> X = am.planar_poses(np.c_[t, 3 * np.sin(t / 3)], np.arctan(np.cos(t / 3)))
    >>> noise = 0.01 * np.random.default_rng(1).normal(size=(600, 2))
    >>> camera = am.positions(X @ am.planar_poses([[0.4, -0.1]], [0])) + noise
    >>> arm = am.lever_arm(X, camera)
    >>> arm.offset.round(2).tolist()
    [0.4, -0.1]
    """
    coverage_of(reference, estimate)
    if getattr(reference, "why_no_orientation", ""):
        raise AmrError(
            f"reference has no orientations: {reference.why_no_orientation}. If the estimate has, "
            "exchange the two: the offset is then that of the reference's point in the estimate's "
            "body frame."
        )
    if mode not in MODES:
        raise AmrError(f"mode is {mode!r}; expected one of {', '.join(map(repr, MODES))}.")
    X = as_poses(reference, "reference")
    p, q = as_position_pair(reference, estimate)
    oriented = np.ndim(estimate) == 3
    return solve(X, p, q, mode, as_poses(estimate, "estimate") if oriented else None)


def solve(X, p, q, mode, Y=None):
    """Return the LeverArm of poses X at p and of positions q, those of the poses Y if given."""
    n, d = p.shape
    R = X[:, :d, :d]
    turning = R if mode == "none" else R - R.mean(axis=0)
    _refuse_undetermined(np.einsum("nki,nkj->ij", turning, turning) / n, "")
    offset = np.zeros(d)
    found, distances = fit(p, q, mode)
    without, scale = found.rmse, found.scale
    for _ in range(STEPS):
        columns, rest = _linearized(R, p, q, offset, found)
        information, change = _step(columns, rest, d)
        _refuse_undetermined(information / n, " together with the alignment")
        if np.abs(change).max() <= CONVERGED * (np.abs(offset).max() + distances.max()):
            break
        for _ in range(HALVINGS):
            better = fit(p + R @ (offset + change), q, mode)[0]
            if better.residual < found.residual:
                break
            change = change / 2
        else:
            break
        offset, found = offset + change, better
        if mode == "similarity" and found.scale < COLLAPSED * scale:
            at = ", ".join(f"{x:.3g}" for x in offset)
            raise DegenerateAlignmentError(
                "the motion does not determine the offset together with the scale: the point at "
                f"({at}) of the body hardly moves, and an estimate scaled to nothing fits it. Use "
                "mode='rigid' if the scale is known.",
                "the offset together with the scale",
            )
    turn = None
    if Y is not None:
        turn = nearest_rotation(np.einsum("nji,jk,nkl->il", R, found.rotation, Y[:, :d, :d]))
    error = _standard_error(columns, rest, d)
    return LeverArm(offset, error, found.rmse, without, found, n, turn)


def _refuse_undetermined(information, how):
    """Raise if the motion does not show the offset in some direction of the body."""
    strength, axes = np.linalg.eigh(information)
    hidden = axes[:, strength < TURNS**2].T
    if not len(hidden):
        return
    if len(hidden) == len(information):
        motion, why = "the offset", "the robot hardly turns"
    else:
        named = " and ".join(map(_direction, hidden))
        motion = f"the offset along {named} of the body"
        why = f"the robot turns about {named} only"
    if how:
        why = "turning the world and moving the point on the body fit equally well, as on a circle"
    in_plane = "project both to the plane, " if len(information) == 3 else ""
    raise DegenerateAlignmentError(
        f"the motion does not determine {motion}{how}: {why}. Use data with other turns, "
        f"{in_plane}or mode='none' if both have one world frame.",
        motion,
    )


def _direction(axis):
    axis = axis * np.sign(axis[np.abs(axis).argmax()])
    return f"({', '.join(f'{x:.2f}' for x in axis.round(2) + 0.0)})"


def _linearized(R, p, q, offset, found):
    """Return how the distances change with what is free, (N, d, m), and these, (N, d).

    The first d columns are the offset's. The translation is eliminated by centering.
    """
    d = len(offset)
    rest = p + R @ offset - found.apply(q)
    if found.mode == "none":
        return R, rest
    y = found.apply(q) - found.translation
    y -= y.mean(axis=0)
    columns = [R - R.mean(axis=0)]
    if d == 2:
        columns.append(np.stack([y[:, 1], -y[:, 0]], axis=1)[..., None])
    else:
        axes = np.eye(3)[2:] if found.mode == "yaw" else np.eye(3)
        columns.append(-np.cross(axes, y[:, None]).swapaxes(1, 2))
    if found.mode == "similarity":
        columns.append(-y[..., None])
    return np.concatenate(columns, axis=2), rest


def _step(columns, rest, d):
    """Return the information about the offset, the others eliminated, and its next change."""
    H = np.einsum("nim,nil->ml", columns, columns)
    g = np.einsum("nim,ni->m", columns, rest)
    others = H[:d, d:] @ np.linalg.pinv(H[d:, d:], hermitian=True)
    information = H[:d, :d] - others @ H[d:, :d]
    return information, -np.linalg.pinv(information, hermitian=True) @ (g[:d] - others @ g[d:])


def _standard_error(columns, rest, d):
    """Return one standard deviation of the offset, from the scatter of the stretches' pulls."""
    n, _, m = columns.shape
    free = m + d * (m > d)  # the translation, too
    inverse = np.linalg.pinv(np.einsum("nim,nil->ml", columns, columns), hermitian=True)
    pulls = np.einsum("nim,ni->nm", columns, rest)
    count = min(STRETCHES, n)
    summed = np.add.reduceat(pulls, np.arange(count) * n // count)
    lasting = inverse @ (summed.T @ summed) @ inverse * count / max(count - free / d, 1)
    alone = inverse * (rest**2).sum() / max(rest.size - free, 1)
    return np.sqrt(np.maximum(np.diag(lasting), np.diag(alone))[:d])
