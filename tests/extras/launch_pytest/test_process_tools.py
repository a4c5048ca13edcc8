"""Waiting for starts, output and ends, in coroutines and in plain functions."""

from __future__ import annotations

from importlib import import_module

import pytest

from .conftest import Run

SLOW = """
@pytest.fixture
def proc():
    return ExecuteProcess(cmd=['python3', 'slow.py'], cwd=__file__.rpartition('/')[0], cached_output=True)
@launch_pytest.fixture
def slow(proc):
    return launch.LaunchDescription([TimerAction(period=2.0, actions=[proc]), ReadyToTest()])
"""
PROGRAM = """
import sys, time
print('one', flush=True)
time.sleep(3)
print('two', file=sys.stderr, flush=True)
time.sleep(3)
sys.exit(4)
"""


def test_coroutines_wait(inner: Run) -> None:
    done = inner(
        SLOW
        + """
@pytest.mark.launch(fixture=slow)
async def test_it(proc, launch_context, event_loop):
    now = lambda: round(event_loop.time() - began)
    began = event_loop.time()
    assert not await tools.wait_for_start(launch_context, proc, timeout=1)
    assert await tools.wait_for_start(launch_context, proc, timeout=5) and now() == 2
    await tools.assert_stdout(launch_context, proc, lambda text: text == 'one\\n', timeout=1)
    assert not await tools.wait_for_stderr(launch_context, proc, lambda text: 'two' in text, timeout=2)
    assert await tools.wait_for_stderr(launch_context, proc, lambda text: 'two' in text, timeout=2) and now() == 5
    await tools.assert_output(launch_context, proc, lambda text: 'one' in text)
    assert not await tools.wait_for_exit(launch_context, proc, timeout=2)
    assert await tools.wait_for_exit(launch_context, proc) and now() == 8
    assert proc.return_code == 4
""",
        slow=PROGRAM,
    )
    assert done.outcomes == [('test_it', 'passed')], done.text


def test_functions_wait(inner: Run) -> None:
    done = inner(
        SLOW
        + """
@pytest.mark.launch(fixture=slow)
def test_it(proc, launch_context):
    now = lambda: round(time.monotonic() - began)
    began = time.monotonic()
    assert not tools.wait_for_start_sync(launch_context, proc, timeout=1)
    assert tools.wait_for_start_sync(launch_context, proc, timeout=5) and now() == 2
    tools.assert_stdout_sync(launch_context, proc, lambda text: text == 'one\\n', timeout=1)
    assert not tools.wait_for_stderr_sync(launch_context, proc, lambda text: 'two' in text, timeout=2)
    assert tools.wait_for_stderr_sync(launch_context, proc, lambda text: 'two' in text, timeout=2) and now() == 5
    tools.assert_output_sync(launch_context, proc, lambda text: 'one' in text)
    assert not tools.wait_for_exit_sync(launch_context, proc, timeout=2)
    assert tools.wait_for_exit_sync(launch_context, proc) and now() == 8
    assert proc.return_code == 4
""",
        slow=PROGRAM,
    )
    assert done.outcomes == [('test_it', 'passed')], done.text


@pytest.mark.parametrize('call', ['await tools.assert_{}(', 'tools.assert_{}_sync('])
@pytest.mark.parametrize(('stream', 'end'), [('output', 'stdout never was as expected; it is {!r}'), ('stderr', 'it is {!r}')])
def test_what_was_not_as_expected_is_told(inner: Run, call: str, stream: str, end: str) -> None:
    call = call.format(stream)
    text = end.format('two\n' if stream == 'stderr' else 'one\n')
    done = inner(
        SLOW
        + f"""
def validate(text):
    assert text == 'three', 'my own words'
{'async ' * call.startswith('await')}def both(launch_context, proc):
    with pytest.raises(AssertionError, match='my own words'):
        {call}launch_context, proc, validate, timeout=20)
    with pytest.raises(AssertionError) as found:
        {call}launch_context, proc, lambda text: False, timeout=1)
    assert str(found.value).endswith({text!r})
test_it = pytest.mark.launch(fixture=slow)(both)
""",
        slow=PROGRAM,
    )
    assert done.outcomes == [('test_it', 'passed')], done.text


def test_every_exported_name_is_there() -> None:
    tools = import_module('launch_pytest.tools')  # an import statement would make this file one of launch tests
    for name in tools.__all__:
        assert getattr(tools, name) is not None
