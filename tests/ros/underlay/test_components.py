"""Containers: nodes that are loaded into a running process, listed and unloaded."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rcl_interfaces.msg import Parameter, ParameterValue

import edulaunch
from edulaunch.engine.packages import Index
from edulaunch.engine.underlay_place import underlay_prefix

LOAD, UNLOAD, LIST = (f'/ComponentManager/_container/{verb}' for verb in ('load_node', 'unload_node', 'list_nodes'))


def load(stage: Any, plugin: str, package: str = 'composition', **fields: Any) -> Any:
    reply = stage.ask(LOAD, LoadNode, package_name=package, plugin_name=plugin, **fields)
    stage.until((stage.sim.now_ns - stage.sim.start_ns) / 1e6 + 10)
    return reply[0]


@pytest.mark.parametrize(
    'container', ['component_container', 'component_container_mt', 'component_container_isolated', 'component_container_event']
)
def test_nodes_are_loaded_listed_and_unloaded(stage: Any, container: str) -> None:
    stage.start('rclcpp_components', container)
    stage.until(10)
    first, second = load(stage, 'composition::Talker'), load(stage, 'composition::Listener')
    assert (first.success, first.unique_id, first.full_node_name) == (True, 1, '/talker')
    assert (second.success, second.unique_id, second.full_node_name) == (True, 2, '/listener')
    stage.until(1100)
    assert stage.texts()[-2:] == ["Publishing: 'Hello World: 1'", 'I heard: [Hello World: 1]']
    listed = stage.ask(LIST, ListNodes)
    stage.until(1200)
    gone, unknown = stage.ask(UNLOAD, UnloadNode, unique_id=1), stage.ask(UNLOAD, UnloadNode, unique_id=7)
    stage.until(3500)
    assert (list(listed[0].unique_ids), list(listed[0].full_node_names)) == ([1, 2], ['/talker', '/listener'])
    assert gone[0].success
    assert (unknown[0].success, unknown[0].error_message) == (False, 'No node found with unique_id: 7')
    assert stage.texts()[-1] == 'No node found with unique_id: 7'  # and the talker is silent
    assert load(stage, 'composition::Talker').unique_id == 3


def test_a_component_gets_its_name_namespace_remappings_and_parameters(stage: Any) -> None:
    stage.start('rclcpp_components', 'component_container', '--ros-args', '-r', '__node:=box', '-r', 'chatter:=elsewhere')
    stage.until(10)
    value = Parameter(name='use_sim_time', value=ParameterValue(type=1, bool_value=False))
    fields = {'node_name': 'tom', 'node_namespace': '/zoo', 'remap_rules': ['chatter:=news'], 'parameters': [value]}
    reply = stage.ask(
        '/box/_container/load_node', LoadNode, package_name='composition', plugin_name='composition::Talker', **fields
    )
    stage.until(1100)
    assert reply[0].full_node_name == '/zoo/tom'
    assert [message.data for message in stage.messages('/zoo/news')] == ['Hello World: 1']


@pytest.mark.parametrize(
    ('package', 'plugin', 'message', 'help'),
    [
        (
            'nothing',
            'nothing::Node',
            'Could not find requested resource in ament index',
            "no components of a package 'nothing' are here",
        ),
        ('composition', 'composition::Taker', 'Failed to find class with the requested plugin name.', 'composition::Talker'),
    ],
)
def test_what_is_not_there_is_told_in_the_words_of_ros(stage: Any, package: str, plugin: str, message: str, help: str) -> None:
    stage.start('rclcpp_components', 'component_container')
    stage.until(10)
    reply = load(stage, plugin, package)
    assert (reply.success, reply.error_message) == (False, message)
    assert help in stage.texts()[-1]


def test_every_component_of_every_package_can_be_loaded(stage: Any) -> None:
    from rclcpp_components.component_container import components_of, packages_with_components

    stage.start('rclcpp_components', 'component_container')
    stage.until(10)
    names = [(package, name) for package in packages_with_components(Index()) for name in components_of(Index(), package)]
    failed = {name: reply.error_message for package, name in names if not (reply := load(stage, name, package)).success}
    text = 'Component constructor threw an exception: robot_description parameter must not be empty'
    assert len(names) >= 20 and failed == {'robot_state_publisher::RobotStatePublisher': text}


def test_a_component_publishes_the_static_transform_of_its_parameters(stage: Any) -> None:
    stage.start('rclcpp_components', 'component_container')
    stage.until(10)
    numbers = {'translation.z': 0.4, 'rotation.z': 1.0, 'rotation.w': 0.0}
    values = [Parameter(name=name, value=ParameterValue(type=3, double_value=value)) for name, value in numbers.items()]
    names = {'frame_id': 'base', 'child_frame_id': 'lamp'}
    values += [Parameter(name=name, value=ParameterValue(type=4, string_value=value)) for name, value in names.items()]
    plugin = {'package': 'tf2_ros', 'plugin': 'tf2_ros::StaticTransformBroadcasterNode'}
    assert load(stage, **plugin, node_name='lamp', parameters=values).full_node_name == '/lamp'
    (message,) = stage.messages('/tf_static')
    (sent,) = message.transforms
    assert (sent.header.frame_id, sent.child_frame_id) == ('base', 'lamp')
    assert (sent.transform.translation.z, sent.transform.rotation.z, sent.transform.rotation.w) == (0.4, 1.0, 0.0)
    same = [Parameter(name=name, value=ParameterValue(type=4, string_value='base')) for name in names]
    refused = load(stage, **plugin, parameters=same)
    assert 'child_frame_id cannot equal frame_id' in refused.error_message
    whole = [Parameter(name='translation.x', value=ParameterValue(type=2, integer_value=1))]
    assert 'invalid type' in load(stage, **plugin, parameters=whole).error_message


def test_a_launch_file_loads_its_components() -> None:
    recording = edulaunch.run('composition', 'composition_demo_launch.py', duration_s=2.5)
    said = ''.join(line.text for line in recording.output)
    assert "Loaded node '/talker' in container '/my_container'" in said and '[listener]: I heard: [Hello World: 2]' in said


@pytest.mark.parametrize(
    ('words', 'nodes'),
    [
        (['manual_composition'], ['talker', 'listener', 'Server', 'Client']),
        (['linktime_composition'], ['talker', 'listener', 'Server', 'Client']),
        (['dlopen_composition', '/x/lib/libserver_component.so', 'libclient_component.so'], ['Server', 'Client']),
    ],
)
def test_components_in_one_program_without_a_container(stage: Any, words: list[str], nodes: list[str]) -> None:
    stage.start('composition', *words)
    stage.until(2100)
    assert [node.name for node in stage.graph.nodes if node.name != 'hand'] == nodes
    assert stage.texts()[-1] == 'Got result: [5]'


def test_dlopen_composition_names_what_it_needs(stage: Any) -> None:
    process = stage.start('composition', 'dlopen_composition', 'libtalk.so')
    stage.until(10)
    assert process.returncode == 1 and 'libtalker_component.so' in stage.tape.outputs[0][1]


def test_a_clone_of_a_package_of_ros_has_the_built_in_components(tmp_path: Path) -> None:
    """As after `git clone https://github.com/ros2/demos` into a workspace."""
    clone = tmp_path / 'src' / 'demos' / 'composition'
    share = Path(underlay_prefix()) / 'share' / 'composition'
    shutil.copytree(share / 'launch', clone / 'launch')
    shutil.copy(share / 'package.xml', clone)
    (clone / 'CMakeLists.txt').write_text(
        'cmake_minimum_required(VERSION 3.5)\nproject(composition)\nfind_package(ament_cmake REQUIRED)\n'
        'add_library(talker_component SHARED src/talker_component.cpp)\n'
        'rclcpp_components_register_nodes(talker_component "composition::Talker")\n'
        'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package()\n'
    )
    recording = edulaunch.run('composition', 'composition_demo_launch.py', duration_s=2.5, workspaces=[tmp_path])
    assert [node.name for node in recording.nodes if node.name in ('/talker', '/listener')] == ['/talker', '/listener']
    assert recording.warnings == []


def test_a_clone_of_lifecycle_py_serves_the_built_in_program_of_lifecycle(tmp_path: Path) -> None:
    """The built-in lifecycle_talker takes its class from lifecycle_py, whose real one needs a name."""
    clone = tmp_path / 'src' / 'lifecycle_py'
    (clone / 'lifecycle_py').mkdir(parents=True)
    shutil.copy(Path(underlay_prefix()) / 'share' / 'lifecycle_py' / 'package.xml', clone)
    (clone / 'setup.py').write_text("from setuptools import setup\nsetup(name='lifecycle_py', packages=['lifecycle_py'])\n")
    (clone / 'lifecycle_py' / '__init__.py').touch()
    (clone / 'lifecycle_py' / 'talker.py').write_text(
        'from rclpy.lifecycle import Node\n\n\nclass LifecycleTalker(Node):\n    def __init__(self, node_name, **kwargs):\n'
        '        super().__init__(node_name, **kwargs)\n'
    )
    recording = edulaunch.run('lifecycle', 'lifecycle_demo_launch.py', duration_s=1.0, workspaces=[tmp_path])
    assert '/lc_talker' in [node.name for node in recording.nodes]
