"""rosidl_runtime_py: interfaces by name, messages as data and text."""

from __future__ import annotations

from typing import Any

import pytest
from geometry_msgs.msg import Polygon, Twist
from nav_msgs.msg import Path
from rosidl_runtime_py import (
    get_interface_path,
    get_interfaces,
    get_message_interfaces,
    get_service_interfaces,
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
    utilities,
)
from rosidl_runtime_py.convert import get_message_slot_types
from sensor_msgs.msg import Imu, JointState
from std_msgs.msg import Header, String
from std_srvs.srv import Trigger


def test_a_message_as_data_keeps_the_order_of_its_fields() -> None:
    message = JointState(name=['a'], position=[1.0])
    assert list(message_to_ordereddict(message)) == ['header', 'name', 'position', 'velocity', 'effort']
    assert message_to_ordereddict(message)['position'] == [1.0]
    assert message_to_ordereddict(message, no_arr=True)['name'] == '<sequence<string>, length: 1>'


def test_texts_are_those_of_topic_echo() -> None:
    assert message_to_yaml(String(data='hello'), truncate_length=3) == 'data: hel...\n'
    assert message_to_yaml(Header(frame_id='map'), flow_style=True) == '{stamp: {sec: 0, nanosec: 0}, frame_id: map}\n'
    assert message_to_csv(Twist()) == '0.0,0.0,0.0,0.0,0.0,0.0'


@pytest.mark.parametrize(
    ('find', 'name', 'found'),
    [
        (utilities.get_message, 'std_msgs/msg/String', String),
        (utilities.get_message, 'std_msgs/String', String),
        (utilities.get_service, 'std_srvs/srv/Trigger', Trigger),
        (utilities.get_interface, 'std_srvs/srv/Trigger', Trigger),
    ],
)
def test_classes_are_found_by_name(find: Any, name: str, found: Any) -> None:
    assert find(name) is found


@pytest.mark.parametrize(
    ('name', 'error'),
    [
        ('String', ValueError),
        ('std_srvs/srv/Trigger', ValueError),
        ('nope_msgs/msg/A', ModuleNotFoundError),
        ('std_msgs/msg/Strin', AttributeError),
    ],
)
def test_wrong_names_are_refused(name: str, error: type[Exception]) -> None:
    with pytest.raises(error):
        utilities.get_message(name)


def test_kinds_are_told_apart() -> None:
    kinds = (utilities.is_message, utilities.is_service, utilities.is_action)
    action = utilities.get_action('example_interfaces/action/Fibonacci')
    assert [[is_kind(each) for is_kind in kinds] for each in (String, Trigger, action)] == [
        [True, False, False],
        [False, True, False],
        [False, False, True],
    ]


def test_the_feedback_of_an_action_is_a_message() -> None:
    """As a program needs it that subscribes to every topic there is."""
    found = utilities.get_message('example_interfaces/action/Fibonacci_FeedbackMessage')
    assert 'feedback' in found.get_fields_and_field_types()


def test_what_there_is() -> None:
    assert get_message_interfaces(['turtlesim']) == {'turtlesim': ['msg/Color', 'msg/Pose']}
    assert 'srv/Spawn' in get_interfaces(['turtlesim'])['turtlesim'] == sorted(get_interfaces(['turtlesim'])['turtlesim'])
    assert get_service_interfaces(['geometry_msgs']) == {}
    assert get_interface_path('std_msgs/msg/String').endswith('share/std_msgs/msg/String.msg')
    with pytest.raises(LookupError, match="Unknown package 'nope'"):
        get_interfaces(['nope'])


def test_values_are_converted_to_the_types_of_the_fields() -> None:
    message = Imu()
    set_message_fields(
        message, {'linear_acceleration': {'x': 1, 'y': '2'}, 'orientation_covariance': range(9), 'header': {'frame_id': 7}}
    )
    assert (message.linear_acceleration.x, message.linear_acceleration.y, message.header.frame_id) == (1.0, 2.0, '7')
    assert message.orientation_covariance.tolist() == [float(i) for i in range(9)]
    joints = JointState()
    set_message_fields(joints, {'name': ['a'], 'position': [1, 2]})
    assert (joints.name, joints.position.tolist()) == (['a'], [1.0, 2.0])


def test_nested_messages_are_filled_from_dictionaries_or_taken_as_they_are() -> None:
    polygon, path, header = Polygon(), Path(), Header(frame_id='map')
    set_message_fields(polygon, {'points': [{'x': 1}, {'y': 2}]})
    set_message_fields(path, {'header': header})
    assert [(point.x, point.y) for point in polygon.points] == [(1.0, 0.0), (0.0, 2.0)]
    assert path.header is header


def test_auto_and_now_are_stamped_later() -> None:
    path = Path()
    stamps = set_message_fields(
        path, {'header': 'auto', 'poses': [{'header': {'stamp': 'now'}}]}, expand_header_auto=True, expand_time_now=True
    )
    for stamp in stamps:
        stamp(Header(frame_id='x').stamp.__class__(sec=5))
    assert (path.header.stamp.sec, path.poses[0].header.stamp.sec) == (5, 5)


@pytest.mark.parametrize(
    ('values', 'error', 'text'),
    [
        (3, TypeError, "Value '3' is expected to be a dictionary but is a int"),
        ({'z': 1}, AttributeError, "'String' object has no attribute 'z'"),
    ],
)
def test_values_that_do_not_fit_are_refused(values: Any, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        set_message_fields(String(), values)


def test_slot_types_by_name() -> None:
    assert list(get_message_slot_types(Header())) == ['stamp', 'frame_id']


def test_a_type_by_name_is_the_class_it_stands_for() -> None:
    from geometry_msgs.msg import Twist, Vector3
    from rosidl_runtime_py.import_message import import_message_from_namespaced_type
    from rosidl_runtime_py.utilities import get_namespaced_type

    assert get_namespaced_type('geometry_msgs/msg/Vector3') == Twist.SLOT_TYPES[0]
    assert import_message_from_namespaced_type(Twist.SLOT_TYPES[0]) is Vector3
    with pytest.raises(ValueError, match='such as'):
        get_namespaced_type('Vector3')
