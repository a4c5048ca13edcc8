"""A user at a computer with several terminals."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.machine.shells import Desk


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    """Terminals on a machine of their own; at the end it must have nothing to complain of."""
    runtime, folder = tmp_path / 'run', tmp_path / 'home'
    runtime.mkdir()
    folder.mkdir()
    found = Desk(runtime, folder)
    yield found
    found.close()
    assert found.log() == ''
