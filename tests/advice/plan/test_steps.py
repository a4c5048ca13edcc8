"""What is told of one step."""

from __future__ import annotations

import json
from types import SimpleNamespace
from typing import Any

import pytest
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.events import Shutdown, TimerEvent
from launch.events.process import ProcessExited, ProcessStarted
from launch.substitution import Substitution
from launch.substitutions import AndSubstitution, Command, LaunchConfiguration, NotSubstitution, PythonExpression

from edulaunch.advice.plan.steps import LONGEST_VALUE, Step, _plain, configurations_in, is_repeatable, row_of, waits_for
from edulaunch.engine.processes.spec import Origin


@pytest.mark.parametrize(
    ('condition', 'names'),
    [
        (IfCondition(LaunchConfiguration('a')), ['a']),
        (UnlessCondition(PythonExpression(["'", LaunchConfiguration('a'), "' == '", LaunchConfiguration('b'), "'"])), ['a', 'b']),
        (IfCondition(AndSubstitution(LaunchConfiguration('a'), NotSubstitution(LaunchConfiguration('b')))), ['a', 'b']),
        (IfCondition('false'), []),
    ],
)
def test_the_launch_configurations_that_a_condition_reads(condition: Any, names: list[str]) -> None:
    assert list(configurations_in(condition)) == names


@pytest.mark.parametrize(
    ('handler', 'words'),
    [
        (OnProcessExit(on_exit=[]), 'the end of any process'),
        (OnProcessStart(target_action=ExecuteProcess(cmd=['a', 'b']), on_start=[]), "the start of ExecuteProcess 'a' 'b'"),
        (OnProcessIO(on_stdout=lambda event: None), 'output of any process'),
        (OnExecutionComplete(on_completion=[]), 'the execution of any action'),
        (OnShutdown(on_shutdown=[]), 'the shutdown of the launch'),
    ],
)
def test_what_a_handler_waits_for(handler: Any, words: str) -> None:
    assert waits_for(handler) == words


def test_a_row_is_plain_data_and_long_values_are_cut() -> None:
    step = Step(RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg='x')])))
    step.changes = {'configurations': {'robot': 'x' * 10_000, 'gone': None, 'list': [('a', 'b')], 'odd': object}}
    row = json.loads(json.dumps(row_of(step)))
    changes = row['changes']['configurations']
    assert len(changes['robot']) == LONGEST_VALUE + 1
    assert (changes['gone'], changes['list'], changes['odd']) == (None, [['a', 'b']], "<class 'object'>")
    assert (row['state'], row['time'], row['order']) == ('waiting', None, 0)


class Mine(Substitution):
    """A substitution of a student."""


@pytest.mark.parametrize(
    ('value', 'answer'),
    [
        ('text', True),
        (3, True),
        (LaunchConfiguration('a'), True),
        (PythonExpression(['1']), False),
        (Command(['ls']), False),
        (Mine(), False),
        ([LaunchConfiguration('a'), [Command(['ls'])]], False),
        ({'a': (LaunchConfiguration('a'),)}, True),
        ({'a': Command(['ls'])}, False),
        ({LaunchConfiguration('a'): Command(['ls'])}, False),
        (NotSubstitution(Command(['ls'])), False),
        (NotSubstitution(LaunchConfiguration('a')), True),
    ],
)
def test_what_can_be_evaluated_again_without_an_effect(value: Any, answer: bool) -> None:
    assert is_repeatable(value) is answer


def test_an_item_is_made_once_and_a_file_that_has_changed_is_no_error() -> None:
    made: list[str] = []
    step = Step(LogInfo(msg='x'))
    assert step.item is None
    step.make_item = lambda: made.append('made') or {'kind': 'log'}
    assert (step.item, step.item, made) == ({'kind': 'log'}, {'kind': 'log'}, ['made'])
    given = Step(LogInfo(msg='x'))
    given.make_item = lambda: {'kind': 'other'}
    given.item = {'kind': 'log'}
    assert given.item == {'kind': 'log'}
    broken = Step(LogInfo(msg='x'))

    def fail() -> Any:
        raise ValueError('gone')

    broken.make_item = fail
    assert broken.item == {'kind': 'action', 'name': 'LogInfo (gone)'}


@pytest.mark.parametrize(
    ('event', 'text'),
    [
        (SimpleNamespace(process_name='a-1'), 'SimpleNamespace of a-1'),
        (SimpleNamespace(), 'SimpleNamespace'),
        (Shutdown(reason='enough'), 'shutdown: enough'),
        (ProcessStarted(action=None, name='a-1', cmd=[], cwd=None, env=None, pid=3), 'a-1 started'),
        (ProcessExited(action=None, name='a-1', cmd=[], cwd=None, env=None, pid=3, returncode=-2), 'a-1 ended with exit code -2'),
        (TimerEvent(timer_action=None), 'the timer ran out'),
    ],
)
def test_an_event_in_words(event: Any, text: str) -> None:
    row = row_of(Step(event))
    assert (row['kind'], row['event'], row['text'], row['details']) == ('event', type(event).__name__, text, [])
    assert 'about' not in row


def test_an_event_of_a_timer_names_its_line() -> None:
    step, timer = Step(TimerEvent(timer_action=None)), Step(LogInfo(msg='x'))
    timer.origin, timer.number, step.about = Origin('a.launch.py', 7), 4, timer
    assert (row_of(step)['text'], row_of(step)['about']) == ('the timer of line 7 ran out', 4)


def test_a_row_leaves_out_what_is_not_known() -> None:
    step = Step(LogInfo(msg='x'))
    assert list(row_of(step)) == ['kind', 'text', 'file', 'line', 'details', 'number', 'parent', 'state', 'time', 'order']
    step.number, step.parent, step.state, step.at_ns, step.order = 3, 1, 'taken', 5, 2
    step.runs, step.fired, step.fired_ns, step.due_ns, step.error = ([9, 1, None, None],), (4,), (8,), 6, 'odd'
    step.handlers = [OnShutdown(on_shutdown=[])]
    row = row_of(step)
    assert {name: row[name] for name in ('number', 'parent', 'state', 'time', 'order', 'runs', 'fired', 'fired_at', 'due')} == {
        'number': 3,
        'parent': 1,
        'state': 'taken',
        'time': 5,
        'order': 2,
        'runs': [[9, 1, None, None]],
        'fired': [4],
        'fired_at': [8],
        'due': 6,
    }
    assert (row['error'], row['handlers'], step.is_running) == ('odd', ['the shutdown of the launch'], True)
    step.runs = ([9, 1, 2, 0],)
    assert not step.is_running and not Step(LogInfo(msg='x')).is_running


@pytest.mark.parametrize(
    ('value', 'plain'),
    [(1.5, 1.5), (float('nan'), 'nan'), (float('-inf'), '-inf'), (True, True), (list(range(300)), list(range(200)))],
)
def test_values_are_plain_data(value: Any, plain: Any) -> None:
    assert _plain(value) == plain
    assert (len(_plain('x' * LONGEST_VALUE)), len(_plain('x' * (LONGEST_VALUE + 1)))) == (LONGEST_VALUE, LONGEST_VALUE + 1)
