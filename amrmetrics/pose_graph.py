"""Pose graphs in the plane and in space: residuals, and their least squares (lecture 07).

Nodes are poses X_i; an edge (i, j) carries a measurement Z of inverse(X_i) X_j with an
information matrix W, the inverse of its covariance. Its residual is the tangent vector
e = log(inverse(Z) inverse(X_i) X_j), translation first, and its chi-square is e^T W e.
"""

from copy import copy
from dataclasses import dataclass, replace

import numpy as np

from amrmetrics import _groups
from amrmetrics._arguments import as_array, as_numbers, as_poses
from amrmetrics.errors import AmrError
from amrmetrics.loops import as_information, residual_summary


@dataclass(frozen=True, eq=False, repr=False)
class PoseGraph:
    """Poses and what was measured between them.

    Attributes
    ----------
    poses : (N, d+1, d+1) array
        The nodes, robot frame to world frame, meters, d = 2 or 3: where an optimizer starts.
    edges : (M, 2) array of int
        Indices (i, j) into `poses`, i != j; two nodes may have several edges.
    measurements : (M, d+1, d+1) array
        Measured inverse(X_i) X_j: the pose of node j in the frame of node i.
    information : (M, n, n) array
        Inverse covariance of each measurement, n = 3 or 6, symmetric positive definite, in
        the order of the residual: x, y, (z,) in the frame of the measured pose, then the
        heading (or rotation vector); 1/m^2, 1/rad^2. One (n, n) matrix stands for all.
    fixed : tuple of int
        Indices of the nodes that `optimize` does not move: the gauge. Only the first by
        default; with none, nothing says where the map lies in the world.
    ids : (N,) array of int
        Names of the nodes in a file, increasing; 0 to N - 1 by default.

    Raises
    ------
    AmrError
        If shapes do not fit, a pose is no rigid motion, an information matrix not
        symmetric positive definite, an index out of range, an edge joins a node to
        itself, or an id occurs twice.

    Examples
    --------
    Two steps ahead, and a closure that says 1.7 m instead of 2 m.

    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.planar_poses([[0, 0], [1, 0], [2, 0]], [0, 0, 0])
    >>> Z = am.planar_poses([[1, 0], [1, 0], [1.7, 0]], [0, 0, 0])
    >>> graph = am.PoseGraph(X, [[0, 1], [1, 2], [0, 2]], Z, 100 * np.eye(3))
    >>> graph.residuals().round(6).tolist()
    [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.3, 0.0, 0.0]]
    >>> am.positions(am.optimize(graph).poses).round(6).tolist()
    [[0.0, 0.0], [0.9, 0.0], [1.8, 0.0]]
    """

    poses: np.ndarray
    edges: np.ndarray
    measurements: np.ndarray
    information: np.ndarray
    fixed: tuple = (0,)
    ids: np.ndarray | None = None

    def __post_init__(self):
        poses = as_poses(self.poses, "poses").copy()
        edges = _as_edges(self.edges, len(poses))
        Z = as_poses(self.measurements, "measurements").copy()
        if Z.shape != (len(edges), *poses.shape[1:]):
            raise AmrError(
                f"measurements has shape {Z.shape}; {len(edges)} edges between poses of shape "
                f"{poses.shape[1:]} need shape {(len(edges), *poses.shape[1:])}."
            )
        n = 3 if poses.shape[-1] == 3 else 6
        information = as_information(self.information, len(edges), n)
        values = {
            "poses": poses,
            "edges": edges,
            "measurements": Z,
            "information": information,
            "fixed": _as_fixed(self.fixed, len(poses)),
            "ids": _as_ids(self.ids, len(poses)),
        }
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @property
    def dim(self):
        """Number of components of a residual: 3 in the plane, 6 in space."""
        return self.information.shape[-1]

    @property
    def free(self):
        """Indices of the nodes that are not fixed, (F,)."""
        return np.setdiff1d(np.arange(len(self.poses)), self.fixed)

    def residuals(self):
        """Return e = log(inverse(Z) inverse(X_i) X_j) of each edge, (M, n); angles within pi."""
        i, j = self.edges.T
        return _groups.log(
            _groups.inverse(self.measurements) @ (_groups.inverse(self.poses[i]) @ self.poses[j])
        )

    def jacobians(self):
        """Return the derivatives of the residuals, (M, n, n) each, at nodes i and at nodes j.

        They belong to the motions X_i Exp(delta_i) and X_j Exp(delta_j): each delta in the
        frame of its own node.
        """
        i, j = self.edges.T
        return _groups.jacobians(self.residuals(), _groups.inverse(self.poses[j]) @ self.poses[i])

    def summary(self):
        """Return the `ResidualSummary`; all nodes that are not fixed count as fitted."""
        return residual_summary(self.residuals(), self.information, free_nodes=len(self.free))

    def with_poses(self, poses):
        """Return the graph with other poses, as many."""
        poses = as_poses(poses, "poses")
        if poses.shape != self.poses.shape:
            raise AmrError(f"poses has shape {poses.shape}; the graph has {self.poses.shape}.")
        return self._at(poses.copy())

    def _at(self, poses):
        # What is not new has been checked, which takes as long as a step of the optimizer.
        graph = copy(self)
        object.__setattr__(graph, "poses", poses)
        return graph

    def with_edges(self, edges, measurements, information):
        """Return the graph with further edges behind its own."""
        edges = _as_edges(edges, len(self.poses))
        return replace(
            self,
            edges=np.concatenate([self.edges, edges]),
            measurements=np.concatenate(
                [self.measurements, as_poses(measurements, "measurements")]
            ),
            information=np.concatenate(
                [self.information, as_information(information, len(edges), self.dim)]
            ),
        )

    def keep(self, edges):
        """Return the graph with those edges alone: a mask (M,) or their indices."""
        edges = as_choice(edges, "edges", len(self.edges))
        return replace(
            self,
            edges=self.edges[edges],
            measurements=self.measurements[edges],
            information=self.information[edges],
        )

    def __repr__(self):
        space = "plane" if self.dim == 3 else "space"
        anchors = ", ".join(str(self.ids[k]) for k in self.fixed[:3])
        more = ", ..." if len(self.fixed) > 3 else ""
        return (
            f"pose graph in the {space}: {len(self.poses)} nodes, {len(self.edges)} edges, fixed "
            f"{anchors + more or 'none'}"
        )


def as_choice(value, name, count):
    """Return the indices of some of so many things, from a mask or from indices."""
    array = as_array(value, name)
    if array.dtype == bool:
        if array.shape != (count,):
            raise AmrError(f"{name} has shape {array.shape}; a mask needs shape ({count},).")
        return np.flatnonzero(array)
    indices = _as_indices(array, name)
    if indices.ndim != 1 or (indices < 0).any() or (indices >= count).any():
        raise AmrError(
            f"{name} is {value!r}; expected a mask of shape ({count},) or indices from 0 to "
            f"{count - 1}."
        )
    return indices


def _as_edges(value, nodes):
    edges = _as_indices(value, "edges")
    if edges.ndim != 2 or edges.shape[1:] != (2,) or not len(edges):
        raise AmrError(f"edges has shape {edges.shape}; expected (M, 2), node indices, M >= 1.")
    outside = (edges < 0) | (edges >= nodes)
    if outside.any():
        k, end = np.argwhere(outside)[0].tolist()
        raise AmrError(
            f"edges[{k}, {end}] is {edges[k, end]}; the graph has {nodes} poses, so indices run "
            f"from 0 to {nodes - 1}."
        )
    loop = edges[:, 0] == edges[:, 1]
    if loop.any():
        k = int(np.argmax(loop))
        raise AmrError(f"edges[{k}] joins node {edges[k, 0]} to itself; it measures nothing.")
    return edges


def _as_fixed(value, nodes):
    fixed = np.unique(_as_indices(value, "fixed"))
    if np.ndim(value) != 1:
        raise AmrError(f"fixed is {value!r}; expected node indices, such as (0,).")
    outside = (fixed < 0) | (fixed >= nodes)
    if outside.any():
        raise AmrError(
            f"fixed holds {fixed[outside][0]}; the graph has {nodes} poses, so indices run from 0 "
            f"to {nodes - 1}."
        )
    return tuple(fixed.tolist())


def _as_ids(value, nodes):
    if value is None:
        return np.arange(nodes)
    ids = _as_indices(value, "ids")
    if ids.shape != (nodes,) or (ids[1:] <= ids[:-1]).any():
        raise AmrError(f"ids has shape {ids.shape}; expected {nodes} increasing whole numbers.")
    return ids


def _as_indices(value, name):
    """Return whole numbers as an array of int64 of its own."""
    array = as_array(value, name)
    if array.dtype.kind in "iu" and (not array.size or array.max() < 2**63):
        return array.astype(np.int64)
    numbers = as_numbers(array, name)
    if (numbers != np.round(numbers)).any() or np.abs(numbers).max(initial=0) > 2**53:
        raise AmrError(f"{name} must hold whole numbers.")
    return numbers.astype(np.int64)
