"""YAML into messages and messages into YAML, as the commands do it."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.desk.cli.ros2.fill_message import FillError, ValuesError, fill_message, parse_values
from edulaunch.engine.interfaces import current_registry
from edulaunch.ros.serialization.message_text import EVERYTHING, Shortening, message_csv, message_dict, message_yaml

FINITE = st.floats(allow_nan=False, allow_infinity=False)


def filled(type_name: str, text: str) -> object:
    message = current_registry().get(type_name)()
    fill_message(message, parse_values(text))
    return message


@given(
    st.lists(FINITE, max_size=5),
    st.text(st.characters(codec='utf-8', exclude_categories=('Cc', 'Cs'))),
    st.integers(0, 2**32 - 1),
)
def test_what_is_printed_can_be_typed_in_again(numbers: list[float], label: str, size: int) -> None:
    cls, dimension = (
        current_registry().get('std_msgs/msg/Float64MultiArray'),
        current_registry().get('std_msgs/msg/MultiArrayDimension'),
    )
    message = cls(data=numbers)
    message.layout.dim = [dimension(label=label, size=size)]
    assert filled(cls.TYPE, message_yaml(message)) == message


@given(st.integers(-(2**15), 2**15 - 1))
def test_numbers_become_the_type_of_their_field(number: int) -> None:
    assert filled('turtlesim/msg/Pose', f'x: {number}').x == float(number)
    assert filled('std_msgs/msg/Int16', f"data: '{number}'").data == number


def test_header_auto_and_time_now_are_stamped_when_asked() -> None:
    message = current_registry().get('sensor_msgs/msg/TimeReference')()
    stamps = fill_message(message, parse_values('{header: auto, time_ref: now}'), stamps=True)
    for stamp in stamps:
        stamp(current_registry().get('builtin_interfaces/msg/Time')(sec=7))
    assert (message.header.stamp.sec, message.time_ref.sec) == (7, 7)


@pytest.mark.parametrize(
    ('type_name', 'text', 'reason'),
    [
        ('std_msgs/msg/UInt8', 'data: -1', 'unsigned integer in [0, 255]'),
        ('std_msgs/msg/Header', 'stamp: 5', "Value '5' is expected to be a dictionary but is a int"),
        ('std_msgs/msg/Header', 'auto: 5', 'help: the fields of std_msgs/msg/Header are: stamp, frame_id'),
        ('std_msgs/msg/Float64MultiArray', 'data: 5', "Value '5' of 'data' is expected to be a list but is a int"),
        ('std_msgs/msg/Float64MultiArray', 'layout: {dim: [{sise: 1}]}', "help: did you mean 'size'?"),
        ('std_msgs/msg/String', 'data: [a]', 'is expected to be a string but is a list'),
    ],
)
def test_a_misfit_names_field_and_reason(type_name: str, text: str, reason: str) -> None:
    with pytest.raises(FillError) as caught:
        filled(type_name, text)
    assert str(caught.value).startswith('Failed to populate field: ') and reason in str(caught.value)


@pytest.mark.parametrize('text', ['5', '[1]', '{x: ', "'", '{x: 2020-99-99}', '{x: ' * 2000, '{x: ' + '9' * 5000 + '}'])
def test_values_must_be_a_dictionary(text: str) -> None:
    with pytest.raises(ValuesError, match='^The passed value .*\n  help: write the fields in braces'):
        parse_values(text)


def test_shortening_cuts_strings_and_arrays() -> None:
    message = filled('sensor_msgs/msg/JointState', '{name: [left, right], position: [1, 2]}')
    assert message_dict(message, Shortening(length=3))['name'] == ['lef...', 'rig...']
    assert message_dict(message, Shortening(no_arr=True))['position'] == '<sequence<double>, length: 2>'
    assert message_dict(message, Shortening(no_str=True))['header']['frame_id'] == '<string, length: <0>>'


def test_csv_is_flat_and_yaml_keeps_the_order_of_fields() -> None:
    message = filled('geometry_msgs/msg/Twist', '{linear: {x: 1}, angular: {z: 2}}')
    assert message_csv(message) == '1.0,0.0,0.0,0.0,0.0,2.0'
    assert list(message_dict(message)) == ['linear', 'angular']
    assert message_yaml(message, EVERYTHING, flow_style=True).startswith('{linear: {x: 1.0, ')


def test_letters_are_shown_as_they_are() -> None:
    assert message_yaml(current_registry().get('std_msgs/msg/String')(data='grüße \N{TURTLE}')) == 'data: grüße \N{TURTLE}\n'
