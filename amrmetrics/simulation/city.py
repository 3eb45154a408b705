"""A drive through a city of look-alike blocks, with proposed loop closures (lecture 07)."""

from typing import NamedTuple

import numpy as np

from amrmetrics._arguments import as_count, as_generator, as_size
from amrmetrics.errors import AmrError
from amrmetrics.pose_graph import PoseGraph, as_choice
from amrmetrics.poses import planar_poses, relative

BLOCK = 5  # poses from one crossing to the next, 1 m apart
LOOKS = 6  # kinds of blocks that cannot be told apart
GAP = 20  # poses between two visits that count as a loop
# Mean log-odds of the detector's score; the standard deviation is 1 for all.
TRUE, ALIASED, UNLIKE = 2.0, 1.0, -2.0


class CityRun(NamedTuple):
    """One drive, its odometry, and the loop closures that a detector proposes.

    Attributes
    ----------
    truth : (N, 3, 3) array
        True poses, 1 m apart; the first is the identity.
    odometry : (N-1, 3, 3) array
        Measured motion from each pose to the next, in the frame of the former.
    odometry_information : (3, 3) array
        Inverse covariance of its error in x, y, heading; 1/m^2, 1/rad^2.
    pairs : (M, 2) array of int
        Candidates: pose i and, at least 20 poses later, pose j.
    measurements : (M, 3, 3) array
        Where the detector sees pose j in the frame of pose i. For a false candidate it is
        what would be seen if both stood at the same place.
    closure_information : (3, 3) array
        Inverse covariance of the error of a true closure.
    labels : (M,) bool array
        Whether both poses are at one place.
    scores : (M,) array
        Of the detector, in (0, 1), three decimals.
    """

    truth: np.ndarray
    odometry: np.ndarray
    odometry_information: np.ndarray
    pairs: np.ndarray
    measurements: np.ndarray
    closure_information: np.ndarray
    labels: np.ndarray
    scores: np.ndarray

    def graph(self, accepted=None):
        """Return the `PoseGraph` of the odometry and of the accepted candidates.

        Parameters
        ----------
        accepted : (M,) bool array or indices, optional
            All candidates by default. Edge k < N - 1 is odometry; the candidates follow in
            their order.

        Returns
        -------
        PoseGraph
            Its poses are dead reckoning; the first is fixed.
        """
        n = len(self.odometry)
        chosen = (
            slice(None) if accepted is None else as_choice(accepted, "accepted", len(self.pairs))
        )
        pairs, Z = self.pairs[chosen], self.measurements[chosen]
        information = np.concatenate(
            [
                np.broadcast_to(self.odometry_information, (n, 3, 3)),
                np.broadcast_to(self.closure_information, (len(pairs), 3, 3)),
            ]
        )
        steps = np.column_stack([np.arange(n), np.arange(1, n + 1)])
        return PoseGraph(
            _dead_reckoning(self.odometry),
            np.concatenate([steps, pairs]),
            np.concatenate([self.odometry, Z]),
            information,
        )


def city_run(
    rng,
    poses=400,
    *,
    closures=60,
    aliased=30,
    unlike=200,
    odometry_std=(0.02, 0.02, 0.005),
    closure_std=(0.05, 0.05, 0.01),
):
    """Drive through a city whose blocks look alike, and let a detector propose closures.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of all randomness.
    poses : int
        Number of poses N, 1 m apart; the city grows with it, so that each street is
        driven about twice.
    closures : int
        Number of true candidates: pairs of visits of one place.
    aliased : int
        Number of false candidates between places that look alike, with scores that are
        nearly as high.
    unlike : int
        Number of false candidates between places that do not, with low scores.
    odometry_std, closure_std : (3,) array
        Standard deviations of the measured x, y (m) and heading (rad), > 0.

    Returns
    -------
    CityRun
        Candidates in random order. `CityRun.graph` makes the pose graph.

    Raises
    ------
    AmrError
        If an argument is out of range, or the drive has fewer pairs than asked for.

    References
    ----------
    Lecture 07. The Manhattan world of Olson, Leonard and Teller, Fast iterative alignment
    of pose graphs with poor initial estimates, ICRA 2006, with 3500 poses.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> run = am.simulation.city_run(np.random.default_rng(7))
    >>> len(run.truth), int(run.labels.sum()), len(run.scores)
    (400, 60, 290)
    >>> am.optimize(run.graph(run.labels)).converged
    True
    """
    rng, n = as_generator(rng), as_count(poses, "poses")
    wanted = [
        as_count(value, name, least=0)
        for value, name in ((closures, "closures"), (aliased, "aliased"), (unlike, "unlike"))
    ]
    odometry_std = as_size(odometry_std, "odometry_std", (3,))
    closure_std = as_size(closure_std, "closure_std", (3,))
    if n < 2:
        raise AmrError(f"poses is {poses!r}; a drive has at least 2.")
    blocks = max(2, round(np.sqrt(n / 20)))
    cells, headings = _drive(rng, n, blocks)
    truth = planar_poses(cells, headings * np.pi / 2)
    place = cells[:, 0] * (blocks * BLOCK + 1) + cells[:, 1]
    look = _looks(rng, cells, blocks)
    kinds = [
        _pairs(rng, place, np.zeros(n), wanted[0], "closures"),
        _pairs(rng, look, place, wanted[1], "aliased"),
        _pairs(rng, np.zeros(n), look, wanted[2], "unlike"),
    ]
    log_odds = np.repeat([TRUE, ALIASED, UNLIKE], wanted) + rng.normal(size=sum(wanted))
    pairs, labels = np.concatenate(kinds), np.repeat([True, False, False], wanted)
    # The detector sees one place: only the headings differ.
    i, j = pairs.T
    seen = relative(truth[i], truth[j]) if len(pairs) else np.empty((0, 3, 3))
    seen[:, :2, 2] = 0
    order = rng.permutation(len(pairs))
    return CityRun(
        truth,
        _measured(rng, relative(truth[:-1], truth[1:]), odometry_std),
        np.diag(odometry_std**-2.0),
        pairs[order],
        _measured(rng, seen, closure_std)[order],
        np.diag(closure_std**-2.0),
        labels[order],
        np.round(1 / (1 + np.exp(-log_odds[order])), 3),
    )


def _drive(rng, n, blocks):
    """Return cells (n, 2), meters, and headings (n,), quarter turns, of a random drive."""
    ahead = np.array([[1, 0], [0, 1], [-1, 0], [0, -1]])
    last = blocks * BLOCK
    cell, heading = np.zeros(2, dtype=int), 0
    cells, headings = np.empty((n, 2), dtype=int), np.empty(n, dtype=int)
    turns = rng.choice([0, 0, 1, -1], size=n)
    for k in range(n):
        if k and not (cell % BLOCK).any():
            # Straight on, left or right at a crossing, or what the edge of the city leaves.
            for turn in (turns[k], 1, -1):
                ahead_cell = cell + ahead[(heading + turn) % 4]
                if ahead_cell.min() >= 0 and ahead_cell.max() <= last:
                    heading = (heading + turn) % 4
                    break
        cells[k], headings[k] = cell, heading
        cell = cell + ahead[heading]
    return cells, headings


def _looks(rng, cells, blocks):
    """Return a number for what each pose sees: the look of its block and the place within it."""
    kind = rng.integers(LOOKS, size=(blocks + 1, blocks + 1))
    x, y = cells.T
    return (kind[x // BLOCK, y // BLOCK] * BLOCK + x % BLOCK) * BLOCK + y % BLOCK


def _pairs(rng, same, different, wanted, name):
    """Return pairs i < j of poses equal in `same` and, unless all 0, not in `different`."""
    order = np.argsort(same, kind="stable")
    ranked = same[order]
    start = np.searchsorted(ranked, same, side="left")
    count = np.searchsorted(ranked, same, side="right") - start
    found = np.empty((0, 2), dtype=int)
    for _ in range(50):
        if len(found) >= wanted:
            return found[:wanted]
        one = rng.integers(len(same), size=4 * wanted + 100)
        other = order[start[one] + rng.integers(count[one])]
        i, j = np.minimum(one, other), np.maximum(one, other)
        good = (j - i >= GAP) & ((different[i] != different[j]) | (not different.any()))
        found = np.concatenate([found, np.column_stack([i, j])[good]])
        _, first = np.unique(found, axis=0, return_index=True)
        found = found[np.sort(first)]
    raise AmrError(
        f"{name} is {wanted}; this drive of {len(same)} poses has {len(found)} such pairs. Ask for "
        "fewer, or for more poses."
    )


def _measured(rng, Z, std):
    """Return measurements with errors in x, y (in the frame of the measured pose) and heading."""
    error = std * rng.normal(size=(len(Z), 3))
    return Z @ planar_poses(error[:, :2], error[:, 2]) if len(Z) else Z


def _dead_reckoning(odometry):
    X = np.empty((len(odometry) + 1, 3, 3))
    X[0] = np.eye(3)
    for k, step in enumerate(odometry):
        X[k + 1] = X[k] @ step
    return X
