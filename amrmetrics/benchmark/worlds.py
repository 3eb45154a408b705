"""The worlds of the default benchmark: where a robot drives, and what it measures there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from amrmetrics._arguments import as_count, as_generator, as_size
from amrmetrics.benchmark.data import Scenario, SensorLog, Truth
from amrmetrics.errors import AmrError
from amrmetrics.poses import planar_poses, relative, wrap
from amrmetrics.simulation.city import ALIASED, LOOKS, TRUE, UNLIKE
from amrmetrics.simulation.filters import measurement_model, motion_model

if TYPE_CHECKING:
    from amrmetrics._types import ArrayLike

# Corners that the robot drives to, one after the other and over again, meters.
COURSES = {
    "rectangle": ((30, 0), (30, 20), (0, 20), (0, 0)),
    "corridor": ((45, 0), (0, 0)),
    "tour": ((70, -10), (120, 30), (110, 80), (60, 60), (30, 90), (-20, 60), (-10, 20), (0, 0)),
    "blocks": ((20, 0), (20, 20), (40, 20), (40, 0), (20, 0), (20, 20), (0, 20), (0, 0)),
    "yard": ((25, 5), (15, 15), (30, 25), (5, 30), (0, 0)),
}
JITTER = 1.0  # m, standard deviation of each corner
REACHED = 1.5  # m from a corner: on to the next
FASTEST_TURN = 0.8  # rad/s
GAP = 30  # steps between two visits that count as a loop
SAME_PLACE = 1.5  # m between two poses that see the same place
OTHER_PLACE = 5.0  # m between two poses that surely do not
CELL = 4.0  # m, side of what has one look
TRIES = 1000  # to place a landmark beside its part of the path

SIGHTING = np.dtype(
    [("step", np.int64), ("landmark", np.int64), ("range", float), ("bearing", float)]
)


def make(
    rng: np.random.Generator,
    *,
    course: str = "rectangle",
    steps: int = 400,
    dt: float = 0.5,
    speed: float = 1.0,
    landmarks: int = 24,
    aside: ArrayLike = (1.5, 5.0),
    max_range: float = 8.0,
    detection: float = 0.5,
    closures: int = 40,
    aliased: int = 0,
    unlike: int = 40,
    alias_score: float = ALIASED,
    odometry_std: ArrayLike = (0.05, 0.015),
    sighting_std: ArrayLike = (0.15, 0.02),
    prior_std: ArrayLike = (0.2, 0.2, 0.03),
    closure_std: ArrayLike = (0.15, 0.15, 0.02),
    blind: ArrayLike = (0.0, 0.0),
    slip_std: ArrayLike = (0.0, 0.0),
) -> tuple[SensorLog, Truth]:
    """Drive a course past landmarks, and measure.

    Each call draws the corners of the course (1 m around their places), the speed, the
    landmarks, all noise and all proposed closures anew.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of all randomness.
    course : {"rectangle", "corridor", "tour", "blocks", "yard"}
        Where the robot drives, round after round: `COURSES`.
    steps : int
        Number of steps T; the log has T + 1 poses.
    dt : float
        Duration of a step, seconds.
    speed : float
        Of the robot on straight stretches, m/s.
    landmarks : int
        Their number L, at least 1.
    aside : (2,) array
        Least and largest distance of a landmark from the path, meters.
    max_range : float
        Landmarks beyond it are not seen, meters.
    detection : float
        Probability that a landmark in range is seen in a step, in (0, 1].
    closures : int
        Number of true candidates, if the drive has so many: pairs of poses within 1.5 m,
        at least 30 steps apart.
    aliased : int
        Number of false candidates between places that look alike: poses more than 5 m
        apart in cells of 4 m that drew the same of six looks.
    unlike : int
        Number of false candidates between places that do not, with low scores.
    alias_score : float
        Mean log-odds of the scores of aliased candidates; those of true ones have mean 2,
        those of unlike ones -2, and all have standard deviation 1.
    odometry_std, sighting_std, prior_std, closure_std : array
        Standard deviations of the noise: m/s and rad/s; m and rad; m, m, rad; m, m, rad.
    blind : (2,) array
        From which to which part of the drive, in [0, 1], nothing is sighted or recognized.
    slip_std : (2,) array
        Standard deviations of what is added in that part to the measured speed, as a part of
        it, and to the turn rate (rad/s): one draw for the whole part. No system is told.

    Returns
    -------
    log : SensorLog
        For the systems. Candidates in the order of the pose that sees the place again.
    truth : Truth
        For the judge.

    Raises
    ------
    AmrError
        If a setting is out of range.

    References
    ----------
    Motion and measurement models: Thrun, Burgard and Fox, Probabilistic Robotics (2005),
    chapters 5 and 6. Look-alike cells: `amrmetrics.simulation.city_run`.

    Examples
    --------
    >>> import numpy as np
    >>> from amrmetrics.benchmark import worlds
    >>> log, truth = worlds.make(np.random.default_rng(1), steps=300, aliased=5)
    >>> log.odometry.shape, truth.poses.shape, int(truth.labels.sum()), len(log.candidates)
    ((300, 2), (301, 3, 3), 40, 85)
    """
    rng = as_generator(rng)
    if course not in COURSES:
        raise AmrError(f"course is {course!r}; expected one of {', '.join(COURSES)}.")
    steps, landmarks = as_count(steps, "steps"), as_count(landmarks, "landmarks")
    dt, speed = float(as_size(dt, "dt")), float(as_size(speed, "speed"))
    aside = as_size(aside, "aside", (2,))
    blind = as_size(blind, "blind", (2,), sign=">= 0")
    for name, (first, last) in (("aside", aside.tolist()), ("blind", blind.tolist())):
        if first > last:
            raise AmrError(f"{name} runs from {first:g} to {last:g}; give the smaller one first.")
    odometry_std = as_size(odometry_std, "odometry_std", (2,))
    sighting_std = as_size(sighting_std, "sighting_std", (2,))
    prior_std = as_size(prior_std, "prior_std", (3,))
    closure_std = as_size(closure_std, "closure_std", (3,))
    slip_std = as_size(slip_std, "slip_std", (2,), sign=">= 0")

    corners = np.array(COURSES[course], dtype=float)
    corners += JITTER * rng.normal(size=corners.shape)
    states, controls = _drive(corners, speed * rng.uniform(0.9, 1.1), steps, dt)
    truth = planar_poses(states[:, :2], states[:, 2])
    dark = _dark(blind, steps)
    odometry = controls + odometry_std * rng.normal(size=controls.shape)
    slip = slip_std * rng.normal(size=2)
    odometry[dark[1:], 0] *= 1 + slip[0]
    odometry[dark[1:], 1] += slip[1]
    places = _landmarks(rng, states[:, :2], landmarks, aside)
    candidates, closures_seen, labels, scores = _candidates(
        rng, truth, dark, (closures, aliased, unlike), alias_score, closure_std
    )
    log = SensorLog(
        stamps=dt * np.arange(steps + 1),
        odometry=odometry,
        odometry_std=odometry_std,
        sightings=_sightings(rng, states, places, dark, max_range, detection, sighting_std),
        sighting_std=sighting_std,
        landmarks=places,
        prior=states[0] + prior_std * rng.normal(size=3),
        prior_covariance=np.diag(prior_std**2),
        candidates=candidates,
        closures=closures_seen,
        closure_information=np.diag(closure_std**-2.0),
        scores=scores,
        seed=int(rng.integers(2**31)),
    )
    return log, Truth(log.stamps, truth, places, labels)


def scenarios() -> tuple[Scenario, ...]:
    """Return the seven default scenarios: six to test on, one to tune on.

    Returns
    -------
    tuple of Scenario
        loop, corridor, outdoor, sparse, aliasing, dropout; and yard, where the thresholds
        of the default systems were chosen.

    Examples
    --------
    >>> from amrmetrics.benchmark import worlds
    >>> [scenario.name for scenario in worlds.scenarios() if scenario.split == "tuning"]
    ['yard']
    """
    return (
        Scenario(
            "loop",
            make,
            {"course": "rectangle"},
            description="Two rounds of a rectangle; landmarks and true closures everywhere.",
        ),
        Scenario(
            "corridor",
            make,
            {
                "course": "corridor",
                "landmarks": 20,
                "aside": [1.5, 2.5],
                "max_range": 6.0,
                "aliased": 1,
            },
            description="Up and down a corridor in which two places look alike.",
        ),
        Scenario(
            "outdoor",
            make,
            {
                "course": "tour",
                "steps": 1500,
                "speed": 1.5,
                "landmarks": 60,
                "aside": [2.0, 12.0],
                "max_range": 20.0,
                "detection": 0.3,
                "closures": 60,
            },
            description="More than a kilometer outdoors, two and a half rounds.",
        ),
        Scenario(
            "sparse",
            make,
            {"course": "rectangle", "landmarks": 4, "detection": 0.3},
            description="Four landmarks on a whole rectangle, seldom seen.",
        ),
        Scenario(
            "aliasing",
            make,
            {"course": "blocks", "aliased": 20, "alias_score": TRUE},
            description="Blocks that look alike: false closures, proposed as surely as true ones.",
        ),
        Scenario(
            "dropout",
            make,
            {"course": "rectangle", "blind": [0.4, 0.5], "slip_std": [0.1, 0.003]},
            description="Twenty seconds without sight while the wheels slip.",
        ),
        Scenario(
            "yard",
            make,
            {"course": "yard", "aliased": 1},
            split="tuning",
            description="A yard, where thresholds are chosen.",
        ),
    )


def _drive(corners, speed, steps, dt):
    """Return states (T+1, 3) and controls (T, 2) of a robot that steers towards the corners."""
    states, controls = np.zeros((steps + 1, 3)), np.empty((steps, 2))
    states[0, 2] = np.arctan2(corners[0, 1], corners[0, 0])
    goal = 0
    for k in range(steps):
        dx, dy = corners[goal] - states[k, :2]
        if np.hypot(dx, dy) < REACHED:
            goal = (goal + 1) % len(corners)
            dx, dy = corners[goal] - states[k, :2]
        off = wrap(np.arctan2(dy, dx) - states[k, 2])
        turn = min(max(off / (2 * dt), -FASTEST_TURN), FASTEST_TURN)
        controls[k] = speed * max(np.cos(off), 0.3), turn
        states[k + 1] = motion_model(states[k], controls[k], dt)[0]
    return states, controls


def _dark(blind, steps):
    """Return for each pose if the robot is blind there."""
    start, end = blind
    part = np.arange(steps + 1) / steps
    return (part >= start) & (part < end)


def _landmarks(rng, path, count, aside):
    """Return positions (L, 2) beside the path, spread along it."""
    found = []
    for k in range(count):
        for tried in range(TRIES):
            # Between two lanes there may be no room; then it goes somewhere else.
            part = k if tried < TRIES // 2 else rng.integers(count)
            near = path[int((part + rng.uniform()) / count * (len(path) - 1))]
            direction, distance = rng.uniform(-np.pi, np.pi), rng.uniform(*aside)
            place = near + distance * np.array([np.cos(direction), np.sin(direction)])
            if np.hypot(*(path - place).T).min() >= aside[0]:
                found.append(place)
                break
        else:
            raise AmrError(
                f"aside is {aside.tolist()}; no place beside the path is so far from it."
            )
    return np.array(found)


def _sightings(rng, states, places, dark, max_range, detection, std):
    """Return what is seen from all poses but the first."""
    exact = measurement_model(states[1:, None], places)[0]
    seen = (exact[..., 0] <= max_range) & (rng.uniform(size=exact.shape[:2]) < detection)
    seen &= ~dark[1:, None]
    noisy = exact + std * rng.normal(size=exact.shape)
    step, landmark = np.nonzero(seen)
    sightings = np.empty(len(step), dtype=SIGHTING)
    sightings["step"], sightings["landmark"] = step + 1, landmark
    sightings["range"], sightings["bearing"] = noisy[seen, 0], wrap(noisy[seen, 1])
    return sightings


def _candidates(rng, truth, dark, wanted, alias_score, std):
    """Return pairs (M, 2), measured poses (M, 3, 3), labels and scores, ordered by j."""
    xy = truth[:, :2, 2]
    i, j = np.triu_indices(len(xy), GAP)
    open_eyed = ~(dark[i] | dark[j])
    i, j = i[open_eyed], j[open_eyed]
    distance = np.hypot(*(xy[i] - xy[j]).T)
    cells = np.floor(xy / CELL).astype(int)
    cells -= cells.min(axis=0)
    look = rng.integers(LOOKS, size=cells.max(axis=0) + 1)[tuple(cells.T)]
    alike, far = look[i] == look[j], distance > OTHER_PLACE
    kinds = (distance < SAME_PLACE, alike & far, ~alike & far)
    chosen = [
        rng.permutation(np.flatnonzero(kind))[: as_count(count, "candidates", least=0)]
        for kind, count in zip(kinds, wanted, strict=True)
    ]
    counts = [len(kind) for kind in chosen]
    log_odds = np.repeat([TRUE, alias_score, UNLIKE], counts) + rng.normal(size=sum(counts))
    labels = np.repeat([True, False, False], counts)
    chosen = np.concatenate(chosen)
    pairs = np.column_stack([i[chosen], j[chosen]])
    # A false candidate claims a place as near as that of a true one.
    near = rng.uniform(-1, 1, size=(len(pairs), 2))
    error = std * rng.normal(size=(len(pairs), 3))
    seen = np.empty((0, 3, 3))
    if len(pairs):
        seen = relative(truth[pairs[:, 0]], truth[pairs[:, 1]])
        seen[~labels, :2, 2] = near[~labels]
        seen = seen @ planar_poses(error[:, :2], error[:, 2])
    order = np.lexsort((pairs[:, 0], pairs[:, 1]))
    scores = 1 / (1 + np.exp(-log_odds))
    return pairs[order], seen[order], labels[order], scores[order]
