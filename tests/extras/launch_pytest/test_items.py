"""Tests of all kinds beside a launch, or after it; the time in a test file."""

from __future__ import annotations

import pytest

from .conftest import Run
from .sources import ALIVE, SHARED


def test_all_kinds_of_tests_run_beside_the_launch_or_after_it(inner: Run) -> None:
    done = inner(
        ALIVE
        + """
is_over = lambda service: service._is_idle() and service.event_loop is None
@pytest.mark.launch(fixture=alive)
def test_function(launch_service):
    assert not is_over(launch_service)
@pytest.mark.launch(fixture=alive)
async def test_coroutine(launch_service, event_loop):
    assert not is_over(launch_service) and asyncio.get_running_loop() is event_loop
@pytest.mark.launch(fixture=alive, shutdown=True)
def test_function_after(launch_service):
    assert is_over(launch_service)
@pytest.mark.launch(fixture=alive, shutdown=True)
async def test_coroutine_after(launch_service):
    assert is_over(launch_service)
@pytest.mark.launch(fixture=alive)
def test_generator(launch_service):
    assert not is_over(launch_service)
    yield
    assert is_over(launch_service)
@pytest.mark.launch(fixture=alive)
async def test_async_generator(launch_service):
    assert not is_over(launch_service)
    yield
    assert is_over(launch_service)
class TestInClass:
    @pytest.mark.launch(fixture=alive)
    async def test_method(self, launch_service, launch_context):
        assert launch_context is launch_service.context
def test_plain():
    assert True
"""
    )
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 8, done.text


def test_tests_share_a_launch_of_their_module_and_its_end_comes_last(inner: Run) -> None:
    done = inner(
        SHARED
        + """
@pytest.mark.launch(fixture=shared, shutdown=True)
def test_after(proc):
    assert proc.return_code is not None
@pytest.mark.launch(fixture=shared)
def test_two_parts(proc):
    assert proc.return_code is None
    yield
    assert proc.return_code is not None
@pytest.mark.launch(fixture=shared)
async def test_two_async_parts(proc):
    assert proc.return_code is None
    yield
    assert proc.return_code is not None
@pytest.mark.launch(fixture=shared)
def test_broken_before(proc):
    assert False
    yield
@pytest.mark.launch(fixture=shared)
def test_beside(proc):
    assert proc.return_code is None
"""
    )
    assert done.outcomes == [
        ('test_two_parts', 'passed'),
        ('test_two_async_parts', 'passed'),
        ('test_broken_before', 'failed'),
        ('test_beside', 'passed'),
        ('test_after', 'passed'),
        ('test_two_parts[shutdown_test]', 'passed'),
        ('test_two_async_parts[shutdown_test]', 'passed'),
        ('test_broken_before[shutdown_test]', 'skipped'),
    ], done.text


def test_time_of_a_test_file_is_simulated(inner: Run) -> None:
    done = inner(
        ALIVE
        + """
@pytest.mark.launch(fixture=alive)
def test_sleep():
    began = time.time()
    time.sleep(30)
    from time import monotonic, sleep
    sleep(30)
    assert time.time() - began == pytest.approx(60)
@pytest.mark.launch(fixture=alive)
def test_thread():
    heard = []
    thread = threading.Timer(20, lambda: heard.append(1))
    thread.start()
    thread.join()
    assert heard
@pytest.mark.launch(fixture=alive)
async def test_async_sleep(event_loop):
    began = event_loop.time()
    await asyncio.sleep(100)
    assert event_loop.time() - began == pytest.approx(100)
"""
    )
    assert [outcome for _, outcome in done.outcomes] == ['passed'] * 3, done.text


@pytest.mark.parametrize(
    ('text', 'outcome', 'said'),
    [
        (
            ALIVE + '@pytest.mark.launch\ndef test_it(): pass',
            'skipped',
            '"fixture" keyword argument is required in a pytest.mark.launch() decorator',
        ),
        (
            '@pytest.fixture\ndef plain(): pass\n@pytest.mark.launch(fixture=plain)\ndef test_it(): pass',
            'skipped',
            "must be a launch fixture: decorate 'plain' with @launch_pytest.fixture",
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive, shutdown=True)\ndef test_it(): yield',
            'skipped',
            'generator or async generator based launch test items cannot be marked with shutdown=True',
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive)\ndef test_it():\n    yield\n    yield',
            'failed',
            'launch tests using a generator function must stop iteration after yielding once',
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive)\nasync def test_it():\n    yield\n    yield',
            'failed',
            'launch tests using an async gen function must stop iteration after yielding once',
        ),
        (
            '@launch_pytest.fixture\ndef empty(): pass\n@pytest.mark.launch(fixture=empty)\ndef test_it(): pass',
            'error',
            "When running launch_pytest fixture 'empty': return value must be either a launch description or a sequence whose first "
            'item is a launch description\n  help: it is None',
        ),
        (
            '@launch_pytest.fixture\ndef two(): return launch.LaunchDescription([ReadyToTest(), ReadyToTest()])\n'
            '@pytest.mark.launch(fixture=two)\ndef test_it(): pass',
            'error',
            'containing only one ReadyToTest action',
        ),
        (
            '@launch_pytest.fixture\ndef bad(): return launch.LaunchDescription([Node(package="nowhere", executable="x"), ReadyToTest()])\n'
            '@pytest.mark.launch(fixture=bad)\ndef test_it(): pass',
            'error',
            "fixture 'bad': the launch ended before ReadyToTest was reached: PackageNotFoundError: \"package 'nowhere' not found",
        ),
        (
            ALIVE + '@pytest.mark.launch(fixture=alive)\ndef test_it(): threading.Event().wait()',
            'failed',
            'the test did not come to its end: it was still waiting after 600.0 s of simulated time',
        ),
        (
            '@launch_pytest.fixture(auto_shutdown=False)\ndef stays(): return launch.LaunchDescription([KeepAliveProc()])\n'
            '@pytest.mark.launch(fixture=stays, shutdown=True)\ndef test_it(): pass',
            'failed',
            'the launch did not come to its end',
        ),
    ],
)
def test_what_goes_wrong_is_told(inner: Run, text: str, outcome: str, said: str) -> None:
    done = inner(text)
    assert done.outcomes[0] == ('test_it', outcome)
    assert said in done.text
