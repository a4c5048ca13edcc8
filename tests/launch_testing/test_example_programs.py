"""The example programs, and claims about real runs of them."""

from __future__ import annotations

import os
import sys
from typing import Any

import pytest
from ament_index_python import get_package_prefix
from launch import LaunchDescription, LaunchService
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessIO
from launch_testing import IoHandler, ProcInfoHandler, asserts
from launch_testing.util import NoMatchingProcessException, resolveProcesses


def program(executable: str, *arguments: str, **options: Any) -> ExecuteProcess:
    path = os.path.join(get_package_prefix('launch_testing'), 'lib', 'launch_testing', executable)
    return ExecuteProcess(cmd=[sys.executable, path, *arguments], **options)


def run(*processes: ExecuteProcess) -> tuple[ProcInfoHandler, IoHandler]:
    info, output = ProcInfoHandler(), IoHandler()
    service = LaunchService()
    service.include_launch_description(
        LaunchDescription(
            [
                RegisterEventHandler(OnProcessIO(on_stdout=output.append, on_stderr=output.append)),
                RegisterEventHandler(OnProcessExit(on_exit=lambda event, context: info.append(event))),
                *processes,
            ]
        )
    )
    assert service.run() == 0
    return info, output


def test_programs_write_and_end_as_they_should() -> None:
    info, output = run(
        program('good_proc', name='good'),
        program('terminating_proc', '--exception', name='bad'),
        program('exit_code_proc', '--exit-code', '42', name='code'),
    )
    with asserts.assertSequentialStdout(output, 'good') as checker:
        for text in ('Starting Up', 'Loop 0', 'Loop 9', 'Shutting Down'):
            checker.assertInStdout(text)
    asserts.assertInStderr(output, 'Process had a pretend error', 'bad')
    asserts.assertInStderr(output, 'Exiting with a code 42', 'code')
    assert {name.partition('-')[0]: info[name].returncode for name in info.process_names()} == {  # type: ignore[attr-defined]
        'good': 0,
        'bad': 1,
        'code': 42,
    }


def test_processes_are_told_apart_by_their_arguments() -> None:
    plain, extra = program('terminating_proc'), program('terminating_proc', '--extra')
    info, output = run(plain, extra)
    assert resolveProcesses(info, process='python', cmd_args='--extra') == [extra]
    asserts.assertInStdout(output, 'Ready', 'python', strict_proc_matching=False)
    with pytest.raises(
        ValueError, match=r'Found multiple processes .* Procs: python\S*-\d+ \S+terminating_proc, \S+ \S+ --extra'
    ):
        asserts.assertInStdout(output, 'Ready', 'python')
    with pytest.raises(NoMatchingProcessException, match="name 'nobody'"):
        asserts.assertInStdout(output, 'Ready', 'nobody')
