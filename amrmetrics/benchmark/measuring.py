"""All numbers of one trial, and a thinned series of it for the figures (lecture 10).

A number that cannot be had is None, and the row says why. A trial breaks the rules of the
protocol, or cannot be measured: then it failed, and has no numbers but its coverage.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from amrmetrics.consistency import consistency_test, nees, nis, pose_errors
from amrmetrics.errors import AmrError
from amrmetrics.loops import precision_recall
from amrmetrics.maps import chamfer
from amrmetrics.matching import match
from amrmetrics.poses import path_length
from amrmetrics.recording import Trajectory
from amrmetrics.stamps import SHORTEST_GAP, USUAL_GAPS, as_gap
from amrmetrics.trajectory import ate, rpe

# A run is looked at in this many equally spaced instants; the last one is its end.
INSTANTS = 50
# At every tenth of them, a fifth of the run, NEES is tested over the seeds.
TESTED = slice(9, INSTANTS, 10)
# Levels of recall at which precision is averaged over the seeds.
RECALLS = np.arange(1, 51) / 50
# Times of frames are counted in classes that differ by a factor of 10^(1/200), 1.2 %.
PER_DECADE = 200
# Points of a trajectory that a figure shows.
DRAWN = 300

# Deepest text of a reason that is kept.
LONGEST = 300


@dataclass(frozen=True)
class Column:
    """What a column of the table means.

    Attributes
    ----------
    unit : str
        Of its numbers; "" if they have none.
    better : str
        "lower" or "higher"; "" if neither is.
    meaning : str
        The convention, in a sentence.
    counts_failures : bool
        Whether the protocol's rule gives failed trials a number here; otherwise they are counted
        beside the others.
    """

    unit: str
    better: str
    meaning: str
    counts_failures: bool = True


def columns(decisions: dict) -> dict[str, Column]:
    """Return the numbers of a row by name, with their conventions.

    Parameters
    ----------
    decisions : dict
        The fields of a `Protocol`.

    Examples
    --------
    >>> from dataclasses import asdict
    >>> from amrmetrics.benchmark.data import Protocol
    >>> from amrmetrics.benchmark.measuring import columns
    >>> table = columns(asdict(Protocol()))
    >>> table["ate"].unit, table["ate"].better, "rpe_10m" in table
    ('m', 'lower', True)
    """
    align = decisions["align"]
    after = f"after {align} alignment" if align != "none" else "without alignment"
    lost = (
        "time of the truth without matched estimates: gaps longer than "
        f"{USUAL_GAPS} usual ones between them and than {SHORTEST_GAP:g} s"
    )
    # The median of a chi-square is smaller: 2.37 with 3 dof.
    expected = "the mean over the seeds, not their median, is expected to be the dof"
    moved = f"brought along by the trajectory's {align} alignment" if align != "none" else after
    found = {
        "coverage": Column(
            "", "higher", "part of the truth's time that has matched estimates", False
        ),
        "lost_seconds": Column("s", "lower", lost, False),
        "path_length": Column("m", "", "length of the matched part of the truth"),
        "ate": Column("m", "lower", f"rmse of the ATE {after}"),
        "ate_max": Column("m", "lower", f"largest ATE {after}"),
        "ate_rotation_deg": Column("deg", "lower", f"rmse of the ATE's rotation {after}"),
    }
    if align == "similarity":
        found["scale"] = Column("", "", "factor by which the alignment made the estimate larger")
    for delta, unit in decisions["deltas"]:
        name = f"rpe_{delta:g}{unit}"
        over = f"of the RPE over {delta:g} {unit}, all pairs, no alignment"
        found[name] = Column("m", "lower", f"rmse of the translation {over}")
        found[f"{name}_deg"] = Column("deg", "lower", f"rmse of the rotation {over}")
    return found | {
        "drift_percent": Column("%", "lower", f"rmse of the ATE {after} per length of path"),
        "anees": Column("", "", f"NEES, averaged over the run; {expected}; not aligned"),
        "nees_end": Column("", "", f"NEES at the end of the run; {expected}; not aligned"),
        "nees_dof": Column("", "", "degrees of freedom of one NEES"),
        "anis": Column("", "", f"NIS, averaged over the run; {expected}"),
        "nis_dof": Column("", "", "degrees of freedom of one NIS"),
        "map_rmse": Column("m", "lower", f"rmse over mapped landmarks, {moved}"),
        "map_chamfer": Column(
            "m", "lower", f"Chamfer distance, the sum of both directions' means, {moved}"
        ),
        "map_found": Column("", "higher", "part of the landmarks that were mapped"),
        "closure_precision": Column("", "higher", "true closures of those accepted"),
        "closure_recall": Column("", "higher", "closures accepted of the true candidates"),
        "false_closures": Column("", "lower", "false closures accepted"),
        "average_precision": Column(
            "", "higher", "area under the steps of precision over recall, no interpolation"
        ),
        "latency_median_ms": Column("ms", "lower", "median time of a frame; measured", False),
        "latency_p95_ms": Column("ms", "lower", "P95 of the times of frames; measured", False),
        "latency_p99_ms": Column("ms", "lower", "P99 of the times of frames; measured", False),
        "wall_seconds": Column("s", "lower", "time of the call of the system; measured", False),
        "peak_megabytes": Column(
            "MB", "lower", "largest memory of the trial's process, with Python; measured", False
        ),
    }


@dataclass
class Measured:
    """What is kept of one trial.

    Attributes
    ----------
    row : dict
        Names and plain numbers or texts; ``skipped`` says why numbers are missing.
    series : dict of str to array
        At the instants of the run, at the levels of recall, and frames by their time.
    trace : dict
        For the figure of its trajectory; empty if that is not wanted.
    dof : dict
        Degrees of freedom of its NEES and NIS, which a trial that broke a rule has, too.
    """

    row: dict
    series: dict = field(default_factory=dict)
    trace: dict = field(default_factory=dict)
    dof: dict = field(default_factory=dict)


def measure(trial, decisions: dict, split: str = "test", traced: bool = False) -> Measured:
    """Compute all numbers of one trial.

    Parameters
    ----------
    trial : Trial
        As `amrmetrics.benchmark.logs.read_trial` returns it.
    decisions : dict
        The fields of a `Protocol`.
    split : str
        Of its scenario.
    traced : bool
        Whether its trajectory will be drawn.

    Returns
    -------
    Measured
        Its row of the table, and series for the figures.
    """
    row = empty_row(trial, decisions, split)
    found = Measured(row)
    if traced and trial.truth is not None:
        found.trace = {"truth": _thinned(trial.truth.poses)}
    if trial.estimate is None:
        return found
    skipped: dict[str, str] = {}
    try:
        pair, used = _matched(trial, decisions)
        error = ate(pair.reference, pair.estimate, decisions["align"])
    except AmrError as why:
        return _failed(found, "not measured", str(why))
    _cover(row, pair, trial.truth)
    _trajectory(row, skipped, pair, error, decisions)
    instants = _instants(pair, trial.truth)
    found.series["error"] = _at(error.series, instants)
    if traced:
        found.trace |= _trace(pair, error)
    for part in (_nees, _nis, _map, _closures, _latency):
        part(found, skipped, trial, pair, error.alignment, used, instants)
    _resources(row, trial.seconds)
    row["skipped"] = skipped
    return _judged(found, decisions)


def empty_row(entry, decisions, split):
    """Return the row of a trial that has no numbers."""
    row = {
        "system": entry.system,
        "scenario": entry.scenario,
        "split": split,
        "seed": entry.seed,
        "status": entry.status,
        "kind": entry.kind or "",
        "reason": _one_line(entry.reason),
    }
    return row | dict.fromkeys(columns(decisions)) | {"skipped": {}}


def _one_line(text):
    text = " ".join((text or "").encode("utf-8", "replace").decode().split())
    text = "".join(letter if letter.isprintable() else "?" for letter in text)
    return text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."


def _matched(trial, decisions):
    """Return the matched pair, and which of the estimates are in it."""
    truth, estimate = trial.truth, trial.estimate
    stamps = estimate.stamps
    if stamps is None and truth.stamps is not None and len(estimate.poses) <= len(truth.stamps):
        stamps = truth.stamps[: len(estimate.poses)]
    number = np.arange(len(estimate.poses))  # carried along, to find what belongs to a pose
    pair = match(
        Trajectory(truth.stamps, truth.poses),
        Trajectory(stamps, estimate.poses, frames=number),
        decisions["max_difference"],
    )
    return pair, pair.estimate.frames


def _failed(found, kind, reason):
    row = found.row
    for name, value in row.items():
        if value is not None and name not in KEPT:
            row[name] = None
    row |= {"status": "failed", "kind": kind, "reason": _one_line(reason), "skipped": {}}
    return found


KEPT = ("system", "scenario", "split", "seed", "coverage", "lost_seconds")


def _judged(found, decisions):
    """Hold a trial to the rules of the protocol."""
    row = found.row
    least, most = decisions["minimum_coverage"], decisions["maximum_ate"]
    if row["coverage"] < least:
        lost = f", {row['lost_seconds']:.4g} s are lost" if row["lost_seconds"] is not None else ""
        reason = (
            f"covers {100 * row['coverage']:.3g} % of the truth{lost}; minimum_coverage is "
            f"{100 * least:.3g} %"
        )
        return _failed(found, "rule", reason)
    if most is not None and row["ate"] > most:
        return _failed(found, "rule", f"ATE rmse {row['ate']:.4g} m; maximum_ate is {most:g} m")
    return found


def _cover(row, pair, truth):
    """Say how much of the truth has matched estimates: gaps count as lost, in any place."""
    row["path_length"] = float(path_length(pair.reference))
    duration = pair.coverage.reference_duration
    if truth.stamps is None or not duration > 0:
        row["coverage"] = pair.coverage.matched / pair.coverage.reference
        return
    stamps = pair.reference.stamps
    gaps = np.diff(np.concatenate([truth.stamps[:1], stamps, truth.stamps[-1:]]))
    limit = as_gap(None, stamps)
    lost = float(gaps[gaps > limit].sum())
    row["lost_seconds"] = lost
    row["coverage"] = 1 - lost / duration


def _trajectory(row, skipped, pair, error, decisions):
    row["ate"] = error.rmse
    row["ate_max"] = error.max
    if "scale" in row:
        row["scale"] = error.alignment.scale
    row["drift_percent"] = 100 * error.rmse / row["path_length"] if row["path_length"] else None
    if row["drift_percent"] is None:
        skipped["drift"] = "the truth does not move"
    p, q = pair
    if not p.poses.ndim == q.poses.ndim == 3:
        why = next(x.why_no_orientation for x in (p, q) if x.why_no_orientation)
        skipped["rotation and RPE"] = why
        return
    row["ate_rotation_deg"] = float(np.degrees(error.rotation.rmse))
    for delta, unit in decisions["deltas"]:
        name = f"rpe_{delta:g}{unit}"
        try:
            relative = rpe(p, q, delta, unit)
        except AmrError as why:
            skipped[name] = str(why)
            continue
        row[name] = relative.translation.rmse
        row[f"{name}_deg"] = float(np.degrees(relative.rotation.rmse))


def _instants(pair, truth):
    """Return for each instant of the truth the matched sample there, -1 where none is near."""
    parts = np.arange(1, INSTANTS + 1) / INSTANTS
    n = len(pair)
    stamps = pair.reference.stamps
    if truth.stamps is None or stamps is None or n == 1:
        return np.minimum((parts * n).astype(int), n - 1)
    wanted = truth.stamps[0] + parts * (truth.stamps[-1] - truth.stamps[0])
    after = np.clip(np.searchsorted(stamps, wanted), 1, n - 1)
    nearer = wanted - stamps[after - 1] <= stamps[after] - wanted
    k = np.where(nearer, after - 1, after)
    return np.where(np.abs(stamps[k] - wanted) <= as_gap(None, stamps), k, -1)


def _at(values, instants):
    return np.where(instants >= 0, values[instants], np.nan)


def _nees(found, skipped, trial, pair, _alignment, used, instants):
    P = trial.estimate.covariances
    if P is None:
        skipped["NEES"] = "the system hands in no covariances"
        return
    try:
        # Not aligned: a covariance speaks about the filter's own frame.
        errors = pose_errors(pair.reference, pair.estimate)
        values = _nees_where_defined(errors, np.asarray(P)[used], skipped)
    except (AmrError, IndexError) as why:
        skipped["NEES"] = _one_line(str(why))
        return
    found.dof["nees_dof"] = errors.shape[1]
    found.row |= {"anees": float(np.nanmean(values)), "nees_dof": errors.shape[1]}
    found.series["nees"] = _at(values, instants)
    last = float(found.series["nees"][-1])
    if last == last:
        found.row["nees_end"] = last
    else:
        skipped["nees_end"] = "no estimate with a covariance at the end of the run"


def _nees_where_defined(errors, P, skipped):
    """Return the NEES, nan where a covariance is singular, as at a start that is known."""
    try:
        return nees(errors, P)
    except AmrError:
        smallest = np.linalg.eigvalsh(P)[:, 0]
        regular = smallest > P.shape[1] * np.finfo(float).eps * np.abs(P).max(axis=(1, 2))
        if regular.all() or not regular.any():
            raise
        values = np.full(len(P), np.nan)
        values[regular] = nees(errors[regular], P[regular])
        few = len(P) - int(regular.sum())
        skipped["NEES of some poses"] = f"{few} of {len(P)} covariances are singular"
        return values


def _nis(found, skipped, trial, _pair, _alignment, _used, _instants_):
    innovations, S = trial.estimate.innovations, trial.estimate.innovation_covariances
    if innovations is None or S is None or not len(innovations):
        skipped["NIS"] = "the system hands in no innovations"
        return
    try:
        values = nis(innovations, S)
    except AmrError as why:
        skipped["NIS"] = _one_line(str(why))
        return
    dof = np.shape(innovations)[1]
    test = consistency_test(values, dof)
    found.dof["nis_dof"] = dof
    found.row |= {"anis": test.mean, "nis_dof": dof}
    part = np.arange(len(values)) * INSTANTS // len(values)
    found.series["nis_sum"] = np.bincount(part, values, INSTANTS)
    found.series["nis_count"] = np.bincount(part, minlength=INSTANTS).astype(float)
    found.series["nis_total"] = np.array([test.mean * test.n, test.n, test.n_effective])


def _map(found, skipped, trial, _pair, alignment, _used, _instants_):
    landmarks, points = trial.truth.landmarks, trial.estimate.map_points
    if landmarks is None or not len(landmarks):
        skipped["map"] = "the truth has no landmarks"
        return
    if points is None:
        skipped["map"] = "the system hands in no map"
        return
    landmarks, points = np.asarray(landmarks, float), np.asarray(points, float)
    seen = np.isfinite(points).all(axis=-1)
    if not seen.any():
        skipped["map"] = "the map is empty"
        return
    try:
        mapped = alignment.apply(points[seen])
        found.row["map_chamfer"] = chamfer(landmarks, mapped).value
    except AmrError as why:
        skipped["map"] = _one_line(str(why))
        return
    if points.shape != landmarks.shape:
        skipped["map_rmse"] = "points of the map are not numbered like the landmarks"
        return
    off = mapped - landmarks[seen]
    found.row["map_rmse"] = float(np.sqrt((off**2).sum(axis=1).mean()))
    found.row["map_found"] = float(seen.mean())


def _closures(found, skipped, trial, _pair, _alignment, _used, _instants_):
    labels, accepted = trial.truth.labels, trial.estimate.accepted
    if labels is None:
        skipped["closures"] = "the truth does not say which closures are true"
        return
    if accepted is None:
        skipped["closures"] = "the system hands in no closures"
        return
    labels, accepted = np.asarray(labels, bool), np.asarray(accepted, bool)
    if labels.shape != accepted.shape:
        skipped["closures"] = f"{len(accepted)} closures for {len(labels)} candidates"
        return
    if not len(labels):
        skipped["closures"] = "nothing was proposed"
        return
    row, right = found.row, int((labels & accepted).sum())
    row["false_closures"] = int((~labels & accepted).sum())
    if accepted.any():
        row["closure_precision"] = right / int(accepted.sum())
    else:
        skipped["closure_precision"] = "no closure was accepted"
    if labels.any():
        row["closure_recall"] = right / int(labels.sum())
    else:
        skipped["closure_recall"] = "no candidate is a true closure"
    _ranking(found, skipped, labels, trial.estimate.closure_scores)


def _ranking(found, skipped, labels, scores):
    if scores is None:
        skipped["average_precision"] = "the system hands in no scores of closures"
        return
    try:
        curve = precision_recall(labels, scores)
    except AmrError as why:
        skipped["average_precision"] = _one_line(str(why))
        return
    if not labels.any():
        skipped["average_precision"] = curve.undefined["average_precision"]
        return
    found.row["average_precision"] = curve.average_precision
    # The first threshold that reaches a recall; a hair, for 3 of 5 is not quite 0.6.
    first = np.searchsorted(curve.recall, RECALLS - 1e-12)
    found.series["precision"] = curve.precision[first]


def _latency(found, skipped, trial, _pair, _alignment, _used, _instants_):
    seconds = trial.estimate.frame_seconds
    if seconds is None or not len(seconds):
        skipped["latency"] = "the system hands in no times of frames"
        return
    seconds = np.asarray(seconds, float)
    if not (np.isfinite(seconds).all() and seconds.min() >= 0):
        skipped["latency"] = "a time of a frame is negative or no number"
        return
    median, p95, p99 = (1e3 * float(x) for x in np.percentile(seconds, (50, 95, 99)))
    found.row |= {"latency_median_ms": median, "latency_p95_ms": p95, "latency_p99_ms": p99}
    shortest = 1e-9  # a clock that stands still has told of less than this
    kind = np.ceil(PER_DECADE * np.log10(np.maximum(seconds, shortest))).astype(int)
    kinds, counts = np.unique(kind, return_counts=True)
    found.series["frames"] = np.array([kinds, counts])


def _resources(row, seconds):
    row["wall_seconds"] = seconds.get("wall")
    row["peak_megabytes"] = seconds["peak"] / 1e6 if "peak" in seconds else None


def _trace(pair, error):
    moved = error.alignment.apply(pair.estimate.positions)
    kept = _kept(len(moved))
    return {"estimate": moved[kept, :2], "ate": error.rmse}


def _kept(n):
    return np.unique(np.linspace(0, n - 1, min(n, DRAWN)).astype(int))


def _thinned(poses):
    positions = poses if poses.ndim == 2 else poses[:, :-1, -1]
    return positions[_kept(len(positions)), :2]
