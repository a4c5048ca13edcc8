"""What a page may ask of a living machine."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from edulaunch.advice.rendering import Mark
from edulaunch.desk.view import ViewedMachine
from edulaunch.desk.view.viewer import TICK_NS, Viewer
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.recording import Recording
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.runtime.session import Session
from tests.house import EXAMPLES


class Desk(ViewedMachine):
    """A viewer with what it said, on a machine whose wall clock the test moves."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.wall_s = 0.0
        self.time = RealTime(session.sim, clock=lambda: self.wall_s)
        self.said: list[dict[str, Any]] = []
        self.viewer = Viewer(self, self.said.append)

    is_on_network: bool | None = None

    def join_network(self, joins: bool) -> str:
        self.is_on_network = joins
        return 'joined' if joins else 'left'

    def continue_at(self, time_s: float) -> None:
        raise AssertionError('nobody asks this')

    def ask(self, op: str, **words: Any) -> None:
        self.viewer.take({'op': op, **words})

    def go(self, seconds: float) -> None:
        """Let real time pass in small steps."""
        self.time.paused = False
        for _ in range(round(seconds / 0.02)):
            self.wall_s += 0.02
            self.time.advance()

    def text(self) -> str:
        return ''.join(message.get('text', '') for message in self.said)


@pytest.fixture
def desk() -> Iterator[Desk]:
    with Session() as session, streams_of_programs():
        session.launch('turtlesim', 'multisim.launch.py')
        session.run(1)
        yield Desk(session)


def test_a_tick_is_exactly_sixteen_milliseconds_and_time_stands_still_after_it(desk: Desk) -> None:
    before = desk.session.sim.now_ns
    desk.ask('step')
    assert desk.session.sim.now_ns - before == TICK_NS
    desk.wall_s += 5
    desk.time.advance()
    assert desk.session.sim.now_ns - before == TICK_NS


def test_a_step_to_the_next_message_ends_with_it(desk: Desk) -> None:
    before = desk.session.recorder.publication_count()
    desk.ask('step', what='message')
    assert 0 < desk.session.recorder.publication_count() - before <= 4  # one turn publishes pose and colour of a window


def test_driving_is_a_message_of_a_node_and_moves_the_turtle(desk: Desk) -> None:
    desk.ask('drive', turtle='/turtlesim1/turtle1', linear=2, angular=0)
    desk.go(1.2)
    recording = desk.session.recording()
    assert [(message.linear.x, message.angular.z) for _, message in recording.messages('/turtlesim1/turtle1/cmd_vel')] == [
        (2.0, 0.0)
    ]
    assert recording.trajectory('/turtlesim1/turtle1').x[-1] > 7


def test_a_parameter_is_set_as_ros2_param_set_does(desk: Desk) -> None:
    desk.ask('param', node='/turtlesim1/turtlesim', name='background_r', value='200')
    desk.go(2)
    assert {'said': 'Set parameter successful'} in desk.said
    assert desk.session.recording().parameters('/turtlesim1/turtlesim')['background_r'].value == 200


def test_dragging_teleports_by_a_service_call(desk: Desk) -> None:
    desk.time.paused = True
    desk.ask('teleport', turtle='/turtlesim1/turtle1', x=3.0, y=4.0, theta=0.0)
    desk.go(1)
    calls = [call.service for call in desk.session.recording().service_calls]
    assert '/turtlesim1/turtle1/teleport_absolute' in calls


def test_a_line_runs_and_ctrl_c_ends_the_last_one(desk: Desk) -> None:
    desk.ask('line', line='ros2 node list')
    desk.go(1)
    assert '/turtlesim1/turtlesim' in desk.text()
    desk.ask('line', line='ros2 topic echo /turtlesim1/turtle1/pose')
    desk.go(0.5)
    desk.ask('interrupt')
    desk.go(0.5)
    length = len(desk.text())
    desk.go(1)
    assert len(desk.text()) == length


@pytest.mark.parametrize(
    ('line', 'sure'),
    [
        ('ros2 topic ec', 'ros2 topic echo '),
        ('ros2 topic echo /turtlesim1/turtle1/po', 'ros2 topic echo /turtlesim1/turtle1/pose '),
        ('ros2 param get /turtlesim1/turtlesim background_', 'ros2 param get /turtlesim1/turtlesim background_'),
        ('ros2 run turtle_tf2_', 'ros2 run turtle_tf2_py '),
        ('ros2 nothing of th', 'ros2 nothing of th'),
        ('ros2 launch turtle_tf2_py turtle_tf2_f', 'ros2 launch turtle_tf2_py turtle_tf2_fixed_frame_demo.launch.py '),
        (
            'ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py tar',
            'ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py target_frame:=',
        ),
        ('ros2 topic pub /x geometry_msgs/msg/TwistW', 'ros2 topic pub /x geometry_msgs/msg/TwistWithCovariance'),
        ('ros2 node info /turtlesim1/', 'ros2 node info /turtlesim1/turtlesim '),
    ],
)
def test_the_tab_key_knows_verbs_packages_and_names_of_the_machine(desk: Desk, line: str, sure: str) -> None:
    desk.ask('complete', line=line)
    assert desk.said[-1]['completed'][0] == sure


def test_the_rules_look_when_somebody_asks(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('edulaunch.advice.rendering.marks', one_mark)
    desk.ask('advise')
    desk.viewer.show()
    assert desk.said[-2:][0] == {'said': 'Problems found: 1.'}
    assert desk.said[-1]['delta']['advice'] == [{'time': 1_000_000, 'subject': {}, 'text': 'so long already', 'rule': 'length'}]


def one_mark(recording: Recording) -> list[Mark]:
    return [Mark(recording.duration_s, ('', ''), 'so long already', 'length')]


def test_two_terminals_each_with_a_program_of_its_own(desk: Desk) -> None:
    desk.ask('line', line='ros2 topic echo /turtlesim1/turtle1/pose')
    desk.ask('line', line='ros2 node list', pane=1)
    desk.go(1)
    texts = {pane: ''.join(message.get('text', '') for message in desk.said if message.get('pane') == pane) for pane in (0, 1)}
    assert texts[0].startswith('x: 5.54') and texts[1] == '/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n'
    states = [(message['pane'], message['runs']) for message in desk.said if 'runs' in message]
    assert states == [(0, True), (1, True), (1, False)]
    desk.ask('interrupt', pane=1)
    desk.ask('complete', line='ros2 topic l', pane=1)
    assert desk.said[-1] == {'completed': ['ros2 topic list ', ['list']], 'pane': 1}
    desk.ask('interrupt', pane=0)
    desk.go(1)
    assert desk.said[-1] == {'pane': 0, 'runs': False, 'keys': False}
    desk.ask('line', line='ros2 topic list', pane=2)
    assert desk.said[-1] == {'said': 'line: there are 2 terminals'}


def test_a_program_that_wants_keys_gets_them(desk: Desk) -> None:
    desk.ask('line', line='ros2 run turtlesim turtle_teleop_key --ros-args -r __ns:=/turtlesim1')
    desk.go(1)
    assert desk.said[-1].get('keys') or any(message.get('keys') for message in desk.said)
    desk.ask('keys', keys='\x1b[A')
    desk.go(1)
    assert desk.session.recording().trajectory('/turtlesim1/turtle1').x[-1] > 7
    desk.ask('keys', keys='q')
    desk.go(1)
    assert desk.said[-1] == {'pane': 0, 'runs': False, 'keys': False}


def test_another_command_is_refused_with_a_sentence(desk: Desk) -> None:
    desk.ask('line', line='rm -rf /')
    assert desk.text() == 'rm: this terminal runs only ros2 commands\n'


def test_the_state_of_time_is_told_when_it_changes(desk: Desk) -> None:
    desk.viewer.show()
    desk.viewer.show()
    desk.ask('pause')
    desk.viewer.show()
    going = {'running': True, 'speed': 1.0, 'can_continue': False, 'network': None, 'steps_launches': False}
    assert [message.get('machine') for message in desk.said] == [going, None, {**going, 'running': False}]


def test_a_page_joins_a_network_and_leaves_it(desk: Desk) -> None:
    desk.is_on_network = False
    for joins in (True, False):
        desk.viewer.show()
        desk.ask('network', on=joins)
    desk.viewer.show()
    assert [message['machine']['network'] for message in desk.said if 'machine' in message] == [False, True, False]
    assert [message['said'] for message in desk.said if 'said' in message] == ['joined', 'left']


ANYTHING = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=5,
)
OPS = st.sampled_from(
    [
        'pause',
        'play',
        'continue',
        'export',
        'keys',
        'network',
        'advise',
        'advise',
        'speed',
        'step',
        'drive',
        'teleport',
        'param',
        'line',
        'complete',
        'interrupt',
        'what',
    ]
)
FIELDS = st.sampled_from(
    ['op', 'what', 'turtle', 'linear', 'angular', 'x', 'y', 'theta', 'node', 'name', 'value', 'line', 'speed', 'pane', 'keys']
)


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=3 * EXAMPLES // 2)
@given(
    words=ANYTHING | st.tuples(OPS, st.dictionaries(FIELDS, ANYTHING, max_size=4)).map(lambda pair: {**pair[1], 'op': pair[0]})
)
def test_whatever_a_page_says_is_answered_and_harms_nothing(desk: Desk, words: Any) -> None:
    desk.viewer.take(words)
    desk.time.advance()


def test_a_launch_is_stepped_and_its_processes_stopped_and_restarted() -> None:
    with Session() as session, streams_of_programs():
        session.steps_launches = True
        session.launch('turtlesim', 'multisim.launch.py')
        desk = Desk(session)
        desk.time.paused = False
        desk.time.advance()
        assert desk.time.paused and session.sim.is_suspended
        trace = session.traces[0]
        stops = [trace.stepper.at.number]
        for way in ('into', 'event'):
            desk.ask('launch', pid=trace.pid, way=way)
            stops.append(trace.stepper.at.number)
        assert [trace.steps[number].is_event for number in stops] == [False, False, True]
        desk.ask('play')
        desk.go(0.5)
        (one, two) = (step for step in trace.steps if step.process_name)
        desk.ask('process', pid=trace.pid, number=one.number, what='restart')
        desk.ask('process', pid=trace.pid, number=two.number, what='kill')
        desk.go(0.5)
        assert (len(one.runs), one.is_running, two.runs[0][3]) == (2, True, -9)
        desk.ask('launch', pid=trace.pid, way='line', file='multisim.launch.py', line=1)
        assert desk.said[-1] == {'said': 'The launch does not reach this line within 10 s of simulated time.'}
        desk.ask('launch', pid=trace.pid, way='into')
        assert desk.said[-1] == {'said': 'No action follows within 10 s of simulated time.'}
        desk.ask('launch', pid=trace.pid, way='there')
        desk.ask('launch', pid=1, way='into')
        desk.ask('process', pid=trace.pid, number=0, what='kill')
        desk.ask('stops', on=True, again=True)
        assert [message['said'].partition(':')[0] for message in desk.said[-4:]] == ['launch', 'launch', 'process', 'stops']


def test_a_page_that_is_closed_lets_a_launch_go_on_that_waits_before_an_action() -> None:
    with Session() as session, streams_of_programs():
        session.steps_launches = True
        session.launch('turtlesim', 'multisim.launch.py')
        desk = Desk(session)
        desk.time.advance()
        assert session.sim.is_suspended and desk.time.paused
        desk.viewer.close()
        assert not session.sim.is_suspended and not desk.time.paused
        desk.go(0.1)
        assert [step.is_running for step in session.traces[0].steps if step.process_name] == [True, True]
