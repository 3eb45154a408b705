"""How far off a trajectory is: ATE, RPE, drift. Lecture 03 derives what each one sees.

Every result says how it was aligned, in which unit it is and over how many samples.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from amrmetrics._arguments import as_array, as_numbers, as_pose_pair, as_position_pair
from amrmetrics.alignment import Alignment, fit
from amrmetrics.errors import AmrError
from amrmetrics.pairs import find_pairs, orientation_errors, pair_errors, travelled
from amrmetrics.poses import path_length

KITTI_LENGTHS = (100, 200, 300, 400, 500, 600, 700, 800)


@dataclass(frozen=True, eq=False, repr=False)
class ErrorSummary:
    """One error per sample, and the numbers that papers print.

    Attributes
    ----------
    squares : (n,) array
        The squared error of each sample or pair, in `unit` squared.
    unit : str
        "m" or "rad".
    of : str
        What was measured, for example "ATE" or "RPE translation, delta 1 frames, all pairs".
    alignment : Alignment or None
        The transformation applied first; None where the metric needs none.
    rotation : ErrorSummary or None
        For the ATE of poses: the angle between the orientations after alignment.
    """

    squares: np.ndarray
    unit: str
    of: str
    alignment: Alignment | None = None
    rotation: "ErrorSummary | None" = None

    @cached_property
    def series(self):
        """The error of each sample or pair, (n,) array, not negative, in `unit`."""
        return np.sqrt(self.squares)

    @property
    def n(self):
        """Number of samples."""
        return len(self.squares)

    @property
    def rmse(self):
        """Root of the mean square: large errors weigh most."""
        return float(np.sqrt(self.squares.mean()))

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
        return float(self.series.std())

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

    def __float__(self):
        return self.rmse

    def __repr__(self):
        return f"{self.of}: {', '.join(f'{name} {text}' for name, text in self._rows())}"

    def _repr_html_(self):
        rows = "".join(f"<tr><th>{name}</th><td>{text}</td></tr>" for name, text in self._rows())
        return f"<table><caption>{self.of}</caption>{rows}</table>"

    def _rows(self):
        names = ("rmse", "mean", "median", "std", "min", "max", "p95")
        rows = [(name, self._with_unit(getattr(self, name))) for name in names]
        how = self.alignment.mode if self.alignment else "not needed"
        return [*rows, ("n", f"{self.n}"), ("alignment", how)]

    def _with_unit(self, x):
        degrees = f" ({np.degrees(x):.6g} deg)" if self.unit == "rad" else ""
        return f"{x:.6g} {self.unit}{degrees}"


@dataclass(frozen=True, eq=False, repr=False)
class RelativeError:
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

    def __repr__(self):
        rmse = (f"{x.of.split()[1][:-1]} rmse {x._with_unit(x.rmse)}" for x in self._both())
        what = self.translation.of.replace(" translation", "")
        return f"{what}: {', '.join(rmse)}, n {self.translation.n}, {self._span()}"

    def _repr_html_(self):
        return "".join(x._repr_html_() for x in self._both()) + f"<p>{self._span()}</p>"

    def _both(self):
        return self.translation, self.rotation

    def _span(self):
        span = f"pairs span {self.lengths.min():.6g} to {self.lengths.max():.6g}"
        return f"{span}, {self.left_out} left out, no alignment needed"


@dataclass(frozen=True, eq=False, repr=False)
class DriftRate:
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

    def __repr__(self):
        return (
            f"drift rate {100 * self.rate:.6g} % (ATE rmse {self.ate.rmse:.6g} m, aligned: "
            f"{self.ate.alignment.mode}, on {self.path_length:.6g} m of path, n {self.ate.n})"
        )

    def _repr_html_(self):
        return f"<table><tr><td>{self!r}</td></tr></table>"


@dataclass(frozen=True, eq=False, repr=False)
class SegmentDrift:
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
    """

    translation_percent: float
    rotation_deg_per_100m: float
    per_length: dict
    n: int

    def __repr__(self):
        lengths = ", ".join(f"{length:g}" for length in self.per_length)
        return (
            f"segment drift {self.translation_percent:.6g} %, {self.rotation_deg_per_100m:.6g} "
            f"deg/100 m (no alignment needed, n {self.n}, segments of {lengths} m)"
        )

    def _repr_html_(self):
        head = "<tr><th>length</th><th>translation</th><th>rotation</th><th>n</th></tr>"
        rows = "".join(
            f"<tr><td>{length:g} m</td><td>{t:.6g} %</td>"
            f"<td>{r:.6g} deg/100 m</td><td>{n}</td></tr>"
            for length, (t, r, n) in self.per_length.items()
        )
        return f"<table><caption>{self!r}</caption>{head}{rows}</table>"


def ate(reference, estimate, align="rigid"):
    """Absolute trajectory error: the distance of each position after alignment.

    Parameters
    ----------
    reference, estimate : (N, d) or (N, d+1, d+1) array
        Positions or poses in meters, d = 2 or 3, sample by sample at the same times.
    align : {"rigid", "similarity", "yaw", "none"}
        How the estimate is first brought into the reference's frame.

    Returns
    -------
    ErrorSummary
        In meters, each >= 0, with the Alignment. If both are poses, `rotation` holds the
        angles between the orientations after alignment, radians in [0, pi].

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
    arrays = as_array(reference, "reference"), as_array(estimate, "estimate")
    if any(array.ndim != 3 for array in arrays):
        alignment, squares = fit(*as_position_pair(*arrays), align)
        return ErrorSummary(squares, "m", "ATE", alignment)
    X, Y = as_pose_pair(*arrays)
    alignment, squares = fit(X[:, :-1, -1].copy(), Y[:, :-1, -1].copy(), align)
    angles = orientation_errors(X, Y, alignment.rotation)
    rotation = ErrorSummary(angles**2, "rad", "ATE rotation", alignment)
    return ErrorSummary(squares, "m", "ATE", alignment, rotation)


def rpe(reference, estimate, delta=1, unit="frames", pairs="all", stamps=None):
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
    unit : {"frames", "metres", "seconds", "degrees"}
        How the stretch is measured, always on the reference.
    pairs : {"all", "consecutive"}
        "all": from every sample to the one nearest to delta further on (for degrees, to
        every one at that angle, which takes time N**2). "consecutive": end to start, each
        ending at the first sample that reaches delta; metres are summed along the path and
        degrees over the single turns. Pairs in metres, seconds and, if all, in degrees
        that miss delta by more than 10 % are left out and counted.
    stamps : (N,) array, optional
        Seconds; needed for unit="seconds".

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
    X, Y = as_pose_pair(reference, estimate)
    found, lengths, left_out = find_pairs(X, delta, unit, pairs, stamps)
    translation, rotation = pair_errors(X, Y, *found)
    of = f"delta {delta:g} {unit}, {pairs} pairs"
    return RelativeError(
        ErrorSummary(translation**2, "m", f"RPE translation, {of}"),
        ErrorSummary(rotation**2, "rad", f"RPE rotation, {of}"),
        found.T,
        lengths,
        left_out,
    )


def drift_rate(reference, estimate, align="rigid"):
    """ATE per meter travelled: half a meter on ten is not half a meter on two kilometers.

    Parameters
    ----------
    reference, estimate : (N, d) or (N, d+1, d+1) array
        As for `ate`.
    align : {"rigid", "similarity", "yaw", "none"}
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
    error = ate(reference, estimate, align)
    length = path_length(reference)
    if length == 0:
        raise AmrError("the reference does not move (path length 0 m): it has no drift per meter.")
    return DriftRate(error.rmse / length, error, length)


def segment_drift(reference, estimate, lengths=KITTI_LENGTHS, step=10):
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
    X, Y = as_pose_pair(reference, estimate)
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
    return SegmentDrift(float(translation / n), float(rotation / n), per_length, int(n))


def pool(summaries):
    """Pool the errors of several runs as if they were one.

    Parameters
    ----------
    summaries : sequence of ErrorSummary
        Of the same metric, unit and alignment mode.

    Returns
    -------
    ErrorSummary
        Over all samples. Its rmse is the root of the mean of all squares; the mean of the
        runs' RMSEs weighs a short run like a long one; `of` gives it. `alignment` is that of
        the first run.

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
    kinds = {(s.of, s.unit, s.alignment.mode if s.alignment else "none") for s in summaries}
    if len(kinds) > 1:
        found = "; ".join(f"{of} in {unit}, aligned: {mode}" for of, unit, mode in sorted(kinds))
        raise AmrError(f"summaries differ in what they measure ({found}); pool equal ones.")
    mean = np.mean([s.rmse for s in summaries])
    of = f"{summaries[0].of}, {len(summaries)} runs pooled (mean of the runs' rmse {mean:.6g})"
    squares = np.concatenate([s.squares for s in summaries])
    return ErrorSummary(squares, summaries[0].unit, of, summaries[0].alignment)
