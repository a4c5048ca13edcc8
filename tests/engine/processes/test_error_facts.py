"""What is known about an error that ends a program."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.processes.error_facts import with_facts_at
from edulaunch.engine.processes.spec import ProcessSpec


def facts(world: Any, text: str) -> dict[str, Any]:
    """What is known about the error that ends a program of this text."""
    process = world.start(world.write('p.py', text))
    world.sim.run()
    return process.exception['facts'] if process.exception else {}


@pytest.mark.parametrize(
    ('text', 'known'),
    [
        ('import gazebo_msgs.msg', {'about': 'packages.absent-module', 'module': 'gazebo_msgs', 'belongs_to': 'Gazebo'}),
        ('import geometry_mgs', {'about': 'programs.unknown-module', 'module': 'geometry_mgs', 'near': 'geometry_msgs'}),
        ('import geometri_msgs', {'about': 'messages.unknown-package', 'module': 'geometri_msgs', 'near': 'geometry_msgs'}),
        ('import my_interfaces', {'about': 'messages.unknown-package', 'module': 'my_interfaces', 'near': None}),
        ('import qqq_zzz', {'about': 'programs.unknown-module', 'module': 'qqq_zzz', 'near': None}),
        ('import scipy_nothing', {'about': 'programs.unknown-module', 'module': 'scipy_nothing', 'near': None}),
        ('from robot import arm', {}),
        ('import robot.amr', {'about': 'programs.module-part', 'module': 'robot.amr', 'parent': 'robot', 'near': 'arm'}),
        ('from rclpy.nod import Node', {'about': 'programs.module-part', 'parent': 'rclpy', 'near': 'node'}),
        ('from robot.arm import mvoe', {'about': 'programs.import-name', 'missing': 'mvoe', 'near': 'move', 'known': ['move']}),
        ('import rclpy\nwith rclpy.init():\n    pass', {'about': 'programs.with-init'}),
        ('from geometry_msgs.msg import Twist\nTwist().linaer', {'about': 'messages.field', 'type': 'Twist', 'near': 'linear'}),
        ('import ctypes\nctypes.CDLL("libnothing.so.1")', {'about': 'programs.library', 'library': 'libnothing.so.1'}),
        ('from geometry_msgs import Twist', {'about': 'messages.no-interface', 'homes': ['geometry_msgs.msg']}),
        ('1 / 0', {}),
    ],
)
def test_what_is_known(world: Any, text: str, known: dict[str, Any]) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/arm.py', 'def move(): ...')
    found = facts(world, text)
    assert {name: found.get(name) for name in known} == known and bool(found) == bool(known)


def test_help_stands_below_the_error_and_is_not_recorded(world: Any) -> None:
    recorded: list[str] = []
    world.host.tracer.output = lambda process, stream, text: recorded.append(text)
    wrote = world.run('import geometri_msgs')
    assert 'help: the interface package geometri_msgs does not exist; write geometry_msgs\n' in wrote
    assert wrote == ''.join(recorded) + wrote.splitlines(True)[-1] and 'help:' not in ''.join(recorded)


@pytest.mark.skipif(sys.version_info < (3, 11), reason='Python 3.10 does not tell the class')
@pytest.mark.parametrize(
    ('text', 'name', 'ending'),
    [
        ('with rclpy.create_node("n"): ...', 'Node', 'destroy_node()'),
        ('class Robot(Node): ...\nwith Robot("n"): ...', 'Robot', 'destroy_node()'),
        ('with Node("n").create_timer(1, print): ...', 'Timer', 'destroy()'),
        ('class Timer: ...\nwith Timer(): ...', 'Timer', None),
    ],
)
def test_nodes_and_what_they_make_are_not_for_with(world: Any, text: str, name: str, ending: str | None) -> None:
    found = facts(world, f'import rclpy\nfrom rclpy.node import Node\nrclpy.init()\n{text}')
    assert found == ({} if ending is None else {'about': 'programs.with-entity', 'thing': name, 'ending': ending})


@pytest.mark.parametrize(
    ('text', 'name', 'place'),
    [
        ('import robot.fast', 'robot.fast', 'robot/fast.cpython-312-x86_64-linux-gnu.so'),
        ('from robot import fast', 'robot.fast', 'robot/fast.cpython-312-x86_64-linux-gnu.so'),
        ('from robot.quick import go', 'robot.quick', 'robot/quick.pyx'),
        ('import driver', 'driver', 'lib/driver.abi3.so'),
    ],
)
def test_compiled_modules_are_found(world: Any, text: str, name: str, place: str) -> None:
    for file in ('robot/__init__.py', 'robot/fast.cpython-312-x86_64-linux-gnu.so', 'robot/quick.pyx', 'driver.abi3.so'):
        world.write(f'lib/{file}', '')
    assert facts(world, text) == {'about': 'programs.compiled-module', 'module': name, 'compiled': place}


def test_modules_that_cmake_would_build_are_found_too(tmp_path: Path) -> None:
    for name, text in {
        'package.xml': '<package><name>robo</name><export><build_type>ament_cmake</build_type></export></package>',
        'CMakeLists.txt': 'project(robo)\nament_python_install_package(robo)\npybind11_add_module(_core SHARED src/core.cpp)\n',
        'robo/__init__.py': 'from robo._core import go\n',
    }.items():
        (tmp_path / 'robo' / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / 'robo' / name).write_text(text)
    (tmp_path / 'p.py').write_text('import robo')
    with edulaunch.Session(workspaces=[tmp_path / 'robo']) as session:
        process: Any = session.host.start(ProcessSpec(argv=('python3', str(tmp_path / 'p.py')), name='p-1'))
        session.run(1)
    assert process.exception['facts']['compiled'] == 'robo/CMakeLists.txt:3'


@pytest.mark.parametrize('module', ['pygame', 'PyQt5', 'curses', 'pynput'])
def test_what_takes_the_real_screen_or_keyboard_is_refused_even_where_it_is_installed(
    world: Any, module: str, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path_factory.mktemp('site')
    (folder / f'{module}.py').write_text('print("opens a window")')
    monkeypatch.syspath_prepend(str(folder))
    assert facts(world, f'import {module}')['about'] == 'packages.absent-module'


def test_a_program_may_have_a_module_of_such_a_name_itself(world: Any) -> None:
    world.write('keyboard.py', 'keys = 3')
    assert world.run('import keyboard\nprint(keyboard.keys)') == '3\n'


@pytest.mark.parametrize('use', ['tkinter.Tk()', 'tkinter.Frame()', 'tkinter.ttk.Button()'])
def test_windows_of_tkinter_do_not_open(world: Any, use: str) -> None:
    pytest.importorskip('_tkinter')
    wrote = world.run(f'import tkinter\nfrom tkinter import ttk\n{use}')
    said, help = wrote.splitlines()[-2:]
    assert said.endswith('TclError: no display name and no $DISPLAY environment variable') and 'opens a window' in help


def test_an_error_of_another_kind_has_no_facts_of_a_with_statement() -> None:
    assert with_facts_at(ValueError('too large')) == {}
    assert with_facts_at(AttributeError('__enter__')) == {}, 'it was never raised'
