"""How far off a trajectory is: ATE, RPE, drift. Lecture 03 derives what each one sees.

Every result says how it was aligned, in which unit it is, over how many samples, and how much
of the run those cover.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import (
    as_numbers,
    as_pose_pair,
    as_poses,
    as_position_pair,
    as_reals,
)
from amrmetrics._results import Number, Result
from amrmetrics.alignment import Alignment, first_poses, fit
from amrmetrics.errors import AmrError
from amrmetrics.pairs import as_unit, find_pairs, orientation_errors, pair_errors, travelled
from amrmetrics.poses import path_length
from amrmetrics.recording import coverage_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from amrmetrics._types import ArrayLike

KITTI_LENGTHS = (100, 200, 300, 400, 500, 600, 700, 800)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class ErrorSummary(Number):
    """One error per sample, and the numbers that papers print; ``float()`` gives the rmse.

    Attributes
    ----------
    metric : str
        "ATE" or "RPE".
    quantity : str
        "translation" or "rotation".
    unit : str
        "m" or "rad", of all errors.
    series : (n,) array
        The error of each sample or pair, not negative.
    alignment : Alignment or None
        The transformation applied first; None where the metric needs none, or has several.
    delta : float or None
        Of an RPE: what its pairs span.
    delta_unit, pairs : str or None
        Of an RPE: the unit of `delta`, and which pairs were taken.
    coverage : Coverage or None
        How much of the run was matched, if `match` did it.
    run_rmse : tuple of float
        Of pooled runs: the rmse of each.
    run_alignment : str or None
        Of pooled runs: the mode in which each was aligned.
    compared : object
        What was compared; `rotation` and `notes` are computed from it when they are first read.
    """

    metric: str
    quantity: str
    unit: str
    series: np.ndarray
    alignment: Alignment | None = None
    delta: float | None = None
    delta_unit: str | None = None
    pairs: str | None = None
    coverage: object = None
    run_rmse: tuple = ()
    run_alignment: str | None = None
    compared: object = field(default=None, repr=False)

    def __post_init__(self):
        self.series.flags.writeable = False

    @property
    def n(self):
        """Number of samples."""
        return len(self.series)

    @property
    def rmse(self):
        """Root of the mean square: large errors weigh most."""
        return _root_mean_square(self.series)

    @property
    def mean(self):
        """Mean."""
        return float(self.series.mean())

    @property
    def median(self):
        """Median: half of the samples are better."""
        return float(np.median(self.series))

    @property
    def std(self):
        """Standard deviation about the mean, with divisor n: rmse**2 = mean**2 + std**2."""
        return _root_mean_square(self.series - self.series.mean())

    @property
    def min(self):
        """Smallest error."""
        return float(self.series.min())

    @property
    def max(self):
        """Largest error."""
        return float(self.series.max())

    @property
    def p95(self):
        """95th percentile, linearly interpolated between the order statistics."""
        return float(np.percentile(self.series, 95))

    @cached_property
    def rotation(self):
        """For the ATE of poses: the angles between the orientations after alignment, or None."""
        if self.compared is None or self.quantity == "rotation":
            return None
        return self.compared.rotation(self)

    @cached_property
    def notes(self):
        """Likely causes of a large ATE, each of them tested; a tuple of sentences."""
        if not isinstance(self.compared, Compared):
            return ()
        from amrmetrics.causes import likely_causes

        return likely_causes(self)

    def __float__(self):
        return self.rmse

    def as_dict(self):
        """Return the numbers, without the series, ready for JSON."""
        rows = super().as_dict()
        del rows["series"]
        numbers = {name: getattr(self, name) for name in (*NUMBERS, "n")}
        rotation = self.rotation and self.rotation.as_dict()
        return rows | numbers | {"rotation": rotation, "notes": list(self.notes)}

    def __repr__(self):
        return f"{self._title()}: {', '.join(f'{name} {text}' for name, text in self._rows())}"

    def _title(self):
        title = f"{self.metric} {self.quantity}"
        if self.metric == "ATE" and self.quantity == "translation":
            title = "ATE"
        if self.delta is not None:
            title += f", delta {self.delta:g} {self.delta_unit}, {self.pairs} pairs"
        if self.run_rmse:
            mean = np.mean(self.run_rmse)
            title += f", {len(self.run_rmse)} runs pooled (mean of the runs' rmse {mean:.6g})"
        return title

    def _rows(self):
        rows = [(name, self._with_unit(getattr(self, name))) for name in NUMBERS]
        rows += [("n", f"{self.n}"), ("alignment", self._aligned())]
        if self.coverage is not None:
            rows.append(("coverage", repr(self.coverage)))
        return rows + [("note", note) for note in self.notes]

    def _aligned(self):
        if self.run_alignment:
            return f"{self.run_alignment} of each run"
        if self.alignment is None:
            return "not needed"
        if self.alignment.mode != "similarity":
            return self.alignment.mode
        return f"similarity, scale {self.alignment.scale:.6g}"

    def _with_unit(self, x):
        degrees = f" ({np.degrees(x):.6g} deg)" if self.unit == "rad" else ""
        return f"{x:.6g} {self.unit}{degrees}"


# Poses that are remembered, to notice that somebody changed them.
SAMPLED = 64
NUMBERS = ("rmse", "mean", "median", "std", "min", "max", "p95")


def _covered(coverage):
    return "" if coverage is None else f", {coverage!r}"


def _root_mean_square(series):
    """Return the root of the mean square, also of numbers whose squares are no doubles."""
    largest = float(np.abs(series).max())
    if largest == 0 or 1e-100 < largest < 1e100:
        return float(np.sqrt(np.einsum("n,n->", series, series) / len(series)))
    return largest * _root_mean_square(series / largest)


class Compared:
    """Two trajectories of which an ATE was taken, for what is only computed when it is read.

    They are not copied; a sample of them tells whether they are still the same. `body` is the
    frame of the body that the estimate was moved to before.
    """

    def __init__(self, reference, estimate, stamps, body=None):
        self._pair, self.stamps, self.body = (reference, estimate), stamps, body
        self._sample = self._sampled()

    def _sampled(self):
        return [x[:: max(1, len(x) // SAMPLED)].copy() for x in self._pair]

    @property
    def pair(self):
        """Reference and estimate."""
        if not all(map(np.array_equal, self._sample, self._sampled())):
            raise AmrError(
                "the trajectories were changed in place after ate was called. Read rotation and "
                "notes before, or change a copy."
            )
        return self._pair

    @property
    def are_poses(self):
        return all(x.ndim == 3 for x in self._pair)

    def rotation(self, summary):
        if not self.are_poses:
            return None
        series = orientation_errors(*self.pair, summary.alignment.rotation)
        return ErrorSummary(
            metric="ATE",
            quantity="rotation",
            unit="rad",
            series=series,
            alignment=summary.alignment,
            coverage=summary.coverage,
        )


@dataclass(frozen=True, eq=False, repr=False)
class RelativeError(Result):
    """The RPE: translation and rotation over the same pairs.

    Attributes
    ----------
    translation, rotation : ErrorSummary
        In meters and in radians.
    pairs : (M, 2) array of int
        First and last sample of each pair.
    lengths : (M,) array
        What each pair really spans on the reference, in the unit of delta.
    left_out : int
        Pairs that missed delta by more than 10 % and were not used.
    """

    translation: ErrorSummary
    rotation: ErrorSummary
    pairs: np.ndarray
    lengths: np.ndarray
    left_out: int = 0

    @property
    def coverage(self):
        """How much of the run was matched, if `match` did it."""
        return self.translation.coverage

    def __repr__(self):
        return f"{self._title()}: {', '.join(f'{name} {text}' for name, text in self._rows())}"

    def _repr_html_(self):
        return "".join(x._repr_html_() for x in self._both()) + f"<p>pairs span {self._span()}</p>"

    def _both(self):
        return self.translation, self.rotation

    def _title(self):
        return self.translation._title().replace(" translation", "")

    def _rows(self):
        rows = [(f"{x.quantity} rmse", x._with_unit(x.rmse)) for x in self._both()]
        rows += [("n", f"{self.translation.n}"), ("pairs span", self._span())]
        return rows + ([("coverage", repr(self.coverage))] if self.coverage else [])

    def _span(self):
        span = f"{self.lengths.min():.6g} to {self.lengths.max():.6g}"
        return f"{span}, {self.left_out} left out, no alignment needed"

    def as_dict(self):
        """Return the numbers of both, without the pairs, ready for JSON."""
        spans = {"shortest": float(self.lengths.min()), "longest": float(self.lengths.max())}
        both = {x.quantity: x.as_dict() for x in self._both()}
        return {"metric": "RPE", **both, **spans, "left_out": self.left_out}


@dataclass(frozen=True, eq=False, repr=False)
class DriftRate(Number):
    """ATE per meter travelled.

    Attributes
    ----------
    rate : float
        Meters of error per meter of path.
    ate : ErrorSummary
        The absolute error and how it was aligned.
    path_length : float
        Length of the reference, meters.
    """

    rate: float
    ate: ErrorSummary
    path_length: float

    def __float__(self):
        return self.rate

    @property
    def coverage(self):
        """How much of the run was matched, if `match` did it."""
        return self.ate.coverage

    def __repr__(self):
        return (
            f"drift rate {100 * self.rate:.6g} % (ATE rmse {self.ate.rmse:.6g} m, aligned: "
            f"{self.ate.alignment.mode}, on {self.path_length:.6g} m of path, n {self.ate.n})"
            + _covered(self.coverage)
        )

    def _repr_html_(self):
        return f"<table><tr><td>{self!r}</td></tr></table>"

    def as_dict(self):
        """Return the rate and what it is made of, ready for JSON."""
        return {
            "metric": "drift rate",
            "rate": self.rate,
            "unit": "m/m",
            "path_length": self.path_length,
            "ate": self.ate.as_dict(),
        }


@dataclass(frozen=True, eq=False, repr=False)
class SegmentDrift(Result):
    """Drift over segments of given lengths, as in the KITTI odometry benchmark.

    Attributes
    ----------
    translation_percent : float
        Mean over all segments of translation error / nominal length, percent.
    rotation_deg_per_100m : float
        Mean over all segments of rotation error / nominal length, degrees per 100 m.
    per_length : dict of float to (float, float, int)
        The two means and the number of segments, by length in meters; lengths longer
        than the path are absent.
    n : int
        Number of segments.
    coverage : Coverage or None
        How much of the run was matched, if `match` did it.
    """

    translation_percent: float
    rotation_deg_per_100m: float
    per_length: dict
    n: int
    coverage: object = None

    def __repr__(self):
        lengths = ", ".join(f"{length:g}" for length in self.per_length)
        return (
            f"segment drift {self.translation_percent:.6g} %, {self.rotation_deg_per_100m:.6g} "
            f"deg/100 m (no alignment needed, n {self.n}, segments of {lengths} m)"
            + _covered(self.coverage)
        )

    def _repr_html_(self):
        head = "<tr><th>length</th><th>translation</th><th>rotation</th><th>n</th></tr>"
        rows = "".join(
            f"<tr><td>{length:g} m</td><td>{t:.6g} %</td>"
            f"<td>{r:.6g} deg/100 m</td><td>{n}</td></tr>"
            for length, (t, r, n) in self.per_length.items()
        )
        return f"<table><caption>{self!r}</caption>{head}{rows}</table>"


def ate(
    reference: ArrayLike,
    estimate: ArrayLike,
    align: str = "rigid",
    *,
    first: int | None = None,
    body: ArrayLike | None = None,
) -> ErrorSummary:
    """Absolute trajectory error: the distance of each position after alignment.

    Parameters
    ----------
    reference, estimate : (N, d) or (N, d+1, d+1) array or Trajectory
        Positions or poses in meters, d = 2 or 3, sample by sample at the same times, as
        `match` returns them.
    align : {"rigid", "similarity", "yaw", "origin", "none"}
        How the estimate is first brought into the reference's frame, as in `align`.
    first : int, optional
        How many of the first samples the alignment is found from; all by default.
    body : (d+1, d+1) array, optional
        Pose of the reference's body frame in the estimate's body frame, where they track
        different points of the robot: the estimate becomes ``estimate @ body``.

    Returns
    -------
    ErrorSummary
        In meters, each >= 0, with the Alignment. If both are poses, `rotation` holds the
        angles between the orientations after alignment, radians in [0, pi]. `notes` names
        likely causes of a large error.

    Raises
    ------
    DegenerateAlignmentError
        If the positions leave the alignment undetermined.
    AmrError
        If the input is malformed.

    References
    ----------
    Lecture 03. Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems,
    IROS 2012, eqs. (4)-(5).

    Examples
    --------
    >>> import amrmetrics as am
    >>> truth = [[0, 0], [1, 0], [2, 0], [3, 0]]
    >>> error = am.ate(truth, [[0, 0], [1, 1], [2, 0], [3, 1]], align="none")
    >>> error.series.tolist(), error.median
    ([0.0, 1.0, 0.0, 1.0], 0.5)
    """
    coverage, stamps = coverage_of(reference, estimate), getattr(reference, "stamps", None)
    reference = as_reals(reference, "reference")
    estimate = with_body(as_reals(estimate, "estimate"), body)
    p, q = as_position_pair(reference, estimate)
    alignment, series = fit(p, q, align, first, first_poses(reference, estimate, align))
    return ErrorSummary(
        metric="ATE",
        quantity="translation",
        unit="m",
        series=series,
        alignment=alignment,
        coverage=coverage,
        compared=Compared(reference, estimate, stamps, body),
    )


def with_body(estimate, body):
    """Return the poses of another body frame of the same robot."""
    if body is None:
        return estimate
    body, poses = as_poses(body, "body", batch=True), as_poses(estimate, "estimate")
    if body.shape != poses.shape[1:]:
        raise AmrError(f"body has shape {body.shape}; expected one pose {poses.shape[1:]}.")
    return poses @ body


def rpe(
    reference: ArrayLike,
    estimate: ArrayLike,
    delta: float = 1,
    unit: str = "frames",
    pairs: str = "all",
    stamps: ArrayLike | None = None,
    *,
    body: ArrayLike | None = None,
) -> RelativeError:
    """Relative pose error: how well the motion over a short stretch is reproduced.

    For a pair (i, j), E = inv(inv(X[i]) @ X[j]) @ (inv(Xh[i]) @ Xh[j]); its translation
    and its rotation angle are the errors. No alignment is needed: E does not change when
    either trajectory is moved as a whole.

    Parameters
    ----------
    reference, estimate : (N, d+1, d+1) array
        Poses, d = 2 or 3, sample by sample at the same times.
    delta : float
        Length of the stretch in `unit`, > 0; a whole number of frames.
    unit : {"frames", "m", "s", "deg"}
        How the stretch is measured, always on the reference; "metres", "meters", "seconds"
        and "degrees" are taken, too.
    pairs : {"all", "consecutive"}
        "all": from every sample to the one nearest to delta further on (for degrees, to
        every one at that angle, which takes time N**2), as far as the recording reaches
        delta. "consecutive": end to start, each ending at the first sample that reaches
        delta; metres are summed along the path and degrees over the single turns. Pairs in
        metres, seconds and, if all, in degrees that miss delta by more than 10 % are left
        out and counted.
    stamps : (N,) array, optional
        Seconds; needed for unit="s", and a Trajectory has its own.
    body : (d+1, d+1) array, optional
        As for `ate`.

    Returns
    -------
    RelativeError
        `translation` in meters, `rotation` in radians in [0, pi], `pairs`, `lengths`.

    Raises
    ------
    AmrError
        If no pair spans delta (the message says what the data would allow), or the input
        is malformed.

    References
    ----------
    Lecture 03. Sturm et al. 2012, eqs. (1)-(2); Kuemmerle et al., Autonomous Robots 27
    (2009), eq. (4).

    Examples
    --------
    A heading error of 0.1 rad that stays constant is no relative error at all.

    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.linspace(0, 4, 50)
    >>> X = am.planar_poses(np.c_[t, np.sin(t)], np.arctan(np.cos(t)))
    >>> G = am.planar_poses([[3, 4]], [0.1])
    >>> am.rpe(X, G @ X, delta=5).translation.max < 1e-12
    True
    """
    coverage = coverage_of(reference, estimate)
    stamps = getattr(reference, "stamps", None) if stamps is None else stamps
    X, Y = as_pose_pair(reference, estimate if body is None else with_body(estimate, body))
    found, lengths, left_out = find_pairs(X, delta, unit, pairs, stamps)
    shared = {
        "metric": "RPE",
        "delta": float(delta),
        "delta_unit": as_unit(unit),
        "pairs": pairs,
        "coverage": coverage,
    }
    translation, rotation = pair_errors(X, Y, *found)
    return RelativeError(
        ErrorSummary(quantity="translation", unit="m", series=translation, **shared),
        ErrorSummary(quantity="rotation", unit="rad", series=rotation, **shared),
        found.T,
        lengths,
        left_out,
    )


def drift_rate(
    reference: ArrayLike,
    estimate: ArrayLike,
    align: str = "rigid",
    *,
    first: int | None = None,
    body: ArrayLike | None = None,
) -> DriftRate:
    """ATE per meter travelled: half a meter on ten is not half a meter on two kilometers.

    Parameters
    ----------
    reference, estimate : (N, d) or (N, d+1, d+1) array
        As for `ate`.
    align, first, body
        As for `ate`.

    Returns
    -------
    DriftRate
        Converts to the plain ratio with ``float()``.

    Raises
    ------
    AmrError
        As `ate`, and if the reference does not move.

    References
    ----------
    Lecture 03.

    Examples
    --------
    >>> import amrmetrics as am
    >>> float(am.drift_rate([[0, 0], [10, 0]], [[0, 1], [10, 1]], align="none"))
    0.1
    """
    error = ate(reference, estimate, align, first=first, body=body)
    length = path_length(reference)
    if length == 0:
        raise AmrError("the reference does not move (path length 0 m): it has no drift per meter.")
    return DriftRate(error.rmse / length, error, length)


def segment_drift(
    reference: ArrayLike,
    estimate: ArrayLike,
    lengths: ArrayLike = KITTI_LENGTHS,
    step: int = 10,
    *,
    body: ArrayLike | None = None,
) -> SegmentDrift:
    """Translation and rotation error over segments of the path, as KITTI reports them.

    Parameters
    ----------
    reference, estimate : (N, d+1, d+1) array
        Poses, d = 2 or 3, sample by sample at the same times.
    lengths : sequence of float
        Segment lengths in meters along the reference, > 0.
    step : int
        A segment starts at every `step`-th sample and ends at the first sample farther
        along the path than its length.
    body : (d+1, d+1) array, optional
        As for `ate`.

    Returns
    -------
    SegmentDrift
        `translation_percent`, `rotation_deg_per_100m`, and both per length.

    Raises
    ------
    AmrError
        If the path is not longer than the shortest length, or the input is malformed.

    References
    ----------
    Lecture 03. Geiger, Lenz and Urtasun, Are we ready for autonomous driving?, CVPR 2012,
    eqs. (2)-(3), averaged as in the benchmark's development kit.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 1000.0)
    >>> X = am.planar_poses(np.c_[t, 0 * t], 0 * t)
    >>> Xh = am.planar_poses(np.c_[1.01 * t, 0 * t], 0 * t)
    >>> round(am.segment_drift(X, Xh, lengths=[100, 200]).translation_percent, 4)
    1.0076
    """
    coverage = coverage_of(reference, estimate)
    X, Y = as_pose_pair(reference, estimate if body is None else with_body(estimate, body))
    lengths = np.unique(as_numbers(lengths, "lengths").ravel())
    if not len(lengths) or lengths[0] <= 0:
        raise AmrError(f"lengths are {lengths.tolist()}; expected positive numbers of meters.")
    if not isinstance(step, int | np.integer) or step < 1:
        raise AmrError(f"step is {step!r}; expected a whole number of samples, at least 1.")
    along = travelled(X)
    per_length, total = {}, np.zeros(3)
    for length in lengths.tolist():
        i = np.arange(0, len(X), step)
        j = np.searchsorted(along, along[i] + length, side="right")
        i, j = i[j < len(X)], j[j < len(X)]
        if len(i):
            t, r = (error.sum() / length for error in pair_errors(X, Y, i, j))
            sums = np.array([100 * t, 100 * np.degrees(r), len(i)])
            per_length[length] = (*(sums[:2] / len(i)).tolist(), len(i))
            total += sums
    if not per_length:
        raise AmrError(
            f"the reference is {along[-1]:.6g} m long, too short for {lengths[0]:g} m segments. "
            "Give shorter lengths."
        )
    translation, rotation, n = total
    mean_translation, mean_rotation = float(translation / n), float(rotation / n)
    return SegmentDrift(mean_translation, mean_rotation, per_length, int(n), coverage)


def pool(summaries: Iterable[ErrorSummary]) -> ErrorSummary:
    """Pool the errors of several runs as if they were one.

    Parameters
    ----------
    summaries : sequence of ErrorSummary
        Of the same metric, unit and alignment mode.

    Returns
    -------
    ErrorSummary
        Over all samples. Its rmse is the root of the mean of all squares; the mean of the
        runs' RMSEs weighs a short run like a long one; `run_rmse` has them. There is no single
        `alignment`; `run_alignment` is the mode. Rotations are pooled, too, if all runs have
        them, and pooled runs can be pooled again.

    Raises
    ------
    AmrError
        If there is no summary, or metrics, units or alignment modes differ.

    References
    ----------
    Lecture 03.

    Examples
    --------
    >>> import amrmetrics as am
    >>> runs = [am.ate([[0, 0]] * n, [[0, e]] * n, align="none") for n, e in ((1, 0), (3, 4))]
    >>> round(am.pool(runs).rmse, 4)
    3.4641
    """
    summaries = list(summaries) if np.iterable(summaries) else [summaries]
    if not summaries:
        raise AmrError("summaries is empty; at least one run is needed.")
    for k, summary in enumerate(summaries):
        if not isinstance(summary, ErrorSummary):
            raise AmrError(
                f"summaries[{k}] is of type {type(summary).__name__}; expected an ErrorSummary, as "
                "ate returns it, or the translation or rotation that rpe returns."
            )
    kinds = {(s.metric, s.quantity, s.delta, s.delta_unit, s.pairs, _mode(s)) for s in summaries}
    if len(kinds) > 1:
        found = "; ".join(sorted(f"{s._title()}, aligned: {_mode(s)}" for s in summaries))
        raise AmrError(f"summaries differ in what they measure ({found}); pool equal ones.")
    return _pooled(summaries)


def _mode(summary):
    return summary.run_alignment or (summary.alignment.mode if summary.alignment else "none")


def _pooled(summaries):
    one = summaries[0]
    rotations = [s.rotation for s in summaries]
    pooled = ErrorSummary(
        metric=one.metric,
        quantity=one.quantity,
        unit=one.unit,
        series=np.concatenate([s.series for s in summaries]),
        delta=one.delta,
        delta_unit=one.delta_unit,
        pairs=one.pairs,
        run_rmse=tuple(x for s in summaries for x in s.run_rmse or (s.rmse,)),
        run_alignment=_mode(one) if one.metric == "ATE" else None,
        compared=None if None in rotations else Pooled(_pooled(rotations)),
    )
    return pooled


@dataclass(frozen=True, eq=False)
class Pooled:
    """The rotations of pooled runs."""

    rotations: ErrorSummary

    def rotation(self, summary):
        return self.rotations
