"""Claims about processes: what they accept, and the texts with which they fail."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import launch_testing
import pytest
from launch.actions import ExecuteProcess
from launch.events.process import ProcessExited, ProcessStarted, ProcessStderr, ProcessStdout
from launch.launch_context import LaunchContext
from launch_testing.asserts import (
    NO_CMD_ARGS,
    assertExitCodes,
    assertInStderr,
    assertInStdout,
    assertInStream,
    assertSequentialStdout,
)
from launch_testing.util import NoMatchingProcessException, resolveProcesses


class World:
    """Three processes: two talkers that wrote something, and one that died."""

    def __init__(self) -> None:
        self.info = launch_testing.ProcInfoHandler()
        self.output = launch_testing.IoHandler()
        self.talker = self.add('talker', ['--fast'], b'one\ntwo\n\x1b[31mthree\x1b[0m\n', b'warning: slow\n', 0)
        self.second = self.add('talker', [], b'four\n', b'', None)
        self.dead = self.add('crash', ['a', 'b'], b'', b'boom\n', 3)

    def add(self, name: str, arguments: list[str], stdout: bytes, stderr: bytes, code: int | None) -> Any:
        action = ExecuteProcess(cmd=[name, *arguments])
        action.prepare(LaunchContext())
        details = {**(action.process_details or {}), 'pid': 1}
        self.output.track(action)
        for event, text in ((ProcessStdout, stdout), (ProcessStderr, stderr)):
            self.output.append(event(text=text, **details))
        self.info.append(ProcessStarted(**details) if code is None else ProcessExited(returncode=code, **details))
        return action


@pytest.fixture
def world() -> World:
    return World()


def failure(claim: Callable[[], object]) -> str:
    with pytest.raises(AssertionError) as error:
        claim()
    return re.sub(r'-\d+', '', str(error.value))


def test_exit_codes(world: World) -> None:
    assertExitCodes(world.info, process=world.talker)
    assertExitCodes(world.info, allowable_exit_codes=[0, 3], process='crash')
    assert failure(lambda: assertExitCodes(world.info, process='crash')) == 'Proc crash exited with code 3'
    assert failure(lambda: assertExitCodes(world.info, process=world.second)) == (
        'Proc talker has not ended: it has no exit code yet'
    )
    with pytest.raises(TypeError, match='must contain integers'):
        assertExitCodes(world.info, allowable_exit_codes=['0'])  # type: ignore[list-item]


def test_output_of_a_stream(world: World) -> None:
    assertInStdout(world.output, 'two', world.talker)
    assertInStderr(world.output, re.compile('w.*slow'), world.talker)
    assertInStdout(world.output, ['one', 'three'], world.talker)
    assertInStream(world.output, 'boom')
    assert failure(lambda: assertInStdout(world.output, ['two', 'one'], world.talker)).startswith("Did not find '['two', 'one']'")
    assert failure(lambda: assertInStdout(world.output, 'boom', 'crash')) == (
        "Did not find 'boom' in output for any of the matching processes: crash"
    )
    with pytest.raises(ValueError, match="must be 'stdout' or 'stderr', got 'both'"):
        assertInStream(world.output, 'one', world.talker, stream='both')


def test_colours_are_left_out_unless_wanted(world: World) -> None:
    assertInStdout(world.output, 'two\nthree', world.talker)
    failure(lambda: assertInStdout(world.output, 'two\nthree', world.talker, strip_ansi_escape_sequences=False))


def test_output_in_order(world: World) -> None:
    with assertSequentialStdout(world.output, world.talker) as checker:
        checker.assertInStdout('one')
        checker.assertInStdout(re.compile('t.o'))
        assert failure(lambda: checker.assertInStdout('one')) == (
            "'one' was not found in the output after character 7\n  help: it was not written there, only before it"
        )


def test_processes_are_found_by_name_and_arguments(world: World) -> None:
    assert resolveProcesses(world.info, process='talker', cmd_args='--fast') == [world.talker]
    assert resolveProcesses(world.info, process='talker', cmd_args=NO_CMD_ARGS) == [world.second]
    assert resolveProcesses(world.info, process='crash', cmd_args=['b', 'a']) == [world.dead]
    assert resolveProcesses(world.info, process='talker', strict_proc_matching=False) == [world.talker, world.second]
    assert len(resolveProcesses(world.info)) == 3


def test_processes_that_are_not_found(world: World) -> None:
    with pytest.raises(ValueError, match="Found multiple processes matching name 'talker'"):
        resolveProcesses(world.info, process='talker')
    with pytest.raises(NoMatchingProcessException, match="Did not find any processes matching name 'listener'"):
        resolveProcesses(world.info, process='listener')
    with pytest.raises(NoMatchingProcessException, match='No data recorded for proc ExecuteProcess'):
        resolveProcesses(world.info, process=ExecuteProcess(cmd=['x']))
    with pytest.raises(TypeError, match="must be 'ExecuteProcess' or 'str' not <class 'int'>"):
        resolveProcesses(world.info, process=3)


def test_handlers_are_asked_by_action_or_name(world: World) -> None:
    assert world.info[world.dead].returncode == 3  # type: ignore[attr-defined]
    assert world.info['crash'] is world.info[world.dead]
    assert [piece.text for piece in world.output['crash']] == [b'', b'boom\n']
    assert [name.partition('-')[0] for name in world.info.process_names()] == ['talker', 'talker', 'crash']
    assert world.output.processes() == [world.talker, world.second, world.dead]
    with pytest.raises(KeyError):
        world.info['nobody']
