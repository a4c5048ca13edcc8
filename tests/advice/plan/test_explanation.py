"""A launch file explained: the tree, and where every value comes from."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice.plan import rehearse
from edulaunch.advice.plan.explanation import Entry, explanation_of
from edulaunch.runtime.session import index_for

HEAD = """
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.parameter_descriptions import ParameterValue

def generate_launch_description():
"""


def flat(entries: list[Entry], depth: int = 0) -> list[str]:
    return [text for entry in entries for text in ('  ' * depth + entry['text'], *flat(entry['children'], depth + 1))]


@pytest.fixture
def told(tmp_path: Path):
    def tell(body: str, *, given: dict[str, str] | None = None) -> list[str]:
        path = tmp_path / 'my.launch.py'
        path.write_text(HEAD + body)
        return flat(explanation_of(rehearse(path, given or {}, index_for([]), {}))['tree'])

    return tell


def test_a_condition_is_shown_with_its_outcome(told) -> None:
    text = """
    return LaunchDescription([DeclareLaunchArgument('gui', default_value='false'),
        LogInfo(msg='yes', condition=IfCondition(LaunchConfiguration('gui'))),
        LogInfo(msg='no', condition=UnlessCondition(LaunchConfiguration('gui')))])"""
    assert told(text) == [
        "argument gui = 'false'  (default)",
        "LogInfo 'yes'  [if LaunchConfig('gui'): not taken]",
        "log 'no'  [unless LaunchConfig('gui'): taken]",
    ]
    assert told(text, given={'gui': 'true'})[1] == "log 'yes'  [if LaunchConfig('gui'): taken]"


def test_what_is_left_out_is_left_out_with_all_below(told) -> None:
    assert told("""
    return LaunchDescription([GroupAction([LogInfo(msg='a')], condition=IfCondition('false'))])
    """) == ["group  [if 'false': not taken]"]


def test_a_group_holds_its_actions_but_not_how_it_is_done(told) -> None:
    assert told("""
    return LaunchDescription([GroupAction([PushRosNamespace('robot'), LogInfo(msg='a')])])
    """) == ['group', '  namespace /robot', "  log 'a'"]


def test_a_parameter_comes_with_its_origin(told, tmp_path: Path) -> None:
    (tmp_path / 'p.yaml').write_text('/**:\n  ros__parameters:\n    background_g: 1\n')
    assert told(f"""
    return LaunchDescription([SetParameter('background_r', 2), Node(package='turtlesim', executable='turtlesim_node', name='sim',
        parameters=[{str(tmp_path / 'p.yaml')!r}, {{'background_b': 3}}])])""") == [
        'parameter background_r = 2 for all nodes that follow',
        'node /sim: turtlesim turtlesim_node',
        '  parameter background_b = 3  (my.launch.py line 13)',
        '  parameter background_g = 1  (p.yaml line 3)',
        '  parameter background_r = 2  (SetParameter in my.launch.py line 12)',
    ]


def test_an_event_holds_what_it_leads_to_and_a_silent_handler_says_so(told) -> None:
    assert told("""
    first = ExecuteProcess(cmd=['sleep', '1'], name='first')
    return LaunchDescription([first,
        RegisterEventHandler(OnProcessStart(target_action=first, on_start=[LogInfo(msg='up')])),
        RegisterEventHandler(OnProcessIO(target_action=first, on_stdout=lambda event: None))])""") == [
        'process first: sleep 1',
        'event handler OnProcessStart',
        '  when first-1 has started',
        "    log 'up'",
        'event handler OnProcessIO',
        '  never happened here',
    ]


def test_where_launch_stopped_is_marked(told) -> None:
    assert told("""
    return LaunchDescription([LogInfo(msg='a'), Node(package='nothing', executable='talker'), LogInfo(msg='b')])
    """) == ["log 'a'", 'Node talker  [launch stopped here]']


def test_what_a_timer_leads_to_stands_below_that_very_timer(told) -> None:
    assert told("""
    return LaunchDescription([TimerAction(period=after, actions=[LogInfo(msg=f'{after}')]) for after in (2.0, 1.0)])
    """) == ['timer after 2 s', "  log '2.0'", 'timer after 1 s', "  log '1.0'"]


LIFECYCLES = """
    from launch.events import matches_action
    from launch_ros.event_handlers import OnStateTransition
    from launch_ros.events.lifecycle import ChangeState
    node = LifecycleNode(package='turtlesim', executable='turtlesim_node', name='n', namespace='')
    def change(number):
        return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=number))
    def when(state, *entities):
        return RegisterEventHandler(OnStateTransition(target_lifecycle_node=node, goal_state=state, entities=list(entities)))
    return LaunchDescription([when('inactive', LogInfo(msg='ready'), change(3)), when('active', LogInfo(msg='works')), node, change({})])
"""


def test_a_lifecycle_node_makes_the_transitions_that_it_is_asked_for(told) -> None:
    lines = told(LIFECYCLES.format(1).replace('{}', ''))
    assert [line.strip() for line in lines if line.strip().startswith('log')] == ["log 'ready'", "log 'works'"]


def test_a_transition_that_does_not_begin_in_the_node_s_state_is_not_made(told) -> None:
    lines = told(LIFECYCLES.format(3))
    assert [line.strip() for line in lines if 'never' in line] == ['never happened here'] * 2


def test_a_node_without_a_name_shows_its_namespace(told) -> None:
    assert told("""
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', namespace='left', output='log')])
    """) == ["node /left/(the program's own name): turtlesim turtlesim_node"]


def test_a_parameter_of_a_file_shows_its_line_when_the_node_has_only_a_namespace(told, tmp_path: Path) -> None:
    (tmp_path / 'far.yaml').write_text('/left/**:\n  ros__parameters:\n    speed: 2\n')
    assert told(f"""
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', namespace='left', output='log',
                                   parameters=[{str(tmp_path / 'far.yaml')!r}])])
    """)[1:] == ['  parameter speed = 2  (far.yaml line 3)']


def test_a_limit_of_new_starts_is_shown(told) -> None:
    assert told("""
    return LaunchDescription([ExecuteProcess(cmd=['true'], respawn=True, respawn_delay=2.0, respawn_max_retries=3, output='log')])
    """) == ['process true: true', '  started again when it ends, 2 s later, at most 3 times']


def test_the_parameters_of_composable_nodes_are_shown(told) -> None:
    lines = told("""
    from launch_ros.descriptions import ComposableNode
    part = ComposableNode(package='image_tools', plugin='image_tools::Cam2Image', name='cam', parameters=[{'rate': 5, 'names': ['a']}])
    return LaunchDescription([LoadComposableNodes(target_container='/box', composable_node_descriptions=[part])])
    """)
    assert [line.strip() for line in lines[-3:]] == [
        'composable node /cam: image_tools image_tools::Cam2Image',
        "with parameter names = ['a']",
        'with parameter rate = 5',
    ]


def test_a_parameter_file_that_names_the_node_wins_over_the_launch_file_as_in_rcl(told, tmp_path: Path) -> None:
    (tmp_path / 'p.yaml').write_text('/sim:\n  ros__parameters:\n    background_g: 1\n')
    lines = told(f"""
    return LaunchDescription([SetParameter('use_sim_time', False), Node(package='turtlesim', executable='turtlesim_node', name='sim',
        parameters=[{str(tmp_path / 'p.yaml')!r}, {{'background_g': 3}}])])""")
    assert lines[2] == '  parameter background_g = 1  (p.yaml line 3, instead of 3 from my.launch.py line 13)'


def test_the_value_of_an_argument_outlives_its_scope_only_without_one(told) -> None:
    lines = told("""
    return LaunchDescription([GroupAction([SetLaunchConfiguration('green', '1')]),
        GroupAction([SetLaunchConfiguration('red', '1')], scoped=False),
        DeclareLaunchArgument('green', default_value='2'), DeclareLaunchArgument('red', default_value='2')])""")
    assert lines[-2:] == ["argument green = '2'  (default)", "argument red = '1'  (set in my.launch.py line 13, instead of '2')"]
