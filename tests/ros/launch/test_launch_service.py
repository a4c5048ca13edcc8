"""The main loop: order of visiting, handling and starting; ends, errors and interrupts."""

from __future__ import annotations

import asyncio
import signal
import threading
from typing import Any

import pytest
from launch import LaunchDescription, LaunchService
from launch.actions import (
    EmitEvent,
    ExecuteProcess,
    GroupAction,
    LogInfo,
    OpaqueFunction,
    RegisterEventHandler,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
)
from launch.event_handlers import OnShutdown
from launch.events import Shutdown as ShutdownEvent
from launch.substitutions import LaunchConfiguration, LocalSubstitution

from edulaunch.engine.sim.task import Task


def say(text: Any) -> LogInfo:
    return LogInfo(msg=text)


def test_nothing_to_do_ends_at_once(launch_it: Any) -> None:
    assert launch_it() == (0, [])


def test_messages_of_the_visit_come_before_any_process(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(say('a'), ExecuteProcess(cmd=['quick']), say('b'), ExecuteProcess(cmd=['quick']), say('c'))
    assert code == 0
    assert lines == [
        '[INFO] [launch.user]: a',
        '[INFO] [launch.user]: b',
        '[INFO] [launch.user]: c',
        '[INFO] [quick-1]: process started with pid [101]',
        '[INFO] [quick-2]: process started with pid [102]',
        '[INFO] [quick-1]: process has finished cleanly [pid 101]',
        '[INFO] [quick-2]: process has finished cleanly [pid 102]',
    ]


def test_an_exception_in_the_visit_starts_nothing_and_gives_one(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(
        ExecuteProcess(cmd=['forever']), TimerAction(period=1.0, actions=[]), say(LaunchConfiguration('missing'))
    )
    assert code == 1
    assert lines[0] == (
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): launch configuration 'missing' does not exist"
    )
    assert host.log == []


def test_an_exception_later_lets_processes_end_first(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(
        ExecuteProcess(cmd=['forever']), TimerAction(period=2.0, actions=[say(LaunchConfiguration('missing'))])
    )
    assert code == 1
    assert host.log == [(0.0, 'start', 'forever-1'), (2.0, 'SIGINT', 'forever-1')]
    assert lines[-1].startswith('[ERROR] [forever-1]: process has died [pid 101, exit code -2,')


def test_exit_codes_of_processes_do_not_count(launch_it: Any, host: Any) -> None:
    code, lines = launch_it(ExecuteProcess(cmd=['failing', ' ', 'x']))
    assert code == 0
    assert lines[-1] == "[ERROR] [failing-1]: process has died [pid 101, exit code 3, cmd 'failing x']."


def test_the_shutdown_reason_reaches_handlers(launch_it: Any) -> None:
    code, lines = launch_it(
        RegisterEventHandler(OnShutdown(on_shutdown=[say(['why: ', LocalSubstitution('event.reason')])])), Shutdown(reason='done')
    )
    assert (code, lines) == (0, ['[INFO] [launch.user]: why: done'])


def test_the_reason_of_an_idle_launch_is_idle(launch_it: Any) -> None:
    handler = RegisterEventHandler(OnShutdown(on_shutdown=[say([LocalSubstitution('event.reason')])]))
    assert launch_it(handler)[1] == ['[INFO] [launch.user]: idle']


def test_a_handler_must_return_entities(launch_it: Any) -> None:
    code, lines = launch_it(RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: ['x'])), Shutdown())
    assert code == 1
    assert "expected a LaunchDescriptionEntity from event_handler, got 'x'" in lines[0]


def test_timers_fire_in_the_order_of_their_times(launch_it: Any) -> None:
    lines = launch_it(*(TimerAction(period=float(n), actions=[say(f'{n}')]) for n in (3, 1, 2)))[1]
    assert lines == [f'[INFO] [launch.user]: {n}' for n in (1, 2, 3)]


def test_what_a_timer_visits_sees_the_configurations_of_that_moment(launch_it: Any) -> None:
    timer = TimerAction(period=1.0, actions=[say(LaunchConfiguration('x', default='gone'))])
    group = GroupAction([SetLaunchConfiguration('x', 'inside'), say(LaunchConfiguration('x')), timer])
    assert launch_it(group)[1] == ['[INFO] [launch.user]: inside', '[INFO] [launch.user]: gone']


def test_ctrl_c_ends_the_launch_and_a_second_one_is_ignored(launch_it: Any, host: Any, fresh_simulation: Any) -> None:
    def press(context: Any) -> None:
        fresh_simulation.signals.handlers[signal.SIGINT](signal.SIGINT)

    presses = [
        TimerAction(period=period, actions=[OpaqueFunction(function=press)], cancel_on_shutdown=False) for period in (1.0, 2.0)
    ]
    code, lines = launch_it(ExecuteProcess(cmd=['stubborn']), *presses, noninteractive=True)
    assert code == 0
    assert [line for line in lines if 'ctrl-c' in line] == [
        '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)',
        '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT) again, ignoring...',
    ]
    assert host.log == [
        (0.0, 'start', 'stubborn-1'),
        (1.0, 'SIGINT', 'stubborn-1'),
        (6.0, 'SIGTERM', 'stubborn-1'),
        (11.0, 'SIGKILL', 'stubborn-1'),
    ]


def test_in_a_terminal_ctrl_c_has_reached_the_processes_already(launch_it: Any, host: Any) -> None:
    interrupted = EmitEvent(event=ShutdownEvent(reason='ctrl-c (SIGINT)', due_to_sigint=True))
    launch_it(ExecuteProcess(cmd=['stubborn']), TimerAction(period=1.0, actions=[interrupted]))
    assert [entry[:2] for entry in host.log] == [(0.0, 'start'), (6.0, 'SIGTERM'), (11.0, 'SIGKILL')]


def test_a_keyboard_interrupt_counts_as_ctrl_c(launch_it: Any, host: Any, fresh_simulation: Any) -> None:
    def interrupt() -> None:
        raise KeyboardInterrupt

    sim = fresh_simulation.sim
    sim.schedule(sim.now_ns + 10**9, interrupt)
    code, lines = launch_it(ExecuteProcess(cmd=['forever']), noninteractive=True)
    assert code == 0
    assert '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)' in lines


def test_a_keyboard_interrupt_inside_launch_itself_ends_the_run(launch_it: Any) -> None:
    def interrupt(context: Any) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        launch_it(OpaqueFunction(function=interrupt))


def test_shutdown_from_outside_ends_the_run(host: Any, fresh_simulation: Any) -> None:
    service = LaunchService()
    assert service.shutdown() is None
    service.include_launch_description(LaunchDescription([ExecuteProcess(cmd=['forever'])]))
    sim = fresh_simulation.sim
    sim.schedule(sim.now_ns + 10**9, service.shutdown)
    assert service.run() == 0
    assert host.log == [(0.0, 'start', 'forever-1'), (1.0, 'SIGINT', 'forever-1')]


def test_a_description_may_be_included_while_it_runs(launch_it: Any, capsys: Any, fresh_simulation: Any) -> None:
    service = LaunchService()
    later = LaunchDescription([say('later')])
    sim = fresh_simulation.sim
    sim.schedule(sim.now_ns + 10**9, lambda: service.include_launch_description(later))
    service.include_launch_description(LaunchDescription([TimerAction(period=2.0, actions=[say('end')])]))
    service.run()
    assert capsys.readouterr().out.splitlines()[1:] == ['[INFO] [launch.user]: later', '[INFO] [launch.user]: end']


def test_two_runs_at_once_are_refused(capsys: Any) -> None:
    service = LaunchService()
    errors: list[str] = []

    async def again(context: Any) -> None:
        try:
            await service.run_async()
        except RuntimeError as error:
            errors.append(str(error))

    from launch.actions import OpaqueCoroutine

    service.include_launch_description(LaunchDescription([OpaqueCoroutine(coroutine=again)]))
    assert service.run() == 0
    assert errors == ['LaunchService cannot be run multiple times concurrently.']


def test_only_the_main_thread_may_run_it() -> None:
    errors: list[str] = []

    def run() -> None:
        try:
            LaunchService().run()
        except RuntimeError as error:
            errors.append(str(error))

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    assert errors == ['LaunchService can only be run in the main thread.']


def test_run_async_works_on_a_loop_of_real_time(capsys: Any) -> None:
    service = LaunchService()
    service.include_launch_description(LaunchDescription([TimerAction(period=3600.0, actions=[say('late')])]))
    assert asyncio.run(service.run_async()) == 0
    assert capsys.readouterr().out.splitlines()[1:] == ['[INFO] [launch.user]: late']


def test_a_cancelled_run_says_so(capsys: Any) -> None:
    from edulaunch.engine.sim.aio import new_event_loop

    service, loop = LaunchService(), new_event_loop()
    task = loop.create_task(service.run_async(shutdown_when_idle=False))
    loop.call_later(1.0, task.cancel)
    assert loop.run_until_complete(task) == 1
    loop.close()
    assert capsys.readouterr().out.splitlines()[-1] == '[ERROR] [launch]: run task was canceled'


def test_two_launches_in_one_simulation_do_not_share_anything(fresh_simulation: Any) -> None:
    """Each in a process of its own: numbers, loggers and environments are separate, and they take turns."""
    from edulaunch.engine.processes import ProcessSpec
    from edulaunch.engine.processes.process import Process

    outputs: dict[str, str] = {'a': '', 'b': ''}

    def main(process: Any) -> int:
        service = LaunchService()
        service.include_launch_description(
            LaunchDescription([TimerAction(period=float(n), actions=[say(f'{process.name} {n}')]) for n in (1, 2)])
        )
        return service.run()

    for name in outputs:
        process = Process(fresh_simulation.host, ProcessSpec(argv=(name,), name=name), 1, [name], main)
        process.on_output = lambda stream, text, name=name: outputs.__setitem__(name, outputs[name] + text)
        process.lifecycle.task.start()
    fresh_simulation.sim.run()
    assert {name: text.splitlines()[1:] for name, text in outputs.items()} == {
        name: [f'[INFO] [launch.user]: {name} 1', f'[INFO] [launch.user]: {name} 2'] for name in outputs
    }


def test_a_thread_of_a_simulated_process_is_not_its_main_thread(fresh_simulation: Any) -> None:
    errors: list[str] = []

    def run() -> None:
        with pytest.raises(RuntimeError) as error:
            LaunchService().run()
        errors.append(str(error.value))

    Task(fresh_simulation.sim, run, owner=fresh_simulation).start()
    fresh_simulation.sim.run()
    assert errors == ['LaunchService can only be run in the main thread.']


def test_debug_shows_events(capsys: Any) -> None:
    service = LaunchService(debug=True)
    service.include_launch_description(LaunchDescription())
    service.run()
    lines = capsys.readouterr().out.splitlines()
    emitted = "emitting event synchronously: 'launch.events.IncludeLaunchDescription'"
    assert lines[0] == f'[DEBUG] [launch.launch_context]: {emitted}'
    assert lines[1] == '[INFO] [launch]: Default logging verbosity is set to DEBUG'
    assert any(line.startswith("[DEBUG] [launch]: processing event: '") and ' ✓ ' in line for line in lines)


def test_the_exceptions_of_a_launch_are_kept_for_the_session(launch_it: Any, fresh_simulation: Any) -> None:
    launch_it(say(LaunchConfiguration('missing')))
    [error] = fresh_simulation.state['launch.exceptions']
    assert str(error) == "launch configuration 'missing' does not exist"
