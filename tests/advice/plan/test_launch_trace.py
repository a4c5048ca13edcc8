"""What is told of a launch that runs: each step with its state and reason, events and timers, and the context at each step."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.recording import Recording
from edulaunch.runtime.session import Session

HEAD = """
import os
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import *
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import *
from launch_ros.actions import Node, PushRosNamespace, SetRemap
def talker(name, **more):
    return Node(package='demo_nodes_py', executable='talker', name=name, **more)
def generate_launch_description():
"""
ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture
def session() -> Iterator[Session]:
    with Session() as found:
        yield found


@pytest.fixture
def launch(session: Session, tmp_path: Path) -> Callable[..., list[dict[str, Any]]]:
    def run(body: str, seconds: float = 3.0, **arguments: str) -> list[dict[str, Any]]:
        path = tmp_path / 'a.launch.py'
        path.write_text(HEAD + body)
        session.launch(path, arguments=arguments)
        session.run(seconds)
        return rows(session)

    return run


def rows(session: Session) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = session.traces[-1].as_data()['rows']
    return sorted(found, key=lambda row: row['number'])


def actions(found: list[dict[str, Any]]) -> list[tuple[str, str]]:
    return [(row['text'], row['state']) for row in found if row.get('file')]


def test_each_action_has_its_place_and_what_became_of_it(launch: Any) -> None:
    found = launch("""
    return LaunchDescription([
        DeclareLaunchArgument('loud', default_value='false'),
        GroupAction([PushRosNamespace('a'), talker('one', condition=IfCondition(LaunchConfiguration('loud')))]),
        talker('two'),
    ])
    """)
    assert actions(found) == [
        ("argument loud = 'false'  (default)", 'taken'),
        ('group', 'taken'),
        ('node /two: demo_nodes_py talker', 'taken'),
        ('namespace /a', 'taken'),
        ('Node talker', 'left out'),
    ]


def test_what_a_function_creates_is_found_at_the_call_that_tells_it_from_the_others(launch: Any, session: Session) -> None:
    found = launch("""
    def once():
        return [LogInfo(msg='once')]
    return LaunchDescription([
        talker('one'),
        *[talker(name) for name in ('two', 'three')],
        *once(),
    ])
    """)
    first, last = HEAD.count('\n') + 1, HEAD.count('\n') - 1
    places = [
        (row['line'] - first, [detail[3] for detail in row['details'] if detail[0] == 'created'])
        for row in found
        if row.get('file')
    ]
    assert places == [(4, [last]), (5, [last]), (5, [last]), (2, [])]
    stepper, (one, two, *_) = session.traces[-1].stepper, [step for step in session.traces[-1].steps if step.origin]
    stops = [
        [stepper.go('line', ('a.launch.py', line)) or stepper.stops_before(step) for step in (one, two)]
        for line in (first + 4, last)
    ]
    assert stops == [[True, False], [True, True]]


def test_what_is_left_out_says_which_value_is_the_reason_and_who_gave_it(launch: Any) -> None:
    found = launch(
        """
    return LaunchDescription([
        DeclareLaunchArgument('loud', default_value='true'),
        talker('one', condition=IfCondition(LaunchConfiguration('loud'))),
    ])
    """,
        loud='false',
    )
    left = next(row for row in found if row['state'] == 'left out')
    assert left['condition'] == "if LaunchConfig('loud')"
    (reason,) = left['values']
    assert (reason['name'], reason['value']) == ('loud', 'false')
    assert [(step['value'], step['origin'], step['counts']) for step in reason['chain']] == [
        ('true', 'default', False),
        ('false', 'command line', True),
    ]


def test_a_parameter_has_the_chain_of_its_origin(launch: Any) -> None:
    found = launch("""
    return LaunchDescription([
        DeclareLaunchArgument('rate', default_value='2'),
        talker('one', parameters=[{'rate': 1}, {'rate': LaunchConfiguration('rate')}]),
    ])
    """)
    (value,) = next(row for row in found if row['kind'] == 'node')['values']
    assert (value['kind'], value['name'], value['value']) == ('parameter', 'rate', 2)
    assert [step['value'] for step in value['chain']] == [1, 2]
    assert [step['value'] for step in value['chain'][-1]['argument']] == ['2']


def test_handlers_say_what_they_wait_for_and_how_often_they_fired(launch: Any) -> None:
    found = launch("""
    quick = ExecuteProcess(cmd=['true'])
    never = ExecuteProcess(cmd=['true'], condition=IfCondition('false'))
    return LaunchDescription([
        RegisterEventHandler(OnProcessExit(target_action=quick, on_exit=[LogInfo(msg='done'), talker('late')])),
        RegisterEventHandler(OnProcessExit(target_action=never, on_exit=[talker('nobody')])),
        quick,
        never,
    ])
    """)
    one, two = (row for row in found if row['kind'] == 'event_handler')
    assert (one['handlers'], one['fired_at']) == (['the end of true-1'], [20_000_000])  # a real program takes 20 ms
    assert 'fired_at' not in two and two['state'] == 'taken'
    below = {row['text']: row['state'] for row in found if row['parent'] in (one['number'], two['number'])}
    assert below == {"log 'done'": 'taken', 'node /late: demo_nodes_py talker': 'taken', 'Node talker': 'waiting'}
    ended = next(row for row in found if row.get('event') == 'ProcessExited')
    assert (ended['text'], ended['fired']) == ('true-1 ended with exit code 0', [one['number']])


def test_a_timer_says_when_and_its_actions_wait_below_it(launch: Any, session: Session) -> None:
    body = """
    return LaunchDescription([
        TimerAction(period=1.5, actions=[LogInfo(msg='now')]), TimerAction(period=9.0, actions=[LogInfo(msg='late')])])
    """
    early, late = (row for row in launch(body) if row['kind'] == 'timer')
    assert (early['due'], early['fired_at']) == (1_500_000_000, [1_500_000_000])
    assert late['due'] == 9_000_000_000 and 'fired_at' not in late
    below = [(row['parent'], row['state'], row['time']) for row in rows(session) if row['kind'] in ('log', 'LogInfo')]
    assert below == [(early['number'], 'taken', 1_500_000_000), (late['number'], 'waiting', None)]


def test_the_context_at_a_step_is_what_launch_had_then(launch: Any, session: Session) -> None:
    launch("""
    return LaunchDescription([
        SetEnvironmentVariable('COLOUR', 'red'),
        GroupAction([PushRosNamespace('a'), SetRemap('x', 'y'), SetLaunchConfiguration('v', '1'), talker('in')]),
        talker('out'),
    ])
    """)
    trace = session.traces[0]
    inside, outside = (
        trace.context_before(next(step for step in trace.steps if step.origin and name in str(step.item)))
        for name in ('/a/in', "'/out'")
    )
    assert inside[0] == {'ros_namespace': '/a', 'ros_remaps': (('x', 'y'),), 'v': '1'}
    assert outside[0] == {}
    assert inside[1] == outside[1] == {'COLOUR': 'red'}


def test_what_runs_a_program_or_code_is_evaluated_once(launch: Any, tmp_path: Path) -> None:
    count = f"sh -c 'echo x >> {tmp_path}/count; echo 1.0'"
    found = launch(f"""
    once = Command(["{count}"])
    return LaunchDescription([LogInfo(msg=once), TimerAction(period=once, actions=[])])
    """)
    assert (tmp_path / 'count').read_text() == 'x\n' * 2
    assert [row['state'] for row in found if row['kind'] in ('LogInfo', 'TimerAction')] == ['taken', 'taken']


def test_an_error_stands_at_the_action_that_failed(launch: Any) -> None:
    found = launch("    return LaunchDescription([GroupAction([LogInfo(msg=LaunchConfiguration('nowhere'))]), talker('x')])")
    assert [(row['text'], row['state']) for row in found if row['state'] == 'failed'] == [
        ("LogInfo LaunchConfig('nowhere')", 'failed')
    ]
    assert [row['state'] for row in found if row['text'] == 'Node talker'] == ['waiting']


def test_a_process_is_stopped_killed_and_started_again_by_launch(launch: Any, session: Session) -> None:
    launch("    return LaunchDescription([talker('one'), talker('two')])")
    trace = session.traces[0]
    one, two = (step for step in trace.steps if step.process_name)
    assert trace.signal(one.number, signal.SIGINT) == 'launch sends SIGINT to talker-1'
    assert trace.restart(two.number) == 'launch starts talker-2 again'
    session.run(1)
    assert [run[1:] for run in one.runs] == [[0, 3_000_000_000, 0]]
    assert [run[1:] for run in two.runs] == [[0, 3_000_000_000, 0], [3_000_000_000, None, None]]
    assert trace.signal(one.number, signal.SIGINT) == 'talker-1 does not run'
    trace.restart(one.number)
    trace.signal(two.number, signal.SIGKILL)
    session.run(1)
    assert one.runs[1][1:] == [4_000_000_000, None, None]
    assert two.runs[1][2:] == [4_000_000_000, -9]
    with pytest.raises(ValueError, match='starts no process'):
        trace.restart(0)


def test_the_digest_does_not_cover_the_steps_and_a_file_keeps_them(session: Session, launch: Any, tmp_path: Path) -> None:
    launch("    return LaunchDescription([talker('one')])")
    recording = session.recording()
    with Session() as other:
        other.host.make_launch_observer = None
        other.launch(tmp_path / 'a.launch.py')
        other.run(3)
        plain = other.recording()
    assert plain.digest() == recording.digest()
    assert plain._content['beside'] == {}
    again = Recording.from_bytes(recording.to_bytes())
    assert again._content['beside'] == recording._content['beside'] != {}
    assert again.to_bytes() == recording.to_bytes()


def test_two_runs_tell_the_same_steps(tmp_path: Path) -> None:
    found = []
    for _ in range(2):
        with Session(workspaces=[ROOT / 'solutions' / 'large_project']) as session:
            session.launch('large_project', 'large_project.launch.py')
            session.run(2)
            found.append(rows(session))
    assert found[0] == found[1]


def stepped(way: str) -> tuple[Session, list[str]]:
    """The large project, with every stop of a launch that is stepped through."""
    session = Session(workspaces=[ROOT / 'solutions' / 'large_project'])
    session.steps_launches = True
    session.launch('large_project', 'large_project.launch.py')
    seen: list[str] = []
    session.sim.run(session.sim.now_ns)
    while session.sim.is_suspended:
        trace = session.traces[0]
        seen.append(trace.stepper.at.process_name or type(trace.stepper.at.action).__name__)
        trace.stepper.go(way)
        session.sim.run(session.sim.now_ns)
    return session, seen


def test_the_large_project_is_stepped_through_and_the_run_is_the_same() -> None:
    session, seen = stepped('into')
    with session:
        session.run(3)
        digest = session.recording().digest()
        trace = session.traces[0]
        written = [step for step in trace.steps if step.origin is not None and step.order and step.at_ns == 0]
        assert len(seen) == len(written) >= 12
        assert seen.count('Node') == sum(type(step.action).__name__ == 'Node' for step in written) >= 5
        back = [trace.context_before(step)[0].get('ros_namespace') for step in reversed(written)]
        assert len(set(back)) > 1 and back[-1] is None
    with Session(workspaces=[ROOT / 'solutions' / 'large_project']) as plain:
        plain.launch('large_project', 'large_project.launch.py')
        plain.run(3)
        assert plain.recording().digest() == digest


def test_a_step_that_ends_after_it_was_told_is_told_again() -> None:
    with Session() as session:
        session.steps_launches = True
        session.launch('turtlesim', 'multisim.launch.py')
        session.sim.run(session.sim.now_ns)
        trace, known, count = session.traces[0], {}, 0
        for way in ('into', 'event', 'event', 'go'):
            told = trace.as_data(count)
            count = told['count']
            known |= {row['number']: row for row in told['rows']}
            assert known == {row['number']: row for row in trace.as_data()['rows']}
            trace.stepper.go(way)
            session.sim.run(session.sim.now_ns)
        known |= {row['number']: row for row in trace.as_data(count)['rows']}
        assert 'visiting' not in {row['state'] for row in known.values()}


def test_a_launch_that_stands_can_be_closed() -> None:
    session = Session()
    session.steps_launches = True
    session.launch('turtlesim', 'multisim.launch.py')
    session.sim.run(session.sim.now_ns)
    assert session.sim.is_suspended
    session.close()
    assert session.traces[0].is_over or not session.graph.nodes


@pytest.mark.processes
def test_a_launch_does_not_load_the_dry_run() -> None:
    text = (
        "import edulaunch, sys; edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=0.1); "
        "print([name for name in ('dry_run', 'planner', 'rehearsal', 'closed') if f'edulaunch.advice.plan.{name}' in sys.modules])"
    )
    assert subprocess.run([sys.executable, '-c', text], capture_output=True, text=True, check=True).stdout == '[]\n'


def test_a_timer_of_a_launch_file_is_shown_when_it_runs_out_and_one_of_ros_is_not(launch: Any) -> None:
    """An ExecuteProcess has timers of its own, which decide about SIGTERM and SIGKILL."""
    found = launch("""
    return LaunchDescription([TimerAction(period=1.0, actions=[LogInfo(msg='x')]), talker('one'), TimerAction(
        period=1.5, actions=[Shutdown()])])
    """)
    assert [row['text'] for row in found if row['kind'] == 'event' and row['event'] == 'TimerEvent'] == [
        'the timer of line 14 ran out',
        'the timer of line 14 ran out',
    ]
