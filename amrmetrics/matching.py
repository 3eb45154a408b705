"""Two recordings of one run made into pairs, and how much of each run they cover."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from amrmetrics._arguments import as_numbers
from amrmetrics._results import Result
from amrmetrics.errors import AmrError
from amrmetrics.recording import Trajectory
from amrmetrics.stamps import as_gap, associate, between_samples, in_gap


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Coverage(Result):
    """How much of two recordings was matched.

    Attributes
    ----------
    matched : int
        Number of pairs.
    reference, estimate : int
        Number of poses given on either side.
    duration : float
        Seconds from the first to the last pair; nan without stamps.
    reference_duration : float
        Seconds that the reference lasts.
    longest_gap : float
        Seconds between the two neighboring pairs that lie farthest apart.
    left_out : int
        Estimates in gaps or outside of an interpolated reference.
    """

    matched: int
    reference: int
    estimate: int
    duration: float
    reference_duration: float
    longest_gap: float
    left_out: int

    @property
    def share(self):
        """Part of the reference's duration, or of its poses without stamps, that is covered."""
        if self.reference_duration > 0:
            return self.duration / self.reference_duration
        return self.matched / self.reference

    def __repr__(self):
        text = (
            f"matched {self.matched} of {self.reference} reference and of {self.estimate} "
            "estimated poses"
        )
        if self.duration == self.duration:
            text += (
                f", {self.duration:.6g} of {self.reference_duration:.6g} s "
                f"({100 * self.share:.0f} %), longest gap {self.longest_gap:.3g} s"
            )
        return text + (f", {self.left_out} left out" if self.left_out else "")


@dataclass(frozen=True, eq=False, repr=False)
class Match:
    """A matched pair; ``reference, estimate = match`` takes it apart.

    Attributes
    ----------
    reference, estimate : Trajectory
        Sample k of one belongs to sample k of the other. Every metric of them says how much of
        the run it covers.
    coverage : Coverage
        How much of each was matched.
    offset : float
        Seconds that were added to the estimate's stamps.
    how : str
        "nearest stamps", "interpolated reference", "frame numbers" or "order in the files".
    """

    reference: Trajectory
    estimate: Trajectory
    coverage: Coverage
    offset: float
    how: str

    def __iter__(self):
        return iter((self.reference, self.estimate))

    def __len__(self):
        return len(self.reference)

    def __getitem__(self, index):
        return replace(self, reference=self.reference[index], estimate=self.estimate[index])

    def __repr__(self):
        offset = f", offset {self.offset:.6g} s" if self.offset else ""
        by = "" if self.how == "nearest stamps" else f", by {self.how}"
        return f"{self.coverage!r}{by}{offset}"


def match(
    reference: Trajectory,
    estimate: Trajectory,
    max_difference: float = 0.01,
    offset: float = 0.0,
    interpolate: bool = False,
    max_gap: float | None = None,
) -> Match:
    """Match an estimate with its reference, so that sample k of one belongs to sample k of both.

    Parameters
    ----------
    reference, estimate : Trajectory
        By their stamps; without stamps by frame numbers, or in order if they are as many.
    max_difference : float
        Largest difference of two matched stamps in seconds, as in `associate`.
    offset : float
        Seconds, added to the estimate's stamps first.
    interpolate : bool
        Interpolate the reference at the estimate's stamps, instead of taking its nearest pose;
        for a reference that is recorded much faster. `max_difference` is then not used.
    max_gap : float, optional
        Longest gap of the reference in seconds that is interpolated, as in `interpolate`.

    Returns
    -------
    Match
        The pair and its coverage, which every metric of the two carries and prints.

    Raises
    ------
    AmrError
        If nothing matches, or there is nothing to match by.

    References
    ----------
    Lecture 03.

    Examples
    --------
    A robot that gave up after 2 of 10 seconds looks good on what is left.

    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 10.05, 0.1)
    >>> truth = am.Trajectory(t, np.c_[t, t**2])
    >>> lost = am.Trajectory(t[:21], np.c_[t, t**2][:21] + 0.01)
    >>> am.match(truth, lost)
    matched 21 of 101 reference and of 21 estimated poses, 2 of 10 s (20 %), longest gap 0.1 s
    """
    for name, given in (("reference", reference), ("estimate", estimate)):
        if not isinstance(given, Trajectory):
            raise AmrError(
                f"{name} is of type {type(given).__name__}; expected a Trajectory, as the readers "
                "return it: am.Trajectory(stamps, poses). associate matches plain stamps."
            )
    offset = float(as_numbers(offset, "offset"))
    if reference.stamps is None or estimate.stamps is None:
        return _by_number(reference, estimate)
    if interpolate:
        return _interpolated(reference, estimate, offset, max_gap)
    i, j = associate(reference.stamps, estimate.stamps, max_difference, offset)
    return _matched(reference, estimate, i, j, offset, "nearest stamps")


def _by_number(reference, estimate):
    if reference.frames is not None and estimate.frames is not None:
        _, i, j = np.intersect1d(reference.frames, estimate.frames, return_indices=True)
        if not len(i):
            raise AmrError("no frame number of the estimate is one of the reference.")
        return _matched(reference, estimate, i, j, 0.0, "frame numbers")
    if len(reference) != len(estimate):
        n, m = len(reference), len(estimate)
        raise AmrError(
            f"the reference has {n} poses and the estimate {m}, and not both have stamps to match "
            f"them by. If one stopped early, cut the longer one: trajectory[:{min(n, m)}]. If "
            "frames were left out, write their numbers before the poses and give the sequence's "
            "times.txt for both: read_kitti(path, times=...)."
        )
    every = np.arange(len(reference))
    return _matched(reference, estimate, every, every, 0.0, "order in the files")


def _interpolated(reference, estimate, offset, max_gap):
    t, u = reference.stamps, estimate.stamps + offset
    limit = as_gap(max_gap, t)
    inside = (u >= t[0]) & (u <= t[-1])
    kept = inside & ~in_gap(t, u, limit)
    if not kept.any():
        why = (
            f"the reference has gaps of more than max_gap={limit:g} s wherever the estimate is"
            if inside.any()
            else f"the reference runs from {t[0]:.6f} to {t[-1]:.6f} s, the estimate with "
            f"offset={offset:g} from {u[0]:.6f} to {u[-1]:.6f} s"
        )
        raise AmrError(f"no estimate can be matched: {why}.")
    poses = between_samples(t, reference.poses, u[kept])
    between = replace(reference, stamps=u[kept], poses=poses, frames=None)
    j = np.flatnonzero(kept)
    left_out = len(u) - len(j)
    how = "interpolated reference"
    return _matched(between, estimate, np.arange(len(j)), j, offset, how, reference, left_out)


def _matched(reference, estimate, i, j, offset, how, given=None, left_out=0):
    given = reference if given is None else given
    p, q = reference[i], estimate[j]
    stamps = p.stamps if p.stamps is not None else q.stamps
    nothing = float("nan")
    coverage = Coverage(
        matched=len(i),
        reference=len(given),
        estimate=len(estimate),
        duration=nothing if stamps is None else float(stamps[-1] - stamps[0]),
        reference_duration=given.duration,
        longest_gap=nothing if stamps is None else float(np.diff(stamps).max(initial=0.0)),
        left_out=left_out,
    )
    p, q = (replace(x, coverage=coverage) for x in (p, q))
    return Match(p, q, coverage, offset, how)
