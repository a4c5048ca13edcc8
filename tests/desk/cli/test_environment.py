"""`edulaunch env`, `edulaunch python`, and the commands that are not needed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.engine.underlay_place import underlay_python

NODE = """\
import sys
from geometry_msgs.msg import Twist
from robo.parts import wheels
from robo_msgs.msg import Part
import rclpy

rclpy.init()
node = rclpy.create_node('plain')
print(node.get_name(), Twist().linear.x, Part(name='arm').name, wheels, sys.argv[1:])
"""


@pytest.fixture
def ws(tmp_path: Path) -> Path:
    texts = {
        'src/robo/package.xml': '<package format="3"><name>robo</name></package>',
        'src/robo/setup.py': "from setuptools import setup\nsetup(packages=['robo'])\n",
        'src/robo/robo/__init__.py': '',
        'src/robo/robo/parts.py': 'wheels = 4\n',
        'src/robo/robo/node.py': NODE,
        'src/robo_msgs/package.xml': '<package format="3"><name>robo_msgs</name></package>',
        'src/robo_msgs/CMakeLists.txt': 'project(robo_msgs)\nrosidl_generate_interfaces(robo_msgs msg/Part.msg)\n',
        'src/robo_msgs/msg/Part.msg': 'string name\n',
    }
    for name, text in texts.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def run(*words: str, cwd: Path, env: dict[str, str] | None = None) -> str:
    done = subprocess.run(words, cwd=cwd, env=env, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


SAYS = "plain 0.0 arm 4 ['x', '-h']\n"


@pytest.mark.processes
@pytest.mark.parametrize('here', ['.', 'src/robo/robo'])
def test_python_finds_rclpy_and_the_workspace(ws: Path, here: str) -> None:
    file = os.path.relpath(ws / 'src/robo/robo/node.py', ws / here)
    assert run(sys.executable, '-m', 'edulaunch', 'python', file, 'x', '-h', cwd=ws / here) == SAYS


@pytest.mark.processes
@pytest.mark.skipif(os.name == 'nt', reason='a POSIX shell')
def test_so_does_python3_in_a_shell_that_evaluated_env(ws: Path) -> None:
    line = f'eval "$({sys.executable} -m edulaunch env --shell)"; cd /; {sys.executable} {ws}/src/robo/robo/node.py x -h'
    assert run('sh', '-c', line, cwd=ws) == SAYS


@pytest.mark.processes
@pytest.mark.skipif(os.name == 'nt', reason='a POSIX shell')
def test_a_python_of_such_a_shell_that_needs_no_ros_loads_nothing_of_it(ws: Path) -> None:
    (ws / 'other').mkdir()
    (ws / 'other' / 'sitecustomize.py').write_text("print('the hidden one')\n")
    code = "import sys\ntry:\n    import no_such\nexcept ModuleNotFoundError as e:\n    print(e, 'rclpy' in sys.modules)"
    line = f'eval "$(PYTHONPATH={ws}/other {sys.executable} -m edulaunch env --shell)"; {sys.executable} -c "{code}"'
    said = run('sh', '-c', line, cwd=Path('/'))
    assert said == "the hidden one\nNo module named 'no_such' False\n"


@pytest.mark.processes
@pytest.mark.skipif(os.name == 'nt', reason='a POSIX shell')
def test_in_a_workspace_of_such_a_shell_names_that_python_itself_tries_read_nothing(ws: Path) -> None:
    code = "import copy, sys; before = any('robo' in p for p in sys.path); import robo; print(before)"
    line = f'eval "$({sys.executable} -m edulaunch env --shell)"; {sys.executable} -c "{code}"'
    assert run('sh', '-c', line, cwd=ws) == 'False\n'
    assert 'usage: edugrade' in run('sh', '-c', line.partition(';')[0] + f'; {sys.executable} -m edugrade --help', cwd=ws)


def test_env_prints_the_folder_with_rclpy(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['env']) == 0
    assert capsys.readouterr().out == f'{underlay_python()}\n'


@pytest.mark.parametrize(
    'words', [['colcon', 'build', '--packages-select', 'robo'], ['rosdep', 'install', '-i', '--from-path', 'src', '-y']]
)
def test_what_is_not_needed_says_so_and_is_well(capsys: pytest.CaptureFixture[str], words: list[str]) -> None:
    assert main(words) == 0
    assert capsys.readouterr().out.startswith(words[0])
