"""The files of a package that `ros2 pkg create` makes."""

from __future__ import annotations

import ast
import configparser
from typing import Any

import pytest

from edulaunch.advice.workspace.package_files import LICENSES, NewPackage, cmake_text, license_notice, write_cmake, write_python


class Writer:
    def __init__(self) -> None:
        self.said: list[str] = []
        self.folders: list[str] = []
        self.files: dict[str, str] = {}

    def say(self, text: str) -> None:
        self.said.append(text)

    def folder(self, path: str) -> None:
        self.folders.append(path)

    def file(self, path: str, text: str) -> None:
        self.files[path] = text


def written(write: Any, **changes: Any) -> Writer:
    writer = Writer()
    write(NewPackage('robot', **changes), writer)
    return writer


PYTHON = [
    'setup.py',
    'setup.cfg',
    'resource/robot',
    'robot/__init__.py',
    'test/test_copyright.py',
    'test/test_flake8.py',
    'test/test_pep257.py',
]


@pytest.mark.parametrize(
    ('given', 'more'),
    [
        ({}, []),
        ({'node_name': 'talker'}, ['robot/talker.py']),
        ({'library_name': 'tools'}, ['robot/tools/__init__.py']),
        ({'library_name': 'tools', 'node_name': 'talker'}, ['robot/tools/__init__.py', 'robot/talker.py']),
    ],
)
def test_a_python_package(given: dict[str, str], more: list[str]) -> None:
    writer = written(write_python, **given)
    assert list(writer.files) == [*PYTHON, *more]
    assert writer.said == ['creating source folder']
    assert writer.folders == ['robot', 'resource', 'test', *(['robot/tools'] if 'library_name' in given else [])]
    for path, text in writer.files.items():
        if path.endswith('.py'):
            ast.parse(text)


def test_setup_py_has_what_was_given() -> None:
    files = written(write_python, node_name='talker', license="O'Neil", maintainer_name='Ann', maintainer_email='a@b.c').files
    call: Any = next(
        node
        for node in ast.walk(ast.parse(files['setup.py']))
        if isinstance(node, ast.Call) and getattr(node.func, 'id', '') == 'setup'
    )
    words = {word.arg: word.value for word in call.keywords}
    for name, value in (('license', "O'Neil"), ('maintainer', 'Ann'), ('maintainer_email', 'a@b.c'), ('zip_safe', True)):
        assert ast.literal_eval(words[name]) == value
    assert ast.literal_eval(words['entry_points']) == {'console_scripts': ['talker = robot.talker:main']}
    assert ast.literal_eval(words['description']) == 'TODO: Package description'
    settings = configparser.ConfigParser()
    settings.read_string(files['setup.cfg'].replace('%', '%%'))
    assert (settings['develop']['script_dir'], settings['install']['install_scripts']) == ('$base/lib/robot', '$base/lib/robot')


def test_the_programs_of_new_packages_say_hello(capsys: pytest.CaptureFixture[str]) -> None:
    exec(
        compile(written(write_python, node_name='talker').files['robot/talker.py'], 'talker.py', 'exec'), {'__name__': '__main__'}
    )
    assert 'robot' in capsys.readouterr().out


@pytest.mark.parametrize(
    ('given', 'files'),
    [
        ({}, ['CMakeLists.txt']),
        ({'node_name': 'talker'}, ['CMakeLists.txt', 'src/talker.cpp']),
        ({'library_name': 'my_tools'}, ['CMakeLists.txt', 'include/robot/my_tools.hpp', 'src/my_tools.cpp']),
    ],
)
def test_a_cmake_package(given: dict[str, str], files: list[str]) -> None:
    writer = written(write_cmake, **given)
    assert (list(writer.files), writer.folders) == (files, ['src', 'include/robot'])
    assert writer.said == ['creating source and include folder']


def test_a_library_has_a_class_of_its_name() -> None:
    files = written(write_cmake, library_name='my_tools').files
    header = files['include/robot/my_tools.hpp']
    assert header.splitlines()[:2] == ['#ifndef ROBOT__MY_TOOLS_HPP_', '#define ROBOT__MY_TOOLS_HPP_']
    assert 'class MyTools\n' in header
    assert '#include "robot/my_tools.hpp"' in files['src/my_tools.cpp']


def test_cmake_finds_and_uses_what_the_package_needs() -> None:
    text = cmake_text(NewPackage('robot', dependencies=('rclcpp', 'std_msgs'), node_name='talker', library_name='tools'))
    assert 'find_package(rclcpp REQUIRED)\nfind_package(std_msgs REQUIRED)\n' in text
    for target in ('talker', 'tools'):
        assert f'ament_target_dependencies({target}\n  rclcpp\n  std_msgs\n)' in text
    assert (text.index('add_library(tools src/tools.cpp)'), text.index('ament_package()')) == tuple(
        sorted((text.index('add_library(tools src/tools.cpp)'), text.index('ament_package()')))
    )
    alone = cmake_text(NewPackage('robot', node_name='talker'))
    assert ('add_executable(talker src/talker.cpp)' in alone, 'ament_target_dependencies' in alone, 'add_library' in alone) == (
        True,
        False,
        False,
    )


@pytest.mark.parametrize('identifier', sorted(LICENSES))
def test_a_known_licence_is_named_by_its_spdx_name(identifier: str) -> None:
    notice = license_notice(identifier, 'Ann')
    assert notice is not None
    spdx = 'BSD-3-Clause' if identifier == 'BSD-2.0' else identifier
    assert notice.splitlines()[0] == f'SPDX-License-Identifier: {spdx}'
    assert 'Copyright holder: Ann\n' in notice
    assert LICENSES[identifier] in notice


def test_an_unknown_licence_has_no_notice() -> None:
    assert license_notice('My own', 'Ann') is None
    assert (NewPackage('a').folder, NewPackage('a', '/x').folder) == ('./a', '/x/a')
