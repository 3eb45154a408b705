"""Read the cells of a map for scoring and maps: labels, probabilities, unknown cells, weights."""

import numpy as np

from amrmetrics._arguments import (
    as_array,
    as_binary,
    as_numbers,
    as_reals,
    first_index,
    refuse_not_finite,
    with_samples,
)
from amrmetrics.errors import AmrError


def as_forecasts(occupied, probability, unknown=None, weights=None):
    """Return labels (bool), probabilities and weights (or None) of the known cells, flat.

    The last item is the array of flat indices of those cells in the map.
    """
    labels = as_labels(occupied, "occupied", unknown)
    p = as_cells(probability, "probability", unknown)
    if p.shape != labels.shape:
        raise AmrError(
            f"occupied has shape {labels.shape} and probability {p.shape}; they must be equal, "
            "cell by cell."
        )
    outside = (p < 0) | (p > 1)
    if outside.any():
        raise AmrError(
            f"probability{first_index(outside)} is {p[outside][0]:.6g}; probabilities lie in "
            "[0, 1]. Log-odds are passed as logits to cross_entropy."
        )
    return known_cells(labels, p, unknown, weights)


def as_cells(value, name, unknown):
    """Return finite doubles, one per cell; what stands in unknown cells, often nan, becomes 0."""
    array = as_reals(value, name)
    if unknown is not None and np.shape(unknown) == array.shape:
        array = np.where(as_labels(unknown, "unknown"), 0.0, array)
    refuse_not_finite(array, name)
    return array


def as_labels(value, name, unknown=None):
    """Return labels of cells as an array of booleans, at least one.

    What stands in unknown cells, such as ROS's -1, becomes False.
    """
    meaning = "0 (free) or 1 (occupied). Mark unknown cells by `unknown`"
    array = as_array(value, name)
    if unknown is not None and np.shape(unknown) == array.shape:
        array = np.where(as_labels(unknown, "unknown"), False, array)
    return with_samples(as_binary(array, name, meaning), name)


def known_cells(labels, p, unknown, weights):
    if weights is not None:
        weights = as_numbers(weights, "weights")
        if weights.shape != labels.shape or weights.min() < 0:
            raise AmrError(
                f"weights have shape {weights.shape} and minimum {weights.min():g}; expected "
                f"shape {labels.shape} and no negative weight."
            )
    cells = np.arange(labels.size)
    if unknown is not None:
        unknown = as_labels(unknown, "unknown")
        if unknown.shape != labels.shape:
            raise AmrError(f"unknown has shape {unknown.shape}; expected {labels.shape}.")
        cells = np.flatnonzero(~unknown)
        if not len(cells):
            raise AmrError("every cell is unknown; a score needs at least one known cell.")
    weights = None if weights is None else weights.ravel()[cells]
    if weights is not None and weights.sum() == 0:
        raise AmrError("the weights of the known cells are all 0; nothing is left to average.")
    return labels.ravel()[cells], p.ravel()[cells], weights, cells
