"""Transforms of robot_state_publisher count only where the description and a position of the joint give them."""

from __future__ import annotations

from math import cos, pi, sin, sqrt
from types import SimpleNamespace
from typing import Any

import pytest
from edugrade import Mismatch
from edugrade.library.description import Joint, joints_of, require_derived

URDF = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/>
<joint name="turns" type="continuous"><parent link="a"/><child link="b"/><origin xyz="1 0 0" rpy="0 0 1.5707963"/><axis xyz="0 0 2"/></joint>
<joint name="slides" type="prismatic"><parent link="b"/><child link="c"/><origin rpy="0 0 1.5707963"/></joint>
<joint name="fixed" type="fixed"><parent link="c"/><child link="d"/><origin xyz="0 0 0.5"/></joint>
<joint name="half" type="fixed"><parent link="c"/></joint></robot>"""
HALF = sqrt(0.5)


class Run(dict[str, Any]):
    """One run with these transforms and joint positions."""

    def __init__(
        self, sent: list[tuple[float, tuple[float, ...], tuple[float, ...]]], states: list[tuple[float, str, float]]
    ) -> None:
        messages = [(time_s, SimpleNamespace(name=[name], position=[value])) for time_s, name, value in states]
        topic = SimpleNamespace(name='/joint_states', type='sensor_msgs/msg/JointState')
        super().__init__(one=SimpleNamespace(topics={'/joint_states': topic}, messages=lambda name: messages))
        self.sent = [
            SimpleNamespace(time_s=time_s, frame=SimpleNamespace(parent='a', translation=place, rotation=turn))
            for time_s, place, turn in sent
        ]

    def once(self, key: object, calculate: object) -> dict[str, Any]:
        return {'link': self.sent}

    def scenario(self, name: str) -> Any:
        return SimpleNamespace(words='no arguments')


def test_the_joints_of_a_description_are_read_and_nonsense_has_none() -> None:
    joints = joints_of(URDF)
    assert list(joints) == ['b', 'c', 'd']
    assert joints['b'] == Joint('turns', 'a', 'continuous', (1.0, 0.0, 0.0), (0.0, 0.0, 1.5707963), (0.0, 0.0, 2.0))
    assert joints['c'].axis == (1.0, 0.0, 0.0) and joints['d'].axis is None
    for text in ('', '<robot', URDF.replace('1 0 0', '1 0'), URDF.replace('0.5', 'x')):
        assert joints_of(text) == {}


def turned(angle: float) -> tuple[float, ...]:
    return 0.0, 0.0, sin(angle / 2), cos(angle / 2)


@pytest.mark.parametrize(
    ('link', 'place', 'turn', 'states', 'is_right'),
    [
        ('b', (1.0, 0.0, 0.0), turned(pi / 2 + 0.3), [(0.99, 'turns', 0.3)], True),
        ('b', (1.0, 0.0, 0.0), turned(pi / 2 + 0.3 + 2 * pi), [(0.99, 'turns', 0.3)], True),
        ('b', (1.0, 0.0, 0.0), turned(pi / 2 + 0.35), [(0.99, 'turns', 0.3)], False),
        ('b', (1.0, 0.0, 0.1), turned(pi / 2 + 0.3), [(0.99, 'turns', 0.3)], False),
        ('b', (1.0, 0.0, 0.0), turned(pi / 2 + 0.3), [(0.8, 'turns', 0.3)], False),
        ('b', (1.0, 0.0, 0.0), turned(pi / 2 + 0.3), [(1.01, 'turns', 0.3)], False),
        ('b', (1.0, 0.0, 0.0), turned(pi / 2 + 0.3), [(0.99, 'other', 0.3)], False),
        ('b', (1.0, 0.0, 0.0), turned(pi / 2), [], False),
        ('c', (0.0, 0.25, 0.0), (0.0, 0.0, HALF, HALF), [(1.0, 'slides', 0.25)], True),
        ('c', (0.25, 0.0, 0.0), (0.0, 0.0, HALF, HALF), [(1.0, 'slides', 0.25)], False),
        ('d', (0.0, 0.0, 0.5), (0.0, 0.0, 0.0, 1.0), [], True),
        ('d', (0.0, 0.0, 0.5), turned(0.01), [], False),
    ],
)
def test_a_transform_follows_from_the_joint_and_a_recent_position(
    link: str, place: tuple[float, ...], turn: tuple[float, ...], states: list[tuple[float, str, float]], is_right: bool
) -> None:
    run: Any = Run([(1.0, place, turn)], states)
    joint = joints_of(URDF)[link]
    if is_right:
        require_derived(run, 'one', 'link', joint, None)
    else:
        with pytest.raises(Mismatch, match=r'the transform of link at 1\.00 s in the run with no arguments'):
            require_derived(run, 'one', 'link', joint, None)
