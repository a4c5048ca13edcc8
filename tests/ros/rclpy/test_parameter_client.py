"""rclpy.parameter_client, and the services of a node that it asks."""

from __future__ import annotations

from typing import Any

import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.parameter_client import AsyncParameterClient

from .conftest import Ros, World


def test_other_programs_read_and_change_parameters(world: World) -> None:
    def owner() -> None:
        rclpy.init()
        node = Node('owner')
        node.declare_parameter('p', 1)
        rclpy.spin(node)

    def program() -> None:
        rclpy.init()
        node = Node('n')
        client = AsyncParameterClient(node, 'owner')
        client.wait_for_services()

        def ask(future: Any) -> Any:
            rclpy.spin_until_future_complete(node, future)
            return future.result()

        world.say([one.reason for one in ask(client.set_parameters([Parameter('p', value=2), Parameter('q', value=1)])).results])
        world.say([parameter_value_to_python(value) for value in ask(client.get_parameters(['p'])).values])
        world.say((ask(client.get_parameters(['p', 'q'])).values, list(ask(client.get_parameter_types(['p'])).types)))
        world.say(ask(client.list_parameters()).result.names)
        world.say(ask(client.describe_parameters(['p'])).descriptors[0].type)

    world.start(owner, name='owner')
    world.start(program)
    assert [what for _, _, what in world.run(1)] == [
        ['', 'Invalid access to undeclared parameter(s): []'],
        [2],
        ([], [2]),
        ['use_sim_time', 'start_type_description_service', 'p'],
        2,
    ]


def test_services_can_be_left_out(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', start_parameter_services=False)
        world.say([name for name, _ in node.get_service_names_and_types()])

    assert ros(body) == [['/n/get_type_description']]


def test_a_file_is_loaded_whatever_nodes_it_is_for(world: World, tmp_path: Any) -> None:
    from rclpy.parameter_client import AsyncParameterClient

    file = tmp_path / 'p.yaml'
    file.write_text('/one:\n  ros__parameters: {a: 1}\n/two:\n  ros__parameters: {b: 2}\n/**:\n  ros__parameters: {all: 3}\n')

    def program() -> None:
        rclpy.init()
        node = Node('n', allow_undeclared_parameters=True)
        client = AsyncParameterClient(node, 'n')
        for wildcard in (False, True):
            rclpy.spin_until_future_complete(node, client.load_parameter_file(str(file), wildcard))
            world.say([node.has_parameter(name) for name in ('a', 'b', 'all')])

    assert world.run_program(program) == [[True, True, False], [True, True, True]]
