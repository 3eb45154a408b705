"""Whole jobs: two recordings in, all trajectory metrics out (lecture 03).

`evaluate` reads, matches, aligns and measures, and says how much of the run its numbers cover.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from amrmetrics._arguments import as_numbers
from amrmetrics._results import Result
from amrmetrics.alignment import Alignment
from amrmetrics.errors import AmrError
from amrmetrics.files import read
from amrmetrics.interruptions import Jumps, LostTime, jumps, lost_time
from amrmetrics.matching import Coverage, match
from amrmetrics.poses import project
from amrmetrics.recording import Trajectory
from amrmetrics.stamps import clock_offset
from amrmetrics.trajectory import (
    DriftRate,
    ErrorSummary,
    SegmentDrift,
    ate,
    drift_rate,
    rpe,
    segment_drift,
    with_body,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from amrmetrics._types import ArrayLike, Path

# Stretches of an RPE that say something about most robots, as far as the run is long enough.
DELTAS = ((1, "frames"), (1, "s"), (0.1, "m"), (1, "m"), (10, "m"), (100, "m"))
# A run is this many times as long as a stretch at least.
LONG_ENOUGH = 4
PLANES = ("xy", "xz", "yz")
# Standard errors of an estimated clock offset by which stamps may differ because of it.
DEVIATIONS = 2
# Pairs of runs from which a comparison can show something at 95 %.
ENOUGH_RUNS = 6
# An ATE of this part of what a point leaves that never moves, from so many poses, is worth a word.
UNLIKE = 0.5
ENOUGH_POSES = 10


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Report(Result):
    """Every trajectory metric of one estimate.

    Attributes
    ----------
    name, reference_name : str
        Of the estimate and of the reference.
    coverage : Coverage
        How much of each was matched.
    matched_by : str
        How samples were matched.
    offset : float
        Seconds that were added to the estimate's stamps.
    plane : str or None
        The plane that everything was projected to.
    ate : ErrorSummary
        Absolute error of the positions; `ate.rotation` that of the orientations.
    rpe : tuple of RelativeError
        Relative errors, by increasing stretch.
    drift_rate : DriftRate or None
        ATE per meter.
    segments : SegmentDrift or None
        KITTI's drift of segments, where the path is long enough.
    jumps : Jumps or None
        Steps in which the estimate moves far from the reference's motion, the worst with its
        time; None of a single sample. `Jumps` says what counts.
    lost_seconds : LostTime or None
        Time of the reference without a matched estimate, and the longest stretch; None without
        stamps. `LostTime` says what counts.
    skipped : dict of str to str
        What could not be computed, and why.
    notes : tuple of str
        Repairs of the files and likely causes of a large error.
    reference, estimate : Trajectory
        What was measured, matched and not yet aligned.
    """

    name: str
    reference_name: str
    coverage: Coverage
    matched_by: str
    offset: float
    plane: str | None
    ate: ErrorSummary
    rpe: tuple
    drift_rate: DriftRate | None
    segments: SegmentDrift | None
    jumps: Jumps | None
    lost_seconds: LostTime | None
    skipped: dict
    notes: tuple
    reference: Trajectory
    estimate: Trajectory

    @property
    def alignment(self):
        """How the estimate was aligned for the ATE."""
        return self.ate.alignment

    def as_dict(self):
        """Return all numbers and conventions, ready for JSON."""
        rows = {
            "estimate": self.name,
            "reference": self.reference_name,
            "coverage": self.coverage.as_dict(),
            "matched_by": self.matched_by,
            "offset": self.offset,
            "plane": self.plane,
            "alignment": self.alignment.as_dict(),
            "ate": self.ate.as_dict(),
            "rpe": [x.as_dict() for x in self.rpe],
            "drift_rate": self.drift_rate and self.drift_rate.rate,
            "path_length": self.drift_rate and self.drift_rate.path_length,
            "segments": self.segments and self.segments.as_dict(),
            "jumps": None if self.jumps is None else self.jumps.as_dict(),
            "lost_seconds": None if self.lost_seconds is None else self.lost_seconds.as_dict(),
            "skipped": self.skipped,
            "notes": list(self.notes),
        }
        return _without_nan(rows)

    def _matched(self):
        by = "" if self.matched_by == "nearest stamps" else f", by {self.matched_by}"
        return repr(self.coverage).removeprefix("matched ") + by

    def _title(self):
        return f"{self.name} against {self.reference_name}"

    def _rows(self):
        rows = [
            ("matched", self._matched()),
            ("alignment", _aligned(self.alignment)),
        ]
        if self.offset:
            rows.append(("clock offset", f"{self.offset:.6g} s"))
        if self.plane:
            rows.append(("plane", self.plane))
        rows += [("ATE", _summary(self.ate))]
        if self.ate.rotation is not None:
            rows.append(("ATE rotation", _summary(self.ate.rotation)))
        rows += [
            (_name_of(x), f"{_summary(x.translation)}; {_short(x.rotation)}") for x in self.rpe
        ]
        if self.drift_rate:
            length = f"{self.drift_rate.path_length:.6g} m"
            rows.append(("drift rate", f"{100 * self.drift_rate.rate:.4g} % of {length}"))
        if self.segments:
            s = self.segments
            text = f"{s.translation_percent:.4g} %, {s.rotation_deg_per_100m:.4g} deg/100 m"
            rows.append(("segment drift", f"{text}, n {s.n}"))
        if self.jumps is not None:
            rows.append(("jumps", repr(self.jumps)))
        if self.lost_seconds is not None:
            rows.append(("lost time", repr(self.lost_seconds)))
        rows += [(f"no {what}", why) for what, why in self.skipped.items()]
        return rows + [("note", note) for note in self.notes]

    def __repr__(self):
        width = max(len(name) for name, _ in self._rows())
        rows = [f"  {name:{width}}  {text}" for name, text in self._rows()]
        return "\n".join([self._title(), *rows])


@dataclass(frozen=True, eq=False, repr=False)
class Reports(Result):
    """Reports of several estimates, the best ATE first, and the estimates that failed.

    Attributes
    ----------
    reports : tuple of Report
        Sorted by the rmse of the ATE.
    failures : dict of str to str
        Estimates that could not be evaluated, and why.
    comparisons : dict of str to PairedTest
        Systems with enough runs each, two by two: differences of their ATE, run by run.
    """

    reports: tuple
    failures: dict
    comparisons: dict

    def __iter__(self):
        return iter(self.reports)

    def __len__(self):
        return len(self.reports)

    def __getitem__(self, index):
        return self.reports[index]

    @property
    def success_rate(self):
        """Part of the estimates that could be evaluated."""
        return len(self.reports) / (len(self.reports) + len(self.failures))

    @property
    def median(self):
        """Median of the ATE rmse over the runs, failures as the worst; nan if half failed."""
        values = [x.ate.rmse for x in self.reports] + [np.inf] * len(self.failures)
        middle = float(np.median(values))
        return middle if np.isfinite(middle) else float("nan")

    def table(self):
        """Return the table: a list of dictionaries with the same keys, ready for pandas."""
        rows = [row_of(report) for report in self.reports]
        # The longest rows know best where a column belongs.
        longest = sorted(rows, key=len, reverse=True)
        columns = dict.fromkeys(name for row in longest for name in row)
        return [{name: row.get(name) for name in columns} for row in rows]

    def as_dict(self):
        """Return all numbers, ready for JSON."""
        rows = {
            "success_rate": self.success_rate,
            "median_ate_rmse": self.median,
            "reports": [report.as_dict() for report in self.reports],
            "failures": self.failures,
            "comparisons": {name: x.as_dict() for name, x in self.comparisons.items()},
        }
        return _without_nan(rows)

    def _title(self):
        done, total = len(self.reports), len(self.reports) + len(self.failures)
        median = f"{self.median:.6g} m" if self.median == self.median else "none, half failed"
        return f"{done} of {total} estimates evaluated, median ATE rmse {median}"

    def __repr__(self):
        table = self.table()
        rows = [list(map(_cell, row.values())) for row in table]
        head = [name.replace("_", " ") for name in table[0]]
        lines = _aligned_text([head, *rows])
        lines += [f"failed: {name}: {why}" for name, why in self.failures.items()]
        lines += [f"{name}: {result!r}" for name, result in self.comparisons.items()]
        notes = [f"{x.name}: {note}" for x in self.reports for note in x.notes]
        return "\n".join([self._title(), *lines, *notes])


def evaluate(
    reference: Path | Trajectory,
    estimate: Any,
    *,
    align: str = "rigid",
    first: int | None = None,
    deltas: Iterable[tuple[float, str]] | None = None,
    max_difference: float = 0.01,
    offset: float | str = 0.0,
    interpolate: bool = False,
    max_gap: float | None = None,
    plane: str | None = None,
    body: ArrayLike | None = None,
) -> Report | Reports:
    """Read, match, align and measure: every trajectory metric of one estimate or of several.

    Parameters
    ----------
    reference : path or Trajectory
        Ground truth.
    estimate : path or Trajectory, or a list or dict of them
        What is measured. Several are evaluated one by one; what fails is counted.
    align, first, body
        As in `ate`.
    deltas : sequence of (float, str), optional
        Stretches of the RPE with their units. By default 1 frame, 1 s, and those of 0.1, 1,
        10 and 100 m that the run is long enough for.
    max_difference, interpolate, max_gap
        As in `match`.
    offset : float or "auto"
        Seconds, added to the estimate's stamps; "auto" estimates it with `clock_offset`, and
        widens `max_difference` by two of its standard errors, but at most by half a step of the
        reference.
    plane : {None, "xy", "xz", "yz"}
        Project both to a plane first, as `project`.

    Returns
    -------
    Report, or Reports if several are given
        It prints as a table; `as_dict` has every number for JSON.

    Raises
    ------
    AmrError
        If the files cannot be read or matched, or the ATE is undefined. Of several
        estimates, only if all fail.
    OSError
        If the file of the reference, or of a single estimate, cannot be opened.

    References
    ----------
    Lecture 03.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> t = np.arange(0, 60, 0.1)
    >>> truth = am.Trajectory(t, am.planar_poses(np.c_[t, np.sin(t)], np.arctan(np.cos(t))))
    >>> noise = 0.01 * np.random.default_rng(3).normal(size=(600, 2))
    >>> run = am.Trajectory(t, am.planar_poses(am.positions(truth) + noise, am.yaw(truth)))
    >>> report = am.evaluate(truth, run)
    >>> round(report.ate.rmse, 3), len(report.rpe), report.coverage.matched
    (0.014, 5, 600)
    """
    options = {
        "align": align,
        "first": first,
        "deltas": deltas,
        "max_difference": max_difference,
        "offset": offset,
        "interpolate": interpolate,
        "max_gap": max_gap,
        "plane": plane,
        "body": body,
    }
    reference = as_trajectory(reference, "reference")
    one = isinstance(estimate, str | os.PathLike | Trajectory | np.ndarray)
    if one or not np.iterable(estimate):
        return _report(reference, as_trajectory(estimate, "estimate"), **options)
    named = _named(estimate)
    if not named:
        raise AmrError("estimate is empty; at least one is needed.")
    reports, failures = {}, {}
    for name, given in named.items():
        try:
            reports[name] = _report(reference, as_trajectory(given, name), name, **options)
        except (AmrError, OSError) as error:
            failures[name] = str(error)
    if not reports:
        raise AmrError(f"no estimate could be evaluated. {next(iter(failures.values()))}")
    ranked = sorted(reports.values(), key=lambda report: report.ate.rmse)
    return Reports(tuple(ranked), failures, _comparisons(list(named), reports))


def as_trajectory(given, name):
    """Return a Trajectory as it is, or read it from a file."""
    if isinstance(given, Trajectory):
        return given
    if isinstance(given, str | os.PathLike):
        return read(given)
    raise AmrError(
        f"{name} is of type {type(given).__name__}; expected the path of a file or a Trajectory: "
        "am.Trajectory(stamps, poses)."
    )


def _named(estimates):
    """Return the estimates by name: as given, or by file or source, each name once."""
    if isinstance(estimates, dict):
        return {str(name): given for name, given in estimates.items()}
    estimates = list(estimates)
    names = [
        os.fspath(x) if isinstance(x, str | os.PathLike) else getattr(x, "source", "")
        for x in estimates
    ]
    short = [os.path.basename(name) for name in names]
    seen = Counter(short)
    names = [s if seen[s] == 1 else n for s, n in zip(short, names, strict=True)]
    seen = Counter(names)
    names = [n if seen[n] == 1 and n else f"{n or 'estimate'} {k}" for k, n in enumerate(names, 1)]
    return dict(zip(names, estimates, strict=True))


def _report(
    reference,
    estimate,
    name=None,
    *,
    align,
    first,
    deltas,
    max_difference,
    offset,
    interpolate,
    max_gap,
    plane,
    body,
):
    if plane is not None and plane not in PLANES:
        raise AmrError(f"plane is {plane!r}; expected one of {', '.join(map(repr, PLANES))}.")
    name = name or estimate.source or "estimate"
    notes = [
        f"{who} repaired: {what}"
        for who, x in (("reference", reference), ("estimate", estimate))
        for what in x.repairs
    ]
    if isinstance(offset, str):
        offset = _estimated_offset(reference, estimate, offset)
        notes.append(f"clock offset estimated: {offset!r}")
        if not interpolate:
            max_difference = _widened(max_difference, offset, reference.stamps)
            notes[-1] += f"; stamps matched up to {max_difference:.3g} s apart because of that"
    if plane is not None:
        reference, estimate = (_projected(x, plane) for x in (reference, estimate))
    if body is not None:
        estimate = replace(estimate, poses=with_body(estimate, body))
    pair = match(reference, estimate, max_difference, offset, interpolate, max_gap)
    p, q = pair
    error = ate(p, q, align, first=first)
    error.compared.body = body
    if not error.notes:
        notes += _unlike(p, error)
    skipped, found = {}, []
    poses = p.poses.ndim == q.poses.ndim == 3
    if poses:
        found = _relative_errors(p, q, deltas, skipped)
    else:
        why = next(x.why_no_orientation for x in (p, q) if x.why_no_orientation)
        skipped["RPE"] = why
    drift = _unless_refused(skipped, "drift rate", lambda: drift_rate(p, q, align, first=first))
    segments = None
    if poses:
        segments = _unless_refused(skipped, "segment drift", lambda: segment_drift(p, q))
    return Report(
        name=name,
        reference_name=reference.source or "reference",
        coverage=pair.coverage,
        matched_by=pair.how,
        offset=pair.offset,
        plane=plane,
        ate=error,
        rpe=tuple(found),
        drift_rate=drift,
        segments=segments,
        jumps=jumps(p, q, error.alignment, max_gap),
        lost_seconds=lost_time(reference, p, max_gap),
        skipped=skipped,
        notes=(*notes, *error.notes),
        reference=p,
        estimate=q,
    )


def _estimated_offset(reference, estimate, offset):
    if offset != "auto":
        raise AmrError(f'offset is {offset!r}; expected a number of seconds or "auto".')
    try:
        return clock_offset(reference, estimate)
    except AmrError as error:
        named = {"X": "the reference", "Xh": "the estimate"}
        text = re.sub(r"\bXh?\b", lambda name: named[name[0]], str(error))
        raise AmrError(f"no clock offset could be estimated: {text}") from None


def _widened(max_difference, offset, stamps):
    """Return the tolerance for stamps that are off by what an estimated offset may be off by.

    Half a step of the reference is the most: farther away, another pose is as near.
    """
    most = float(np.median(np.diff(stamps))) / 2
    return float(as_numbers(max_difference, "max_difference")) + min(
        DEVIATIONS * offset.standard_error, most
    )


def _projected(trajectory, plane):
    if trajectory.dimension == 2:
        return trajectory
    if trajectory.poses.ndim == 2:
        columns = ["xyz".index(letter) for letter in plane]
        return replace(trajectory, poses=trajectory.poses[:, columns])
    return replace(trajectory, poses=project(trajectory.poses, plane))


def _relative_errors(p, q, deltas, skipped):
    """Return the RPE over the stretches asked for, or those that the run is long enough for."""
    if deltas is not None:
        return [rpe(p, q, *stretch) for stretch in _stretches(deltas)]
    extent = {"frames": len(p), "s": p.duration, "m": p.path_length}
    found = []
    for delta, unit in DELTAS:
        if not extent[unit] >= LONG_ENOUGH * delta:
            continue
        try:
            found.append(rpe(p, q, delta, unit))
        except AmrError:  # the samples are farther apart than this stretch
            continue
    if not found:
        skipped["RPE"] = "the run is too short for any of the usual stretches"
    return found


def _stretches(deltas):
    """Return pairs of a delta and its unit."""
    pairs = list(deltas) if np.iterable(deltas) else [deltas]
    if not all(isinstance(pair, tuple | list) and len(pair) == 2 for pair in pairs):
        raise AmrError(f"deltas is {deltas!r}; expected pairs such as [(10, 'm'), (1, 's')].")
    return pairs


def _unlike(reference, error):
    """Say if an estimate is not much better than none."""
    xyz = reference.positions
    still = float(np.sqrt(((xyz - xyz.mean(axis=0)) ** 2).sum(axis=1).mean()))
    if len(xyz) < ENOUGH_POSES or error.rmse < UNLIKE * still:
        return []
    return [
        f"the ATE of a point that never moves would be {still:.4g} m: the estimate hardly follows "
        "the reference"
    ]


def _unless_refused(skipped, what, compute):
    try:
        return compute()
    except AmrError as error:
        skipped[what] = str(error)
        return None


def _comparisons(names, reports):
    """Compare systems pairwise whose runs are numbered alike: orb_1, orb_2 and vins_1, vins_2."""
    from amrmetrics.comparison import compare_paired

    systems = {}
    for name in names:
        stem = re.sub(r"\.(txt|csv|tum|kitti)$", "", name)
        found = re.fullmatch(r"(.*?)[_.\- ]*(\d+)", stem)
        if found:
            systems.setdefault(found[1], {})[found[2]] = name
    results = {}
    ordered = list(systems)
    for k, a in enumerate(ordered):
        for b in ordered[k + 1 :]:
            runs = sorted({*systems[a]} & {*systems[b]})
            if len(runs) >= ENOUGH_RUNS:
                pairs = [_rmse(reports, systems[s], runs) for s in (a, b)]
                if not np.isnan(pairs).all():  # there is a worst value
                    results[f"{a} - {b}"] = compare_paired(*pairs, failures="worst", unit="m")
    return results


def _rmse(reports, runs_of, runs):
    names = [runs_of[run] for run in runs]
    return [reports[name].ate.rmse if name in reports else np.nan for name in names]


def row_of(report):
    """Return one row of the table of several estimates; a number that is missing is None."""
    rotation, segments = report.ate.rotation, report.segments
    row = {
        "estimate": report.name,
        "matched_percent": 100 * report.coverage.share,
        "n": report.ate.n,
        "alignment": report.alignment.mode,
        "scale": report.alignment.scale,
        "ate_rmse_m": report.ate.rmse,
        "ate_mean_m": report.ate.mean,
        "ate_median_m": report.ate.median,
        "ate_max_m": report.ate.max,
        "ate_rotation_rmse_deg": rotation and float(np.degrees(rotation.rmse)),
    }
    for x in report.rpe:
        stretch = f"{x.translation.delta:g}{x.translation.delta_unit}"
        row[f"rpe_{stretch}_rmse_m"] = x.translation.rmse
        row[f"rpe_{stretch}_rmse_deg"] = float(np.degrees(x.rotation.rmse))
    row["drift_percent"] = report.drift_rate and 100 * report.drift_rate.rate
    row["segment_drift_percent"] = segments and segments.translation_percent
    row["segment_drift_deg_per_100m"] = segments and segments.rotation_deg_per_100m
    row["jumps"] = None if report.jumps is None else report.jumps.count
    row["lost_s"] = None if report.lost_seconds is None else report.lost_seconds.seconds
    return row


def _name_of(x):
    return f"RPE {x.translation.delta:g} {x.translation.delta_unit}"


def _summary(x):
    return (
        f"rmse {_number(x.rmse, x)}, median {_number(x.median, x)}, max {_number(x.max, x)}, "
        f"n {x.n}"
    )


def _short(x):
    return f"{x.quantity} rmse {_number(x.rmse, x)}"


def _number(value, summary):
    if summary.unit == "rad":
        return f"{np.degrees(value):.4g} deg"
    return f"{value:.4g} {summary.unit}"


def _aligned(alignment: Alignment):
    rows = dict(alignment._rows())
    text = f"{alignment.mode}, angle {rows['angle']}, translation {rows['translation']}"
    if alignment.mode == "similarity":
        text += f", scale {rows['scale']}"
    return f"{text}, from {alignment.n} samples"


def _cell(value):
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)


def _aligned_text(rows):
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    return ["  ".join(f"{c:>{w}}" for c, w in zip(row, widths, strict=True)) for row in rows]


def _without_nan(value):
    """Return plain data with None in place of nan, which JSON does not have."""
    if isinstance(value, dict):
        return {str(key): _without_nan(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_without_nan(item) for item in value]
    if isinstance(value, float):
        return float(value) if np.isfinite(value) else None
    return value
