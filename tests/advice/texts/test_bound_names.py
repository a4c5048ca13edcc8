"""Names that a file binds, and names that it uses without."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from typing import Any

import pytest

from edulaunch.advice.texts.bound_names import bound_names, full_name, imported, interface_imports, launch_imports, unknown_names
from edulaunch.advice.texts.text import Text
from edulaunch.engine.interfaces.registry import underlay_registry


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


def text_of(code: str) -> tuple[Text, ast.Module]:
    return Text(code, 'a.launch.py'), ast.parse(code)


def foreseen(found: Iterable[Any]) -> list[tuple[str, str, int | None]]:
    return [(one.failure.type, one.failure.message, one.failure.line) for one in found]


def test_each_undefined_name_is_named_once_at_its_first_use() -> None:
    found = list(unknown_names(*text_of('x = len(b)\nprint(a, x, b, __file__)\n'), 'talker'))
    assert foreseen(found) == [('NameError', "name 'b' is not defined", 1), ('NameError', "name 'a' is not defined", 2)]
    assert (found[0].failure.process, found[0].failure.facts, found[0].failure.file) == (
        'talker',
        {'bound': ['x']},
        'a.launch.py',
    )
    assert foreseen(unknown_names(*text_of('from x import *\na'))) == []


@pytest.mark.parametrize(
    ('code', 'call', 'name'),
    [
        ('from launch_ros.actions import Node', 'Node()', 'launch_ros.actions.Node'),
        ('from launch_ros.actions import Node as N', 'N()', 'launch_ros.actions.Node'),
        ('from launch import actions', 'actions.LogInfo()', 'launch.actions.LogInfo'),
        ('import launch.actions', 'launch.actions.LogInfo()', 'launch.actions.LogInfo'),
        ('import launch.actions as a', 'a.LogInfo()', 'launch.actions.LogInfo'),
        ('from .mine import Node', 'Node()', None),
        ('', 'Node()', None),
        ('import launch', 'launch.a().b()', None),
    ],
)
def test_the_full_name_of_a_called_function(code: str, call: str, name: str | None) -> None:
    function = ast.parse(call, mode='eval').body
    assert isinstance(function, ast.Call)
    assert full_name(function.func, imported(ast.parse(code))) == name


@pytest.mark.parametrize(
    ('code', 'error'),
    [
        ('from launch import LaunchDescription, actions', None),
        ('from launch.actions import *', None),
        ('import launch.actions, os, nowhere', None),
        ('from nowhere import launch', None),
        ('from .launch import x', None),
        (
            'from launch.actions import Node',
            ('ImportError', "cannot import name 'Node' from 'launch.actions' (unknown location)", 1),
        ),
        ('from launch.action_s import X', ('ModuleNotFoundError', "No module named 'launch.action_s'", 1)),
        ('import launch_ros.action_s', ('ModuleNotFoundError', "No module named 'launch_ros.action_s'", 1)),
        ('from launch_roos.actions import Node', ('ModuleNotFoundError', "No module named 'launch_roos.actions'", 1)),
    ],
)
def test_imports_that_launch_does_not_have(code: str, error: tuple[str, str, int] | None) -> None:
    assert foreseen(launch_imports(*text_of(code))) == ([] if error is None else [error])


@pytest.mark.parametrize(
    ('code', 'messages'),
    [
        ('from std_msgs.msg import String, Int32', []),
        ('from std_msgs.msg import *', []),
        ('from other_pkg.msg import X', []),
        ('from std_msg.msg import String', ["No module named 'std_msg'"]),
        ('from std_msgs.msg import Strng', ["cannot import name 'Strng' from 'std_msgs.msg'"]),
        ('from std_msgs.tools import Strng', []),
    ],
)
def test_imports_of_interfaces_that_are_not_there(code: str, messages: list[str]) -> None:
    found = list(interface_imports(*text_of(code), 'talker-1', underlay_registry()))
    assert [one.failure.message.partition(' (')[0] for one in found] == messages
    assert all(one.failure.process == 'talker-1' for one in found)
