"""Small workspaces of student packages."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

NODE = """
import rclpy
from rclpy.node import Node


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Node('quiet'))
"""


class Workspace:
    """A folder in which packages are written file by file."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def write(self, name: str, text: str = '') -> Path:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text).lstrip('\n'), encoding='utf-8')
        return path

    def manifest(self, package: str, build_type: str, depends: str = '', folder: str | None = None) -> Path:
        tags = ''.join(f'  <exec_depend>{name}</exec_depend>\n' for name in depends.split())
        return self.write(
            f'{folder or package}/package.xml',
            f'<package format="3">\n  <name>{package}</name>\n{tags}'
            f'  <export><build_type>{build_type}</build_type></export>\n</package>\n',
        )

    def python(self, package: str, scripts: str = '', data: str = '', depends: str = 'rclpy') -> None:
        """An ament_python package; `scripts` are entry points and `data` further data_files."""
        entries = [line.strip() for line in scripts.splitlines() if line.strip()]
        self.manifest(package, 'ament_python', depends)
        self.write(
            f'{package}/setup.cfg', f'[develop]\nscript_dir=$base/lib/{package}\n[install]\ninstall_scripts=$base/lib/{package}\n'
        )
        self.write(f'{package}/resource/{package}')
        self.write(f'{package}/{package}/__init__.py')
        self.write(
            f'{package}/setup.py',
            f"""
            from glob import glob
            from setuptools import find_packages, setup
            setup(name={package!r}, version='0.0.0', packages=find_packages(exclude=['test']),
                  data_files=[('share/ament_index/resource_index/packages', ['resource/{package}']),
                              ('share/{package}', ['package.xml']), {data}],
                  entry_points={{'console_scripts': {entries!r}}})
            """,
        )

    def cmake(self, package: str, text: str, depends: str = '') -> None:
        """An ament_cmake package."""
        self.manifest(package, 'ament_cmake', depends)
        self.write(
            f'{package}/CMakeLists.txt',
            f'cmake_minimum_required(VERSION 3.8)\nproject({package})\n'
            f'find_package(ament_cmake REQUIRED)\n{textwrap.dedent(text)}\nament_package()\n',
        )

    def interfaces(self, package: str, **texts: str) -> None:
        """A package of interfaces: interfaces('robo_msgs', msg_Part='string name')."""
        files = {
            f'{kind}/{name}.{kind}': text
            for kind, name in (key.split('_') for key in texts)
            for text in [texts[f'{kind}_{name}']]
        }
        for file, text in files.items():
            self.write(f'{package}/{file}', text)
        self.cmake(package, f'rosidl_generate_interfaces(${{PROJECT_NAME}} {" ".join(files)})')


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    return Workspace(tmp_path / 'ws')


@pytest.fixture
def another_workspace(tmp_path: Path) -> Workspace:
    return Workspace(tmp_path / 'other')


@pytest.fixture
def node() -> str:
    return NODE


@pytest.fixture
def launch_text() -> Callable[..., str]:
    def text(*nodes: tuple[str, str]) -> str:
        actions = ', '.join(f'Node(package={package!r}, executable={executable!r})' for package, executable in nodes)
        return (
            'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n'
            f'def generate_launch_description():\n    return LaunchDescription([{actions}])\n'
        )

    return text
