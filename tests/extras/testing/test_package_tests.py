"""Plain test files of a ROS package: `pytest` in its folder runs them in simulated time, with the packages around it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.extras.testing import absent_linter, is_of_own_package, workspaces_of

MANIFEST = '<package format="3"><name>{}</name><version>0.0.0</version><description/><license>x</license></package>'
SETUP = "from setuptools import setup\nsetup(name='bot', packages=['bot'])\n"
NODE = """
import time
from rclpy.node import Node
from bot_msgs.msg import Level

class Bot(Node):
    def __init__(self):
        super().__init__('bot')
        self.pub = self.create_publisher(Level, 'level', 10)

    def slow(self):
        time.sleep(300)
        return Level(level=4)
"""
CONFTEST = """
import pytest
import rclpy
from bot.node import Bot

@pytest.fixture
def bot():
    rclpy.init()
    yield Bot()
    rclpy.shutdown()
"""
TEST = """
import subprocess, threading, time
from unittest import mock
import rclpy
from bot.node import Bot
from bot_msgs.msg import Level
from beside import make

def test_classes_are_those_of_conftest_and_of_modules_beside(bot):
    assert isinstance(bot, Bot) and isinstance(make(), Level)

def test_time_is_simulated(bot):
    before = time.time()
    assert bot.slow().level == 4 and time.time() - before == 300

def test_names_can_be_patched(bot):
    with mock.patch('bot.node.time.sleep') as sleep, mock.patch('bot.node.Level') as level:
        assert bot.slow() is level.return_value
    sleep.assert_called_once_with(300)

def test_a_thread_spins_beside_a_program(bot):
    thread = threading.Thread(target=rclpy.spin, args=(bot,), daemon=True)
    thread.start()
    program = subprocess.Popen(['ros2', 'run', 'turtlesim', 'turtlesim_node'])
    time.sleep(1.0)
    assert 'turtlesim' in bot.get_node_names() and thread.is_alive()
    program.terminate()

def test_what_never_ends_fails(bot):
    rclpy.spin(bot)

def test_what_never_ends_fails_also_while_a_timer_ticks(bot):
    bot.create_timer(0.5, lambda: None)
    rclpy.spin_until_future_complete(bot, rclpy.task.Future())

def test_what_never_ends_fails_also_when_it_looks_again_and_again(bot):
    bot.create_client(rclpy.node.ListParameters, 'nobody').wait_for_service()
"""
LINTER = 'from ament_flake8.main import main_with_errors\ndef test_flake8():\n    assert main_with_errors(argv=[])[0] == 0\n'


@pytest.fixture
def bot(tmp_path: Path) -> Path:
    """A package with tests, beside one with its messages; its folder."""
    files = {
        'bot_msgs/package.xml': MANIFEST.format('bot_msgs'),
        'bot_msgs/msg/Level.msg': 'int32 level\n',
        'bot_msgs/CMakeLists.txt': 'project(bot_msgs)\nrosidl_generate_interfaces(${PROJECT_NAME} "msg/Level.msg")\n',
        'bot/package.xml': MANIFEST.format('bot'),
        'bot/setup.py': SETUP,
        'bot/bot/__init__.py': '',
        'bot/bot/node.py': NODE,
        'bot/test/conftest.py': CONFTEST,
        'bot/test/test_bot.py': TEST,
        'bot/test/test_flake8.py': LINTER,
        'bot/test/beside.py': 'from bot_msgs.msg import Level\nmake = Level\n',
    }
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return tmp_path / 'bot'


@pytest.mark.processes
def test_the_tests_of_a_package_run_without_ros(bot: Path) -> None:
    (bot.parent / 'conftest.py').write_text('import rclpy\n')  # of the whole workspace: in no package
    done = subprocess.run(
        [
            sys.executable,
            '-m',
            'pytest',
            '-q',
            '-rfs',
            '-p',
            'no:cacheprovider',
            '-p',
            'no:nbval',
            '-p',
            'no:hypothesispytest',
            'bot',
        ],
        cwd=bot.parent,
        capture_output=True,
        text=True,
        env={**os.environ, 'PYTHONDONTWRITEBYTECODE': '1'},
    )
    assert '3 failed, 4 passed, 1 skipped' in done.stdout, done.stdout
    assert done.stdout.count('this test has waited for 900 s of simulated time') >= 3, done.stdout
    assert 'FAILED bot/test/test_bot.py::test_what_never_ends_fails' in done.stdout
    assert (
        'SKIPPED [1] bot/test/test_flake8.py:1: ament_flake8 is not available: run style checks where ROS 2 is installed'
        in done.stdout
    )


def test_tests_see_packages_beside_their_own(bot: Path) -> None:
    assert workspaces_of(str(bot / 'test' / 'test_bot.py')) == [str(bot.parent)]
    (bot.parent / 'bot_msgs' / 'package.xml').unlink()
    assert workspaces_of(str(bot / 'test' / 'test_bot.py')) == [str(bot)]


def test_tests_of_packages_of_ros_itself_are_left_alone(bot: Path, tmp_path: Path) -> None:
    assert is_of_own_package(str(bot / 'test' / 'test_bot.py'))
    assert not is_of_own_package(str(tmp_path / 'test_loose.py'))
    assert not is_of_own_package(str(bot.rename(tmp_path / 'launch') / 'test' / 'test_bot.py'))


@pytest.mark.parametrize(
    ('source', 'linter'),
    [
        (b'from ament_pep257.main import main', 'ament_pep257'),
        (b'import ament_copyright.main as main', 'ament_copyright'),
        (b'from ament_index_python import get_resource', None),
        (b'# ament_flake8', None),
        (b'from ament_flake8 import (', None),
    ],
)
def test_a_linter_is_known_by_its_import(source: bytes, linter: str | None) -> None:
    assert absent_linter(source) == linter
