"""How good loop closures are: detection curves, residuals, inliers, kernels (lecture 07).

A rate with nothing to count is nan, with the reason in the result; it is never made up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_binary, as_count, as_numbers, as_probability, as_size
from amrmetrics._results import Number, Result
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike

# The default width of a kernel leaves this share of right edges below it.
UNTOUCHED = 0.95

# An information matrix may differ from its transpose by this part of its largest entry.
SYMMETRIC_WITHIN = 1e-8


@dataclass(frozen=True, eq=False, repr=False)
class PrecisionRecall(Result):
    """A detector at each of its thresholds: a candidate is accepted if its score is at least it.

    Attributes
    ----------
    thresholds : (K,) array
        The scores that occur, each once, decreasing.
    tp, fp, fn, tn : (K,) array of int
        Counts at each threshold: true and false closures accepted, true and false ones not.
    precision, recall, false_positive_rate, f1 : (K,) array
        Rates in [0, 1] at each threshold, nan where undefined.
    average_precision : float
        Sum of precision times the increase of recall: the area under the steps.
    recall_at_full_precision : float
        Largest recall of a threshold that accepts no false closure; 0 if none does.
    threshold_at_full_precision : float
        The lowest threshold that accepts no false closure; nan if none does.
    undefined : dict
        For each number that is nan, the reason.
    notes : tuple of str
        What else limits what the numbers say.
    """

    thresholds: np.ndarray
    tp: np.ndarray
    fp: np.ndarray
    fn: np.ndarray
    tn: np.ndarray
    precision: np.ndarray
    recall: np.ndarray
    false_positive_rate: np.ndarray
    f1: np.ndarray
    average_precision: float
    recall_at_full_precision: float
    threshold_at_full_precision: float
    undefined: dict
    notes: tuple

    @property
    def n(self):
        """Number of candidates."""
        return int(self.fn[-1] + self.tn[-1] + self.tp[-1] + self.fp[-1]) if len(self.tp) else 0

    @property
    def table(self):
        """One row per threshold, as a dictionary of columns; pandas.DataFrame takes it."""
        names = ("thresholds", "tp", "fp", "fn", "tn", *_RATES)
        return {name: getattr(self, name) for name in names}

    def at(self, threshold):
        """Return the counts and rates at any threshold, one that no candidate reaches included."""
        level = float(as_size(threshold, "threshold", sign=""))
        k = int(np.searchsorted(-self.thresholds, -level, side="right")) - 1
        if k >= 0:
            return {"threshold": level} | {
                name: column[k].item()
                for name, column in self.table.items()
                if name != "thresholds"
            }
        true, false = _totals(self)
        counts = {"tp": 0, "fp": 0, "fn": true, "tn": false}
        return {"threshold": level} | counts | {k: float(v) for k, v in _rates(**counts).items()}

    def __repr__(self):
        true, false = _totals(self)
        reasons = "".join(f"; {name} undefined: {why}" for name, why in self.undefined.items())
        return (
            f"average precision {self.average_precision:.6g}, recall at full precision "
            f"{self.recall_at_full_precision:.6g}, {len(self.thresholds)} thresholds, {true} true "
            f"and {false} false candidates{reasons}" + "".join(f"; {note}" for note in self.notes)
        )


_RATES = ("precision", "recall", "false_positive_rate", "f1")


def precision_recall(labels: ArrayLike, scores: ArrayLike) -> PrecisionRecall:
    """Count at every threshold of a loop-closure detector that makes a difference.

    Parameters
    ----------
    labels : (N,) array of 0/1 or bool
        Truth: 1 if the candidate joins two visits of one place. N may be 0.
    scores : (N,) array
        What the detector says, any finite numbers; larger is more certain. Candidates of
        equal score are accepted together.

    Returns
    -------
    PrecisionRecall
        Arrays over the thresholds, average precision, recall at full precision. Time
        N log N. Recall counts what was proposed: a closure that is no candidate is not
        missed here.

    Raises
    ------
    AmrError
        If a label is not 0 or 1, a score not finite, or the shapes differ.

    References
    ----------
    Lecture 07. Davis and Goadrich, The relationship between precision-recall and ROC
    curves, ICML 2006; average precision without interpolation, as in scikit-learn.

    Examples
    --------
    >>> import amrmetrics as am
    >>> curve = am.precision_recall([1, 1, 0, 1, 0], [0.9, 0.8, 0.8, 0.4, 0.1])
    >>> curve.thresholds.tolist(), curve.tp.tolist(), curve.fp.tolist()
    ([0.9, 0.8, 0.4, 0.1], [1, 2, 3, 3], [0, 1, 1, 2])
    >>> round(curve.average_precision, 6), round(curve.recall_at_full_precision, 6)
    (0.805556, 0.333333)
    """
    scores = as_numbers(scores, "scores")
    labels = _as_labels(labels, scores.shape)
    order = np.argsort(scores)[::-1]
    ranked, truth = scores[order], labels[order]
    last = np.flatnonzero(np.r_[ranked[1:] != ranked[:-1], np.ones(min(1, len(ranked)), bool)])
    tp = truth.cumsum()[last]
    fp = last + 1 - tp
    true = int(truth.sum())
    false = len(truth) - true
    rates = _rates(tp, fp, true - tp, false - fp)
    undefined, notes = _undefined(true, false), ()
    if true:
        average = float((np.diff(rates["recall"], prepend=0) * rates["precision"]).sum())
        pure = int((fp == 0).sum())
        best = float(rates["recall"][pure - 1]) if pure else 0.0
    else:
        average, pure, best = np.nan, 0, np.nan
    if len(truth) > 1 and len(last) == 1:
        notes = ("all scores are equal: they rank nothing",)
    if not pure and true:
        undefined["threshold_at_full_precision"] = "a false closure has the highest score"
    lowest = float(ranked[last[pure - 1]]) if pure else np.nan
    return PrecisionRecall(
        thresholds=ranked[last],
        tp=tp,
        fp=fp,
        fn=true - tp,
        tn=false - fp,
        **rates,
        average_precision=average,
        recall_at_full_precision=best,
        threshold_at_full_precision=lowest,
        undefined=undefined,
        notes=notes,
    )


def _totals(curve):
    """Return how many candidates are true and how many are false."""
    if not len(curve.tp):
        return 0, 0
    return int(curve.tp[-1] + curve.fn[-1]), int(curve.fp[-1] + curve.tn[-1])


def _rates(tp, fp, fn, tn):
    return {
        "precision": _ratio(tp, tp + fp),
        "recall": _ratio(tp, tp + fn),
        "false_positive_rate": _ratio(fp, fp + tn),
        "f1": _ratio(2 * tp, 2 * tp + fp + fn),
    }


def _ratio(part, whole):
    return np.divide(part, whole, out=np.full(np.shape(whole), np.nan), where=np.greater(whole, 0))


def _undefined(true, false):
    """Return the reason for each number that is nan with so many true and false candidates."""
    if not true and not false:
        why = "there is no candidate"
        names = ("average_precision", "recall_at_full_precision", "threshold_at_full_precision")
        return dict.fromkeys(names, why)
    undefined = {}
    if not true:
        why = "no candidate is a true closure"
        names = (
            "recall",
            "average_precision",
            "recall_at_full_precision",
            "threshold_at_full_precision",
        )
        undefined |= dict.fromkeys(names, why)
    if not false:
        undefined["false_positive_rate"] = "no candidate is a false closure"
    return undefined


def _as_labels(value, shape):
    meaning = "1 for a candidate that closes a loop, 0 for one that does not"
    labels = as_binary(value, "labels", meaning)
    if labels.ndim != 1 or labels.shape != shape:
        raise AmrError(
            f"labels has shape {labels.shape} and scores {shape}; expected one label and one "
            "score per candidate, shape (N,) both."
        )
    return labels


@dataclass(frozen=True, eq=False, repr=False)
class ResidualSummary(Result):
    """Chi-square of residuals, per edge and in total.

    Attributes
    ----------
    edge_chi_square : (M,) array
        e^T W e of each edge.
    chi_square : float
        Their sum.
    dof : int
        Degrees of freedom: (edges - free nodes) times `dim`.
    p_value : float
        Probability of a sum as large or larger if every information matrix is right; nan
        without degrees of freedom.
    edges, free_nodes, dim : int
        Number of edges, of nodes that were fitted to them, of components of a residual.
    undefined : dict
        For each number that is nan, the reason.
    """

    edge_chi_square: np.ndarray
    chi_square: float
    dof: int
    p_value: float
    edges: int
    free_nodes: int
    dim: int
    undefined: dict

    def __repr__(self):
        reason = "".join(f"; {name} undefined: {why}" for name, why in self.undefined.items())
        return (
            f"chi-square {self.chi_square:.6g}, dof {self.dof}, p {self.p_value:.3g}, "
            f"{self.edges} edges of {self.dim}, {self.free_nodes} free nodes{reason}"
        )


def residual_summary(
    residuals: ArrayLike, information: ArrayLike, *, free_nodes: int = 0
) -> ResidualSummary:
    """Chi-square of the residuals of a graph, per edge and in total, with its p-value.

    Parameters
    ----------
    residuals : (M, n) array
        Residuals e, angles wrapped (see `PoseGraph.residuals`).
    information : (M, n, n) or (n, n) array
        Inverse covariances W, symmetric positive definite; one per residual or one for all.
    free_nodes : int
        How many nodes of n coordinates each were fitted to these residuals: each takes n
        degrees of freedom. 0 for residuals at poses that were not fitted, such as the truth.

    Returns
    -------
    ResidualSummary
        A small p-value says that edges disagree more than they claim; one near 1 that they
        claim too little.

    Raises
    ------
    AmrError
        If an information matrix is not symmetric positive definite (with its index), a
        residual not finite, or shapes do not fit.

    References
    ----------
    Lecture 07. Bar-Shalom, Li and Kirubarajan (2001), section 3.4.2: a least-squares fit
    of p numbers leaves n_z - p degrees of freedom.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> am.residual_summary([[3.0, 0, 0], [0, 0, 0.1]], np.diag([1, 1, 100]))
    chi-square 10, dof 6, p 0.125, 2 edges of 3, 0 free nodes
    """
    free_nodes = as_count(free_nodes, "free_nodes", least=0)
    return summarize(chi_squares(residuals, information), np.shape(residuals)[1], free_nodes)


def summarize(chi_square, dim, free_nodes):
    """Return the `ResidualSummary` of edges with these chi-squares, (M,)."""
    from scipy.special import gammaincc

    edges, total = len(chi_square), float(chi_square.sum())
    dof = (edges - free_nodes) * dim
    p_value, undefined = float("nan"), {}
    if dof > 0:
        p_value = float(gammaincc(dof / 2, total / 2))
    else:
        undefined["p_value"] = f"{edges} edges leave no freedom to {free_nodes} free nodes"
    return ResidualSummary(chi_square, total, dof, p_value, edges, free_nodes, dim, undefined)


@dataclass(frozen=True, eq=False, repr=False)
class InlierRatio(Number):
    """Share of the edges that agree with the rest; converts to a number with ``float()``.

    Attributes
    ----------
    value : float
        Share of the edges inside the gate, in [0, 1].
    by_weight : float
        Mean kernel weight of the edges, in [0, 1].
    inliers : (M,) bool array
        Which edges are inside the gate.
    weights : (M,) array
        Kernel weight of each edge.
    gate : float
        Largest e^T W e of an inlier: the `confidence` quantile of chi-square.
    confidence : float
        Share of right edges that the gate keeps.
    loss : str
        The kernel of the weights.
    width : float
        Its width, in units of sqrt(e^T W e).
    n : int
        Number of edges.
    """

    value: float
    by_weight: float
    inliers: np.ndarray
    weights: np.ndarray
    gate: float
    confidence: float
    loss: str
    width: float
    n: int

    def __float__(self):
        return self.value

    def __repr__(self):
        return (
            f"inlier ratio {self.value:.6g} by the {100 * self.confidence:g} % gate (chi-square at "
            f"most {self.gate:.6g}), {self.by_weight:.6g} by {self.loss} weight of width "
            f"{self.width:.4g}, n {self.n}"
        )


def inlier_ratio(
    residuals: ArrayLike,
    information: ArrayLike,
    confidence: float = 0.95,
    *,
    loss: str = "huber",
    width: float | None = None,
) -> InlierRatio:
    """Share of edges that a chi-square gate keeps, and the mean weight that a kernel leaves.

    Parameters
    ----------
    residuals : (M, n) array
        Residuals e, angles wrapped.
    information : (M, n, n) or (n, n) array
        Inverse covariances W, symmetric positive definite; one per residual or one for all.
    confidence : float
        Share of right edges that stay inside the gate, in (0, 1).
    loss : {"huber", "cauchy", "geman_mcclure"}
        Kernel of the weights, as in `optimize`.
    width : float, optional
        Of the kernel, in units of sqrt(e^T W e); the default is that of `optimize`.

    Returns
    -------
    InlierRatio
        If all edges are right, `value` is `confidence` up to chance and to the fit. A hard
        gate counts an edge or does not; the weight counts it in part.

    Raises
    ------
    AmrError
        As `residual_summary`, and if confidence, loss or width are out of range.

    References
    ----------
    Lecture 07. Gate: Bar-Shalom, Li and Kirubarajan (2001), section 2.5.4 (validation
    region); weights: Zhang (1997), table 1.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> ratio = am.inlier_ratio([[1.0, 0, 0], [9.0, 0, 0]], np.eye(3))
    >>> float(ratio), round(ratio.gate, 3), ratio.inliers.tolist()
    (0.5, 7.815, [True, False])
    """
    chi_square = chi_squares(residuals, information)
    dim = np.shape(residuals)[1]
    confidence = as_probability(confidence, "confidence")
    width = as_loss(loss, width, dim)
    gate = chi_square_quantile(confidence, dim)
    inliers, weights = chi_square <= gate, LOSSES[loss](chi_square, width)[1]
    return InlierRatio(
        float(inliers.mean()),
        float(weights.mean()),
        inliers,
        weights,
        gate,
        confidence,
        loss,
        width,
        len(inliers),
    )


def chi_square_quantile(probability, dof):
    """Return what a chi-square variable stays below with that probability."""
    from scipy.special import gammaincinv  # scipy.stats takes ten times as long to load

    return float(2 * gammaincinv(dof / 2, probability))


def chi_squares(residuals, information):
    """Return e^T W e of each residual, (M,)."""
    e = as_numbers(residuals, "residuals")
    if e.ndim != 2 or not e.size:
        raise AmrError(f"residuals has shape {e.shape}; expected (M, n), one row per edge, M >= 1.")
    roots = information_roots(as_information(information, *e.shape))
    white = np.einsum("mij,mj->mi", roots, e)
    return np.einsum("mi,mi->m", white, white)


def as_information(value, edges, dim):
    """Return symmetric positive definite matrices (edges, dim, dim) of one's own."""
    W = as_numbers(value, "information")
    if W.shape not in ((dim, dim), (edges, dim, dim)):
        raise AmrError(
            f"information has shape {W.shape}; {edges} edges of {dim} components need shape "
            f"({edges}, {dim}, {dim}) or ({dim}, {dim})."
        )
    transposed = W.swapaxes(-1, -2)
    # A symmetric matrix that is not finite has been refused; one that overflows is below.
    off = np.abs(W - transposed).max((-2, -1)) > SYMMETRIC_WITHIN * np.abs(W).max((-2, -1))
    if off.any():
        raise AmrError(
            f"information{_at(off)} is not symmetric, so it is no inverse covariance. Use "
            "(W + W.T) / 2."
        )
    W = (W + transposed) / 2
    bad = not_positive_definite(W)
    if bad.any():
        raise AmrError(
            f"information{_at(bad)} is not positive definite: some direction has no or negative "
            "information. A direction that was not measured needs a small positive value."
        )
    return np.array(np.broadcast_to(W, (edges, dim, dim)))


def not_positive_definite(W):
    """Say for each matrix if it lacks a Cholesky factor, or has one by rounding only."""
    # The unit of each component is taken out, so that only the correlation is judged.
    scale = np.sqrt(np.maximum(np.diagonal(W, axis1=-2, axis2=-1), 1e-300))
    values = np.linalg.eigvalsh(W / scale[..., :, None] / scale[..., None, :])
    return values[..., 0] <= W.shape[-1] * np.finfo(float).eps


def _at(mask):
    return f"[{int(np.argmax(mask))}]" if np.ndim(mask) else ""


def information_roots(W):
    """Return the upper triangular S with S^T S = W: S e has the identity as covariance."""
    return np.linalg.cholesky(W).swapaxes(-1, -2)


def _linear(s, k):
    return s, np.ones_like(s)


def _huber(s, k):
    x = np.sqrt(s)
    weight = k / np.maximum(x, k)
    return np.where(x <= k, s, 2 * k * x - k * k), weight


def _cauchy(s, k):
    ratio = s / (k * k)
    return k * k * np.log1p(ratio), 1 / (1 + ratio)


def _geman_mcclure(s, k):
    root = 1 / (1 + s / (k * k))
    return s * root, root * root


# From s = e^T W e and the width: the cost rho, which is s near 0, and the weight d rho / d s.
LOSSES = {
    "linear": _linear,
    "huber": _huber,
    "cauchy": _cauchy,
    "geman_mcclure": _geman_mcclure,
}


def as_loss(loss, width, dim):
    """Return the width of a known loss, nan for the linear one."""
    if loss not in LOSSES:
        known = ", ".join(map(repr, LOSSES))
        raise AmrError(f"loss is {loss!r}; expected one of {known}.")
    if loss == "linear":
        if width is not None:
            raise AmrError(f"width is {width!r}; the linear loss has none. Leave it out.")
        return float("nan")
    if width is None:
        return float(np.sqrt(chi_square_quantile(UNTOUCHED, dim)))
    return float(as_size(width, "width"))
