"""What is told of one step."""

from __future__ import annotations

import json
from typing import Any

import pytest
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart, OnShutdown
from launch.substitutions import AndSubstitution, LaunchConfiguration, NotSubstitution, PythonExpression

from edulaunch.advice.plan.steps import LONGEST_VALUE, Step, configurations_in, row_of, waits_for


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
