"""Being told of parameters that change."""

from __future__ import annotations

import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler

from .conftest import Ros, World, raised, results


def test_an_event_handler_hears_of_other_nodes(world: World) -> None:
    def owner() -> None:
        rclpy.init()
        node = Node('owner')
        node.declare_parameter('p', 1)
        node.create_timer(0.5, lambda: results(node, 2))
        rclpy.spin(node)

    def program() -> None:
        rclpy.init()
        node = Node('n')
        handler = ParameterEventHandler(node)
        handler.add_parameter_callback('p', 'owner', lambda parameter: world.say(parameter_value_to_python(parameter.value)))
        rclpy.spin(node)

    world.start(owner, name='owner')
    world.start(program)
    assert world.run(0.6) == [(500.0, 'main', 2)]


def test_a_client_is_told_of_parameter_events(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        AsyncParameterClient(node, 'n').on_parameter_event(lambda event: world.say([p.name for p in event.new_parameters]))
        node.declare_parameter('p', 1)
        rclpy.spin_once(node, timeout_sec=1.0)

    assert ros(body) == [['p']]


def test_callbacks_of_one_parameter_stay_together(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.declare_parameters('', [('p', 1), ('q', 1)])
        handler = ParameterEventHandler(node)
        for name, word in (('p', 'first'), ('q', 'other'), ('p', 'second')):
            handle = handler.add_parameter_callback(name, 'n', lambda parameter, word=word: world.say(word))
        node.set_parameters_atomically([Parameter('p', value=2), Parameter('q', value=2)])
        rclpy.spin_once(node, timeout_sec=1.0)
        handler.remove_parameter_callback(handle=handle)
        world.say(raised(handler.remove_parameter_callback, handle))

    assert ros(body) == ['second', 'first', 'other', "RuntimeError: Callback doesn't exist"]
