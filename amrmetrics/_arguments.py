"""Read an argument into an array, or refuse it with a message that helps.

Every public function passes its arrays through here once, so that the same
mistake gets the same message everywhere.
"""

import numpy as np

from amrmetrics.errors import AmrError

# Squares of larger numbers overflow; no robot is that far away.
LARGEST = 1e100

# Squares of smaller numbers lose digits.
SMALLEST = 1e-140

# Rotation matrices read from text keep six or seven digits.
ORTHONORMAL_WITHIN = 1e-5

# Sums of squares within this part of a limit are within it for sure, however they are rounded.
CLOSE = 0.9

# Samples worked on at a time: 8192 poses of 16 doubles are a megabyte, and stay in the cache.
BLOCK = 8192


def as_numbers(value, name):
    """Return `value` as an array of finite doubles."""
    array = as_reals(value, name)
    refuse_not_finite(array, name)
    return array


def as_reals(value, name):
    array = as_array(value, name)
    if array.dtype.kind not in "fiu":
        # Strings and complex numbers convert to float in ways nobody means.
        raise AmrError(
            f"{name} must be an array of real numbers; its entries are of type {array.dtype}."
        )
    return array.astype(float, copy=False)


def refuse_not_finite(array, name):
    bad = ~np.isfinite(array)
    if bad.any():
        raise AmrError(
            f"{name}{first_index(bad)} is {array[bad][0]}; entries of {name} that are NaN or "
            f"infinite: {bad.sum()}. Remove or interpolate those samples first."
        )


def as_rows(value, name, widths, meaning):
    """Return `value` as an (N, w) array with N >= 1 and w one of `widths`."""
    array = _in_rows(as_reals(value, name), name, widths, meaning)
    refuse_not_finite(array, name)
    return array


def _in_rows(array, name, widths, meaning):
    if array.ndim != 2 or array.shape[1] not in widths:
        shapes = " or ".join(f"(N, {width})" for width in widths)
        raise AmrError(
            f"{name} has shape {array.shape}; {meaning} need shape {shapes}, one row per sample."
        )
    return with_samples(array, name)


def as_poses(value, name, batch=False):
    """Return `value` as homogeneous matrices (N, d+1, d+1), d = 2 or 3, of rigid motions.

    With `batch`, any number of leading axes is allowed, none included.
    """
    why = getattr(value, "why_no_orientation", "")
    if why:
        raise AmrError(
            f"{name} has no orientations, which are needed here: {why}. ate, align and "
            "path_length need positions only."
        )
    array = as_reals(value, name)
    square = array.ndim >= 2 and array.shape[-2:] in ((3, 3), (4, 4))
    if not square or (array.ndim != 3 and not batch):
        raise AmrError(
            f"{name} has shape {array.shape}; poses need shape (N, 3, 3) for the plane or "
            "(N, 4, 4) for space. planar_poses and spatial_poses make them."
        )
    with_samples(array, name)
    with np.errstate(over="ignore", invalid="ignore"):
        if not all(map(_are_poses, in_blocks(array.reshape(-1, *array.shape[-2:])))):
            refuse_not_finite(array, name)
            _refuse_non_poses(array, name)
    return array


def _are_poses(X):
    """Say if these are a rotation, a position that can be squared, and the row 0 ... 0 1.

    NaN fails every comparison, so that finite numbers need no pass of their own.
    """
    off = _off_rotation(X)
    if not (X[-1] == np.eye(len(X))[:, -1:]).all():
        return False
    # Few numbers are read twice: a sum of squares within the limit leaves none beyond it.
    return (
        block_squares(off) < CLOSE * ORTHONORMAL_WITHIN**2
        or all(_size(x) < ORTHONORMAL_WITHIN for x in off)
    ) and (block_squares(X[:-1, -1]) < CLOSE * LARGEST**2 or _size(X[:-1, -1]) <= LARGEST)


def _off_rotation(X):
    """Return by how much each sample is no rotation, a few rows of numbers.

    In space: of two columns the squares less 1 and the product, and their cross product less
    the third column.
    """
    n = X.shape[-1]
    if len(X) == 3:
        off = np.empty((3, n))
        np.einsum("kn,kn->n", X[:2, 0], X[:2, 0], out=off[0])
        off[0] -= 1
        np.add(X[0, 1], X[1, 0], out=off[1])
        np.subtract(X[1, 1], X[0, 0], out=off[2])
        return off
    off, product = np.empty((6, n)), np.empty((3, n))
    np.einsum("kjn,kjn->jn", X[:3, :2], X[:3, :2], out=off[:2])
    off[:2] -= 1
    np.einsum("kn,kn->n", X[:3, 0], X[:3, 1], out=off[2])
    cross = off[3:]
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        np.multiply(X[i, 0], X[j, 1], out=cross[k])
        np.multiply(X[j, 0], X[i, 1], out=product[k])
    cross -= product
    cross -= X[:3, 2]
    return off


def block_squares(rows):
    """Return the sum of the squares of rows of a block, too short for BLAS to start threads."""
    return np.vecdot(rows, rows).sum()


def _refuse_non_poses(X, name):
    d = X.shape[-1] - 1
    last_row = np.eye(d + 1)[d]
    wrong = (X[..., d, :] != last_row).any(-1)
    if wrong.any():
        raise AmrError(
            f"{name}{first_index(wrong)} has the last row {X[..., d, :][wrong][0].tolist()}; a "
            f"homogeneous matrix ends with {last_row.tolist()}. Is it transposed?"
        )
    _refuse_huge(X[..., :d, d], name)
    R = X[..., :d, :d]
    off = np.abs(np.einsum("...ki,...kj->...ij", R, R) - np.eye(d)).max((-2, -1))
    mirrored = np.linalg.det(R) < 0
    if off.max() > ORTHONORMAL_WITHIN or not mirrored.any():
        raise AmrError(
            f"{name}{first_index(off == off.max())} is not a pose: its {d}x{d} block is not a "
            f"rotation matrix (R^T R differs from the identity by {off.max():.2g}, more than "
            f"{ORTHONORMAL_WITHIN:g}). Scale, shear and rounded entries have to be removed first."
        )
    raise AmrError(
        f"{name}{first_index(mirrored)} is a reflection (determinant -1), not a rotation. "
        "One axis of the frame has the wrong sign."
    )


def in_blocks(x):
    """Yield `x` in blocks that fit the cache, samples along the last axis, in one buffer.

    Arithmetic on such rows runs several times faster than on N small matrices, and no
    intermediate result grows with N.
    """
    buffer = np.empty((*x.shape[1:], min(len(x), BLOCK)))
    for block in blocks(len(x)):
        rows = buffer[..., : len(x[block])]
        np.copyto(rows, np.moveaxis(x[block], 0, -1))
        yield rows


def blocks(n):
    """Return slices of neighboring samples that fit the cache."""
    return [slice(k, k + BLOCK) for k in range(0, n, BLOCK)]


def lengths(rows):
    """Return the lengths of vectors (d, n), also of those whose squares are no doubles."""
    squares = np.einsum("kn,kn->n", rows, rows)
    found = np.sqrt(squares, out=squares)
    if found.size and not found.min() >= SMALLEST:
        tiny = found < SMALLEST
        largest = np.abs(rows[:, tiny]).max(axis=0)
        scale = np.where(largest > 0, largest, 1)
        found[tiny] = scale * np.sqrt(np.einsum("kn,kn->n", *2 * [rows[:, tiny] / scale]))
    return found


def as_position_pair(reference, estimate):
    """Return both trajectories as (N, d) position arrays of one shape."""
    return _paired(as_positions(reference, "reference"), as_positions(estimate, "estimate"))


def as_pose_pair(reference, estimate):
    """Return both trajectories as (N, d+1, d+1) pose arrays of one shape."""
    return _paired(as_poses(reference, "reference"), as_poses(estimate, "estimate"))


def _paired(p, q):
    d, e = (x.shape[1] - (x.ndim == 3) for x in (p, q))
    if d != e:
        raise AmrError(
            f"reference is {d}-D and estimate is {e}-D; both must live in the same space. "
            "Project the spatial one to the plane first."
        )
    if len(p) != len(q):
        raise AmrError(
            f"reference has {len(p)} samples and estimate has {len(q)}; sample k of one must "
            "belong to sample k of the other. Associate them by their time stamps first."
        )
    return p, q


def as_positions(value, name):
    """Return (N, d) positions from positions or from poses (N, d+1, d+1)."""
    array = as_reals(value, name)
    if array.ndim == 3:
        return _positions_of(array, name)
    if _is_single_pose(array):
        raise AmrError(
            f"{name} is a single pose of shape {array.shape}; a trajectory of one has shape "
            f"(1, {len(array)}, {len(array)}): {name}[None], or X[k : k + 1] in place of X[k]."
        )
    array = _in_rows(array, name, (2, 3), "positions")
    if not np.einsum("nk,nk->", array, array) <= LARGEST**2:  # nor is NaN; one pass for both
        refuse_not_finite(array, name)
        _refuse_huge(array, name)
    return array


def _is_single_pose(array):
    """Say if a square array is one homogeneous matrix and not three positions in space.

    The identity stays what it is to who writes np.eye(3): a point on each axis.
    """
    n = len(array) if array.ndim == 2 else 0
    if n not in (3, 4) or array.shape != (n, n) or (array[-1] != np.eye(n)[-1]).any():
        return False
    with np.errstate(over="ignore", invalid="ignore"):
        is_pose = bool(_are_poses(array[:, :, None]))
    return is_pose and (n == 4 or bool((array != np.eye(3)).any()))


def _positions_of(X, name):
    """Return the positions of poses, which are checked on the way."""
    if X.shape[1:] not in ((3, 3), (4, 4)) or not len(X):
        as_poses(X, name)  # says what is wrong
    columns = np.empty((X.shape[1] - 1, len(X)))  # as alignment works on them
    with np.errstate(over="ignore", invalid="ignore"):
        for block, rows in zip(blocks(len(X)), in_blocks(X), strict=True):
            if not _are_poses(rows):
                as_poses(X, name)
            columns[:, block] = rows[:-1, -1]
    return columns.T


def _refuse_huge(positions, name):
    if _size(positions) > LARGEST:
        raise AmrError(
            f"{name} holds a coordinate of {_size(positions):.3g} m; more than {LARGEST:g} m "
            "cannot be squared. Check the units."
        )


def _size(array):
    return max(array.max(), -array.min())


def as_stamps(value, name):
    """Return `value` as an (N,) array of strictly increasing seconds, N >= 1.

    A Trajectory brings its own.
    """
    if hasattr(value, "stamps"):
        if value.stamps is None:
            raise AmrError(f"{name}: this trajectory has no stamps. Read it with times=.")
        return value.stamps
    array = as_reals(value, name)
    if array.ndim != 1:
        raise AmrError(f"{name} has shape {array.shape}; time stamps need shape (N,).")
    with_samples(array, name)
    forward = array[1:] > array[:-1]  # NaN is not, and infinity can only be first or last
    if not (forward.all() and np.isfinite(array[[0, -1]]).all()):
        refuse_not_finite(array, name)
        k = int(np.argmin(forward))
        what = "repeat" if array[k] == array[k + 1] else "go back in time"
        raise AmrError(
            f"{name} {what} at index {k + 1}: {array[k]:.6f} s comes before {array[k + 1]:.6f} s. "
            "Stamps must increase; sort the recording or drop the repeated sample."
        )
    return array


def as_count(value, name, least=1):
    """Return `value` as an int of at least `least`."""
    number = as_numbers(value, name)
    if number.ndim or number < least or number != np.round(number):
        raise AmrError(f"{name} is {value!r}; expected a whole number of at least {least}.")
    return int(number)


def as_size(value, name, *shapes, sign="> 0"):
    """Return finite numbers of one of the shapes (a single number if none is given)."""
    number = as_numbers(value, name)
    if number.shape not in (shapes or ((),)):
        shapes = " or ".join(map(str, shapes)) or "a single number"
        raise AmrError(f"{name} has shape {number.shape}; expected {shapes}.")
    if not {"> 0": number > 0, ">= 0": number >= 0, "": np.True_}[sign].all():
        raise AmrError(f"{name} is {value!r}; expected {sign}.")
    return number


def as_probability(value, name):
    """Return `value` as a float strictly between 0 and 1."""
    number = as_numbers(value, name)
    if number.ndim or not 0 < number < 1:
        raise AmrError(f"{name} is {value!r}; expected a number between 0 and 1, such as 0.95.")
    return float(number)


def as_generator(rng):
    """Return `rng` if it is what all randomness of the kit comes from."""
    if not isinstance(rng, np.random.Generator):
        raise AmrError(f"rng is {rng!r}; expected a numpy Generator, such as default_rng(4).")
    return rng


def as_array(value, name):
    try:
        return np.asarray(value)
    except ValueError:
        raise AmrError(f"{name} is not an array: its rows have different lengths.") from None


def with_samples(array, name):
    if array.size == 0:
        raise AmrError(f"{name} is empty (shape {array.shape}); at least one sample is needed.")
    return array


def first_index(mask):
    """Index of the first True, written as in the code: "[3, 1]", or "" for a single value."""
    return str(np.argwhere(mask)[0].tolist()) if np.ndim(mask) else ""


def as_binary(value, name, meaning):
    """Return `value` as an array of booleans; only 0, 1, False and True are taken."""
    array = as_array(value, name)
    if array.dtype == bool:
        return array
    numbers = as_numbers(array, name)
    wrong = (numbers != 0) & (numbers != 1)
    if wrong.any():
        raise AmrError(
            f"{name}{first_index(wrong)} is {numbers[wrong][0]:.6g}; labels are {meaning}."
        )
    return numbers == 1
