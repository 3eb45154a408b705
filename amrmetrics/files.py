"""Trajectory files as robots and benchmarks write them: TUM, EuRoC, KITTI.

A reader meets real recordings. What has one sensible repair is repaired and said in one
`RecordingWarning` per file; a file in another format is refused with what speaks for which.
Comments, blank lines, commas, semicolons or spaces between numbers, and ``.gz`` are taken.
"""

from __future__ import annotations

import gzip
import os
import warnings
from decimal import Decimal
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import ORTHONORMAL_WITHIN, as_numbers, as_poses, blocks
from amrmetrics._layouts import (
    LOOKED_AT,
    REPAIRABLE_QUATERNION,
    SECONDS,
    WXYZ,
    XYZW,
    off_rotation,
    recognized,
    stated,
    unit_of,
)
from amrmetrics._text import REPAIRABLE, Table
from amrmetrics.errors import AmrError, RecordingWarning
from amrmetrics.poses import UNIT_QUATERNION_WITHIN, spatial_poses
from amrmetrics.recording import Trajectory, as_recording

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike, Path

TUM = ("s x y z qx qy qz qw", "s ns x y z qx qy qz qw", "s x y z")
EUROC = ("ns x y z qw qx qy qz", "ns x y z")
KITTI = ("T", "frame T", *(f"{unit} T" for unit in SECONDS))

ALL_ZERO = "every quaternion in the file is 0 0 0 0"
# What rounding to three decimals does to R^T R.
REPAIRABLE_MATRIX = 2e-3
# Fewer neighboring lines out of order may be misplaced ones, and more are a second run.
SHORTEST_RUN = 10
# Coordinates of which six digits, the default of many programs, end at a meter or above.
FAR_AWAY = 1e5


def read(
    path: Path,
    times: Path | ArrayLike | None = None,
    strict: bool = False,
    columns: str | None = None,
) -> Trajectory:
    """Read a trajectory file in whatever format it is, or say why that cannot be told.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz.
    times : str, Path or (N,) array, optional
        Stamps of a KITTI file, as in `read_kitti`.
    strict : bool
        Refuse what would be repaired.
    columns : str, optional
        What the first columns are, where neither numbers nor a header tell: names out of
        ``s ms us ns`` (the stamp in that unit), ``x y z``, ``qx qy qz qw``, ``frame``, ``R``
        (the nine entries of a rotation matrix), ``T`` (the twelve of a pose) and ``_`` (not
        used), such as "us x y z qw qx qy qz".

    Returns
    -------
    Trajectory
        As from `read_tum`, `read_euroc` or `read_kitti`; also of a table whose header names
        its columns in any order, of a position and a quaternion without stamps, of
        nanoseconds in a file that is otherwise TUM, of matrices of 16 entries, or of a rotation
        matrix and then a position.

    Raises
    ------
    AmrError
        As these, and if the file fits no format or more than one.
    OSError
        If the file cannot be opened.

    References
    ----------
    Lecture 01.

    Examples
    --------
    >>> import os, tempfile
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "run.csv")
    >>> with open(path, "w", encoding="utf-8") as file:
    ...     _ = file.write("#time,x,y,z,qw,qx,qy,qz\\n0.5,1,2,3,1,0,0,0\\n")
    >>> am.read(path).positions.tolist()
    [[1.0, 2.0, 3.0]]
    """
    return _read(path, None, strict, times, columns)


def read_tum(path: Path, strict: bool = False) -> Trajectory:
    """Read a TUM file: one line ``stamp tx ty tz qx qy qz qw`` per pose, more is ignored.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz. The stamp may be written as
        two columns, seconds and nanoseconds. A quaternion may be missing, or 0 0 0 0 in every
        line: then the trajectory has positions only.
    strict : bool
        Refuse what would be repaired.

    Returns
    -------
    Trajectory
        Stamps in seconds, poses (N, 4, 4) in meters. Quaternions within 1e-3 of unit
        length are normalized without a word.

    Warns
    -----
    RecordingWarning
        What was repaired: lines and columns without numbers and repeated stamps left out,
        stamps out of order sorted, quaternions off by up to 1 % normalized; a header line,
        semicolons, letters that are not UTF-8; what had to be assumed, such as that the scalar is
        the last of four although the first quaternion is 1 0 0 0; and what was kept and is
        doubtful: poses at the origin in the middle of a run, coordinates with six digits only.

    Raises
    ------
    AmrError
        With file and line: no data, another format, two runs in one file, stamps that lost
        digits, a zero quaternion, or more than one row in ten in need of repair.
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
    return _read(path, TUM, strict)


def read_euroc(path: Path, strict: bool = False) -> Trajectory:
    """Read a EuRoC file: ``stamp[ns], px, py, pz, qw, qx, qy, qz`` per line, more is ignored.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz. A quaternion may be missing.
    strict : bool
        Refuse what would be repaired.

    Returns
    -------
    Trajectory
        Stamps in seconds (the file has nanoseconds), poses (N, 4, 4) in meters.

    Warns
    -----
    RecordingWarning
        As `read_tum`.

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
    return _read(path, EUROC, strict)


def read_kitti(
    path: Path, times: Path | ArrayLike | None = None, strict: bool = False
) -> Trajectory:
    """Read a KITTI file: the twelve entries of the upper 3 x 4 matrix per line, row by row.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz. A number of the frame or a
        stamp may stand before the twelve.
    times : str, Path or (N,) array, optional
        Seconds of each pose, or of each frame if the file has frame numbers: the sequence's
        ``times.txt``.
    strict : bool
        Refuse what would be repaired.

    Returns
    -------
    Trajectory
        Poses (N, 4, 4) in meters; `stamps` is None without `times`: the format has none.

    Warns
    -----
    RecordingWarning
        As `read_tum`, and if matrices that were rounded when they were written are replaced
        by the nearest rotations.

    Raises
    ------
    AmrError
        With file and line: as `read_tum`, or a matrix that is not a rotation.
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
    >>> am.read_kitti(path, times=[0.1]).positions.tolist()
    [[5.0, 6.0, 7.0]]
    """
    return _read(path, KITTI, strict, times)


def _read(path, readable, strict, times=None, columns=None):
    """Return the Trajectory of a file in one of the layouts `readable`, None for any."""
    table = Table(path)
    layout = recognized(table) if columns is None else stated(columns, table)
    if not layout.certain or (readable and layout.columns not in readable):
        raise AmrError(f"{path}: {_refusal(layout, readable, table)}")
    if layout.assumed:
        table.note(layout.assumed, table.lines[0])
    stamps, frames = _clock(table, layout, times)
    poses, why = _poses(table, layout)
    _note_doubtful(table, poses)
    repairs = tuple(_said(*repair) for repair in table.repairs)
    try:
        trajectory = Trajectory(stamps, poses, os.path.basename(path), repairs, frames, why)
    except AmrError as error:
        raise AmrError(f"{path}: {error}") from None
    if repairs and strict:
        raise AmrError(f"{path}: {repairs[0]}. Without strict=True it is read all the same.")
    if repairs:
        warnings.warn(f"{path}: {'; '.join(repairs)}.", RecordingWarning, stacklevel=3)
    return trajectory


def _said(what, line, count):
    return f"{what}, line {line}" if count is None else f"{count} {what}, first in line {line}"


def _refusal(layout, readable, table):
    """Say what a file is, why that is not what was asked for, and what reads it."""
    asked = {TUM: f"{TUM[0]} (TUM)", EUROC: f"{EUROC[0]} (EuRoC)", KITTI: "12 entries of a matrix"}
    expected = f"expected {asked[readable]}; this file has " if readable else ""
    readers = {"read_tum": TUM, "read_euroc": EUROC, "read_kitti": KITTI}
    reader = next((name for name, columns in readers.items() if layout.columns in columns), "read")
    if layout.certain:
        return f"{expected}{layout.why}. amrmetrics.{reader} reads this format."
    if XYZW in layout.columns:
        first = layout.columns.replace(XYZW, WXYZ)
        return (
            f"{expected}{layout.why}, whose order the numbers do not tell. With the scalar last: "
            f'amrmetrics.read(path, columns="{layout.columns}"), first: columns="{first}".'
        )
    if readable is KITTI and table.values.shape[1] == 12:
        _poses(table, stated("T", table))  # refuses the first line that is no pose
    row = " ".join(f"{x:.6g}" for x in table.values[0][:13])
    found = f"{expected}{layout.why} (line {table.lines[0]}: {row})"
    if layout.why.endswith("plane"):
        return f"{found}. amrmetrics.Trajectory(stamps, amrmetrics.planar_poses(xy, yaw)) takes it."
    stamped = (np.diff(table.values[:, 0]) > 0).all()
    unit = unit_of(table.values[:, 0])
    columns = layout.columns or (f"{unit} x y z" if stamped else "x y z")
    return (
        f"{found}. If you know what they are, name them, for example: "
        f'amrmetrics.read(path, columns="{columns}").'
    )


def _clock(table, layout, times):
    """Return stamps and frame numbers, each None if there are none, rows in order of time."""
    units = [unit for unit in SECONDS if unit in layout.columns.split()]
    if times is not None and (units or layout.where("T") is None):
        raise AmrError(f"times were given, but {table.path} has {layout.why}.")
    where = [layout.where(name).start for name in units or ["frame"] if layout.where(name)]
    if not where:
        return None if times is None else _stamps_of(table, None, times), None
    if not units:
        frames = _in_order(table, table.values[:, where[0]].astype(int), where, "frame numbers")
        return None if times is None else _stamps_of(table, frames, times), frames
    parts = zip(where, units, strict=True)
    stamps = sum(table.values[:, column] / SECONDS[unit] for column, unit in parts)
    return _in_order(table, stamps, where, "stamps"), None


def _stamps_of(table, frames, times):
    """Return the stamps of the poses, or of the frames if they are numbered."""
    if isinstance(times, str | os.PathLike):
        name, clock = str(times), Table(times)
        if clock.values.shape[1] != 1:
            raise AmrError(f"{name} has {clock.values.shape[1]} columns; expected one, seconds.")
        stamps = clock.values[:, 0]
        table.repairs += [(f"{name}: {what}", line, n) for what, line, n in clock.repairs]
    else:
        name, stamps = "times", as_numbers(times, "times")
    poses = len(table.values)
    if frames is None and stamps.shape != (poses,):
        raise AmrError(f"{name} has {len(stamps)} stamps, and {table.path} has {poses} poses.")
    if frames is not None and not (frames.min() >= 0 and frames.max() < len(stamps)):
        raise AmrError(
            f"{name} has {len(stamps)} stamps, and {table.path} has frames {frames.min()} to "
            f"{frames.max()}; the first stamp belongs to frame 0."
        )
    return stamps if frames is None else stamps[frames]


def _in_order(table, stamps, columns, name):
    """Return stamps in order, rows with those that repeat left out and others sorted."""
    steps = np.diff(stamps)
    if (steps > 0).all():
        return stamps
    if len(stamps) > SHORTEST_RUN and (steps < 0).all():
        table.note(f"{name} in falling order, turned round", table.lines[0])
        table.keep(np.arange(len(stamps))[::-1])
        return stamps[::-1]
    _refuse_lost_digits(table, stamps, columns)
    order = np.argsort(stamps, kind="stable")
    fresh = np.r_[True, np.diff(stamps[order]) > 0]
    repeats = np.sort(order[~fresh])
    misplaced = _misplaced(stamps)
    _refuse_second_run(table, stamps, misplaced)
    if len(repeats):
        what = f"{name} that were there already, left out"
        digits = "Were they written with too few digits?"
        table.note(what, table.lines[repeats[0]], len(repeats), why=digits)
    if misplaced.any():
        line = table.lines[misplaced.argmax()]
        table.note(f"{name} out of order, sorted", line, int(misplaced.sum()))
    kept = order[fresh]
    table.keep(kept)
    return stamps[kept]


def _misplaced(stamps):
    """Say which rows come too late or, if these are fewer, too early."""
    late = stamps < np.maximum.accumulate(stamps)
    early = stamps > np.minimum.accumulate(stamps[::-1])[::-1]
    return late if late.sum() <= early.sum() else early


def _refuse_lost_digits(table, stamps, columns):
    """Refuse stamps that are equal as doubles but not in the file, or that were cut short."""
    same = np.flatnonzero(np.diff(stamps) == 0) + 1
    for k in same:
        before, after = ([table.word(row, c) for c in columns] for row in (k - 1, k))
        if list(map(Decimal, before)) != list(map(Decimal, after)):
            table.refuse(
                k,
                f"the stamps {' '.join(before)} and {' '.join(after)} differ, but are equal as "
                "doubles, which hold 16 digits. Subtract a whole number of seconds from all.",
            )
    if len(same) <= REPAIRABLE * len(stamps):
        return
    k = int(same[0])
    word = table.word(k, columns[0])
    cut = "e" in word.lower() or (stamps == [float(f"{t:.6g}") for t in stamps]).all()
    if cut and stamps[k] > 1e6:
        table.refuse(
            k,
            f"the stamp {word} repeats, as in {len(same)} of {len(stamps)} rows: the stamps lost "
            "digits when the file was written. Write them with 9 decimals (%.9f).",
        )
    if (stamps == np.round(stamps)).all():
        table.refuse(
            k,
            f"the stamp {word} repeats, as in {len(same)} of {len(stamps)} rows: they are whole "
            "seconds, and the parts of a second are missing.",
        )


def _refuse_second_run(table, stamps, misplaced):
    edges = np.flatnonzero(np.diff(np.r_[0, misplaced, 0])).reshape(-1, 2)
    for start, end in edges:
        if end - start >= min(SHORTEST_RUN, len(stamps) / 3):
            back = start if stamps[start] < stamps[start - 1] else end
            table.refuse(
                back,
                f"the stamp {stamps[back]:.9f} is before the one of line "
                f"{table.lines[back - 1]}, and {end - start} lines are out of order with the "
                "rest: these are several runs in one file. Put each into a file of its own.",
            )


def _poses(table, layout):
    """Return poses or positions, and why there is no orientation ("" if there is one)."""
    x, matrix = table.values, layout.where("T")
    if matrix is not None:
        return _matrices(table, x[:, matrix].reshape(-1, 3, 4)), ""
    xyz, rotation = x[:, layout.where("x", "y", "z")], layout.where("R")
    if rotation is not None:
        return _matrices(table, np.dstack([x[:, rotation].reshape(-1, 3, 3), xyz])), ""
    columns = layout.where("qx", "qy", "qz", "qw")
    if columns is None:
        zeros = x.shape[1] >= 8 and not x[:, 4:8].any()
        return xyz, ALL_ZERO if zeros else "the file has positions only"
    q = x[:, columns]
    if not q.any():
        return xyz, ALL_ZERO
    return spatial_poses(xyz, _unit_quaternions(table, q)), ""


def _note_doubtful(table, poses):
    """Note poses that stand for none, and positions that were cut to six digits."""
    xyz = poses if poses.ndim == 2 else poses[:, :3, 3]
    if len(xyz) < SHORTEST_RUN:
        return
    lost = xyz[:, 0] == 0
    if lost.any():
        lost[lost] = ~xyz[lost].any(axis=1)
        if poses.ndim == 3:
            lost[lost] = (poses[lost, :3, :3] == np.eye(3)).all((1, 2))
        lost[: int(np.argmin(lost))] = False  # many start there
    if lost.any() and not lost.all():
        what = "poses exactly at the origin after it was left, as of frames that were lost; kept"
        table.repairs.append((what, table.lines[lost.argmax()], int(lost.sum())))
    for coordinates in xyz[:LOOKED_AT].T[np.abs(xyz[0]) >= FAR_AWAY]:
        cut = [float(f"{x:.6g}") for x in coordinates]
        if (coordinates == cut).all() and np.ptp(coordinates) > 0:
            step = 10 ** (np.floor(np.log10(np.abs(coordinates[0]))) - 5)
            table.note(f"coordinates of six digits, in steps of {step:g} m", table.lines[0])
            return


def _unit_quaternions(table, q):
    """Return quaternions near unit length, those that are off by a little normalized."""
    length = np.sqrt(np.einsum("nk,nk->n", q, q))
    off = np.abs(length - 1)
    worst = off.max()
    if worst <= UNIT_QUATERNION_WITHIN:
        return q
    if worst > REPAIRABLE_QUATERNION:
        first = int((off > REPAIRABLE_QUATERNION).argmax())
        table.refuse(
            first,
            f"the quaternion has length {length[first]:.6g}; a rotation needs 1, and within "
            f"{REPAIRABLE_QUATERNION:g} it would be repaired.",
        )
    long = off > UNIT_QUATERNION_WITHIN
    table.note(
        f"quaternions off unit length by up to {worst:.2g}, normalized",
        table.lines[long.argmax()],
        int(long.sum()),
        why="Were they written with too few digits?",
    )
    return q / length[:, None]


def _matrices(table, upper):
    """Return poses from their upper 3 x 4 parts, rotations that were rounded repaired."""
    X = np.zeros((len(upper), 4, 4))
    X[:, :3], X[:, 3, 3] = upper, 1
    off = off_rotation(X[:, :3, :3])
    rounded = off > ORTHONORMAL_WITHIN
    if off.max() <= REPAIRABLE_MATRIX and rounded.any():
        U, _, Vt = np.linalg.svd(X[rounded, :3, :3])
        X[rounded, :3, :3] = U @ Vt
        what = f"rotation matrices rounded in the file (off by up to {off.max():.1g}), repaired"
        table.repairs.append((what, table.lines[rounded.argmax()], int(rounded.sum())))
    wrong = np.linalg.det(X[:, :3, :3]) < 0
    wrong |= off > REPAIRABLE_MATRIX
    if wrong.any():
        row = int(wrong.argmax())
        as_poses(X[row], f"{table.path}, line {table.lines[row]}: the matrix", batch=True)
    return X


def write_tum(path: Path, stamps: ArrayLike, X: ArrayLike | None = None) -> None:
    """Write poses in TUM format, every number to its last digit.

    Parameters
    ----------
    path : str or Path
        Overwritten if it exists; compressed by gzip if the name ends in .gz.
    stamps : (N,) array or Trajectory
        Seconds, increasing; a trajectory has stamps and poses.
    X : (N, d+1, d+1) array, optional
        Poses, meters. Planar ones get z = 0 and a rotation about z.

    Returns
    -------
    None

    Raises
    ------
    AmrError
        If the stamps are not increasing or not as many, or there are none.

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
    stamps, X = as_recording(stamps, X, "stamps", "X")
    X = _spatial(X)
    tables = (
        np.column_stack([stamps[k], X[k, :3, 3], _quaternions(X[k, :3, :3])])
        for k in blocks(len(X))
    )
    _write_tables(path, tables)


def write_kitti(path: Path, X: ArrayLike) -> None:
    """Write poses in KITTI format, every number to its last digit.

    Parameters
    ----------
    path : str or Path
        Overwritten if it exists; compressed by gzip if the name ends in .gz.
    X : (N, d+1, d+1) array or Trajectory
        Poses, meters. Planar ones get z = 0 and a rotation about z.

    Returns
    -------
    None

    Raises
    ------
    AmrError
        If these are no poses.

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
    X = _spatial(as_poses(X, "X"))
    _write_tables(path, (X[k, :3].reshape(-1, 12) for k in blocks(len(X))))


def _spatial(X):
    """Return poses in space; planar ones lie in the plane z = 0."""
    if X.shape[-1] == 4:
        return X
    Y = np.tile(np.eye(4), (len(X), 1, 1))
    Y[:, :2, :2], Y[:, :2, 3] = X[:, :2, :2], X[:, :2, 2]
    return Y


def _quaternions(R):
    """Return the quaternions x, y, z, w of rotation matrices.

    Four times the matrix q q^T is linear in R; each of its rows is a multiple of q, and the one
    with the largest diagonal entry the best conditioned.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = np.moveaxis(R, 0, -1).copy()
    Q = np.array(
        [
            [1 + xx - yy - zz, xy + yx, xz + zx, zy - yz],
            [xy + yx, 1 - xx + yy - zz, yz + zy, xz - zx],
            [xz + zx, yz + zy, 1 - xx - yy + zz, yx - xy],
            [zy - yz, xz - zx, yx - xy, 1 + xx + yy + zz],
        ]
    )
    largest = np.einsum("iin->in", Q).argmax(axis=0)
    q = Q[largest, :, np.arange(len(R))]
    return q / np.linalg.norm(q, axis=1)[:, None]


def _write_tables(path, tables):
    opener = gzip.open if str(path).endswith(".gz") else open
    lines = _lines_by_orjson if _orjson() else _lines
    with opener(path, "wb") as file:
        for table in tables:
            file.write(lines(table))


def _lines(table):
    """Return a table as text with the shortest digits that read back as the same doubles."""
    return "".join(" ".join(map(repr, row)) + "\n" for row in table.tolist()).encode()


def _lines_by_orjson(table):
    """Return the same ten times as fast: a list of numbers, each comma of which is replaced."""
    orjson = _orjson()
    text = bytearray(orjson.dumps(table.ravel(), option=orjson.OPT_SERIALIZE_NUMPY))
    letters = np.frombuffer(text, np.uint8)
    commas = np.flatnonzero(letters == ord(","))
    letters[commas] = ord(" ")
    letters[commas[table.shape[1] - 1 :: table.shape[1]]] = ord("\n")
    letters[-1] = ord("\n")
    return memoryview(text)[1:]


def _orjson():
    try:
        import orjson
    except ImportError:
        return None
    return orjson
