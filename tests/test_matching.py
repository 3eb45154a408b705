"""Matched pairs cover what they say, gaps are not bridged, every metric carries the coverage."""

import numpy as np
import pytest

import amrmetrics as am

T = np.arange(0, 20, 0.05)


def drive(t, noise=0.0, seed=0):
    rng = np.random.default_rng(seed)
    xy = np.c_[t, np.sin(t)] + noise * rng.normal(size=(len(t), 2))
    return am.Trajectory(t, am.planar_poses(xy, np.arctan(np.cos(t))), "drive")


class TestMatch:
    def test_pairs_are_those_of_associate(self):
        truth, run = drive(T), drive(T[::3] + 0.004)
        i, j = am.associate(truth.stamps, run.stamps)
        reference, estimate = am.match(truth, run)
        assert np.array_equal(reference.stamps, truth.stamps[i])
        assert np.array_equal(estimate.poses, run.poses[j])

    def test_says_how_much_was_matched(self):
        truth = drive(T)
        run = truth[np.r_[0:50, 90:120]]
        found = am.match(truth, run)
        c = found.coverage
        assert (c.matched, c.reference, c.estimate, c.left_out) == (80, 400, 80, 0)
        assert c.duration == pytest.approx(119 * 0.05)
        assert c.reference_duration == pytest.approx(399 * 0.05)
        assert c.longest_gap == pytest.approx(41 * 0.05)
        assert c.share == pytest.approx(119 / 399)
        assert repr(found) == (
            "matched 80 of 400 reference and of 80 estimated poses, 5.95 of 19.95 s (30 %), "
            "longest gap 2.05 s"
        )

    def test_every_metric_carries_and_prints_the_coverage(self):
        pair = am.match(drive(T), drive(T[:100], 0.01))
        for result in (
            am.ate(*pair),
            am.ate(*pair).rotation,
            am.rpe(*pair),
            am.rpe(*pair).rotation,
        ):
            assert result.coverage is pair.coverage
            assert "matched 100 of 400 reference" in repr(result)
            assert "matched 100 of 400 reference" in result._repr_html_() or "RPE" in repr(result)
        for result in (am.drift_rate(*pair), am.segment_drift(*pair, lengths=[1])):
            assert result.coverage is pair.coverage
            assert "matched 100 of 400 reference" in repr(result)
        assert am.ate(*pair).as_dict()["coverage"]["matched"] == 100
        assert am.ate(*pair[10:20]).coverage is pair.coverage
        assert am.ate(drive(T), drive(T)).coverage is None

    def test_a_clock_offset_is_applied(self):
        truth, run = drive(T), drive(T)
        late = am.Trajectory(T - 3.2, run.poses)
        pair = am.match(truth, late, offset=3.2)
        assert pair.coverage.matched == len(T)
        assert am.ate(*pair).rmse < 1e-12
        assert "offset 3.2 s" in repr(pair)

    def test_interpolates_the_reference(self):
        truth, t = drive(T), np.arange(0.513, 19, 0.1)
        pair = am.match(truth, drive(t), interpolate=True)
        assert pair.coverage.matched == len(t)
        assert np.array_equal(pair.reference.stamps, t)
        assert am.ate(*pair, align="none").rmse < 1e-3
        assert am.ate(*am.match(truth, drive(t), 0.05), align="none").rmse > 0.01

    def test_interpolation_reaches_both_ends_of_the_reference(self):
        truth = drive(T)
        pair = am.match(truth, drive(T[[0, 7, -1]]), interpolate=True)
        assert pair.coverage.matched == 3
        assert pair.coverage.left_out == 0
        assert pair.coverage.reference == len(T)
        assert pair.coverage.duration == pytest.approx(T[-1])
        late = am.match(truth, drive(T[100:120]), interpolate=True).coverage
        assert late.duration == pytest.approx(0.95)
        numbered = am.Trajectory(T, truth.poses, frames=np.arange(len(T)))
        found = am.match(numbered, drive(T[:20] + 0.02), interpolate=True)
        assert found.reference.frames is None

    def test_a_single_pose_covers_itself(self):
        one = drive(T[:1])
        assert am.match(one, one).coverage.share == 1

    def test_stamps_of_one_side_are_enough_to_tell_the_duration(self):
        truth, run = drive(T), am.Trajectory(None, drive(T).poses)
        for pair in (am.match(truth, run), am.match(run, truth)):
            assert pair.coverage.duration == pytest.approx(T[-1])
            assert pair.how == "order in the files"
        numbered = am.Trajectory(None, drive(T).poses, frames=np.arange(len(T)))
        assert am.match(numbered, run).how == "order in the files"

    def test_leaves_out_what_falls_in_a_gap_and_counts_it(self):
        gone = (T > 5) & (T < 12)
        truth, run = drive(T)[~gone], drive(T + 0.02)
        pair = am.match(truth, run, interpolate=True)
        assert pair.coverage.left_out == len(T) - pair.coverage.matched == gone.sum() + 2
        assert "141 left out" in repr(pair)
        assert am.ate(*pair, align="none").max < 1e-3
        bridged = am.match(truth, run, interpolate=True, max_gap=10)
        assert bridged.coverage.left_out == 1  # after the end
        assert am.ate(*bridged, align="none").max > 0.5

    @pytest.mark.parametrize(("gap", "kept"), [(1.0, True), (1.05, False)])
    def test_the_default_gap_is_ten_usual_steps_and_at_least_a_second(self, gap, kept):
        t = np.r_[np.arange(0, 5, 0.1), 4.9 + gap + np.arange(0, 5, 0.1)]
        run = am.Trajectory(np.array([2.03, 4.9 + gap / 2]), np.zeros((2, 2)))
        pair = am.match(am.Trajectory(t, np.zeros((len(t), 2))), run, interpolate=True)
        assert pair.coverage.matched == 1 + kept

    @pytest.mark.parametrize(("gap", "kept"), [(1.95, True), (2.05, False)])
    def test_and_ten_usual_steps_where_these_are_longer(self, gap, kept):
        t = np.r_[np.arange(0, 5, 0.2), 4.8 + gap + np.arange(0, 5, 0.2)]
        run = am.Trajectory(np.array([2.03, 4.8 + gap / 2]), np.zeros((2, 2)))
        pair = am.match(am.Trajectory(t, np.zeros((len(t), 2))), run, interpolate=True)
        assert pair.coverage.matched == 1 + kept

    def test_kitti_without_stamps(self):
        X = drive(T).poses
        a, b = am.Trajectory(None, X), am.Trajectory(None, X)
        pair = am.match(a, b)
        assert pair.how == "order in the files"
        assert np.isnan(pair.coverage.duration)
        assert pair.coverage.share == 1
        with pytest.raises(am.AmrError, match=r"read_kitti\(path, times=...\)"):
            am.match(a, b[:300])
        frames = np.arange(400)
        some = am.Trajectory(None, X[::3], frames=frames[::3])
        pair = am.match(am.Trajectory(None, X, frames=frames), some)
        assert pair.how == "frame numbers"
        assert np.array_equal(pair.reference.poses, pair.estimate.poses)

    def test_refuses_what_it_cannot_pair(self):
        with pytest.raises(am.AmrError, match=r"am.Trajectory\(stamps, poses\)"):
            am.match(drive(T).poses, drive(T))
        with pytest.raises(am.AmrError, match="no stamps match"):
            am.match(drive(T), drive(T + 100))
        with pytest.raises(am.AmrError, match="no estimate can be matched: the reference runs"):
            am.match(drive(T), drive(T + 100), interpolate=True)
        with pytest.raises(am.AmrError, match="gaps of more than max_gap=1 s wherever"):
            am.match(drive(T)[[0, -1]], drive(T[100:200]), interpolate=True, max_gap=1)


class TestWhatEverybodyTypesFirst:
    def test_two_recordings_of_different_length(self):
        truth, run = drive(T), drive(T[::2])
        with pytest.raises(am.AmrError, match="Match them first: ") as caught:
            am.ate(truth, run)
        advice = str(caught.value).split("Match them first: ")[1].rstrip(".")
        names = {"am": am, "reference": truth, "estimate": run}
        exec(advice, names)
        assert am.ate(names["reference"], names["estimate"]).n == 200

    def test_equal_length_and_other_stamps(self):
        with pytest.raises(am.AmrError, match=r"of reference and of estimate are 0\.03 s apart"):
            am.ate(drive(T), drive(T + 0.03))
        assert am.ate(drive(T), drive(T + 0.02)).n == 400

    def test_an_advised_offset_is_exact(self):
        epoch = 1403636580.838555574
        truth, run = drive(T), drive(T)
        later = am.Trajectory(T + epoch, truth.poses)
        with pytest.raises(am.AmrError) as caught:
            am.match(later, run)
        offset = float(str(caught.value).split("try offset=")[1].split(" ")[0])
        assert am.match(later, run, offset=offset).coverage.matched == 400

    def test_an_advised_difference_is_enough(self):
        for late in (0.0103, 0.02, 0.0249999):
            with pytest.raises(am.AmrError) as caught:
                am.match(drive(T), drive(T[::10] + late))
            wide = float(str(caught.value).split("Try max_difference=")[1].split(" ")[0])
            assert am.match(drive(T), drive(T[::10] + late), wide).coverage.matched == 40


class TestInterpolate:
    def test_takes_and_returns_a_trajectory(self):
        run = am.interpolate(drive(T), T[:-1] + 0.025)
        assert isinstance(run, am.Trajectory)
        assert np.allclose(am.positions(run)[:, 0], T[:-1] + 0.025)

    def test_arrays_refuse_a_gap(self):
        gone = (T > 5) & (T < 12)
        truth, t = drive(T)[~gone], T[:-1] + 0.025
        with pytest.raises(am.AmrError, match="140 of 399 new_stamps lie where"):
            am.interpolate(truth.stamps, truth.poses, t)
        assert len(am.interpolate(truth.stamps, truth.poses, t, max_gap=8)) == 399
        found = am.interpolate(truth, t)
        assert len(found) == 259
        assert found.repairs == ("140 of 399 stamps in gaps left out",)

    @pytest.mark.parametrize("gap", [0, -1, "1", [1, 2], np.nan])
    def test_refuses_other_gaps(self, gap):
        with pytest.raises(am.AmrError, match="max_gap is"):
            am.interpolate(T, drive(T).poses, T, max_gap=gap)
