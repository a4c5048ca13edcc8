"""Launch tests written for ROS 2 run in simulated time, with ROS 2's rules and texts."""

from __future__ import annotations

import re

import pytest

from .conftest import Run, outcome


def texts(test: object) -> list[str]:
    return [text for result in test.results.values() for _, _, text in result.problems()]  # type: ignore[attr-defined]


def test_a_running_talker_is_tested_and_ends_well(run: Run) -> None:
    test = run('talker')
    assert (test.code, outcome(test)) == (0, [])
    (result,) = test.results.values()
    assert [case.id().rpartition('.')[2] for case in result.testTimes] == [
        'test_publishes_once_a_second',
        'test_waits_for_output',
        'test_exit_code',
    ]


def test_durations_are_simulated_seconds_and_repeat(run: Run) -> None:
    times = [list(next(iter(run('talker').results.values())).testTimes.values()) for _ in range(2)]
    assert times[0] == times[1]
    assert times[0] == pytest.approx([5.0, 1014.0, 0.0])


def test_each_wrong_claim_is_told_with_its_own_lines_only(run: Run) -> None:
    test = run('failing')
    assert (test.code, outcome(test)) == (1, [('ERROR', 'test_c_broken'), ('FAIL', 'test_b_wrong')])
    error, failure = texts(test)
    assert re.fullmatch(
        r'Traceback \(most recent call last\):\n  File ".*failing\.py", line 24, in test_c_broken\n'
        r"    raise KeyError\('no such thing'\)\nKeyError: 'no such thing'\n",
        error,
    )
    assert failure.splitlines()[-2:] == [
        'AssertionError: Waiting for output timed out',
        '  help: nothing was written to stderr within 3 s by: keep_alive_proc-1',
    ]


def test_skipped_tests_are_no_failures(run: Run) -> None:
    (result,) = run('failing').results.values()
    assert [(case.id().rpartition('.')[2], reason) for case, reason in result.skipped] == [('test_d_skipped', 'not today')]


def test_each_parameter_is_a_launch_of_its_own(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    test = run('parametrized', 'who:=me')
    assert (test.code, outcome(test)) == (0, [])
    assert [str(test_run) for test_run in test.results] == ['parametrized[one, 1]', 'parametrized[two, 2]']
    assert 'Starting test run parametrized[two, 2]\n' in capsys.readouterr().out


def test_old_style_descriptions_threads_and_processes_of_tests(run: Run) -> None:
    test = run('old_style')
    assert (test.code, outcome(test)) == (0, [])


def test_a_launch_that_ends_too_early_is_a_failure(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    test = run('dying')
    assert (test.code, outcome(test)) == (1, [('FAIL', 'launch')])
    assert texts(test) == ['Processes under test stopped before tests completed']
    told = capsys.readouterr().out
    assert "Process 'ros2-1' exited with 1\n##### 'ros2-1' output #####\nPackage not found\n" in told


def test_a_launch_that_never_gets_ready_is_a_failure(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    test = run('not_ready')
    assert texts(test) == [
        'Processes under test stopped before tests completed\n  help: ReadyToTest was not reached within 5 s of simulated time'
    ]
    assert 'Timed out waiting for processes to start up\n' in capsys.readouterr().out


def test_a_description_without_ready_to_test_is_refused(run: Run) -> None:
    test = run('forgetful')
    assert test.code == 1
    assert str(test.error) == (
        'generate_test_description functions without a ready_fn argument must return '
        'a LaunchDescription containing a ReadyToTest action'
    )


def test_a_test_that_waits_for_ever_is_ended(run: Run) -> None:
    test = run('waiting')
    assert str(test.error) == (
        'waiting.py: the launch test was still waiting after 3600.0 s of simulated time.\n'
        '  help: give each wait a timeout, such as event.wait(timeout=10)'
    )


def test_tests_of_nodes_wait_for_topics(run: Run) -> None:
    test = run('topics')
    assert (test.code, outcome(test), texts(test)) == (0, [], [])
