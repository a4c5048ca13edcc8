"""The folder of links that stands for a build of a workspace, and what the workspace answers about its packages."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.packages import workspace as module
from edulaunch.engine.packages.reading import Contents, PackageWarning
from edulaunch.engine.packages.workspace import Image, Workspace
from edulaunch.ros.sources import read_source

SETUP = """from setuptools import setup
setup(name='robo', packages=['robo'], data_files=[('share/robo', ['package.xml']), ('share/robo/launch', ['launch/a.launch.py'])],
      entry_points={'console_scripts': ['walk = robo.walk:main', 'run = robo.run:go']})
"""
LISTS = """find_package(ament_cmake REQUIRED)
install(PROGRAMS scripts/tool.py scripts/tool.sh DESTINATION lib/${PROJECT_NAME})
"""


@pytest.fixture
def opened(workspace: Any) -> Workspace:
    workspace.python_package('robo', SETUP, **{'launch__a.launch.py': '', 'robo__walk.py': '', 'robo__run.py': ''})
    scripts = {'scripts/tool.py': '#!/usr/bin/env python3\n', 'scripts/tool.sh': '#!/bin/sh\n'}
    workspace.cmake_package('tools', f'project(tools)\n{LISTS}', scripts)
    return Workspace(str(workspace.path), read_source, [])


def test_a_workspace_names_its_packages_their_programs_and_their_modules(opened: Workspace) -> None:
    assert opened.packages() == ['robo', 'tools']
    assert [opened.executables(name) for name in opened.packages()] == [['run', 'walk'], ['tool.py', 'tool.sh']]
    assert opened.modules() == {'robo': f'{opened.folder}/robo/robo'}
    assert opened.package_folder('tools') == f'{opened.folder}/tools'


def test_an_entry_point_and_a_script_are_programs_and_a_shell_script_is_none(opened: Workspace) -> None:
    walk, tool = opened.program('robo', 'walk'), opened.program('tools', 'tool.py')
    assert walk is not None and tool is not None
    assert (walk.kind, walk.package, walk.executable, walk.path) == (
        'entry_point',
        'robo',
        'walk',
        f'{opened.path}/lib/robo/walk',
    )
    assert (walk.module, walk.function, walk.python_roots) == ('robo.walk', 'main', (f'{opened.folder}/robo',))
    assert (tool.kind, tool.package, tool.executable, tool.path) == (
        'script',
        'tools',
        'tool.py',
        f'{opened.path}/lib/tools/tool.py',
    )
    assert tool.file == f'{opened.folder}/tools/scripts/tool.py'
    assert opened.program('tools', 'tool.sh') is None and opened.program('robo', 'swim') is None


def test_a_path_in_the_folder_of_links_leads_back_to_the_file_of_the_student(opened: Workspace) -> None:
    opened.install('robo')
    share = f'{opened.path}/share/robo'
    assert os.readlink(f'{share}/launch/a.launch.py') == f'{opened.folder}/robo/launch/a.launch.py'
    assert os.path.isdir(f'{opened.path}/lib/robo')
    ways = {
        f'{share}/launch/a.launch.py': f'{opened.folder}/robo/launch/a.launch.py',
        f'{share}/launch': f'{opened.folder}/robo/launch',
        share: f'{opened.folder}/robo',
        f'{share}/launch/b.launch.py': None,
        f'{share}/laun': None,
        '/etc/hosts': None,
        opened.path + 'x': None,
    }
    assert {path: opened.source_path(path) for path in ways} == ways


def test_a_package_is_read_and_installed_once(opened: Workspace, monkeypatch: pytest.MonkeyPatch) -> None:
    log: list[str] = []
    monkeypatch.setattr(opened, '_read_source', lambda manifest: log.append(manifest.name) or read_source(manifest))
    monkeypatch.setattr(opened._image, 'add', lambda package, contents: log.append(f'install {package}'))
    opened.install('robo')
    opened.install('robo')
    assert opened.executables('robo') and log == ['robo', 'install robo']


def test_what_a_build_would_reject_is_added_to_the_warnings(workspace: Any) -> None:
    workspace.cmake_package('tools', 'project(tools)\ninstall(DIRECTORY absent DESTINATION share/tools)\n')
    warnings: list[PackageWarning] = []
    opened = Workspace(str(workspace.path), read_source, warnings)
    assert opened.packages() == ['tools'] and warnings == []
    opened.executables('tools')
    assert warnings == opened.contents('tools').warnings != []


def contents(**files: str) -> Contents:
    made = Contents()
    made.files.update({name.replace('__', '/'): source for name, source in files.items()})
    return made


def test_a_link_replaces_what_stood_in_its_place(tmp_path: Path) -> None:
    (tmp_path / 'old').write_text('old')
    (tmp_path / 'new').write_text('new')
    image = Image(str(tmp_path / 'ws'))
    place = f'{image.path}/share/robo/a'
    image.add('robo', contents(share__robo__a=str(tmp_path / 'old'), share__robo__b=str(tmp_path / 'old')))
    image.add('robo', contents(share__robo__a=str(tmp_path / 'new')))
    assert (os.readlink(place), os.listdir(f'{image.path}/share/robo')) == (str(tmp_path / 'new'), ['a'])
    os.unlink(place)
    Path(place).write_text('a copy')
    image.add('robo', contents(share__robo__a=str(tmp_path / 'new')))
    assert os.readlink(place) == str(tmp_path / 'new')


def test_the_folder_goes_with_the_last_image_that_uses_it(tmp_path: Path) -> None:
    first, second = Image(str(tmp_path / 'ws')), Image(str(tmp_path / 'ws'))
    assert first.path == second.path and not os.path.exists(first.path)
    folder = first.add_folder('lib/robo')
    assert second.add_folder('lib/robo') == folder == f'{first.path}/lib/robo'
    del first
    assert os.path.isdir(folder)
    del second
    assert not os.path.exists(os.path.dirname(os.path.dirname(folder)))


@pytest.mark.parametrize(('error', 'runs'), [(None, True), (ProcessLookupError, False), (PermissionError, True)])
def test_a_process_runs_unless_the_system_does_not_know_it(
    monkeypatch: pytest.MonkeyPatch, error: type[OSError] | None, runs: bool
) -> None:
    asked: list[tuple[int, int]] = []

    def kill(pid: int, signum: int) -> None:
        asked.append((pid, signum))
        if error is not None:
            raise error

    monkeypatch.setattr(os, 'kill', kill)
    assert module._runs(77) is runs and asked == [(77, 0)]


def test_a_folder_of_another_user_is_not_used(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr('tempfile.gettempdir', lambda: str(tmp_path))
    monkeypatch.setattr('tempfile.tempdir', str(tmp_path))
    mine = module._base()
    assert mine == f'{tmp_path}/edulaunch-{os.getuid()}' and os.stat(mine).st_mode & 0o777 == 0o700
    stranger = os.getuid() + 1
    monkeypatch.setattr(os, 'getuid', lambda: stranger)
    os.rename(mine, f'{tmp_path}/edulaunch-{stranger}')
    other = module._base()
    assert other.startswith(f'{tmp_path}/edulaunch-') and other != f'{tmp_path}/edulaunch-{stranger}'
