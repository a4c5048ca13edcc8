"""What ROS 2 names are called in DDS."""

from __future__ import annotations

import pytest

from edulaunch.extras.network.dds.mangling import dds_type, remote_name, topic_name


def test_names_there_and_back() -> None:
    assert topic_name('rt', '/turtle1/pose') == 'rt/turtle1/pose'
    assert topic_name('rq', '/spawn') == 'rq/spawnRequest' and topic_name('rr', '/spawn') == 'rr/spawnReply'
    assert dds_type('geometry_msgs/msg/Twist') == 'geometry_msgs::msg::dds_::Twist_'


@pytest.mark.parametrize(
    ('topic', 'type_name', 'is_writer', 'found'),
    [
        ('rt/turtle1/pose', 'turtlesim::msg::dds_::Pose_', True, ('publisher', '/turtle1/pose', 'turtlesim/msg/Pose')),
        ('rt/turtle1/pose', 'turtlesim::msg::dds_::Pose_', False, ('subscription', '/turtle1/pose', 'turtlesim/msg/Pose')),
        ('rq/spawnRequest', 'turtlesim::srv::dds_::Spawn_Request_', False, ('service', '/spawn', 'turtlesim/srv/Spawn')),
        ('rq/spawnRequest', 'turtlesim::srv::dds_::Spawn_Request_', True, ('client', '/spawn', 'turtlesim/srv/Spawn')),
        (
            'rq/a/_action/send_goalRequest',
            'my::action::dds_::Go_SendGoal_Request_',
            False,
            ('service', '/a/_action/send_goal', 'my/action/Go_SendGoal'),
        ),
        ('rr/spawnReply', 'turtlesim::srv::dds_::Spawn_Response_', True, None),
        ('ros_discovery_info', 'rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_', True, None),
        ('Square', 'ShapeType', True, None),
        ('rt/plain', 'ShapeType', True, None),
        ('rq/spawn', 'turtlesim::srv::dds_::Spawn_Request_', True, None),
        ('rt/' + 'x' * 600, 'turtlesim::msg::dds_::Pose_', True, None),
    ],
)
def test_what_an_endpoint_of_dds_is_in_ros_2(topic: str, type_name: str, is_writer: bool, found: object) -> None:
    assert remote_name(topic, type_name, is_writer) == found
