"""A student's own attributes and methods on a node never collide with the node's own state."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Empty

from .conftest import Ros, World

PLAUSIBLE = (
    'clock',
    'logger',
    'name',
    'namespace',
    'node',
    'count',
    'counter',
    'timer',
    'rate',
    'pub',
    'sub',
    'publisher',
    'subscription',
    'client',
    'service',
    'server',
    'parameters',
    'params',
    'state',
    'status',
    'goal',
    'goal_handle',
    'future',
    'result',
    'request',
    'response',
    'callback',
    'callback_group',
    'group',
    'lock',
    'thread',
    'queue',
    'spin',
    'run',
    'stop',
    'start',
    'update',
    'reset',
    'pose',
    'msg',
    'data',
    'id',
    'type',
    'running',
    'done',
    'shutdown',
    'init',
    'args',
    'time_source',
    'graph',
    'core',
    'entry',
    'rates',
    'tasks',
    'entities',
    'number',
    'destroyed',
    'process',
    'rules',
    'overrides',
    'descriptors',
    'names',
    'topic_name',
    'qos',
    'rosout',
    'life',
    'entity',
    'order',
    'impl',
    'sim',
    'resolve',
    'full_name',
    'ready_list',
)
REAL_PROPERTIES = (
    'publishers',
    'subscriptions',
    'clients',
    'services',
    'timers',
    'guards',
    'waitables',
    'context',
    'default_callback_group',
)


class Crowded(Node):
    """Everything that comes to mind is an attribute, with and without underscores, from before super().__init__ on."""

    def __init__(self, world: World) -> None:
        self._crowd(before=True)
        super().__init__('crowded')
        self._crowd(before=False)
        self.create_subscription(String, 'chatter', lambda message: world.say(message.data), 10)
        self.create_service(Empty, 'nothing', lambda request, response: response)
        self.create_client(Empty, 'nothing').call_async(Empty.Request()).add_done_callback(lambda _: world.say('answered'))
        self.create_publisher(String, 'chatter', 10).publish(String(data='heard'))
        self.create_timer(0.1, lambda: world.say('tick'))

    def _crowd(self, before: bool) -> None:
        for name in PLAUSIBLE:
            for spelling in (name, f'_{name}', f'{name}_', f'_{name}s'):
                if spelling not in REAL_PROPERTIES:
                    setattr(self, spelling, before)


def test_any_attribute_may_be_set(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Crowded(world)
        node.declare_parameter('p', 1)
        ActionServer(node, Fibonacci, 'fibonacci', lambda goal: Fibonacci.Result())
        ActionClient(node, Fibonacci, 'fibonacci').send_goal_async(Fibonacci.Goal())
        world.say((node.get_parameter('p').value, node.count_publishers('chatter'), node.get_name(), node.has_parameter('q')))
        for _ in range(20):
            rclpy.spin_once(node, timeout_sec=0.05)
        node.destroy_node()

    assert ros(body) == [(1, 1, 'crowded', False), 'heard', 'answered', *['tick'] * (len(world.log) - 3)]
    assert len(world.log) > 3


@pytest.mark.parametrize('base', [Node, LifecycleNode])
def test_the_only_private_name_is_rclpys_own(ros: Ros, world: World, base: Any) -> None:
    def body() -> None:
        node = base('node')
        node.get_logger().info('x')
        names = {name for kind in base.__mro__ if kind is not object for name in vars(kind)} | set(vars(node))
        world.say(sorted(name for name in names if name.startswith('_') and not name.startswith('__')))

    assert ros(body) == [['_rclpy']]


@pytest.mark.parametrize('name', REAL_PROPERTIES)
def test_what_is_a_property_in_ros_cannot_be_set(ros: Ros, world: World, name: str) -> None:
    def body() -> None:
        node = Node('node')
        with pytest.raises(AttributeError, match=name):
            setattr(node, name, [])
        world.say('refused')

    assert ros(body) == ['refused']


def test_errors_about_arguments_name_the_node_class(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError, match=r"^Node.create_publisher\(\) missing 1 required positional argument: 'qos_profile'"):
            Node('node').create_publisher(String, 'topic')  # type: ignore[call-arg]
        world.say('named')

    assert ros(body) == ['named']


def test_what_rclpy_keeps_under_private_names_can_be_read(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameter('p', 5)
        world.say(
            (
                node._logger is node.get_logger(),
                node._clock is node.get_clock(),
                node._parameters['p'].value,
                node._default_callback_group is node.default_callback_group,
                hasattr(node, '_nothing'),
            )
        )
        node._clock = 'my own'
        world.say(node.get_clock() is not node._clock)

    assert ros(body) == [(True, True, 5, True, False), True]
