"""The lines of a program that use the order of a set."""

from __future__ import annotations

import pytest

from edulaunch.runtime.set_order import set_lines

SETS = """names = {'a', 'b'}
numbers = {1, 2}
later = set()
later = sorted(names)
for name in sorted(names): pass
if 'a' in names: print(len(names), *numbers, later, sum(1 for name in names))
"""


@pytest.mark.parametrize(
    'line',
    [
        'for name in names: pass',
        'print([name for name in names | {"c"}])',
        'print(", ".join(set("ab")))',
        'list(names)',
        'print(f"{names}")',
        'names.pop()',
        'print(*{name for name in "ab"})',
    ],
)
def test_a_line_that_uses_the_order_of_a_set(line: str) -> None:
    assert set_lines(SETS.encode()) == () and set_lines((SETS + line).encode()) == (7,)
