"""Actions that talk to running nodes: composition, life cycle, timers on ROS time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from edulaunch.runtime.session import Session

LISTS = """
project(robo)
install(PROGRAMS container.py managed.py DESTINATION lib/robo)
install(DIRECTORY launch DESTINATION share/robo)
"""
CONTAINER = """
import rclpy
from composition_interfaces.srv import LoadNode
rclpy.init()
node = rclpy.create_node('c')

def load(request, response):
    values = [(parameter.name, parameter.value.integer_value) for parameter in request.parameters]
    print(request.plugin_name, request.node_namespace, request.remap_rules, values)
    response.success = request.plugin_name != 'bad::One'
    response.error_message = '' if response.success else 'no such plugin'
    response.full_node_name = f'{request.node_namespace}/{request.node_name}'
    return response

node.create_service(LoadNode, '~/_container/load_node', load)
rclpy.spin(node)
"""
MANAGED = """
import rclpy
from lifecycle_msgs.msg import TransitionEvent
from lifecycle_msgs.srv import ChangeState
rclpy.init()
node = rclpy.create_node('m')
publisher = node.create_publisher(TransitionEvent, '~/transition_event', 10)
STEPS = {1: ('configuring', 'inactive'), 3: ('activating', 'active')}

def change(request, response):
    print('transition', request.transition.id)
    event = TransitionEvent()
    event.start_state.label, event.goal_state.label = STEPS[request.transition.id]
    publisher.publish(event)
    response.success = True
    return response

node.create_service(ChangeState, '~/change_state', change)
rclpy.spin(node)
"""
HEAD = """
from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler, Shutdown, TimerAction
from launch_ros.actions import *
from launch_ros.descriptions import ComposableNode
from launch_ros.event_handlers import OnStateTransition

def generate_launch_description():
    return LaunchDescription(entities())
"""

Lines = Callable[[str], list[tuple[float, str]]]


@pytest.fixture
def lines(tmp_path: Path) -> Lines:
    """Runs a launch file with the body of entities(), and gives (seconds, line) of its console."""
    for name, text in (
        ('CMakeLists.txt', LISTS),
        ('package.xml', '<package><name>robo</name></package>'),
        ('container.py', CONTAINER),
        ('managed.py', MANAGED),
    ):
        (tmp_path / name).write_text(text, encoding='utf-8')
    (tmp_path / 'launch').mkdir()

    def run(body: str) -> list[tuple[float, str]]:
        (tmp_path / 'launch/a.launch.py').write_text(HEAD + 'def entities():\n' + body, encoding='utf-8')
        found: list[tuple[float, str]] = []
        sessions: list[Session] = []

        def console(stream: str, text: str) -> None:
            found.extend((sessions[0].sim.elapsed_s, line) for line in text.splitlines())

        with Session(workspaces=[tmp_path], env={}, console=console) as session:
            sessions.append(session)
            session.launch('robo', 'a.launch.py')
            session.run(8.0)
        noise = (
            'process started',
            'Default logging',
            'Traceback',
            'File',
            'rclpy.spin',
            'KeyboardInterrupt',
            'has died',
            'SIGINT',
        )
        return [line for line in found if not any(word in line[1] for word in noise)]

    return run


def test_a_container_gets_its_nodes_one_after_another(lines: Lines) -> None:
    assert lines("""
    return [SetRemap('g', 'h'), ComposableNodeContainer(
        package='robo', executable='container.py', name='c', namespace='/ns', output='screen',
        composable_node_descriptions=[
            ComposableNode(package='p', plugin='a::B', name='n', namespace='x', parameters=[{'k': 7}],
                           remappings=[('a', 'b')]),
            ComposableNode(package='p', plugin='bad::One', name='m')]),
        TimerAction(period=5.0, actions=[Shutdown()])]
""") == [
        (0.0, "[container.py-1] a::B /x ['g:=h', 'a:=b'] [('k', 7)]"),
        (0.0, "[INFO] [launch_ros.actions.load_composable_nodes]: Loaded node '/x/n' in container '/ns/c'"),
        (0.0, "[container.py-1] bad::One  ['g:=h'] []"),
        (
            0.0,
            (
                "[ERROR] [launch_ros.actions.load_composable_nodes]: Failed to load node '/m' of type "
                "'bad::One' "
                "in container '/ns/c': no such plugin"
            ),
        ),
    ]


def test_waiting_for_a_container_that_never_comes_ends_with_launch(lines: Lines) -> None:
    assert lines("""
    return [LoadComposableNodes(target_container='/none', composable_node_descriptions=[
                ComposableNode(package='p', plugin='a::B', name='n')]),
            TimerAction(period=2.0, actions=[Shutdown()])]
""") == [
        (
            2.0,
            (
                '[WARNING] [launch_ros.actions.load_composable_nodes]: Abandoning wait for the '
                "'/none/_container/load_node' service, due to shutdown."
            ),
        )
    ]


def test_a_lifecycle_node_goes_through_its_transitions_in_order(lines: Lines) -> None:
    assert lines("""
    node = LifecycleNode(package='robo', executable='managed.py', name='m', namespace='', output='screen')
    return [
        node,
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=node, goal_state='active', entities=[LogInfo(msg='active'), Shutdown()])),
        LifecycleTransition(lifecycle_node_names=['/m'], transition_ids=[1, 3])]
""") == [(0.0, '[managed.py-1] transition 1'), (0.0, '[managed.py-1] transition 3'), (0.0, '[INFO] [launch.user]: active')]


def test_a_ros_timer_fires_once_on_ros_time(lines: Lines) -> None:
    assert lines("""
    return [ROSTimer(period=1.5, actions=[LogInfo(msg='now')])]
""") == [(1.5, '[INFO] [launch.user]: now')]
