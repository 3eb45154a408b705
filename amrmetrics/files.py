"""Trajectory files as robots and benchmarks write them: TUM, KITTI, EuRoC.

Readers accept comments (#), blank lines, commas or spaces, and ``.gz``; they report every
problem with the file and the line.
"""

import gzip
import zlib
from typing import NamedTuple

import numpy as np

from amrmetrics._arguments import as_poses, as_stamps
from amrmetrics.errors import AmrError
from amrmetrics.poses import UNIT_QUATERNION_WITHIN, spatial_poses


class Trajectory(NamedTuple):
    """A recording: `stamps` in seconds, shape (N,) or None, and `poses`, shape (N, 4, 4)."""

    stamps: np.ndarray | None
    poses: np.ndarray


def read_tum(path):
    """Read a TUM file: one line ``stamp tx ty tz qx qy qz qw`` per pose.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz.

    Returns
    -------
    Trajectory
        Stamps in seconds, poses (N, 4, 4) in meters. Quaternions within 1e-3 of unit
        length are normalized.

    Raises
    ------
    AmrError
        With file and line: an empty file, a wrong number of columns, text in a number,
        NaN, a quaternion not of unit length, stamps that do not increase.
    OSError
        If the file cannot be opened.

    References
    ----------
    Lecture 01. Sturm et al., IROS 2012, and the benchmark's page on file formats.

    Examples
    --------
    >>> import os, tempfile
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "run.txt")
    >>> with open(path, "w", encoding="utf-8") as file:
    ...     _ = file.write("# stamp tx ty tz qx qy qz qw\\n0.5 1 2 3 0 0 0 1\\n")
    >>> am.read_tum(path).stamps.tolist()
    [0.5]
    """
    table, line = _read_table(path, 8, "stamp tx ty tz qx qy qz qw")
    return _stamped(path, line, table[:, 0], table[:, 1:4], table[:, 4:8])


def read_euroc(path):
    """Read a EuRoC file: ``stamp[ns], px, py, pz, qw, qx, qy, qz`` per line, more is ignored.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz.

    Returns
    -------
    Trajectory
        Stamps in seconds (the file has nanoseconds), poses (N, 4, 4) in meters.

    Raises
    ------
    AmrError
        As `read_tum`.
    OSError
        If the file cannot be opened.

    References
    ----------
    Lecture 01. Burri et al., The EuRoC micro aerial vehicle datasets, IJRR 35 (2016),
    sec. 3.4.

    Examples
    --------
    >>> import os, tempfile
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "data.csv")
    >>> with open(path, "w", encoding="utf-8") as file:
    ...     _ = file.write("1403636580838555648, 4.6, -1.7, 0.7, 1, 0, 0, 0\\n")
    >>> am.positions(am.read_euroc(path).poses).tolist()
    [[4.6, -1.7, 0.7]]
    """
    table, line = _read_table(path, 8, "stamp[ns] px py pz qw qx qy qz", more=True)
    return _stamped(path, line, table[:, 0] / 1e9, table[:, 1:4], table[:, [5, 6, 7, 4]])


def read_kitti(path):
    """Read a KITTI file: the twelve entries of the upper 3 x 4 matrix per line, row by row.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz.

    Returns
    -------
    Trajectory
        `stamps` is None: the format has none. Poses (N, 4, 4) in meters.

    Raises
    ------
    AmrError
        With file and line: an empty file, a wrong number of columns, text in a number,
        NaN, a matrix that is not a rotation.
    OSError
        If the file cannot be opened.

    References
    ----------
    Lecture 01. Geiger, Lenz and Urtasun, CVPR 2012, and the development kit's readme.

    Examples
    --------
    >>> import os, tempfile
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "00.txt")
    >>> with open(path, "w", encoding="utf-8") as file:
    ...     _ = file.write("1 0 0 5 0 1 0 6 0 0 1 7\\n")
    >>> am.positions(am.read_kitti(path).poses).tolist()
    [[5.0, 6.0, 7.0]]
    """
    table, line = _read_table(path, 12, "r11 r12 r13 tx r21 r22 r23 ty r31 r32 r33 tz")
    X = np.zeros((len(table), 4, 4))
    X[:, :3], X[:, 3, 3] = table.reshape(-1, 3, 4), 1
    if _refused(X):
        low, high = 0, len(X)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (low, middle) if _refused(X[low:middle]) else (middle, high)
        as_poses(X[low], f"{path}, line {line(low)}: the matrix", batch=True)
    return Trajectory(None, X)


def write_tum(path, stamps, X):
    """Write poses in TUM format, every number to its last digit.

    Parameters
    ----------
    path : str or Path
        Overwritten if it exists; compressed by gzip if the name ends in .gz.
    stamps : (N,) array
        Seconds, increasing.
    X : (N, 4, 4) array
        Poses, meters.

    Returns
    -------
    None

    Raises
    ------
    AmrError
        If the poses are not spatial, or the stamps not increasing or not as many.

    References
    ----------
    See `read_tum`.

    Examples
    --------
    >>> import os, tempfile
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "run.txt")
    >>> am.write_tum(path, [0.1], np.eye(4)[None])
    >>> am.read_tum(path).stamps.tolist()
    [0.1]
    """
    from scipy.spatial.transform import Rotation

    X, stamps = _spatial(X), as_stamps(stamps, "stamps")
    if len(stamps) != len(X):
        raise AmrError(f"stamps has {len(stamps)} entries and X has {len(X)} poses.")
    q = Rotation.from_matrix(X[:, :3, :3]).as_quat()
    _write_table(path, np.column_stack([stamps, X[:, :3, 3], q]))


def write_kitti(path, X):
    """Write poses in KITTI format, every number to its last digit.

    Parameters
    ----------
    path : str or Path
        Overwritten if it exists; compressed by gzip if the name ends in .gz.
    X : (N, 4, 4) array
        Poses, meters.

    Returns
    -------
    None

    Raises
    ------
    AmrError
        If the poses are not spatial.

    References
    ----------
    See `read_kitti`.

    Examples
    --------
    >>> import os, tempfile
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "00.txt")
    >>> am.write_kitti(path, np.eye(4)[None])
    >>> bool((am.read_kitti(path).poses == np.eye(4)).all())
    True
    """
    _write_table(path, _spatial(X)[:, :3].reshape(-1, 12))


def _read_table(path, columns, names, more=False):
    """Return the numbers of a file, (N, columns), and a function from row to line number."""
    opener = gzip.open if str(path).endswith(".gz") else open
    try:
        with opener(path, "rt", encoding="utf-8-sig") as file:
            text = file.read()
    except (UnicodeDecodeError, gzip.BadGzipFile, EOFError, zlib.error) as error:
        raise AmrError(f"{path} is not a text file in UTF-8 ({error}).") from None
    lines = text.replace(",", " ").splitlines()
    kept = [k for k, line in enumerate(lines) if (word := line.lstrip()) and word[0] != "#"]
    if not kept:
        raise AmrError(f"{path} has no data: {len(lines)} lines, all blank or comments.")
    rows = [lines[k] for k in kept]
    try:
        table = np.loadtxt(rows, comments="#", ndmin=2)
        wrong = table.shape[1] != columns and not (more and table.shape[1] > columns)
        if wrong or not np.isfinite(table).all():
            raise ValueError
    except ValueError:
        raise AmrError(_complaint(path, rows, kept, columns, names, more)) from None
    return table[:, :columns], lambda row: kept[row] + 1


def _complaint(path, rows, kept, columns, names, more):
    """Say what is wrong with the first line that has something wrong."""
    for row, k in zip(rows, kept, strict=True):
        words = row.split("#")[0].split()
        if len(words) < columns or (len(words) > columns and not more):
            return (
                f"{path}, line {k + 1}: {len(words)} columns, expected {columns}"
                f"{' or more' if more else ''} ({names})."
            )
        for column, word in enumerate(words):
            try:
                # Python reads 1_0 and digits of other scripts; these files do not mean them.
                finite = np.isfinite(float(word.replace("_", "?").encode("ascii", "replace")))
            except ValueError:
                return f"{path}, line {k + 1}, column {column + 1}: {word!r} is not a number."
            if not finite:
                return f"{path}, line {k + 1}, column {column + 1}: {word}. Drop such poses first."
    return f"{path}: the lines differ in their number of columns ({columns} expected: {names})."


def _stamped(path, line, stamps, xyz, q):
    """Return the Trajectory, or complain with the line number."""
    backward = np.diff(stamps) <= 0
    if backward.any():
        k = int(np.argmax(backward)) + 1
        what = "repeats" if stamps[k] == stamps[k - 1] else "is before"
        raise AmrError(
            f"{path}, line {line(k)}: the stamp {stamps[k]:.9f} {what} the one of line "
            f"{line(k - 1)}. Stamps must increase."
        )
    off = np.abs(np.linalg.norm(q, axis=1) - 1) > UNIT_QUATERNION_WITHIN
    if off.any():
        k = int(np.argmax(off))
        raise AmrError(
            f"{path}, line {line(k)}: the quaternion has length {np.linalg.norm(q[k]):.6g}; a "
            f"rotation needs 1 within {UNIT_QUATERNION_WITHIN:g}."
        )
    return Trajectory(stamps.copy(), spatial_poses(xyz, q))


def _refused(X):
    try:
        as_poses(X, "X")
    except AmrError:
        return True
    return False


def _spatial(X):
    X = as_poses(X, "X")
    if X.shape[-1] != 4:
        raise AmrError(f"X has shape {X.shape}; the format holds spatial poses (N, 4, 4).")
    return X


def _write_table(path, table):
    opener = gzip.open if str(path).endswith(".gz") else open
    with opener(path, "wt", encoding="utf-8", newline="\n") as file:
        # repr gives the shortest digits that read back as the same double.
        file.writelines(" ".join(map(repr, row)) + "\n" for row in table.tolist())
