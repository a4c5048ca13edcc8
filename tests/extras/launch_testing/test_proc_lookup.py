"""Which recorded processes a test means; and texts that are found in output."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any

import pytest
from launch.actions import ExecuteLocal, ExecuteProcess
from launch_testing.tools.text import build_text_match
from launch_testing.util.proc_lookup import NO_CMD_ARGS, NoMatchingProcessException, process_name, resolveProcesses


def started(name: str, *arguments: str) -> Any:
    return SimpleNamespace(process_details={'name': name, 'cmd': [f'/bin/{name}', *arguments]})


FIRST, SECOND, THIRD = started('talker-1', '-a', '1'), started('talker-2'), started('listener-3', '-a')
ALL = SimpleNamespace(processes=lambda: [FIRST, SECOND, THIRD])


@pytest.mark.parametrize(
    ('process', 'arguments', 'found'),
    [
        (None, None, [FIRST, SECOND, THIRD]),
        ('listener', None, [THIRD]),
        ('talker-1', None, [FIRST]),
        ('talker', '-a', [FIRST]),
        ('talker', ['-a', '1'], [FIRST]),
        ('talker', NO_CMD_ARGS, [SECOND]),
        ('', '1', [FIRST]),
    ],
)
def test_a_process_is_found_by_a_part_of_its_name_and_its_arguments(process: Any, arguments: Any, found: list[Any]) -> None:
    assert resolveProcesses(ALL, process=process, cmd_args=arguments) == found


@pytest.mark.parametrize(
    ('process', 'arguments', 'problem'),
    [
        ('nothing', None, "matching name 'nothing' and args 'None'. Procs: listener-3 -a, talker-1 -a 1, talker-2"),
        ('talker', ['-a', '2'], 'Procs: listener-3 -a, talker-1 -a 1, talker-2'),
        ('listener', NO_CMD_ARGS, "args 'NO_CMD_ARGS'"),
    ],
)
def test_a_process_that_is_not_there_is_told_with_those_that_are(process: str, arguments: Any, problem: str) -> None:
    with pytest.raises(NoMatchingProcessException, match=re.escape(problem)):
        resolveProcesses(ALL, process=process, cmd_args=arguments)


def test_several_processes_are_too_many_unless_told_otherwise() -> None:
    with pytest.raises(ValueError, match='Found multiple processes.*Procs: talker-1 -a 1, talker-2$'):
        resolveProcesses(ALL, process='talker')
    assert resolveProcesses(ALL, process='talker', strict_proc_matching=False) == [FIRST, SECOND]


def test_an_action_is_found_if_it_was_recorded() -> None:
    mine, other = ExecuteProcess(cmd=['a']), ExecuteProcess(cmd=['b'])
    known = SimpleNamespace(processes=lambda: [mine])
    assert isinstance(mine, ExecuteLocal)
    assert resolveProcesses(known, process=mine) == [mine]
    with pytest.raises(NoMatchingProcessException, match='No data recorded for proc ExecuteProcess'):
        resolveProcesses(known, process=other)
    with pytest.raises(NoMatchingProcessException, match='No data recorded for any process'):
        resolveProcesses(SimpleNamespace(processes=list))
    with pytest.raises(TypeError, match="must be 'ExecuteProcess' or 'str' not <class 'int'>"):
        resolveProcesses(ALL, process=3)
    assert (process_name(FIRST), process_name(other)) == ('talker-1', 'ExecuteProcess')


@pytest.mark.parametrize(
    ('expected', 'text', 'start', 'span'),
    [
        ('b', 'abcb', 0, (1, 2)),
        ('b', 'abcb', 2, (3, 4)),
        ('x', 'abc', 0, None),
        ('a.c', 'abc a.c', 0, (4, 7)),
        (re.compile('a.c'), 'abc a.c', 0, (0, 3)),
        (['a', 'c'], 'abca', 0, (0, 3)),
        (['c', 'a'], 'abca', 0, (2, 4)),
        (['c', 'b'], 'abc', 0, None),
        ([], 'abc', 2, (2, 2)),
        ('red', 'a \x1b[31mred\x1b[0m', 0, (2, 5)),
    ],
)
def test_texts_are_found_in_their_order(expected: Any, text: str, start: int, span: tuple[int, int] | None) -> None:
    assert build_text_match(expected)(text, start) == span


def test_colours_stay_if_they_are_asked_for() -> None:
    assert build_text_match('red', strip_ansi_escape_sequences=False)('a \x1b[31mred', 0) == (7, 10)
    with pytest.raises(ValueError, match='got int: 5'):
        build_text_match(5)
