"""The small actions: configurations, environment, functions, coroutines, events, timers."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from launch import Event, EventHandler
from launch.actions import (
    AppendEnvironmentVariable,
    DeclareLaunchArgument,
    EmitEvent,
    GroupAction,
    LogInfo,
    OpaqueCoroutine,
    OpaqueFunction,
    RegisterEventHandler,
    ResetLaunchConfigurations,
    SetEnvironmentVariable,
    SetLaunchConfiguration,
    Shutdown,
    TimerAction,
    UnregisterEventHandler,
    UnsetEnvironmentVariable,
    UnsetLaunchConfiguration,
)
from launch.event_handlers import OnShutdown, event_named
from launch.substitutions import EnvironmentVariable, LaunchConfiguration


def conf(name: str) -> LaunchConfiguration:
    return LaunchConfiguration(name, default='-')


def say(*parts: Any) -> LogInfo:
    return LogInfo(msg=parts)


def said(result: tuple[int, list[str]]) -> list[str]:
    return [line.removeprefix('[INFO] [launch.user]: ') for line in result[1]]


def test_a_declared_argument_keeps_a_value_that_is_set(launch_it: Any) -> None:
    assert said(
        launch_it(
            SetLaunchConfiguration('a', '1'),
            DeclareLaunchArgument('a', default_value='2'),
            DeclareLaunchArgument('b', default_value=['x', conf('a')]),
            say(conf('a'), conf('b')),
        )
    ) == ['1x1']


def test_a_required_argument_that_is_missing_is_logged_and_raised(launch_it: Any) -> None:
    code, lines = launch_it(DeclareLaunchArgument('a', description='why'))
    assert code == 1
    assert lines[0] == (
        '[ERROR] [launch.actions.declare_launch_argument]: Required launch argument "a" (description: "why") was not provided'
    )
    assert lines[1].endswith('Required launch argument "a" was not provided.')


@pytest.mark.parametrize(
    ('kwargs', 'description'),
    [
        ({}, 'no description given'),
        ({'choices': ['a', 'b']}, "One of: ['a', 'b']"),
        ({'description': 'A x', 'choices': ['a']}, "A x. Valid choices are: ['a']"),
        ({'description': 'A x.', 'choices': ['a']}, "A x. Valid choices are: ['a']"),
    ],
)
def test_descriptions_name_the_choices(kwargs: Any, description: str) -> None:
    assert DeclareLaunchArgument('x', **kwargs).description == description


@pytest.mark.parametrize(
    ('kwargs', 'text'),
    [
        ({'choices': []}, 'Provided choices arg is empty. Use None to ignore the choice list.'),
        ({'choices': ['a'], 'default_value': 'b'}, 'Provided default_value "b" is not in provided choices "[\'a\']".'),
    ],
)
def test_choices_that_cannot_be_are_logged_too(launch_it: Any, kwargs: Any, text: str) -> None:
    code, lines = launch_it(OpaqueFunction(function=lambda context: [DeclareLaunchArgument('x', **kwargs)]))
    assert (code, lines[0]) == (1, f'[ERROR] [launch.actions.declare_launch_argument]: {text}')
    assert lines[1].endswith(text)


def test_a_scoped_group_undoes_configurations_and_environment(launch_it: Any) -> None:
    inside = [SetLaunchConfiguration('a', '1'), SetEnvironmentVariable('E', '1')]
    after = say(conf('a'), EnvironmentVariable('E', default_value='-'))
    assert said(launch_it(GroupAction(inside), after, GroupAction(inside, scoped=False), after)) == ['--', '11']


def test_a_group_without_forwarding_sees_only_what_it_is_given(launch_it: Any) -> None:
    group = GroupAction([say(conf('a'), conf('b'), conf('c'))], forwarding=False, launch_configurations={'c': conf('a')})
    assert said(launch_it(SetLaunchConfiguration('a', '1'), SetLaunchConfiguration('b', '2'), group, say(conf('b')))) == [
        '--1',
        '2',
    ]


def test_configurations_can_be_unset_and_reset(launch_it: Any) -> None:
    assert said(
        launch_it(
            SetLaunchConfiguration('a', '1'),
            UnsetLaunchConfiguration('a'),
            UnsetLaunchConfiguration('never'),
            say(conf('a')),
            SetLaunchConfiguration('a', '2'),
            SetLaunchConfiguration('b', '3'),
            ResetLaunchConfigurations({'a': conf('b')}),
            say(conf('a'), conf('b')),
        )
    ) == ['-', '3-']


def test_environment_variables_are_set_appended_and_unset(launch_it: Any) -> None:
    show = say(EnvironmentVariable('P', default_value='-'))
    assert said(
        launch_it(
            SetEnvironmentVariable('P', 'b'),
            AppendEnvironmentVariable('P', 'c'),
            AppendEnvironmentVariable('P', 'a', prepend=True, separator=';'),
            show,
            AppendEnvironmentVariable('P', 'z', prepend='false', separator=','),
            show,
            UnsetEnvironmentVariable('P'),
            show,
        )
    ) == ['a;b:c', 'a;b:c,z', '-']


def test_an_opaque_function_gets_context_and_arguments_and_may_return_entities(launch_it: Any) -> None:
    def build(context: Any, word: str, *, end: str) -> Any:
        return [say(context.launch_configurations['a'], word, end)]

    assert said(launch_it(SetLaunchConfiguration('a', '1'), OpaqueFunction(function=build, args=['2'], kwargs={'end': '3'}))) == [
        '123'
    ]


def test_a_coroutine_runs_in_simulated_time_and_ends_with_the_launch(launch_it: Any, fresh_simulation: Any) -> None:
    log: list[Any] = []

    async def count(context: Any) -> None:
        try:
            while True:
                await asyncio.sleep(1.0)
                log.append(fresh_simulation.sim.elapsed_s)
        finally:
            log.append('cancelled')

    launch_it(OpaqueCoroutine(coroutine=count), TimerAction(period=2.5, actions=[Shutdown()]))
    assert log == [1.0, 2.0, 'cancelled']


def test_an_error_in_a_coroutine_ends_the_launch_with_one(launch_it: Any) -> None:
    async def fail(text: str) -> None:
        raise ValueError(text)

    code, lines = launch_it(OpaqueCoroutine(coroutine=fail, args=['oh'], ignore_context=True))
    assert code == 1
    assert lines[0] == '[ERROR] [launch]: Caught exception in launch (see debug for traceback): oh'


def test_only_coroutine_functions_are_accepted() -> None:
    with pytest.raises(TypeError, match="OpaqueCoroutine expected a coroutine function for 'coroutine'"):
        OpaqueCoroutine(coroutine=lambda: None)  # type: ignore[arg-type,return-value]


def test_own_events_are_emitted_and_handled_until_unregistered(launch_it: Any) -> None:
    class Mine(Event):
        name = 'mine'

    handler = EventHandler(matcher=event_named('mine'), entities=[say('got it')])
    assert said(
        launch_it(
            RegisterEventHandler(handler),
            EmitEvent(event=Mine()),
            TimerAction(period=1.0, actions=[UnregisterEventHandler(handler), EmitEvent(event=Mine())]),
        )
    ) == ['got it']


def test_a_handler_sees_only_later_events(launch_it: Any) -> None:
    timers = [TimerAction(period=float(n), actions=[Shutdown(reason=str(n))]) for n in (1, 2)]
    assert said(launch_it(*timers, RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: say(event.reason))))) == [
        '1'
    ]


def test_a_timer_is_cancelled_by_a_shutdown_unless_told_otherwise(launch_it: Any) -> None:
    assert said(
        launch_it(
            TimerAction(period=2.0, actions=[say('cancelled')]),
            TimerAction(period=3.0, actions=[say('kept')], cancel_on_shutdown=False),
            TimerAction(period=1.0, actions=[Shutdown()]),
        )
    ) == ['kept']


def test_a_timer_can_be_cancelled_before_and_while_it_waits(launch_it: Any) -> None:
    before, during = (TimerAction(period=2.0, actions=[say('never')]) for _ in range(2))
    before.cancel()
    stop = OpaqueFunction(function=lambda context: during.cancel())
    assert launch_it(before, during, TimerAction(period=1.0, actions=[stop])) == (0, [])


def test_a_period_may_be_a_substitution_that_is_wrong(launch_it: Any) -> None:
    code, lines = launch_it(SetLaunchConfiguration('p', 'soon'), TimerAction(period=LaunchConfiguration('p'), actions=[]))
    assert code == 1
    assert lines[0].endswith("could not convert string to float: 'soon'")


def test_a_text_as_period_is_deprecated() -> None:
    with pytest.warns(UserWarning, match="The parameter 'period' must be a float or substitution"):
        timer = TimerAction(period='2', actions=[])
    assert (timer.period, timer.describe()) == (2.0, 'TimerAction(period=2.0, actions=<actions>)')
    assert timer.describe_conditional_sub_entities() == [('2.0 seconds pass without being canceled', [])]


def test_shutdown_event_has_the_reason_when_it_is_a_plain_text() -> None:
    assert Shutdown(reason='enough').event.reason == 'enough'  # type: ignore[attr-defined]
