"""Filters of log calls, names and levels of loggers."""

from __future__ import annotations

from typing import Any

import pytest
from rclpy.clock import Clock
from rclpy.impl.logging_severity import LoggingSeverity
from rclpy.impl.logging_state import logging_state
from rclpy.impl.rcutils_logger import CallSite, RcutilsLogger, filters_of

S = 1_000_000_000


@pytest.mark.parametrize(
    ('options', 'filters'),
    [
        ({}, ()),
        ({'once': True}, ('once',)),
        ({'once': False}, ()),
        ({'skip_first': True, 'once': True}, ('skip_first', 'once')),
        ({'throttle_duration_sec': 1}, ('throttle',)),
        ({'throttle_duration_sec': 0}, ()),
        ({'throttle_duration_sec': 0, 'throttle_time_source_type': None}, ()),
    ],
)
def test_options_choose_filters(options: dict[str, Any], filters: tuple[str, ...]) -> None:
    assert filters_of(options) == filters


@pytest.mark.parametrize(
    ('options', 'error', 'text'),
    [
        ({'throttle_time_source_type': 'ros'}, TypeError, 'required parameter "throttle_duration_sec" not specified'),
        ({'ones': True}, TypeError, 'parameter "ones" is not one of the recognized logging options'),
        ({'throttle_duration_sec': 1, 'throttle_time_source_type': 'ros'}, ValueError, 'of "ros" is not a clock instance'),
    ],
)
def test_wrong_options_are_refused(options: dict[str, Any], error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        filters_of(options)


def passes(options: dict[str, Any], times_ns: list[int]) -> list[bool]:
    site = CallSite('a', 20, filters_of(options), options)
    return [site.lets_through(options, time_ns) for time_ns in times_ns]


def test_filters_let_calls_through_by_their_number_and_time() -> None:
    assert passes({}, [0, 0]) == [True, True]
    assert passes({'once': True}, [0, 0, 0]) == [True, False, False]
    assert passes({'skip_first': True}, [0, 0, 0]) == [False, True, True]
    assert passes({'skip_first': True, 'once': True}, [0, 0, 0]) == [False, True, False]
    times = [0, S - 1, S, S + 1, 2 * S - 1, 2 * S, 5 * S]
    assert passes({'throttle_duration_sec': 1}, times) == [False, False, True, False, False, True, True]


def test_a_clock_may_tell_the_time_of_a_throttle() -> None:
    class Stopped(Clock):
        def rcl_now_ns(self) -> int:
            return 3 * S

    assert passes({'throttle_duration_sec': 1, 'throttle_time_source_type': Stopped()}, [9 * S, 20 * S]) == [True, False]


@pytest.mark.parametrize(
    ('name', 'severity', 'options', 'text'),
    [
        ('a', 30, {'once': True}, 'Logger severity cannot be changed'),
        ('b', 20, {'once': True}, 'Logger name cannot be changed'),
        ('a', 20, {'skip_first': True}, 'Requested logging filters cannot be changed'),
        ('a', 20, {'once': 1.5}, 'Logging filter parameters cannot be changed'),
    ],
)
def test_a_place_of_the_code_keeps_its_options(name: str, severity: int, options: dict[str, Any], text: str) -> None:
    site = CallSite('a', 20, ('once',), {'once': True})
    site.check('a', 20, ('once',), {'once': True})
    with pytest.raises(ValueError, match=text):
        site.check(name, severity, filters_of(options), options)


def test_a_child_has_its_parents_name_and_topic() -> None:
    with pytest.raises(ValueError, match='must not be empty'):
        RcutilsLogger('a').get_child('')
    assert RcutilsLogger().get_child('a').name == 'a'
    state = logging_state()
    state.rosout['checked'] = 'its publisher'
    try:
        assert RcutilsLogger('checked').get_child('b').name == 'checked.b'
        assert state.rosout.pop('checked.b') == 'its publisher'
        assert RcutilsLogger('other').get_child('b').name not in state.rosout
    finally:
        del state.rosout['checked']


def test_levels_are_inherited_by_the_parts_of_a_name() -> None:
    parent, child = RcutilsLogger('levels'), RcutilsLogger('levels.a.b')
    assert (parent.get_effective_level(), child.is_enabled_for(20), child.is_enabled_for(10)) == (
        LoggingSeverity.INFO,
        True,
        False,
    )
    parent.set_level(40)
    assert (child.get_effective_level(), child.is_enabled_for(30), child.is_enabled_for(LoggingSeverity.ERROR)) == (
        40,
        False,
        True,
    )
    child.set_level(LoggingSeverity.DEBUG)
    assert (child.is_enabled_for(10), parent.is_enabled_for(10)) == (True, False)
    child.set_level(0)
    parent.set_level(LoggingSeverity.UNSET)
    assert child.get_effective_level() == LoggingSeverity.INFO


@pytest.mark.parametrize('level', ['debug', 'info', 'warning', 'warn', 'error', 'fatal'])
def test_a_call_says_whether_it_logged(level: str) -> None:
    logger = RcutilsLogger('calls')
    assert getattr(logger, level)('text') is (level != 'debug')
    assert [logger.info('text', once=True) for _ in range(2)] == [True, False]
    assert [logger.info('text', name='other', skip_first=True) for _ in range(2)] == [False, True]
    assert logger.log('text', 50) is True
    with pytest.raises(TypeError, match='name of a logger must be a str, not int'):
        logger.info('text', name=3)
    with pytest.raises(TypeError, match='log message must be a str, not int'):
        logger.info(3)  # type: ignore[arg-type]
