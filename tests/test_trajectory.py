"""ATE, RPE and drift agree with evo, with plain loops, and with what was built into the data."""

import copy

import numpy as np
import pytest
from evo.core import geometry, metrics, result, trajectory, units
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import amrmetrics as am

TRANSLATION = metrics.PoseRelation.translation_part
ROTATION = metrics.PoseRelation.rotation_angle_rad
EVO_UNITS = {
    "frames": units.Unit.frames,
    "metres": units.Unit.meters,
    "degrees": units.Unit.degrees,
}
SEEDS = range(3)


def random_poses(rng, n, d, step, turn):
    if d == 2:
        return am.planar_poses(step * rng.normal(size=(n, 2)), turn * rng.normal(size=n))
    q = Rotation.from_rotvec(turn * rng.normal(size=(n, 3))).as_quat()
    return am.spatial_poses(step * rng.normal(size=(n, 3)), q)


def walk(rng, n, d, step=0.05, turn=0.05):
    """Return a trajectory whose every step is random, and all digits of a rotation."""
    X = random_poses(rng, n, d, step, turn)
    for k in range(1, n):
        X[k] = X[k - 1] @ X[k]
    xyz, R = X[:, :d, d], X[:, :d, :d]
    if d == 2:
        return am.planar_poses(xyz, np.arctan2(R[:, 1, 0], R[:, 0, 0]))
    return am.spatial_poses(xyz, Rotation.from_matrix(R).as_quat())


def pair(seed, d, n=200, step=0.05, turn=0.05):
    """Return a walk and a noisy copy in another frame."""
    rng = np.random.default_rng(seed)
    X = walk(rng, n, d, step, turn)
    return X, random_poses(rng, 1, d, 5, 1) @ X @ random_poses(rng, n, d, 0.02, 0.03)


def evo_path(X):
    """Return evo's object; a planar trajectory lies in its xy plane."""
    d = X.shape[-1] - 1
    Y = np.tile(np.eye(4), (len(X), 1, 1))
    Y[:, :d, :d], Y[:, :d, 3] = X[:, :d, :d], X[:, :d, d]
    return trajectory.PosePath3D(poses_se3=list(Y))


def evo_error(metric, X, Y):
    metric.process_data((evo_path(X), Y if isinstance(Y, trajectory.PosePath3D) else evo_path(Y)))
    return metric


def assert_same(summary, metric, kept=None):
    """Demand the same errors, and the same statistics to 1e-9 relative."""
    if kept is not None:
        metric.error = metric.error[:kept]
    assert summary.n == len(metric.error)
    assert np.allclose(summary.series, metric.error, rtol=1e-9, atol=1e-12)
    theirs = metric.get_all_statistics()
    for name in ("rmse", "mean", "median", "std", "max"):
        assert getattr(summary, name) == pytest.approx(theirs[name], rel=1e-9), name
    assert summary.min == pytest.approx(theirs["min"], rel=1e-9, abs=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("d", [2, 3])
class TestAgreesWithEvo:
    @pytest.mark.parametrize("mode", ["none", "rigid", "similarity"])
    def test_ate(self, d, mode, seed):
        X, Y = pair(seed, d)
        aligned = evo_path(Y)
        if mode != "none":
            aligned.align(evo_path(X), correct_scale=mode == "similarity")
        error = am.ate(X, Y, mode)
        assert_same(error, evo_error(metrics.APE(TRANSLATION), X, aligned))
        assert_same(error.rotation, evo_error(metrics.APE(ROTATION), X, aligned))

    @pytest.mark.parametrize("pairs", ["all", "consecutive"])
    @pytest.mark.parametrize(
        ("delta", "unit"), [(1, "frames"), (7, "frames"), (2.5, "metres"), (10, "degrees")]
    )
    def test_rpe(self, d, delta, unit, pairs, seed):
        X, Y = pair(seed, d)
        found = am.rpe(X, Y, delta, unit, pairs)
        for summary, relation in ((found.translation, TRANSLATION), (found.rotation, ROTATION)):
            metric = metrics.RPE(
                relation, delta, EVO_UNITS[unit], 0.1, pairs == "all", pairs_from_reference=True
            )
            # At the end of the path evo also counts pairs that fall short of delta.
            kept = len(found.pairs) if (unit, pairs) == ("metres", "all") else None
            assert_same(summary, evo_error(metric, X, Y), kept)
        assert found.pairs[:, 1].tolist() == metric.delta_ids[:kept]
        assert found.left_out == 0 or pairs == "all"


def plain_error(X, Y, i, j):
    """Return the two errors of one pair by the definition and by general routines."""
    inv = np.linalg.inv
    E = inv(inv(X[i]) @ X[j]) @ (inv(Y[i]) @ Y[j])
    R = np.eye(3)
    d = len(E) - 1
    R[:d, :d] = E[:d, :d]
    return np.linalg.norm(E[:d, d]), Rotation.from_matrix(R).magnitude()


def plain_pairs(measure, delta, pairs):
    """Return the pairs by looping over all candidates."""
    n = len(measure)
    if pairs == "all":
        ends = [
            min(range(i + 1, n), key=lambda j, i=i: abs(measure[j] - measure[i] - delta))
            for i in range(n - 1)
        ]
        # From the last samples the recording does not reach delta any more.
        found = [(i, j) for i, j in enumerate(ends) if measure[-1] - measure[i] >= delta]
    else:
        found, i = [], 0
        for j in range(n):
            if measure[j] - measure[i] >= delta:
                found.append((i, j))
                i = j
    return [(i, j) for i, j in found if abs(measure[j] - measure[i] - delta) <= 0.1 * delta]


# Multiples of 1/1024 have exact sums: nothing is decided by rounding. Zero: it stands still.
GRID = st.lists(st.integers(0, 5), min_size=2, max_size=40).map(lambda x: np.array(x) / 1024)


class TestAgreesWithPlainLoops:
    @pytest.mark.parametrize("pairs", ["all", "consecutive"])
    @pytest.mark.parametrize("d", [2, 3])
    def test_seconds(self, rng, d, pairs):
        X, Y = pair(3, d)
        stamps = 1.3e9 + np.cumsum(rng.integers(1, 50, len(X)) / 1024)
        found = am.rpe(X, Y, 0.75, "seconds", pairs, stamps)
        expected = plain_pairs(stamps, 0.75, pairs)
        assert found.pairs.tolist() == [list(p) for p in expected]
        errors = np.array([plain_error(X, Y, *p) for p in expected])
        assert np.allclose(found.translation.series, errors[:, 0], rtol=1e-9)
        assert np.allclose(found.rotation.series, errors[:, 1], rtol=1e-9, atol=1e-12)
        assert np.allclose(found.lengths, [stamps[j] - stamps[i] for i, j in expected])
        assert np.abs(found.lengths / 0.75 - 1).max() <= 0.1

    @given(GRID, st.integers(1, 40), st.sampled_from(["all", "consecutive"]))
    def test_metres_also_when_the_robot_stands_still(self, steps, delta, pairs):
        along, delta = np.cumsum(steps), delta / 1024
        X = am.planar_poses(np.c_[along, 0 * along], 0 * along)
        expected = plain_pairs(along, delta, pairs)
        if expected:
            found = am.rpe(X, X, delta, "metres", pairs)
            assert found.pairs.tolist() == [list(p) for p in expected]
            assert found.translation.max == found.rotation.max == 0
            n = len(plain_pairs(along, delta, pairs)) + found.left_out
            reaching = (along[-1] - along[:-1] >= delta).sum()
            assert pairs == "consecutive" or n == reaching
        else:
            with pytest.raises(am.AmrError, match="no pair of samples spans"):
                am.rpe(X, X, delta, "metres", pairs)

    @pytest.mark.parametrize("delta", [10, 30, 90, 175, 180])
    def test_degrees(self, delta):
        X, Y = pair(4, 3, n=60, turn=0.5)
        turn = np.degrees([am.rotation_angle(am.relative(x, X)) for x in X])
        expected = [
            [i, j] for i in range(60) for j in range(i + 1, 60) if abs(turn[i, j] / delta - 1) < 0.1
        ]
        found = am.rpe(X, Y, delta, "degrees")
        assert found.pairs.tolist() == expected
        assert np.allclose(found.lengths, [turn[i, j] for i, j in expected])
        errors = np.array([plain_error(X, Y, i, j) for i, j in expected])
        assert np.allclose(found.translation.series, errors[:, 0])
        assert np.allclose(found.rotation.series, errors[:, 1])

    @pytest.mark.parametrize("d", [2, 3])
    @pytest.mark.parametrize("step", [1, 10])
    def test_kitti_segments(self, d, step):
        X, Y = pair(5, d, n=400, step=1)
        lengths = [10.0, 25.0, 60.0, 1e4]
        along = [0.0]
        for k in range(1, len(X)):
            along.append(along[-1] + np.linalg.norm(X[k, :d, d] - X[k - 1, :d, d]))
        errors = []
        for length in lengths:
            for i in range(0, len(X), step):
                j = next((k for k in range(i, len(X)) if along[k] > along[i] + length), None)
                if j is not None:
                    errors.append((length, *np.divide(plain_error(X, Y, i, j), length)))
        errors = np.array(errors)
        found = am.segment_drift(X, Y, lengths, step)
        assert found.n == len(errors)
        assert found.translation_percent == pytest.approx(100 * errors[:, 1].mean(), rel=1e-9)
        expected = 100 * np.degrees(errors[:, 2].mean())
        assert found.rotation_deg_per_100m == pytest.approx(expected, rel=1e-9)
        assert list(found.per_length) == [10.0, 25.0, 60.0]
        for length, (t, r, n) in found.per_length.items():
            mine = errors[errors[:, 0] == length]
            assert n == len(mine)
            assert (t, r) == pytest.approx(
                (100 * mine[:, 1].mean(), 100 * np.degrees(mine[:, 2].mean())), rel=1e-9
            )

    @given(seed=st.integers(0, 2**32 - 1), delta=st.integers(1, 12), d=st.sampled_from([2, 3]))
    @settings(max_examples=30)
    def test_any_delta_in_frames(self, seed, delta, d):
        X, Y = pair(seed, d, n=13, turn=2)
        found = am.rpe(X, Y, delta)
        assert found.pairs.tolist() == [[i, i + delta] for i in range(13 - delta)]
        errors = np.array([plain_error(X, Y, *p) for p in found.pairs])
        assert np.allclose(found.translation.series, errors[:, 0], rtol=1e-9, atol=1e-14)
        assert np.allclose(found.rotation.series, errors[:, 1], rtol=1e-9, atol=1e-14)

    @pytest.mark.parametrize("delta", [1, 3000, 9000, 9999])
    def test_blocks_do_not_show(self, delta):
        rng = np.random.default_rng(delta)
        n, at = 10_000, np.r_[0, rng.integers(0, 10_000 - delta, 20), 9999 - delta]
        X, E = random_poses(rng, n, 3, 10, 2), random_poses(rng, n, 3, 0.1, 0.1)
        found = am.rpe(X, X @ E, delta)
        for k in at:
            both = found.translation.series[k], found.rotation.series[k]
            assert both == pytest.approx(plain_error(X, X @ E, k, k + delta), rel=1e-9)


class TestRightWhereEvoIsWrong:
    def test_not_a_number(self, rng):
        X = walk(rng, 10, 3)
        Y = X.copy()
        Y[3, 0, 3] = np.nan
        theirs = evo_error(metrics.APE(TRANSLATION), X, Y)
        assert np.isnan(theirs.get_all_statistics()["rmse"])
        for function in (am.ate, am.rpe, am.segment_drift, am.drift_rate):
            with pytest.raises(am.AmrError, match=r"estimate\[3, 0, 3\] is nan"):
                function(X, Y)

    def test_a_zero_quaternion_is_no_rotation(self):
        path = trajectory.PosePath3D(np.zeros((1, 3)), np.zeros((1, 4)))
        assert np.array_equal(path.poses_se3[0], np.eye(4))
        with pytest.raises(am.AmrError, match=r"quaternions\[0\] is zero"):
            am.spatial_poses(np.zeros((1, 3)), np.zeros((1, 4)))

    def test_delta_zero(self, rng):
        X = walk(rng, 10, 3)
        with pytest.raises(ZeroDivisionError):
            evo_error(metrics.RPE(TRANSLATION, 0, units.Unit.frames), X, X)
        with pytest.raises(am.AmrError, match="delta is 0"):
            am.rpe(X, X, 0)

    def test_inputs_stay(self, rng):
        X, Y = pair(0, 3)
        theirs = evo_path(Y)
        before = copy.deepcopy(theirs.poses_se3)
        theirs.align(evo_path(X))
        assert not np.allclose(before, theirs.poses_se3)
        kept = X.copy(), Y.copy()
        call_everything(X, Y)
        assert np.array_equal(X, kept[0])
        assert np.array_equal(Y, kept[1])

    def test_steps_of_a_meter_are_steps_of_a_meter(self, rng):
        x = 0.7 * np.arange(50)
        X = am.planar_poses(np.c_[x, 0 * x], 0 * x)
        theirs = metrics.RPE(TRANSLATION, 1.0, units.Unit.meters, pairs_from_reference=True)
        evo_error(theirs, X, X)
        assert np.allclose(np.diff(x[theirs.delta_ids]), 1.4)
        with pytest.raises(am.AmrError, match=r"no pair .* in steps of 0.7 \(median\)"):
            am.rpe(X, X, 1, "metres", "consecutive")
        x = np.cumsum(rng.uniform(0.05, 0.4, 200))
        X = am.planar_poses(np.c_[x, 0 * x], 0 * x)
        found = am.rpe(X, X, 1, "metres", "consecutive")
        i, j = found.pairs.T
        assert np.allclose(found.lengths, x[j] - x[i])
        assert np.abs(found.lengths - 1).max() <= 0.1 + 1e-9
        assert found.left_out > 0

    def test_runs_are_pooled_not_averaged(self):
        runs = []
        for n, e in ((10, 1.0), (90, 3.0)):
            x = np.c_[np.arange(n), np.zeros(n)]
            runs.append(am.ate(x, x + [0, e], align="none"))
        theirs = []
        for run in runs:
            theirs.append(result.Result())
            theirs[-1].add_stats({"rmse": run.rmse})
            theirs[-1].add_np_array("error_array", run.series)
        assert result.merge_results(theirs).stats["rmse"] == pytest.approx(2.0)
        pooled = am.pool(runs)
        assert pooled.rmse == pytest.approx(np.sqrt((10 * 1 + 90 * 9) / 100))
        assert f"{pooled.rmse:.2f}" == "2.86"
        assert pooled.n == 100
        assert "2 runs pooled (mean of the runs' rmse 2)" in repr(pooled)

    def test_the_size_of_the_motion_does_not_matter(self, rng):
        angle = np.linspace(0, 6, 50)
        p = 1e-9 * np.c_[np.cos(angle), np.sin(angle), 0 * angle]
        R = Rotation.random(rng=rng).as_matrix()
        with pytest.raises(geometry.GeometryException):
            geometry.umeyama_alignment((p @ R).T, p.T)
        assert am.ate(p, p @ R).rmse < 1e-20


def call_everything(X, Y):
    d = X.shape[-1] - 1
    p, q, stamps = X[:, :d, d], Y[:, :d, d], np.arange(len(X))
    errors = [am.ate(X, Y, mode) for mode in ("rigid", "similarity", "yaw", "none")]
    errors += [am.ate(p, q), am.drift_rate(X, Y).ate, am.pool(errors[:1])]
    relative = [
        am.rpe(X, Y, 1, unit, pairs, stamps)
        for unit in ("frames", "metres", "seconds", "degrees")
        for pairs in ("all", "consecutive")
    ]
    segments = am.segment_drift(X, Y, [1, 2])
    return [
        *(e.rmse for e in errors),
        *(x.rmse for r in relative for x in (r.translation, r.rotation)),
        segments.translation_percent,
    ]


@pytest.mark.parametrize("d", [2, 3])
class TestArguments:
    def test_read_only(self, d):
        X, Y = pair(0, d)
        expected = call_everything(X, Y)
        for array in (X, Y):
            array.flags.writeable = False
        assert call_everything(X, Y) == expected

    def test_views_and_other_orders(self, d):
        X, Y = pair(0, d)
        expected = call_everything(X[::2], Y[::2])
        X, Y = (np.asfortranarray(np.repeat(Z[::2], 2, axis=0)) for Z in (X, Y))
        assert call_everything(X[::2], Y[::2]) == pytest.approx(expected, rel=1e-12)

    def test_lists(self, d):
        X, Y = pair(0, d, n=20)
        for function in (am.ate, am.rpe, am.drift_rate):
            assert repr(function(X.tolist(), list(Y))) == repr(function(X, Y))

    def test_short_numbers(self, d):
        X, Y = pair(0, d)
        short = am.ate(X.astype(np.float32), Y.astype(np.float32))
        assert short.rmse == pytest.approx(am.ate(X, Y).rmse, rel=1e-4)
        square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0]])[:, :d]
        assert am.ate(square, square + 1).rmse < 1e-15
        still = np.tile(np.eye(d + 1, dtype=int), (3, 1, 1))
        assert am.rpe(still, still, np.int32(1)).translation.rmse == 0

    def test_one_sample(self, d):
        X = np.eye(d + 1)[None]
        error = am.ate(X, X, align="none")
        assert (error.n, error.rmse, error.std, error.p95) == (1, 0, 0, 0)
        assert error.rotation.n == 1
        with pytest.raises(am.DegenerateAlignmentError, match="single position"):
            am.ate(X, X)
        for unit in ("frames", "metres", "seconds", "degrees"):
            for pairs in ("all", "consecutive"):
                with pytest.raises(am.AmrError, match=r"1 sample|one sample|no two orientations"):
                    am.rpe(X, X, 1, unit, pairs, stamps=[0.0])
        with pytest.raises(am.AmrError, match="does not move"):
            am.drift_rate(X, X, align="none")
        with pytest.raises(am.AmrError, match="0 m long, too short"):
            am.segment_drift(X, X)

    def test_poses_beside_positions(self, d):
        X, Y = pair(0, d)
        mixed = am.ate(X, am.positions(Y))
        assert mixed.rmse == am.ate(X, Y).rmse
        assert mixed.rotation is None

    def test_map_coordinates_keep_their_digits(self, d):
        X, Y = pair(0, d)
        far = np.zeros(d)
        far[:2] = 5e5, 5.4e6
        Xf, Yf = X.copy(), Y.copy()
        Xf[:, :d, d] += far
        Yf[:, :d, d] += far
        for mode in ("none", "rigid", "similarity"):
            a, b = am.ate(X, Y, mode), am.ate(Xf, Yf, mode)
            assert np.allclose(a.series, b.series, atol=1e-8)
        a, b = am.rpe(X, Y, 1, "metres"), am.rpe(Xf, Yf, 1, "metres")
        assert np.array_equal(a.pairs, b.pairs)
        assert np.allclose(a.translation.series, b.translation.series, atol=1e-8)
        assert am.drift_rate(Xf, Yf).rate == pytest.approx(am.drift_rate(X, Y).rate, rel=1e-6)

    def test_equal_trajectories_have_no_error_at_all(self, d):
        X, _ = pair(0, d)
        X[:, :d, :d] = X[:, :d, :d].round(6)  # as read from a file with few digits
        found = am.rpe(X, X, 3)
        assert found.translation.max == found.rotation.max == 0
        assert am.ate(X, X, "none").rotation.max == 0

    @pytest.mark.parametrize("angle", [1e-12, 1e-6, 1.0, 3.0, np.pi - 1e-6, np.pi - 1e-10, np.pi])
    def test_rotation_errors_keep_their_digits_at_both_ends(self, d, angle):
        rng = np.random.default_rng(1)
        X = np.repeat(walk(rng, 1, d), 5, axis=0)
        axis = [0, 0, 1] if d == 2 else rng.normal(size=3)
        R = Rotation.from_rotvec(angle * np.array(axis) / np.linalg.norm(axis)).as_matrix()
        Y = X.copy()
        Y[1::2, :d, :d] = Y[1::2, :d, :d] @ R[:d, :d]
        expected = pytest.approx(angle, rel=1e-9, abs=3e-16)
        assert am.ate(X, Y, "none").rotation.max == expected
        assert am.rpe(X, Y).rotation.max == expected


class TestInvariance:
    @pytest.mark.parametrize("d", [2, 3])
    def test_rpe_does_not_see_where_either_trajectory_lies(self, rng, d):
        X, Y = pair(1, d)
        G, H = random_poses(rng, 2, d, 10, 3)
        for unit in ("frames", "metres", "degrees"):
            a, b = am.rpe(X, Y, 1, unit), am.rpe(G @ X, H @ Y, 1, unit)
            assert np.allclose(a.translation.series, b.translation.series, atol=1e-12)
            assert np.allclose(a.rotation.series, b.rotation.series, atol=1e-12)

    def test_ate_rotation_is_built_in(self, rng):
        X = walk(rng, 50, 2)
        wrong = rng.uniform(-3.1, 3.1, 50)
        Y = am.planar_poses(am.positions(X), am.yaw(X) + wrong)
        for mode in ("none", "rigid", "yaw"):
            assert np.allclose(am.ate(X, Y, mode).rotation.series, np.abs(wrong))

    def test_drift_is_ate_per_meter(self):
        X, Y = pair(2, 3)
        for mode in ("none", "rigid"):
            drift = am.drift_rate(X, Y, mode)
            assert drift.rate == float(drift) == am.ate(X, Y, mode).rmse / am.path_length(X)

    def test_a_scale_error_is_a_drift_in_percent(self):
        x = np.arange(2000.0)
        X, Y = (am.planar_poses(np.c_[s * x, 0 * x], 0 * x) for s in (1, 1.01))
        found = am.segment_drift(X, Y, lengths=[100])
        # KITTI ends a segment at the first sample farther than 100 m: after 101 steps of 1 m.
        assert found.translation_percent == pytest.approx(0.01 * 101)
        assert found.rotation_deg_per_100m == pytest.approx(0, abs=1e-12)


class TestSummary:
    def test_the_numbers_that_papers_print(self):
        error = am.ate([[0, 0]] * 4, [[0, 0], [3, 4], [0, 10], [0, 5]], align="none")
        assert error.series.tolist() == [0, 5, 10, 5]
        assert error.rmse == float(error) == pytest.approx(np.sqrt(150 / 4))
        assert (error.mean, error.median, error.min, error.max, error.n) == (5, 5, 0, 10, 4)
        assert error.rmse**2 == pytest.approx(error.mean**2 + error.std**2)
        assert error.p95 == pytest.approx(9.25)

    def test_says_how_it_was_made(self):
        X, Y = pair(0, 2)
        error = am.ate(X, Y, "similarity")
        for text in (repr(error), error._repr_html_()):
            assert "ATE" in text
            assert "alignment" in text
            assert "similarity" in text
            assert "200" in text
        assert " rad (" in repr(error.rotation)
        found = am.rpe(X, Y, 0.5, "metres")
        for text in (repr(found), found._repr_html_()):
            assert "RPE" in text
            assert "delta 0.5 m, all pairs" in text
            assert "no alignment needed" in text
            assert f"{found.left_out} left out" in text
            assert f"{found.lengths.max():.6g}" in text
        assert "\n" not in repr(found)
        drift = am.drift_rate(X, Y)
        assert "aligned: rigid" in repr(drift)
        assert repr(drift) in drift._repr_html_()
        segments = am.segment_drift(X, Y, [1, 2])
        assert "segments of 1, 2 m" in repr(segments)
        assert "<td>2 m</td>" in segments._repr_html_()

    def test_pooling_one_run_changes_no_number(self):
        error = am.ate(*pair(0, 2))
        assert am.pool([error]).rmse == am.pool(error).rmse == error.rmse


EYES = np.tile(np.eye(3), (5, 1, 1))
ROAD = am.planar_poses(np.c_[np.arange(5.0), np.zeros(5)], np.zeros(5))
SUMMARY = am.ate(ROAD, ROAD, "none")
REFUSED = {
    "ate nan": (lambda: am.ate(ROAD + np.nan, ROAD), r"reference\[0, 0, 0\] is nan"),
    "ate inf": (lambda: am.ate(ROAD, ROAD[:, :2, 2] + np.inf), r"estimate\[0, 0\] is inf"),
    "ate ragged": (lambda: am.ate([[1, 2], [3]], [[1, 2], [3, 4]]), "rows have different lengths"),
    "ate text": (lambda: am.ate("ab", ROAD), "reference must be an array of real numbers"),
    "ate lengths": (lambda: am.ate(ROAD, ROAD[:4]), "5 samples and estimate has 4"),
    "ate dimensions": (lambda: am.ate(ROAD, np.eye(4)[None]), "reference is 2-D and estimate"),
    "ate shape": (lambda: am.ate(ROAD, np.zeros((5, 7))), r"estimate has shape \(5, 7\)"),
    "ate single poses": (lambda: am.ate(ROAD[1], ROAD[2], "none"), "reference is a single pose"),
    "ate single pose in space": (lambda: am.ate(np.eye(4), np.eye(4)), "is a single pose of shape"),
    "ate transposed": (lambda: am.ate(ROAD.swapaxes(1, 2), ROAD), "Is it transposed"),
    "ate nan in a rotation": (
        lambda: am.ate(ROAD, np.where(np.arange(3) == 0, np.nan, ROAD)),
        r"estimate\[0, 0, 0\] is nan",
    ),
    "path of transposed": (lambda: am.path_length(ROAD.swapaxes(1, 2)), "Is it transposed"),
    "align first": (lambda: am.align(ROAD, ROAD, first=0), "first is 0; expected a whole number"),
    "align origin": (
        lambda: am.align(ROAD[:, :2, 2], ROAD[:, :2, 2], "origin"),
        "poses need shape",
    ),
    "body of positions": (lambda: am.ate(ROAD, ROAD[:, :2, 2], body=EYES[0]), "poses need shape"),
    "body in space": (lambda: am.ate(ROAD, ROAD, body=np.eye(4)), r"expected one pose \(3, 3\)"),
    "ate empty": (lambda: am.ate(ROAD[:0], ROAD[:0]), "reference is empty"),
    "ate mode": (lambda: am.ate(ROAD, ROAD, "umeyama"), "'umeyama'; expected one of 'rigid'"),
    "ate still": (lambda: am.ate(EYES, EYES), "5 positions that all coincide"),
    "ate huge": (lambda: am.ate(ROAD[:, :2, 2] * 1e200, ROAD), "4e.200 m; more than"),
    "ate huge poses": (
        lambda: am.ate(ROAD, am.planar_poses(np.full((5, 2), 1e200), np.zeros(5))),
        "estimate holds a coordinate of 1e.200 m",
    ),
    "ate mirrored": (lambda: am.ate(ROAD, ROAD * [[1], [-1], [1]]), "is a reflection"),
    "ate scaled": (lambda: am.ate(ROAD, ROAD * [[2], [2], [1]]), "not a rotation matrix"),
    "ate overflowing": (lambda: am.ate(ROAD, ROAD * [[1e200], [2], [1]]), "estimate.*coordinate"),
    "rpe overflowing": (
        lambda: am.rpe(EYES, EYES * [[1e200], [2], [1]]),
        r"estimate\[0\] is not a pose",
    ),
    "rpe positions": (lambda: am.rpe(ROAD[:, :2, 2], ROAD[:, :2, 2]), r"poses need shape \(N, 3"),
    "rpe transposed": (
        lambda: am.rpe(ROAD, ROAD.swapaxes(1, 2)),
        r"estimate\[1\] .* Is it transposed",
    ),
    "rpe unit": (
        lambda: am.rpe(ROAD, ROAD, 1, "km"),
        "unit is 'km'; expected one of 'frames', 'm'",
    ),
    "rpe pairs": (lambda: am.rpe(ROAD, ROAD, pairs="some"), "pairs is 'some'; expected 'all'"),
    "rpe delta sign": (lambda: am.rpe(ROAD, ROAD, -1), "delta is -1.0; expected .* greater than 0"),
    "rpe delta nan": (lambda: am.rpe(ROAD, ROAD, np.nan), "delta is nan"),
    "rpe delta inf": (lambda: am.rpe(ROAD, ROAD, np.inf), "delta is inf"),
    "rpe delta text": (lambda: am.rpe(ROAD, ROAD, "1"), "delta must be an array of real numbers"),
    "rpe two deltas": (lambda: am.rpe(ROAD, ROAD, [1, 2]), "expected one number of frames"),
    "rpe half a frame": (lambda: am.rpe(ROAD, ROAD, 1.5), "1.5 frames; expected a whole number"),
    "rpe too many frames": (lambda: am.rpe(ROAD, ROAD, 5), "delta is 5 frames, but .* 5 samples"),
    "rpe many frames": (lambda: am.rpe(ROAD, ROAD, 1e300), "frames, but the recording has 5"),
    "rpe 200 degrees": (lambda: am.rpe(ROAD, ROAD, 200, "degrees"), "at most 180 degrees"),
    "rpe no turn": (lambda: am.rpe(ROAD, ROAD, 9, "degrees"), "no two orientations are 9 degrees"),
    "rpe no turns": (
        lambda: am.rpe(ROAD, ROAD, 9, "degrees", "consecutive"),
        "spans delta=9 deg .* covers 0 deg",
    ),
    "rpe too long": (
        lambda: am.rpe(ROAD, ROAD, 7, "metres"),
        r"spans delta=7 m within 10 %: the reference covers 4 m in steps of 1 \(median\)",
    ),
    "rpe no stamps": (lambda: am.rpe(ROAD, ROAD, 1, "seconds"), "stamps are missing"),
    "rpe few stamps": (
        lambda: am.rpe(ROAD, ROAD, 1, "seconds", stamps=[1, 2]),
        "stamps has 2 entries for 5 poses",
    ),
    "rpe repeated stamps": (
        lambda: am.rpe(ROAD, ROAD, 1, "seconds", stamps=[1, 2, 2, 3, 4]),
        "stamps repeat at index 2",
    ),
    "rpe too short": (
        lambda: am.rpe(ROAD, ROAD, 0.1, "seconds", stamps=range(5)),
        "spans delta=0.1 s",
    ),
    "drift still": (lambda: am.drift_rate(EYES, EYES, "none"), "does not move"),
    "segments short": (
        lambda: am.segment_drift(ROAD, ROAD),
        "4 m long, too short for 100 m segments",
    ),
    "segments length": (lambda: am.segment_drift(ROAD, ROAD, [0, 1]), "expected positive numbers"),
    "segments none": (lambda: am.segment_drift(ROAD, ROAD, []), r"lengths are \[\]"),
    "segments nan": (lambda: am.segment_drift(ROAD, ROAD, [np.nan]), r"lengths\[0\] is nan"),
    "segments step": (lambda: am.segment_drift(ROAD, ROAD, [1], 0), "step is 0; expected a whole"),
    "segments half step": (lambda: am.segment_drift(ROAD, ROAD, [1], 1.5), "step is 1.5"),
    "segments lengths": (lambda: am.segment_drift(ROAD, ROAD[:2]), "estimate has 2"),
    "pool nothing": (lambda: am.pool([]), "summaries is empty"),
    "pool numbers": (lambda: am.pool([1.0]), r"summaries\[0\] is of type float"),
    "pool both": (
        lambda: am.pool([am.rpe(ROAD, ROAD)]),
        "RelativeError; expected .* translation or rotation",
    ),
    "pool units": (lambda: am.pool([SUMMARY, SUMMARY.rotation]), "differ in what they measure"),
    "pool alignments": (
        lambda: am.pool([SUMMARY, am.ate(ROAD, ROAD)]),
        "ATE, aligned: none; ATE, aligned: rigid",
    ),
    "pool deltas": (
        lambda: am.pool([am.rpe(ROAD, ROAD, k).translation for k in (1, 2)]),
        "delta 1 frames, .*; RPE translation, delta 2 frames",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refuses_with_a_message(case):
    call, message = REFUSED[case]
    with pytest.raises(am.AmrError, match=message):
        call()
