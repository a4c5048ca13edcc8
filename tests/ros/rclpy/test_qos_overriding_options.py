"""rclpy.qos_overriding_options: parameters that override the quality of service."""

from __future__ import annotations

import pytest
from rclpy.node import Node
from rclpy.qos import QoSPolicyKind, QoSProfile
from rclpy.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions
from std_msgs.msg import String

from .conftest import Ros, World


def test_parameters_may_override_quality_of_service(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        options = QoSOverridingOptions((QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY))
        publisher = node.create_publisher(String, 'c', QoSProfile(depth=10), qos_overriding_options=options)
        world.say((publisher.qos_profile.depth, node.get_parameter('qos_overrides./c.publisher.reliability').value))

    assert ros(body, '--ros-args', '-p', 'qos_overrides./c.publisher.depth:=3') == [(3, 'reliable')]


def test_quality_of_service_overrides_may_be_refused(ros: Ros, world: World) -> None:
    from rcl_interfaces.msg import SetParametersResult

    def body() -> None:
        options = QoSOverridingOptions.with_default_policies(callback=lambda profile: SetParametersResult(reason='no'))
        with pytest.raises(
            InvalidQosOverridesError, match='^Provided QoS overrides for publisher `/c` with id `None`, are not valid: no$'
        ):
            Node('n').create_publisher(String, 'c', 10, qos_overriding_options=options)
        world.say('refused')

    assert ros(body) == ['refused']


@pytest.mark.parametrize(
    ('value', 'what'),
    [
        ('best_effort', 'reliability for publisher `/c` with id `left`'),
        ('wrong', 'Unexpected QoS override for policy `reliability`: `wrong`'),
    ],
)
def test_an_override_is_described_by_its_endpoint_and_must_name_a_value(ros: Ros, world: World, value: str, what: str) -> None:
    def body() -> None:
        node, options = Node('n'), QoSOverridingOptions([QoSPolicyKind.RELIABILITY], entity_id='left')
        try:
            node.create_publisher(String, 'c', 10, qos_overriding_options=options)
            world.say(node.describe_parameter('qos_overrides./c.publisher_left.reliability').description)
        except RuntimeError as error:
            world.say(str(error))

    assert ros(body, '--ros-args', '-p', f'qos_overrides./c.publisher_left.reliability:={value}') == [what]


def test_a_subscription_has_no_lifespan_to_override(ros: Ros, world: World) -> None:
    def body() -> None:
        node, options = Node('n'), QoSOverridingOptions([QoSPolicyKind.LIFESPAN, QoSPolicyKind.DEADLINE])
        node.create_subscription(String, 'c', print, 10, qos_overriding_options=options)
        world.say(sorted(name for name in node.get_parameters_by_prefix('qos_overrides./c')))

    assert ros(body) == [['subscription.deadline']]
