"""Least squares on a pose graph: sparse, damped, robust (lecture 07)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics import _groups
from amrmetrics._arguments import as_array, as_count, as_size
from amrmetrics._results import Result
from amrmetrics.errors import AmrError
from amrmetrics.loops import LOSSES, as_loss, information_roots, inlier_ratio, summarize
from amrmetrics.pose_graph import PoseGraph

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike

# A step is final if it moves no node by more than this part of the size of the map, nor turns
# one by more than this, radians.
SMALLEST_STEP = 1e-12

# Damping (in units of the mean curvature) up to which a step is nearly that of Gauss-Newton.
TRUSTED = 1e-6

# Damping, in the same units, at which the search for a smaller cost is given up.
LARGEST_DAMPING = 1e6

# Columns that SuperLU works on together. With 32, that of SciPy 1.17 leaves its memory and crashes.
PANEL = 2

# A decrease that is predicted smaller than this part of the cost is lost in its rounding.
ROUNDING = 1e-14


@dataclass(frozen=True, eq=False, repr=False)
class Optimization(Result):
    """Where an optimizer came to rest, and why it stopped.

    Attributes
    ----------
    poses : (N, d+1, d+1) array
        The nodes of smallest cost.
    converged : bool
        False if it stopped for another reason than that no step lowers the cost.
    reason : str
        Why it stopped.
    iterations : int
        Linear systems solved, those whose step was rejected included.
    chi_square, chi_square_before : float
        Sum of e^T W e over all edges, unweighted, after and before.
    dof : int
        Its degrees of freedom: (edges - free nodes) times 3 or 6.
    p_value : float
        Probability of a chi-square as large or larger if every edge is as good as its
        information says; nan without degrees of freedom.
    cost, cost_before : float
        What was minimized: the sum of rho(x) over the edges, x = sqrt(e^T W e). The same
        as chi-square for the linear loss.
    loss : str
        "linear", "huber", "cauchy" or "geman_mcclure".
    width : float
        Of the kernel, in units of x; nan for the linear loss.
    weights : (M,) array
        Weight of each edge at the end, in [0, 1]; 1 where no kernel acts.
    edge_chi_square : (M,) array
        e^T W e of each edge at the end.
    history : (K,) array
        The cost at the start and after each accepted step.
    graph : PoseGraph
        The graph with these poses.
    """

    poses: np.ndarray
    converged: bool
    reason: str
    iterations: int
    chi_square: float
    chi_square_before: float
    dof: int
    p_value: float
    cost: float
    cost_before: float
    loss: str
    width: float
    weights: np.ndarray
    edge_chi_square: np.ndarray
    history: np.ndarray
    graph: PoseGraph = field(repr=False)

    def summary(self):
        """Return the `ResidualSummary` at the end."""
        return self.graph.summary()

    def inlier_ratio(self, confidence=0.95):
        """Return the `InlierRatio` at the end, by gate and by the kernel used."""
        kernel = {} if self.loss == "linear" else {"loss": self.loss, "width": self.width}
        return inlier_ratio(self.graph.residuals(), self.graph.information, confidence, **kernel)

    def __repr__(self):
        kernel = "" if self.loss == "linear" else f", {self.loss} of width {self.width:.4g}"
        return (
            f"{'' if self.converged else 'NOT CONVERGED, '}{self.reason}: chi-square "
            f"{self.chi_square_before:.6g} before, {self.chi_square:.6g} after, dof {self.dof}, p "
            f"{self.p_value:.3g}, {self.iterations} iterations{kernel}"
        )


def optimize(
    graph: PoseGraph,
    loss: str = "linear",
    *,
    width: float | None = None,
    robust: ArrayLike | None = None,
    damping: float = 1e-9,
    max_iterations: int = 500,
    tolerance: float = 1e-8,
) -> Optimization:
    """Move the free nodes to where the edges agree best.

    Parameters
    ----------
    graph : PoseGraph
        Where to start, what to agree with, and which nodes stay.
    loss : {"linear", "huber", "cauchy", "geman_mcclure"}
        What an edge with x = sqrt(e^T W e) costs. Linear: x^2. Others grow more slowly
        beyond the width k: Huber 2 k x - k^2, Cauchy k^2 log(1 + x^2/k^2), Geman-McClure
        x^2 / (1 + x^2/k^2). Solved by reweighting: weight = (d rho / dx) / (2 x).
    width : float, optional
        k, in units of x, that is of standard deviations. By default the x that 95 % of
        right edges stay below: 2.795 in the plane, 3.548 in space.
    robust : (M,) bool array, optional
        The edges on which the kernel acts, for example the closures; all by default.
    damping : float
        Levenberg-Marquardt damping to begin with, in units of the mean curvature, >= 0.
        It is adapted. 0 is plain Gauss-Newton: every step is taken as it is.
    max_iterations : int
        When to give up.
    tolerance : float
        Stop when a step promises to lower the cost by less than this part of it.

    Returns
    -------
    Optimization
        Poses, chi-square before and after with its test, weights, and why it stopped. The
        cost never rises (unless `damping` is 0); the minimum may still be a local one.

    Raises
    ------
    AmrError
        If no node is fixed, a node is not connected to a fixed one, an argument is out of
        range, or the iteration diverges.

    Notes
    -----
    Each step solves (H + lambda D) delta = -J^T W e by a sparse LU decomposition in a
    fill-reducing order that is computed once, D the mean curvature times the identity;
    poses move by X Exp(delta).

    References
    ----------
    Lecture 07. Grisetti, Kuemmerle, Stachniss and Burgard, A tutorial on graph-based SLAM,
    IEEE ITS Magazine 2 (2010), eqs. (14)-(19); kernels: Zhang, Parameter estimation
    techniques: a tutorial, Image and Vision Computing 15 (1997), table 1.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> X = am.planar_poses([[0, 0], [1, 0], [2, 0]], [0, 0, 0])
    >>> Z = am.planar_poses([[1, 0], [1, 0], [1.7, 0]], [0, 0, 0])
    >>> graph = am.PoseGraph(X, [[0, 1], [1, 2], [0, 2]], Z, 100 * np.eye(3))
    >>> result = am.optimize(graph)
    >>> round(result.chi_square_before, 9), round(result.chi_square, 9), result.dof
    (9.0, 3.0, 3)
    """
    _refuse_graph(graph)
    width = as_loss(loss, width, graph.dim)
    damping = float(as_size(damping, "damping", sign=">= 0"))
    tolerance = float(as_size(tolerance, "tolerance", sign=">= 0"))
    problem = _Problem(graph, LOSSES[loss], width, _as_mask(robust, len(graph.edges)))
    search = _Search(problem, damping, tolerance)
    search.run(as_count(max_iterations, "max_iterations"))
    summary = summarize(search.chi_square, graph.dim, len(graph.free))
    return Optimization(
        poses=search.X,
        converged=search.converged,
        reason=search.reason,
        iterations=search.iterations,
        chi_square=summary.chi_square,
        chi_square_before=search.before,
        dof=summary.dof,
        p_value=summary.p_value,
        cost=search.cost,
        cost_before=search.history[0],
        loss=loss,
        width=width,
        weights=search.weights,
        edge_chi_square=summary.edge_chi_square,
        history=np.array(search.history),
        graph=graph._at(search.X),
    )


def _refuse_graph(graph):
    """Refuse what no least squares can place: nodes without a path to a fixed one."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    if not isinstance(graph, PoseGraph):
        raise AmrError(f"graph is a {type(graph).__name__}; expected a PoseGraph.")
    if not graph.fixed:
        raise AmrError(
            "graph has no fixed node, so the whole map could lie anywhere. Fix one, such as "
            "dataclasses.replace(graph, fixed=(0,))."
        )
    n = len(graph.poses)
    links = coo_array((np.ones(len(graph.edges)), graph.edges.T), shape=(n, n))
    _, part = connected_components(links, directed=False)
    loose = ~np.isin(part, part[list(graph.fixed)])
    if loose.any():
        names = ", ".join(map(str, graph.ids[loose][:3])) + ", ..." * int(loose.sum() > 3)
        raise AmrError(
            f"graph is not connected: no edges lead from {loose.sum()} of {n} nodes (ids {names}) "
            "to a fixed one. Add an edge, or fix a node of each part: dataclasses.replace(graph, "
            "fixed=...)."
        )


def _as_mask(robust, edges):
    if robust is None:
        return np.ones(edges, dtype=bool)
    mask = as_array(robust, "robust")
    if mask.dtype != bool or mask.shape != (edges,):
        raise AmrError(
            f"robust has shape {mask.shape} and type {mask.dtype}; expected one bool per edge, "
            f"shape ({edges},)."
        )
    return mask


class _Problem:
    """The normal equations of a graph: their sparsity is worked out once, their values often."""

    def __init__(self, graph, loss, width, robust):
        self.graph, self.loss, self.width, self.robust = graph, loss, width, robust
        self.i, self.j = graph.edges.T
        self.back = _groups.inverse(graph.measurements)
        self.roots = information_roots(graph.information)
        self.free = graph.free
        self.unknown = _order(graph)
        # Reused from step to step: memory that is new each time costs more than the products.
        self.products = np.empty((4, *graph.information.shape))
        self._plan()

    def _plan(self):
        """Say where each product of two Jacobians goes in the matrix, stored by columns."""
        from scipy.sparse import csr_array

        n, F = self.graph.dim, len(self.free)
        i, j = self.unknown[self.i], self.unknown[self.j]
        rows, columns = np.concatenate([i, j, i, j]), np.concatenate([i, j, j, i])
        inside = np.flatnonzero((rows >= 0) & (columns >= 0))
        keys, block = np.unique(columns[inside] * F + rows[inside], return_inverse=True)
        ones = np.ones(len(inside))
        self.sum_blocks = csr_array((ones, (block, inside)), shape=(len(keys), len(rows)))
        ends = np.concatenate([i, j])
        inside = np.flatnonzero(ends >= 0)
        ones = np.ones(len(inside))
        self.sum_ends = csr_array((ones, (ends[inside], inside)), shape=(F, len(ends)))
        column, row = np.divmod(keys, max(F, 1))
        height = np.bincount(column, minlength=F)
        first = np.concatenate([[0], height.cumsum()])
        # Entry (a, b) of a block stands in scalar column b of its block column.
        a, b = np.arange(n)[:, None], np.arange(n)
        above = (np.arange(len(keys)) - first[column])[:, None, None]
        start = (n * n * first[column])[:, None, None]
        self.place = start + b * (n * height[column])[:, None, None] + n * above + a
        self.diagonal = self.place[row == column][:, np.arange(n), np.arange(n)].ravel()
        self.indices = np.empty(self.place.size, dtype=np.intc)
        self.indices[self.place] = (n * row)[:, None, None] + a + 0 * b
        starts = n * n * first[:-1, None] + b * (n * height)[:, None]
        self.indptr = np.append(starts.ravel(), self.place.size).astype(np.intc)

    def residuals(self, X):
        """Return the residuals and the way from j to i that their derivatives need."""
        back = _groups.inverse(X[self.j]) @ X[self.i]
        return _groups.log(self.back @ _groups.inverse(back)), back

    def costs(self, e):
        """Return chi-square, cost and weight of each edge."""
        white = np.einsum("mij,mj->mi", self.roots, e)
        chi_square = np.einsum("mi,mi->m", white, white)
        rho, weight = self.loss(chi_square, self.width)
        return (
            chi_square,
            np.where(self.robust, rho, chi_square),
            np.where(self.robust, weight, 1.0),
        )

    def equations(self, e, back, weight):
        """Return the values of J^T W J, stored by columns, and J^T W e, (F, n)."""
        n = self.graph.dim
        roots = np.sqrt(weight)[:, None, None] * self.roots
        A, B = (roots @ J for J in _groups.jacobians(e, back))
        At, Bt = A.swapaxes(1, 2), B.swapaxes(1, 2)
        AA, BB, AB, BA = self.products
        np.matmul(At, A, out=AA)
        np.matmul(Bt, B, out=BB)
        np.matmul(At, B, out=AB)
        BA[:] = AB.swapaxes(1, 2)
        sums = self.sum_blocks @ self.products.reshape(-1, n * n)
        values = np.empty(self.place.size)
        values[self.place] = sums.reshape(-1, n, n)
        white = roots @ e[:, :, None]
        gradient = self.sum_ends @ np.concatenate([At @ white, Bt @ white])[:, :, 0]
        return values, gradient

    def solve(self, values, gradient, damping):
        """Return the step of each free node, (F, n), or None if the matrix is singular."""
        from scipy.sparse import csc_array
        from scipy.sparse.linalg import splu

        damped = values.copy()
        damped[self.diagonal] += damping
        matrix = csc_array((damped, self.indices, self.indptr), shape=(gradient.size,) * 2)
        try:
            # Symmetric positive definite: the order is ours, and no pivot is searched.
            factors = splu(
                matrix,
                permc_spec="NATURAL",
                diag_pivot_thresh=0,
                relax=self.graph.dim,  # its own value takes up to three times as long
                panel_size=PANEL,
                options={"SymmetricMode": True},
            )
        except RuntimeError:
            return None
        return -factors.solve(gradient.ravel()).reshape(gradient.shape)

    def moved(self, X, step):
        """Return the poses after a step of each free node in its own frame."""
        Y = X.copy()
        Y[self.free] = X[self.free] @ _groups.exp(step[self.unknown[self.free]])
        return Y


def _order(graph):
    """Return for each node its place among the unknowns, in an order that keeps factors sparse.

    Fixed nodes get -1.
    """
    from scipy.sparse import coo_array, eye_array
    from scipy.sparse.linalg import splu

    n, free = len(graph.poses), graph.free
    unknown = np.full(n, -1)
    if not len(free):
        return unknown
    unknown[free] = np.arange(len(free))
    i, j = unknown[graph.edges].T
    both = (i >= 0) & (j >= 0)
    i, j = i[both], j[both]
    links = coo_array((np.ones(len(i)), (i, j)), shape=(len(free),) * 2).tocsc()
    links = links + links.T
    # Only the order is wanted; the weights make it a matrix that has a decomposition.
    matrix = eye_array(len(free)) * (1 + links.sum(0).max()) - links
    factors = splu(
        matrix.tocsc(),
        permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0,
        options={"SymmetricMode": True},
    )
    unknown[free] = factors.perm_c
    return unknown


class _Search:
    """One minimization: the best poses so far, and what to try next."""

    def __init__(self, problem, damping, tolerance):
        self.problem, self.damping, self.tolerance = problem, damping, tolerance
        self.plain = damping == 0
        self.growth = 10.0
        self.reason, self.converged, self.iterations = "", False, 0
        X = problem.graph.poses
        self.extent = 1 + np.abs(X[:, :-1, -1]).max()
        self._place(X, *self._look(X))
        self.before = float(self.chi_square.sum())
        self.history = [self.cost]
        if not np.isfinite(self.cost):
            raise AmrError("the cost of graph is not finite: residuals or information overflow.")

    def _look(self, X):
        with np.errstate(over="ignore", invalid="ignore"):
            e, back = self.problem.residuals(X)
            chi_square, rho, weights = self.problem.costs(e)
            return e, back, chi_square, float(rho.sum()), weights

    def _place(self, X, e, back, chi_square, cost, weights):
        self.X, self.e, self.back = X, e, back
        self.chi_square, self.cost, self.weights = chi_square, cost, weights
        self.equations = None

    def run(self, max_iterations):
        """Iterate until there is a reason to stop."""
        if not len(self.problem.free):
            self.reason, self.converged = "no node is free", True
        while not self.reason and self.iterations < max_iterations:
            self.iterations += 1
            self._step()
        if self.plain and not self.converged and self.cost > self.history[0]:
            self._diverged()
        self.reason = self.reason or f"stopped after {max_iterations} iterations"

    def _step(self):
        problem = self.problem
        if self.equations is None:
            self.equations = problem.equations(self.e, self.back, self.weights)
            self.curvature = self.equations[0][problem.diagonal].mean()
        damping = self.damping * self.curvature
        step = problem.solve(*self.equations, damping)
        if step is None or not np.isfinite(step).all():
            self._reject()
            return
        promised = damping * (step * step).sum() - (self.equations[1] * step).sum()
        X = problem.moved(self.X, step)
        found = self._look(X)
        gained = self.cost - found[3]
        if self.plain and not np.isfinite(found[3]):
            self._diverged()
        last = self._negligible(promised) and self._settled()
        if self.plain or gained >= 0:
            self._place(X, *found)
            self.history.append(self.cost)
            if gained > promised / 4:
                self.damping, self.growth = self.damping / 10, 10.0
            else:
                self.damping *= 10
        elif not last:
            self._reject()
        turn = self.problem.graph.poses.shape[-1] - 1
        moved = max(np.abs(step[:, :turn]).max() / self.extent, np.abs(step[:, turn:]).max())
        if last:
            self.converged, self.reason = True, "converged: no step promises a smaller cost"
        elif moved <= SMALLEST_STEP and self.damping <= TRUSTED:
            self.converged, self.reason = True, "converged: the step is lost in rounding"

    def _negligible(self, gain):
        return gain <= max(self.tolerance, ROUNDING) * self.cost

    def _settled(self):
        """Say if a step without much damping, too, promises little; a damped one always does."""
        if self.damping <= TRUSTED:
            return True
        step = self.problem.solve(*self.equations, TRUSTED * self.curvature)
        return step is not None and self._negligible(-(self.equations[1] * step).sum())

    def _reject(self):
        if self.plain:
            raise AmrError(
                "the normal equations are singular. Use damping above 0, or check that every node "
                "is held by its edges."
            )
        self.damping, self.growth = self.damping * self.growth, self.growth * 10
        if self.damping > LARGEST_DAMPING:
            self.reason = "no step lowers the cost"

    def _diverged(self):
        raise AmrError(
            f"Gauss-Newton without damping diverges: the cost is {self.cost:.6g} after "
            f"{self.iterations} iterations and was {self.history[0]:.6g}. Leave damping at its "
            "default, or start closer."
        )
