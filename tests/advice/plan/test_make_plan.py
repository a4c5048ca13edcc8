"""The phases of a plan, and what it tells of errors."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch import Session
from edulaunch.advice.plan import rehearse
from edulaunch.engine.packages import Index
from edulaunch.errors import UnusableInput

HEAD = """
from launch import LaunchDescription
from launch.actions import *
from launch.actions import DeclareLaunchArgument, EmitEvent, ExecuteProcess, GroupAction, LogInfo
from launch.event_handlers import OnProcessExit, OnProcessStart, OnShutdown
from launch.substitutions import Command, LaunchConfiguration, LocalSubstitution
from launch_ros.actions import Node, SetParameter

def run(name, **arguments):
    return ExecuteProcess(cmd=[name], **arguments)

def generate_launch_description():
    return LaunchDescription(entities())

"""
Plan = Callable[..., dict[str, Any]]


@pytest.fixture
def plan(tmp_path: Path) -> Plan:
    """The plan of a launch file with this body of entities()."""

    def make(body: str, *arguments: str, **options: Any) -> dict[str, Any]:
        path = tmp_path / 'a.launch.py'
        path.write_text(HEAD + 'def entities():\n' + body, encoding='utf-8')
        return rehearse(path, arguments, Index(), {'HOME': '/h'}, **options).plan

    return make


def steps(plan: dict[str, Any]) -> list[tuple[str, float | None, str]]:
    """(phase, time, what) of logs and processes."""
    return [
        (item['phase'], item.get('time'), item.get('msg') or item['process_name'])
        for item in plan['items']
        if item['kind'] in ('log', 'process', 'node')
    ]


def test_reactions_stand_in_the_phase_of_their_event(plan: Plan) -> None:
    found = plan("""
    a, b = run('a'), Node(package='turtlesim', executable='turtlesim_node', name='b')
    return [
        RegisterEventHandler(OnProcessStart(target_action=a, on_start=[LogInfo(msg='a started'), run('c')])),
        RegisterEventHandler(OnProcessExit(target_action=b, on_exit=[LogInfo(msg='b ended')])),
        RegisterEventHandler(OnShutdown(on_shutdown=[
            LogInfo(msg=['end: ', LocalSubstitution('event.reason')])])),
        TimerAction(period=2.5, actions=[run('d')]), b, a]
""")
    assert steps(found) == [
        ('launch', None, 'turtlesim_node'),
        ('launch', None, 'a'),
        ('on_start', None, 'a started'),
        ('on_start', None, 'c'),
        ('timer', 2.5, 'd'),
        ('on_exit', None, 'b ended'),
        ('on_shutdown', None, 'end: idle'),
    ]
    assert found['shutdown_reason'] == 'idle'


def test_plain_commands_end_before_nodes_each_in_the_order_they_started(plan: Plan) -> None:
    found = plan("""
    def node(name):
        return Node(package='turtlesim', executable='turtlesim_node', name=name, on_exit=[LogInfo(msg=name)])
    def command(name):
        return run(name, on_exit=[LogInfo(msg=name)])
    return [node('n1'), command('p1'), node('n2'), command('p2')]
""")
    assert [what for phase, _, what in steps(found) if phase == 'on_exit'] == ['p1', 'p2', 'n1', 'n2']


def test_a_required_process_ends_the_plan_with_its_reason(plan: Plan) -> None:
    found = plan("    return [run('a', on_exit=Shutdown(reason='a is gone')), TimerAction(period=9.0, actions=[run('late')])]")
    assert found['shutdown_reason'] == 'a is gone'
    assert [what for _, _, what in steps(found)] == ['a', 'late']


def test_a_respawning_process_does_not_keep_the_plan_alive(plan: Plan) -> None:
    found = plan("    return [run('a', respawn=True, respawn_delay=1.0)]")
    (item,) = [item for item in found['items'] if item['kind'] == 'process']
    assert (item['respawn'], item['respawn_delay']) == (True, 1.0)
    assert found['shutdown_reason'] == 'idle'


def test_nothing_is_started_and_nothing_is_printed(plan: Plan, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    found = plan(f"    print('hello')\n    return [ExecuteProcess(cmd=['touch', '{tmp_path}/made'])]")
    assert not (tmp_path / 'made').exists()
    assert capfd.readouterr() == ('', '')
    assert found['stdout'] == 'hello\n' * found['stdout'].count('hello')


def test_no_folder_of_logs_is_made(tmp_path: Path) -> None:
    launch_file = tmp_path / 'a.launch.py'
    launch_file.write_text(HEAD + "def entities():\n    return [LogInfo(msg='a'), run('b', output='both')]", encoding='utf-8')
    environ = {'ROS_HOME': str(tmp_path / 'home'), 'ROS_LOG_DIR': str(tmp_path / 'logs')}
    assert len(rehearse(launch_file, [], Index(), environ).plan['items']) == 3
    assert [path.name for path in tmp_path.iterdir()] == ['a.launch.py']


def test_values_and_changes_are_noted(plan: Plan) -> None:
    found = plan(
        """
    return [DeclareLaunchArgument('x', default_value='1', description='an x'),
            SetEnvironmentVariable('E', LaunchConfiguration('x')),
            GroupAction([SetLaunchConfiguration('y', '2'), run('a', additional_env={'F': 'f'})]),
            SetParameter('p', 1)]
""",
        'x:=5',
    )
    assert found['given'] == {'x': '5'}
    assert found['configurations'] == {'x': '5', 'global_params': [['p', 1]]}
    assert found['arguments'] == [{'choices': None, 'conditional': False, 'default': "'1'", 'description': 'an x', 'name': 'x'}]
    assert [item for item in found['items'] if item['kind'] in ('set_env', 'set_parameter')] == [
        {'kind': 'set_env', 'name': 'E', 'phase': 'launch', 'value': '5'},
        {'kind': 'set_parameter', 'name': 'p', 'phase': 'launch', 'value': 1},
    ]
    assert [item['env_changes'] for item in found['items'] if item['kind'] == 'process'] == [{'E': '5', 'F': 'f'}]


def test_an_error_has_its_type_text_place_and_help(plan: Plan, tmp_path: Path) -> None:
    found = plan("    return [LogInfo(msg='before'),\n      Node(package='turtelsim', executable='x')]\n")
    error = found['error']
    assert (error['type'], error['stage'], error['help']) == (
        'PackageNotFoundError',
        'visit',
        'the package turtelsim does not exist; write turtlesim if you mean that package',
    )
    assert error['origin'] == f'{tmp_path}/a.launch.py:{HEAD.count(chr(10)) + 3}'
    assert [what for _, _, what in steps(found)] == ['before']


def test_with_assumed_packages_nothing_is_missing_and_no_executable_is_looked_up(plan: Plan) -> None:
    found = plan(
        "    return [Node(package='nowhere', executable='x'), Node(package='turtlesim', executable='y')]", assume_packages=True
    )
    assert found['error'] is None
    assert [item['cmd'][0].rsplit('/', 3)[1:] for item in found['items'] if item['kind'] == 'node'] == [
        ['lib', 'nowhere', 'x'],
        ['lib', 'turtlesim', 'y'],
    ]


def test_the_parameters_are_what_the_node_would_get(plan: Plan, tmp_path: Path) -> None:
    (tmp_path / 'p.yaml').write_text(
        '/**:\n  ros__parameters: {a: 1, b: 1}\n/s/n:\n  ros__parameters: {b: 2}\n', encoding='utf-8'
    )
    found = plan(f"""
    return [Node(package='turtlesim', executable='turtlesim_node', name='n', namespace='s',
                 parameters=['{tmp_path}/p.yaml', {{'a': 3, 'c': [1, 2]}}])]
""")
    (item,) = [item for item in found['items'] if item['kind'] == 'node']
    assert item['parameters'] == {'a': 3, 'b': 2, 'c': [1, 2]}
    assert (item['runtime_name'], item['namespace'], item['fully_qualified_name']) == ('/s/n', '/s', '/s/n')


@pytest.mark.parametrize('text', ['mode=zz', ':=x', 'x:='])
def test_malformed_arguments_are_refused_as_by_ros2_launch(plan: Plan, text: str) -> None:
    with pytest.raises(UnusableInput) as caught:
        plan('    return []', text)
    assert str(caught.value) == f"malformed launch argument '{text}', expected format '<name>:=<value>'"


def test_a_plan_repeats_byte_for_byte(plan: Plan) -> None:
    body = "    return [Node(package='turtlesim', executable='turtlesim_node', parameters=[{'a': 1}, {'a': 1}])]"
    assert repr(plan(body)) == repr(plan(body))


def test_an_event_of_one_process_is_no_question_to_the_others(plan: Plan, monkeypatch: pytest.MonkeyPatch) -> None:
    from launch.actions._process_watch import ProcessWatch

    asked: list[str] = []
    concerns = ProcessWatch._concerns
    monkeypatch.setattr(ProcessWatch, '_concerns', lambda self, event: asked.append(event.name) or concerns(self, event))
    plan('    return [run(str(number)) for number in range(40)]\n')
    assert asked.count('launch.events.process.ProcessStarted') <= 2 * 40
    assert asked.count('launch.events.process.ProcessExited') <= 2 * 40


@pytest.mark.parametrize(
    ('body', 'after'),
    [
        (
            '    def again(context):\n        return [TimerAction(period=1.0, actions=[OpaqueFunction(function=again)])]\n'
            '    return [OpaqueFunction(function=again)]',
            '101',
        ),
        (
            '    async def wait(context):\n        import asyncio\n        while True:\n            await asyncio.sleep(0.5)\n'
            '    return [OpaqueCoroutine(coroutine=wait)]',
            '50.5',
        ),
    ],
)
def test_what_goes_on_without_end_is_an_error_with_its_place(
    plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, body: str, after: str
) -> None:
    monkeypatch.setattr('edulaunch.advice.plan.rehearsal.MOST_INSTANTS', 100)
    error = plan(body)['error']
    assert error['text'] == f'the launch file goes on without end: after {after} simulated seconds it still does something'
    assert error['origin'].startswith(f'{tmp_path}/a.launch.py:')
    assert 'give an end to a handler whose own actions cause its event' in error['help']


def test_a_handler_of_its_own_events_is_silenced_and_named(plan: Plan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edulaunch.advice.plan.watching.MOST_REACTIONS', 50)
    found = plan(
        '    from launch import EventHandler\n'
        "    every = EventHandler(matcher=lambda event: True, entities=[LogInfo(msg='again')])\n"
        "    return [RegisterEventHandler(every), run('a'), TimerAction(period=1.0, actions=[])]"
    )
    assert 40 < sum(item['kind'] == 'log' for item in found['items']) <= 51
    assert found['error']['text'].startswith('the launch file goes on without end')
    assert found['error']['help'].startswith(
        f'{found["error"]["origin"]} (LogInfo): give an end to a handler whose own actions cause its event'
    )


@pytest.mark.parametrize(
    'body',
    [
        "    return [Node(package='gazebo_ros', executable='spawn_entity.py')]\n",
        "    from launch_ros.substitutions import FindPackageShare\n    return [LogInfo(msg=FindPackageShare('gazebo_ros'))]\n",
    ],
)
def test_a_plan_does_not_go_on_without_well_known_packages_as_a_launch_does(plan: Plan, body: str) -> None:
    error = plan(body)['error']
    assert error['text'].startswith("\"package 'gazebo_ros' not found, searching: ")
    assert (
        error['help'] == 'the package gazebo_ros (Gazebo) is not part of edulaunch; leave it out here, or add a condition to it'
    )


def test_what_a_respawned_process_does_again_is_not_told_again(plan: Plan) -> None:
    found = plan("""
    again = [RegisterEventHandler(OnProcessStart(on_start=[LogInfo(msg='started')])),
             RegisterEventHandler(OnProcessExit(on_exit=[LogInfo(msg='ended')]))]
    return [run('a', respawn=True, respawn_delay=1.0), run('b', respawn=True), *again]""")
    assert steps(found) == [
        ('launch', None, 'a'),
        ('launch', None, 'b'),
        ('on_start', None, 'started'),
        ('on_start', None, 'started'),
        ('on_exit', None, 'ended'),
        ('on_exit', None, 'ended'),
    ]
    assert [item['kind'] for item in found['items'] if item['kind'] in ('timer', 'emit_event')] == []
    assert (found['log'], found['shutdown_reason']) == ([], 'idle')


def test_a_timer_with_which_launch_ends_a_process_is_not_the_files(plan: Plan) -> None:
    found = plan("    return [run('a'), TimerAction(period=2.0, actions=[Shutdown()]), run('b', respawn=True)]")
    assert [item['period'] for item in found['items'] if item['kind'] == 'timer'] == [2.0]


def test_ros_arguments_decide_over_name_and_namespace(plan: Plan, tmp_path: Path) -> None:
    (tmp_path / 'a.yaml').write_text('/x/n:\n  ros__parameters: {speed: 2}\n/n:\n  ros__parameters: {speed: 1}\n')
    node = "Node(package='turtlesim', executable='turtlesim_node', parameters=[{!r}], {})"
    cases = {
        "ros_arguments=['-r', '__ns:=/x'], name='n'": ('n', '/x', '/x/n', {'speed': 2}),
        "arguments=['--ros-args', '-r', '__node:=n'], name='other'": ('n', None, '/n', {'speed': 1}),
        "namespace='x', name='n'": ('n', '/x', '/x/n', {'speed': 2}),
        "namespace='x'": (None, '/x', None, {}),
    }
    for arguments, expected in cases.items():
        (item,) = [
            item
            for item in plan(f'    return [{node.format(str(tmp_path / "a.yaml"), arguments)}]')['items']
            if item['kind'] == 'node'
        ]
        assert (item['name'], item['namespace'], item['runtime_name'], item['parameters']) == expected


def test_actions_that_a_function_adds_to_its_own_description_are_planned(plan: Plan) -> None:
    found = plan("""
    description = []
    def more(context):
        described.add_action(LogInfo(msg='added'))
    described = LaunchDescription([OpaqueFunction(function=more)])
    return [described, LogInfo(msg='last')]""")
    assert [what for _, _, what in steps(found)] == ['added', 'last']


def test_commands_of_ros2_answer_and_programs_that_a_file_starts_itself_end_at_once(plan: Plan) -> None:
    command_set = Session(env={}).host.command_set
    found = plan(
        """
    import subprocess
    code = subprocess.Popen(['sleep', '60']).wait()
    prefix = subprocess.check_output(['ros2', 'pkg', 'prefix', 'turtlesim'], text=True).strip()
    return [LogInfo(msg=[str(code), ' ', prefix.rpartition('/')[2], ' ', Command('ros2 pkg prefix turtlesim')])]""",
        command_set=command_set,
    )
    assert found['error'] is None
    (said,) = [item['msg'] for item in found['items'] if item['kind'] == 'log']
    assert (said.startswith('0 ros /'), said.endswith('/ros\n')) == (True, True)


def test_a_composable_node_may_have_parameters_of_an_assumed_package(plan: Plan) -> None:
    found = plan(
        """
    from launch_ros.actions import LoadComposableNodes
    from launch_ros.descriptions import ComposableNode
    from ament_index_python.packages import get_package_share_directory as share
    return [LoadComposableNodes(target_container='/c', composable_node_descriptions=[
        ComposableNode(package='nowhere', plugin='n::A', name='a', parameters=[share('nowhere') + '/a.yaml', {'x': 1}])])]
""",
        assume_packages=True,
    )
    assert found['error'] is None
