"""One name, one type: what Fast DDS asks of one program."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from rclpy._rclpy_pybind11 import RCLError
from rclpy.node import Node
from std_msgs.msg import Int32, String
from std_srvs.srv import SetBool, Trigger

from edulaunch.engine.facts import facts_of

from .conftest import Ros, World


@pytest.mark.parametrize(
    ('make', 'text'),
    [
        (
            lambda node: node.create_publisher(Int32, 'a', 1),
            'Failed to create publisher: create_publisher() called for existing topic name rt/a with incompatible type '
            'std_msgs::msg::dds_::Int32_',
        ),
        (lambda node: node.create_subscription(Int32, 'a', print, 1), 'Failed to create subscription: invalid allocator'),
        (
            lambda node: node.create_service(SetBool, 's', print),
            'failed to create service: create_service() called for existing request topic name rq/sRequest with incompatible type '
            'std_srvs::srv::dds_::SetBool_Request_',
        ),
        (
            lambda node: node.create_client(SetBool, 's'),
            'failed to create client: create_client() called for existing request topic name rq/sRequest with incompatible type '
            'std_srvs::srv::dds_::SetBool_Request_',
        ),
    ],
)
def test_a_second_type_of_one_name_is_refused(ros: Ros, world: World, make: Callable[[Node], Any], text: str) -> None:
    def body() -> None:
        one, other = Node('one'), Node('other')
        one.create_publisher(String, 'a', 1)
        one.create_client(Trigger, 's')
        with pytest.raises(RCLError) as refused:
            make(other)
        world.say((str(refused.value), facts_of(refused.value)['node']))

    assert ros(body) == [(text, '/one')]


def test_a_name_is_free_again_when_its_last_endpoint_is_gone(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.destroy_publisher(node.create_publisher(String, 'a', 1))
        world.say(node.create_publisher(Int32, 'a', 1).topic_name)

    assert ros(body) == ['/a']


def test_another_context_is_another_participant(ros: Ros, world: World) -> None:
    def body() -> None:
        context = rclpy.Context()
        rclpy.init(context=context)
        Node('n').create_publisher(String, 'a', 1)
        world.say(Node('m', context=context).create_publisher(Int32, 'a', 1).topic_name)

    assert ros(body) == ['/a']


@pytest.mark.parametrize(
    ('make', 'text'),
    [
        (lambda node: node.create_publisher(String, 'a', 1), 'Failed to create publisher'),
        (lambda node: node.create_subscription(String, 'a', print, 1), 'Failed to create subscription'),
        (lambda node: node.create_service(Trigger, 's', print), 'failed to create service'),
        (lambda node: node.create_client(Trigger, 's'), 'failed to create client'),
    ],
)
def test_nothing_is_made_after_shutdown(ros: Ros, world: World, make: Callable[[Node], Any], text: str) -> None:
    def body() -> None:
        node = Node('n')
        rclpy.shutdown()
        with pytest.raises(RCLError, match=f"^{text}: rcl node's context is invalid$"):
            make(node)
        world.say('refused')

    assert ros(body) == ['refused']


def test_endpoints_answer_neither_after_shutdown_nor_after_their_end(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        publisher, client = node.create_publisher(String, 'a', 1), node.create_client(Trigger, 's')
        gone = node.create_subscription(String, 'a', print, 1)
        node.destroy_subscription(gone)
        with pytest.raises(rclpy._rclpy_pybind11.InvalidHandle, match='cannot use Destroyable because destruction was requested'):
            gone.topic_name  # noqa: B018
        rclpy.shutdown()
        for ask, text in (
            (publisher.get_subscription_count, "failed to get subscription count: publisher's"),
            (client.wait_for_service, "failed to check service availability: rcl node's"),
        ):
            with pytest.raises(RCLError, match=f'^{text} context is invalid$'):
                ask()
        world.say((publisher.topic_name, client.service_name))

    assert ros(body) == [('/a', '/s')]


def test_timers_are_not_made_after_shutdown(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        rclpy.shutdown()
        with pytest.raises(RCLError, match='^failed to create timer: the given context is not valid, either rcl_init'):
            node.create_timer(1.0, print)
        world.say('refused')

    assert ros(body) == ['refused']
