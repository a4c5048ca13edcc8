"""Kinds of tests. Unit tests start no other Python and are what the README's command runs; every other kind has a mark, and a step of `.ci/run`."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from typing import Any

import pytest

KINDS = ('attacks', 'browser', 'processes', 'real', 'terminals', 'whole')
STARTS = {'subprocess.Popen', 'os.posix_spawn'}
ALL_TESTS = pytest.StashKey[list[pytest.Item]]()
"""In the stash of the configuration: what was collected, before what takes its time was left out."""


def kinds_of(item: pytest.Item) -> list[str]:
    """The kinds that a test is marked with; none of a unit test."""
    return [name for name in KINDS if item.get_closest_marker(name)]


def has_none_of(file: Path, expression: str) -> bool:
    """Whether a file of tests can have none that an expression of marks asks for, as neither it nor its folder's conftest names one of these marks:
    then it need not be imported. An expression that is more than kinds with `or` between them can ask for anything.
    """
    wanted = expression.split(' or ')
    if not set(wanted) <= set(KINDS) or not file.match('test_*.py'):
        return False
    places = [place for place in (file, file.with_name('conftest.py')) if place.is_file()]
    return not any(re.search(rf'\bmark\.(?:{"|".join(wanted)})\b', place.read_text(encoding='utf-8')) for place in places)


class UnitTestsStartNoPython:
    """While a unit test runs, whoever starts a Python fails it there and then: a second of such processes is thirty unit tests."""

    def __init__(self) -> None:
        self._is_unit = False
        sys.addaudithook(self._hear)

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Any:
        self._is_unit = not kinds_of(item)
        try:
            return (yield)
        finally:
            self._is_unit = False

    def _hear(self, event: str, args: tuple[Any, ...]) -> None:
        if event in STARTS and self._is_unit and _is_python([args[0], *args[1]]):
            pytest.fail('a unit test starts no Python: call the function itself, or mark the test @pytest.mark.processes')


def _is_python(words: list[str | bytes | os.PathLike[str]]) -> bool:
    """Whether a command runs Python, or a program of this environment (`edugrade`)."""
    texts = [os.fsdecode(word) for word in words if word is not None]
    return any(os.path.basename(text).startswith('python') for text in texts[:2]) or any(sys.prefix in text for text in texts)
