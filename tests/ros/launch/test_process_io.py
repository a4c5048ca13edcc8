"""Which stream of a process an event with bytes is about."""

from __future__ import annotations

import pytest
from launch.actions import ExecuteProcess
from launch.events.process import ProcessIO


@pytest.mark.parametrize(('fd', 'streams'), [(0, (True, False, False)), (1, (False, True, False)), (2, (False, False, True))])
def test_the_descriptor_says_which_stream_it_is(fd: int, streams: tuple[bool, bool, bool]) -> None:
    event = ProcessIO(action=ExecuteProcess(cmd=['a']), name='a-1', cmd=['a'], cwd=None, env=None, pid=1, text=b'hello', fd=fd)
    assert (event.from_stdin, event.from_stdout, event.from_stderr) == streams and event.text == b'hello'
