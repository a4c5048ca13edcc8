"""Programs of further tutorials: managed nodes, logging, introspection, actions in C++, driving with keys."""

from __future__ import annotations

from typing import Any

import pytest
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from logging_demo.srv import ConfigLogger

import edulaunch


def said(recording: Any, process: str) -> list[str]:
    return [line.message for line in recording.logs if line.process == process]


def test_a_managed_talker_speaks_while_it_is_active(stage: Any) -> None:
    stage.start('lifecycle_py', 'lifecycle_talker')
    stage.until(10)
    for name in ('CONFIGURE', 'ACTIVATE', 'DEACTIVATE', 'CLEANUP', 'UNCONFIGURED_SHUTDOWN'):
        stage.ask('/lc_talker/change_state', ChangeState, transition=Transition(id=getattr(Transition, f'TRANSITION_{name}')))
        stage.until((stage.sim.now_ns - stage.sim.start_ns) / 1e6 + 1000)
    assert stage.texts() == [
        'on_configure() is called.',
        'Lifecycle publisher is inactive. Messages are not published.',
        'on_activate() is called.',
        'Lifecycle publisher is active. Publishing: [Lifecycle HelloWorld #1]',
        'on_deactivate() is called.',
        'Lifecycle publisher is inactive. Messages are not published.',
        'on_cleanup() is called.',
        'on_shutdown() is called.',
    ]
    assert [message.data for message in stage.messages('/lifecycle_chatter')] == ['Lifecycle HelloWorld #1']


def test_the_tutorial_of_managed_nodes_runs_to_its_end() -> None:
    recording = edulaunch.run('lifecycle', 'lifecycle_demo_launch.py', duration_s=90)
    states = [text.split()[-1] for text in said(recording, 'lifecycle_service_client-3') if text.startswith('Node')]
    assert states == [
        f'{name}.'
        for name in ['unconfigured', 'inactive', 'active', 'inactive', 'active', 'inactive', 'unconfigured', 'finalized']
    ]
    heard = said(recording, 'lifecycle_listener-2')
    assert 'notify callback: Transition from state activating to active' in heard
    assert 'data_callback: Lifecycle HelloWorld #10' in heard
    assert {round(process.ended_s or 0.0) for process in recording.processes} == {64}  # the client's end ends the launch


def test_the_client_of_managed_nodes_says_when_there_is_none(stage: Any) -> None:
    client = stage.start('lifecycle', 'lifecycle_service_client')
    stage.until(6000)
    assert stage.tape.logs == [(5000.0, 'Service /lc_talker/get_state is not available.')] and client.returncode == 0


def test_logging_demo_shows_debug_after_ten_rounds_or_when_asked(stage: Any) -> None:
    stage.start('logging_demo', 'logging_demo_main')
    stage.until(10)
    replies = [
        stage.ask('/config_logger', ConfigLogger, logger_name='logger_usage_demo', level=level) for level in ('DEBUG', 'LOUD')
    ]
    stage.until(1100)
    assert [reply[0].success for reply in replies] == [True, False]
    texts = stage.texts()
    assert texts[:3] == [
        "Incoming request: logger 'logger_usage_demo', severity 'DEBUG'",
        "Incoming request: logger 'logger_usage_demo', severity 'LOUD'",
        "Unknown severity 'LOUD'",
    ]
    assert '12 modulo 1 is 0' in texts and texts.count('Timer callback called (this will only log once)') == 1
    stage.until(8600)
    assert 'Setting severity threshold to DEBUG' in stage.texts() and 'Reseting count to 0' in stage.texts()


def test_a_logger_is_set_by_service(stage: Any) -> None:
    process = stage.start('demo_nodes_py', 'use_logger_service')
    stage.until(5000)
    texts = stage.texts()
    assert 'Output 2 with DEBUG logger level.' in texts and 'Output 1 with DEBUG logger level.' not in texts
    assert not {'Output 3 with INFO logger level.', 'Output 4 with WARN logger level.'} & set(texts)
    assert texts[-1] == 'Current logger level: 40' and process.returncode == 0


@pytest.mark.parametrize(('state', 'events', 'requests'), [('disabled', 0, 0), ('metadata', 4, 0), ('contents', 4, 1)])
def test_services_are_introspected_as_much_as_a_parameter_says(stage: Any, state: str, events: int, requests: int) -> None:
    stage.start('demo_nodes_cpp', 'introspection_service', '--ros-args', '-p', f'service_configure_introspection:={state}')
    stage.start('demo_nodes_cpp', 'introspection_client', '--ros-args', '-p', f'client_configure_introspection:={state}')
    stage.until(700)
    found = stage.messages('/add_two_ints/_service_event')
    assert stage.texts() == ['Incoming request\na: 2 b: 3', 'Result of add_two_ints: 5']
    assert [event.info.event_type for event in found] == list(range(events))
    assert len(found[0].request if found else ()) == requests


def test_another_word_for_introspection_is_refused(stage: Any) -> None:
    from rcl_interfaces.msg import Parameter, ParameterValue
    from rcl_interfaces.srv import SetParameters

    stage.start('demo_nodes_cpp', 'introspection_service')
    stage.until(10)
    value = Parameter(name='service_configure_introspection', value=ParameterValue(type=4, string_value='all'))
    replies = stage.ask('/introspection_service/set_parameters', SetParameters, parameters=[value])
    stage.until(20)
    [result] = replies[0].results
    assert (result.successful, result.reason) == (False, 'must be one of "disabled", "metadata", or "contents"')


def test_the_action_tutorial_in_cpp(stage: Any) -> None:
    client = stage.start('action_tutorials_cpp', 'fibonacci_action_client')
    stage.until(2000)
    stage.start('action_tutorials_cpp', 'fibonacci_action_server')
    stage.until(20_000)
    texts = stage.texts()
    assert texts[:2] == ['Sending goal', 'Received goal request with order 10']
    assert 'Next number in sequence received: 0 1 1 2 ' in texts and texts.count('Publish feedback') == 9
    assert texts[-1] == 'Result received: 0 1 1 2 3 5 8 13 21 34 55 ' and client.returncode == 0


def test_an_action_client_without_a_server_gives_up(stage: Any) -> None:
    client = stage.start('action_tutorials_cpp', 'fibonacci_action_client')
    stage.until(11_000)
    assert stage.tape.logs == [(10_500.0, 'Action server not available after waiting')] and client.returncode == 0


@pytest.mark.parametrize('stamped', ['false', 'true'])
def test_keys_drive_a_robot(tmp_path: Any, stamped: str) -> None:
    file = tmp_path / 'keys.launch.xml'
    file.write_text(
        '<launch><node pkg="teleop_twist_keyboard" exec="teleop_twist_keyboard" output="screen">'
        f'<param name="stamped" value="{stamped}"/></node></launch>'
    )
    keys = [(1.0, 'i'), (2.0, 'w'), (3.0, 'J'), (4.0, '?'), (5.0, '\x03')]
    with edulaunch.Session(stdin={'teleop_twist_keyboard': keys}) as session:
        session.launch(file)
        session.run(6.0)
        recording = session.recording()
    times, messages = zip(*recording.messages('/cmd_vel'), strict=True)
    twists = [message.twist if stamped == 'true' else message for message in messages]
    assert times == (1.0, 2.0, 3.0, 4.0, 5.0)
    seen = [value for one in twists for value in (one.linear.x, one.linear.y, one.angular.z)]
    assert seen == pytest.approx([0.5, 0, 0, 0.55, 0, 0, 0, 0.55, 0, *[0] * 6])
    printed = ''.join(line.text for line in recording.output)
    assert 'currently:\tspeed 0.5\tturn 1.0 ' in printed and 'CTRL-C to quit' in printed
    assert recording.processes[-1].returncode == 0


def test_a_frame_needs_stamped_messages(stage: Any) -> None:
    process = stage.start('teleop_twist_keyboard', 'teleop_twist_keyboard', '--ros-args', '-p', 'frame_id:=base')
    stage.until(100)
    assert process.returncode == 1 and "'frame_id' can only be set when 'stamped' is True" in stage.tape.outputs[-1][1]
