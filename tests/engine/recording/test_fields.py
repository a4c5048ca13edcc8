"""Fields of messages by path."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.recording.absent import NotRecorded
from edulaunch.engine.recording.fields import getter, leaf_paths


def cls(name: str) -> Any:
    return current_registry().get(name)


def test_a_path_leads_through_messages_and_lists() -> None:
    kind = cls('sensor_msgs/msg/LaserScan')
    scan = kind(ranges=[1.0, 2.0, 3.0])
    scan.header.stamp.sec = 7
    values = [getter(kind, path)(scan) for path in ('header.stamp.sec', 'ranges[0]', 'ranges[-1]', 'header.frame_id')]
    assert values == [7, 1.0, 3.0, '']
    assert list(getter(kind, 'ranges')(scan)) == [1.0, 2.0, 3.0]


def test_a_path_may_end_at_a_message_and_go_on_behind_an_element() -> None:
    kind = cls('tf2_msgs/msg/TFMessage')
    message = kind(transforms=[cls('geometry_msgs/msg/TransformStamped')(child_frame_id='a')])
    assert getter(kind, 'transforms[0].child_frame_id')(message) == 'a'
    assert getter(cls('geometry_msgs/msg/Twist'), 'linear')(cls('geometry_msgs/msg/Twist')()).x == 0.0


@pytest.mark.parametrize('path', ['', 'linear.', 'linear..x', 'linear x', 'ranges[a]', 'ranges[0', '[0]'])
def test_what_is_not_a_path_is_a_value_error(path: str) -> None:
    with pytest.raises(ValueError, match='is not a path of a field'):
        getter(cls('geometry_msgs/msg/Twist'), path)


def test_an_unknown_field_names_the_nearest_one() -> None:
    with pytest.raises(NotRecorded, match=r"geometry_msgs/msg/Twist has no field 'linear\.xx'") as caught:
        getter(cls('geometry_msgs/msg/Twist'), 'linear.xx')
    assert 'linear.x' in str(caught.value)
    with pytest.raises(NotRecorded):
        getter(cls('geometry_msgs/msg/Twist'), 'lin')


def test_an_element_that_is_not_there_is_said_with_how_many_there_are() -> None:
    take = getter(cls('sensor_msgs/msg/LaserScan'), 'ranges[3]')
    with pytest.raises(NotRecorded, match=r"'ranges\[3\]' has no element 3, only 2 of them"):
        take(cls('sensor_msgs/msg/LaserScan')(ranges=[1.0, 2.0]))


def test_leaves_are_the_fields_without_parts() -> None:
    assert leaf_paths(cls('geometry_msgs/msg/Vector3')) == ['x', 'y', 'z']
    assert leaf_paths(cls('geometry_msgs/msg/Twist'))[:4] == ['linear.x', 'linear.y', 'linear.z', 'angular.x']
