"""Locals, stacks and events of a context."""

from __future__ import annotations

import asyncio
import subprocess
import sys
from typing import Any

import pytest
from launch import Condition, Event, EventHandler, LaunchContext
from launch.actions import LogInfo
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration
from launch.utilities import is_a_subclass, isclassinstance

from edulaunch.engine.underlay_place import underlay_python


def test_locals_are_read_through_attributes_and_hide_globals() -> None:
    context = LaunchContext()
    context.extend_globals({'a': 1, 'b': 1})
    context.extend_locals({'b': 2})
    assert (context.locals.a, context.locals.b, context.get_locals_as_dict()) == (1, 2, {'a': 1, 'b': 2})


def test_a_missing_local_is_an_error_that_lists_the_others() -> None:
    context = LaunchContext()
    context.extend_locals({'a': 1, 'b': 2})
    with pytest.raises(AttributeError, match=r"context.locals does not contain attribute 'x', it contains: \[a, b\]"):
        _ = context.locals.x
    with pytest.raises(AttributeError):
        context.locals.x = 1


@pytest.mark.parametrize('what', ['locals', 'environment', 'launch_configurations'])
def test_popping_too_often_is_an_error(what: str) -> None:
    with pytest.raises(RuntimeError, match=f'{what} stack unexpectedly empty'):
        getattr(LaunchContext(), f'_pop_{what}')()


def test_the_environment_can_be_pushed_popped_and_reset(fresh_simulation: Any) -> None:
    context = LaunchContext()
    context._push_environment()
    context.environment['NEW'] = '1'
    assert fresh_simulation.env['NEW'] == '1'
    context._pop_environment()
    assert 'NEW' not in context.environment
    context.environment['NEW'] = '2'
    context._reset_environment()
    assert 'NEW' not in fresh_simulation.env


def test_a_pushed_copy_shares_lists_inside() -> None:
    context = LaunchContext()
    context.launch_configurations['list'] = [1]
    context._push_launch_configurations()
    context.launch_configurations['list'].append(2)
    context._pop_launch_configurations()
    assert context.launch_configurations == {'list': [1, 2]}


def test_the_newest_handler_comes_first_unless_appended() -> None:
    context = LaunchContext()
    handlers = [EventHandler(matcher=lambda event: True) for _ in range(3)]
    context.register_event_handler(handlers[0])
    context.register_event_handler(handlers[1])
    context.register_event_handler(handlers[2], append=True)
    assert list(context._event_handlers) == [handlers[1], handlers[0], handlers[2]]


def test_a_handler_for_one_event_forgets_itself() -> None:
    context = LaunchContext()
    handler = EventHandler(matcher=lambda event: True, entities=LogInfo(msg='x'), handle_once=True)
    context.register_event_handler(handler)
    event = Event()
    assert context.would_handle_event(event)
    assert handler.handle(event, context) is handler.entities
    assert context.locals.event is event
    assert not context.would_handle_event(event)


def test_events_wait_in_a_queue() -> None:
    context = LaunchContext()
    first, second = Event(), Event()
    context.emit_event_sync(first)
    asyncio.run(context.emit_event(second))
    assert [context._event_queue.get_nowait() for _ in range(2)] == [first, second]


def test_a_handler_of_any_class_can_be_registered() -> None:
    context, handler = LaunchContext(), object()
    context.register_event_handler(handler)  # type: ignore[arg-type]
    assert list(context._event_handlers) == [handler]
    context.unregister_event_handler(handler)  # type: ignore[arg-type]
    with pytest.raises(ValueError):
        context.unregister_event_handler(handler)  # type: ignore[arg-type]


def test_conditions_describe_themselves() -> None:
    described = [kind(LaunchConfiguration('x')).describe() for kind in (IfCondition, UnlessCondition)]
    assert described == ["IfCondition(LaunchConfig('x'))", "UnlessCondition(LaunchConfig('x'))"]
    assert Condition().describe() == '<launch.condition.Condition object at 0x>'


def test_everything_is_an_instance_of_a_class() -> None:
    assert [isclassinstance(one) for one in (0, None, 'foo', {}, LaunchContext())] == [True] * 5
    assert (is_a_subclass(1, int), is_a_subclass(int, int), is_a_subclass(1, float)) == (True, True, False)


@pytest.mark.processes
def test_the_underlay_alone_is_enough_for_launch_and_its_interfaces() -> None:
    code = (
        'import launch.actions, osrf_pycommon, launch_ros; osrf_pycommon.process_utils.get_loop\n'
        'import lifecycle_msgs.msg, composition_interfaces.srv, builtin_interfaces.msg'
    )
    done = subprocess.run(
        [sys.executable, '-c', f'import sys; sys.path.insert(0, {underlay_python()!r})\n{code}'], capture_output=True, text=True
    )
    assert (done.returncode, done.stderr) == (0, '')
