"""Own data as a benchmark: recordings from files and bags, and what cannot be read."""

import csv
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from test_bags import Recorder

import amrmetrics as am
from amrmetrics.benchmark import Protocol, logs

T = np.arange(0, 20, 0.1)
NAMES = ("system", "scenario", "seed", "reference", "estimate")


def spatial(error, seed):
    """A climbing curve and an estimate of it."""
    noise = error * np.random.default_rng(seed).standard_normal((len(T), 3))
    xyz = np.c_[5 * np.cos(T / 4), 5 * np.sin(T / 4), 0.1 * T]
    half = (T / 4 + np.pi / 2) / 2
    turn = np.c_[0 * T, 0 * T, np.sin(half), np.cos(half)]
    return am.spatial_poses(xyz + noise, turn)


def write_bag(path, poses):
    log = Recorder(path, "ros1")
    geometry = "geometry_msgs/msg/"
    with log.writer:
        for t, pose in zip(T, poses, strict=True):
            point = log.make(geometry + "Point", *pose[:3, 3])
            half = am.yaw(pose) / 2
            turn = log.make(geometry + "Quaternion", 0.0, 0.0, np.sin(half), np.cos(half))
            at = log.make(geometry + "Pose", point, turn)
            message = log.make(geometry + "PoseStamped", log.header(t, "map"), at)
            log.write("/pose", geometry + "PoseStamped", message, t)


def write_table(path, rows, names=NAMES):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        writer.writerows(rows)


@pytest.fixture(scope="module")
def data(tmp_path_factory):
    """Two systems, three repetitions of two scenarios, as files and as a bag. Not to be changed."""
    home = tmp_path_factory.mktemp("own")
    rows = []
    for scenario in ("hall", "yard"):
        for seed in range(3):
            truth = f"{scenario}{seed}.txt"
            am.write_tum(home / truth, T, spatial(0, 0))
            for system, error in (("lidar", 0.02), ("camera", 0.1)):
                name = f"{system}-{scenario}{seed}.csv"
                with open(home / name, "w", encoding="utf-8") as file:
                    file.write("t,x,y,z\n")
                    xyz = am.positions(spatial(error, seed))
                    np.savetxt(file, np.c_[T, xyz], delimiter=",", fmt="%.17g")
                rows.append([system, scenario, seed, truth, name])
    write_bag(home / "lidar.bag", spatial(0.02, 0))
    rows[0][-1] = "lidar.bag:/pose"
    am.write_tum(home / "camera.txt", T, spatial(0.1, 0))
    rows[1][-1] = "camera.txt"
    write_table(home / "table.csv", rows)
    return home


@pytest.fixture(scope="module")
def adopted(data, tmp_path_factory):
    folder = tmp_path_factory.mktemp("adopted")
    assert am.benchmark.adopt(data / "table.csv", folder).done == 12
    return folder


def entry_of(folder, *names):
    entries = logs.index(folder).entries
    return next(e for e in entries if (e.system, e.scenario, e.seed) == names)


def test_recordings_are_logged_as_trials(adopted):
    index = logs.index(adopted)
    assert index.protocol["origin"] == "recordings"
    assert index.protocol["protocol"]["calibration"] == "not stated"
    assert [e.status for e in index.entries] == ["ok"] * 12
    trial = logs.read_trial(entry_of(adopted, "camera", "hall", 0))
    assert trial.truth.poses.shape == trial.estimate.poses.shape == (200, 4, 4)
    assert np.array_equal(am.positions(trial.estimate.poses), am.positions(spatial(0.1, 0)))
    assert np.abs(trial.estimate.poses - spatial(0.1, 0)).max() < 2e-15
    assert np.array_equal(trial.truth.stamps, T)
    assert trial.seconds == {}


def test_a_topic_of_a_bag_is_a_recording(adopted):
    trial = logs.read_trial(entry_of(adopted, "lidar", "hall", 0))
    assert np.array_equal(am.positions(trial.estimate.poses), am.positions(spatial(0.02, 0)))


def test_positions_without_orientation_are_taken(adopted):
    trial = logs.read_trial(entry_of(adopted, "camera", "yard", 2))
    assert trial.estimate.poses.shape == (200, 3)
    assert np.array_equal(trial.estimate.poses, am.positions(spatial(0.1, 2)))


def test_the_errors_are_those_of_the_files(adopted, data):
    evaluation = am.benchmark.evaluate(adopted)
    assert len(evaluation.table()) == 12
    for row in evaluation.table():
        k = row["seed"]
        expected = spatial({"lidar": 0.02, "camera": 0.1}[row["system"]], k)
        assert row["ate"] == pytest.approx(am.ate(spatial(0, 0), expected).rmse, rel=1e-9)


def test_again_nothing_is_done(adopted, data):
    done = am.benchmark.adopt(data / "table.csv", adopted)
    assert (done.trials, done.done, done.resumed, done.failed) == (12, 0, 12, 0)


def test_other_data_are_refused(adopted, data, tmp_path):
    copy = Path(shutil.copytree(data, tmp_path / "data"))
    am.write_tum(copy / "camera.txt", T, spatial(0.2, 0))
    with pytest.raises(am.AmrError, match=r"sources.hall/camera/0.estimate.sha256 is"):
        am.benchmark.adopt(copy / "table.csv", adopted)


def test_what_was_damaged_is_read_again(data, tmp_path):
    folder = tmp_path / "logs"
    am.benchmark.adopt(data / "table.csv", folder)
    (entry_of(folder, "lidar", "hall", 1).path / "estimate.tum").write_text("1 2 3\n")
    (entry_of(folder, "lidar", "yard", 1).world / "truth.tum").unlink()
    shutil.rmtree(entry_of(folder, "lidar", "hall", 2).world)
    assert am.benchmark.adopt(data / "table.csv", folder).done == 3
    assert logs.read_trial(entry_of(folder, "camera", "yard", 1)).status == "ok"


BAD = {
    "missing.txt": "No such file",
    "words.txt": "has no data",
    "lidar.bag": "write the topic behind it: lidar.bag:/odom",
    "lidar.bag:/imu": "has no poses in topic '/imu'",
    "gone.bag:/pose": "No such file",
    "kitti.txt": "it has no stamps; the column times names",
    "nan.txt": "nan",
}


@pytest.fixture(scope="module")
def bad(data, tmp_path_factory):
    home = Path(shutil.copytree(data, tmp_path_factory.mktemp("bad") / "data"))
    (home / "words.txt").write_text("these are\nno numbers\n")
    am.write_kitti(home / "kitti.txt", spatial(0.1, 0))
    (home / "nan.txt").write_text("".join(f"{t} nan 0 0 0 0 0 1\n" for t in range(20)))
    rows = [["good", "hall", k, "hall0.txt", "camera.txt"] for k in range(len(BAD))]
    rows += [["bad", "hall", k, "hall0.txt", name] for k, name in enumerate(BAD)]
    rows += [["good", "yard", 0, "missing.txt", "camera.txt"]]
    write_table(home / "table.csv", rows)
    done = am.benchmark.adopt(home / "table.csv", home / "logs")
    assert (done.done, done.failed, done.kinds) == (15, 8, {"not read": 8})
    return home / "logs"


@pytest.mark.parametrize("name", BAD)
def test_what_cannot_be_read_is_a_failure_with_its_reason(bad, name):
    entry = entry_of(bad, "bad", "hall", list(BAD).index(name))
    assert (entry.status, entry.kind) == ("failed", "not read")
    assert entry.reason.startswith("estimate: ")
    assert BAD[name] in entry.reason
    assert logs.read_trial(entry).truth is not None


def test_a_reference_that_cannot_be_read_is_a_failure_too(bad):
    entry = entry_of(bad, "good", "yard", 0)
    assert entry.reason.startswith("reference: ")
    assert logs.read_trial(entry).truth is None


def test_failures_are_counted(bad):
    rows = am.benchmark.evaluate(bad).table()
    assert sum(row["status"] == "failed" for row in rows) == 8


def test_repairs_are_logged_and_not_shouted(data, tmp_path):
    lines = (data / "camera.txt").read_text().splitlines()
    lines[5], lines[6] = lines[6], lines[5]
    (tmp_path / "shuffled.txt").write_text("\n".join(lines) + "\n")
    row = dict(
        zip(NAMES, ("a", "hall", 0, data / "hall0.txt", tmp_path / "shuffled.txt"), strict=True)
    )
    am.benchmark.adopt([row], tmp_path / "logs")
    assert "repaired: 1 stamps out of order" in entry_of(tmp_path / "logs", "a", "hall", 0).detail


def test_kitti_files_with_their_times(data, tmp_path):
    am.write_kitti(tmp_path / "estimate.txt", spatial(0.1, 0))
    np.savetxt(tmp_path / "times.txt", T)
    row = ["a", "hall", 0, data / "hall0.txt", "estimate.txt", "tuning", "times.txt"]
    write_table(tmp_path / "table.csv", [row], (*NAMES, "split", "times"))
    assert am.benchmark.adopt(tmp_path / "table.csv", tmp_path / "logs").failed == 0
    trial = logs.read_trial(entry_of(tmp_path / "logs", "a", "hall", 0))
    assert np.allclose(trial.estimate.stamps, T)
    assert trial.split == "tuning"


def test_trajectories_in_memory(tmp_path):
    truth, estimate = am.Trajectory(T, spatial(0, 0)), am.Trajectory(T, spatial(0.1, 0))
    row = dict(zip(NAMES, ("a", "hall", 0, truth, estimate), strict=True))
    assert am.benchmark.adopt([row], tmp_path, protocol=Protocol(align="none")).failed == 0
    assert np.array_equal(
        am.positions(logs.read_trial(entry_of(tmp_path, "a", "hall", 0)).estimate.poses),
        estimate.positions,
    )


GOOD = dict(zip(NAMES, ("a", "hall", 0, "truth.txt", "a.txt"), strict=True))
WRONG = {
    "table has no rows": [],
    "row 0: no seed, estimate. A row needs": [{"system": "a", "scenario": "b", "reference": "c"}],
    "row 1: unknown column 'sede'": [GOOD, GOOD | {"sede": 1}],
    r"row 0: system is 'a b'; expected letters": [GOOD | {"system": "a b"}],
    "row 0: seed is 1.5": [GOOD | {"seed": 1.5}],
    "row 0: seed is 'first'": [GOOD | {"seed": "first"}],
    "row 0: split is 'train'": [GOOD | {"split": "train"}],
    "row 0: estimate is of type int": [GOOD | {"estimate": 4}],
    "system a, scenario hall, seed 0 twice": [GOOD, GOOD],
    "two different entries in column reference": [GOOD, GOOD | {"system": "b", "reference": "x"}],
    "two different entries in column split": [GOOD, GOOD | {"seed": 1, "split": "tuning"}],
    "'A' twice": [GOOD, GOOD | {"system": "A"}],
}


@pytest.mark.parametrize("message", WRONG)
def test_a_wrong_table_is_refused(tmp_path, message):
    with pytest.raises(am.AmrError, match=message):
        am.benchmark.adopt(WRONG[message], tmp_path / "logs")
    assert not (tmp_path / "logs").exists()


def test_a_wrong_line_of_a_file_is_named(tmp_path):
    write_table(tmp_path / "table.csv", [list(GOOD.values()), ["b", "hall", "", "x", "y"]])
    with pytest.raises(am.AmrError, match=r"table.csv, line 3: no seed"):
        am.benchmark.adopt(tmp_path / "table.csv", tmp_path / "logs")


@pytest.mark.parametrize("separator", [";", "\t", ","])
def test_a_table_as_spreadsheets_write_it(data, tmp_path, separator):
    lines = [NAMES, ("a", "hall", "0", "hall0.txt", "camera.txt"), [""] * len(NAMES)]
    text = "\r\n".join(map(separator.join, lines))
    home = shutil.copytree(data, tmp_path / "data")
    (home / "mine.csv").write_text(text, encoding="utf-8-sig", newline="")
    done = am.benchmark.adopt(home / "mine.csv", tmp_path / "logs")
    assert (done.trials, done.failed) == (1, 0)


@pytest.mark.skipif(os.sep == "\\", reason="there it is a path like any other")
def test_relative_paths_of_windows(data, tmp_path):
    rows = [
        ["a", "hall", 0, "hall0.txt", "data\\camera.txt"],
        ["b", "hall", 0, ".\\hall0.txt", ".\\data\\lidar.bag:/pose"],
        ["c", "hall", 0, "./hall0.txt", "C:\\data\\camera.txt"],
    ]
    shutil.copytree(data, tmp_path / "data")
    shutil.copy(data / "hall0.txt", tmp_path)
    write_table(tmp_path / "table.csv", rows)
    am.benchmark.adopt(tmp_path / "table.csv", tmp_path / "logs")
    found = {e.system: e.reason for e in logs.index(tmp_path / "logs").entries}
    assert (found["a"], found["b"]) == ("", "")
    assert "No such file" in found["c"]


def test_a_reason_has_no_path_of_this_machine(bad):
    assert all("/data" not in e.reason for e in logs.index(bad).entries)


LINE = "a,hall,0,truth.txt,a.txt"
WRONG_FILES = {
    "is no text in UTF-8": f"{','.join(NAMES)}\n{LINE}\n".encode("utf-16"),
    "line 2: more entries than columns": f"{','.join(NAMES)}\n{LINE},b.txt\n".encode(),
    "has no rows": b"",
}


@pytest.mark.parametrize("message", WRONG_FILES)
def test_a_wrong_file_is_refused(tmp_path, message):
    (tmp_path / "table.csv").write_bytes(WRONG_FILES[message])
    with pytest.raises(am.AmrError, match=message):
        am.benchmark.adopt(tmp_path / "table.csv", tmp_path / "logs")
