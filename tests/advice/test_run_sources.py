"""The files of a run that rules read."""

from __future__ import annotations

import tokenize
from pathlib import Path

import pytest

from edulaunch.advice.run_sources import joined_strings


@pytest.mark.parametrize(
    ('line', 'pairs'),
    [
        ("names = ['turtle1' 'turtle2']", [('turtle1', 'turtle2', 2)]),
        ("""names = ["/a"r'b', 'c']""", [('/a', 'b', 2)]),
        ("""names = ['''a''' "b", 'c']""", [('a', 'b', 2)]),
        ("names = ['a', 'b']", []),
        ("names = ['a' b'c']", []),
        ("names = ['a' 'b'", []),
    ],
)
def test_adjacent_strings_of_one_line(tmp_path: Path, line: str, pairs: list[tuple[str, str, int]]) -> None:
    (tmp_path / 'node.py').write_text(f'"""A node."""\n{line}\n')
    assert list(joined_strings(str(tmp_path / 'node.py'))) == pairs


def test_a_file_without_adjacent_strings_is_not_split_into_tokens(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'node.py').write_text('"""A node."""\nnames = {\'a\': "it\'s", \'b\': \'\'}\nprint(f\'{names["a"]} x\', "")\n')
    with monkeypatch.context() as patched:
        patched.setattr(tokenize, 'generate_tokens', None)
        assert list(joined_strings(str(tmp_path / 'node.py'))) == []


def test_a_missing_file_has_no_strings(tmp_path: Path) -> None:
    assert list(joined_strings(str(tmp_path / 'absent.py'))) == []
