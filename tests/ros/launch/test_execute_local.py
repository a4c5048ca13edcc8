"""Processes: names, command lines, output, signals, respawn and ends."""

from __future__ import annotations

import signal
from typing import Any

import pytest
from launch import LaunchContext
from launch.actions import (
    EmitEvent,
    ExecuteProcess,
    GroupAction,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
)
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import ExecutionComplete, matches_action
from launch.events.process import ShutdownProcess, SignalProcess
from launch.substitutions import LaunchConfiguration


def say(text: Any) -> LogInfo:
    return LogInfo(msg=text)


def said(lines: list[str]) -> list[str]:
    return [line.partition(']: ')[2] for line in lines if line.startswith('[INFO] [launch.user]')]


def test_numbers_count_all_processes_in_order_of_visiting(launch_it: Any, host: Any) -> None:
    launch_it(ExecuteProcess(cmd=['quick']), ExecuteProcess(cmd=['quick'], name='named'), ExecuteProcess(cmd=['quick']))
    assert [spec.name for spec in host.specs] == ['quick-1', 'named-2', 'quick-3']


def test_the_command_line_is_resolved_where_it_is_visited(launch_it: Any, host: Any) -> None:
    launch_it(
        GroupAction(
            [
                SetLaunchConfiguration('x', '1'),
                SetEnvironmentVariable('IN_GROUP', 'yes'),
                ExecuteProcess(cmd=['quick', ['-', LaunchConfiguration('x')]]),
            ]
        ),
        SetLaunchConfiguration('x', '2'),
    )
    assert host.specs[0].argv == ('quick', '-1')
    assert host.specs[0].env['IN_GROUP'] == 'yes'


def test_a_plain_text_as_command_is_split_into_characters() -> None:
    assert len(ExecuteProcess(cmd='ls').cmd) == 2


def test_additional_env_adds_and_env_replaces(launch_it: Any, host: Any, fresh_simulation: Any) -> None:
    fresh_simulation.env['OLD'] = '1'
    launch_it(ExecuteProcess(cmd=['quick'], additional_env={'NEW': '2'}), ExecuteProcess(cmd=['quick'], env={'NEW': '3'}))
    added, replaced = (spec.env for spec in host.specs)
    assert (added['OLD'], added['NEW']) == ('1', '2')
    assert replaced == {'NEW': '3'}


def test_the_launch_prefix_goes_to_programs_that_match_the_filter(launch_it: Any, host: Any) -> None:
    host.scripts['nice'] = host.scripts['quick']
    launch_it(
        SetLaunchConfiguration('launch-prefix', 'nice -n 5'),
        SetLaunchConfiguration('launch-prefix-filter', 'fail'),
        ExecuteProcess(cmd=['quick']),
        ExecuteProcess(cmd=['failing']),
    )
    assert [spec.argv for spec in host.specs] == [('quick',), ('nice', '-n', '5', 'failing')]
    assert host.specs[1].name == 'nice-2', 'as upstream, the prefix counts as the program'


def test_an_own_prefix_ignores_the_filter(launch_it: Any, host: Any) -> None:
    host.scripts['time'] = host.scripts['quick']
    launch_it(SetLaunchConfiguration('launch-prefix-filter', 'zzz'), ExecuteProcess(cmd=['quick'], prefix='time'))
    assert host.specs[0].argv == ('time', 'quick')


def test_output_comes_in_lines_and_the_rest_at_the_end(launch_it: Any, host: Any) -> None:
    lines = launch_it(ExecuteProcess(cmd=['talker'], output='screen'))[1]
    assert lines == [
        '[INFO] [talker-1]: process started with pid [101]',
        '[talker-1] one',
        '[talker-1] two',
        '[INFO] [talker-1]: process has finished cleanly [pid 101]',
        '[talker-1] rest',
    ]


def test_empty_lines_get_the_prefix_too(launch_it: Any, host: Any) -> None:
    host.scripts['blank'] = lambda program: (program.print('\n\n'), program.at(1.0, lambda: program.exit(0)))
    assert launch_it(ExecuteProcess(cmd=['blank'], output='screen'))[1].count('[blank-1] ') == 2


@pytest.mark.parametrize(
    ('output', 'shown'),
    [
        ('log', ['[both-1] err']),
        ('screen', ['[both-1] out', '[both-1] err']),
        ('both', ['[both-1] out', '[both-1] err']),
        ({'stdout': 'screen'}, ['[both-1] out']),
        ({'both': {'log'}}, []),
        ('own_log', []),
    ],
)
def test_output_decides_what_the_screen_shows(output: Any, shown: list[str], launch_it: Any, host: Any) -> None:
    host.scripts['both'] = lambda program: (
        program.print('out\n'),
        program.print('err\n', 'stderr'),
        program.at(1.0, lambda: program.exit(0)),
    )
    lines = launch_it(ExecuteProcess(cmd=['both'], output=output))[1]
    assert [line for line in lines if line.startswith('[both-1]')] == shown


def test_an_unknown_output_is_an_error(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(ExecuteProcess(cmd=['quick'], output='scren'))
    assert code == 1
    assert 'scren is not a valid standard output config i.e. "screen", "log" or "both"' in lines[0]


def test_the_environment_can_override_all_outputs(launch_it: Any, host: Any, fresh_simulation: Any) -> None:
    fresh_simulation.env['OVERRIDE_LAUNCH_PROCESS_OUTPUT'] = 'screen'
    assert '[talker-1] one' in launch_it(ExecuteProcess(cmd=['talker'], output='log'))[1]


def test_output_format_may_use_the_line_and_the_action(launch_it: Any, host: Any) -> None:
    talker = ExecuteProcess(cmd=['talker'], output='screen', output_format='{this.process_details[pid]}: {line}')
    assert '101: one' in launch_it(talker)[1]


def test_cached_output_can_be_read_and_other_output_cannot(launch_it: Any, host: Any) -> None:
    cached, plain = ExecuteProcess(cmd=['talker'], cached_output=True), ExecuteProcess(cmd=['talker'])
    launch_it(cached, plain)
    assert (cached.get_stdout(), cached.get_stderr()) == ('one\ntwo\nrest', '')
    with pytest.raises(RuntimeError, match="cached output must be true to be able to get stdout, proc 'talker-2'"):
        plain.get_stdout()


def test_log_cmd_shows_the_command(launch_it: Any, host: Any) -> None:
    lines = launch_it(ExecuteProcess(cmd=['quick', 'x'], log_cmd=True))[1]
    assert lines[0] == "[INFO] [quick-1]: process details: cmd='quick x', cwd='None', custom_env?=True"


def test_a_command_that_is_not_there_is_reported_and_the_rest_goes_on(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(ExecuteProcess(cmd=['nothing']), ExecuteProcess(cmd=['quick']))
    assert code == 0
    assert lines[0] == '[ERROR] [nothing-1]: exception occurred while executing process:'
    assert "FileNotFoundError: [Errno 2] No such file or directory: 'nothing'" in lines
    assert lines[-1] == '[INFO] [quick-2]: process has finished cleanly [pid 101]'


def test_signals_escalate_with_ros_texts(launch_it: Any, host: Any) -> None:
    lines = launch_it(
        ExecuteProcess(cmd=['stubborn'], sigterm_timeout='2', sigkill_timeout='3'), TimerAction(period=1.0, actions=[Shutdown()])
    )[1]
    assert host.log[1:] == [(1.0, 'SIGINT', 'stubborn-1'), (3.0, 'SIGTERM', 'stubborn-1'), (6.0, 'SIGKILL', 'stubborn-1')]
    failed = '[ERROR] [stubborn-1]: process[stubborn-1] failed to terminate'
    assert lines[1:-1] == [
        "[INFO] [stubborn-1]: sending signal 'SIGINT' to process[stubborn-1]",
        f"{failed} '2' seconds after receiving 'SIGINT', escalating to 'SIGTERM'",
        "[INFO] [stubborn-1]: sending signal 'SIGTERM' to process[stubborn-1]",
        f"{failed} '5.0' seconds after receiving 'SIGTERM', escalating to 'SIGKILL'",
        "[INFO] [stubborn-1]: sending signal 'SIGKILL' to process[stubborn-1]",
    ]


def test_the_timeouts_are_launch_configurations_by_default(launch_it: Any, host: Any) -> None:
    launch_it(
        SetLaunchConfiguration('sigterm_timeout', '1'),
        ExecuteProcess(cmd=['stubborn']),
        TimerAction(period=1.0, actions=[Shutdown()]),
    )
    assert [entry[0] for entry in host.log] == [0.0, 1.0, 2.0, 7.0]


def test_a_process_that_ends_in_time_gets_no_further_signal(launch_it: Any, host: Any) -> None:
    launch_it(ExecuteProcess(cmd=['forever']), TimerAction(period=1.0, actions=[Shutdown()]))
    assert host.log == [(0.0, 'start', 'forever-1'), (1.0, 'SIGINT', 'forever-1')]


def test_a_shutdown_right_at_the_start_reaches_the_process(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(ExecuteProcess(cmd=['forever']), Shutdown())
    assert code == 0
    assert [entry[1] for entry in host.log] == ['start', 'SIGINT']


def test_after_a_shutdown_nothing_is_started(launch_it: Any, host: Any) -> None:
    launch_it(Shutdown(), TimerAction(period=1.0, actions=[ExecuteProcess(cmd=['quick'])], cancel_on_shutdown=False))
    assert host.log == []


def test_respawn_starts_again_after_the_delay_under_the_same_name(launch_it: Any, host: Any) -> None:
    launch_it(ExecuteProcess(cmd=['quick'], respawn=True, respawn_delay=0.5, respawn_max_retries=2))
    assert host.log == [(0.0, 'start', 'quick-1'), (1.5, 'start', 'quick-1'), (3.0, 'start', 'quick-1')]


def test_a_delay_that_is_no_number_ends_the_launch(launch_it: Any, host: Any) -> None:
    delay: Any = LaunchConfiguration('d', default='1')
    code, lines = launch_it(ExecuteProcess(cmd=['quick'], respawn=True, respawn_delay=delay))
    assert code == 1
    assert "'>' not supported between instances of 'LaunchConfiguration' and 'float'" in '\n'.join(lines)


def test_respawn_ends_with_the_launch_also_during_the_delay(launch_it: Any, host: Any) -> None:
    launch_it(ExecuteProcess(cmd=['failing'], respawn=True, respawn_delay=5), TimerAction(period=2.0, actions=[Shutdown()]))
    assert host.log == [(0.0, 'start', 'failing-1')]


def test_on_exit_may_end_the_launch(launch_it: Any, host: Any) -> None:
    lines = launch_it(ExecuteProcess(cmd=['quick'], on_exit=Shutdown()), ExecuteProcess(cmd=['forever']))[1]
    assert '[INFO] [launch]: process[quick-1] was required: shutting down launched system' in lines
    assert host.log[-1] == (1.0, 'SIGINT', 'forever-2')


@pytest.mark.parametrize('on_exit', [[say('bye')], say('bye'), lambda event, context: say('bye')])
def test_on_exit_takes_an_entity_a_list_or_a_callable(on_exit: Any, launch_it: Any, host: Any) -> None:
    assert said(launch_it(ExecuteProcess(cmd=['quick'], on_exit=on_exit))[1]) == ['bye']


def test_handlers_see_start_output_completion_and_exit(launch_it: Any, host: Any) -> None:
    talker = ExecuteProcess(cmd=['talker'])
    lines = launch_it(
        RegisterEventHandler(OnExecutionComplete(target_action=talker, on_completion=[say('complete')])),
        talker,
        ExecuteProcess(cmd=['quick']),
        RegisterEventHandler(OnProcessStart(target_action=talker, on_start=[say('started')])),
        RegisterEventHandler(OnProcessIO(target_action=talker, on_stdout=lambda event: say(event.text.decode().split()[0]))),
        RegisterEventHandler(OnProcessExit(target_action=talker, on_exit=[say('exited')])),
    )[1]
    assert said(lines) == ['started', 'one', 'exited', 'complete']


def test_a_process_alone_wants_no_event_about_its_execution(launch_it: Any, host: Any) -> None:
    quick, wanted = ExecuteProcess(cmd=['quick']), []

    def ask(context: LaunchContext) -> None:
        wanted.append(context.would_handle_event(ExecutionComplete(action=quick)))

    listener = RegisterEventHandler(OnExecutionComplete(target_action=quick, on_completion=[say('complete')]))
    launch_it(quick, OpaqueFunction(function=ask), listener, OpaqueFunction(function=ask))
    assert wanted == [False, True]


def test_events_can_signal_and_end_one_process(launch_it: Any, host: Any) -> None:
    one, two = ExecuteProcess(cmd=['stubborn']), ExecuteProcess(cmd=['forever'])
    launch_it(
        one,
        two,
        TimerAction(
            period=1.0,
            actions=[
                EmitEvent(event=SignalProcess(signal_number='SIGKILL', process_matcher=matches_action(one))),
                EmitEvent(event=ShutdownProcess(process_matcher=matches_action(two))),
            ],
        ),
    )
    assert host.log[2:] == [(1.0, 'SIGKILL', 'stubborn-1'), (1.0, 'SIGINT', 'forever-2')]


def test_the_details_of_a_process(launch_it: Any, host: Any) -> None:
    action = ExecuteProcess(cmd=['failing', 'x'])
    assert (action.process_details, action.return_code, action.name) == (None, None, None)
    launch_it(action)
    assert action.process_details is not None
    assert list(action.process_details) == ['action', 'name', 'cmd', 'cwd', 'env', 'pid']
    assert (action.return_code, action.name, action.cmd) == (3, 'failing-1', ['failing', 'x'])


def test_one_action_cannot_be_executed_twice(launch_it: Any, host: Any) -> None:
    action = ExecuteProcess(cmd=['quick'])
    code, lines = launch_it(action, action)
    assert code == 1
    assert "ExecuteLocal action 'quick-1': executed more than once: <launch.actions." in lines[0]


def test_the_process_knows_the_line_of_its_action(launch_it: Any, host: Any) -> None:
    launch_it(ExecuteProcess(cmd=['quick']))
    assert host.specs[0].origin.file == __file__


def test_prepare_alone_resolves_everything() -> None:
    action = ExecuteProcess(cmd=['ls', LaunchConfiguration('x')], cwd='/tmp')
    context = LaunchContext()
    context.launch_configurations['x'] = 'y'
    action.prepare(context)
    assert (action.cmd, action.cwd, action.name) == (['ls', 'y'], '/tmp', 'ls-1')


def test_signal_events_know_their_name() -> None:
    event = SignalProcess(signal_number=signal.SIGTERM, process_matcher=lambda action: True)
    assert (event.signal, event.signal_name) == (signal.SIGTERM, 'SIGTERM')
    kill = SignalProcess(signal_number='SIGKILL', process_matcher=lambda action: True)
    assert (kill.signal, kill.signal_name) == ('SIGKILL', 'SIGKILL')
    with pytest.raises(TypeError, match=r"'SignalProcess' expected 'signal_number' to be one of .* but got '2' of type"):
        SignalProcess(signal_number=2, process_matcher=lambda action: True)  # type: ignore[arg-type]


def test_a_signal_by_its_name_is_no_number_as_in_ros(launch_it: Any, host: Any) -> None:
    forever = ExecuteProcess(cmd=['forever'])
    by_name = SignalProcess(signal_number='SIGUSR1', process_matcher=matches_action(forever))
    code, lines = launch_it(forever, TimerAction(period=1.0, actions=[EmitEvent(event=by_name)]))
    assert code == 1 and any("'str' object cannot be interpreted as an integer" in line for line in lines), lines
    assert [entry[1] for entry in host.log] == ['start', 'SIGINT']
