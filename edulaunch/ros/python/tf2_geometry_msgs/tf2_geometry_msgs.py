"""The functions that transform geometry_msgs, and their registration for `Buffer.transform`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

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
from tf2_ros.buffer_interface import provide

from edulaunch.engine.tf import quaternions, transforms
from edulaunch.engine.tf.quaternions import Matrix, Quaternion
from edulaunch.engine.tf.transforms import Transform


def to_msg_msg(msg: Any) -> Any:
    """Return the message itself, because it needs no conversion."""
    return msg


from_msg_msg = to_msg_msg


def do_transform_point(point: PointStamped, transform: TransformStamped) -> PointStamped:
    """Return the point in the transform's frame. The result has the transform's header."""
    result = PointStamped(header=transform.header)
    result.point.x, result.point.y, result.point.z = transforms.apply(
        _numbers(transform), (point.point.x, point.point.y, point.point.z)
    )
    return result


def do_transform_vector3(vector3: Vector3Stamped, transform: TransformStamped) -> Vector3Stamped:
    """Return the vector, rotated into the transform's frame. A vector has no position, so the translation is not added.

    As in upstream, the function sets the translation of the argument `transform` to zero.
    """
    transform.transform.translation.x = transform.transform.translation.y = transform.transform.translation.z = 0.0
    result = Vector3Stamped(header=transform.header)
    result.vector.x, result.vector.y, result.vector.z = quaternions.rotate(
        _rotation(transform.transform.rotation), (vector3.vector.x, vector3.vector.y, vector3.vector.z)
    )
    return result


def do_transform_pose(pose: Pose, transform: TransformStamped) -> Pose:
    """Return the pose in the transform's frame. Its orientation has w >= 0."""
    at = pose.position
    moved = transforms.compose(_numbers(transform), (at.x, at.y, at.z, *_rotation(pose.orientation)))
    x, y, z, w = quaternions.canonical(moved[3:])
    sign = -1.0 if w < 0.0 else 1.0
    result = Pose()
    result.position.x, result.position.y, result.position.z = moved[:3]
    turned = result.orientation
    turned.x, turned.y, turned.z, turned.w = x * sign + 0.0, y * sign + 0.0, z * sign + 0.0, w * sign
    return result


def do_transform_pose_stamped(pose: PoseStamped, transform: TransformStamped) -> PoseStamped:
    """Return the pose in the transform's frame. The result has the transform's header."""
    return PoseStamped(header=transform.header, pose=do_transform_pose(pose.pose, transform))


def do_transform_pose_with_covariance_stamped(
    pose: PoseWithCovarianceStamped, transform: TransformStamped
) -> PoseWithCovarianceStamped:
    """Return the pose and covariance in the transform's frame."""
    result = PoseWithCovarianceStamped(header=transform.header)
    result.pose.pose = do_transform_pose(pose.pose.pose, transform)
    result.pose.covariance = transform_covariance(pose.pose.covariance, transform)
    return result


def do_transform_polygon_stamped(polygon: PolygonStamped, transform: TransformStamped) -> PolygonStamped:
    """Return all points of the polygon in the transform's frame."""
    numbers = _numbers(transform)
    result = PolygonStamped(header=transform.header)
    for point in polygon.polygon.points:
        x, y, z = transforms.apply(numbers, (point.x, point.y, point.z))
        result.polygon.points.append(Point32(x=x, y=y, z=z))
    return result


def transform_covariance(cov_in: Sequence[float], transform: TransformStamped) -> list[float]:
    """Return a 6x6 covariance (36 numbers, row by row) in the transform's frame. With the rotation R, each 3x3 block B becomes
    R B R^T.
    """
    r = quaternions.to_matrix(_rotation(transform.transform.rotation))
    result = [0.0] * 36
    for row in (0, 3):
        for column in (0, 3):
            block = [[float(cov_in[(row + i) * 6 + column + j]) for j in range(3)] for i in range(3)]
            for i in range(3):
                for j in range(3):
                    result[(row + i) * 6 + column + j] = _turned(r, block, i, j)
    return result


def _turned(r: Matrix, block: list[list[float]], i: int, j: int) -> float:
    return sum(r[i][k] * block[k][m] * r[j][m] for k in range(3) for m in range(3))


def _rotation(q: Any) -> Quaternion:
    """Return the rotation of a message, normalized to unit length. If all components are zero, return the identity."""
    if q.x == q.y == q.z == q.w == 0.0:
        return quaternions.IDENTITY
    return quaternions.canonical((q.x, q.y, q.z, q.w))


def _numbers(transform: TransformStamped) -> Transform:
    at = transform.transform.translation
    return (at.x, at.y, at.z, *_rotation(transform.transform.rotation))


_FUNCTIONS = {
    PointStamped: do_transform_point,
    Vector3Stamped: do_transform_vector3,
    PoseStamped: do_transform_pose_stamped,
    PoseWithCovarianceStamped: do_transform_pose_with_covariance_stamped,
    PolygonStamped: do_transform_polygon_stamped,
}
for _type, _function in _FUNCTIONS.items():
    provide('transform', _type, _function)
    provide('to_msg', _type, to_msg_msg)
    provide('from_msg', _type, from_msg_msg)
