"""How good a map is: thresholded occupancy grids, and distances between point maps (lecture 06).

A rate with nothing to count is nan, with the reason in the result; it is never made up.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_numbers, as_rows
from amrmetrics._cells import as_forecasts
from amrmetrics._results import Number, Result
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike


class _Rates(Result):
    """Rates of the counts tp, fp, fn and tn: numbers, or arrays over thresholds."""

    @property
    def precision(self):
        """Part of the cells called occupied that are."""
        return _ratio(self.tp, self.tp + self.fp)

    @property
    def recall(self):
        """Part of the occupied cells that are called so."""
        return _ratio(self.tp, self.tp + self.fn)

    @property
    def f1(self):
        """Harmonic mean of precision and recall: 2 tp / (2 tp + fp + fn)."""
        return _ratio(2 * self.tp, 2 * self.tp + self.fp + self.fn)

    @property
    def iou(self):
        """Intersection over union: tp / (tp + fp + fn)."""
        return _ratio(self.tp, self.tp + self.fp + self.fn)

    @property
    def false_positive_rate(self):
        """Part of the free cells that are called occupied."""
        return _ratio(self.fp, self.fp + self.tn)

    @property
    def accuracy(self):
        """Part of all cells that are called right."""
        return _ratio(self.tp + self.tn, self.tp + self.fp + self.fn + self.tn)


@dataclass(frozen=True)
class Confusion(_Rates):
    """Counts and rates of a map cut at a threshold.

    Attributes
    ----------
    tp, fp, fn, tn : int
        Cells called occupied rightly and wrongly, called free wrongly and rightly.
    threshold : float
        A cell is called occupied if its probability is at least this.
    precision, recall, f1, iou, false_positive_rate, accuracy : float
        Rates in [0, 1], nan where undefined.
    """

    tp: int
    fp: int
    fn: int
    tn: int
    threshold: float

    @property
    def n(self):
        """Number of known cells."""
        return self.tp + self.fp + self.fn + self.tn

    @property
    def undefined(self):
        """Why a rate is nan, by its name; empty if none is."""
        no_positive = "no cell is called occupied"
        no_occupied = "no cell is occupied"
        reasons = {
            "precision": (self.tp + self.fp, no_positive),
            "recall": (self.tp + self.fn, no_occupied),
            "f1": (self.tp + self.fp + self.fn, f"{no_occupied} and {no_positive}"),
            "iou": (self.tp + self.fp + self.fn, f"{no_occupied} and {no_positive}"),
            "false_positive_rate": (self.fp + self.tn, "no cell is free"),
        }
        return {name: why for name, (count, why) in reasons.items() if count == 0}

    def __repr__(self):
        names = ("precision", "recall", "f1", "iou", "false_positive_rate", "accuracy")
        rates = ", ".join(f"{name} {getattr(self, name):.6g}" for name in names)
        reasons = "".join(f"; {name} undefined: {why}" for name, why in self.undefined.items())
        return (
            f"threshold {self.threshold:g}: tp {self.tp}, fp {self.fp}, fn {self.fn}, "
            f"tn {self.tn}, {rates}{reasons}"
        )


@dataclass(frozen=True, eq=False, repr=False)
class ThresholdSweep(_Rates):
    """All cuts that a map allows, from the highest threshold to the lowest.

    Attributes
    ----------
    thresholds : (K,) array
        inf (nothing is called occupied), then each probability that occurs, decreasing.
    tp, fp, fn, tn : (K,) array of int
        Counts at each threshold.
    precision, recall, f1, iou, false_positive_rate, accuracy : (K,) array
        Rates at each threshold, nan where undefined.
    """

    thresholds: np.ndarray
    tp: np.ndarray
    fp: np.ndarray
    fn: np.ndarray
    tn: np.ndarray

    def __repr__(self):
        k = int(np.nanargmax(self.iou)) if np.isfinite(self.iou).any() else 0
        return (
            f"{len(self.thresholds)} thresholds, best IoU {self.iou[k]:.6g} and F1 {self.f1[k]:.6g}"
            f" at {self.thresholds[k]:.6g}, n {self.fn[0] + self.tn[0]}"
        )


@dataclass(frozen=True, eq=False)
class MapDistance(Number):
    """A distance between two point sets, meters; converts to a number with ``float()``.

    Attributes
    ----------
    value : float
        The distance.
    forward, backward : float
        The directed parts: from P to Q and from Q to P.
    worst : (int, int)
        Indices in P and Q of the largest nearest-neighbor distance.
    worst_distance : float
        That distance, meters.
    name : str
        "Chamfer" or "Hausdorff".
    n : (int, int)
        Number of points of P and Q.
    """

    value: float
    forward: float
    backward: float
    worst: tuple
    worst_distance: float
    name: str
    n: tuple

    def __float__(self):
        return self.value

    def __repr__(self):
        return (
            f"{self.name} distance {self.value:.6g} m (P to Q {self.forward:.6g}, Q to P "
            f"{self.backward:.6g}), worst pair P[{self.worst[0]}], Q[{self.worst[1]}] "
            f"{self.worst_distance:.6g} m apart, n {self.n[0]} and {self.n[1]}"
        )


def confusion(
    occupied: ArrayLike,
    probability: ArrayLike,
    threshold: float = 0.5,
    *,
    unknown: ArrayLike | None = None,
) -> Confusion:
    """Cut a map at a threshold and count.

    Parameters
    ----------
    occupied : array of 0/1 or bool
        Truth, any shape.
    probability : array
        Probability of "occupied", same shape, in [0, 1].
    threshold : float
        A cell is called occupied if its probability is at least this; in [0, 1].
    unknown : array of bool, optional
        Cells to leave out, whatever is said of them, nan included.

    Returns
    -------
    Confusion
        Counts, and rates in [0, 1] or nan; `undefined` says why.

    Raises
    ------
    AmrError
        If a label is not 0 or 1, a probability or the threshold outside [0, 1], or
        shapes differ.

    References
    ----------
    Lecture 06. Van Rijsbergen, Information Retrieval (1979), chapter 7; Jaccard (1912).

    Examples
    --------
    >>> import amrmetrics as am
    >>> c = am.confusion([1, 1, 0, 0], [0.9, 0.2, 0.6, 0.1])
    >>> c.tp, c.fp, c.fn, c.tn, round(c.iou, 4)
    (1, 1, 1, 1, 0.3333)
    >>> am.confusion([1, 0], [0.2, 0.1]).undefined
    {'precision': 'no cell is called occupied'}
    """
    level = as_numbers(threshold, "threshold")
    if level.ndim or not 0 <= level <= 1:
        raise AmrError(f"threshold is {threshold!r}; expected one number in [0, 1].")
    y, p, _, _ = as_forecasts(occupied, probability, unknown)
    called = p >= level
    tp, positives, truths = int((y & called).sum()), int(called.sum()), int(y.sum())
    fp, fn = positives - tp, truths - tp
    return Confusion(tp, fp, fn, len(y) - tp - fp - fn, float(level))


def threshold_sweep(
    occupied: ArrayLike, probability: ArrayLike, *, unknown: ArrayLike | None = None
) -> ThresholdSweep:
    """Count at every threshold that makes a difference.

    Parameters
    ----------
    occupied : array of 0/1 or bool
        Truth, any shape.
    probability : array
        Probability of "occupied", same shape, in [0, 1].
    unknown : array of bool, optional
        Cells to leave out, whatever is said of them, nan included.

    Returns
    -------
    ThresholdSweep
        Arrays over the thresholds. Time n log n for n cells.

    Raises
    ------
    AmrError
        If a label is not 0 or 1, a probability outside [0, 1], or shapes differ.

    References
    ----------
    Lecture 06. Fawcett, An introduction to ROC analysis (2006), algorithm 1.

    Examples
    --------
    >>> import amrmetrics as am
    >>> sweep = am.threshold_sweep([1, 1, 0, 0], [0.9, 0.2, 0.6, 0.1])
    >>> sweep.thresholds.tolist(), sweep.tp.tolist(), sweep.fp.tolist()
    ([inf, 0.9, 0.6, 0.2, 0.1], [0, 1, 1, 2, 2], [0, 0, 1, 1, 2])
    """
    y, p, _, _ = as_forecasts(occupied, probability, unknown)
    order = np.argsort(p)[::-1]
    p, y = p[order], y[order]
    last = np.flatnonzero(np.diff(p, append=-1))  # cells of equal probability fall together
    tp = np.concatenate([[0], y.cumsum()[last]])
    fp = np.concatenate([[0], last + 1]) - tp
    thresholds = np.concatenate([[np.inf], p[last]])
    return ThresholdSweep(thresholds, tp, fp, tp[-1] - tp, fp[-1] - fp)


def chamfer(P: ArrayLike, Q: ArrayLike) -> MapDistance:
    """Chamfer distance: mean nearest-neighbor distance from P to Q plus that from Q to P.

    Parameters
    ----------
    P, Q : (N, d), (M, d) array
        Points in meters in one frame, d = 2 or 3.

    Returns
    -------
    MapDistance
        Not squared, and a sum of the two directions, not their mean; `forward` and
        `backward` give each, `worst` the pair farthest apart.

    Raises
    ------
    AmrError
        If a set is empty, has NaN, or the dimensions differ.

    References
    ----------
    Lecture 06. Barrow et al., Parametric correspondence and chamfer matching, IJCAI 1977.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.chamfer([[0, 0], [1, 0]], [[0, 1]]).value.__round__(6)
    2.207107
    """
    forward, backward, worst, n = _nearest_both_ways(P, Q)
    mean = float(forward.mean()), float(backward.mean())
    return MapDistance(sum(mean), *mean, *worst, "Chamfer", n)


def hausdorff(P: ArrayLike, Q: ArrayLike) -> MapDistance:
    """Hausdorff distance: the largest nearest-neighbor distance, from either set.

    Parameters
    ----------
    P, Q : (N, d), (M, d) array
        Points in meters in one frame, d = 2 or 3.

    Returns
    -------
    MapDistance
        One outlier decides it; `worst` names the pair.

    Raises
    ------
    AmrError
        If a set is empty, has NaN, or the dimensions differ.

    References
    ----------
    Lecture 06. Huttenlocher, Klanderman and Rucklidge, Comparing images using the
    Hausdorff distance, IEEE TPAMI 15 (1993), eqs. (1)-(2).

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.hausdorff([[0, 0], [1, 0]], [[0, 0], [4, 0]])
    Hausdorff distance 3 m (P to Q 1, Q to P 3), worst pair P[1], Q[1] 3 m apart, n 2 and 2
    """
    forward, backward, worst, n = _nearest_both_ways(P, Q)
    largest = float(forward.max()), float(backward.max())
    return MapDistance(max(largest), *largest, *worst, "Hausdorff", n)


def _nearest_both_ways(P, Q):
    from scipy.spatial import cKDTree

    P, Q = as_rows(P, "P", (2, 3), "points"), as_rows(Q, "Q", (2, 3), "points")
    if P.shape[1] != Q.shape[1]:
        raise AmrError(f"P is {P.shape[1]}-D and Q is {Q.shape[1]}-D; both maps need one space.")
    forward, to_q = cKDTree(Q).query(P)
    backward, to_p = cKDTree(P).query(Q)
    i, j = int(forward.argmax()), int(backward.argmax())
    if forward[i] >= backward[j]:
        worst = (i, int(to_q[i])), float(forward[i])
    else:
        worst = (int(to_p[j]), j), float(backward[j])
    return forward, backward, worst, (len(P), len(Q))


def _ratio(part, whole):
    if np.ndim(whole):
        return np.divide(part, whole, out=np.full(len(whole), np.nan), where=whole > 0)
    return part / whole if whole else float("nan")
