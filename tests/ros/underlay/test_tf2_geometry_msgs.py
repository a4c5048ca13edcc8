"""Transforming messages."""

from __future__ import annotations

from math import pi

import pytest
import tf2_geometry_msgs as under_test
from geometry_msgs.msg import (
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    TransformStamped,
    Vector3Stamped,
)
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.tf.quaternions import from_euler


def turn_and_shift(yaw: float = pi / 2) -> TransformStamped:
    """map <- base: 10 m along x, turned to the left."""
    return TransformStamped.from_wire((7, 8, 'map', 'base', 10.0, 0.0, 0.0, *from_euler(0.0, 0.0, yaw)))


def place(message) -> tuple[float, float, float]:
    return pytest.approx((message.x, message.y, message.z), abs=1e-6)


def test_a_point_is_turned_and_shifted_and_gets_the_header_of_the_transform():
    point = PointStamped()
    point.header.frame_id = 'base'
    point.point.x = 2.0
    result = under_test.do_transform_point(point, turn_and_shift())
    assert place(result.point) == (10.0, 2.0, 0.0)
    assert (result.header.frame_id, result.header.stamp.sec, result.header.stamp.nanosec) == ('map', 7, 8)


def test_a_vector_is_turned_only_and_the_given_transform_loses_its_translation():
    vector, transform = Vector3Stamped(), turn_and_shift()
    vector.vector.x = 2.0
    assert place(under_test.do_transform_vector3(vector, transform).vector) == (0.0, 2.0, 0.0)
    assert transform.transform.translation.x == 0.0


def test_a_pose_keeps_w_positive():
    pose = Pose()
    pose.orientation.z, pose.orientation.w = 1.0, 0.0
    result = under_test.do_transform_pose(pose, turn_and_shift())
    turned = result.orientation
    assert (turned.x, turned.y, turned.z, turned.w) == pytest.approx((0.0, 0.0, -(0.5**0.5), 0.5**0.5))


def test_a_zero_quaternion_counts_as_no_rotation():
    stamped = PoseStamped()
    stamped.pose.orientation.w = 0.0
    turned = under_test.do_transform_pose_stamped(stamped, turn_and_shift()).pose.orientation
    assert (turned.z, turned.w) == pytest.approx((0.5**0.5, 0.5**0.5))


def test_all_points_of_a_polygon_move():
    polygon = PolygonStamped()
    polygon.polygon.points = [Point32(x=1.0), Point32(y=1.0)]
    points = under_test.do_transform_polygon_stamped(polygon, turn_and_shift()).polygon.points
    assert place(points[0]) == (10.0, 1.0, 0.0)
    assert place(points[1]) == (9.0, 0.0, 0.0)


def test_a_covariance_turns_block_by_block():
    stamped = PoseWithCovarianceStamped()
    covariance = [0.0] * 36
    covariance[0], covariance[7], covariance[21], covariance[3] = 4.0, 9.0, 1.0, 2.0
    stamped.pose.covariance = covariance
    result = under_test.do_transform_pose_with_covariance_stamped(stamped, turn_and_shift()).pose.covariance
    assert [round(float(result[i]), 9) for i in (0, 7, 21, 28, 10)] == [9.0, 4.0, 0.0, 1.0, 2.0]


@given(st.lists(st.floats(-5.0, 5.0), min_size=36, max_size=36), st.floats(-3.0, 3.0))
def test_turning_a_covariance_keeps_the_trace_of_each_block(covariance, yaw):
    turned = under_test.transform_covariance(covariance, turn_and_shift(yaw))
    for corner in (0, 3, 18, 21):
        places = [corner + 7 * i for i in range(3)]
        assert sum(turned[i] for i in places) == pytest.approx(sum(covariance[i] for i in places), abs=1e-9)


def test_the_transformed_types_are_names_of_the_package():
    assert under_test.PoseStamped is PoseStamped
    assert {'PointStamped', 'Vector3Stamped', 'TransformStamped'} < set(under_test.__all__)
