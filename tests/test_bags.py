"""Bags that rosbags writes come back: every message type, ROS 1, ROS 2 and mcap."""

import sys
from types import SimpleNamespace

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

import amrmetrics as am
from amrmetrics.bags import _as_trajectory, _transforms, is_bag
from amrmetrics.command import main

T = 1.7e9 + np.arange(30) * 0.1


def poses():
    angle = np.linspace(0, 3, 30)
    q = np.c_[0 * T[:30], 0 * T, np.sin(angle / 2), np.cos(angle / 2)]
    return am.spatial_poses(np.c_[np.cos(angle), np.sin(angle), angle], q), q


class Recorder:
    """Writes one message of each kind per stamp."""

    def __init__(self, path, kind):
        self.ros1 = kind == "ros1"
        self.types = get_typestore(Stores.ROS1_NOETIC if self.ros1 else Stores.ROS2_HUMBLE)
        if self.ros1:
            self.writer = Writer1(path)
        else:
            plugin = StoragePlugin.MCAP if kind == "mcap" else StoragePlugin.SQLITE3
            self.writer = Writer2(path, version=9, storage_plugin=plugin)
        self.topics = {}
        if self.ros1:
            text = "geometry_msgs/TransformStamped[] transforms"
            self.types.register(get_types_from_msg(text, "tf2_msgs/msg/TFMessage"))

    def make(self, name, *values):
        return self.types.types[name](*values)

    def header(self, t, frame):
        sec, nanosec = int(t), round((t % 1) * 1e9)
        stamp = self.make("builtin_interfaces/msg/Time", sec, nanosec)
        return self.make("std_msgs/msg/Header", *([0] if self.ros1 else []), stamp, frame)

    def write(self, topic, kind, message, t):
        if topic not in self.topics:
            self.topics[topic] = self.writer.add_connection(topic, kind, typestore=self.types)
        serialize = self.types.serialize_ros1 if self.ros1 else self.types.serialize_cdr
        self.writer.write(self.topics[topic], int(t * 1e9), serialize(message, kind))


@pytest.fixture(params=["ros1", "ros2", "mcap"])
def bag(request, tmp_path):
    X, q = poses()
    path = tmp_path / ("run.bag" if request.param == "ros1" else "run")
    log = Recorder(path, request.param)
    geometry = "geometry_msgs/msg/"
    with log.writer:
        stamped = []
        for t, pose, orientation in zip(T, X, q, strict=True):
            point = log.make(geometry + "Point", *pose[:3, 3])
            turn = log.make(geometry + "Quaternion", *orientation)
            at = log.make(geometry + "Pose", point, turn)
            header = log.header(t, "map")
            one = log.make(geometry + "PoseStamped", header, at)
            stamped.append(one)
            log.write("/pose", geometry + "PoseStamped", one, t)
            both = log.make(geometry + "PoseWithCovariance", at, np.zeros(36))
            message = log.make(geometry + "PoseWithCovarianceStamped", header, both)
            log.write("/cov", geometry + "PoseWithCovarianceStamped", message, t)
            zero = log.make(geometry + "Vector3", 0.0, 0.0, 0.0)
            still = log.make(geometry + "Twist", zero, zero)
            twist = log.make(geometry + "TwistWithCovariance", still, np.zeros(36))
            message = log.make("nav_msgs/msg/Odometry", header, "base", both, twist)
            log.write("/odom", "nav_msgs/msg/Odometry", message, t)
            message = log.make(geometry + "PointStamped", header, point)
            log.write("/prism", geometry + "PointStamped", message, t)
            shift = log.make(geometry + "Vector3", *pose[:3, 3])
            move = log.make(geometry + "Transform", shift, turn)
            transform = log.make(geometry + "TransformStamped", header, "base", move)
            log.write("/vicon", geometry + "TransformStamped", transform, t)
            other = log.make(geometry + "TransformStamped", header, "laser", move)
            message = log.make("tf2_msgs/msg/TFMessage", [other, transform])
            log.write("/tf", "tf2_msgs/msg/TFMessage", message, t)
            path_ = log.make("nav_msgs/msg/Path", header, list(stamped))
            log.write("/path", "nav_msgs/msg/Path", path_, t)
    return path


@pytest.mark.parametrize("topic", ["/pose", "/cov", "/odom", "/vicon", "/tf:map.base", "/path"])
def test_poses_of_every_kind(bag, topic):
    found = am.read_bag(bag, topic)
    assert np.allclose(found.stamps, T, atol=1e-6)
    assert np.allclose(found.poses, poses()[0], atol=1e-12)
    assert found.source == f"{bag.name}:{topic}"


def test_points_have_no_orientation(bag):
    found = am.read_bag(bag, "/prism")
    assert np.allclose(found.positions, poses()[0][:, :3, 3])
    with pytest.raises(am.AmrError, match="the topic has positions only"):
        am.rpe(found, found)


def test_says_which_topics_there_are(bag):
    with pytest.raises(am.AmrError, match=r"no poses in topic '/no'.*/cov \(PoseWithCovar.*/odom"):
        am.read_bag(bag, "/no")
    with pytest.raises(am.AmrError, match=r"/tf:odom\.base_link"):
        am.read_bag(bag, "/tf")
    with pytest.raises(am.AmrError, match="has no messages"):
        am.read_bag(bag, "/tf:map.nobody")


def test_the_command_reads_topics(bag, tmp_path, capsys):
    am.write_tum(tmp_path / "truth.txt", T, poses()[0])
    assert main([str(tmp_path / "truth.txt"), f"{bag}:/odom", "--align", "none"]) == 0
    assert "30 of 30 reference" in capsys.readouterr().out
    if bag.suffix == ".bag":
        assert main([str(tmp_path / "truth.txt"), str(bag)]) == 2
        assert "say which topic" in capsys.readouterr().err


def test_a_missing_bag_is_the_systems_error(tmp_path):
    with pytest.raises(FileNotFoundError):
        am.read_bag(tmp_path / "none.bag", "/odom")


def test_rubbish_is_no_bag(tmp_path):
    (tmp_path / "run.bag").write_bytes(b"rubbish")
    with pytest.raises(am.AmrError, match="cannot be read as a bag"):
        am.read_bag(tmp_path / "run.bag", "/odom")


def test_without_rosbags_it_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "rosbags.highlevel", None)
    with pytest.raises(am.AmrError, match=r"pip install 'amrmetrics\[ros\]'"):
        am.read_bag(tmp_path / "run.bag", "/odom")


@pytest.mark.parametrize("name", ["run.bag", "run.mcap", "run_0.db3"])
def test_what_a_bag_is(tmp_path, name):
    assert is_bag(tmp_path / name)
    assert not is_bag(tmp_path / "run.txt")
    assert not is_bag(tmp_path)
    (tmp_path / "metadata.yaml").touch()
    assert is_bag(tmp_path)


def test_the_file_in_the_folder_of_a_bag(bag):
    for path in bag.glob("*.db3") if bag.is_dir() else ():
        assert np.array_equal(am.read_bag(path, "/odom").stamps, am.read_bag(bag, "/odom").stamps)


def test_frames_are_named_with_or_without_a_slash():
    name = SimpleNamespace
    zero, one = name(x=0.0, y=0.0, z=0.0), name(x=0.0, y=0.0, z=0.0, w=1.0)
    header = name(frame_id="/map", stamp=name(sec=1, nanosec=500_000_000))
    move = name(translation=zero, rotation=one)
    message = name(transforms=[name(header=header, child_frame_id="/a.b", transform=move)])
    for parent in ("map", "/map"):
        (found,) = _transforms(message, parent, "a.b")
        assert found == (1.5, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    assert not list(_transforms(message, "odom", "a.b"))


def test_a_child_frame_may_have_a_point(tmp_path):
    log = Recorder(tmp_path / "run", "ros2")
    geometry = "geometry_msgs/msg/"
    with log.writer:
        for t in T:
            shift = log.make(geometry + "Vector3", t - T[0], 0.0, 0.0)
            move = log.make(
                geometry + "Transform", shift, log.make(geometry + "Quaternion", 0.0, 0.0, 0.0, 1.0)
            )
            one = log.make(geometry + "TransformStamped", log.header(t, "map"), "arm.tip", move)
            message = log.make("tf2_msgs/msg/TFMessage", [one])
            log.write("/tf", "tf2_msgs/msg/TFMessage", message, t)
    assert len(am.read_bag(tmp_path / "run", "/tf:map.arm.tip")) == len(T)


@pytest.mark.parametrize("oriented", [False, True])
def test_repeated_stamps_keep_what_belongs_to_them(oriented):
    X, q = poses()
    order = [0, 1, 1, 2, 5, 3]
    messages = [
        (float(k), tuple(X[n, :3, 3]), tuple(q[n]) if oriented else None)
        for n, k in enumerate(order)
    ]
    found = _as_trajectory(messages, "run.bag:/odom")
    first = [0, 1, 3, 5, 4]
    assert found.stamps.tolist() == [0, 1, 2, 3, 5]
    assert np.allclose(found.positions, X[first, :3, 3])
    if oriented:
        assert np.allclose(found.poses, X[first])
    assert found.repairs == ("1 repeated stamps left out",)
    assert _as_trajectory(messages[:2], "run.bag:/odom").repairs == ()


def test_headers_without_a_stamp_are_refused():
    point = (0.0, (1.0, 2.0, 3.0), None)
    with pytest.raises(am.AmrError, match=r"all 5 messages of run\.bag:/prism have the stamp 0 s"):
        _as_trajectory([point] * 5, "run.bag:/prism")
    assert len(_as_trajectory([point], "run.bag:/prism")) == 1
