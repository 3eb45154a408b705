"""The default worlds and systems of the benchmark: their shapes, bits, and statistics."""

import json
import re
import subprocess
import sys
from dataclasses import fields, replace
from zlib import crc32

import numpy as np
import pytest

import amrmetrics as am
from amrmetrics import AmrError
from amrmetrics.benchmark import estimators, worlds
from amrmetrics.benchmark.data import SensorLog

SCENARIOS = {scenario.name: scenario for scenario in worlds.scenarios()}
SYSTEMS = {system.name: system for system in estimators.systems()}


def world(name, seed, **settings):
    scenario = SCENARIOS[name]
    rng = np.random.default_rng(np.random.SeedSequence([seed, crc32(name.encode())]))
    return scenario.make(rng, **{**scenario.settings, **settings})


def arrays(record):
    for field in fields(record):
        value = getattr(record, field.name)
        if isinstance(value, np.ndarray):
            yield field.name, value


def frozen(log):
    for _, array in arrays(log):
        array.flags.writeable = False
    return log


def same(one, other, but=()):
    other = dict(arrays(other))
    return all(
        name in but or (array.tobytes(), array.shape) == (other[name].tobytes(), other[name].shape)
        for name, array in arrays(one)
    )


def mean_band(dof, n, sigmas=4.0):
    """Return the interval that holds the mean of n chi-square values."""
    half = sigmas * np.sqrt(2 * dof / n)
    return dof - half, dof + half


# Worlds


def test_the_default_scenarios_are_six_to_test_on_and_one_to_tune_on():
    assert [s.name for s in SCENARIOS.values() if s.split == "test"] == [
        "loop",
        "corridor",
        "outdoor",
        "sparse",
        "aliasing",
        "dropout",
    ]
    assert [s.name for s in SCENARIOS.values() if s.split == "tuning"] == ["yard"]
    assert list(SYSTEMS) == [
        "dead_reckoning",
        "ekf_localization",
        "ekf_overconfident",
        "ekf_slam",
        "pose_graph",
        "pose_graph_robust",
    ]
    for thing in (*SCENARIOS.values(), *SYSTEMS.values()):
        assert re.fullmatch(r"[A-Za-z0-9_-]+", thing.name)
        assert json.loads(json.dumps(thing.settings)) == thing.settings
        assert thing.description.endswith(".")


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_world_is_its_seed_and_nothing_else(name):
    (log, truth), (again, truth_again), (other, _) = (world(name, seed) for seed in (3, 3, 4))
    assert same(log, again) and same(truth, truth_again)
    assert log.seed == again.seed != other.seed
    # Not the noise alone: the course and the landmarks are new, too.
    assert np.abs(log.landmarks - other.landmarks).min() > 0


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_world_has_what_every_system_needs(name):
    log, truth = world(name, 0)
    steps = 1500 if name == "outdoor" else 400
    assert log.stamps.shape == (steps + 1,) and log.odometry.shape == (steps, 2)
    assert truth.poses.shape == (steps + 1, 3, 3)
    assert len(log.sightings) > steps / 20
    assert (np.diff(log.sightings["step"]) >= 0).all() and log.sightings["step"].min() >= 1
    assert truth.labels.sum() == (60 if name == "outdoor" else 40)
    assert (~truth.labels).sum() >= 20
    i, j = log.candidates.T
    assert (j - i >= worlds.GAP).all() and (np.diff(j) >= 0).all()
    apart = np.hypot(*(truth.poses[i] - truth.poses[j])[:, :2, 2].T)
    assert apart[truth.labels].max() < worlds.SAME_PLACE
    assert ((log.scores > 0) & (log.scores < 1)).all()
    # True candidates are good, false ones are not, nearly all of them.
    assert np.median(log.scores[truth.labels]) > 0.8
    path = am.path_length(truth.poses)
    assert path > (1000 if name == "outdoor" else 100)


def test_a_narrow_corridor_has_room_for_landmarks_in_every_seed():
    # Where three lanes lie side by side, the middle one has none beside it.
    for seed in (40, 324):
        log, truth = world("corridor", seed)
        apart = truth.landmarks[:, None] - truth.poses[:, :2, 2]
        assert log.landmarks.shape == (20, 2) and np.hypot(*apart.T).min() >= 1.5


def test_noise_is_what_the_log_says():
    normal = {"odometry": [], "sightings": [], "prior": [], "closures": []}
    for seed in range(8):
        log, truth = world("aliasing", seed)
        way = am.relative(truth.poses[:-1], truth.poses[1:])
        dt = np.diff(log.stamps)
        turn = am.yaw(way) / dt
        speed = np.hypot(way[:, 0, 2], way[:, 1, 2]) / dt
        normal["odometry"].append((log.odometry - np.column_stack([speed, turn])) / [0.05, 0.015])
        s = log.sightings
        X = am.inverse(truth.poses[s["step"]])
        seen = (X[:, :2, :2] @ truth.landmarks[s["landmark"]][:, :, None])[:, :, 0] + X[:, :2, 2]
        z = np.column_stack([np.hypot(*seen.T), np.arctan2(seen[:, 1], seen[:, 0])])
        off = np.column_stack([s["range"], s["bearing"]]) - z
        off[:, 1] = am.wrap(off[:, 1])
        normal["sightings"].append(off / log.sighting_std)
        start = np.append(truth.poses[0, :2, 2], am.yaw(truth.poses[0]))
        normal["prior"].append((log.prior - start)[None] / [0.2, 0.2, 0.03])
        true = truth.labels
        i, j = log.candidates[true].T
        off = am.relative(am.relative(truth.poses[i], truth.poses[j]), log.closures[true])
        normal["closures"].append(
            np.column_stack([off[:, :2, 2], am.yaw(off)]) / [0.15, 0.15, 0.02]
        )
        assert np.allclose(np.linalg.inv(log.closure_information), np.diag([0.0225, 0.0225, 4e-4]))
        # The false ones claim what is not: the residual is far outside of the noise.
        i, j = log.candidates[~true].T
        off = am.relative(am.relative(truth.poses[i], truth.poses[j]), log.closures[~true])
        assert np.hypot(off[:, 0, 2], off[:, 1, 2]).min() > 15 * 0.15
    for name, values in normal.items():
        values = np.concatenate(values)
        n = len(values)
        assert np.abs(values.mean(axis=0)).max() < 4 / np.sqrt(n), name
        assert np.abs(values.var(axis=0) - 1).max() < 4 * np.sqrt(2 / n), name


def test_a_drop_out_hides_everything_and_slips():
    slips = []
    for seed in range(40):
        log, truth = world("dropout", seed)
        dark = (np.arange(401) >= 160) & (np.arange(401) < 200)
        assert not dark[log.sightings["step"]].any()
        assert not dark[log.candidates].any()
        way = am.relative(truth.poses[:-1], truth.poses[1:])
        off = log.odometry[:, 1] - am.yaw(way) / 0.5
        assert abs(off[~dark[1:]].mean()) < 4 * 0.015 / np.sqrt(360)
        speed = np.hypot(way[:, 0, 2], way[:, 1, 2]) / 0.5
        slips.append((log.odometry[:, 0] / speed)[dark[1:]].mean() - 1)
    # One draw of 0.1 for each drive, and some noise.
    assert 0.07 < np.std(slips) < 0.14


@pytest.mark.parametrize(
    "settings, word",
    [
        ({"course": "moon"}, "course"),
        ({"steps": 0}, "steps"),
        ({"dt": -1.0}, "dt"),
        ({"closures": -1}, "candidates"),
        ({"sighting_std": (0.0, 0.1)}, "sighting_std"),
        ({"aside": (2.0, 1.0)}, "aside"),
        ({"blind": (0.5, 0.4)}, "blind"),
    ],
)
def test_a_world_refuses_settings_out_of_range(settings, word):
    with pytest.raises(AmrError, match=word):
        worlds.make(np.random.default_rng(0), **settings)


# All systems


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_every_system_runs_on_every_scenario(scenario):
    log, truth = world(scenario, 1)
    frozen(log)
    untouched, _ = world(scenario, 1)
    for system in SYSTEMS.values():
        estimate = system.run(log, **system.settings)
        n = len(estimate.poses)
        assert n == len(truth.poses) or (scenario == "dropout" and "ekf_" in system.name)
        assert estimate.stamps.tolist() == log.stamps[:n].tolist()
        assert estimate.covariances.shape == (n, 3, 3)
        assert estimate.frame_seconds.shape == (n - 1,) and (estimate.frame_seconds > 0).all()
        for name, array in arrays(estimate):
            if name != "map_points":
                assert np.isfinite(array).all(), (system.name, name)
        assert (estimate.covariances == estimate.covariances.mT).all()
        assert np.linalg.eigvalsh(estimate.covariances)[:, 0].min() > 0
        assert np.allclose(am.inverse(estimate.poses) @ estimate.poses, np.eye(3), atol=1e-9)
        if "graph" in system.name:
            assert estimate.accepted.shape == estimate.closure_scores.shape == log.scores.shape
            assert estimate.accepted.any() and estimate.innovations is None
        if "ekf" in system.name:
            K = len(estimate.innovations)
            assert estimate.innovations.shape == (K, 2)
            assert estimate.innovation_covariances.shape == (K, 2, 2)
        if "slam" in system.name or "graph" in system.name:
            seen = np.bincount(log.sightings["landmark"], minlength=len(log.landmarks)) > 0
            assert (np.isfinite(estimate.map_points).all(axis=1) == seen).all()
        assert same(estimate, system.run(log, **system.settings), but={"frame_seconds"})
    assert same(log, untouched)


def test_a_world_may_have_no_candidates_and_no_sightings():
    log, truth = world("loop", 0, steps=60, closures=0, unlike=0, blind=(0.0, 1.1))
    assert log.candidates.shape == (0, 2) and log.closures.shape == (0, 3, 3)
    assert log.scores.shape == truth.labels.shape == (0,) and not len(log.sightings)
    expected = estimators.dead_reckoning(log).poses
    for system in SYSTEMS.values():
        estimate = system.run(log, **system.settings)
        assert np.allclose(estimate.poses, expected), system.name


def test_only_localization_looks_at_the_surveyed_map():
    log, _ = world("loop", 2)
    moved = replace(log, landmarks=log.landmarks + [5.0, 0.0])
    for system in SYSTEMS.values():
        one, other = (system.run(each, **system.settings) for each in (log, moved))
        equal = one.poses.tobytes() == other.poses.tobytes()
        assert equal != (system.run is estimators.ekf_localization), system.name


@pytest.mark.parametrize("name", SYSTEMS)
def test_late_stamps_are_late_and_change_nothing_else(name):
    log, _ = world("corridor", 0)
    system = SYSTEMS[name]
    late = system.run(log, **{**system.settings, "stamp_delay": 0.5})
    assert late.stamps.tolist() == (log.stamps + 0.5).tolist()
    assert same(late, system.run(log, **system.settings), but={"frame_seconds", "stamps"})


def test_a_child_process_needs_no_scipy():
    code = (
        "import sys; import numpy as np\n"
        "from amrmetrics.benchmark import estimators, worlds\n"
        "log, _ = worlds.make(np.random.default_rng(0), steps=150)\n"
        "for system in estimators.systems():\n"
        "    system.run(log, **system.settings)\n"
        "print([name for name in sys.modules if name.split('.')[0] == 'scipy'])"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


# Dead reckoning


def fresh_odometry(log, truth, rng):
    """Return the log of the same drive with new noise of odometry and prior."""
    way = am.relative(truth.poses[:-1], truth.poses[1:])
    dt = np.diff(log.stamps)
    controls = np.column_stack([np.hypot(way[:, 0, 2], way[:, 1, 2]) / dt, am.yaw(way) / dt])
    start = np.append(truth.poses[0, :2, 2], am.yaw(truth.poses[0]))
    std = np.sqrt(np.diag(log.prior_covariance))
    return replace(
        log,
        odometry=controls + log.odometry_std * rng.normal(size=controls.shape),
        prior=start + std * rng.normal(size=3),
    )


def test_the_covariance_of_dead_reckoning_is_that_of_its_errors():
    log, truth = world("loop", 5, steps=120)
    rng = np.random.default_rng(5)
    errors = []
    for _ in range(800):
        estimate = estimators.dead_reckoning(fresh_odometry(log, truth, rng))
        errors.append(am.pose_errors(truth.poses, estimate.poses))
    sample = np.cov(np.array(errors).transpose(1, 2, 0)[60]), np.cov(np.array(errors)[:, 120].T)
    exact = fresh_odometry(log, truth, rng)
    claims = {
        "right": exact,
        "no prior": replace(exact, prior_covariance=0.1 * exact.prior_covariance),
        "small noise of turns": replace(exact, odometry_std=exact.odometry_std * [1, 0.7]),
        "small noise of speed": replace(exact, odometry_std=exact.odometry_std * [0.7, 1]),
    }
    P = {name: estimators.dead_reckoning(each).covariances for name, each in claims.items()}
    P["no lever"] = np.eye(3) * P["right"]
    off = {}
    for name, claimed in P.items():
        # Whitened errors have the identity as covariance, each entry within about sqrt(2 / n).
        roots = [np.linalg.inv(np.linalg.cholesky(claimed[k])) for k in (60, 120)]
        white = [root @ C @ root.T for root, C in zip(roots, sample, strict=True)]
        off[name] = max(np.abs(each - np.eye(3)).max() for each in white)
    close = 5 * np.sqrt(2 / 800)
    assert off.pop("right") < close < min(off.values()), off


# Filters


def as_log(run, k=0):
    """Return one repetition of a drive of lecture 04 as a sensor log."""
    step, landmark = np.nonzero(run.visible)
    sightings = np.empty(len(step), dtype=worlds.SIGHTING)
    sightings["step"], sightings["landmark"] = step + 1, landmark
    sightings["range"], sightings["bearing"] = run.measurements[k][step, landmark].T
    return SensorLog(
        stamps=run.dt * np.arange(len(run.controls) + 1),
        odometry=run.odometry[k],
        odometry_std=run.odometry_std,
        sightings=sightings,
        sighting_std=run.measurement_std,
        landmarks=run.landmarks,
        prior=run.prior[k],
        prior_covariance=run.prior_covariance,
        candidates=np.empty((0, 2), dtype=int),
        closures=np.empty((0, 3, 3)),
        closure_information=np.eye(3),
        scores=np.empty(0),
        seed=0,
    )


@pytest.mark.parametrize("name", ["ekf_localization", "ekf_slam"])
def test_the_filters_are_those_of_lecture_04(name):
    run = am.simulation.drive(np.random.default_rng(4), runs=2)
    known = getattr(am.simulation, name)(run)
    more = {"gate": np.inf} if name == "ekf_localization" else {}
    estimate = getattr(estimators, name)(as_log(run, 1), **more)
    assert np.allclose(estimate.poses, known.estimate[1], atol=1e-9)
    assert np.allclose(estimate.covariances, known.covariances[1], atol=1e-10)
    assert np.allclose(estimate.innovations, known.innovations[1][known.used], atol=1e-9)
    assert np.allclose(estimate.innovation_covariances, known.S[1][known.used], atol=1e-10)


def end_nees(system, name, seeds, **settings):
    values = []
    for seed in seeds:
        log, truth = world(name, seed, **settings)
        estimate = system.run(log, **system.settings)
        error = am.pose_errors(truth.poses[-1:], estimate.poses[-1:])
        values.append(am.nees(error, estimate.covariances[-1:])[0])
    return np.array(values)


def test_the_honest_filter_is_consistent_and_the_overconfident_is_not():
    seeds = range(40)
    honest = end_nees(SYSTEMS["ekf_localization"], "loop", seeds, steps=200)
    boaster = end_nees(SYSTEMS["ekf_overconfident"], "loop", seeds, steps=200)
    assert am.consistency_test(honest, dof=3, confidence=0.999).verdict == "consistent"
    assert am.consistency_test(boaster, dof=3, confidence=0.999).verdict == "overconfident"


def test_overconfidence_alone_changes_no_estimate():
    log, _ = world("loop", 0)
    one = estimators.ekf_localization(log, gate=np.inf)
    other = estimators.ekf_localization(log, gate=np.inf, claimed=0.6)
    assert np.allclose(one.poses, other.poses, atol=1e-9)
    assert np.allclose(other.covariances, 0.36 * one.covariances, rtol=1e-6)


def test_innovations_are_handed_in_whether_or_not_they_pass():
    log, _ = world("loop", 0)
    estimate = estimators.ekf_localization(log, claimed=0.6)
    assert len(estimate.innovations) == len(log.sightings)
    values = am.nis(estimate.innovations, estimate.innovation_covariances)
    assert values.max() > 13.8
    # What a careless log would show: the boaster looks far better than it is.
    assert values[values < 13.8].mean() < 0.85 * values.mean()
    honest = estimators.ekf_localization(log)
    mean = am.nis(honest.innovations, honest.innovation_covariances).mean()
    low, high = mean_band(2, len(log.sightings))
    assert low < mean < high < values.mean()


def test_a_lost_filter_stops_when_it_said_it_would():
    log, _ = world("loop", 0)
    late = log.sightings["step"] > 100
    astray = log.sightings.copy()
    astray["range"][late] += 50.0
    astray = replace(log, sightings=astray)
    frames = np.unique(log.sightings["step"][late])
    for lost_after in (5.0, 10.0):
        estimate = estimators.ekf_localization(astray, lost_after=lost_after)
        # Half a second each; frames without sightings do not count.
        assert len(estimate.poses) == frames[round(lost_after / 0.5) - 1] + 1
    kept = np.flatnonzero(~late | (log.sightings["step"] == frames[5]))
    once = astray.sightings.copy()
    once[kept] = log.sightings[kept]
    estimate = estimators.ekf_localization(replace(log, sightings=once), lost_after=5.0)
    assert len(estimate.poses) == frames[5 + 10] + 1


def test_a_drop_out_loses_some_honest_filters_and_more_boasters():
    lost = {name: [] for name in ("ekf_localization", "ekf_overconfident")}
    for seed in range(30):
        log, truth = world("dropout", seed)
        for name, found in lost.items():
            estimate = SYSTEMS[name].run(log, **SYSTEMS[name].settings)
            found.append(len(estimate.poses) < 0.9 * len(truth.poses))
    honest, boaster = (np.mean(found) for found in lost.values())
    assert 0.1 <= honest <= 0.4
    assert boaster > honest


def test_slam_maps_the_landmarks():
    log, truth = world("loop", 3)
    points = estimators.ekf_slam(log).map_points
    fit = am.align(truth.landmarks, points)
    off = np.hypot(*(truth.landmarks - (points @ fit.rotation.T + fit.translation)).T)
    assert np.sqrt((off**2).mean()) < 0.6
    graph = estimators.pose_graph(log).map_points
    fit = am.align(truth.landmarks, graph)
    off = np.hypot(*(truth.landmarks - (graph @ fit.rotation.T + fit.translation)).T)
    assert np.sqrt((off**2).mean()) < 0.3


def test_a_landmark_that_was_never_seen_is_not_on_the_map():
    log, _ = world("loop", 3)
    log = replace(log, sightings=log.sightings[log.sightings["landmark"] != 7])
    for system in (estimators.ekf_slam, estimators.pose_graph):
        assert np.flatnonzero(np.isnan(system(log).map_points[:, 0])).tolist() == [7]


# Pose graphs


def library_graph(log, poses, chosen):
    """Return the same problem for `amrmetrics.optimize`."""
    Z, Q = estimators._motions(log)
    n = len(Z)
    steps = np.column_stack([np.arange(n), np.arange(1, n + 1)])
    return am.PoseGraph(
        poses,
        np.concatenate([steps, log.candidates[chosen]]),
        np.concatenate([Z, log.closures[chosen]]),
        np.concatenate(
            [
                np.linalg.inv(Q),
                np.broadcast_to(log.closure_information, (len(chosen), 3, 3)),
            ]
        ),
    )


@pytest.mark.parametrize("loss", ["linear", "cauchy", "huber", "geman_mcclure"])
def test_a_pose_graph_is_at_the_optimum_that_the_library_finds(loss):
    log, _ = world("aliasing", 2, steps=250)
    estimate = estimators.pose_graph(log, loss=loss)
    chosen = np.flatnonzero(log.scores >= 0.85)
    graph = library_graph(log, estimate.poses, chosen)
    kernel = {} if loss == "linear" else {"width": 2.0}
    best = am.optimize(graph, loss, robust=np.arange(len(graph.edges)) >= 250, **kernel)
    assert best.cost_before <= best.cost * (1 + 1e-6)
    assert np.abs(am.positions(best.poses) - am.positions(estimate.poses)).max() < 0.01
    if loss == "linear":
        assert estimate.closure_scores.tolist() == log.scores.tolist()
        assert estimate.accepted.tolist() == (log.scores >= 0.85).tolist()
    else:
        assert np.allclose(estimate.closure_scores[chosen], best.weights[250:], atol=0.01)
        assert estimate.accepted.tolist() == (estimate.closure_scores >= 0.2).tolist()
        assert not np.delete(estimate.closure_scores, chosen).any()


def dense_covariances(log, poses, chosen, weights, prior=True):
    """Return the same from the inverse of the whole information matrix, at once."""
    graph = library_graph(log, poses, chosen)
    A, B = graph.jacobians()
    weight = np.concatenate([np.ones(len(poses) - 1), weights])
    W = weight[:, None, None] * graph.information
    H = np.zeros((len(poses), 3, len(poses), 3))
    for (i, j), a, b, w in zip(graph.edges, A, B, W, strict=True):
        for k, left in ((i, a), (j, b)):
            for m, right in ((i, a), (j, b)):
                H[k, :, m] += left.T @ w @ right
    size = 3 * len(poses)
    P = np.zeros((size, size))
    P[3:, 3:] = np.linalg.inv(H.reshape(size, size)[3:, 3:])
    P = P.reshape(len(poses), 3, len(poses), 3)
    result = np.empty((len(poses), 3, 3))
    for k, X in enumerate(poses):
        # From motions in the robot's frame to errors in the world's, and what the start adds.
        turn = np.eye(3)
        turn[:2, :2] = X[:2, :2]
        lever = np.eye(3)
        dx, dy = X[:2, 2] - poses[0, :2, 2]
        lever[:2, 2] = -dy, dx
        result[k] = turn @ P[k, :, k] @ turn.T + prior * lever @ log.prior_covariance @ lever.T
    return result


@pytest.mark.parametrize("loss", ["linear", "cauchy"])
def test_marginal_covariances_are_those_of_a_dense_inverse(loss):
    log, _ = world("aliasing", 2, steps=250)
    # Few closures, so that most poses are bound loosely.
    log = replace(log, scores=np.where(np.arange(len(log.scores)) % 3 == 0, log.scores, 0.0))
    chosen = np.flatnonzero(log.scores >= 0.85)
    estimate = estimators.pose_graph(log, loss=loss)
    weights = estimate.closure_scores[chosen] if loss != "linear" else np.ones(len(chosen))
    assert loss == "linear" or weights.min() < 0.5 < weights.max()
    right = dense_covariances(log, estimate.poses, chosen, weights)
    scale = np.sqrt(np.diagonal(right, axis1=1, axis2=2))
    scale = scale[:, :, None] * scale[:, None]
    # The wheels' 1 mm sideways makes the information ill-conditioned.
    assert np.abs((estimate.covariances - right) / scale).max() < 1e-4
    wrong = {"no prior": dense_covariances(log, estimate.poses, chosen, weights, prior=False)}
    if loss != "linear":
        ones = np.ones(len(chosen))
        wrong["no weights"] = dense_covariances(log, estimate.poses, chosen, ones)
    for name, values in wrong.items():
        assert np.abs((estimate.covariances - values) / scale).max() > 0.1, name


def test_without_closures_a_pose_graph_is_dead_reckoning():
    log, _ = world("loop", 0, steps=100)
    log = replace(log, scores=np.zeros_like(log.scores))
    graph, odometry = estimators.pose_graph(log), estimators.dead_reckoning(log)
    assert np.allclose(graph.poses, odometry.poses, atol=1e-9)
    assert np.allclose(graph.covariances, odometry.covariances, rtol=1e-3, atol=1e-4)
    assert not graph.accepted.any()


@pytest.mark.parametrize("name", ["pose_graph", "pose_graph_robust"])
def test_pose_graphs_are_consistent_where_all_closures_are_true(name):
    values = end_nees(SYSTEMS[name], "loop", range(30), steps=250, unlike=0)
    low, high = mean_band(3, len(values))
    assert low < values.mean() < high


def test_one_false_closure_ruins_the_linear_graph_and_not_the_robust():
    ates = []
    for seed in range(6):
        log, truth = world("loop", seed, unlike=1)
        scores = np.where(truth.labels, log.scores, 0.99)
        for tried in (log, replace(log, scores=scores)):
            for name in ("pose_graph", "pose_graph_robust"):
                estimate = SYSTEMS[name].run(tried, **SYSTEMS[name].settings)
                ates.append(am.ate(truth.poses, estimate.poses).rmse)
                if tried is not log:
                    taken = estimate.accepted[~truth.labels].all()
                    assert taken == (name == "pose_graph")
    clean, clean_robust, ruined, survived = np.median(np.reshape(ates, (6, 4)), axis=0)
    assert ruined > 5 * survived
    assert max(clean, clean_robust, survived) < 0.25


def test_a_pose_graph_takes_long_where_a_closure_is_accepted():
    log, _ = world("loop", 0)
    estimate = estimators.pose_graph(log)
    busy = np.zeros(400, dtype=bool)
    busy[log.candidates[log.scores >= 0.85, 1] - 1] = True
    seconds = estimate.frame_seconds
    assert np.median(seconds[busy]) > 5 * np.median(seconds[~busy])


def test_a_pose_graph_refuses_an_unknown_loss():
    log, _ = world("loop", 0, steps=100)
    with pytest.raises(AmrError, match="loss"):
        estimators.pose_graph(log, loss="tukey")
    with pytest.raises(AmrError, match="width"):
        estimators.pose_graph(log, loss="cauchy", width=-1.0)
    with pytest.raises(AmrError, match="claimed"):
        estimators.ekf_localization(log, claimed=0.0)
