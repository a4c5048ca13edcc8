"""`ros2 component ...` with a container that is an ordinary node."""

from __future__ import annotations

import pytest

CONTAINER = """
import rclpy
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode

rclpy.init()
node = rclpy.create_node('ComponentManager')
loaded = {}

def load(request, response):
    response.success = request.plugin_name == 'demo::Talker'
    response.error_message = '' if response.success else 'Failed to find class'
    if response.success:
        response.unique_id = len(loaded) + 1
        values = [parameter.value.double_value for parameter in request.parameters]
        response.full_node_name = '/'.join([request.node_namespace, request.node_name or 'talker', *map(str, values)])
        loaded[response.unique_id] = response.full_node_name
    return response

def unload(request, response):
    response.success = loaded.pop(request.unique_id, None) is not None
    response.error_message = '' if response.success else f'No node found with unique_id: {request.unique_id}'
    return response

def listed(request, response):
    response.unique_ids, response.full_node_names = list(loaded), list(loaded.values())
    return response

node.create_service(LoadNode, '~/_container/load_node', load)
node.create_service(UnloadNode, '~/_container/unload_node', unload)
node.create_service(ListNodes, '~/_container/list_nodes', listed)
rclpy.spin(node)
"""


@pytest.fixture
def container(machine):
    (machine.folder / 'container.py').write_text(CONTAINER)
    machine.run('python3 container.py')
    return machine


def test_components_are_loaded_listed_and_unloaded(container) -> None:
    assert container.read('ros2 component list') == '/ComponentManager\n'
    assert container.read('ros2 component load /ComponentManager demo demo::Talker') == (
        "Loaded component 1 into '/ComponentManager' container node as '/talker'\n"
    )
    words = '--node-name me --node-namespace /ns -p rate:=2.5 -r chatter:=talk -e use_intra_process_comms:=true --log-level debug'
    assert container.read(f'ros2 component load ComponentManager demo demo::Talker {words}').endswith(" as '/ns/me/2.5'\n")
    assert container.read('ros2 component list') == '/ComponentManager\n  1  /talker\n  2  /ns/me/2.5\n'
    assert container.read('ros2 component list /ComponentManager') == '  1  /talker\n  2  /ns/me/2.5\n'
    assert container.read('ros2 component unload /ComponentManager 1 2') == (
        "Unloaded component 1 from '/ComponentManager' container node\n"
        "Unloaded component 2 from '/ComponentManager' container node\n"
    )
    assert container.read('ros2 component list --containers-only') == '/ComponentManager\n'


def test_what_cannot_be_loaded_or_found(container) -> None:
    assert container.fails('ros2 component load /ComponentManager demo demo::Nix') == (
        'Failed to load component: failed to find class\n'
    )
    assert container.fails('ros2 component unload /ComponentManager 7') == (
        "Failed to unload component 7 from '/ComponentManager' container node\n    No node found with unique_id: 7\n"
    )
    assert container.fails('ros2 component list /ComponentManger') == (
        "Unable to find container node '/ComponentManger'\n  help: did you mean '/ComponentManager'?\n"
    )
    assert 'not a log level' in container.fails('ros2 component load /ComponentManager demo demo::Talker --log-level loud')


def test_types_are_listed_by_package(machine) -> None:
    listed = machine.read('ros2 component types')
    assert 'composition\n  composition::Talker\n' in listed and 'tf2_ros\n  tf2_ros::StaticTransformBroadcasterNode\n' in listed
    assert 'composition::Listener\n' in machine.read('ros2 component types composition')
    assert "did you mean 'composition'?" in machine.fails('ros2 component types compositon')
