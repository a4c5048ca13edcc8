"""What this interpreter has sourced, whatever a program does to its environment afterwards."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from edulaunch.engine.packages import sourced
from edulaunch.engine.packages.sourced import put_on_prefix_path, sourced_path
from edulaunch.engine.underlay_place import underlay_prefix


@pytest.fixture(autouse=True)
def nothing_sourced(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.setattr(sourced, '_SOURCED', sourced._Sourced())
    monkeypatch.delenv('AMENT_PREFIX_PATH', raising=False)
    yield


@pytest.mark.parametrize(
    ('before', 'prefixes', 'after'),
    [('', (), ''), ('/b', ('/a',), '/a:/b:'), ('/a:/b', ('/b', '/c'), '/b:/c:/a:'), (':/a:', (), '/a:')],
)
def test_new_prefixes_come_first_each_once_and_the_underlay_last(
    monkeypatch: pytest.MonkeyPatch, before: str, prefixes: tuple[str, ...], after: str
) -> None:
    monkeypatch.setenv('AMENT_PREFIX_PATH', before)
    put_on_prefix_path(prefixes)
    assert os.environ['AMENT_PREFIX_PATH'] == after.replace(':', os.pathsep) + underlay_prefix() == sourced_path()


def test_what_is_sourced_counts_and_before_that_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    assert sourced_path() == ''
    monkeypatch.setenv('AMENT_PREFIX_PATH', '/x')
    assert sourced_path() == '/x'
    put_on_prefix_path()
    monkeypatch.setenv('AMENT_PREFIX_PATH', '/changed')
    assert sourced_path() == os.pathsep.join(['/x', underlay_prefix()])
