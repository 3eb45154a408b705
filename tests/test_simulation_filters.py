"""The simulated robot does what it says; the honest filter is consistent, the others are caught.

Each test of consistency has confidence 0.999: at 20 seeds a filter that is consistent raises
a false alarm with probability 1 - 0.999^20 = 2 %, for each metric that is tested.
"""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import chi2, kstest

import amrmetrics as am
from amrmetrics import plotting
from amrmetrics import simulation as sim

SEEDS = range(20)
CONFIDENCE = 0.999
RUNS = 100


def drive(seed, runs=RUNS, steps=60, **options):
    return sim.drive(np.random.default_rng(seed), runs=runs, steps=steps, **options)


def nees(run, log, k=-1):
    errors = am.pose_errors(run.truth[:, k], log.estimate[:, k])
    return am.nees(errors, log.covariances[:, k])


def nis(log):
    """NIS of every update, one row per run."""
    nu, S = log.innovations[:, log.used], log.S[:, log.used]
    return am.nis(nu.reshape(-1, 2), S.reshape(-1, 2, 2)).reshape(len(nu), -1)


def verdict(values, dof):
    """Verdict on independent runs: one column, so that no correlation in time is looked for."""
    return am.consistency_test(values[:, None], dof, CONFIDENCE).verdict


def derivative(f, i, *arguments, h=1e-6):
    """Central differences by argument `i`, column by column; right to about 1e-9."""

    def moved(d):
        return f(*arguments[:i], arguments[i] + d, *arguments[i + 1 :])

    return np.stack([(moved(d) - moved(-d)) / (2 * h) for d in h * np.eye(len(arguments[i]))], -1)


def move(x, u, dt):
    return sim.motion_model(x, u, dt)[0]


def see(x, m):
    return sim.measurement_model(x, m)[0]


@pytest.fixture
def seeds(request):
    """For the claims that take longest."""
    return SEEDS if request.config.getoption("--sweep") else SEEDS[:3]


class TestModels:
    def test_motion_jacobians(self, rng):
        for _ in range(50):
            x, u, dt = rng.normal(size=3) * 3, rng.normal(size=2) * 2, rng.uniform(0.01, 1)
            _, F, G = sim.motion_model(x, u, dt)
            assert np.allclose(F, derivative(move, 0, x, u, dt), rtol=0, atol=1e-8)
            assert np.allclose(G, derivative(move, 1, x, u, dt), rtol=0, atol=1e-8)

    def test_measurement_jacobians(self, rng):
        for _ in range(50):
            x, m = rng.normal(size=3) * 3, rng.normal(size=2) * 3 + [14, 0]
            x[2] = rng.uniform(-1, 1)  # the landmark is ahead: the bearing does not jump
            _, H = sim.measurement_model(x, m)
            assert np.allclose(H, derivative(see, 0, x, m), rtol=0, atol=1e-8)
            assert np.allclose(-H[:, :2], derivative(see, 1, x, m), rtol=0, atol=1e-8)

    def test_one_step_differs_from_the_arc_by_the_third_order(self):
        v, w, start = 1.3, 0.7, 0.4

        def off(dt):
            arc = [math.sin(start + w * dt) - math.sin(start),
                   math.cos(start) - math.cos(start + w * dt)]  # fmt: skip
            x = sim.motion_model([0, 0, start], [v, w], dt)[0]
            assert x[2] == pytest.approx(start + w * dt)
            return np.linalg.norm(x[:2] - v / w * np.array(arc))

        assert off(0.1) / off(0.05) == pytest.approx(8, rel=0.01)

    def test_broadcast_over_leading_axes(self, rng):
        x, m = rng.normal(size=(4, 1, 3)), rng.normal(size=(5, 2)) + 9
        z, H = sim.measurement_model(x, m)
        assert z.shape == (4, 5, 2) and H.shape == (4, 5, 2, 3)
        assert np.array_equal(z[2, 3], sim.measurement_model(x[2, 0], m[3])[0])

    def test_a_landmark_to_the_left_and_one_behind(self):
        z, _ = sim.measurement_model([1, 1, math.pi / 2], [[-1, 1], [1, -2]])
        assert z == pytest.approx(np.array([[2, math.pi / 2], [3, -math.pi]]))


class TestDrive:
    def test_shapes(self):
        run = drive(0, runs=3, steps=5)
        assert run.truth.shape == (3, 6, 3, 3)
        assert run.controls.shape == (5, 2)
        assert run.odometry.shape == (3, 5, 2)
        assert run.visible.shape == (5, 8)
        assert run.measurements.shape == (3, 5, 8, 2)
        assert run.prior.shape == (3, 3)

    def test_one_run_one_step_one_landmark(self):
        run = drive(0, runs=1, steps=1, landmarks=[[3, 3]])
        for log in (sim.ekf_localization(run), sim.ekf_slam(run)):
            assert log.estimate.shape == (1, 2, 3, 3)

    def test_the_same_seed_gives_the_same_run(self):
        for a, b in zip(drive(7), drive(7), strict=True):
            assert np.array_equal(a, b, equal_nan=True)
        assert not np.array_equal(drive(7).odometry, drive(8).odometry)

    def test_it_drives_the_circle_it_is_told(self):
        X = drive(0, runs=1, steps=200, speed=1.0, turn_rate=0.3).truth[0]
        distance = np.linalg.norm(am.positions(X) - [0, 1 / 0.3], axis=1)
        assert distance == pytest.approx(np.full(201, 1 / 0.3), rel=1e-3)
        assert am.yaw(X[-1]) == pytest.approx(am.wrap(0.3 * 20))
        assert am.path_length(X) == pytest.approx(20)

    def test_controls_may_change(self):
        speed = np.linspace(0, 2, 60)
        run = drive(0, runs=1, speed=speed, turn_rate=0)
        assert am.positions(run.truth[0, -1]) == pytest.approx([0.1 * speed.sum(), 0])

    def test_measurements_are_range_and_bearing_of_what_is_in_range(self):
        run = drive(0, runs=1, measurement_std=(1e-9, 1e-9), max_range=6)
        for k, X in enumerate(run.truth[0, 1:]):
            for j, m in enumerate(run.landmarks):
                x, y, _ = np.linalg.inv(X) @ [*m, 1]  # the landmark as the robot sees it
                z = run.measurements[0, k, j]
                assert run.visible[k, j] == (math.hypot(x, y) <= 6)
                if run.visible[k, j]:
                    assert z == pytest.approx([math.hypot(x, y), math.atan2(y, x)], abs=1e-7)
                else:
                    assert np.isnan(z).all()
        assert 0 < run.visible.mean() < 1

    def test_noise_is_what_the_filter_is_told(self):
        """Kolmogorov-Smirnov on 4 samples of 3000 and more: false alarms 4 x 0.1 %."""
        run = drive(1, runs=1000, steps=3)
        exact, _ = sim.measurement_model(
            np.c_[am.positions(run.truth[0]), am.yaw(run.truth[0])][1:, None], run.landmarks
        )
        noise = run.measurements - exact
        noise[..., 1] = am.wrap(np.nan_to_num(noise[..., 1]))
        for sample in (
            (run.odometry - run.controls) / run.odometry_std,
            noise[:, run.visible, 0] / run.measurement_std[0],
            noise[:, run.visible, 1] / run.measurement_std[1],
            run.prior / np.sqrt(np.diag(run.prior_covariance)),
        ):
            assert kstest(sample.ravel(), "norm").pvalue > 0.001
            assert kstest(1.2 * sample.ravel(), "norm").pvalue < 0.001  # 20 % off is seen

    def test_bearings_are_wrapped_although_noise_is_added(self):
        run = drive(0, landmarks=[[-5, 0]], turn_rate=0, max_range=20)
        bearings = run.measurements[..., 1]
        assert bearings.min() >= -np.pi and bearings.max() < np.pi
        assert (np.abs(bearings) > 2.9).all() and np.ptp(bearings) > 6

    def test_biases_shift_what_is_measured_and_nothing_else(self):
        plain = drive(3)
        biased = drive(3, odometry_bias=(0.02, -0.01), measurement_bias=(0.05, 0.1))
        shift = biased.measurements - plain.measurements
        assert np.allclose(biased.odometry - plain.odometry, [0.02, -0.01])
        assert np.allclose(shift[:, plain.visible, 0], 0.05)
        assert np.allclose(am.wrap(shift[:, plain.visible, 1]), 0.1)
        assert np.array_equal(biased.truth, plain.truth)

    @pytest.mark.parametrize(
        ("options", "message"),
        [
            ({"landmarks": []}, "landmarks"),
            ({"landmarks": [[1, 2, 3]]}, r"landmarks has shape \(1, 3\)"),
            ({"landmarks": [[3, np.nan]]}, r"landmarks\[0, 1\] is nan"),
            ({"landmarks": [[9, 9], [1, 0.2]]}, r"landmarks\[1\] is .* from the path"),
            ({"runs": 0}, "runs is 0"),
            ({"steps": 2.5}, r"steps is 2\.5"),
            ({"dt": 0}, "dt is 0; expected > 0"),
            ({"speed": [1, 2]}, r"speed has shape \(2,\); expected \(\) or \(60,\)"),
            ({"turn_rate": np.inf}, "turn_rate is inf"),
            ({"odometry_std": 0.1}, r"odometry_std has shape \(\); expected \(2,\)"),
            ({"odometry_std": (-1, 0)}, "odometry_std is .* expected >= 0"),
            ({"measurement_std": (0.1, 0)}, "measurement_std is .* expected > 0"),
            ({"initial_std": (0.1, 0.1)}, "initial_std has shape"),
            ({"odometry_bias": "slip"}, "odometry_bias must be an array of real numbers"),
            ({"measurement_bias": (1, 2, 3)}, "measurement_bias has shape"),
            ({"max_range": -1}, "max_range is -1"),
        ],
    )
    def test_bad_arguments_are_named(self, options, message):
        with pytest.raises(am.AmrError, match=message):
            drive(0, **options)

    @pytest.mark.parametrize("rng", [4, None, np.random.RandomState(4)])
    def test_randomness_comes_from_a_generator_only(self, rng):
        with pytest.raises(am.AmrError, match=r"rng is .* expected a numpy Generator"):
            sim.drive(rng)


def textbook(run, i, mapping, ideal=False):
    """One run through an EKF written from the equations: dense and in information form.

    The derivatives are numerical, the state is (x, y, heading, landmarks seen so far), and
    with `ideal` they are taken at the truth. Returns pose means and covariances.
    """

    def move(x, u):
        middle = x[2] + u[1] * run.dt / 2
        step = np.array([u[0] * math.cos(middle), u[0] * math.sin(middle), u[1]]) * run.dt
        return x + np.r_[step, np.zeros(len(x) - 3)]

    def see(x, j):
        m = x[slots[j] : slots[j] + 2] if mapping else run.landmarks[j]
        seen = complex(*(m - x[:2])) * np.exp(-1j * x[2])  # in the robot's frame
        return np.array([abs(seen), np.angle(seen)])

    def place(x, z):
        direction = x[2] + z[1]
        return np.r_[x, x[:2] + z[0] * np.array([math.cos(direction), math.sin(direction)])]

    def at(k):
        """Return where to linearize."""
        return np.r_[true_poses[k], run.landmarks[list(slots)].ravel()] if ideal else x

    Q, R_inverse = np.diag(run.odometry_std**2), np.diag(run.measurement_std**-2.0)
    true_poses = np.c_[am.positions(run.truth[i]), am.yaw(run.truth[i])]
    x, P, slots = run.prior[i], run.prior_covariance, {}
    means, covariances = [x], [P]
    for k, u in enumerate(run.odometry[i]):
        around = at(k), run.controls[k] if ideal else u
        F, G = derivative(move, 0, *around), derivative(move, 1, *around)
        x, P = move(x, u), F @ P @ F.T + G @ Q @ G.T
        for j in np.flatnonzero(run.visible[k]):
            z = run.measurements[i, k, j]
            if mapping and j not in slots:
                pose = at(k + 1)
                around = pose, z
                if ideal:
                    seen = complex(*(run.landmarks[j] - pose[:2])) * np.exp(-1j * pose[2])
                    around = pose, np.array([abs(seen), np.angle(seen)])
                X, Z = derivative(place, 0, *around), derivative(place, 1, *around)
                slots[j] = len(x)
                x, P = place(x, z), X @ P @ X.T + Z @ np.linalg.inv(R_inverse) @ Z.T
                continue
            H, nu = derivative(see, 0, at(k + 1), j), z - see(x, j)
            nu[1] = math.remainder(nu[1], 2 * math.pi)
            P = np.linalg.inv(np.linalg.inv(P) + H.T @ R_inverse @ H)
            x = x + P @ H.T @ R_inverse @ nu
        means.append(x[:3])
        covariances.append(P[:3, :3])
    return np.array(means), np.array(covariances)


class TestAgainstTheTextbook:
    """Two implementations that share no formula but the models give the same numbers."""

    def compare(self, run, log, **options):
        for i in range(2):
            means, covariances = textbook(run, i, **options)
            estimate = log.estimate[i]
            assert am.positions(estimate) == pytest.approx(means[:, :2], abs=1e-6)
            assert am.wrap(am.yaw(estimate) - means[:, 2]) == pytest.approx(0, abs=1e-6)
            assert log.covariances[i] == pytest.approx(covariances, rel=1e-5, abs=1e-8)

    def test_localization(self):
        run = drive(5, runs=2)
        self.compare(run, sim.ekf_localization(run), mapping=False)

    @pytest.mark.parametrize("jacobians", ["estimate", "truth"])
    def test_slam(self, jacobians):
        run = drive(5, runs=2)
        log = sim.ekf_slam(run, jacobians)
        self.compare(run, log, mapping=True, ideal=jacobians == "truth")

    def test_a_wrong_process_noise_would_be_noticed(self):
        run = drive(5, runs=2)
        with pytest.raises(AssertionError):
            self.compare(run, sim.ekf_localization(run, process_scale=1.01), mapping=False)


class TestLocalization:
    def test_consistent_at_20_seeds(self):
        for seed in SEEDS:
            run = drive(seed)
            log = sim.ekf_localization(run)
            assert verdict(nees(run, log), 3) == "consistent", seed
            assert am.consistency_test(nis(log), 2, CONFIDENCE).verdict == "consistent", seed

    def test_nees_has_the_right_distribution_and_not_only_the_right_mean(self):
        run = drive(20, runs=2000)
        values = nees(run, sim.ekf_localization(run))
        assert kstest(values, chi2(3).cdf).pvalue > 0.001
        assert kstest(values / 1.1, chi2(3).cdf).pvalue < 0.001  # 10 % more variance is seen

    def test_before_the_first_step_nees_is_that_of_the_prior(self):
        run = drive(0)
        log = sim.ekf_localization(run)
        expected = np.sum((run.prior / [0.1, 0.1, 0.05]) ** 2, axis=1)
        assert nees(run, log, 0) == pytest.approx(expected)

    @given(kappa=st.floats(1e-3, 1e3))
    @settings(max_examples=20, deadline=None)
    def test_the_same_scale_everywhere_changes_the_claim_and_not_the_estimate(self, kappa):
        run = drive(1, runs=3, steps=20)
        honest, liar = sim.ekf_localization(run), sim.ekf_localization(run, kappa, kappa, kappa)
        assert np.allclose(liar.estimate, honest.estimate, rtol=0, atol=1e-9)
        assert np.allclose(liar.covariances, kappa * honest.covariances, rtol=1e-7, atol=0)
        assert np.allclose(kappa * nis(liar), nis(honest), rtol=1e-6)
        assert np.allclose(kappa * nees(run, liar), nees(run, honest), rtol=1e-6)

    def test_the_same_ate_and_one_filter_is_dangerously_overconfident(self, seeds):
        """Claims of a third of the standard deviation: power 1 - 1e-12 with 100 runs."""
        kappa = 1 / 9
        assert am.consistency_power(3, RUNS, kappa, CONFIDENCE) > 1 - 1e-12
        for seed in seeds:
            run = drive(seed)
            honest, liar = sim.ekf_localization(run), sim.ekf_localization(run, *3 * [kappa])
            ate = [am.ate(run.truth[0], log.estimate[0]).rmse for log in (honest, liar)]
            assert ate[0] == pytest.approx(ate[1], rel=1e-9)
            assert verdict(nees(run, honest), 3) == "consistent"
            assert verdict(nees(run, liar), 3) == "overconfident"
            assert am.consistency_test(nis(liar), 2, CONFIDENCE).verdict == "overconfident"

    @pytest.mark.parametrize(
        ("metric", "expected", "options", "switches"),
        [
            ("nees", "overconfident", {}, {"process_scale": 1 / 9}),
            ("nis", "underconfident", {}, {"process_scale": 9}),
            ("nees", "overconfident", {}, {"measurement_scale": 1 / 4}),
            ("nis", "overconfident", {}, {"measurement_scale": 1 / 4}),
            ("nees", "underconfident", {}, {"measurement_scale": 4}),
            ("nis", "underconfident", {}, {"measurement_scale": 4}),
            ("nees", "overconfident", {"odometry_bias": (0.1, 0)}, {}),
            ("nees", "overconfident", {"measurement_bias": (0, math.radians(1))}, {}),
            ("nees", "overconfident", {"steps": 120}, {"wrap_innovation": False}),
            ("nis", "overconfident", {"steps": 120}, {"wrap_innovation": False}),
        ],
    )
    def test_what_goes_wrong_is_caught(self, seeds, metric, expected, options, switches):
        """Caught at 20 of 20 seeds (--sweep): power above 0.86 with 95 % confidence."""
        for seed in seeds:
            run = drive(seed, **options)
            log = sim.ekf_localization(run, **switches)
            values, dof = (nees(run, log)[:, None], 3) if metric == "nees" else (nis(log), 2)
            assert am.consistency_test(values, dof, CONFIDENCE).verdict == expected, seed

    def test_a_small_bias_is_not_seen_by_few_runs_but_by_many(self):
        """Wheels 3 % off: why the number of runs belongs to every verdict."""
        few, many = (drive(0, runs=runs, odometry_bias=(0.03, 0)) for runs in (20, 2000))
        assert verdict(nees(few, sim.ekf_localization(few)), 3) == "consistent"
        assert verdict(nees(many, sim.ekf_localization(many)), 3) == "overconfident"

    def test_only_a_landmark_behind_the_robot_needs_the_wrapping(self):
        ahead = drive(0, landmarks=[[9, 3], [9, -3]], turn_rate=0, max_range=20, steps=50)
        behind = drive(0, landmarks=[[-3, 0], [9, -3]], turn_rate=0, max_range=20, steps=50)
        for run, harmless in ((ahead, True), (behind, False)):
            wrapped, not_wrapped = (sim.ekf_localization(run, wrap_innovation=w) for w in (1, 0))
            assert np.array_equal(wrapped.estimate, not_wrapped.estimate) == harmless
            assert np.nanmax(np.abs(wrapped.innovations[..., 1])) <= np.pi
            assert (np.nanmax(np.abs(not_wrapped.innovations[..., 1])) > 6) != harmless

    def test_the_log_says_what_was_used(self):
        run = drive(0, runs=2)
        log = sim.ekf_localization(run)
        assert np.array_equal(log.used, run.visible)
        assert np.isfinite(log.innovations[:, log.used]).all()
        assert np.isnan(log.innovations[:, ~log.used]).all()
        assert np.isnan(log.S[:, ~log.used]).all()

    @pytest.mark.parametrize("name", ["process_scale", "measurement_scale", "prior_scale"])
    @pytest.mark.parametrize("value", [0, -1, np.nan, [1, 2]])
    def test_a_scale_is_positive(self, name, value):
        with pytest.raises(am.AmrError, match=name):
            sim.ekf_localization(drive(0, runs=1, steps=1), **{name: value})


class TestSlam:
    STANDING = {
        "speed": 0, "turn_rate": 0, "odometry_std": (0, 0), "measurement_std": (0.3, 0.1),
        "initial_std": (0.1, 0.1, 0.3),
    }  # fmt: skip

    def test_standing_still_teaches_the_ideal_filter_no_heading(self):
        run = drive(0, **self.STANDING)
        P = sim.ekf_slam(run, "truth").covariances
        assert np.allclose(P, run.prior_covariance, rtol=0, atol=1e-12)

    def test_standing_still_teaches_the_standard_filter_a_heading_that_is_not_there(self):
        """Nothing while it linearizes where the landmark was first seen; then ever more."""
        run = drive(0, **self.STANDING)
        heading = sim.ekf_slam(run).covariances[..., 2, 2]
        assert heading[:, :3] == pytest.approx(np.full((RUNS, 3), 0.09), abs=1e-12)
        assert (heading[:, 3] < 0.09 * (1 - 1e-6)).all()
        assert (np.diff(heading[:, 3:]) <= 1e-15).all()
        assert (heading[:, -1] < 0.5 * 0.09).all()

    def test_what_is_learned_of_the_heading_on_a_drive(self):
        run = drive(0, steps=200)
        for jacobians, learns in (("truth", False), ("estimate", True)):
            heading = sim.ekf_slam(run, jacobians).covariances[..., 2, 2]
            below = heading.min(axis=1) < run.prior_covariance[2, 2] * (1 - 1e-9)
            assert (below == learns).all()

    def test_with_a_known_map_the_heading_is_learned_rightly(self):
        """The landmarks of localization are fixed to the world: that turn can be seen."""
        run = drive(0, **self.STANDING)
        assert (sim.ekf_localization(run).covariances[:, -1, 2, 2] < 0.01 * 0.09).all()

    def test_the_ideal_filter_is_consistent_at_20_seeds_and_the_standard_one_is_not(self):
        """Standard: caught at 20 of 20 seeds, so its power is above 0.86 (95 %)."""
        for seed in SEEDS:
            run = drive(seed, initial_std=(0.1, 0.1, 0.08))
            ideal, standard = sim.ekf_slam(run, "truth"), sim.ekf_slam(run)
            assert verdict(nees(run, ideal), 3) == "consistent", seed
            assert verdict(nees(run, standard), 3) == "overconfident", seed

    def test_the_first_sight_of_a_landmark_is_no_update(self):
        run = drive(0, runs=2)
        log = sim.ekf_slam(run)
        first = run.visible & (np.cumsum(run.visible, axis=0) == 1)
        assert first.any(axis=0).sum() >= 5
        assert np.array_equal(log.used, run.visible & ~first)
        assert np.isnan(log.innovations[:, first]).all()

    def test_without_landmarks_in_range_both_filters_count_steps_only(self):
        run = drive(0, runs=2, max_range=0.1)
        a, b = sim.ekf_localization(run), sim.ekf_slam(run)
        assert np.allclose(a.estimate, b.estimate) and np.allclose(a.covariances, b.covariances)
        assert np.trace(a.covariances[0, -1]) > np.trace(a.covariances[0, 0])

    def test_where_the_robot_believes_to_start_turns_the_whole_estimate(self):
        """The prior is the only thing that ties robot and map to the world."""
        run = drive(2, runs=2)
        a = sim.ekf_slam(run).estimate
        b = sim.ekf_slam(run._replace(prior=run.prior + [3, -2, 0.5])).estimate
        assert np.allclose(am.relative(a[:, :1], a), am.relative(b[:, :1], b), atol=1e-9)

    def test_jacobians_is_one_of_two_words(self):
        with pytest.raises(am.AmrError, match="jacobians is 'exact'"):
            sim.ekf_slam(drive(0, runs=1, steps=1), jacobians="exact")


@pytest.mark.parametrize("ekf", [sim.ekf_localization, sim.ekf_slam])
class TestBothFilters:
    def test_the_same_run_gives_the_same_log_and_stays_as_it_is(self, ekf):
        run = drive(0, runs=3)
        a, b = ekf(run)._asdict(), ekf(run)._asdict()
        seconds = a.pop("seconds"), b.pop("seconds")
        for name in a:
            assert np.array_equal(a[name], b[name], equal_nan=True), name
        assert all((s > 0).all() and s.shape == (60,) for s in seconds)
        for before, after in zip(drive(0, runs=3), run, strict=True):
            assert np.array_equal(before, after, equal_nan=True)

    def test_each_run_is_filtered_as_if_it_were_alone(self, ekf):
        run = drive(0, runs=3)
        alone = run._replace(
            **{name: getattr(run, name)[1:2] for name in ("truth", "odometry", "prior")},
            measurements=run.measurements[1:2],
        )
        assert np.allclose(ekf(run).estimate[1], ekf(alone).estimate[0], rtol=0, atol=1e-12)

    def test_covariances_stay_symmetric_and_positive_definite(self, ekf):
        P = ekf(drive(0, runs=5, steps=200)).covariances
        assert np.abs(P - P.mT).max() < 1e-14
        assert np.linalg.eigvalsh(P).min() > 0

    def test_something_else_is_refused(self, ekf):
        with pytest.raises(am.AmrError, match="run is of type ndarray; expected what drive"):
            ekf(np.zeros((3, 3)))

    def test_a_hundred_runs_of_200_steps_take_seconds(self, ekf):
        """1 s and 2 s on two busy cores, with 8 landmarks always in range."""
        run = drive(0, steps=200, max_range=50)
        assert run.visible.all()
        assert ekf(run).seconds.sum() < 8


class TestPlots:
    def test_band(self):
        _, ax = plotting.plt.subplots()
        times, values = np.arange(5.0), np.array([3, 2, 9, 3, 1.0])
        plotting.consistency_band(ax, times, values, 1.5, [4, 4, 5, 5, 6], 3, 0.9, name="mean NEES")
        drawn = {line.get_label(): line.get_ydata() for line in ax.lines}
        assert np.array_equal(drawn["90 % band"], np.full(5, 1.5))
        assert np.array_equal(drawn["_"], [4, 4, 5, 5, 6])
        assert np.array_equal(drawn["measured"], values)
        assert set(drawn["expected"]) == {3}
        assert (ax.get_xlabel(), ax.get_ylabel()) == ("time [s]", "mean NEES")
        assert ax.get_ylim()[0] == 0 and ax.get_ylim()[1] > 9
        plotting.plt.close()

    def test_distribution(self, rng):
        _, ax = plotting.plt.subplots()
        values = rng.chisquare(3, size=20000)
        grid = np.linspace(0.01, 12, 100)
        plotting.chi_square(ax, values, grid, chi2.pdf(grid, 3), name="NIS")
        heights, edges, _ = ax.patches[0].get_data()
        assert np.sum(heights * np.diff(edges)) == pytest.approx(np.mean(values <= 12))
        expected = np.diff(chi2.cdf(edges, 3)) / np.diff(edges)
        assert heights == pytest.approx(expected, abs=0.02)
        assert np.array_equal(ax.lines[0].get_ydata(), chi2.pdf(grid, 3))
        labels = [text.get_text() for text in ax.get_legend().get_texts()]
        assert labels[0].startswith("measured (0.") and labels[0].endswith("% beyond 12)")
        assert ax.get_xlabel() == "NIS"
        plotting.plt.close()
