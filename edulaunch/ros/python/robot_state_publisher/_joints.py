"""The joints of a robot description that urdf_parser_py has parsed, and the transform of each joint at a position."""

from __future__ import annotations

import re
from importlib.util import find_spec
from math import cos, sin
from typing import Any, NamedTuple

from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.tf.quaternions import multiply
from edulaunch.errors import MissingExtra

MOVING = ('revolute', 'continuous', 'prismatic')
"""The kinds of joints that move. As in ROS 2's program, joints with several degrees of freedom count as fixed."""
LIMITED = ('revolute', 'prismatic')
"""The kinds of joints that ROS 2's program rejects without <limit>."""
Quaternion = tuple[float, float, float, float]


class Mimic(NamedTuple):
    """A joint that follows another joint, at the position `multiplier * position + offset`."""

    joint: str
    multiplier: float
    offset: float


class Joint(NamedTuple):
    """One joint of a robot.

    :param origin: the transform from the parent link to the child link at position 0. It has x, y, z in metres and the rotation
        (x, y, z, w).
    :param axis: the unit vector of the axis around which the child turns, or along which it slides.
    :param lower: the lowest position (radians or metres). If the description has no limit, `lower` and `upper` are 0.
    """

    name: str
    kind: str
    parent: str
    child: str
    origin: tuple[float, float, float]
    turn: Quaternion
    axis: tuple[float, float, float]
    lower: float = 0.0
    upper: float = 0.0
    mimic: Mimic | None = None

    @property
    def is_moving(self) -> bool:
        """Whether the joint can move, and therefore has a position."""
        return self.kind in MOVING

    def transform(self, position: float) -> tuple[tuple[float, float, float], Quaternion]:
        """Return the translation (metres) and rotation (x, y, z, w) from the parent link to the child link.

        :param position: the position of the joint, in radians or metres, depending on the type of the joint.
        """
        if self.kind == 'prismatic':
            slid = rotated(self.turn, tuple(position * part for part in self.axis))
            x, y, z = (start + part for start, part in zip(self.origin, slid, strict=True))
            return (x, y, z), self.turn
        if not self.is_moving:
            return self.origin, self.turn
        half = sin(position / 2.0)
        x, y, z = self.axis
        return self.origin, multiply(self.turn, (x * half, y * half, z * half, cos(position / 2.0)))


_TRANSMISSIONS = re.compile(r'<transmission\b[^>]*/>|<transmission\b.*?</transmission\s*>', re.DOTALL)
"""The elements that ROS 2's parser ignores. urdf_parser_py rejects such elements if they come from ros2_control."""


def read_joints(description: str) -> list[Joint]:
    """Return the joints of a URDF string, in the order of the string.

    :raises ValueError: when the string is not a robot description. The message comes from the parser.
    :raises SystemExit: when the parser is not installed. The program then ends with a message.
    """
    if find_spec('urdf_parser_py') is None:
        raise SystemExit(str(MissingExtra('a robot description', 'urdf-parser-py', 'urdf')))
    from urdf_parser_py import xml_reflection
    from urdf_parser_py.urdf import URDF

    xml_reflection.core.on_error = lambda message: None  # the default prints each unknown tag, such as <gazebo>
    try:
        robot = URDF.from_xml_string(_TRANSMISSIONS.sub('', description).encode())
    except Exception as error:
        raise ValueError(' '.join(str(error).split()) or type(error).__name__) from error
    for found in robot.joints:
        if found.joint_type in LIMITED and found.limit is None:
            raise ValueError(f'Joint [{found.name}] is of type {found.joint_type.upper()} but it does not specify limits')
    for kind, names in (('link', [link.name for link in robot.links]), ('joint', [found.name for found in robot.joints])):
        if len(set(names)) < len(names):
            raise ValueError(f"{kind} '{next(name for name in names if names.count(name) > 1)}' is not unique.")
    joints = [_joint(found) for found in robot.joints]
    _check_tree([link.name for link in robot.links], joints)
    return joints


def _check_tree(links: list[str], joints: list[Joint]) -> None:
    """Check that all links exist and that they form a tree with one root.

    :raises ValueError: when they do not, because ROS 2's parser rejects such a description.
    """
    if not links:
        raise ValueError('No link elements found in urdf file')
    for joint in joints:
        for end, link in (('parent', joint.parent), ('child', joint.child)):
            if link not in links:
                near = did_you_mean(link, links)
                raise ValueError(
                    f'Failed to build tree: {end} link [{link}] of joint [{joint.name}] not found' + (f'; {near}' if near else '')
                )
    children = {joint.child for joint in joints}
    roots = [link for link in links if link not in children]
    if len(roots) != 1:
        found = (
            f'Two root links found: [{roots[0]}] and [{roots[1]}]'
            if roots
            else 'No root link found. The robot xml is not a tree.'
        )
        raise ValueError(f'Failed to find root link: {found}')


def _joint(found: Any) -> Joint:
    xyz, rpy = (
        ((0.0,) * 3, (0.0,) * 3) if found.origin is None else (found.origin.xyz or (0.0,) * 3, found.origin.rpy or (0.0,) * 3)
    )
    axis = tuple(map(float, found.axis or (1.0, 0.0, 0.0)))
    length = sum(part * part for part in axis) ** 0.5 or 1.0
    x, y, z = (part / length for part in axis)
    limit, mimic = found.limit, found.mimic
    return Joint(
        found.name,
        found.joint_type,
        found.parent,
        found.child,
        (float(xyz[0]), float(xyz[1]), float(xyz[2])),
        of_rpy(*map(float, rpy)),
        (x, y, z),
        0.0 if limit is None else float(limit.lower or 0.0),
        0.0 if limit is None else float(limit.upper or 0.0),
        None if mimic is None else Mimic(mimic.joint, 1.0 if mimic.multiplier is None else mimic.multiplier, mimic.offset or 0.0),
    )


def of_rpy(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the rotation (x, y, z, w) for a URDF's rpy in radians. The rotations are about the fixed axes x, y and z, in this
    order.
    """
    about_x = (sin(roll / 2), 0.0, 0.0, cos(roll / 2))
    about_y = (0.0, sin(pitch / 2), 0.0, cos(pitch / 2))
    about_z = (0.0, 0.0, sin(yaw / 2), cos(yaw / 2))
    return multiply(about_z, multiply(about_y, about_x))


def rotated(turn: Quaternion, vector: Any) -> tuple[float, float, float]:
    """Return a vector after the rotation `turn` (x, y, z, w)."""
    x, y, z, w = turn
    rx, ry, rz, _ = multiply(multiply(turn, (*vector, 0.0)), (-x, -y, -z, w))
    return rx, ry, rz
