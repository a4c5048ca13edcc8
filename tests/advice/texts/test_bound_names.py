"""Names that a file binds, and names that it uses without."""

from __future__ import annotations

import ast

import pytest

from edulaunch.advice.texts.bound_names import bound_names


@pytest.mark.parametrize(
    ('text', 'names'),
    [
        ('import os.path, sys as s', {'os', 's'}),
        ('from a import b, c as d', {'b', 'd'}),
        ('x = y = 1\nz: int = 2\nu += x', {'x', 'y', 'z', 'u'}),
        ('print(x)', set()),
        ('def f(a, *b, c=1, **d): pass', {'f', 'a', 'b', 'c', 'd'}),
        ('async def f(): pass\nclass C: pass', {'f', 'C'}),
        ('try: pass\nexcept E as e: pass', {'e'}),
        ('try: pass\nexcept E: pass', set()),
        ('for i, (j, *k) in x: pass', {'i', 'j', 'k'}),
        ('with a as b: pass', {'b'}),
        ('[n for n in x]', {'n'}),
        ('if (w := 1): pass', {'w'}),
        (
            'match x:\n    case [a, *b]: pass\n    case {"k": c, **d}: pass\n    case E() as e: pass\n    case _: pass',
            {'a', 'b', 'c', 'd', 'e'},
        ),
        ('def f():\n    global g\n    nonlocal_ = 1', {'f', 'g', 'nonlocal_'}),
        ('del x', {'x'}),
        ('lambda q: q', {'q'}),
    ],
)
def test_what_binds_a_name(text: str, names: set[str]) -> None:
    assert bound_names(ast.parse(text)) == names


@pytest.mark.parametrize(
    'text', ['from a import *', 'exec("x = 1")', 'globals()["x"] = 1', 'vars()', 'locals()', 'setattr(a, "b", 1)']
)
def test_names_may_come_from_elsewhere(text: str) -> None:
    assert bound_names(ast.parse(text)) is None
