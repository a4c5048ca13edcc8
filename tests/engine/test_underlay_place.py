"""Where the underlay is, and whose a file is: known without the underlay on Python's path."""

from __future__ import annotations

import ast
import json
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from edulaunch.engine.underlay_place import engine_folder, help_text, is_students, underlay_prefix, underlay_python

ENGINE = Path(engine_folder()) / 'engine'
COMMAND = re.compile(r'\b(ros2|colcon|rosdep|pip|edulaunch (launch|doctor|explain|env)) \w')


@pytest.mark.parametrize(
    ('file', 'is_one'),
    [
        ('/home/anna/circle.launch.py', True),
        (os.path.join(underlay_prefix(), 'share', 'turtlesim', 'launch', 'multisim.launch.py'), True),
        (os.path.join(underlay_python(), 'launch', '__init__.py'), False),
        (os.path.join(engine_folder(), 'errors.py'), False),
        (os.__file__, False),
        (os.path.join(sys.prefix, 'lib', 'site-packages', 'numpy', '__init__.py'), False),
        ('<string>', False),
    ],
)
def test_whose_a_file_is(file: str, is_one: bool) -> None:
    assert is_students(file) is is_one


def nodes() -> Iterator[tuple[Path, ast.AST]]:
    for path in sorted(ENGINE.rglob('*.py')):
        yield from ((path, node) for node in ast.walk(ast.parse(path.read_text('utf-8'))))


def test_each_sentence_that_the_engine_names_is_in_the_data_and_each_is_used() -> None:
    named = {
        node.args[0].value
        for _, node in nodes()
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == 'help_text'
        if isinstance(node.args[0], ast.Constant)
    }
    known = json.loads((ENGINE.parent / 'ros' / 'engine_help.json').read_text('utf-8'))
    assert named == set(known)
    assert help_text('reserved', name='class') == "choose another, such as 'class_value'"


def test_no_string_of_the_engine_names_a_command() -> None:
    found: list[str] = []
    for path in sorted(ENGINE.rglob('*.py')):
        tree = ast.parse(path.read_text('utf-8'))
        docstrings = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        found += [
            f'{path.relative_to(ENGINE)}:{node.lineno}: {node.value}'
            for node in ast.walk(tree)
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docstrings
            if COMMAND.search(node.value)
        ]
    assert found == []
