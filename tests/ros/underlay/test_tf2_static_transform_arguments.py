"""The command line of static_transform_publisher."""

from __future__ import annotations

import pytest
from tf2_ros.static_transform_publisher_node import ArgumentError, parse

from edulaunch.engine.tf.quaternions import from_euler

FRAMES = ['--frame-id', 'world', '--child-frame-id', 'child']
IDENTITY = (0.0, 0.0, 0.0, 1.0)


def test_flags_stand_in_any_order_and_default_to_zero():
    request = parse(['--z', '1', *FRAMES, '--x', '-0.5'])
    assert request[:3] == ('world', 'child', (-0.5, 0.0, 1.0, *IDENTITY))
    assert not request.old_style


def test_angles_are_roll_pitch_yaw_about_fixed_axes():
    request = parse([*FRAMES, '--yaw', '0.3', '--roll', '0.1', '--pitch', '0.2'])
    assert request.transform[3:] == from_euler(0.1, 0.2, 0.3)


def test_a_quaternion_is_taken_as_it_is():
    assert parse([*FRAMES, '--qz', '1', '--qw', '0']).transform[3:] == (0.0, 0.0, 1.0, 0.0)


def test_the_old_order_has_yaw_first():
    request = parse(['1', '2', '3', '0.3', '0.2', '0.1', 'world', 'child'])
    assert request == ('world', 'child', (1.0, 2.0, 3.0, *from_euler(0.1, 0.2, 0.3)), True)
    assert parse(['1', '2', '3', '0', '0', '1', '0', 'world', 'child']).transform == (1.0, 2.0, 3.0, 0.0, 0.0, 1.0, 0.0)


def test_what_follows_a_number_is_ignored_as_in_cpp():
    assert parse([*FRAMES, '--x', '1.5m', '--y', ' 2e1', '--z', '.5']).transform[:3] == (1.5, 20.0, 0.5)


@pytest.mark.parametrize(
    ('line', 'reason'),
    [
        ('', 'Not enough arguments to parse'),
        ('1 2 3 0 0', 'Not enough arguments to parse'),
        ('1 2 3 0 0 0 1 a b c', 'Extra unparsed arguments on command-line'),
        ('--frame-id world --x', 'Not enough arguments for --x'),
        ('--x one --frame-id a --child-frame-id b', 'Failed to parse --x argument as float'),
        ('--yaw 1 --qw 1 --frame-id a --child-frame-id b', 'Cannot specify both quaternion and Euler rotations'),
        ('--x 1 2 3 --frame-id a', 'Cannot specify both new-style (flags) and old-style (arguments)'),
        ('--x 1 --child-frame-id b', 'Frame id must not be empty'),
        ('--x 1 --frame-id a', 'Child frame id must not be empty'),
    ],
)
def test_each_mistake_has_ros_own_reason(line, reason):
    with pytest.raises(ArgumentError) as caught:
        parse(line.split())
    assert str(caught.value) == reason
