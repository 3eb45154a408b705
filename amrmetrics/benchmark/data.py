"""What a benchmark is made of: scenarios, systems, and what they hand to each other."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np


@dataclass(frozen=True, eq=False)
class SensorLog:
    """What a robot recorded: all that a system is given, and nothing of the truth.

    Attributes
    ----------
    stamps : (T+1,) array
        Seconds, of the poses to be estimated; the first is the start.
    odometry : (T, 2) array
        Measured speed (m/s) and turn rate (rad/s) between two stamps.
    odometry_std : (2,) array
        Standard deviations of its noise, as the data sheet has them.
    sightings : (K,) structured array
        Landmarks as seen: ``step`` (index into `stamps`, increasing), ``landmark`` (its number),
        ``range`` (m) and ``bearing`` (rad, from the robot's x axis, in [-pi, pi)).
    sighting_std : (2,) array
        Standard deviations of range (m) and bearing (rad).
    landmarks : (L, 2) array
        The map that was surveyed beforehand, meters. A system that does SLAM does not look at it.
    prior : (3,) array
        Where the robot believes to start: x, y, heading (m, m, rad), world frame.
    prior_covariance : (3, 3) array
        Of the errors of `prior`.
    candidates : (M, 2) array of int
        Proposed loop closures: indices i < j into `stamps`.
    closures : (M, 3, 3) array
        Measured pose of j in the frame of i, for each candidate.
    closure_information : (3, 3) array
        Inverse covariance of a true closure's error; 1/m^2, 1/rad^2.
    scores : (M,) array
        How sure the place recognition is of each candidate, in (0, 1).
    seed : int
        For a system that needs random numbers.
    """

    stamps: np.ndarray
    odometry: np.ndarray
    odometry_std: np.ndarray
    sightings: np.ndarray
    sighting_std: np.ndarray
    landmarks: np.ndarray
    prior: np.ndarray
    prior_covariance: np.ndarray
    candidates: np.ndarray
    closures: np.ndarray
    closure_information: np.ndarray
    scores: np.ndarray
    seed: int


@dataclass(frozen=True, eq=False)
class Truth:
    """What happened; no system sees it.

    Attributes
    ----------
    stamps : (N,) array
        Seconds.
    poses : (N, d+1, d+1) array
        World frame, meters, d = 2 or 3.
    landmarks : (L, 2) array, optional
        True positions, world frame, meters.
    labels : (M,) bool array, optional
        Which candidates are true closures.
    """

    stamps: np.ndarray
    poses: np.ndarray
    landmarks: np.ndarray | None = None
    labels: np.ndarray | None = None


@dataclass(frozen=True, eq=False)
class Estimate:
    """What a system hands in. Only `poses` is needed; a metric without its data says so.

    Attributes
    ----------
    poses : (N, d+1, d+1) array
        World frame, meters.
    stamps : (N,) array, optional
        Seconds; those of the log, from its start on, if not given. A system that lost track
        leaves poses out.
    covariances : (N, n, n) array, optional
        Of the errors of each pose, n = 3 or 6, as `amrmetrics.pose_errors` has them.
    innovations, innovation_covariances : (K, m) and (K, m, m) array, optional
        Measured minus predicted, and the S that the filter claims.
    map_points : (L, 2) array, optional
        Landmarks as mapped, in the frame of `poses`; nan where one was never seen.
    accepted : (M,) bool array, optional
        Which candidates the system took for closures at the end.
    closure_scores : (M,) array, optional
        How sure the system is of each candidate at the end, such as the weight of a robust
        kernel; the larger, the surer.
    frame_seconds : (F,) array, optional
        Computing time of each frame. Times are measured and differ from run to run: they are
        kept apart from everything else.
    """

    poses: np.ndarray
    stamps: np.ndarray | None = None
    covariances: np.ndarray | None = None
    innovations: np.ndarray | None = None
    innovation_covariances: np.ndarray | None = None
    map_points: np.ndarray | None = None
    accepted: np.ndarray | None = None
    closure_scores: np.ndarray | None = None
    frame_seconds: np.ndarray | None = None


@dataclass(frozen=True)
class Scenario:
    """A world to drive through, as often as there are seeds.

    Attributes
    ----------
    name : str
        Short; letters, digits, "_" and "-".
    make : callable
        ``make(rng, **settings)`` returns ``(SensorLog, Truth)``, all randomness from `rng`.
    settings : dict
        Numbers and text for `make`; they stand in the protocol.
    split : str
        "test", or "tuning" where parameters were chosen on it: never part of a result.
    description : str
        One sentence for the report.
    """

    name: str
    make: Callable
    settings: dict[str, Any] = field(default_factory=dict)
    split: str = "test"
    description: str = ""


@dataclass(frozen=True)
class System:
    """Something that turns a sensor log into an estimate.

    Attributes
    ----------
    name : str
        Short; letters, digits, "_" and "-".
    run : callable
        ``run(log, **settings)`` returns an `Estimate`.
    settings : dict
        Numbers and text for `run`; they stand in the protocol.
    description : str
        One sentence for the report.
    """

    name: str
    run: Callable
    settings: dict[str, Any] = field(default_factory=dict)
    description: str = ""


@dataclass(frozen=True)
class Protocol:
    """The decisions that are taken before the first trial.

    Attributes
    ----------
    align : str
        Of the ATE: "rigid", "similarity", "yaw", "none" or "origin".
    max_difference : float
        Seconds between stamps that are matched.
    deltas : tuple of (float, str)
        Stretches of the RPE.
    minimum_coverage : float
        A trial that matches less of the truth has failed, in [0, 1].
    maximum_ate : float or None
        A trial whose ATE rmse is larger, meters, has failed; None: accuracy is no reason to fail.
    time_limit : float
        Seconds of wall clock that a trial may take.
    memory_limit : float
        Bytes that a trial may take, where the operating system can hold it to that.
    metric : str
        The number that decides: a name of the table's columns. All others are secondary.
    better : str
        "lower" or "higher".
    failures : str
        How a failed trial counts, as in `amrmetrics.compare_paired`: "worst" or "separate".
    statistic : str
        What a table shows of many trials: "mean", "median" or "p95".
    confidence : float
        Of all intervals and of the family of all pairwise verdicts, after Holm.
    calibration : str
        Where noise levels, extrinsics and intrinsics came from.
    synchronization : str
        How clocks were brought together.
    """

    align: str = "rigid"
    max_difference: float = 0.01
    deltas: tuple = ((1, "s"), (10, "m"))
    minimum_coverage: float = 0.9
    maximum_ate: float | None = None
    time_limit: float = 60.0
    memory_limit: float = 4e9
    metric: str = "ate"
    better: str = "lower"
    failures: str = "worst"
    statistic: str = "median"
    confidence: float = 0.95
    calibration: str = "the simulator's noise levels, known to all systems"
    synchronization: str = "one clock; nearest stamps"
