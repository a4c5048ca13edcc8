"""The files of a run that rules read."""

from __future__ import annotations

import ast
import tokenize
from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice.run_sources import (
    LONGEST,
    joined_strings,
    keyword_of,
    launch_scripts,
    name_of_call,
    program_scripts,
    script_of,
)

LAUNCH = """from pathlib import Path
from launch import LaunchDescription
from launch.actions import ExecuteProcess, IncludeLaunchDescription
here = Path(__file__).parent
def generate_launch_description():
    return LaunchDescription([{more}])
"""
NODE = """import rclpy
from helper import make
rclpy.init()
node = rclpy.create_node('node')
publisher = make(node)
rclpy.spin(node)
"""
HELPER = """from std_msgs.msg import String
def make(node):
    return node.create_publisher(String, 'words', 1)
"""


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


def test_the_files_of_a_run_are_its_launch_files_and_its_programs(tmp_path: Path) -> None:
    (tmp_path / 'one.launch.py').write_text(LAUNCH.format(more="IncludeLaunchDescription(str(here / 'two.launch.py')),"))
    (tmp_path / 'two.launch.py').write_text(LAUNCH.format(more="ExecuteProcess(cmd=['python3', str(here / 'node.py')]),"))
    (tmp_path / 'node.py').write_text(NODE)
    (tmp_path / 'helper.py').write_text(HELPER)
    recording = edulaunch.run(tmp_path / 'one.launch.py', duration_s=0.5, console=lambda *_: None)
    assert [Path(file).name for file, _ in launch_scripts(recording)] == ['one.launch.py', 'two.launch.py']
    assert [Path(file).name for file, _ in program_scripts(recording)] == ['node.py', 'helper.py']
    (tmp_path / 'helper.py').unlink()
    assert [Path(file).name for file, _ in program_scripts(recording)] == ['node.py']


def test_only_readable_python_files_of_students_are_parsed(tmp_path: Path) -> None:
    (tmp_path / 'a.py').write_text('x = 1\n')
    (tmp_path / 'a.txt').write_text('x = 1\n')
    (tmp_path / 'broken.py').write_text('x = \n')
    (tmp_path / 'long.py').write_text('x = 1\n' * (LONGEST // 6 + 1))
    found = [script_of(str(tmp_path / name)) for name in ('a.py', 'a.txt', 'broken.py', 'long.py', 'absent.py')]
    assert [tree is not None for tree in found] == [True, False, False, False, False]
    assert script_of(None) is script_of(edulaunch.__file__) is None
    (tmp_path / 'a.py').write_text('x = 1\ny = 2\n')
    tree = script_of(str(tmp_path / 'a.py'))
    assert tree is not None and len(tree.body) == 2, 'it is parsed again after a change'


@pytest.mark.parametrize(('call', 'name'), [('Node()', 'Node'), ('actions.Node()', 'Node'), ('a()()', ''), ('Node', '')])
def test_the_last_name_of_a_called_function(call: str, name: str) -> None:
    assert name_of_call(ast.parse(call, mode='eval').body) == name


def test_a_keyword_of_a_call() -> None:
    call = ast.parse('Node(package="a", **more)', mode='eval').body
    assert isinstance(call, ast.Call)
    value = keyword_of(call, 'package')
    assert isinstance(value, ast.Constant) and value.value == 'a' and keyword_of(call, 'name') is None
