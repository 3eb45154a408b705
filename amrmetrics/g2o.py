"""Pose graphs as g2o text files: VERTEX_SE2, EDGE_SE2, VERTEX_SE3:QUAT, EDGE_SE3:QUAT, FIX.

The reader takes lines in any order, comments (#), blank lines, and ``.gz``; it reports every
problem with the file and the line. Lecture 07.
"""

from __future__ import annotations

import gzip
import warnings
import zlib
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics import _groups
from amrmetrics._arguments import LARGEST
from amrmetrics.errors import AmrError, RecordingWarning
from amrmetrics.loops import not_positive_definite
from amrmetrics.pose_graph import PoseGraph
from amrmetrics.poses import UNIT_QUATERNION_WITHIN, planar_poses, spatial_poses

if TYPE_CHECKING:
    from amrmetrics._types import Path

# A quaternion that differs more from unit length than this was not meant as a rotation.
REPAIRED_WITHIN = 0.05

# With more than this part of lines left out, what is left is another problem.
MOST_LEFT_OUT = 0.1

# Numbers behind the ids: a pose, and a pose with the upper triangle of its information.
COLUMNS = {
    "VERTEX_SE2": 3,
    "EDGE_SE2": 3 + 6,
    "VERTEX_SE3:QUAT": 7,
    "EDGE_SE3:QUAT": 7 + 21,
}
PLANE, SPACE = ("VERTEX_SE2", "EDGE_SE2"), ("VERTEX_SE3:QUAT", "EDGE_SE3:QUAT")
TORO = ("VERTEX2", "EDGE2", "VERTEX3", "EDGE3")


def read_g2o(path: Path, strict: bool = False) -> PoseGraph:
    """Read a pose graph from a g2o file.

    Parameters
    ----------
    path : str or Path
        Text, or text compressed by gzip if the name ends in .gz.
    strict : bool
        Refuse what would be repaired or left out.

    Returns
    -------
    PoseGraph
        In the plane or in space; `ids` are the names in the file, increasing, `edges` are
        in the order of the file. Fixed are the nodes of its FIX lines, and the node with
        the smallest id if it has none, as g2o itself does.

    Warns
    -----
    RecordingWarning
        Once per file, with counts and the first line: nodes without a VERTEX line (placed
        by the edges that lead to them), quaternions longer or shorter than 1 by up to 5 %
        (normalized), lines of other kinds such as landmarks (left out; refused if they are
        more than one in ten).

    Raises
    ------
    AmrError
        With file and line: no edge, a wrong number of columns, text in a number, NaN, an
        id that is no whole number or given twice, a FIX of an unknown node, an edge from a
        node to itself, an information matrix that is not positive definite, a quaternion
        far from unit length, both SE2 and SE3 in one file.
    OSError
        If the file cannot be opened.

    Notes
    -----
    The information is read as that of the residual of `PoseGraph`, translation first, then
    the heading or the rotation vector in radians; gtsam reads it so, too. g2o itself
    takes t and the vector part of the quaternion, half the rotation vector, as residual:
    its chi-square of a spatial file counts rotations a fourth.

    References
    ----------
    Lecture 07. Kuemmerle et al., g2o: a general framework for graph optimization, ICRA
    2011, and the format's page in its documentation.

    Examples
    --------
    >>> import os, tempfile
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "two.g2o")
    >>> with open(path, "w", encoding="utf-8") as file:
    ...     _ = file.write("VERTEX_SE2 7 0 0 0\\nVERTEX_SE2 9 1 0 0\\n")
    ...     _ = file.write("EDGE_SE2 7 9 1.5 0 0 100 0 0 100 0 400\\n")
    >>> graph = am.read_g2o(path)
    >>> graph
    pose graph in the plane: 2 nodes, 1 edges, fixed 7
    >>> graph.residuals().tolist(), graph.information[0, 2, 2].item()
    ([[-0.5, 0.0, 0.0]], 400.0)
    """
    rows = _Rows(path, strict)
    vertex, edge = rows.kinds()
    names, places, at = rows.numbers(vertex, 1)
    rows.refuse_repeated(names[:, 0], at)
    ends, values, where = rows.numbers(edge, 2)
    rows.refuse_loops(ends, where)
    split = COLUMNS[vertex]
    Z = rows.poses(values[:, :split], where)
    information = rows.information(values[:, split:], where)
    ids = np.unique(np.concatenate([names.ravel(), ends.ravel()]))
    edges = np.searchsorted(ids, ends)
    X = np.tile(np.eye(Z.shape[-1]), (len(ids), 1, 1))
    known = np.isin(ids, names)
    if len(names):
        X[np.searchsorted(ids, names[:, 0])] = rows.poses(places, at)
    fixed = rows.fixed(ids)
    if not known.all():
        line = int(where[(~known[edges]).any(axis=1)].min())
        missing = int((~known).sum())
        rows.repair(f"{missing} nodes have no VERTEX line and were placed by their edges", line)
        _place(X, known, edges, Z)
    rows.report()
    return PoseGraph(X, edges, Z, information, fixed or (0,), ids)


def write_g2o(path: Path, graph: PoseGraph) -> None:
    """Write a pose graph as a g2o file, every number to its last digit.

    Parameters
    ----------
    path : str or Path
        Overwritten if it exists; compressed by gzip if the name ends in .gz.
    graph : PoseGraph
        Its nodes, edges and fixed nodes; `Optimization.graph` holds an optimized one.

    Returns
    -------
    None

    Raises
    ------
    AmrError
        If `graph` is no PoseGraph.

    References
    ----------
    See `read_g2o`.

    Examples
    --------
    >>> import os, tempfile
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> path = os.path.join(tempfile.mkdtemp(), "two.g2o")
    >>> X = am.planar_poses([[0, 0], [1, 0]], [0, 0])
    >>> am.write_g2o(path, am.PoseGraph(X, [[0, 1]], X[1:], 4 * np.eye(3)))
    >>> with open(path, encoding="utf-8") as file:
    ...     print(file.read(), end="")
    VERTEX_SE2 0 0.0 0.0 0.0
    VERTEX_SE2 1 1.0 0.0 0.0
    EDGE_SE2 0 1 1.0 0.0 0.0 4.0 0.0 0.0 4.0 0.0 4.0
    FIX 0
    """
    if not isinstance(graph, PoseGraph):
        raise AmrError(
            f"graph is a {type(graph).__name__}; expected a PoseGraph, such as the graph of an "
            "Optimization."
        )
    vertex, edge = PLANE if graph.dim == 3 else SPACE
    upper = np.triu_indices(graph.dim)
    names = graph.ids[:, None].tolist()
    ends = graph.ids[graph.edges].tolist()
    numbers = np.column_stack([_coordinates(graph.measurements), graph.information[:, *upper]])
    opener = gzip.open if str(path).endswith(".gz") else open
    with opener(path, "wt", encoding="utf-8", newline="\n") as file:
        file.writelines(_lines(vertex, names, _coordinates(graph.poses)))
        file.writelines(_lines(edge, ends, numbers))
        # Last, because gtsam's reader of planar files stops at the first FIX.
        file.writelines(f"FIX {graph.ids[k]}\n" for k in graph.fixed)


def _lines(tag, names, numbers):
    # repr gives the shortest digits that read back as the same double.
    for name, row in zip(names, numbers.tolist(), strict=True):
        yield f"{tag} {' '.join(map(str, name))} {' '.join(map(repr, row))}\n"


def _coordinates(X):
    """Return x, y, heading or x, y, z, qx, qy, qz, qw of poses."""
    if X.shape[-1] == 3:
        # Adding 0 turns -0.0, which nobody wants to read, into 0.0.
        return np.column_stack([X[:, :2, 2], np.arctan2(X[:, 1, 0], X[:, 0, 0])]) + 0.0
    from scipy.spatial.transform import Rotation

    q = Rotation.from_matrix(X[:, :3, :3]).as_quat(canonical=True)
    return np.column_stack([X[:, :3, 3], q]) + 0.0


def _place(X, known, edges, Z):
    """Put the nodes that are not known where a chain of edges, as short as possible, leads.

    Each round places the neighbors of what is placed; a part of the graph without a known
    node starts with its first node where it is.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    placed = known.copy()
    links = coo_array((np.ones(len(edges)), edges.T), shape=(len(X), len(X)))
    parts, part = connected_components(links, directed=False)
    first = np.unique(part, return_index=True)[1]
    without = np.setdiff1d(np.arange(parts), part[known])
    placed[first[without]] = True
    both = np.concatenate([edges, edges[:, ::-1]])
    motion = np.concatenate([Z, _groups.inverse(Z)])
    order = np.argsort(both[:, 0], kind="stable")
    both, motion = both[order], motion[order]
    start = np.searchsorted(both[:, 0], np.arange(len(X) + 1))
    queue = np.flatnonzero(placed).tolist()
    for i in queue:
        for k in range(start[i], start[i + 1]):
            j = both[k, 1]
            if not placed[j]:
                X[j] = X[i] @ motion[k]
                placed[j] = True
                queue.append(j)


class _Rows:
    """The lines of one file by their first word, and what is repaired in it."""

    def __init__(self, path, strict):
        self.path, self.strict, self.repairs = path, strict, []
        self.by_tag = {}
        for number, text in enumerate(_text(path).splitlines(), start=1):
            words = text.split("#", 1)[0].split(maxsplit=1)
            if words:
                rest = words[1] if len(words) == 2 else ""
                self.by_tag.setdefault(words[0], []).append((number, rest))

    def error(self, line, text):
        return AmrError(f"{self.path}, line {line}: {text}")

    def repair(self, text, line):
        """Remember what was repaired from that line on, or refuse it."""
        if self.strict:
            raise self.error(line, f"{text}. strict=False reads the file all the same.")
        self.repairs.append(f"{text} (first on line {line})")

    def report(self):
        if self.repairs:
            # Seen from whoever called read_g2o.
            warnings.warn(f"{self.path}: {'; '.join(self.repairs)}.", RecordingWarning, 3)

    def kinds(self):
        """Return the tags of vertices and edges of the file, after a look at all others."""
        planar, spatial = (any(tag in self.by_tag for tag in kind) for kind in (PLANE, SPACE))
        if planar and spatial:
            raise AmrError(
                f"{self.path} mixes SE2 and SE3; a graph lives in the plane or in space."
            )
        # Parameters (of sensors) say nothing about poses.
        other = {
            tag: rows
            for tag, rows in self.by_tag.items()
            if tag not in (*COLUMNS, "FIX") and not tag.startswith("PARAMS_")
        }
        left_out = sum(map(len, other.values()))
        total = sum(map(len, self.by_tag.values()))
        kinds = ", ".join(f"{tag} ({len(rows)})" for tag, rows in other.items())
        if left_out > MOST_LEFT_OUT * total or (left_out and not (planar or spatial)):
            first = min(rows[0][0] for rows in other.values())
            if any(tag in TORO for tag in other):
                advice = "VERTEX2 and EDGE2 are TORO's, in another order; convert it to g2o first."
            else:
                advice = "Without them it is another problem; remove those lines if it is meant."
            kinds = kinds if len(kinds) < 200 else f"{kinds[:200]} ..."
            raise self.error(
                first,
                f"{left_out} of {total} lines are neither poses nor edges between poses: {kinds}. "
                f"{advice}",
            )
        if left_out:
            first = min(rows[0][0] for rows in other.values())
            self.repair(f"lines left out: {kinds}", first)
        vertex, edge = SPACE if spatial else PLANE
        if edge not in self.by_tag:
            raise AmrError(
                f"{self.path} has no edge: {total} lines that are neither blank nor comments, none "
                "of them EDGE_SE2 or EDGE_SE3:QUAT."
            )
        return vertex, edge

    def numbers(self, tag, names):
        """Return the ids (K, names), the numbers (K, columns) and the line numbers of a tag."""
        rows = self.by_tag.get(tag, [])
        lines = np.array([number for number, _ in rows], dtype=int)
        width = names + COLUMNS[tag]
        words = [rest.split() for _, rest in rows]
        for (line, _), found in zip(rows, words, strict=True):
            if len(found) != width:
                raise self.error(
                    line, f"{tag} with {len(found)} numbers behind it, expected {width}."
                )
        ids = [
            [self.whole(word, line) for word in found[:names]]
            for (line, _), found in zip(rows, words, strict=True)
        ]
        try:
            table = np.array([found[names:] for found in words], dtype=float)
            bad = ~np.isfinite(table) | (np.abs(table) > LARGEST)
        except ValueError:
            bad = np.ones((len(words), 1), dtype=bool)
        if bad.any():
            raise self.complaint(tag, names, rows)
        shape = (len(rows), COLUMNS[tag])
        return np.array(ids, dtype=np.int64).reshape(-1, names), table.reshape(shape), lines

    def whole(self, word, line):
        try:
            number = int(word)
            np.int64(number)
        except (ValueError, OverflowError):
            raise self.error(line, f"{word!r} is no id; expected a whole number.") from None
        return number

    def complaint(self, tag, names, rows):
        """Return the error of the first number that is none."""
        for line, rest in rows:
            for column, word in enumerate(rest.split()[names:], start=names + 2):
                try:
                    number = float(word)
                except ValueError:
                    return self.error(line, f"column {column}, {word!r} is not a number.")
                if not abs(number) <= LARGEST:
                    return self.error(line, f"column {column} of {tag} is {word}.")
        raise AssertionError("every number is one")

    def refuse_repeated(self, names, lines):
        order = np.argsort(names, kind="stable")
        again = np.flatnonzero(np.diff(names[order]) == 0)
        if len(again):
            k = order[again + 1].min()
            raise self.error(lines[k], f"node {names[k]} has a VERTEX line already.")

    def refuse_loops(self, ends, lines):
        loop = ends[:, 0] == ends[:, 1]
        if loop.any():
            k = int(np.argmax(loop))
            raise self.error(lines[k], f"an edge from node {ends[k, 0]} to itself.")

    def poses(self, numbers, lines):
        """Return poses of x, y, heading or of x, y, z and a quaternion."""
        if numbers.shape[1] == 3:
            return planar_poses(numbers[:, :2], numbers[:, 2])
        q = numbers[:, 3:]
        length = np.linalg.norm(q, axis=1)
        off = np.abs(length - 1)
        if off.max() > REPAIRED_WITHIN:
            k = int(np.argmax(off > REPAIRED_WITHIN))
            raise self.error(
                lines[k],
                f"the quaternion has length {length[k]:.6g}, a rotation needs 1. The order is x, "
                "y, z, w.",
            )
        long = off > UNIT_QUATERNION_WITHIN
        if long.any():
            text = f"{long.sum()} quaternions, up to {100 * off.max():.2g} % off unit length, were"
            self.repair(f"{text} normalized", int(lines[long].min()))
        return spatial_poses(numbers[:, :3], q / length[:, None])

    def information(self, triangles, lines):
        """Return symmetric positive definite matrices of their upper triangles, row by row."""
        n = 3 if triangles.shape[1] == 6 else 6
        rows, columns = np.triu_indices(n)
        W = np.empty((len(triangles), n, n))
        W[:, rows, columns] = W[:, columns, rows] = triangles
        bad = not_positive_definite(W)
        if bad.any():
            k = int(np.argmax(bad))
            raise self.error(
                lines[k],
                "the information matrix is not positive definite: some direction has no or "
                "negative information. The upper triangle is expected, row by row.",
            )
        return W

    def fixed(self, ids):
        """Return the indices of the nodes that FIX lines name."""
        names = [
            (self.whole(word, line), line)
            for line, rest in self.by_tag.get("FIX", [])
            for word in rest.split()
        ]
        for name, line in names:
            if name not in ids:
                raise self.error(line, f"FIX {name}, but no line has a node {name}.")
        return tuple(np.searchsorted(ids, [name for name, _ in names]).tolist())


def _text(path):
    opener = gzip.open if str(path).endswith(".gz") else open
    try:
        with opener(path, "rt", encoding="utf-8-sig") as file:
            return file.read()
    except (UnicodeDecodeError, gzip.BadGzipFile, EOFError, zlib.error) as error:
        raise AmrError(f"{path} is not a text file in UTF-8 ({error}).") from None
