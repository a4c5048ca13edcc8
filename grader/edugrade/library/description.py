"""Compares the transforms of robot_state_publisher with the robot description and the positions of the joints.

robot_state_publisher runs in the same process as the submission, which could change it. So its transforms alone prove nothing.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, hypot, pi, sin
from typing import TYPE_CHECKING, NamedTuple

from ..evidence import Advice, Evidence, Mismatch
from .frames import Sent, numbers, transforms

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

    from edulaunch.engine.recording import Recording

OFF, SOON_S = 1e-3, 0.1  # largest error in m or as a part of a rotation, and largest time between a position and its transform
JOINT_STATES = 'sensor_msgs/msg/JointState'
Three = tuple[float, float, float]


class Joint(NamedTuple):
    """A joint of a robot description. A fixed joint has no `axis`."""

    name: str
    parent: str
    kind: str
    xyz: Three
    rpy: Three
    axis: Three | None


def joints_of(text: str) -> dict[str, Joint]:
    """Return the joints of a robot description, by the name of the child link. Return {} for an invalid description."""
    from xml.etree import ElementTree

    try:
        return dict(_joints(ElementTree.fromstring(text)))
    except (ElementTree.ParseError, ValueError):
        return {}


def _joints(robot: Element) -> Iterator[tuple[str, Joint]]:
    for joint in robot.iter('joint'):
        below, above = joint.find('child'), joint.find('parent')
        if below is None or above is None:
            continue
        origin, axis, kind = joint.find('origin'), joint.find('axis'), joint.get('type', '')
        xyz, rpy = (_three('0 0 0' if origin is None else origin.get(name, '0 0 0')) for name in ('xyz', 'rpy'))
        moves = kind in ('revolute', 'continuous', 'prismatic')
        turns = _three('1 0 0' if axis is None else axis.get('xyz', '1 0 0')) if moves else None
        yield below.get('link', ''), Joint(joint.get('name', ''), above.get('link', ''), kind, xyz, rpy, turns)


def _three(text: str) -> Three:
    x, y, z = map(float, text.split())
    return x, y, z


def require_derived(run: Evidence, scenario: str, child: str, joint: Joint, try_: Advice) -> None:
    """Require that every transform of a link follows from its joint and from a position of this joint on a topic.

    :param child: the link.
    :raises Mismatch: with a transform that does not follow from the joint and its positions.
    """
    known = list(_positions(run[scenario], joint.name))
    for sent in transforms(run, scenario).get(child, ()):
        recent = [value for time_s, value in known if sent.time_s - SOON_S <= time_s <= sent.time_s] if joint.axis else [0.0]
        if not any(_is_same(sent, joint, value) for value in recent):
            asked = f'{numbers(joint.xyz)} from {joint.parent}, and a position of the joint {joint.name} on a topic'
            thing = f'the transform of {child} at {sent.time_s:.2f} s in the run with {run.scenario(scenario).words}'
            raise Mismatch(thing, asked, f'{numbers(sent.frame.translation)} from {sent.frame.parent}', try_=try_)


def _positions(recording: Recording, name: str) -> Iterator[tuple[float, float]]:
    for topic in recording.topics.values():
        if topic.type == JOINT_STATES:
            for time_s, message in recording.messages(topic.name):
                if name in message.name and len(message.name) == len(message.position):
                    yield time_s, message.position[list(message.name).index(name)]


def _is_same(sent: Sent, joint: Joint, position: float) -> bool:
    from edulaunch.engine.tf.quaternions import from_euler, multiply, rotate

    (x, y, z), turn, frame = joint.xyz, from_euler(*joint.rpy), sent.frame
    axis, length = joint.axis or (1.0, 0.0, 0.0), hypot(*(joint.axis or (1.0, 0.0, 0.0))) or 1.0
    along = tuple(part / length for part in axis)
    if joint.kind == 'prismatic':
        dx, dy, dz = rotate(turn, (along[0] * position, along[1] * position, along[2] * position))
        x, y, z = x + dx, y + dy, z + dz
    elif joint.axis:
        half = position % (4 * pi) / 2
        turn = multiply(turn, (along[0] * sin(half), along[1] * sin(half), along[2] * sin(half), cos(half)))
    same_turn = abs(abs(sum(a * b for a, b in zip(turn, frame.rotation, strict=True))) - 1.0) <= OFF * OFF
    return same_turn and all(abs(a - b) <= OFF for a, b in zip((x, y, z), frame.translation, strict=True))
