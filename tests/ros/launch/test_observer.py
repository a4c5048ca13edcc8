"""What a launch service tells its observer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from launch.actions import GroupAction, LogInfo, RegisterEventHandler
from launch.conditions import IfCondition
from launch.event_handlers import OnShutdown
from launch.substitutions import LaunchConfiguration


class Log:
    """Writes down what it is told."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def enter(self, entity: Any, context: Any) -> None:
        self.lines.append(f'enter {type(entity).__name__}')

    def leave(self, entity: Any, context: Any, error: Exception | None) -> None:
        self.lines.append(f'leave {type(entity).__name__}' + (f' {error}' if error else ''))

    def instead_of(self, action: Any) -> Any:
        return None

    def executed(self, action: Any, context: Any) -> None:
        self.lines.append(f'executed {type(action).__name__}')

    def leads_to(self, entity: Any, entities: Any) -> None:
        pass

    def event(self, event: Any, context: Any) -> None:
        self.lines.append(f'event {type(event).__name__}')

    def ignores(self, handler: Any, event: Any) -> bool:
        return False

    def answered(self, handler: Any, event: Any, answer: Any) -> None:
        self.lines.append(f'answered {type(handler).__name__}')

    def handled(self, handler: Any, event: Any) -> None:
        self.lines.append(f'handled {type(handler).__name__}')

    def registered(self, handler: Any) -> None:
        self.lines.append(f'registered {type(handler).__name__}')

    def unregistered(self, handler: Any) -> None:
        self.lines.append(f'unregistered {type(handler).__name__}')


@pytest.fixture
def observed(launch_it: Any, fresh_simulation: Any) -> Callable[..., list[str]]:
    def run(*actions: Any) -> list[str]:
        log = Log()
        fresh_simulation.state['launch.observer'] = log
        launch_it(*actions)
        return log.lines

    return run


def test_visits_are_nested_and_a_condition_that_does_not_hold_executes_nothing(observed: Any) -> None:
    lines = observed(GroupAction([LogInfo(msg='a')], scoped=False), LogInfo(msg='b', condition=IfCondition('false')))
    assert [line for line in lines if 'Log' in line or 'Group' in line] == [
        'enter GroupAction',
        'executed GroupAction',
        'enter LogInfo',
        'executed LogInfo',
        'leave LogInfo',
        'leave GroupAction',
        'enter LogInfo',
        'leave LogInfo',
    ]


def test_events_handlers_and_what_they_lead_to(observed: Any) -> None:
    lines = observed(RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg='end')])))
    start = lines.index('event Shutdown')
    assert 'registered OnShutdown' in lines[:start]
    assert lines[start:][:6] == [
        'event Shutdown',
        'answered OnShutdown',
        'enter LogInfo',
        'executed LogInfo',
        'leave LogInfo',
        'handled OnShutdown',
    ]


def test_an_error_leaves_all_that_it_passes(observed: Any) -> None:
    lines = observed(GroupAction([LogInfo(msg=LaunchConfiguration('nowhere'))], scoped=False))
    error = " launch configuration 'nowhere' does not exist"
    assert [line for line in lines if line.startswith('leave ')][:2] == [f'leave LogInfo{error}', f'leave GroupAction{error}']
