"""The house stays small: code lines per room and in total, files, and long functions (size_budget.toml).

`python -m tests.test_size` lowers every number of the table to what stands today; raising one is written by hand, and the commit
message says what the house gets for it.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from tests.house import PACKAGE, ROOT, code_lines, long_functions, modules, private_reaches, room

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TABLE = ROOT / 'tests' / 'size_budget.toml'
BUDGET = tomllib.loads(TABLE.read_text(encoding='utf-8'))
SPARE = 150
"""Lines that a room may lie under its number before the number has to follow."""


def files() -> dict[Path, str]:
    """Every Python file of the house with its room; launch files of the underlay's share folders are one, and so are the
    built-in programs that are written as students write theirs.
    """
    found = {path: room(name) for name, path in modules().items()}
    for place in ('share', 'programs'):
        found |= dict.fromkeys(sorted((PACKAGE / 'underlay' / place).rglob('*.py')), place)
    return found


@cache
def lines_by_room() -> Counter[str]:
    lines: Counter[str] = Counter()
    for path, name in files().items():
        lines[name] += code_lines(path)
    return lines


def test_no_room_is_larger_than_its_budget() -> None:
    budget = BUDGET['lines']
    large = {name: (count, budget.get(name, 0)) for name, count in lines_by_room().items() if count > budget.get(name, 0)}
    assert large == {}, 'more code lines than (is, may be): make the room smaller, or raise its number and say what for'


def test_the_house_is_not_larger_than_its_budget() -> None:
    assert sum(lines_by_room().values()) <= BUDGET['total']['lines'], 'the whole house: take something out'
    assert len(files()) <= BUDGET['total']['files'], 'too many files: merge some that are one idea'


def test_the_numbers_follow_what_was_taken_out() -> None:
    lines = lines_by_room()
    loose = {
        name: (lines[name], most) for name, most in BUDGET['lines'].items() if 0 < lines[name] < most - max(SPARE, most // 8)
    }
    assert loose == {}, 'smaller than its number (is, may be): run `python -m tests.test_size` and commit the lower table'


def test_no_function_is_long() -> None:
    most = BUDGET['total']['function_lines']
    found = {f'{path.relative_to(ROOT)}:{name}' for path in files() for name, _ in long_functions(path, most)}
    assert found <= set(BUDGET['standing']['long_functions']), f'over {most} lines: split it'
    assert set(BUDGET['standing']['long_functions']) <= found, f'no longer so long: take it out of {TABLE.name}'


def test_no_test_file_is_long() -> None:
    most = BUDGET['total']['test_file_lines']
    tests = [path for path in (ROOT / 'tests').rglob('test_*.py') if not {'corpus', 'golden'} & set(path.parts)]
    long = {str(path.relative_to(ROOT)): count for path in tests if (count := path.read_text('utf-8').count('\n')) > most}
    assert long == {}, f'over {most} lines: a file for each module that it tests'


@cache
def private() -> list[str]:
    """Every reach of the house for what is another's own: `file:line: text`."""
    return [f'{path.relative_to(ROOT)}:{line}: {text}' for path in files() for line, text in private_reaches(path)]


def test_private_attributes_of_others_are_left_alone() -> None:
    assert len(private()) <= BUDGET['total']['private'], (
        'one more reach for a private attribute of another: give it a name that others may use'
    )


@pytest.mark.parametrize(
    ('text', 'found'),
    [
        ('node._parameters', ['node._parameters']),
        ('self.node._parameters', ['self.node._parameters']),
        ('class A:\n    def f(self, other):\n        return self._x == other._x', []),
        ('class A(B):\n    def f(self):\n        return self._x', []),
        ('class A:\n    _x: int\n    _y = 3\ndef f(a):\n    return a._x, a._y, a._z', ['a._z']),
        ('def f(x):\n    return x.__dict__, x._replace(a=1)', []),
        ('def f(context):\n    context._push_locals()', []),
    ],
)
def test_what_counts_as_private_reaching(text: str, found: list[str], tmp_path: Path) -> None:
    (tmp_path / 'one.py').write_text(text)
    assert [reach for _, reach in private_reaches(tmp_path / 'one.py')] == found


def lower() -> None:
    """Write today's numbers where they are lower."""
    lines, text = lines_by_room(), TABLE.read_text(encoding='utf-8')
    today = {f'"{name}"': count for name, count in lines.items()}
    today |= {'lines': sum(lines.values()), 'files': len(files()), 'private': len(private())}

    def lowered(found: re.Match[str]) -> str:
        return f'{found[1]} = {min(int(found[2]), today[found[1]])}' if found[1] in today else found[0]

    TABLE.write_text(re.sub(r'(?m)^("[\w.]+"|lines|files|private) = (\d+)', lowered, text), encoding='utf-8')


if __name__ == '__main__':
    lower()
