"""Mistakes in packages, beyond the examples of tests/advice: what looks like one and is none, and what only a tree can show."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from edulaunch.advice import judge_sources, rendered
from edulaunch.advice.reader import Reader
from edulaunch.desk.cli.main import main


def said(folder: Path) -> list[str]:
    """Place and sentence of each finding."""
    lines = [rendered(finding, Reader(folder=str(folder))) for finding in judge_sources(str(folder))]
    return [f'{line.where}: {line.what}' for line in lines]


@pytest.fixture
def robo(workspace: Any, node: str) -> Any:
    workspace.python('robo', 'drive = robo.drive:main')
    workspace.write('robo/robo/drive.py', node)
    return workspace


def test_a_good_package_has_none(robo: Any, capsys: pytest.CaptureFixture[str]) -> None:
    assert said(robo.folder) == []
    assert main(['pkg', 'check', str(robo.folder)]) == 0
    assert capsys.readouterr().out == '1 package checked (robo): no findings\n'


def test_pkg_check_tells_each_with_its_place_and_what_to_do(robo: Any, node: str, capsys: pytest.CaptureFixture[str]) -> None:
    robo.write('robo/robo/brake.py', node)
    assert main(['pkg', 'check', str(robo.folder)]) == 1
    assert capsys.readouterr().out == (
        'robo/robo/brake.py: brake.py has a main() that starts a node, but no entry point\n'
        "  help: add 'brake = robo.brake:main' to console_scripts in setup.py if you want to start it with `ros2 run`\n"
        '1 package checked (robo): 1 finding\n'
    )


def test_an_entry_point_that_is_misspelled_is_one_mistake(workspace: Any, node: str) -> None:
    workspace.python('robo', 'drive = robo.drvie:main')
    workspace.write('robo/robo/drive.py', node)
    assert [line.partition(': ')[2] for line in said(workspace.folder)] == [
        "the entry point 'drive = robo.drvie:main' names the module robo.drvie, which does not exist"
    ]


def test_a_dependency_is_missed_once_where_it_is_first_used(robo: Any) -> None:
    robo.write('robo/robo/extra.py', 'import math\nfrom geometry_msgs.msg import Twist\nimport geometry_msgs.msg\n')
    assert said(robo.folder) == ['robo/robo/extra.py:2: geometry_msgs is imported here, but package.xml does not name it']


def test_a_package_that_is_launched_and_not_named(workspace: Any) -> None:
    workspace.cmake('robo', 'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})', 'launch')
    workspace.write('robo/launch/go.launch.xml', '<launch>\n  <node pkg="turtlesim" exec="turtlesim_node"/>\n</launch>\n')
    assert said(workspace.folder) == ['robo/launch/go.launch.xml:2: turtlesim is launched here, but package.xml does not name it']


def test_scripts_of_a_cmake_package(workspace: Any, node: str) -> None:
    text = node + "\n\nif __name__ == '__main__':\n    main()\n"
    workspace.cmake(
        'robo',
        'install(PROGRAMS scripts/one.py DESTINATION lib/${PROJECT_NAME})\n'
        'install(FILES scripts/two.py DESTINATION lib/${PROJECT_NAME})',
        'rclpy',
    )
    for name in ('one', 'two', 'three'):
        workspace.write(f'robo/scripts/{name}.py', text)
    assert said(workspace.folder) == [
        'robo/scripts/one.py:1: the first line of the program one.py does not name its interpreter',
        'robo/scripts/two.py: CMake installs two.py without the execute permission',
        'robo/scripts/three.py: three.py starts a node, but the build of robo does not install it',
    ]


@pytest.mark.parametrize(
    'end', ['main()', 'if __name__ == "__main__":\n    sys.exit(main())', 'try:\n    main()\nexcept KeyboardInterrupt:\n    pass']
)
def test_a_program_that_calls_main_in_any_way_is_right(workspace: Any, node: str, end: str) -> None:
    workspace.cmake('robo', 'install(PROGRAMS one.py DESTINATION lib/${PROJECT_NAME})', 'rclpy')
    workspace.write('robo/one.py', f'#!/usr/bin/env python3\nimport sys\n{node}\n\n{end}\n')
    assert said(workspace.folder) == []


def test_files_that_are_no_python(robo: Any) -> None:
    (robo.folder / 'robo/robo/latin.py').write_bytes(b'NAME = "gr\xfc\xdfe"\n')
    robo.write('robo/robo/words.py', 'NAME = "grüße"\n')
    (only,) = judge_sources(str(robo.folder))
    assert rendered(only).do == 'save latin.py as UTF-8'


def test_the_same_package_twice(robo: Any) -> None:
    robo.manifest('robo', 'ament_python', folder='old/robo')
    assert any('two packages have the name robo' in line for line in said(robo.folder))


def test_build_output_in_a_repository(robo: Any) -> None:
    (robo.folder / '.git').mkdir()
    robo.write('install/local_setup.bash')
    robo.write('install/robo/share/robo/package.xml', '<package><name>robo</name></package>')
    (first, *_) = judge_sources(str(robo.folder))
    assert (first.rule, rendered(first).what) == (
        'packages.build-output-committed',
        'the repository contains install/, which colcon created',
    )
    robo.write('.gitignore', 'install/\n')
    assert not any('was made by colcon' in line for line in said(robo.folder))


def test_a_package_at_the_root_of_its_repository_is_no_mistake(tmp_path: Path) -> None:
    (tmp_path / '.git').mkdir()
    (tmp_path / 'package.xml').write_text('<package><name>robo</name></package>')
    (tmp_path / 'CMakeLists.txt').write_text('project(robo)\n')
    assert said(tmp_path) == []


def test_a_package_xml_that_cannot_be_read_is_told_and_not_that_there_is_no_package(tmp_path: Path) -> None:
    (tmp_path / 'package.xml').write_text('<package><name>robo</name>')
    (line,) = said(tmp_path)
    assert 'not well-formed XML' in line


@pytest.mark.parametrize('file', ['test/test_robo.launch.py', 'test/robo_launch.py', 'robo_test.launch.py'])
def test_a_launch_test_need_not_be_installed(robo: Any, file: str) -> None:
    robo.write(f'robo/{file}', 'def generate_test_description():\n    return None\n')
    assert said(robo.folder) == []


def test_a_build_of_links_or_of_the_same_text_is_not_old(robo: Any) -> None:
    place = robo.folder / 'install/robo/lib/python3.12/site-packages/robo'
    robo.write('install/robo/share/robo/package.xml', (robo.folder / 'robo/package.xml').read_text())
    place.mkdir(parents=True)
    (place / '__init__.py').symlink_to(robo.folder / 'robo/robo/__init__.py')
    (place / 'drive.py').write_bytes((robo.folder / 'robo/robo/drive.py').read_bytes())
    assert said(robo.folder) == []
    (place / 'drive.py').write_text('')
    assert said(robo.folder) == ['robo/robo/drive.py: robo has changed since it was built: robo/drive.py']


def test_a_macro_of_another_package_may_install_what_nothing_else_does(workspace: Any, node: str) -> None:
    workspace.cmake('robo', 'company_install_all()', 'rclpy launch')
    workspace.write('robo/launch/go.launch.py', 'from launch import LaunchDescription\n')
    workspace.write('robo/scripts/one.py', node)
    assert said(workspace.folder) == []


def test_what_is_in_a_comment_is_not_launched(workspace: Any) -> None:
    workspace.cmake('robo', 'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})', 'launch')
    workspace.write('robo/launch/a.launch.py', "# Node(package='turtlesim')\n")
    workspace.write('robo/launch/b.launch.xml', '<launch>\n<!--\n<node pkg="turtlesim" exec="x"/>\n-->\n</launch>\n')
    assert said(workspace.folder) == []


def test_an_entry_point_may_name_a_module_of_another_package(workspace: Any, node: str) -> None:
    workspace.python('arm', '')
    workspace.write('arm/arm/move.py', node)
    workspace.python('robo', 'move = arm.move:main')
    assert [line for line in said(workspace.folder) if 'entry point ' in line] == []


def test_a_file_that_is_missing_is_to_be_created_not_corrected(robo: Any) -> None:
    (robo.folder / 'robo' / 'setup.py').unlink()
    first = rendered(judge_sources(str(robo.folder))[0], Reader(folder=str(robo.folder)))
    assert first.what == 'setup.py is missing, so this ament_python package cannot be built'
    assert first.do.startswith('create setup.py: with metadata in setup.cfg or pyproject.toml, ')
