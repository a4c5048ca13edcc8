"""The index over workspaces, prefixes and the underlay."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.packages import Index
from edulaunch.engine.packages.reading import Contents, Manifest
from edulaunch.ros.sources import read_source

SETUP = """
from setuptools import setup
setup(packages=['{0}'], data_files=[('share/{0}/launch', ['launch/a.launch.py'])])
"""


MARKERS = 'share/ament_index/resource_index/packages'


def make_prefix(path: Path, package: str) -> Path:
    (path / MARKERS).mkdir(parents=True)
    (path / MARKERS / package).write_text('')
    executable = path / 'lib' / package / 'run.py'
    executable.parent.mkdir(parents=True)
    executable.write_text('#!/usr/bin/env python3\n')
    executable.chmod(0o755)
    return path


def two_packages(workspace: Any) -> Any:
    for name in ('alpha', 'beta'):
        workspace.python_package(name, SETUP.format(name), launch__a='', folder=f'src/{name}')
        workspace.files({f'src/{name}/launch/a.launch.py': ''})
    return workspace


def test_overlays_come_first_then_prefixes_then_the_underlay(workspace: Any, tmp_path: Path) -> None:
    two_packages(workspace)
    prefix = make_prefix(tmp_path / 'opt', 'alpha')
    underlay = tmp_path / 'under'
    for name in ('alpha', 'gamma'):
        (underlay / 'share' / name).mkdir(parents=True)
        (underlay / 'share' / name / 'console_scripts.txt').write_text('go = gamma.go:main\n')
    index = Index([prefix], [workspace.path], read_source=read_source, underlay=str(underlay))
    overlay = index.search_paths()[0]
    assert index.search_paths() == [overlay, str(prefix), str(underlay)]
    assert index.packages() == {'alpha': overlay, 'beta': overlay, 'gamma': str(underlay)}
    program = index.find_program(f'{underlay}/lib/gamma/go')
    assert program is not None
    assert (program.module, program.function) == ('gamma.go', 'main')


def test_a_source_package_looks_installed_and_its_files_lead_back_to_the_source(workspace: Any) -> None:
    index = two_packages(workspace).index()
    launch_file = f'{index.share("alpha")}/launch/a.launch.py'
    assert os.path.isfile(launch_file)
    assert index.source_path(launch_file) == str(workspace.path / 'src/alpha/launch/a.launch.py')
    assert index.source_path(os.path.dirname(launch_file)) == str(workspace.path / 'src/alpha/launch')
    assert index.source_path('/somewhere/else.py') == '/somewhere/else.py'


def test_nothing_is_made_before_a_package_is_asked_for_and_nothing_stays(workspace: Any) -> None:
    index = two_packages(workspace).index()
    prefix = index.search_paths()[0]
    assert not os.path.exists(prefix)
    index.share('alpha')
    assert sorted(os.listdir(f'{prefix}/share')) == ['alpha', 'ament_index']
    del index
    assert not os.path.exists(prefix)


def test_the_prefix_of_a_workspace_has_the_same_path_in_every_run_and_serves_two_indexes(workspace: Any) -> None:
    first, second = two_packages(workspace).index(), workspace.index()
    share = first.share('alpha')
    assert second.share('alpha') == share
    del first
    assert os.path.isfile(f'{share}/package.xml')


def test_both_layouts_of_a_colcon_install_folder_are_read(tmp_path: Path) -> None:
    isolated = tmp_path / 'install'
    make_prefix(isolated / 'alpha', 'alpha')
    make_prefix(isolated / 'beta', 'beta')
    merged = make_prefix(tmp_path / 'merged', 'gamma')
    index = Index([isolated, merged], underlay=None)
    assert index.search_paths() == [str(isolated / 'alpha'), str(isolated / 'beta'), str(merged)]
    assert index.executables('beta') == ['run.py']
    program = index.find_program(f'{isolated}/beta/lib/beta/run.py')
    assert program is not None
    assert (program.kind, program.file) == ('script', f'{isolated}/beta/lib/beta/run.py')


def test_an_installed_entry_point_is_found_through_its_metadata(tmp_path: Path) -> None:
    prefix = make_prefix(tmp_path / 'opt', 'alpha')
    talk = prefix / 'lib' / 'alpha' / 'talk'
    talk.write_text("#!/usr/bin/python3\n# EASY-INSTALL-ENTRY-SCRIPT: 'alpha==0','console_scripts','talk'\n")
    talk.chmod(0o755)
    metadata = prefix / 'lib' / 'python3.12' / 'site-packages' / 'alpha-0-py3.12.egg-info'
    metadata.mkdir(parents=True)
    (metadata / 'entry_points.txt').write_text('[console_scripts]\ntalk = alpha.talker:main\n')
    program = Index([prefix], underlay=None).find_program(str(talk))
    assert program is not None
    assert (program.kind, program.module, program.function) == ('entry_point', 'alpha.talker', 'main')
    assert program.python_roots == (str(metadata.parent),)


def test_a_compiled_program_of_a_prefix_is_not_ours_to_run(tmp_path: Path) -> None:
    prefix = make_prefix(tmp_path / 'opt', 'alpha')
    binary = prefix / 'lib' / 'alpha' / 'drive'
    binary.write_bytes(b'\x7fELF\x02')
    binary.chmod(0o755)
    index = Index([prefix], underlay=None)
    assert index.executables('alpha') == ['drive', 'run.py']
    assert index.find_program(str(binary)) is None


@pytest.mark.parametrize('folder', ['build', 'install', 'log', '.hidden', 'ignored'])
def test_folders_that_colcon_leaves_out_are_left_out(workspace: Any, folder: str) -> None:
    workspace.python_package('alpha', '', folder=f'{folder}/alpha')
    workspace.files({'ignored/COLCON_IGNORE': ''})
    assert workspace.index().packages() == {}


def test_a_package_may_be_the_workspace_itself_and_packages_do_not_nest(workspace: Any) -> None:
    workspace.python_package('alpha', '', folder='.').python_package('beta', '', folder='inner/beta')
    assert list(workspace.index().packages()) == ['alpha']


def test_of_two_packages_with_one_name_the_first_is_used_and_the_other_named(workspace: Any) -> None:
    workspace.python_package('alpha', SETUP.format('alpha'), folder='src/one')
    workspace.python_package('alpha', '', folder='src/two')
    workspace.files({'src/one/launch/a.launch.py': ''})
    assert workspace.installed('alpha') == ['launch/a.launch.py', 'package.xml']
    assert workspace.warnings('alpha') == [
        ("src/two/package.xml: there is a package 'alpha' in src/one/ already, which is used; colcon refuses duplicate names")
    ]


def test_of_two_packages_with_one_name_the_shallower_one_is_used(workspace: Any) -> None:
    workspace.python_package('alpha', '', folder='backup/old/alpha').python_package('alpha', '', folder='src/alpha')
    index = workspace.index()
    assert index.source_folder('alpha') == str(workspace.path / 'src/alpha')
    assert 'backup/old/alpha' in str(index.warnings[0])


def test_links_to_packages_are_followed_and_no_package_is_found_twice(workspace: Any, tmp_path: Path) -> None:
    workspace.python_package('alpha', '', folder='../elsewhere/alpha').python_package('beta', '', folder='src/zeta')
    os.symlink(tmp_path / 'elsewhere', workspace.path / 'src' / 'linked')
    os.symlink(workspace.path, workspace.path / 'src' / 'loop')
    os.symlink(workspace.path / 'src' / 'zeta', workspace.path / 'src' / 'a_link')
    index = workspace.index()
    assert [index.source_folder(name) for name in index.packages()] == [
        str(workspace.path / 'src' / 'linked' / 'alpha'),
        str(workspace.path / 'src' / 'zeta'),
    ]
    assert index.warnings == ()


def test_built_in_programs_stand_in_for_those_that_a_workspace_would_build_from_cpp(workspace: Any) -> None:
    workspace.cmake_package(
        'turtlesim',
        'project(turtlesim)\nadd_executable(turtlesim_node a.cpp)\n'
        'add_executable(own_node b.cpp)\ninstall(TARGETS turtlesim_node own_node DESTINATION lib/turtlesim)',
    )
    index = Index(workspaces=[workspace.path], read_source=read_source)
    path = index.find_executable('turtlesim', 'turtlesim_node')
    assert path is not None and path.startswith(index.search_paths()[0]) and 'turtlesim_node' in index.executables('turtlesim')
    program = index.find_program(path)
    assert program is not None and program.path == path and program.kind == 'entry_point'
    assert [str(warning) for warning in index.warnings] == [
        f'{workspace.path}/turtlesim/CMakeLists.txt:2: turtlesim_node is built from C++, which does not run here; '
        'the built-in turtlesim has it and is used'
    ]


def test_the_packages_of_ros_that_are_only_modules_are_packages_too() -> None:
    assert {'rclpy', 'launch', 'launch_ros', 'ament_index_python', 'tf2_ros', 'turtlesim'} <= Index().packages().keys()
    assert not [name for name in Index().packages() if name.startswith('_')]


@pytest.mark.parametrize(
    ('text', 'sentence'),
    [
        (
            '<package>\n<name>alpha</name>\n',
            (':3: this is not well-formed XML (no element found: line 3, column 0), so colcon skips the package'),
        ),
        ('<package/>', ": has no usable <name> inside <package> (found ''), so colcon skips the package"),
    ],
)
def test_a_broken_package_xml_is_a_warning(workspace: Any, text: str, sentence: str) -> None:
    workspace.files({'alpha/package.xml': text})
    index = workspace.index()
    assert index.packages() == {}
    assert [str(warning) for warning in index.warnings] == [f'{workspace.path}/alpha/package.xml{sentence}']


def test_questions_about_unknown_packages_have_empty_answers(workspace: Any) -> None:
    index = two_packages(workspace).index()
    assert (index.prefix('x'), index.share('x'), index.executables('x'), index.find_executable('alpha', 'x')) == (
        None,
        None,
        [],
        None,
    )
    assert index.find_program('ls') is None
    assert index.find_program('/usr/bin/ls') is None


def test_links_fall_back_to_copies(workspace: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise OSError('no links here')

    monkeypatch.setattr(os, 'symlink', refuse)
    index = two_packages(workspace).index()
    copy = f'{index.share("alpha")}/launch/a.launch.py'
    assert os.path.isfile(copy)
    assert not os.path.islink(copy)
    assert index.source_path(copy) == str(workspace.path / 'src/alpha/launch/a.launch.py')


def test_rviz2_is_on_the_path() -> None:
    program = Index().find_program('rviz2')
    assert program is not None and program.package == 'rviz2'


@pytest.mark.parametrize(('file', 'kind'), [('setup.py', 'Python'), ('CMakeLists.txt', 'CMake')])
def test_colcon_builds_a_folder_with_a_broken_package_xml_as_another_kind_of_package(
    workspace: Any, file: str, kind: str
) -> None:
    workspace.files({'alpha/package.xml': '<package/>', f'alpha/{file}': ''})
    index = workspace.index()
    assert index.packages() == {}
    assert str(index.warnings[0]).endswith(
        f'so colcon builds it as a plain {kind} package, which `ros2 launch` and `ros2 run` do not find'
    )


def test_what_is_no_longer_installed_goes_though_somebody_else_uses_the_folder(workspace: Any) -> None:
    setup = "from setuptools import setup\nsetup(packages=['alpha'], data_files=[('share/alpha/launch', [{files}])])\n"
    both = ("'launch/a.launch.py', 'launch/b.launch.py'", "'launch/b.launch.py'")
    workspace.files({'alpha/launch/a.launch.py': '', 'alpha/launch/b.launch.py': ''})
    workspace.python_package('alpha', setup.format(files=both[0]))
    first = workspace.index()
    share = first.share('alpha')
    assert sorted(os.listdir(f'{share}/launch')) == ['a.launch.py', 'b.launch.py']
    workspace.files({'alpha/setup.py': setup.format(files=both[1])})
    second = workspace.index()
    assert second.share('alpha') == share
    assert os.listdir(f'{share}/launch') == ['b.launch.py']


def test_source_workspaces_need_a_reader_of_their_build_files(tmp_path: Path) -> None:
    with pytest.raises(TypeError, match='needs read_source'):
        Index(workspaces=[tmp_path])
    read: list[str] = []

    def reader(manifest: Manifest) -> Contents:
        read.append(manifest.name)
        return Contents()

    (tmp_path / 'package.xml').write_text('<package><name>robo</name></package>', encoding='utf-8')
    assert Index(workspaces=[tmp_path], read_source=reader).executables('robo') == []
    assert read == ['robo']


def test_of_two_packages_with_one_name_the_nearer_one_counts(workspace: Any) -> None:
    for week in ('week2', 'week3'):
        workspace.python_package('alpha', SETUP.format('alpha'), launch__a='', folder=f'src/{week}/alpha')
    for near, used in {'src/week3': 'week3', 'src/week3/alpha': 'week3', 'src': 'week2', '../elsewhere': 'week2'}.items():
        index = Index((), [workspace.path], read_source=read_source, near=str(workspace.path / near))
        assert index.source_folder('alpha') == str(workspace.path / 'src' / used / 'alpha')


def test_a_clone_of_launch_does_not_hide_the_built_in_one(workspace: Any) -> None:
    for name in ('launch', 'mine'):
        workspace.python_package(name, SETUP.format(name), launch__a='', folder=f'src/{name}')
        workspace.files({f'src/{name}/{name}/__init__.py': ''})
    index = workspace.index()
    assert [root for root in index.python_roots() if root.startswith(str(workspace.path))] == [str(workspace.path / 'src/mine')]
    assert 'launch' not in index.python_modules()


def test_a_clone_of_edulaunch_in_a_workspace_adds_no_packages(workspace: Any) -> None:
    two_packages(workspace)
    (workspace.path / 'src' / 'edulaunch').symlink_to(Path(__file__).parents[3])
    assert [name for name in workspace.index().packages() if name not in Index().packages()] == ['alpha', 'beta']
