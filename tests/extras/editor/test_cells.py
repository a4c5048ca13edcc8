"""Cells that write a file."""

from __future__ import annotations

import pytest

from edulaunch.extras.editor.cells import written_file


@pytest.mark.parametrize(
    ('cell', 'written'),
    [
        ('%%writefile a.launch.py\nx = 1\n', ('a.launch.py', '\nx = 1\n')),
        ('%%writefile -a "my dir/a.py"\nx', ('my dir/a.py', '\nx')),
        ('%%writefile a.launch.py', ('a.launch.py', '')),
        ('x = 1\n', None),
        ('%%bash\nls\n', None),
    ],
)
def test_the_lines_keep_their_numbers(cell: str, written: tuple[str, str] | None) -> None:
    assert written_file(cell) == written
