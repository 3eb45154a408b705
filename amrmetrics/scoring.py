"""Proper scores for probabilities: cross-entropy, Brier, and what the Brier score is made of.

A score is proper if reporting what one believes is best on average; lecture 05 derives which
ones are. Here lower is better, and nothing is clipped.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_numbers
from amrmetrics._cells import as_cells, as_forecasts, as_labels, known_cells
from amrmetrics._results import Number, Result
from amrmetrics.errors import AmrError

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike


@dataclass(frozen=True, eq=False)
class Score(Number):
    """The mean score of a map; converts to a number with ``float()``.

    Attributes
    ----------
    value : float
        Mean over the known cells; infinite if one cell makes it so.
    name : str
        "cross-entropy" or "Brier score".
    unit : str
        "nats", "bits", or "" for the Brier score.
    n : int
        Number of known cells.
    offending : (K, ndim) array of int
        Indices of the cells with an infinite score: told impossible, yet so.
    """

    value: float
    name: str
    unit: str
    n: int
    offending: np.ndarray

    def __float__(self):
        return self.value

    def __repr__(self):
        text = f"{self.name} {self.value:.6g} {self.unit}".rstrip() + f", n {self.n}"
        if len(self.offending):
            first = self.offending[0].tolist()
            text += f" ({len(self.offending)} cells infinite, first at {first})"
        return text


@dataclass(frozen=True, eq=False)
class Murphy(Result):
    """The parts of a Brier score: brier = reliability - resolution + uncertainty + within_bin.

    Attributes
    ----------
    reliability : float
        Mean squared distance between forecast and frequency of the bins, >= 0; 0 is best.
    resolution : float
        Variance of the bins' frequencies, >= 0; large is good.
    uncertainty : float
        Variance of the labels, in [0, 1/4]; no forecast changes it.
    within_bin : float
        What the bins hide: variance of the forecasts inside a bin minus twice their
        covariance with the labels. 0 if all forecasts of a bin are equal.
    brier : float
        Their sum, the Brier score.
    edges : (B + 1,) array
        Limits of the bins; a forecast on a limit belongs to the bin above.
    count, forecast, frequency : (B,) array
        Per bin: weight, mean forecast and frequency of occupied cells; nan if empty.
    n : int
        Number of known cells.
    """

    reliability: float
    resolution: float
    uncertainty: float
    within_bin: float
    brier: float
    edges: np.ndarray
    count: np.ndarray
    forecast: np.ndarray
    frequency: np.ndarray
    n: int

    def __repr__(self):
        return (
            f"Brier score {self.brier:.6g} = reliability {self.reliability:.6g} - resolution "
            f"{self.resolution:.6g} + uncertainty {self.uncertainty:.6g} + within-bin "
            f"{self.within_bin:.6g}, {len(self.count)} bins, n {self.n}"
        )


def cross_entropy(
    occupied: ArrayLike,
    probability: ArrayLike | None = None,
    *,
    logits: ArrayLike | None = None,
    unknown: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    unit: str = "nats",
) -> Score:
    """Mean of -log(probability that was given to what is the case).

    Parameters
    ----------
    occupied : array of 0/1 or bool
        Truth, any shape.
    probability : array, optional
        Probability of "occupied", same shape, in [0, 1].
    logits : array, optional
        Log-odds log(p / (1 - p)) instead of `probability`, any size: 1000 is no overflow.
    unknown : array of bool, optional
        Cells to leave out, whatever is said of them, nan included.
    weights : array, optional
        Weight per cell, >= 0, for example its area.
    unit : {"nats", "bits"}
        Natural logarithm, or base two.

    Returns
    -------
    Score
        `value` in [0, inf]. It is infinite if a cell was given probability 0 of what is
        the case; `offending` says which.

    Raises
    ------
    AmrError
        If a label is not 0 or 1, a probability outside [0, 1], shapes differ, nothing is
        known, or not exactly one of `probability` and `logits` is given.

    References
    ----------
    Lecture 05. Good, Rational decisions, JRSS B 14 (1952); Gneiting and Raftery, Strictly
    proper scoring rules, JASA 102 (2007), example 3.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.cross_entropy([1, 0], [0.5, 0.75], unit="bits")
    cross-entropy 1.5 bits, n 2
    >>> am.cross_entropy([[1, 1]], [[1.0, 0.0]])
    cross-entropy inf nats, n 2 (1 cells infinite, first at [0, 1])
    """
    if unit not in ("nats", "bits"):
        raise AmrError(f"unit is {unit!r}; expected 'nats' or 'bits'.")
    if (probability is None) == (logits is None):
        raise AmrError("give either probability or logits, not both and not neither.")
    if logits is None:
        y, p, w, cells = as_forecasts(occupied, probability, unknown, weights)
        with np.errstate(divide="ignore"):
            loss = -np.where(y, np.log(p), np.log1p(-p))
    else:
        labels, a = as_labels(occupied, "occupied", unknown), as_cells(logits, "logits", unknown)
        if a.shape != labels.shape:
            raise AmrError(f"occupied has shape {labels.shape} and logits {a.shape}; not equal.")
        y, a, w, cells = known_cells(labels, a, unknown, weights)
        loss = np.logaddexp(0, np.where(y, -a, a))
    infinite = np.isinf(loss) & (True if w is None else w > 0)
    offending = np.column_stack(np.unravel_index(cells[infinite], np.shape(occupied)))
    value = np.inf if infinite.any() else _mean(np.where(np.isinf(loss), 0, loss), w)
    scale = np.log(2) if unit == "bits" else 1.0
    return Score(float(value / scale), "cross-entropy", unit, len(y), offending)


def brier(
    occupied: ArrayLike,
    probability: ArrayLike,
    *,
    unknown: ArrayLike | None = None,
    weights: ArrayLike | None = None,
) -> Score:
    """Mean of (probability - label)^2.

    Parameters
    ----------
    occupied : array of 0/1 or bool
        Truth, any shape.
    probability : array
        Probability of "occupied", same shape, in [0, 1].
    unknown : array of bool, optional
        Cells to leave out, whatever is said of them, nan included.
    weights : array, optional
        Weight per cell, >= 0.

    Returns
    -------
    Score
        `value` in [0, 1].

    Raises
    ------
    AmrError
        If a label is not 0 or 1, a probability outside [0, 1], shapes differ or nothing
        is known.

    References
    ----------
    Lecture 05. Brier, Verification of forecasts expressed in terms of probability,
    Monthly Weather Review 78 (1950), eq. (2), here for one of the two classes (half of his).

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.brier([1, 0], [0.5, 0.25])
    Brier score 0.15625, n 2
    """
    y, p, w, _ = as_forecasts(occupied, probability, unknown, weights)
    none = np.empty((0, np.ndim(occupied)), dtype=int)
    return Score(float(_mean((p - y) ** 2, w)), "Brier score", "", len(y), none)


def murphy(
    occupied: ArrayLike,
    probability: ArrayLike,
    bins: ArrayLike = 10,
    *,
    unknown: ArrayLike | None = None,
    weights: ArrayLike | None = None,
) -> Murphy:
    """Split the Brier score into reliability, resolution, uncertainty and within-bin terms.

    Parameters
    ----------
    occupied : array of 0/1 or bool
        Truth, any shape.
    probability : array
        Probability of "occupied", same shape, in [0, 1].
    bins : int or (B + 1,) array
        Number of equal bins of [0, 1], or increasing limits from 0 to 1.
    unknown : array of bool, optional
        Cells to leave out, whatever is said of them, nan included.
    weights : array, optional
        Weight per cell, >= 0.

    Returns
    -------
    Murphy
        The four parts, which add up to the Brier score whatever the bins, and the
        points of the reliability diagram.

    Raises
    ------
    AmrError
        As `brier`, and if the bins are no positive number or no increasing limits from
        0 to 1.

    References
    ----------
    Lecture 05. Murphy, A new vector partition of the probability score, J. Applied
    Meteorology 12 (1973), eq. (7); within-bin terms: Stephenson, Coelho and Jolliffe,
    Weather and Forecasting 23 (2008), eq. (8).

    Examples
    --------
    >>> import amrmetrics as am
    >>> parts = am.murphy([1, 0, 1, 1], [0.2, 0.2, 0.9, 0.9])
    >>> round(parts.reliability, 9), round(parts.resolution, 9), parts.uncertainty
    (0.05, 0.0625, 0.1875)
    """
    edges = _edges(bins)
    y, p, w, _ = as_forecasts(occupied, probability, unknown, weights)
    w = np.ones(len(p)) if w is None else w
    k = np.clip(np.searchsorted(edges, p, side="right") - 1, 0, len(edges) - 2)

    def total(values):
        return np.bincount(k, w * values, minlength=len(edges) - 1)

    count = total(np.ones(len(p)))
    with np.errstate(invalid="ignore"):
        forecast, frequency = total(p) / count, total(y) / count
    rate = np.average(y, weights=w)
    used = count > 0
    reliability = np.average((forecast - frequency)[used] ** 2, weights=count[used])
    resolution = np.average((frequency[used] - rate) ** 2, weights=count[used])
    f, o = p - forecast[k], y - frequency[k]
    within = _mean(f * f - 2 * f * o, w)
    uncertainty = rate * (1 - rate)
    return Murphy(
        reliability=float(reliability),
        resolution=float(resolution),
        uncertainty=float(uncertainty),
        within_bin=float(within),
        brier=float(_mean((p - y) ** 2, w)),
        edges=edges,
        count=count,
        forecast=forecast,
        frequency=frequency,
        n=len(p),
    )


def _edges(bins):
    array = as_numbers(bins, "bins")
    if array.ndim == 0:
        if array < 1 or array != np.round(array):
            raise AmrError(f"bins is {bins!r}; expected a whole number of at least 1, or limits.")
        return np.linspace(0, 1, int(array) + 1)
    if array.ndim != 1 or len(array) < 2 or array[0] != 0 or array[-1] != 1:
        raise AmrError("bins must be limits from 0 to 1, such as [0, 0.1, 0.5, 1].")
    if (np.diff(array) <= 0).any():
        raise AmrError("bins must increase from one limit to the next.")
    return array


def _mean(values, weights):
    return values.mean() if weights is None else np.average(values, weights=weights)
