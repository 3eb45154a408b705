"""Bags that rosbags writes come back: every message type, ROS 1, ROS 2 and mcap."""

import sys

import numpy as np
import pytest
from rosbags.rosbag1 import Writer as Writer1
from rosbags.rosbag2 import StoragePlugin
from rosbags.rosbag2 import Writer as Writer2
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

import amrmetrics as am
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


def test_headers_without_a_stamp_are_refused():
    from amrmetrics.bags import _as_trajectory

    point = (0.0, (1.0, 2.0, 3.0), None)
    with pytest.raises(am.AmrError, match=r"all 5 messages of run\.bag:/prism have the stamp 0 s"):
        _as_trajectory([point] * 5, "run.bag:/prism")
    assert len(_as_trajectory([point], "run.bag:/prism")) == 1
