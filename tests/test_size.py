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

from tests.house import PACKAGE, ROOT, code_lines, long_functions, modules, room

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


def lower() -> None:
    """Write today's numbers where they are lower."""
    lines, text = lines_by_room(), TABLE.read_text(encoding='utf-8')
    today = {f'"{name}"': count for name, count in lines.items()}
    today |= {'lines': sum(lines.values()), 'files': len(files())}

    def lowered(found: re.Match[str]) -> str:
        return f'{found[1]} = {min(int(found[2]), today[found[1]])}' if found[1] in today else found[0]

    TABLE.write_text(re.sub(r'(?m)^("[\w.]+"|lines|files) = (\d+)', lowered, text), encoding='utf-8')


if __name__ == '__main__':
    lower()
