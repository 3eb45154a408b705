"""The mapping robot sees what is there, and its mapper does what Bayes says; no cell by cell trust.

The references here are slow and different on purpose: a beam walks by the distance to the
nearest surface, a line is sampled, a cell is updated as a probability.
"""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.path import Path
from scipy import stats

import amrmetrics as am
from amrmetrics import simulation as sim
from amrmetrics.simulation import mapping

SEEDS = range(20)
START = [[[1, 0, 4], [0, 1, 1.1], [0, 0, 1]]]  # of the lap: in the corridor, looking along it


@pytest.fixture(scope="module", params=[0])
def scans(request):
    return sim.scan_room(np.random.default_rng(request.param))


@pytest.fixture
def seeds(request):
    return SEEDS if request.config.getoption("--sweep") else SEEDS[:2]


def distance(points):
    """Distance of each point (K, 2) to the nearest surface."""
    p = np.asarray(points)[:, None]
    a, b = mapping.SEGMENTS[:, 0], mapping.SEGMENTS[:, 1]
    along = np.sum((p - a) * (b - a), axis=-1) / np.sum((b - a) ** 2, axis=-1)
    foot = a + np.clip(along, 0, 1)[..., None] * (b - a)
    lines = np.linalg.norm(p - foot, axis=-1)
    discs = np.abs(np.linalg.norm(p - mapping.CENTERS, axis=-1) - mapping.RADII)
    return np.concatenate([lines, discs], axis=1).min(axis=1)


def walk(origin, direction):
    """Range by walking: no surface is nearer than the nearest, so a step of that is safe."""
    t = np.zeros(len(direction))
    for _ in range(2000):
        step = distance(origin + t[:, None] * direction)
        t += np.where(step < 1e-9, 0, step)  # who has arrived must not creep through the wall
        if step.max() < 1e-9:
            break
    return t


def one_scan(scans, k=0, **fields):
    """The scans of one step only."""
    part = {name: getattr(scans, name)[k : k + 1] for name in ("stamps", "truth", "ranges")}
    return scans._replace(**(part | fields))


def cells(points, scans):
    """Columns and rows of points (K, 2)."""
    return np.floor((points - scans.origin) / scans.cell).astype(int)


def odds(p):
    return np.log(p / (1 - p))


class TestScans:
    def test_shapes_units_and_frames(self, scans):
        assert scans.truth.shape == (120, 3, 3)
        assert scans.ranges.shape == (120, 91)
        assert scans.bearings.shape == (91,)
        assert scans.bearings == pytest.approx(-scans.bearings[::-1])
        assert np.diff(scans.bearings) == pytest.approx(np.radians(270) / 91)
        assert scans.extent == pytest.approx((-0.45, 12.45, -0.45, 9.45))
        finite = scans.ranges[np.isfinite(scans.ranges)]
        assert finite.min() > 0.5 and finite.max() <= scans.max_range
        assert np.isposinf(scans.ranges[~np.isfinite(scans.ranges)]).all()

    def test_one_lap_at_constant_speed_looking_ahead(self):
        X = sim.scan_room(np.random.default_rng(0), steps=401, beams=1)
        xy, step = am.positions(X.truth), np.diff(am.positions(X.truth), axis=0)
        assert X.truth[-1] == pytest.approx(X.truth[0], abs=1e-9)
        assert am.path_length(X.truth) == pytest.approx(14.8 + 2 * np.pi, rel=1e-4)
        assert am.path_length(X.truth) / X.stamps[-1] == pytest.approx(0.5, rel=1e-4)
        middle = am.yaw(X.truth)[:-1] + am.wrap(np.diff(am.yaw(X.truth))) / 2
        ahead = np.stack([np.cos(middle), np.sin(middle)], axis=1)
        # A corner may begin or end within a step.
        assert np.sum(step * ahead, axis=1) == pytest.approx(np.linalg.norm(step, axis=1), rel=1e-4)
        assert distance(xy).min() > 0.6

    def test_hand_computed(self):
        """From (4, 1.1), looking along x: walls at y = 0 and 2.2, and 8 m ahead, out of range."""
        scans = sim.scan_room(np.random.default_rng(0), steps=1, beams=3, noise=0)
        assert scans.truth == pytest.approx(np.array(START))
        assert np.degrees(scans.bearings) == pytest.approx([-90, 0, 90])
        assert scans.ranges[0] == pytest.approx([1.1, np.inf, 1.1])

    def test_hand_computed_round_and_slanted(self):
        down, left_up = np.array([[0.0, -1]]), np.array([[-1, 1]]) / np.sqrt(2)
        # The pillar at (8, 4) with radius 1/4: its top, and where 0.15 beside the middle.
        assert mapping._cast(np.array([8, 6]), down) == pytest.approx([1.75])
        assert mapping._cast(np.array([8.15, 6]), down) == pytest.approx([1.8])
        assert mapping._cast(np.array([8.26, 6]), down) == pytest.approx([3.8])  # past it
        assert mapping._cast(np.array([8, 2.9]), down) == pytest.approx([0.7])  # away from it
        # The corner wall from (0, 7.4) to (1.6, 9), met at a right angle in (0.8, 8.2).
        assert mapping._cast(np.array([2.3, 6.7]), left_up) == pytest.approx([1.5 * np.sqrt(2)])

    def test_ranges_equal_walking(self):
        scans = sim.scan_room(np.random.default_rng(0), steps=12, beams=40, noise=0)
        for pose, ranges in zip(scans.truth, scans.ranges, strict=True):
            angle = am.yaw(pose[None]) + scans.bearings
            t = walk(pose[:2, 2], np.stack([np.cos(angle), np.sin(angle)], axis=1))
            expected = np.where(t > scans.max_range, np.inf, t)
            np.testing.assert_allclose(ranges, expected, rtol=0, atol=1e-6)

    def test_no_beam_slips_through_a_corner(self):
        origin = np.array([4, 1.1])
        corners = mapping.SEGMENTS.reshape(-1, 2)
        way = corners - origin
        direction = way / np.linalg.norm(way, axis=1, keepdims=True)
        assert (mapping._cast(origin, direction) < np.linalg.norm(way, axis=1) + 1e-6).all()

    def test_noise_is_as_told(self):
        exact = sim.scan_room(np.random.default_rng(0), noise=0).ranges
        noisy = sim.scan_room(np.random.default_rng(1), noise=0.05).ranges
        # Near the largest range the noise decides if there is a reading.
        near = exact < 5.5
        error = (noisy[near] - exact[near]) / 0.05
        assert stats.kstest(error, "norm").pvalue > 1e-4
        assert abs(np.corrcoef(error[:-1], error[1:])[0, 1]) < 4.5 / np.sqrt(len(error))

    def test_outliers_are_as_told(self):
        exact = sim.scan_room(np.random.default_rng(0), noise=0).ranges
        scans = sim.scan_room(np.random.default_rng(1), noise=0, outliers=0.2)
        wrong = scans.ranges != exact
        assert wrong.mean() == pytest.approx(0.2, abs=4.5 * np.sqrt(0.16 / wrong.size))
        assert stats.kstest(scans.ranges[wrong] / scans.max_range, "uniform").pvalue > 1e-4
        everything = sim.scan_room(np.random.default_rng(1), outliers=1)
        assert stats.kstest(everything.ranges.ravel() / 6, "uniform").pvalue > 1e-4

    def test_generator_decides(self):
        a, b, c = (sim.scan_room(np.random.default_rng(seed)) for seed in (3, 3, 4))
        for name in a._fields:
            assert np.array_equal(getattr(a, name), getattr(b, name)), name
        assert not np.array_equal(a.ranges, c.ranges)
        assert np.array_equal(a.surface, c.surface)

    def test_one_step_one_beam(self):
        scans = sim.scan_room(np.random.default_rng(0), steps=1, beams=1)
        assert scans.bearings.tolist() == [0] and scans.stamps.tolist() == [0]
        assert scans.ranges.tolist() == [[np.inf]]
        assert sim.point_map(scans).shape == (0, 2)
        assert sim.occupancy_grid(scans).max() == 0


class TestTruth:
    def test_grid_against_sampling(self, scans):
        t = np.linspace(0, 1, 5001)[:, None, None]
        a, b = mapping.SEGMENTS[:, 0], mapping.SEGMENTS[:, 1]
        column, row = cells((a + t * (b - a)).reshape(-1, 2), scans).T
        samples = np.bincount(129 * row + column, minlength=99 * 129).reshape(99, 129)
        expected = samples > 2  # fewer: a corner, where the slanted wall runs from cell to cell
        y, x = np.mgrid[:99, :129][:, :, :, None]
        part = (np.arange(10) + 0.5) / 10
        dx, dy = (p.ravel() for p in np.meshgrid(part, part))
        points = np.stack([(x + dx) * 0.1 - 0.45, (y + dy) * 0.1 - 0.45], axis=-1)
        for corners in mapping.THINGS:
            inside = Path(corners).contains_points(points.reshape(-1, 2))
            expected |= inside.reshape(points.shape[:-1]).any(axis=-1)
        for center, radius in zip(mapping.CENTERS, mapping.RADII, strict=True):
            expected |= (np.linalg.norm(points - center, axis=-1) < radius).any(axis=-1)
        assert not (expected & ~scans.occupied).any()
        # Samples 1 cm apart miss what only the tip of a disc reaches.
        assert (scans.occupied & ~expected).sum() <= 6

    def test_exact_end_points_are_in_occupied_cells(self):
        scans = sim.scan_room(np.random.default_rng(0), noise=0)
        column, row = cells(sim.point_map(scans), scans).T
        assert scans.occupied[row, column].all()

    def test_robot_is_in_the_free(self, scans):
        column, row = cells(am.positions(scans.truth), scans).T
        assert not scans.occupied[row, column].any()

    def test_surface_lies_on_the_walls_and_is_in_sight(self, scans):
        assert distance(scans.surface).max() < 1e-9
        for point in scans.surface[::60]:
            way = point - am.positions(scans.truth)
            length = np.linalg.norm(way, axis=1)
            bearing = am.wrap(np.arctan2(way[:, 1], way[:, 0]) - am.yaw(scans.truth))
            inside = (length < 6) & (np.abs(bearing) < np.radians(135))
            assert any(
                walk(point - w, w[None] / d)[0] > d - 1e-5
                for w, d in zip(way[inside], length[inside], strict=True)
            )

    def test_surface_misses_nothing_that_was_hit(self):
        scans = sim.scan_room(np.random.default_rng(0), noise=0)
        found = am.chamfer(scans.surface, sim.point_map(scans))
        assert found.worst_distance < 0.3  # far walls are hit only here and there
        assert am.hausdorff(scans.surface, sim.point_map(scans)).backward < 0.055


class TestTraversal:
    @staticmethod
    def crossed(start, end):
        points = mapping._crossed(np.array([start], dtype=float), np.array([end], dtype=float))
        return {tuple(cell) for cell in np.floor(points).astype(int).tolist()}

    @staticmethod
    def inside(start, end):
        """Length of the line inside each cell of its bounding box, by clipping: {cell: part}."""
        start, way = np.array(start, dtype=float), np.subtract(end, start)
        low, high = (np.floor(f([start, end], axis=0)).astype(int) for f in (np.min, np.max))
        parts = {}
        for i in range(low[0], high[0] + 1):
            for j in range(low[1], high[1] + 1):
                t = [0.0, 1.0]
                for p, v, c in zip(start, way, (i, j), strict=True):
                    if v:
                        enter, leave = sorted([(c - p) / v, (c + 1 - p) / v])
                        t = [max(t[0], enter), min(t[1], leave)]
                    elif not c <= p < c + 1:
                        t = [1.0, 0.0]
                parts[i, j] = t[1] - t[0]
        return parts

    # Hundredths: many lines start, end or run on borders and through corners.
    @given(hundredths=st.lists(st.integers(-900, 900), min_size=4, max_size=4))
    def test_against_clipping(self, hundredths):
        start, end = np.reshape(hundredths, (2, 2)) / 100
        last = tuple(np.floor(end).astype(int).tolist())
        parts = self.inside(start, end)
        found = self.crossed(start, end)
        length = np.linalg.norm(np.subtract(end, start))
        sure = {cell for cell, part in parts.items() if part > 1e-9 and part * length > 1e-9}
        possible = {cell for cell, part in parts.items() if part > -1e-9}
        assert sure - {last} <= found <= possible

    def test_against_samples(self, rng):
        for start, end in rng.uniform(-20, 20, (30, 2, 2)):
            points = start + np.linspace(0, 1, 20001)[:, None] * (end - start)
            visited, count = np.unique(np.floor(points).astype(int), axis=0, return_counts=True)
            seen = {tuple(cell) for cell in visited.tolist()}
            last = tuple(np.floor(end).astype(int).tolist())
            found = self.crossed(start, end)
            assert last not in found
            assert seen - {last} <= found
            assert len(found - seen) <= 1 + (count < 2).sum()  # a corner cut below the sampling

    def test_by_hand(self):
        assert self.crossed([0.5, 0.5], [3.5, 0.5]) == {(0, 0), (1, 0), (2, 0)}
        assert self.crossed([3.5, 0.5], [0.5, 0.5]) == {(3, 0), (2, 0), (1, 0)}
        assert self.crossed([0.5, 0.2], [1.5, 1.2]) == {(0, 0), (1, 0)}
        assert self.crossed([0.5, 0.5], [2.5, 2.5]) == {(0, 0), (1, 1)}  # through corners
        assert self.crossed([0.2, 0.2], [0.8, 0.3]) == set()
        assert self.crossed([0.5, 2.5], [0.5, 0.5]) == {(0, 2), (0, 1)}

    def test_lines_of_one_batch_do_not_mix(self, rng):
        start, end = rng.uniform(0, 9, (2, 30, 2))
        together = np.floor(mapping._crossed(start, end)).astype(int).tolist()
        alone = set().union(*(self.crossed(a, b) for a, b in zip(start, end, strict=True)))
        assert {tuple(cell) for cell in together} == alone


class TestOccupancyGrid:
    def test_equals_bayes_cell_by_cell(self):
        """Each scan turns the prior of a cell into its posterior; evidence by sampled beams."""
        scans = sim.scan_room(np.random.default_rng(2), steps=6, beams=30, noise=0.05)
        hit, miss = 0.8, 0.3
        p = np.full(scans.occupied.shape, 0.5)
        for k in range(6):
            passed, ended = np.zeros((2, *p.shape), dtype=bool)
            for bearing, reach in zip(scans.bearings, scans.ranges[k], strict=True):
                angle = am.yaw(scans.truth[k : k + 1])[0] + bearing
                t = np.linspace(0, min(reach, scans.max_range), 100001)[:, None]
                beam = scans.truth[k, :2, 2] + t * [np.cos(angle), np.sin(angle)]
                column, row = cells(beam, scans).T
                before = (column != column[-1]) | (row != row[-1])
                passed[row[before], column[before]] = True
                ended[row[-1], column[-1]] |= np.isfinite(reach)
            likelihood = np.where(ended, hit / (1 - hit), np.where(passed, miss / (1 - miss), 1))
            p = likelihood * p / (likelihood * p + 1 - p)
        logits = sim.occupancy_grid(scans, hit=hit, miss=miss)
        # The samples are 60 micrometers apart and miss a corner now and then.
        differ = ~np.isclose(1 / (1 + np.exp(-logits)), p)
        assert differ.sum() <= 2

    def test_one_scan_changes_a_cell_once(self, scans):
        logits = sim.occupancy_grid(one_scan(scans, 40), hit=0.9, miss=0.4)
        values = np.array([odds(0.4), 0, odds(0.9)])
        assert np.abs(logits[..., None] - values).min(axis=-1).max() < 1e-12
        column, row = cells(sim.point_map(one_scan(scans, 40)), scans).T
        assert logits[row, column] == pytest.approx(odds(0.9))  # a hit wins over a pass
        assert (logits > 0).sum() == len(set(zip(row, column, strict=True)))

    def test_one_beam_ends_in_one_cell(self, scans):
        beam = one_scan(scans, bearings=np.array([np.pi / 2]), ranges=np.array([[1.1]]))
        logits = sim.occupancy_grid(beam, hit=0.7, miss=0.35)
        # From (4, 1.1) up to the wall at y = 2.2: rows 15 to 25 are passed, 26 is hit.
        assert np.argwhere(logits > 0).tolist() == [[26, 44]]
        assert np.argwhere(logits < 0).tolist() == [[row, 44] for row in range(15, 26)]
        assert logits[26, 44] == pytest.approx(np.log(7 / 3))
        assert logits[20, 44] == pytest.approx(np.log(35 / 65))

    def test_beam_without_return_only_frees(self, scans):
        beam = one_scan(scans, bearings=np.array([0.0]), ranges=np.array([[np.inf]]))
        logits = sim.occupancy_grid(beam)
        # From x = 4 to x = 10, the end of its cell at 10.05 not reached.
        assert np.argwhere(logits).tolist() == [[15, column] for column in range(44, 104)]
        assert logits.max() == 0 and logits.min() == pytest.approx(odds(0.35))

    def test_beam_that_leaves_the_grid(self, scans):
        out = am.planar_poses([[12, 1.1]], [0])
        beam = one_scan(scans, bearings=np.array([0.0, 0.7]), ranges=np.array([[3.0, np.inf]]))
        logits = sim.occupancy_grid(beam, out)
        assert logits.max() == 0 and (logits[15, 124:] < 0).all()
        assert not logits[:, :124].any()
        assert not sim.occupancy_grid(beam, am.planar_poses([[50, 50]], [0])).any()

    def test_untouched_cells_are_exactly_zero(self, scans):
        logits = sim.occupancy_grid(scans)
        inside_a_bench, inside_a_table = logits[5:7, 60:69], logits[46:52, 51:57]
        assert not inside_a_bench.any() and not inside_a_table.any()
        assert (logits[:2] == 0).all() and 0.1 < (logits == 0).mean() < 0.3

    def test_same_evidence_k_times_is_k_times_the_logits(self, scans):
        def power(p, k):
            return p**k / (p**k + (1 - p) ** k)

        once = sim.occupancy_grid(scans, hit=0.62, miss=0.4)
        eight = sim.occupancy_grid(scans, hit=power(0.62, 8), miss=power(0.4, 8))
        assert eight == pytest.approx(8 * once)

    def test_order_of_scans_does_not_matter(self, scans, rng):
        order = rng.permutation(120)
        other = scans._replace(truth=scans.truth[order], ranges=scans.ranges[order])
        assert sim.occupancy_grid(other) == pytest.approx(sim.occupancy_grid(scans))

    def test_believed_poses_are_used_and_kept(self, scans):
        poses = scans.truth @ am.planar_poses([[0.5, 0]], [0.1])
        before = poses.copy()
        moved = sim.occupancy_grid(scans, poses)
        assert np.array_equal(poses, before)
        assert np.array_equal(moved, sim.occupancy_grid(scans._replace(truth=poses)))
        assert not np.array_equal(moved, sim.occupancy_grid(scans))

    def test_moved_by_whole_cells(self, scans):
        """All poses 3 cells right and 2 up: so is the map, where the grid ends for neither."""
        shift = am.planar_poses([[0.3, 0.2]], [0])
        logits, moved = sim.occupancy_grid(scans), sim.occupancy_grid(scans, shift @ scans.truth)
        differ = ~np.isclose(moved[2:, 3:], logits[:-2, :-3])
        assert differ.mean() < 1e-3  # what ends within rounding of a border


class TestPointMap:
    def test_end_points_by_hand(self, scans):
        turned = am.planar_poses([[1, 2]], [np.pi / 2])
        beams = one_scan(
            scans, bearings=np.array([0, np.pi / 2, 1]), ranges=np.array([[2.0, 3, np.inf]])
        )
        assert sim.point_map(beams, turned) == pytest.approx(np.array([[1, 4], [-2, 2]]))

    def test_exact_points_lie_on_surfaces(self):
        scans = sim.scan_room(np.random.default_rng(0), noise=0)
        points = sim.point_map(scans)
        assert len(points) == np.isfinite(scans.ranges).sum()
        assert distance(points).max() < 1e-9

    def test_moves_with_its_frame(self, scans):
        T = am.planar_poses([[3, -1]], [0.4])
        expected = sim.point_map(scans) @ T[0, :2, :2].T + T[0, :2, 2]
        assert sim.point_map(scans, T @ scans.truth) == pytest.approx(expected)


class TestErrors:
    @pytest.mark.parametrize(
        ("options", "message"),
        [
            ({"rng": 4}, "rng is 4; expected a numpy Generator"),
            ({"steps": 0}, "steps is 0; expected a whole number of at least 1"),
            ({"steps": 2.5}, "steps is 2.5; expected a whole number"),
            ({"beams": -1}, "beams is -1; expected a whole number of at least 1"),
            ({"noise": -0.1}, "noise is -0.1; expected >= 0"),
            ({"noise": 0.2}, r"noise is 0.2 m; expected at most 0.1 m"),
            ({"noise": np.nan}, "noise is nan"),
            ({"noise": [0.1, 0.1]}, r"noise has shape \(2,\); expected a single number"),
            ({"outliers": -0.1}, r"outliers is -0.1; expected a part of the readings, in \[0, 1\]"),
            ({"outliers": 5}, "outliers is 5; expected a part of the readings"),
            ({"outliers": "many"}, "outliers must be an array of real numbers"),
        ],
    )
    def test_scan_room(self, options, message):
        with pytest.raises(am.AmrError, match=message):
            sim.scan_room(**({"rng": np.random.default_rng(0)} | options))

    @pytest.mark.parametrize("mapper", [sim.occupancy_grid, sim.point_map])
    def test_scans_and_poses(self, mapper, scans):
        with pytest.raises(am.AmrError, match="scans is of type ndarray; expected what scan_room"):
            mapper(scans.ranges)
        with pytest.raises(am.AmrError, match=r"poses have shape \(119, 3, 3\); expected \(120"):
            mapper(scans, scans.truth[1:])
        with pytest.raises(am.AmrError, match=r"poses have shape \(120, 4, 4\); expected"):
            mapper(scans, np.broadcast_to(np.eye(4), (120, 4, 4)))
        with pytest.raises(am.AmrError, match="poses has shape"):
            mapper(scans, am.positions(scans.truth))
        with pytest.raises(am.AmrError, match="is not a pose"):
            mapper(scans, scans.truth * [[2], [2], [1]])

    @pytest.mark.parametrize(
        ("hit", "miss"), [(0.5, 0.4), (1, 0.4), (0.4, 0.35), (0.7, 0.5), (0.7, 0), (0.7, 0.8)]
    )
    def test_sensor_model(self, hit, miss, scans):
        with pytest.raises(am.AmrError, match="expected 0 < miss < 1/2 < hit < 1"):
            sim.occupancy_grid(scans, hit=hit, miss=miss)

    def test_sensor_model_is_two_numbers(self, scans):
        with pytest.raises(am.AmrError, match="hit has shape"):
            sim.occupancy_grid(scans, hit=[0.7, 0.8])
        with pytest.raises(am.AmrError, match="miss is nan"):
            sim.occupancy_grid(scans, miss=np.nan)


class TestWhatTheLecturesShow:
    """Margins are at most half of the smallest of 25 seeds, over ten standard deviations away."""

    def test_sharp_and_wrong_against_vague_and_right(self, seeds):
        for seed in seeds:
            scans = sim.scan_room(np.random.default_rng(seed), noise=0.05)
            sharp = sim.occupancy_grid(scans, hit=0.97, miss=0.1)
            vague = sim.occupancy_grid(scans, hit=0.62, miss=0.4)
            unknown = vague == 0
            assert np.array_equal(unknown, sharp == 0)
            (a, f, s, b, r), (a2, f2, s2, b2, r2) = (
                self.scores(scans.occupied, logits, unknown) for logits in (sharp, vague)
            )
            assert a > a2 and f > f2 + 0.01, seed
            assert s > s2 + 0.1 and b > b2 + 0.003 and r > r2 + 0.0018, seed

    def test_counting_eight_times_changes_no_decision(self, seeds):
        for seed in seeds:
            scans = sim.scan_room(np.random.default_rng(seed), noise=0.05)
            once = sim.occupancy_grid(scans, hit=0.62, miss=0.4)
            (a, f, s, b, _), (a2, f2, s2, b2, _) = (
                self.scores(scans.occupied, k * once, once == 0) for k in (8, 1)
            )
            assert (a, f) == (a2, f2), seed
            assert s > s2 + 0.15 and b > b2 + 0.005, seed

    def test_exact_positions_and_a_warped_map(self, seeds):
        for seed in seeds:
            scans = sim.scan_room(np.random.default_rng(seed))
            drift = np.radians(np.linspace(0, 6, 120))
            turned = am.planar_poses(am.positions(scans.truth), am.yaw(scans.truth) + drift)
            late = scans.truth.copy()
            late[10::20] = late[10::20] @ am.planar_poses([[0.5, 0]], [0])
            true, warped, good = (self.distances(scans, X) for X in (scans.truth, turned, late))
            assert warped[0] < 1e-9 and good[0] > 0.1, seed
            assert warped[1] < true[1] - 0.2 and good[1] > true[1] - 0.05, seed
            assert warped[2] > 2 * true[2] and good[2] < 1.5 * true[2], seed
            assert warped[3] > 2 * true[3], seed

    @staticmethod
    def scores(occupied, logits, unknown):
        p = 1 / (1 + np.exp(-logits))
        c = am.confusion(occupied, p, unknown=unknown)
        parts = am.murphy(occupied, p, unknown=unknown)
        entropy = am.cross_entropy(occupied, logits=logits, unknown=unknown).value
        return c.accuracy, c.f1, entropy, parts.brier, parts.reliability

    @staticmethod
    def distances(scans, poses):
        unknown = sim.occupancy_grid(scans) == 0
        p = 1 / (1 + np.exp(-sim.occupancy_grid(scans, poses)))
        points = sim.point_map(scans, poses)
        return (
            am.ate(scans.truth, poses).rmse,
            am.confusion(scans.occupied, p, unknown=unknown).iou,
            am.chamfer(scans.surface, points).value,
            am.hausdorff(scans.surface, points).value,
        )
