"""Where an estimate jumped and for how long it was lost (lecture 03).

Both are counted by rules that stand here, since no rule is given by nature: an ATE hides a jump
among thousands of samples, and cannot know of the time in which there was no estimate.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from amrmetrics._results import Number
from amrmetrics.pairs import pair_errors
from amrmetrics.stamps import as_gap

# A step is a jump if its error is farther above the median than this many robust standard
# deviations, and more than this many meters: what is below is noise of a good estimate.
DEVIATIONS = 10
FLOOR = 0.05
# Standard deviations per median absolute deviation, of a normal distribution.
NORMAL = 1.4826


@dataclass(frozen=True, eq=False, repr=False)
class Jumps(Number):
    """Steps whose motion is off by far more than that of the others; ``float()`` counts them.

    The error of a step is the translation of the RPE over one frame; for positions alone, by how
    much the error of the aligned position changes. A step across a gap is none: that is lost time.

    Attributes
    ----------
    count : int
        Steps with an error above the threshold.
    steps : int
        Steps that were looked at.
    threshold : float
        Meters: the median of the errors and ten robust standard deviations (1.4826 times
        the median absolute deviation each), but at least 0.05.
    largest : float
        Error of the worst step, meters, whether it is a jump or not.
    index : int
        Matched sample at which the worst step ends.
    time : float
        When that is, on the reference's clock; nan without stamps.
    """

    count: int
    steps: int
    threshold: float
    largest: float
    index: int
    time: float

    def __float__(self):
        return float(self.count)

    def __repr__(self):
        when = f"at {self.time:.6f} s" if self.time == self.time else f"at sample {self.index}"
        return (
            f"{self.count} of {self.steps} steps off by more than {self.threshold:.3g} m, the "
            f"worst by {self.largest:.3g} m {when}"
        )


@dataclass(frozen=True, eq=False, repr=False)
class LostTime(Number):
    """Time of the reference without a matched estimate; ``float()`` gives the seconds.

    A stretch between two neighboring matches counts if it is longer than a gap may be: ten times
    the usual one and at least 1 s, or `max_gap`. So do the beginning and the end of the reference.

    Attributes
    ----------
    seconds : float
        All such stretches together.
    stretches : int
        How many.
    longest : float
        Seconds of the longest.
    start : float
        When that begins, on the reference's clock; nan if there is none.
    limit : float
        Seconds that a stretch may last before it counts.
    """

    seconds: float
    stretches: int
    longest: float
    start: float
    limit: float

    def __float__(self):
        return self.seconds

    def __repr__(self):
        if not self.stretches:
            return f"no stretch of more than {self.limit:.3g} s without a matched estimate"
        many = "1 stretch" if self.stretches == 1 else f"{self.stretches} stretches"
        return (
            f"{self.seconds:.6g} s without a matched estimate, in {many} of more than "
            f"{self.limit:.3g} s, the longest {self.longest:.6g} s from {self.start:.6f} s"
        )


def jumps(reference, estimate, aligned, max_gap=None):
    """Return the Jumps of a matched pair of recordings, None if there is no step.

    `aligned` is the Alignment that positions alone are compared after.
    """
    p, q = reference.poses, estimate.poses
    start = np.arange(len(p) - 1)
    if reference.stamps is not None:
        steps = np.diff(reference.stamps)
        start = start[steps <= as_gap(max_gap, reference.stamps)]
    if not len(start):
        return None
    if p.ndim == q.ndim == 3:
        errors, _ = pair_errors(p, q, start, start + 1)
    else:
        off = aligned.apply(estimate.positions) - reference.positions
        errors = np.linalg.norm(off[start + 1] - off[start], axis=1)
    middle = np.median(errors)
    deviation = NORMAL * np.median(np.abs(errors - middle))
    threshold = max(FLOOR, float(middle + DEVIATIONS * deviation))
    worst = int(errors.argmax())
    index = int(start[worst]) + 1
    time = float("nan") if reference.stamps is None else float(reference.stamps[index])
    count = int((errors > threshold).sum())
    return Jumps(count, len(errors), threshold, float(errors[worst]), index, time)


def lost_time(given, matched, max_gap=None):
    """Return the LostTime of a reference of which these samples matched, None without stamps."""
    if given.stamps is None:
        return None
    limit = as_gap(max_gap, matched.stamps)
    edges = np.concatenate([given.stamps[:1], matched.stamps, given.stamps[-1:]])
    stretches = np.diff(edges)
    lost = stretches > limit
    longest = int(np.where(lost, stretches, 0).argmax())
    if not lost.any():
        return LostTime(0.0, 0, 0.0, float("nan"), limit)
    return LostTime(
        seconds=float(stretches[lost].sum()),
        stretches=int(lost.sum()),
        longest=float(stretches[longest]),
        start=float(edges[longest]),
        limit=limit,
    )
