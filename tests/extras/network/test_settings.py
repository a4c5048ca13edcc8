"""ROS 2's variables, and which topics cross."""

from __future__ import annotations

import pytest

from edulaunch.extras.network.links import make_link
from edulaunch.extras.network.network_link import LinkError, Settings
from edulaunch.extras.network.settings import settings_of


def test_without_settings_nobody_beyond_this_computer_is_looked_for() -> None:
    assert settings_of({}) == Settings(0, 'LOCALHOST', ())


def test_the_variables_of_ros_2() -> None:
    env = {'ROS_DOMAIN_ID': '7', 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET', 'ROS_STATIC_PEERS': '10.0.0.2;robot.local; '}
    assert settings_of(env) == Settings(7, 'SUBNET', ('10.0.0.2', 'robot.local'))
    assert settings_of({'ROS_LOCALHOST_ONLY': '1', 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'SUBNET'}).discovery_range == 'LOCALHOST'
    assert settings_of({'ROS_AUTOMATIC_DISCOVERY_RANGE': 'OFF', 'ROS_STATIC_PEERS': '10.0.0.2'}) == Settings(0, 'OFF', ())


@pytest.mark.parametrize(
    ('name', 'value', 'said'),
    [
        ('ROS_DOMAIN_ID', 'seven', "ROS_DOMAIN_ID is 'seven', not a number"),
        ('ROS_DOMAIN_ID', '-1', 'ROS_DOMAIN_ID must be from 0 to 232, not -1'),
        ('ROS_DOMAIN_ID', '233', 'ROS_DOMAIN_ID must be from 0 to 232, not 233'),
        ('ROS_AUTOMATIC_DISCOVERY_RANGE', 'SUBNETS', "help: did you mean 'SUBNET'?"),
    ],
)
def test_what_makes_no_sense_is_told(name: str, value: str, said: str) -> None:
    with pytest.raises(LinkError) as error:
        settings_of({name: value})
    assert said in str(error.value)


def test_an_unknown_link_is_told() -> None:
    with pytest.raises(LinkError, match='cyclonedds, rclpy'):
        make_link('cyclone')
