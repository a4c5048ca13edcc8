"""One line of help for an exception that ended a program: what Python and ROS leave unsaid."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from edulaunch.packages import nearest

if TYPE_CHECKING:
    from edulaunch.processes.process import Process

KINDS = {
    'OpenCV': ('cv2', 'cv_bridge'),
    'Gazebo': ('gazebo_msgs', 'gazebo_ros', 'gazebo_plugins', 'ros_gz_interfaces', 'gz'),
    'a window': ('tkinter', '_tkinter', 'PyQt5', 'PyQt6', 'PySide2', 'PySide6', 'pygame', 'python_qt_binding', 'qt_gui', 'kivy',
                 'wx', 'pyglet', 'customtkinter'),
    'the keyboard of a real machine': ('pynput', 'keyboard', 'sshkeyboard', 'getkey', 'readchar'),
    'hardware': ('serial', 'RPi', 'smbus', 'pigpio', 'gpiozero', 'picamera', 'pyrealsense2', 'dynamixel_sdk'),
    'Navigation 2': ('nav2_msgs', 'nav2_simple_commander', 'nav2_common'),
    'MoveIt': ('moveit_msgs', 'moveit_configs_utils', 'moveit_commander', 'moveit'),
    'ros2_control': ('control_msgs', 'controller_manager', 'controller_manager_msgs'),
}
"""What cannot be had here, and the modules that stand for it."""
INTERFACE_ENDINGS = ('_msgs', '_srvs', '_interfaces', '_interface', '_msg', '_srv', '_actions')
SPELLING = ('rclpy', 'launch', 'launch_ros', 'tf2_ros', 'tf_transformations')


def error_help(process: Process, error: BaseException) -> str | None:
    """What to try, or None. An `edulaunch_hint` on the error goes before everything else."""
    hint: str | None = getattr(error, 'edulaunch_hint', None)
    if hint is not None:
        return hint
    if isinstance(error, ModuleNotFoundError) and error.name:
        return _module_help(process, error.name)
    if isinstance(error, AttributeError):
        from edulaunch.interfaces import current_registry
        from edulaunch.interfaces.attribute_help import attribute_help
        return attribute_help(error, current_registry())
    return None


def _module_help(process: Process, name: str) -> str | None:
    """For a module that nobody has: what it is, which program wanted it, and the nearest name."""
    top = name.partition('.')[0]
    for kind, modules in KINDS.items():
        if top in modules:
            return (f'{wanted_by(process)} needs the module {top!r} ({kind}), which is not here; '
                    'the other programs go on without it')
    return (_package_help(process, top) or _part_help(process, name)
            or f'{wanted_by(process)} needs the module {top!r}, which is not here' + _near(process, top))


def wanted_by(process: Process) -> str:
    """The program in words: 'follower-2 (follower of my_robot)'."""
    spec = process.spec
    return f'{process.name} ({spec.executable} of {spec.package})' if spec.package and spec.executable else process.name


def _package_help(process: Process, top: str) -> str | None:
    """For a package of the workspace whose interfaces or modules are not installed."""
    if top not in process.index.packages():
        return None
    if top in process.overlay.interface_packages:
        return f'{top} has other interfaces: {", ".join(_kinds(process, top))}'
    return (f'the package {top!r} is there but installs no module of that name: are its interfaces in '
            'rosidl_generate_interfaces() of CMakeLists.txt, or its Python package in packages= of setup.py?')


def _kinds(process: Process, package: str) -> list[str]:
    return [f'{package}.{kind}' for kind in ('msg', 'srv', 'action') if process.overlay.registry.has(package, kind)]


def _part_help(process: Process, name: str) -> str | None:
    """For a missing part of a package that is there: the nearest module beside it."""
    parent, _, leaf = name.rpartition('.')
    module: Any = process.loader.modules.get(parent)
    if module is None:
        return None
    beside = sorted({os.path.splitext(entry)[0] for folder in getattr(module, '__path__', ()) if os.path.isdir(folder)
                     for entry in os.listdir(folder) if entry.endswith('.py') and not entry.startswith('_')})
    near = nearest(leaf, beside)
    if near is not None:
        return f'did you mean {parent}.{near}?'
    return f'modules of {parent}: {", ".join(beside)}' if beside else f'{parent} has no such module'


def _near(process: Process, top: str) -> str:
    from edulaunch.interfaces import current_registry
    known = {*current_registry().packages(), *process.overlay.modules, *SPELLING}
    ending = next((ending for ending in INTERFACE_ENDINGS if top.endswith(ending)), '')
    near = nearest(top.removesuffix(ending), [name.removesuffix(ending) for name in known if name.endswith(ending)])
    if near:
        return f'; did you mean {near + ending!r}?'
    if ending:
        return ': is the package with these interfaces in the workspace?'
    return f'. If it is no module of yours, try: pip install {top}'
