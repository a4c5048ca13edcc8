"""What happens to endpoints over time: deadlines, leases, matches, lifespans."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile
from std_msgs.msg import String

from edulaunch.engine.sim.sync import sleep

from .conftest import World


def spin(node: Node, seconds: float) -> None:
    """Spin for so long."""
    over: list[bool] = []
    timer = node.create_timer(seconds, lambda: over.append(True))
    while not over:
        rclpy.spin_once(node)
    node.destroy_timer(timer)


def counts(world: World) -> list[Any]:
    return [(time, tuple(info)) for time, _, info in world.log]


@pytest.mark.parametrize('side', ['publisher', 'subscription'])
def test_a_missed_deadline_is_told_each_period_from_the_first_message_on(world: World, side: str) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        qos = QoSProfile(depth=1, deadline=Duration(seconds=0.5))
        tell: dict[str, Any] = {side: world.say}
        publisher = node.create_publisher(
            String, 't', qos, event_callbacks=PublisherEventCallbacks(deadline=tell.get('publisher'))
        )
        node.create_subscription(
            String, 't', lambda _: None, qos, event_callbacks=SubscriptionEventCallbacks(deadline=tell.get('subscription'))
        )
        spin(node, 1.0)
        for _ in range(2):
            publisher.publish(String())
            spin(node, 0.4)
        publisher.assert_liveliness()  # no message
        spin(node, 1.0)

    world.start(program)
    world.run()
    assert counts(world) == [(1900.0, (1, 1)), (2400.0, (2, 1))]


def test_a_publisher_that_does_not_show_itself_for_its_lease_is_not_alive(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        qos = QoSProfile(depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC, liveliness_lease_duration=Duration(seconds=0.5))
        publisher = node.create_publisher(String, 't', qos, event_callbacks=PublisherEventCallbacks(liveliness=world.say))
        node.create_subscription(
            String, 't', lambda _: None, qos, event_callbacks=SubscriptionEventCallbacks(liveliness=world.say)
        )
        for show in (lambda: publisher.publish(String()), publisher.assert_liveliness, lambda: None, publisher.assert_liveliness):
            show()
            spin(node, 0.4)
        node.destroy_publisher(publisher)
        spin(node, 1.0)

    world.start(program)
    world.run()
    assert counts(world) == [
        (0.0, (1, 0, 1, 0)),
        (900.0, (1, 1)),
        (900.0, (0, 1, -1, 1)),
        (1200.0, (1, 0, 1, -1)),
        (1600.0, (0, 0, -1, 0)),
    ]


def test_other_publishers_are_alive_while_they_exist(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        lease = QoSProfile(depth=1, liveliness_lease_duration=Duration(seconds=1))
        for qos in (lease, 1):  # without a lease nothing is told
            node.create_subscription(
                String, 't', lambda _: None, qos, event_callbacks=SubscriptionEventCallbacks(liveliness=world.say)
            )
        spin(node, 0.1)
        publishers = [node.create_publisher(String, 't', lease) for _ in range(2)]
        spin(node, 0.1)
        node.destroy_publisher(publishers[0])
        spin(node, 0.1)

    world.start(program)
    world.run()
    assert counts(world) == [(100.0, (2, 0, 2, 0)), (200.0, (1, 0, -1, 0))]


def test_partners_that_were_there_first_count_as_matched(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_publisher(String, 't', 1)
        node.create_subscription(String, 't', lambda _: None, 1, event_callbacks=SubscriptionEventCallbacks(matched=world.say))
        spin(node, 0.1)

    world.start(program)
    world.run()
    assert counts(world) == [(0.0, (1, 1, 1, 1))]


def test_a_late_subscription_gets_what_has_not_outlived_its_lifespan(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        qos = QoSProfile(depth=9, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=1.0))
        publisher = node.create_publisher(String, 't', qos)
        for word in 'abc':
            publisher.publish(String(data=word))
            spin(node, 0.6)
        node.create_subscription(String, 't', lambda msg: world.say(msg.data), qos)
        spin(node, 0.1)

    world.start(program)
    world.run()
    assert [what for _, _, what in world.log] == ['c']


def test_a_message_that_is_as_old_as_its_lifespan_is_gone(world: World) -> None:
    """A late subscription does not get it, and one that did not look in time has lost it."""

    def program() -> None:
        rclpy.init()
        node = Node('n')
        qos = QoSProfile(depth=9, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=1.0))
        publisher = node.create_publisher(String, 't', qos)
        node.create_subscription(String, 't', lambda message: world.say(('early', message.data)), qos)
        publisher.publish(String(data='old'))
        sleep(0.5)
        publisher.publish(String(data='young'))
        sleep(0.5)
        node.create_subscription(String, 't', lambda message: world.say(('late', message.data)), qos)
        for _ in range(5):
            rclpy.spin_once(node, timeout_sec=0)

    assert world.run_program(program) == [('early', 'young'), ('late', 'young')]


def test_the_policy_of_an_event_is_an_enum_and_handlers_are_there_from_the_start(world: World) -> None:
    from rclpy.qos import QoSPolicyKind

    def program() -> None:
        rclpy.init()
        node, seen = Node('n'), []
        callbacks = SubscriptionEventCallbacks(incompatible_qos=seen.append)
        everything = dict.fromkeys(('deadline', 'liveliness', 'incompatible_qos', 'matched'), print)
        quiet = PublisherEventCallbacks(use_default_callbacks=False)
        publishers = [
            node.create_publisher(String, 't', 1, event_callbacks=given)
            for given in (None, quiet, PublisherEventCallbacks(**everything))
        ]
        qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        heard = node.create_subscription(String, 't', print, qos, event_callbacks=callbacks)
        spin(node, 0.1)
        world.say([len(publisher.event_handlers) for publisher in publishers])
        kind = seen[0].last_policy_kind
        world.say((len(heard.event_handlers), kind == QoSPolicyKind.DURABILITY, str(kind)))

    assert world.run_program(program) == [[2, 0, 5], (2, True, 'rmw_qos_policy_kind_t.RMW_QOS_POLICY_DURABILITY')]
