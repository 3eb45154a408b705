"""Folders of a benchmark as `run` would leave them, from made-up estimates."""

import hashlib
from unittest import mock

import numpy as np

import amrmetrics as am
from amrmetrics.benchmark import logs, protocol
from amrmetrics.benchmark.data import Estimate, Protocol, Scenario, System, Truth


def nothing(*_, **__):
    raise NotImplementedError


def truth_of(rng, n=120, landmarks=8, candidates=20, step=0.1):
    t = np.arange(n) * step
    xy = np.c_[10 * np.cos(t / 2), 6 * np.sin(t / 2)]
    heading = np.arctan2(np.gradient(xy[:, 1]), np.gradient(xy[:, 0]))
    points = rng.uniform(-10, 10, (landmarks, 2))
    labels = rng.random(candidates) < 0.5
    return Truth(t, am.planar_poses(xy, heading), points, labels)


def estimate_of(truth, rng, noise=0.1, claim=1.0, full=True, until=1.0):
    """Return an estimate with white errors of std `noise` that claims `claim` times as much."""
    n = int(until * len(truth.stamps))
    poses = truth.poses[:n]
    xy = am.positions(poses) + noise * rng.normal(size=(n, 2))
    heading = am.yaw(poses) + 0.1 * noise * rng.normal(size=n)
    poses = am.planar_poses(xy, heading)
    stamps = truth.stamps[:n]
    if not full:
        return Estimate(poses, stamps)
    std = claim * noise * np.array([1, 1, 0.1])
    score = rng.random(len(truth.labels)) + 0.5 * truth.labels
    return Estimate(
        poses,
        stamps,
        covariances=np.tile(np.diag(std**2), (n, 1, 1)),
        innovations=noise * rng.normal(size=(2 * n, 2)),
        innovation_covariances=np.tile((claim * noise) ** 2 * np.eye(2), (2 * n, 1, 1)),
        map_points=truth.landmarks + noise * rng.normal(size=truth.landmarks.shape),
        accepted=score > 0.8,
        closure_scores=score,
        frame_seconds=rng.gamma(4, 0.002, n),
    )


def write(
    folder, systems, scenarios=("loop", "hall"), seeds=range(6), tuning=("tune",), truth=truth_of,
    **decisions,
):  # fmt: skip
    """Write a folder; `systems` maps names to ``f(truth, rng, scenario, seed)``.

    It returns an Estimate, the (kind, reason) of a failure, or None for a trial that has not run.
    """
    with mock.patch("os.fsync"):  # nobody pulls a plug here
        _write(folder, systems, scenarios, seeds, tuning, truth, Protocol(**decisions))
    return folder


def _write(folder, systems, scenarios, seeds, tuning, truth, decisions):
    made = [Scenario(name, nothing, {"radius": 10}, "test", "A drive.") for name in scenarios]
    made += [Scenario(name, nothing, {}, "tuning") for name in tuning]
    named = [System(name, nothing, {"gain": 1}, f"Known as {name}.") for name in systems]
    content = protocol.written(named, made, list(seeds), decisions)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / logs.PROTOCOL).write_bytes(logs.sealed(content))
    digest = logs.digest(content)
    for k, scenario in enumerate(made):
        for seed in seeds:
            rng = np.random.default_rng([k, seed])
            world = truth(rng)
            _put_world(folder, digest, scenario.name, seed, world)
            for j, (name, run) in enumerate(systems.items()):
                made_up = run(world, np.random.default_rng([k, seed, j]), scenario.name, seed)
                if made_up is not None:
                    _put_trial(folder, digest, scenario.name, name, seed, made_up)


def _put_world(folder, digest, scenario, seed, truth):
    files = logs.truth_files(truth)
    said = {"scenario": scenario, "seed": seed, "protocol": digest}
    said |= logs.shape_of(truth.poses)
    _put(folder, logs.world_path(folder, scenario, seed), logs.WORLD, said, files, {})


def _put_trial(folder, digest, scenario, system, seed, made):
    said = {"system": system, "scenario": scenario, "seed": seed, "protocol": digest}
    status = {"status": "ok", "kind": "", "reason": "", "detail": ""}
    files, times = {}, logs.times_file(wall=1.5, cpu=1.0, peak=1e8)
    if isinstance(made, tuple):
        status |= {"status": "failed", "kind": made[0], "reason": made[1]}
    else:
        files = logs.estimate_files(made)
        said |= logs.shape_of(made.poses)
        times = logs.times_file(made.frame_seconds, 1.5, 1.0, 1e8)
    path = logs.trial_path(folder, scenario, system, seed)
    _put(folder, path, logs.TRIAL, said | status, files, {logs.TIMES: times})


def _put(folder, path, name, said, files, more):
    said["files"] = {file: hashlib.sha256(data).hexdigest() for file, data in files.items()}
    logs.put_folder(folder, path, files | more | {name: logs.sealed(said)})
