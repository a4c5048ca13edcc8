"""A user at a computer with several terminals."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.desk.machine.shells import Desk


def desk_in(place: Path, runtime: str = 'r') -> Iterator[Desk]:
    """Terminals on a machine of their own; at the end it must have nothing to complain of."""
    found = Desk(place / runtime, place / 'home')
    found.runtime.mkdir()
    found.folder.mkdir()
    yield found
    found.close()
    assert found.log() == ''


HERE = Path(__file__).parent
DESKS = {'desk', 'shared_desk', 'notebook'}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests that type into terminals."""
    for item in items:
        if item.path.parent == HERE and DESKS & set(getattr(item, 'fixturenames', ())):
            item.add_marker(pytest.mark.terminals)


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    """A desk for one test."""
    yield from desk_in(tmp_path)


@pytest.fixture(scope='module')
def shared_desk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Desk]:
    """A desk for tests that leave it as they found it: a talker talks there."""
    for found in desk_in(tmp_path_factory.mktemp('desk')):
        found.ros2('run demo_nodes_py talker').until('Publishing')
        yield found
