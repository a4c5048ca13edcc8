"""The engine stays small enough to be read, and no function or test file is long (size_budget.toml).

Raising a number is written by hand, and the commit message says what the house gets for it.
"""

from __future__ import annotations

import sys
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from tests.house import PACKAGE, ROOT, code_lines, long_functions, modules, private_reaches, wing

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TABLE = ROOT / 'tests' / 'size_budget.toml'
BUDGET = tomllib.loads(TABLE.read_text(encoding='utf-8'))


def files() -> dict[Path, str]:
    """Every Python file of the house with its wing; launch files of the underlay's share folders are one, and so are the
    built-in programs that are written as students write theirs.
    """
    found = {path: wing(name) for name, path in modules().items()}
    for place in ('share', 'programs'):
        found |= dict.fromkeys(sorted((PACKAGE / 'ros' / place).rglob('*.py')), 'edulaunch.ros')
    return found


@cache
def lines_by_wing() -> Counter[str]:
    lines: Counter[str] = Counter()
    for path, name in files().items():
        lines[name] += code_lines(path)
    return lines


def test_the_engine_can_be_read_in_an_afternoon() -> None:
    assert lines_by_wing()['edulaunch.engine'] <= BUDGET['total']['engine_lines'], (
        'what need not know simulated time belongs above'
    )


def test_each_new_room_is_paid_for_by_something_that_went() -> None:
    assert sum(lines_by_wing().values()) <= BUDGET['total']['lines'], 'the whole house: take something out'


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


if __name__ == '__main__':
    for name, count in lines_by_wing().most_common():
        print(f'{count:6} {name}')
    print(f'{sum(lines_by_wing().values()):6} in all')
