"""Packages made by `pkg create`."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.advice import judge_sources
from edulaunch.advice.workspace.new_package import create_package, manifest_text
from edulaunch.advice.workspace.package_files import LICENSES, NewPackage
from edulaunch.engine.packages import Index
from edulaunch.errors import PackageError
from edulaunch.ros.sources import read_source


@pytest.fixture
def create(tmp_path: Path) -> Callable[..., list[str]]:
    def make(name: str, **options: Any) -> list[str]:
        said: list[str] = []
        create_package(NewPackage(name, str(tmp_path), **options), said.append)
        return [line.replace(str(tmp_path), '.') for line in said]

    return make


def test_the_report_of_a_python_package_is_that_of_ros(create: Callable[..., list[str]]) -> None:
    assert create(
        'my_package', build_type='ament_python', license='Apache-2.0', node_name='my_node', dependencies=('rclpy',)
    ) == [
        'going to create a new package',
        'package name: my_package',
        'destination directory: .',
        'package format: 3',
        'version: 0.0.0',
        'description: TODO: Package description',
        "maintainer: ['user <user@todo.todo>']",
        "licenses: ['Apache-2.0']",
        'build type: ament_python',
        "dependencies: ['rclpy']",
        'node_name: my_node',
        'creating folder ./my_package',
        'creating ./my_package/package.xml',
        'creating source folder',
        'creating folder ./my_package/my_package',
        'creating ./my_package/setup.py',
        'creating ./my_package/setup.cfg',
        'creating folder ./my_package/resource',
        'creating ./my_package/resource/my_package',
        'creating ./my_package/my_package/__init__.py',
        'creating folder ./my_package/test',
        'creating ./my_package/test/test_copyright.py',
        'creating ./my_package/test/test_flake8.py',
        'creating ./my_package/test/test_pep257.py',
        'creating ./my_package/my_package/my_node.py',
    ]


def test_a_cmake_package_has_its_own_files(create: Callable[..., list[str]], tmp_path: Path) -> None:
    said = create('robo', license='MIT', node_name='drive', library_name='wheel_parts', dependencies=('rclcpp',))
    assert said[-7:] == [
        'creating source and include folder',
        'creating folder ./robo/src',
        'creating folder ./robo/include/robo',
        'creating ./robo/CMakeLists.txt',
        'creating ./robo/src/drive.cpp',
        'creating ./robo/include/robo/wheel_parts.hpp',
        'creating ./robo/src/wheel_parts.cpp',
    ]
    assert 'class WheelParts' in (tmp_path / 'robo/include/robo/wheel_parts.hpp').read_text()
    assert list(Index([], [tmp_path], read_source=read_source).native_executables('robo')) == ['drive']


def test_a_new_package_is_found_and_runs(create: Callable[..., list[str]], tmp_path: Path) -> None:
    import edulaunch

    create('my_package', build_type='ament_python', node_name='my_node')
    (tmp_path / 'go.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\ndef generate_launch_description():\n'
        "    return LaunchDescription([Node(package='my_package', executable='my_node')])\n"
    )
    recording = edulaunch.run(tmp_path / 'go.launch.py', workspaces=[tmp_path], duration_s=1)
    assert 'Hi from my_package.\n' in [output.text for output in recording.output]
    assert judge_sources(str(tmp_path)) == []


def test_texts_are_safe_inside_the_manifest() -> None:
    text = manifest_text(NewPackage('p', description='a < b & c', maintainer_name='Zoë <x>'))
    assert 'a &lt; b &amp; c' in text and 'Zoë &lt;x&gt;' in text


@pytest.mark.parametrize('license', LICENSES)
def test_known_licenses_get_a_notice(create: Callable[..., list[str]], tmp_path: Path, license: str) -> None:
    said = create('p', license=license)
    assert (tmp_path / 'p/LICENSE').read_text().startswith('SPDX-License-Identifier: ') and 'WARNING' not in said[-1]


def test_an_unknown_license_is_a_warning(create: Callable[..., list[str]], tmp_path: Path) -> None:
    assert create('p', license='Mine')[-1].startswith("\n[WARNING]: Unknown license 'Mine'.")
    assert not (tmp_path / 'p/LICENSE').exists()


@pytest.mark.parametrize(
    ('name', 'options', 'error'),
    [
        ('Robo', {}, "'Robo' cannot be the name of a package"),
        ('a__b', {}, 'cannot be the name'),
        ('robo', {'build_type': 'cmake'}, "unknown build type 'cmake'"),
        ('robo', {'build_type': 'ament_python', 'node_name': 'robo'}, 'cannot have the name of the package'),
        ('there', {}, '\nAborted!\nThe directory already exists: '),
    ],
)
def test_what_cannot_be_made_is_refused(
    create: Callable[..., list[str]], tmp_path: Path, name: str, options: Any, error: str
) -> None:
    (tmp_path / 'there').mkdir()
    with pytest.raises(PackageError) as caught:
        create(name, **options)
    assert error in str(caught.value)
    assert sorted(path.name for path in tmp_path.iterdir()) == ['there']


@pytest.mark.processes
def test_pytest_knows_the_marks_of_a_new_package(create: Callable[..., list[str]], tmp_path: Path) -> None:
    create('my_package', build_type='ament_python')
    done = subprocess.run(
        [
            sys.executable,
            '-m',
            'pytest',
            '-q',
            '-p',
            'no:cacheprovider',
            '-p',
            'no:nbval',
            '-p',
            'no:hypothesispytest',
            '-W',
            'error',
        ],
        cwd=tmp_path / 'my_package',
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0 and '3 skipped' in done.stdout and 'warning' not in done.stdout, done.stdout
