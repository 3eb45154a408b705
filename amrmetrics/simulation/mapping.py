"""A robot that maps a building with a range scanner (lectures 05 and 06).

The scans are cast against the walls themselves, which know nothing of cells; the grid is the
mapper's idea.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from amrmetrics._arguments import as_count, as_generator, as_poses, as_size
from amrmetrics.errors import AmrError
from amrmetrics.poses import planar_poses

CELL = 0.1  # m
ORIGIN = (-0.45, -0.45)  # m; puts the straight walls in the middle of cells
SHAPE = (99, 129)  # rows y, columns x
MAX_RANGE = 6.0  # m
FIELD_OF_VIEW = np.radians(270)
SPEED = 0.5  # m/s
SPACING = 0.05  # m, of the reference points

# Lines through the corners, meters: all that is too thin to have an inside.
LINES = (
    ((0, 0), (12, 0), (12, 9), (1.6, 9), (0, 7.4), (0, 0)),  # outside walls
    ((0, 2.2), (2.4, 2.2)),  # corridor, with a door to either room
    ((3.6, 2.2), (8.9, 2.2)),
    ((10.1, 2.2), (12, 2.2)),
    ((6.5, 2.2), (6.5, 5.4)),  # between the rooms, with a door
    ((6.5, 6.6), (6.5, 9)),
    ((3.6, 2.2), (4.05, 3.2)),  # an open door
)
# Corners of furniture, counterclockwise, meters.
THINGS = (
    ((5.4, 0.0), (6.6, 0.0), (6.6, 0.3), (5.4, 0.3)),
    ((0.0, 4.2), (0.6, 4.2), (0.6, 6.0), (0.0, 6.0)),
    ((3.3, 7.6), (5.1, 7.6), (5.1, 8.4), (3.3, 8.4)),
    ((10.7, 6.9), (11.5, 7.4), (11.0, 8.2), (10.2, 7.7)),
    ((11.2, 3.2), (12.0, 3.2), (12.0, 4.8), (11.2, 4.8)),
)
SEGMENTS = np.array(
    [pair for line in (*LINES, *(c + c[:1] for c in THINGS)) for pair in pairwise(line)]
)
# What is round, meters: a table, a pillar, a bin.
CENTERS = np.array([(4.9, 4.4), (8.0, 4.0), (7.2, 8.3)])
RADII = np.array([0.6, 0.25, 0.3])

# The lap leads counterclockwise around this rectangle, at this distance, meters.
CORNERS = np.array([(4, 2.1), (8.5, 2.1), (8.5, 5), (4, 5), (4, 2.1)])
DISTANCE = 1.0


class Scans(NamedTuple):
    """What a range scanner saw on one lap, and the building that it was in.

    Attributes
    ----------
    stamps : (T,) array
        Seconds.
    truth : (T, 3, 3) array
        True poses of the robot in the world frame; the scanner is its origin.
    bearings : (B,) array
        Directions of the beams in the robot's frame, radians, from its x axis.
    ranges : (T, B) array
        Measured distances, meters; inf where a beam met nothing within `max_range`.
    max_range : float
        Meters.
    occupied : (H, W) bool array
        The true grid; rows are y, columns are x. A cell is occupied if a wall runs through
        it or if it touches a thing.
    cell : float
        Edge of a cell, meters.
    origin : (2,) array
        x and y of the outer corner of cell [0, 0] in the world frame, meters.
    surface : (M, 2) array
        Points on the true surfaces, every 5 cm, that were in sight of the scanner at least
        once on this lap; world frame, meters.
    """

    stamps: np.ndarray
    truth: np.ndarray
    bearings: np.ndarray
    ranges: np.ndarray
    max_range: float
    occupied: np.ndarray
    cell: float
    origin: np.ndarray
    surface: np.ndarray

    @property
    def extent(self):
        """Left, right, bottom and top border of the grid, meters, as `imshow` wants them."""
        (x, y), (height, width) = self.origin, self.occupied.shape
        return x, x + width * self.cell, y, y + height * self.cell


def scan_room(rng, steps=120, beams=91, noise=0.02, outliers=0.0):
    """Drive one lap through two rooms and a corridor, and scan.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of all noise.
    steps : int
        Number of scans T, at equal distances on the lap of 21 m, >= 1.
    beams : int
        Number of beams B, at equal angles over 270 degrees, >= 1.
    noise : float
        Standard deviation of a range, meters, in [0, 0.1].
    outliers : float
        Part of the readings, in [0, 1], that have nothing to do with the building: any
        range up to `max_range` is equally likely. Not known to the mapper.

    Returns
    -------
    Scans
        The readings, and the truth about robot and building.

    Raises
    ------
    AmrError
        If `rng` is no generator, a number is no positive count, or `noise` or `outliers`
        is out of range.

    Notes
    -----
    The robot moves at 0.5 m/s, and a scan takes no time. Ranges have independent errors;
    bearings have none. A mapper knows bearings, ranges, `max_range` and what it believes of
    its poses; it knows neither the building nor `noise` and `outliers`.

    References
    ----------
    Lecture 05. Thrun, Burgard and Fox, Probabilistic Robotics (2005), section 6.3.1: of the
    four kinds of error there, this has the noise of a hit, random readings, and no return
    beyond `max_range`.

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> scans = am.simulation.scan_room(np.random.default_rng(5))
    >>> scans.ranges.shape, scans.occupied.shape
    ((120, 91), (99, 129))
    """
    as_generator(rng)
    steps, beams = as_count(steps, "steps"), as_count(beams, "beams")
    noise, outliers = as_size(noise, "noise", sign=">= 0"), as_size(outliers, "outliers", sign="")
    if noise > 0.1:
        raise AmrError(f"noise is {noise:g} m; expected at most 0.1 m: walls are 0.6 m away.")
    if not 0 <= outliers <= 1:
        raise AmrError(f"outliers is {outliers:g}; expected a part of the readings, in [0, 1].")

    stamps, truth = _lap(steps)
    bearings = (np.arange(beams) - (beams - 1) / 2) * FIELD_OF_VIEW / beams
    ranges = np.stack([_cast(*_rays(pose, bearings)) for pose in truth])
    ranges += noise * rng.standard_normal(ranges.shape)
    random = rng.random(ranges.shape) < outliers
    ranges[random] = rng.uniform(0, MAX_RANGE, random.sum())
    ranges[ranges > MAX_RANGE] = np.inf
    return Scans(
        stamps, truth, bearings, ranges, MAX_RANGE, _true_grid(), CELL, np.array(ORIGIN),
        _seen(_surface(), truth),
    )  # fmt: skip


def occupancy_grid(scans, poses=None, hit=0.7, miss=0.35):
    """Map by adding up log-odds, cell by cell, as if all scans were independent.

    Parameters
    ----------
    scans : Scans
        From `scan_room`. The mapper uses bearings, ranges, `max_range` and the grid's place.
    poses : (T, 3, 3) array, optional
        Where the mapper believes the robot was, world frame; the true poses by default.
    hit : float
        Believed probability of "occupied" for the cell in which a beam ends, from this one
        scan; in (1/2, 1).
    miss : float
        The same for a cell that beams only pass, in (0, 1/2).

    Returns
    -------
    (H, W) array
        Log-odds of "occupied", natural logarithm; 1 / (1 + exp(-logits)) are probabilities.
        Exactly 0 where no beam has been.

    Raises
    ------
    AmrError
        If `scans` does not come from `scan_room`, `poses` are not as many planar poses as
        scans, or `hit` or `miss` is out of range.

    Notes
    -----
    A scan changes a cell once, however many of its beams cross it: they share the pose and
    the surface, so the second says little that the first did not. If beams of one scan both
    end in a cell and pass it, it counts as hit. Nothing is said of cells behind a hit, and
    beams without return only pass, up to `max_range`.

    Scans are not independent either: neighbors on the lap see the same surface from nearly
    the same place, where it lies in the cell in the same way. Each adds its log-odds all the
    same, right or wrong; a `hit` and `miss` near 1/2 are the mapper's only protection.

    If `hit` + `miss` = 1, as many hits as misses bring a cell back to exactly 0, too.

    References
    ----------
    Lecture 05. Thrun, Burgard and Fox (2005), tables 9.1 and 9.2, with prior 1/2 and a wall
    as thick as the cell; there, the beam nearest in bearing decides for its scan. Moravec and
    Elfes, High resolution maps from wide angle sonar (ICRA 1985).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> scans = am.simulation.scan_room(np.random.default_rng(5))
    >>> logits = am.simulation.occupancy_grid(scans)
    >>> c = am.confusion(scans.occupied, 1 / (1 + np.exp(-logits)), unknown=logits == 0)
    >>> round(c.iou, 1), round(c.accuracy, 2)
    (0.8, 0.99)
    """
    poses = _believed(scans, poses)
    hit, miss = as_size(hit, "hit", sign=""), as_size(miss, "miss", sign="")
    if not 0 < miss < 0.5 < hit < 1:
        raise AmrError(f"hit is {hit:g} and miss {miss:g}; expected 0 < miss < 1/2 < hit < 1.")
    logits = np.zeros(scans.occupied.shape)
    for pose, ranges in zip(poses, scans.ranges, strict=True):
        origin, direction = _rays(pose, scans.bearings)
        start = (origin - scans.origin) / scans.cell
        end = start + direction * np.minimum(ranges, scans.max_range)[:, None] / scans.cell
        update = np.zeros(logits.shape)
        _mark(update, _crossed(start, end), np.log(miss / (1 - miss)))
        _mark(update, end[np.isfinite(ranges)], np.log(hit / (1 - hit)))
        logits += update
    return logits


def point_map(scans, poses=None):
    """Return the end points of all beams that met something.

    Parameters
    ----------
    scans : Scans
        From `scan_room`.
    poses : (T, 3, 3) array, optional
        Where the mapper believes the robot was, world frame; the true poses by default.

    Returns
    -------
    (K, 2) array
        Meters, in the world frame of `poses`, scan after scan; K = 0 if nothing was met.

    Raises
    ------
    AmrError
        If `scans` does not come from `scan_room`, or `poses` are not as many planar poses
        as scans.

    References
    ----------
    Lecture 06. Thrun, Burgard and Fox (2005), eq. (6.32).

    Examples
    --------
    >>> import numpy as np
    >>> import amrmetrics as am
    >>> scans = am.simulation.scan_room(np.random.default_rng(5))
    >>> points = am.simulation.point_map(scans)
    >>> round(am.chamfer(scans.surface, points).value, 3)
    0.032
    """
    poses = _believed(scans, poses)
    points = []
    for pose, ranges in zip(poses, scans.ranges, strict=True):
        origin, direction = _rays(pose, scans.bearings)
        met = np.isfinite(ranges)
        points.append(origin + direction[met] * ranges[met, None])
    return np.concatenate(points)


def _believed(scans, poses):
    if not isinstance(scans, Scans):
        raise AmrError(f"scans is of type {type(scans).__name__}; expected what scan_room returns.")
    if poses is None:
        return scans.truth
    poses = as_poses(poses, "poses")
    if poses.shape != scans.truth.shape:
        raise AmrError(
            f"poses have shape {poses.shape}; expected {scans.truth.shape}, as scans.truth."
        )
    return poses


def _lap(steps):
    """Return stamps and poses; the robot looks ahead and has the rectangle on its left."""
    sides = np.linalg.norm(np.diff(CORNERS, axis=0), axis=1)
    lengths = np.column_stack([sides, np.full(4, DISTANCE * np.pi / 2)]).ravel()
    ends = np.concatenate([[0], np.cumsum(lengths)])
    s = np.linspace(0, ends[-1], steps)
    heading = np.interp(s, ends, np.arange(9) // 2 * np.pi / 2)
    inner = [np.interp(s, ends, np.repeat(c, 2)[1:]) for c in CORNERS.T]
    right = _directions(heading - np.pi / 2)
    return s / SPEED, planar_poses(np.transpose(inner) + DISTANCE * right, heading)


def _rays(pose, bearings):
    """Return origin (2,) and unit directions (B, 2) of the beams in the world frame."""
    return pose[:2, 2], _directions(bearings) @ pose[:2, :2].T


def _directions(angles):
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _cast(origin, direction):
    """Return the distance from a point to the nearest surface in each direction (B, 2)."""
    a, b = SEGMENTS[:, 0], SEGMENTS[:, 1]
    side, d = b - a, direction[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        t = _cross(a - origin, side) / _cross(d, side)
        u = _cross(a - origin, d) / _cross(d, side)
    # A hair longer than the wall, so that no beam slips through a corner.
    straight = np.where((t > 0) & (np.abs(u - 0.5) < 0.5 + 1e-9), t, np.inf)
    middle = direction @ (CENTERS - origin).T
    squared = RADII**2 - _cross(d, CENTERS - origin) ** 2  # half a chord
    met = (squared > 0) & (middle > 0)
    curved = np.where(met, middle - np.sqrt(np.where(met, squared, 0)), np.inf)
    return np.minimum(straight.min(axis=1), curved.min(axis=1))


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _crossed(start, end):
    """Return a point inside each cell that lines (B, 2) pass before they end; units are cells.

    The lines of the grid cut a line into pieces of one cell each; the point is a middle.
    """
    start, end = np.broadcast_arrays(start, end)
    way, first = end - start, np.floor(start)
    count = np.abs(np.floor(end) - first)
    k = np.arange(count.max())
    cuts = [np.zeros((len(start), 1))]
    for axis in (0, 1):
        p, v, c, n = (x[:, axis, None] for x in (start, way, first, count))
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            cuts.append(np.where(k < n, (np.where(v > 0, c + 1 + k, c - k) - p) / v, np.nan))
    t = np.sort(np.concatenate(cuts, axis=1), axis=1)
    # A piece no longer than rounding is a corner, and belongs to no cell.
    ray, piece = np.nonzero(np.diff(t, axis=1) > 1e-12)
    middle = (t[ray, piece] + t[ray, piece + 1]) / 2
    return start[ray] + middle[:, None] * way[ray]


def _mark(grid, points, value):
    """Write a value into the cells of points (K, 2); x is the column. Units are cells."""
    column, row = np.floor(points).astype(int).T
    inside = (row >= 0) & (row < grid.shape[0]) & (column >= 0) & (column < grid.shape[1])
    grid[row[inside], column[inside]] = value


def _true_grid():
    grid = np.zeros(SHAPE, dtype=bool)
    a, b = np.moveaxis((SEGMENTS - ORIGIN) / CELL, 1, 0)
    for points in (_crossed(a, b), b):
        _mark(grid, points, True)
    y, x = np.mgrid[: SHAPE[0], : SHAPE[1]]
    low = np.stack([x, y], axis=-1) * CELL + ORIGIN
    for corners in THINGS:
        c = np.array(corners)
        side = np.roll(c, -1, axis=0) - c
        grid |= (_cross(side, low[:, :, None] + CELL / 2 - c) > 0).all(axis=-1)
    for center, radius in zip(CENTERS, RADII, strict=True):
        nearest = np.clip(center, low, low + CELL)
        grid |= np.linalg.norm(nearest - center, axis=-1) <= radius
    return grid


def _surface():
    """Return points on all surfaces, `SPACING` apart."""
    points = []
    for a, b in SEGMENTS:
        n = round(np.linalg.norm(b - a) / SPACING)
        points.append(a + (np.arange(n)[:, None] + 0.5) / n * (b - a))
    for center, radius in zip(CENTERS, RADII, strict=True):
        angle = np.arange(0, 2 * np.pi, SPACING / radius)
        points.append(center + radius * _directions(angle))
    return np.concatenate(points)


def _seen(points, poses):
    """Return the points that are in the field of view from a pose and not behind anything."""
    seen = np.zeros(len(points), dtype=bool)
    for pose in poses:
        way = points - pose[:2, 2]
        distance = np.linalg.norm(way, axis=1)
        x, y = (way @ pose[:2, :2]).T
        near = (distance <= MAX_RANGE) & (np.abs(np.arctan2(y, x)) <= FIELD_OF_VIEW / 2)
        clear = _cast(pose[:2, 2], (way / distance[:, None])[near]) > distance[near] - 1e-6
        seen[np.flatnonzero(near)[clear]] = True
    return points[seen]
