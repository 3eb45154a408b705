"""Read an argument into an array, or refuse it with a message that helps.

Every public function passes its arrays through here once, so that the same
mistake gets the same message everywhere.
"""

import numpy as np

from amrmetrics.errors import AmrError

# Squares of larger numbers overflow; no robot is that far away.
LARGEST = 1e100

# Rotation matrices read from text keep six or seven digits.
ORTHONORMAL_WITHIN = 1e-5


def as_numbers(value, name):
    """Return `value` as an array of finite doubles."""
    array = _as_array(value, name)
    if array.dtype.kind not in "fiu":
        # Strings and complex numbers convert to float in ways nobody means.
        raise AmrError(
            f"{name} must be an array of real numbers; its entries are of type {array.dtype}."
        )
    array = array.astype(float, copy=False)
    bad = ~np.isfinite(array)
    if bad.any():
        raise AmrError(
            f"{name}{_first(bad)} is {array[bad][0]}; entries of {name} that are NaN or infinite: "
            f"{bad.sum()}. Remove or interpolate those samples first."
        )
    return array


def as_rows(value, name, widths, meaning):
    """Return `value` as an (N, w) array with N >= 1 and w one of `widths`."""
    array = as_numbers(value, name)
    if array.ndim != 2 or array.shape[1] not in widths:
        shapes = " or ".join(f"(N, {width})" for width in widths)
        raise AmrError(
            f"{name} has shape {array.shape}; {meaning} need shape {shapes}, one row per sample."
        )
    return _with_samples(array, name)


def as_poses(value, name, batch=False):
    """Return `value` as homogeneous matrices (N, d+1, d+1), d = 2 or 3, of rigid motions.

    With `batch`, any number of leading axes is allowed, none included.
    """
    array = as_numbers(value, name)
    square = array.ndim >= 2 and array.shape[-2:] in ((3, 3), (4, 4))
    if not square or (array.ndim != 3 and not batch):
        raise AmrError(
            f"{name} has shape {array.shape}; poses need shape (N, 3, 3) for the plane or "
            "(N, 4, 4) for space. planar_poses and spatial_poses make them."
        )
    _with_samples(array, name)
    d = array.shape[-1] - 1
    last_row = np.eye(d + 1)[d]
    wrong = (array[..., d, :] != last_row).any(-1)
    if wrong.any():
        raise AmrError(
            f"{name}{_first(wrong)} has the last row {array[..., d, :][wrong][0].tolist()}; a "
            f"homogeneous matrix ends with {last_row.tolist()}. Is it transposed?"
        )
    refuse_non_rotations(array[..., :d, :d], name)
    return array


def refuse_non_rotations(R, name):
    """Raise unless every matrix of `R`, shape (..., d, d), is a rotation."""
    d = R.shape[-1]
    gram = np.einsum("...ki,...kj->...ij", R, R)
    off = np.abs(gram - np.eye(d)).max((-2, -1)) > ORTHONORMAL_WITHIN
    if off.any():
        index = _first(off)
        raise AmrError(
            f"{name}{index} is not a pose: its {d}x{d} block is not a rotation matrix "
            f"(R^T R differs from the identity by more than {ORTHONORMAL_WITHIN:g}). "
            "Scale, shear and rounded entries have to be removed first."
        )
    mirrored = np.linalg.det(R) < 0
    if mirrored.any():
        raise AmrError(
            f"{name}{_first(mirrored)} is a reflection (determinant -1), not a rotation. "
            "One axis of the frame has the wrong sign."
        )


def as_position_pair(reference, estimate):
    """Return both trajectories as (N, d) position arrays of one shape."""
    p = as_positions(reference, "reference")
    q = as_positions(estimate, "estimate")
    if p.shape[1] != q.shape[1]:
        raise AmrError(
            f"reference is {p.shape[1]}-D and estimate is {q.shape[1]}-D; both must live in the "
            "same space. Project the spatial one to the plane first."
        )
    if len(p) != len(q):
        raise AmrError(
            f"reference has {len(p)} samples and estimate has {len(q)}; sample k of one must "
            "belong to sample k of the other. Associate them by their time stamps first."
        )
    return p, q


def as_positions(value, name):
    """Return (N, d) positions from positions or from poses (N, d+1, d+1)."""
    array = _as_array(value, name)
    if array.ndim == 3:
        if array.shape[1:] not in ((3, 3), (4, 4)):
            as_poses(array, name)  # says what is wrong
        array = array[:, :-1, -1]
    array = as_rows(array, name, (2, 3), "positions")
    if np.abs(array).max() > LARGEST:
        raise AmrError(
            f"{name} holds a coordinate of {np.abs(array).max():.3g} m; more than {LARGEST:g} m "
            "cannot be squared. Check the units."
        )
    return array


def _as_array(value, name):
    try:
        return np.asarray(value)
    except ValueError:
        raise AmrError(f"{name} is not an array: its rows have different lengths.") from None


def _with_samples(array, name):
    if array.size == 0:
        raise AmrError(f"{name} is empty (shape {array.shape}); at least one sample is needed.")
    return array


def _first(mask):
    """Index of the first True, written as in the code: "[3, 1]", or "" for a single value."""
    return str(np.argwhere(mask)[0].tolist()) if np.ndim(mask) else ""
