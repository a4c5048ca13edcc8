"""The line of help below a traceback."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.processes.spec import ProcessSpec


@pytest.mark.parametrize(
    ('text', 'help'),
    [
        (
            'import gazebo_msgs.msg',
            "program-1 needs the module 'gazebo_msgs' (Gazebo), which is not here; the other programs go on without it",
        ),
        (
            'import geometry_mgs.msg',
            "program-1 needs the module 'geometry_mgs', which is not here; did you mean 'geometry_msgs'?",
        ),
        (
            'import course_interfaces.msg',
            "program-1 needs the module 'course_interfaces', which is not here: "
            'is the package with these interfaces in the workspace?',
        ),
        (
            'import qqq_zzz',
            "program-1 needs the module 'qqq_zzz', which is not here. If it is no module of yours, try: pip install qqq_zzz",
        ),
        ('from robot import arm', None),
        ('import robot.amr', 'did you mean robot.arm?'),
        ('from rclpy.nod import Node', 'did you mean rclpy.node?'),
        ('from robot.arm import mvoe', "did you mean 'move'?"),
        (
            'import scipy_nothing',
            "program-1 needs the module 'scipy_nothing', which is not here. If it is no module of yours, try: pip install scipy_nothing",
        ),
        (
            'import msvcrt',
            "program-1 needs the module 'msvcrt' (a Windows console), which is not here; the other programs go on without it",
        ),
        (
            'import rospy',
            "program-1 needs the module 'rospy' (ROS 1; with ROS 2 it is rclpy), which is not here; the other programs go on without it",
        ),
        (
            'import diagnostic_updater',
            "program-1 needs the module 'diagnostic_updater' (diagnostics; diagnostic_msgs is here), "
            'which is not here; the other programs go on without it',
        ),
        (
            'import rclpy\nwith rclpy.init():\n    pass',
            'in ROS 2 Jazzy rclpy.init() gives nothing for `with`, as it does in later versions: call it on a line of its own',
        ),
        ('from geometry_msgs.msg import Twist\nTwist().linaer', "did you mean 'linear'?"),
    ],
)
def test_help(world: Any, text: str, help: str | None) -> None:
    world.write('lib/robot/__init__.py', '')
    world.write('lib/robot/arm.py', 'def move(): ...')
    lines = world.run(text).splitlines()
    assert (lines[-1] if lines else None) == (None if help is None else f'  help: {help}')


NOT_FOR_WITH = 'in ROS 2 a {} is not for `with`: make it on a line of its own and call its {} at the end'


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
    lines = world.run(f'import rclpy\nfrom rclpy.node import Node\nrclpy.init()\n{text}').splitlines()
    said = [
        re.sub(r"'rclpy\.\w+\.", "'", line).split(' (missed')[0] for line in lines if line.startswith(('TypeError', '  help'))
    ]
    assert said == [
        f"TypeError: '{name}' object does not support the context manager protocol",
        *([f'  help: {NOT_FOR_WITH.format(name, ending)}'] if ending else []),
    ]


@pytest.mark.parametrize(
    ('text', 'name', 'place'),
    [
        ('import robot.fast', 'robot.fast', 'compiled code (robot/fast.cpython-312-x86_64-linux-gnu.so)'),
        ('from robot import fast', 'robot.fast', 'compiled code (robot/fast.cpython-312-x86_64-linux-gnu.so)'),
        ('from robot.quick import go', 'robot.quick', 'Cython, which must be compiled (robot/quick.pyx)'),
        ('import driver', 'driver', 'compiled code (lib/driver.abi3.so)'),
    ],
)
def test_compiled_modules_are_named_with_the_program_that_needs_them(world: Any, text: str, name: str, place: str) -> None:
    for file in ('robot/__init__.py', 'robot/fast.cpython-312-x86_64-linux-gnu.so', 'robot/quick.pyx', 'driver.abi3.so'):
        world.write(f'lib/{file}', '')
    world.start(world.write('p.py', text), 'arm-2', package='robot', executable='arm')
    world.sim.run()
    assert world.log[-1][2].splitlines()[-1] == (
        f"  help: arm-2 (arm of robot) needs the module '{name}', which is {place}; only Python runs here, "
        'and the other programs go on without it'
    )


def test_modules_that_cmake_would_build_are_named_too(tmp_path: Path) -> None:
    for name, text in {
        'package.xml': '<package><name>robo</name><export><build_type>ament_cmake_python</build_type></export></package>',
        'CMakeLists.txt': 'project(robo)\nament_python_install_package(robo)\npybind11_add_module(_core SHARED src/core.cpp)\n',
        'robo/__init__.py': 'from robo._core import go\n',
    }.items():
        (tmp_path / 'robo' / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / 'robo' / name).write_text(text)
    (tmp_path / 'p.py').write_text('import robo')
    written: list[str] = []
    with edulaunch.Session(workspaces=[tmp_path / 'robo']) as session:
        session.host.start(
            ProcessSpec(argv=('python3', str(tmp_path / 'p.py')), name='p-1'), lambda stream, text: written.append(text)
        )
        session.run(1)
    assert (
        "help: p-1 needs the module 'robo._core', which is made from C++ by CMakeLists.txt:3 of robo; only Python" in written[-1]
    )


def test_a_missing_native_library_is_named(world: Any) -> None:
    assert world.run('import ctypes\nctypes.CDLL("libnothing_of_the_kind.so.1")').splitlines()[-1] == (
        "  help: program-1 needs the native library 'libnothing_of_the_kind.so.1', which this machine does not have"
    )


def test_the_program_is_named_as_the_launch_file_names_it(world: Any) -> None:
    world.start(world.write('p.py', 'import cv2_nothing_of_the_kind'), 'eye-3', package='vision', executable='eye')
    world.sim.run()
    assert "help: eye-3 (eye of vision) needs the module 'cv2_nothing_of_the_kind'" in world.log[-1][2]


@pytest.mark.parametrize('module', ['pygame', 'PyQt5', 'curses', 'pynput'])
def test_what_takes_the_real_screen_or_keyboard_is_refused_even_where_it_is_installed(
    world: Any, module: str, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path_factory.mktemp('site')
    (folder / f'{module}.py').write_text('print("opens a window")')
    monkeypatch.syspath_prepend(str(folder))
    assert f"ModuleNotFoundError: No module named '{module}'\n  help: program-1 needs the module '{module}'" in world.run(
        f'import {module}'
    )


def test_a_program_may_have_a_module_of_such_a_name_itself(world: Any) -> None:
    world.write('keyboard.py', 'keys = 3')
    assert world.run('import keyboard\nprint(keyboard.keys)') == '3\n'


@pytest.mark.parametrize('use', ['tkinter.Tk()', 'tkinter.Frame()', 'tkinter.ttk.Button()'])
def test_windows_of_tkinter_do_not_open(world: Any, use: str) -> None:
    pytest.importorskip('_tkinter')
    wrote = world.run(f'import tkinter\nfrom tkinter import ttk\n{use}')
    assert wrote.endswith(
        'TclError: no display name and no $DISPLAY environment variable\n'
        '  help: program-1 opens a window; the simulation has no screen. turtlesim is drawn by edulaunch itself, '
        'other windows cannot be shown\n'
    )
