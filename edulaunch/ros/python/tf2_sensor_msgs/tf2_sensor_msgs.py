"""Functions that transform point clouds."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import Transform, TransformStamped
from sensor_msgs.msg import PointCloud2
from std_msgs.msg import Header
from tf2_ros.buffer_interface import provide


def to_msg_msg(msg: Any) -> Any:
    """Return the message itself, because it needs no conversion."""
    return msg


from_msg_msg = to_msg_msg


def transform_points(point_cloud: Any, transform: Transform) -> Any:
    """Return the points (an array of N rows of x, y and z in metres), rotated and then translated."""
    import numpy as np

    q, move = transform.rotation, transform.translation
    points = np.asarray(point_cloud, dtype=float)
    axis = np.array([q.x, q.y, q.z])
    turn = 2.0 * np.cross(axis, points)
    return points + q.w * turn + np.cross(axis, turn) + [move.x, move.y, move.z]


def do_transform_cloud(cloud: PointCloud2, transform: Transform | TransformStamped) -> PointCloud2:
    """Return a new cloud with transformed fields x, y and z. All other fields are unchanged.

    The new cloud has the frame and stamp of the transform, if the transform has a header.

    :raises AssertionError: when the cloud lacks one of x, y and z.
    """
    from sensor_msgs_py.point_cloud2 import create_cloud, read_points, read_points_numpy

    header = Header(stamp=cloud.header.stamp, frame_id=cloud.header.frame_id)
    if isinstance(transform, TransformStamped):
        header = Header(stamp=transform.header.stamp, frame_id=transform.header.frame_id)
        transform = transform.transform
    moved = transform_points(read_points_numpy(cloud, ['x', 'y', 'z']), transform)
    points = read_points(cloud).copy()
    for column, name in enumerate('xyz'):
        points[name] = moved[:, column]
    shape = (cloud.height, cloud.width) if cloud.height > 1 else (cloud.width,)
    return create_cloud(header, cloud.fields, points.reshape(shape), cloud.point_step)


provide('transform', PointCloud2, do_transform_cloud)
provide('to_msg', PointCloud2, to_msg_msg)
provide('from_msg', PointCloud2, from_msg_msg)
