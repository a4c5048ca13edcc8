"""tf2_sensor_msgs."""

from __future__ import annotations

import math

import pytest
import tf2_ros
import tf2_sensor_msgs
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from sensor_msgs.msg import PointCloud2, PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header

FIELDS = [
    PointField(name=name, offset=4 * i, datatype=PointField.FLOAT32, count=1) for i, name in enumerate(['x', 'y', 'z', 'heat'])
]


def quarter_turn() -> TransformStamped:
    transform = TransformStamped(header=Header(frame_id='world'), child_frame_id='lidar')
    transform.transform.translation = Vector3(x=2.0)
    transform.transform.rotation = Quaternion(z=math.sqrt(0.5), w=math.sqrt(0.5))
    return transform


def rows(cloud: PointCloud2) -> list[list[float]]:
    return [[round(float(value), 6) + 0.0 for value in point] for point in point_cloud2.read_points(cloud)]


def test_points_turn_and_move_and_other_fields_stay() -> None:
    cloud = point_cloud2.create_cloud(Header(frame_id='lidar'), FIELDS, [(1, 0, 0, 7), (0, 1, 5, 8)])
    moved = tf2_sensor_msgs.do_transform_cloud(cloud, quarter_turn())
    assert rows(moved) == [[2, 1, 0, 7], [1, 0, 5, 8]]
    assert (moved.header.frame_id, cloud.header.frame_id, rows(cloud)[0]) == ('world', 'lidar', [1, 0, 0, 7])


def test_an_organized_cloud_stays_organized() -> None:
    cloud = point_cloud2.create_cloud(Header(), FIELDS, [(float(i), 0, 0, 0) for i in range(6)])
    cloud.height, cloud.width = 2, 3
    moved = tf2_sensor_msgs.do_transform_cloud(cloud, quarter_turn().transform)
    assert (moved.height, moved.width, moved.row_step, rows(moved)[5]) == (2, 3, 48, [2, 5, 0, 0])


def test_a_buffer_transforms_clouds_once_the_package_is_imported() -> None:
    buffer = tf2_ros.Buffer()
    buffer.set_transform_static(quarter_turn(), 'test')
    cloud = point_cloud2.create_cloud_xyz32(Header(frame_id='lidar'), [(1, 0, 0)])
    assert rows(buffer.transform(cloud, 'world')) == [[2, 1, 0]]


def test_a_cloud_without_places_is_refused() -> None:
    cloud = point_cloud2.create_cloud(Header(), FIELDS[3:], [(7.0,)])
    with pytest.raises(AssertionError):
        tf2_sensor_msgs.do_transform_cloud(cloud, quarter_turn())
