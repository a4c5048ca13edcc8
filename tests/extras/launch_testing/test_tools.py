"""Comparing texts; parameters and markers."""

from __future__ import annotations

import re

import launch_testing
import pytest
from launch_testing.markers import keep_alive, retry_on_failure
from launch_testing.tools import build_text_match

from edulaunch.engine.processes.current import current_process


def test_a_match_says_where_it_is() -> None:
    match = build_text_match(['a', re.compile('c')])
    assert match('xabc') == (1, 4)
    assert match('xabcabc', 3) == (4, 7)
    with pytest.raises(ValueError, match='Unknown format for expected text: expected a text or a compiled .* got int: 3'):
        build_text_match(3)


def test_parametrize_accepts_names_and_values_of_all_kinds() -> None:
    @launch_testing.parametrize('a', [1, (2,), 'three', [4, 5]])
    def one(a: object) -> object:
        return a

    assert [(function(), row) for function, row in one()] == [
        (1, {'a': 1}),
        (2, {'a': 2}),
        ('three', {'a': 'three'}),
        ([4, 5], {'a': [4, 5]}),
    ]
    with pytest.raises(ValueError, match=r"parametrize: 2 names \['a', 'b'\], but 3 values"):
        launch_testing.parametrize('a,b', [(1, 2, 3)])


def test_retry_on_failure_counts_the_last() -> None:
    tries: list[int] = []

    @retry_on_failure(times=3)
    def flaky() -> int:
        tries.append(1)
        assert len(tries) > 2
        return len(tries)

    assert flaky() == 3
    began = current_process().sim.elapsed_s
    tries.clear()
    assert retry_on_failure(times=3, delay=2.5)(flaky.__wrapped__)() == 3  # type: ignore[attr-defined]
    assert current_process().sim.elapsed_s - began == pytest.approx(5.0)
    with pytest.raises(ValueError, match='at least 1, got 0'):
        retry_on_failure(times=0)


def test_markers_add_up() -> None:
    @keep_alive
    @launch_testing.ready_to_test_action_timeout(3)
    def description() -> None: ...

    assert description.__markers__ == {'keep_alive': True}  # type: ignore[attr-defined]
    assert description.__ready_to_test_action_timeout__ == 3  # type: ignore[attr-defined]


def test_every_exported_name_is_there() -> None:
    for module in (launch_testing, launch_testing.actions, launch_testing.asserts, launch_testing.tools, launch_testing.util):
        for name in module.__all__:
            assert getattr(module, name) is not None


@pytest.mark.parametrize(
    ('module', 'name', 'instead'),
    [
        ('launch_testing.actions', 'GTest', 'ExecuteProcess'),
        ('launch_testing.tools', 'launch_process', 'generate_test_description'),
        ('launch_testing.tools', 'expect_output', 'proc_output.assertWaitFor'),
        ('launch_testing', 'LaunchTestRunner', 'launch_test'),
        ('launch_testing', 'ReadyAggregator', 'ReadyToTest'),
        ('launch_testing_ros', 'DataRepublisher', 'a subscription'),
        ('osrf_pycommon.process_utils', 'async_execute_process', 'subprocess'),
    ],
)
def test_what_is_not_here_is_told_with_what_to_use(module: str, name: str, instead: str) -> None:
    with pytest.raises(ImportError, match=rf"(?s)^cannot import name '{name}' from '{module}'\n  help: .*{instead}"):
        exec(f'from {module} import {name}')


def test_the_old_tools_say_what_to_use_instead() -> None:
    with pytest.raises(ImportError, match='help: it is not part of edulaunch: write generate_test_description and'):
        from launch_testing.legacy import LaunchTestService  # type: ignore[attr-defined]  # noqa: F401
    with pytest.raises(ImportError, match='ReadyToTest'):
        launch_testing.ReadyAggregator  # noqa: B018
