"""Which workspaces are meant when none is named."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import edulaunch
from edulaunch.engine.packages.discovery import find_workspaces, workspace_around
from edulaunch.engine.underlay_place import underlay_prefix


def package(path: Path) -> Path:
    path.mkdir(parents=True)
    (path / 'package.xml').write_text(f'<package format="3"><name>{path.name}</name></package>')
    return path


@pytest.fixture
def ws(tmp_path: Path) -> Path:
    for name in ('robo', 'stack/arm'):
        package(tmp_path / 'my_ws' / 'src' / name)
    return tmp_path / 'my_ws'


@pytest.mark.parametrize('here', ['.', 'src', 'src/robo', 'src/robo/launch', 'src/stack/arm', 'build/x'])
def test_it_is_found_upwards_from_the_current_folder(ws: Path, here: str) -> None:
    (ws / here).mkdir(parents=True, exist_ok=True)
    assert find_workspaces(str(ws / here), {}) == [str(ws)]


def test_it_is_found_one_level_below_when_nothing_is_above(ws: Path) -> None:
    package(ws.parent / 'other_ws' / 'src' / 'leg')
    assert find_workspaces(str(ws.parent), {}) == [str(ws), str(ws.parent / 'other_ws')]
    assert find_workspaces(str(ws.parent / 'nothing'), {}) == []


def test_packages_beside_each_other_make_their_folder_a_workspace_and_a_lone_one_is_its_own(tmp_path: Path) -> None:
    one = package(tmp_path / 'repo' / 'one')
    assert workspace_around(str(one / 'launch' / 'a.launch.py')) == str(one)
    package(tmp_path / 'repo' / 'two')
    assert workspace_around(str(one / 'launch' / 'a.launch.py')) == str(tmp_path / 'repo')
    assert find_workspaces(str(tmp_path / 'repo'), {}) == [str(tmp_path / 'repo')]
    assert workspace_around(str(tmp_path)) is None


def test_the_launch_files_own_workspace_comes_before_that_of_the_current_folder(ws: Path, tmp_path: Path) -> None:
    here = package(tmp_path / 'here_ws' / 'src' / 'leg')
    found = find_workspaces(str(here), {}, launch_file=str(ws / 'src' / 'robo' / 'launch' / 'a.launch.py'))
    assert found == [str(ws), str(tmp_path / 'here_ws')]


def test_the_launch_files_own_workspace_comes_before_those_beside_it(ws: Path) -> None:
    package(ws.parent / 'a_ws' / 'src' / 'robo')
    found = find_workspaces(str(ws.parent), {}, launch_file=str(ws / 'src' / 'robo' / 'launch' / 'a.launch.py'))
    assert found == [str(ws), str(ws.parent / 'a_ws')]


def test_what_edulaunch_workspaces_names_comes_first(ws: Path, tmp_path: Path) -> None:
    named = tmp_path / 'named'
    named.mkdir()
    env = {'EDULAUNCH_WORKSPACES': os.pathsep.join((str(named), '../gone', ''))}
    assert find_workspaces(str(ws), env) == [str(named), str(ws)]


@pytest.mark.parametrize('variable', ['AMENT_PREFIX_PATH', 'COLCON_PREFIX_PATH'])
@pytest.mark.parametrize('with_sources', [True, False])
def test_a_sourced_install_folder_leads_to_its_sources_if_they_are_there(
    tmp_path: Path, variable: str, with_sources: bool
) -> None:
    install = tmp_path / 'some_ws' / 'install'
    (install / 'robo' / 'share' / 'ament_index').mkdir(parents=True)
    (install / '.colcon_install_layout').write_text('isolated')
    if with_sources:
        package(tmp_path / 'some_ws' / 'src' / 'robo')
    (tmp_path / 'here').mkdir()
    prefix = install / 'robo' if variable == 'AMENT_PREFIX_PATH' else install
    found = find_workspaces(str(tmp_path / 'here'), {variable: f'{prefix}{os.pathsep}/no/such'})
    assert found == [str(tmp_path / 'some_ws' if with_sources else install)]


def test_ros_itself_and_what_is_built_in_are_no_workspaces(tmp_path: Path) -> None:
    (tmp_path / 'jazzy' / 'share' / 'rclpy').mkdir(parents=True)
    env = {'AMENT_PREFIX_PATH': os.pathsep.join((str(tmp_path / 'jazzy'), underlay_prefix()))}
    assert find_workspaces(str(tmp_path), env) == []
    multisim = os.path.join(underlay_prefix(), 'share', 'turtlesim', 'launch', 'multisim.launch.py')
    assert find_workspaces(str(tmp_path), {}, launch_file=multisim) == []


def test_a_home_folder_is_no_workspace_as_a_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('HOME', str(tmp_path))
    inside = package(tmp_path / 'src' / 'robo')
    assert find_workspaces(str(inside), {}) == [str(tmp_path / 'src')]


def test_run_finds_the_package_of_its_launch_file(ws: Path) -> None:
    robo = ws / 'src' / 'robo'
    (robo / 'setup.py').write_text(
        "from setuptools import setup\nsetup(packages=['robo'], entry_points={'console_scripts': ['hello = robo.hello:main']})\n"
    )
    (robo / 'setup.cfg').write_text('[install]\ninstall_scripts=$base/lib/robo\n')
    (robo / 'robo').mkdir()
    (robo / 'robo' / '__init__.py').write_text('')
    (robo / 'robo' / 'hello.py').write_text("def main():\n    print('hello from robo')\n")
    file = robo / 'go.launch.xml'
    file.write_text('<launch><node pkg="robo" exec="hello" output="screen"/></launch>')
    recording = edulaunch.run(file, duration_s=1)
    assert any('hello from robo' in line.text for line in recording.output)
    with pytest.raises(edulaunch.LaunchFileError, match="package 'robo' not found"):
        edulaunch.run(file, duration_s=1, workspaces=[])


def test_packages_deeper_in_the_current_folder_are_found_with_a_launch_file_of_theirs(tmp_path: Path) -> None:
    one = package(tmp_path / 'repo' / 'group' / 'one')
    package(tmp_path / 'repo' / 'other' / 'two')
    here = str(tmp_path / 'repo')
    assert find_workspaces(here, {}) == []
    assert find_workspaces(here, {}, str(one / 'launch' / 'a.launch.py')) == [str(one), here]


@pytest.mark.parametrize('here', ['.', 'src', 'build'])
def test_a_cloned_repository_with_a_folder_src_of_its_own_is_a_part_of_the_workspace(tmp_path: Path, here: str) -> None:
    package(tmp_path / 'ws' / 'src' / 'repo' / 'src' / 'group' / 'leg')
    (tmp_path / 'ws' / here).mkdir(exist_ok=True)
    assert find_workspaces(str(tmp_path / 'ws' / here), {}) == [str(tmp_path / 'ws')]


def test_the_search_for_a_first_package_has_an_end(tmp_path: Path) -> None:
    for number in range(1100):
        (tmp_path / 'ws' / 'src' / f'{number:04}').mkdir(parents=True)
    package(tmp_path / 'ws' / 'src' / '1099' / 'leg')
    assert find_workspaces(str(tmp_path / 'ws'), {}) == []
