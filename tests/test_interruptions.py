"""Jumps and lost time are found where they were planted, at the edge of their rules, too."""

import json

import numpy as np
import pytest

import amrmetrics as am

T = 1e9 + np.arange(0, 100, 0.1)


def drive(noise=0.0, seed=0, t=T):
    rng = np.random.default_rng(seed)
    s = t - T[0]
    xy = np.c_[s, 5 * np.sin(s / 4)] + noise * rng.normal(size=(len(t), 2))
    return am.Trajectory(t, am.planar_poses(xy, np.arctan(1.25 * np.cos(s / 4))), "drive")


def pushed(run, *pushes):
    """Return the run shifted to the side from some samples on."""
    X = run.poses.copy()
    for k, by in pushes:
        X[k:, 1, 2] += by
    return am.Trajectory(run.stamps, X, run.source)


class TestJumps:
    def test_a_good_run_has_none(self):
        for noise in (0, 0.001, 0.01, 0.1):
            found = am.evaluate(drive(), drive(noise)).jumps
            assert found.count == 0
            assert found.steps == 999

    def test_planted_ones_are_counted_and_the_worst_has_its_time(self):
        run = pushed(drive(0.002), (300, 0.2), (500, -0.9), (700, 0.4))
        report = am.evaluate(drive(), run)
        found = report.jumps
        assert found.count == 3
        assert float(found) == 3
        assert found.index == 500
        assert found.time == T[500]
        assert found.largest == pytest.approx(0.9, abs=0.02)
        assert "3 of 999 steps off by more than 0.05 m, the worst by 0.899 m" in repr(report)
        assert f"at {T[500]:.6f} s" in repr(report)
        assert "jumps" in report._repr_html_()
        rows = report.as_dict()["jumps"]
        assert rows["count"] == 3
        assert json.loads(json.dumps(rows, allow_nan=False)) == rows

    @pytest.mark.parametrize(("by", "count"), [(0.0499, 0), (0.0501, 1)])
    def test_the_floor(self, by, count):
        found = am.evaluate(drive(), pushed(drive(), (300, by))).jumps
        assert found.threshold == 0.05
        assert found.count == count

    def test_the_floor_itself_is_no_jump(self):
        still = am.Trajectory(T, np.zeros((len(T), 2)))
        for by, count in ((0.05, 0), (np.nextafter(0.05, 1), 1)):
            moved = am.Trajectory(T, np.c_[np.where(np.arange(len(T)) < 300, 0, by), 0 * T])
            assert am.evaluate(still, moved, align="none").jumps.count == count

    def test_the_worst_is_found_behind_a_gap(self):
        kept = (np.arange(len(T)) < 100) | (np.arange(len(T)) > 200)
        found = am.evaluate(drive(), pushed(drive(), (300, 0.6))[kept]).jumps
        assert (found.index, found.time) == (199, T[300])

    def test_ten_robust_deviations(self):
        noise = 0.05
        clean = am.evaluate(drive(), drive(noise))
        series = am.rpe(drive(), drive(noise)).translation.series
        middle = np.median(series)
        expected = middle + 10 * 1.4826 * np.median(np.abs(series - middle))
        assert clean.jumps.threshold == pytest.approx(expected)
        assert clean.jumps.threshold > 0.3
        for by, count in ((0.7, 0), (1.3, 1)):
            found = am.evaluate(drive(), pushed(drive(noise), (300, by * expected))).jumps
            away = am.rpe(drive(), pushed(drive(noise), (300, by * expected))).translation.series
            assert found.count == count == (away > found.threshold).sum()

    def test_positions_alone(self):
        run = pushed(drive(0.002), (300, 0.6))
        bare = am.Trajectory(T, run.positions)
        found = am.evaluate(drive(), bare).jumps
        assert (found.count, found.index) == (1, 300)
        assert found.largest == pytest.approx(0.6, abs=0.02)
        turned = bare.positions @ [[0, -1], [1, 0]]
        assert am.evaluate(drive(), am.Trajectory(T, turned)).jumps.count == 1

    def test_a_step_across_a_gap_is_lost_time(self):
        run = pushed(drive(), (300, 0.6))
        gone = (np.arange(len(T)) > 280) & (np.arange(len(T)) < 320)
        report = am.evaluate(drive(), run[~gone])
        assert report.jumps.count == 0
        assert report.jumps.steps == 999 - gone.sum() - 1
        assert report.lost_seconds.seconds == pytest.approx(4.0)
        assert am.evaluate(drive(), run[~gone], max_gap=5).jumps.count == 1

    def test_a_step_as_long_as_a_gap_may_be_is_one(self):
        t = np.arange(0, 100.0)
        run = am.Trajectory(t, am.planar_poses(np.c_[t, np.sin(t)], 0 * t))
        assert am.evaluate(run, run, max_gap=1).jumps.steps == 99
        assert am.evaluate(run, run, max_gap=0.99).jumps is None

    def test_without_stamps(self):
        run = pushed(drive(), (300, 0.6))
        pair = [am.Trajectory(None, x.poses) for x in (drive(), run)]
        report = am.evaluate(*pair)
        assert (report.jumps.count, report.jumps.index) == (1, 300)
        assert "at sample 300" in repr(report)
        assert report.lost_seconds is None
        assert report.as_dict()["jumps"]["time"] is None
        assert "lost time" not in repr(report)

    def test_a_single_sample_has_no_step(self):
        one = am.Trajectory(T[:1], drive().poses[:1])
        report = am.evaluate(one, one, align="none")
        assert report.jumps is None
        assert report.as_dict()["jumps"] is None


class TestLostTime:
    def test_nothing_is_lost_at_a_lower_rate(self):
        for every in (1, 5, 30):
            report = am.evaluate(drive(), drive()[::every])
            assert report.lost_seconds.stretches == 0, every
            assert float(report.lost_seconds) == 0
            assert np.isnan(report.lost_seconds.start)
        assert "no stretch of more than 30 s" in repr(report)

    def test_planted_ones(self):
        k = np.arange(len(T))
        kept = (k >= 50) & ~((k > 200) & (k < 280)) & ~((k > 500) & (k < 620)) & (k <= 900)
        report = am.evaluate(drive(), drive()[kept])
        lost = report.lost_seconds
        assert lost.stretches == 4
        assert lost.seconds == pytest.approx(5 + 8 + 12 + 9.9)
        assert lost.longest == pytest.approx(12)
        assert lost.start == T[500]
        assert "34.9 s without a matched estimate, in 4 stretches of more than 1 s" in repr(report)
        assert f"the longest 12 s from {T[500]:.6f} s" in repr(report)
        rows = report.as_dict()["lost_seconds"]
        assert rows["longest"] == lost.longest

    @pytest.mark.parametrize(("gap", "stretches"), [(1.0, 0), (1.01, 1)])
    def test_the_edge_of_a_gap(self, gap, stretches):
        """Ten usual steps of 0.1 s and a second are the same, and no longer lost."""
        s = np.r_[np.arange(0, 5, 0.125), 4.875 + gap + np.arange(0, 5, 0.125)]
        X = am.planar_poses(np.c_[s, np.sin(s)], 0 * s)
        run = am.Trajectory(s, X)
        lost = am.evaluate(run, run, max_gap=1.0).lost_seconds
        assert lost.limit == 1
        assert lost.stretches == stretches

    @pytest.mark.parametrize("at", ["start", "end"])
    def test_the_edges_of_the_reference(self, at):
        for samples, stretches in ((10, 0), (11, 1)):
            run = drive()[samples:] if at == "start" else drive()[: len(T) - samples]
            found = am.evaluate(drive(), run, max_gap=1.05).lost_seconds
            assert found.stretches == stretches

    def test_the_table_has_both(self):
        k = np.arange(len(T))
        jumpy = pushed(drive(0.002, 1), (300, 0.6))
        lost = drive(0.002, 2)[(k < 400) | (k > 500)]
        found = am.evaluate(drive(), {"jumpy": jumpy, "lost": lost})
        rows = {row["estimate"]: row for row in found.table()}
        assert (rows["jumpy"]["jumps"], rows["jumpy"]["lost_s"]) == (1, 0)
        assert rows["lost"]["jumps"] == 0
        assert rows["lost"]["lost_s"] == pytest.approx(10.2)
        assert "jumps" in repr(found)
