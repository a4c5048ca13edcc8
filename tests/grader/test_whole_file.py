"""A file is written whole or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.whole_file import write_whole

from edulaunch.errors import UnusableInput


def test_the_file_has_the_text_and_nothing_is_left_beside_it(tmp_path: Path) -> None:
    write_whole(str(tmp_path / 'a'), 'é\n')
    assert (tmp_path / 'a').read_bytes() == 'é\n'.encode()
    assert [path.name for path in tmp_path.iterdir()] == ['a']


def test_a_place_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    with pytest.raises(UnusableInput, match='cannot be written: No such file or directory'):
        write_whole(str(tmp_path / 'nowhere' / 'a'), 'x')
