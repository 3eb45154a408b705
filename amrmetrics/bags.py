"""Trajectories out of ROS 1 and ROS 2 recordings, by topic. ROS itself is not needed."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

from amrmetrics.errors import AmrError
from amrmetrics.poses import spatial_poses
from amrmetrics.recording import Trajectory

if TYPE_CHECKING:
    from amrmetrics._types import Path

# Where a message of each type has its position and its orientation.
POSES = {
    "geometry_msgs/msg/PoseStamped": ("pose.position", "pose.orientation"),
    "geometry_msgs/msg/PoseWithCovarianceStamped": ("pose.pose.position", "pose.pose.orientation"),
    "geometry_msgs/msg/TransformStamped": ("transform.translation", "transform.rotation"),
    "nav_msgs/msg/Odometry": ("pose.pose.position", "pose.pose.orientation"),
    "geometry_msgs/msg/PointStamped": ("point", None),
}
PATH, TRANSFORMS = "nav_msgs/msg/Path", "tf2_msgs/msg/TFMessage"
ENDINGS = (".bag", ".mcap", ".db3")


def is_bag(path):
    """Say if a path is one of a recording: a ROS 1 bag, or a ROS 2 bag's folder or file."""
    text = os.fspath(path)
    return text.endswith(ENDINGS) or os.path.exists(os.path.join(text, "metadata.yaml"))


def read_bag(path: Path, topic: str) -> Trajectory:
    """Read the poses of a topic of a ROS 1 bag, a ROS 2 bag or an mcap file.

    Parameters
    ----------
    path : str or Path
        A ``.bag`` or ``.mcap`` file, or the folder of a ROS 2 bag.
    topic : str
        Of PoseStamped, PoseWithCovarianceStamped, TransformStamped, Odometry, PointStamped or
        Path messages (of a Path the last one). "/tf:odom.base_link" takes the transformations
        from frame odom to frame base_link out of /tf.

    Returns
    -------
    Trajectory
        Stamps of the headers in seconds, poses (N, 4, 4) in meters, in order of time.

    Raises
    ------
    AmrError
        If rosbags is not installed, there is no such topic (the message lists those that
        would do), or it has no poses.
    OSError
        If the file cannot be opened.

    References
    ----------
    The packages geometry_msgs and nav_msgs of ROS; read by the package rosbags.

    Examples
    --------
    >>> import amrmetrics as am
    >>> am.read_bag("run.bag", "/odom")  # doctest: +SKIP
    run.bag:/odom: 1200 poses in space, 60 s, 20 per second, path 41.2 m
    """
    try:
        from rosbags.highlevel import AnyReader, AnyReaderError
        from rosbags.typesys import Stores, get_typestore
    except ImportError:
        raise AmrError(
            "reading a ROS bag needs the package rosbags: pip install 'amrmetrics[ros]'."
        ) from None
    from pathlib import Path

    path = Path(path)
    path.stat()  # a missing file is the system's error
    folder = path.parent if path.suffix == ".db3" else path
    name, _, frames = topic.partition(":")
    try:
        types = get_typestore(Stores.ROS2_HUMBLE)
        with AnyReader([folder], default_typestore=types) as reader:
            messages = list(_messages(reader, name, frames, path))
    except AnyReaderError as error:
        raise AmrError(f"{path} cannot be read as a bag: {error}.") from None
    return _as_trajectory(messages, f"{path.name}:{topic}")


def _messages(reader, topic, frames, path):
    """Yield (stamp, position, orientation or None) of the messages of a topic."""
    known = (*POSES, PATH, TRANSFORMS)
    found = [c for c in reader.connections if c.topic == topic and c.msgtype in known]
    if not found:
        usable = sorted(
            {
                f"{c.topic} ({c.msgtype.split('/')[-1]})"
                for c in reader.connections
                if c.msgtype in known
            }
        )
        raise AmrError(
            f"{path} has no poses in topic {topic!r}. Topics with poses: "
            f"{', '.join(usable) or 'none'}."
        )
    if found[0].msgtype == TRANSFORMS and "." not in frames:
        raise AmrError(f"say which frames of {topic} to take: '{topic}:odom.base_link'.")
    last = None
    for connection, _, raw in reader.messages(connections=found):
        message = reader.deserialize(raw, connection.msgtype)
        if connection.msgtype == PATH:
            last = message
        elif connection.msgtype == TRANSFORMS:
            yield from _transforms(message, *frames.split(".", 1))
        else:
            yield _pose(message, *POSES[connection.msgtype])
    if last is not None:
        for pose in last.poses:
            yield _pose(pose, *POSES["geometry_msgs/msg/PoseStamped"])


def _transforms(message, parent, child):
    for transform in message.transforms:
        ends = transform.header.frame_id.lstrip("/"), transform.child_frame_id.lstrip("/")
        if ends == (parent.lstrip("/"), child.lstrip("/")):
            yield _pose(transform, *POSES["geometry_msgs/msg/TransformStamped"])


def _pose(message, position, orientation):
    p = _part(message, position)
    q = _part(message, orientation) if orientation else None
    stamp = message.header.stamp
    return (
        stamp.sec + stamp.nanosec * 1e-9,
        (p.x, p.y, p.z),
        None if q is None else (q.x, q.y, q.z, q.w),
    )


def _part(message, name):
    for step in name.split("."):
        message = getattr(message, step)
    return message


def _as_trajectory(messages, source):
    if not messages:
        raise AmrError(f"{source} has no messages.")
    stamps, xyz, q = zip(*messages, strict=True)
    stamps, kept = np.unique(np.array(stamps), return_index=True)
    xyz = np.array(xyz)[kept]
    repairs = ()
    if len(kept) == 1 < len(messages):
        raise AmrError(
            f"all {len(messages)} messages of {source} have the stamp {stamps[0]:g} s in their "
            "header: nobody filled it in, so that they cannot be told apart in time."
        )
    if len(kept) < len(messages):
        repairs = (f"{len(messages) - len(kept)} repeated stamps left out",)
    if q[0] is None:
        why = "the topic has positions only"
        return Trajectory(stamps, xyz, source, repairs, why_no_orientation=why)
    return Trajectory(stamps, spatial_poses(xyz, np.array(q)[kept]), source, repairs)
