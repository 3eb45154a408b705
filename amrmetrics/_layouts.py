"""What the columns of a trajectory file are, told from the numbers and from its header.

A layout is a line of names: "s x y z qx qy qz qw" is a TUM file, "T" a KITTI file.
"""

import re
from dataclasses import dataclass, replace

import numpy as np

from amrmetrics._text import REPAIRABLE
from amrmetrics.errors import AmrError

SECONDS = {"s": 1, "ms": 1e3, "us": 1e6, "ns": 1e9}
UNITS = {"s": "seconds", "ms": "milliseconds", "us": "microseconds", "ns": "nanoseconds"}
NAMES = ("s", "ms", "us", "ns", "frame", "x", "y", "z", "qx", "qy", "qz", "qw", "R", "T", "_")
# Columns that one name stands for: a rotation matrix, and a pose without its last row.
WIDTHS = {"R": 9, "T": 12}
XYZW, WXYZ = "qx qy qz qw", "qw qx qy qz"

# Quaternions that are off by more are no rounded or drifted rotations.
REPAIRABLE_QUATERNION = 1e-2
# A 3 x 3 block that is off by more is no rotation at all, and the columns mean something else.
LIKE_A_ROTATION = 0.1
# Rows that are looked at.
LOOKED_AT = 1000
# Scalar of a first quaternion near the identity, where most estimates start.
IDENTITY = 0.99
# Steps between whole numbers that are no seconds: a day.
DAY = 86_400

# Words of a header, in lower case.
TIME = re.compile(r"t|ts|.*(?:time|stamp)s?(?:_\w+)?|(?:.*[._])?sec(?:s|onds)?")
NANOSECONDS = re.compile(r"(?:.*[._])?n(?:ano)?sec(?:s|onds)?")
STATED_UNIT = re.compile(r"(?:time|stamp|\bt)\w*?[\s_]*[_\[(](ns|us|ms|s)(?:ec)?\b")
FRAME = ("frame", "frame_id", "index", "id")
POSITION = re.compile(
    r"([xyz])|(?:.*[._])?(?:t|p|pos|position|trans|translation|pose)(?:_\w+)??[._]?([xyz])"
)
QUATERNION = re.compile(
    r"(?:.*[._])?(?:q|qua|quat|quaternion|ori|orientation|rot|rotation)(?:_\w+)??[._]?([xyzw])"
)
ON_EARTH = {"easting": "x", "northing": "y", "altitude": "z", "height": "z"}


@dataclass(frozen=True)
class Layout:
    """The names of the first columns, and what speaks for them.

    `certain` says if that leaves no doubt, `assumed` what was taken for granted all the same.
    """

    columns: str
    why: str
    certain: bool = True
    assumed: str = ""

    def where(self, *names):
        """Return the columns of these names, a slice where they are neighbors; None if missing."""
        starts, column = {}, 0
        for name in self.columns.split():
            starts[name] = column
            column += WIDTHS.get(name, 1)
        if not {*names} <= {*starts}:
            return None
        columns = [starts[name] + k for name in names for k in range(WIDTHS.get(name, 1))]
        neighbors = list(range(columns[0], columns[0] + len(columns)))
        return slice(columns[0], columns[-1] + 1) if columns == neighbors else columns


def stated(columns, table):
    """Return the Layout that somebody states."""
    names = columns.split() if isinstance(columns, str) else []
    wrong = [name for name in names if name not in NAMES]
    twice = [name for name in names if name != "_" and names.count(name) > 1]
    quaternion = {*XYZW.split()} & {*names}
    if not names or wrong or twice or len(quaternion) in (1, 2, 3):
        raise AmrError(
            f"columns is {columns!r}; expected names such as 'ns x y z qw qx qy qz', each of "
            f"{', '.join(NAMES)}, once; _ is a column that is not used, R the nine entries of a "
            "rotation matrix, T the twelve of a pose."
        )
    if "T" not in names and not {"x", "y", "z"} <= {*names}:
        raise AmrError(f"columns is {columns!r}; x, y and z (or T) must be among them.")
    named, there = sum(WIDTHS.get(name, 1) for name in names), table.values.shape[1]
    if named > there:
        raise AmrError(f"columns is {columns!r}, {named} columns; {table.path} has {there}.")
    return Layout(columns, "the stated columns")


def recognized(table):
    """Return the Layout of a table by its numbers and its header."""
    x = table.values[:: max(1, len(table.values) // LOOKED_AT)]
    layout = _of_matrices(x) or _by_header(table.head, x) or _by_numbers(table, x)
    position = layout.where("x", "y", "z")
    if position is not None and _on_a_globe(x[:, position]):
        return replace(layout, assumed="latitudes and longitudes, as it seems, read as meters")
    return layout


def _of_matrices(x):
    """Return the Layout of a table of pose matrices, None if it is none."""
    columns, unit = x.shape[1], unit_of(x[:, 0])
    for start, first in enumerate(("", "frame" if _are_counted(x[:, 0]) else unit, f"{unit} _")):
        whole = columns == 16 + start and (x[:, -4:] == (0, 0, 0, 1)).all()
        if whole or columns == 12 + start:
            upper = x[:, start : start + 12].reshape(-1, 3, 4)
            if _are_rotations(upper[:, :, :3]):
                why = f"a pose matrix in columns {start + 1} to {start + 12}"
                return Layout(f"{first} T".strip(), why, start < 2)
    if columns >= 12 and _are_rotations(x[:, :9].reshape(-1, 3, 3)):
        why = "a rotation matrix in columns 1 to 9 and then a position"
        return Layout("R x y z", why, columns == 12)
    return None


def _by_header(head, x):
    """Return the Layout that a header states, None if it names no trajectory."""
    for words in reversed(head):
        header = _cleaned(words)
        names = _names(header, x, " ".join(words))
        q = [names.index(name) for name in XYZW.split() if name in names]
        oriented = len(q) == 4 and _are_unit(x[:, q])
        if not oriented:
            if len(q) == 4 and x[:, q].any():
                continue
            names = [name if name[0] != "q" else "_" for name in names]
        whole = len(header) >= x.shape[1] or not _are_unit(x[:, 4:8])
        if {"x", "y", "z"} <= {*names} and (oriented or whole):
            columns = re.sub("( _)+$", "", " ".join(names))
            return Layout(columns, f"the columns {columns} by its header")
        if {"x", "y"} <= {*names} and len(header) == x.shape[1] and not _are_unit(x[:, 4:8]):
            return _in_the_plane(f"the columns {' '.join(header)} by its header")
    return None


def _names(header, x, text):
    """Return what the words of a header name, "_" for anything else and for a second time."""
    names = []
    for column, word in enumerate(header[: x.shape[1]]):
        q, p, name = QUATERNION.fullmatch(word), POSITION.fullmatch(word), ON_EARTH.get(word, "_")
        if q or p:
            name = f"q{q[1]}" if q else p[1] or p[2]
        elif NANOSECONDS.fullmatch(word) and names[-1:] == ["s"]:
            name = "ns"
        elif TIME.fullmatch(word) and not {*names} & {*SECONDS}:
            name = unit_of(x[:, column], text)
        elif word in FRAME and _are_counted(x[:, column]):
            name = "frame"
        names.append("_" if name in names else name)
    return names


def _by_numbers(table, x):
    """Return the Layout of a table by its numbers."""
    columns, header = x.shape[1], table.head[-1] if table.head else []
    unit = unit_of(x[:, 0], " ".join(header))
    stamps = f"stamps in {UNITS[unit]}"
    other = len(_cleaned(header)) == columns
    unknown = "columns in the order of the format, though the header names others" if other else ""
    if columns >= 9 and _are_split(x) and _are_unit(x[:, 5:9]):
        why = "seconds, nanoseconds, a position and a quaternion in columns 6 to 9"
        return Layout(f"s ns x y z {XYZW}", why, assumed=unknown)
    if columns >= 8 and _are_unit(x[:, 4:8]):
        layout = _ordered(unit, x[0, 4:8], table.commas)
        return replace(layout, assumed=layout.assumed or unknown)
    if columns >= 8 and _are_unit(x[:, 1:5]):
        why = f"{stamps}, a quaternion in columns 2 to 5 and then the position"
        return Layout(f"{unit} {XYZW} x y z", why, False)
    if columns == 7 and _are_unit(x[:, 3:7]):
        return Layout(f"x y z {XYZW}", "a position, a quaternion and no stamps", assumed=unknown)
    if columns == 4 and _is_heading(x):
        return _in_the_plane("4 columns, the last of which is the direction of travel")
    if (columns == 4 and not other) or (columns >= 8 and not x[:, 4:8].any()):
        return Layout(f"{unit} x y z", f"{stamps} and a position")
    unit_at = [k for k in range(columns - 3) if _are_unit(x[:, k : k + 4])]
    if unit_at:
        why = f"four of unit length in columns {unit_at[0] + 1} to {unit_at[0] + 4}"
    elif columns >= 8:
        length = np.median(np.linalg.norm(x[:, 4:8], axis=1))
        why = f"the length of columns 5 to 8 is {length:.3g}, where a quaternion has 1"
    else:
        why = "nowhere among them four of unit length"
    return Layout("", f"{columns} columns, {why}", False)


def _ordered(unit, q, commas):
    """Return the Layout of a stamp, a position and a quaternion, the first of which is `q`.

    TUM files have spaces and the scalar last, EuRoC files nanoseconds, commas and the scalar
    first. An estimate that starts at the identity shows where its scalar is.
    """
    why = f"stamps in {UNITS[unit]}, a position and a quaternion in columns 5 to 8"
    first, last = np.abs(q[[0, 3]]) > IDENTITY
    scalar_last, scalar_first = (f"{unit} x y z {order}" for order in (XYZW, WXYZ))
    if unit == "s":
        assumed = "quaternions, the first of which is 1 0 0 0, read with the scalar last"
        return Layout(scalar_last, why, assumed=assumed if first else "")
    if commas:
        return Layout(scalar_last, why, False) if last else Layout(scalar_first, why)
    if first:
        assumed = "quaternions, the first of which is 1 0 0 0, read with the scalar first"
        return Layout(scalar_first, why, assumed=assumed)
    assumed = f"stamps in {UNITS[unit]}, and quaternions read with the scalar last, as in TUM files"
    return Layout(scalar_last, why, assumed=assumed)


def _in_the_plane(why):
    return Layout("", f"{why}: a path in the plane", False)


def _cleaned(words):
    """Return the words of a header without units in brackets and without stops."""
    text = re.sub(r"\[.*?\]|\(.*?\)", " ", " ".join(words))
    names = [word.strip(".:'\"") for word in text.split()]
    return names[1:] if names[:1] == ["fields"] else names  # so starts a line in a PCD file


def unit_of(t, header=""):
    """Return the unit of stamps by their size since 1970, by the header or by their steps."""
    size, whole = np.median(np.abs(t)), (t == np.round(t)).all()
    for unit, least in (("ns", 1e17), ("us", 1e14), ("ms", 1e11)):
        if size >= least:
            return unit
    said = STATED_UNIT.search(header)
    if said and (whole or size < 1e8):
        return said[1]
    return "ns" if whole and len(t) > 1 and np.median(np.abs(np.diff(t))) > DAY else "s"


def _are_unit(q):
    return q.shape[1] == 4 and _mostly(
        np.abs(np.linalg.norm(q, axis=1) - 1) <= REPAIRABLE_QUATERNION
    )


def _are_rotations(R):
    return _mostly(off_rotation(R) <= LIKE_A_ROTATION)


def off_rotation(R):
    """Return by how much R^T R differs from the identity."""
    return np.abs(np.einsum("nki,nkj->nij", R, R) - np.eye(3)).max((1, 2))


def _are_split(x):
    """Say if the first two columns are whole seconds and the nanoseconds beyond them."""
    whole = (x[:, :2] == np.round(x[:, :2])).all()
    return whole and x[:, 1].min() >= 0 and x[:, 1].max() < 1e9


def _are_counted(t):
    """Say if these are numbers of frames."""
    steps = np.diff(t)
    counted = (steps >= 1) & (steps < DAY)
    return (t == np.round(t)).all() and t.max() < 1e8 and (not len(t[1:]) or _mostly(counted))


def _is_heading(x):
    """Say if the fourth column turns as the path in the second and third does."""
    steps, heading = np.diff(x[:, 1:3], axis=0), x[:, 3]
    moving = steps.any(axis=1)
    if not moving.any() or np.ptp(heading) < 0.5 or np.abs(heading).max() > 2 * np.pi:
        return False
    travel = np.arctan2(steps[moving, 1], steps[moving, 0])
    return np.cos(travel - heading[:-1][moving]).mean() > 0.9


def _on_a_globe(xyz):
    """Say if these are degrees and meters: places that hardly change beside the height."""
    extent, middle = np.ptp(xyz, axis=0), np.abs(np.median(xyz, axis=0))
    degrees = (middle[:2] > 1).all() and middle[:2].max() <= 180 and middle[:2].min() <= 90
    return degrees and 0 < extent[:2].max() < min(1, extent[2] / 50)


def _mostly(true):
    return np.mean(true) >= 1 - REPAIRABLE
