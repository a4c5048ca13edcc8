"""Common mistakes, each named with its place and what to do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from edulaunch.workspace.mistakes import find_mistakes


def found(workspace: Any) -> list[str]:
    base = str(workspace.folder)
    return [mistake.text(base) for mistake in find_mistakes(base).mistakes]


@pytest.fixture
def robo(workspace: Any, node: str) -> Any:
    workspace.python('robo', 'drive = robo.drive:main')
    workspace.write('robo/robo/drive.py', node)
    return workspace


def test_a_good_package_has_none(robo: Any) -> None:
    assert found(robo) == []


def test_a_launch_file_that_is_not_installed(robo: Any) -> None:
    robo.write('robo/launch/go.launch.py', 'def generate_launch_description():\n    return None\n')
    assert found(robo) == [
        'robo/launch/go.launch.py: this launch file is not installed, so `ros2 launch robo go.launch.py` does not find it\n'
        "  help: add (os.path.join('share', package_name, 'launch'), glob('launch/*launch.[pxy][yma]*')) to data_files of setup.py"
    ]


def test_a_parameter_file_that_is_not_installed(robo: Any) -> None:
    robo.write('robo/config/wheels.yaml', '{}')
    assert found(robo)[0].startswith('robo/config/wheels.yaml: this file is not installed')


@pytest.mark.parametrize(
    ('scripts', 'sentence', 'help'),
    [
        ('drive = robo.drvie:main', "names the module 'robo.drvie', which is not there", "did you mean 'robo.drive'?"),
        ('drive = robo.drive:mian', "names the function 'mian', which robo/drive.py does not have", "did you mean 'main'?"),
    ],
)
def test_an_entry_point_that_names_nothing(workspace: Any, node: str, scripts: str, sentence: str, help: str) -> None:
    workspace.python('robo', scripts)
    workspace.write('robo/robo/drive.py', node)
    first = next(line for line in found(workspace) if 'setup.py:' in line)
    assert sentence in first and first.endswith(f'  help: {help}')


def test_a_node_without_an_entry_point(robo: Any, node: str) -> None:
    robo.write('robo/robo/brake.py', node)
    assert found(robo) == [
        'robo/robo/brake.py: this node has no entry point, so `ros2 run robo brake` does not find it\n'
        "  help: add 'brake = robo.brake:main' to console_scripts of setup.py"
    ]


def test_a_dependency_that_package_xml_does_not_name(robo: Any) -> None:
    robo.write('robo/robo/extra.py', 'import math\nfrom geometry_msgs.msg import Twist\nimport geometry_msgs.msg\n')
    assert found(robo) == [
        'robo/robo/extra.py:2: geometry_msgs is imported here, but package.xml does not name it\n'
        '  help: add <exec_depend>geometry_msgs</exec_depend> to package.xml'
    ]


def test_a_package_that_is_launched_and_not_named(workspace: Any) -> None:
    workspace.cmake('robo', 'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})', 'launch')
    workspace.write('robo/launch/go.launch.xml', '<launch>\n  <node pkg="turtlesim" exec="turtlesim_node"/>\n</launch>\n')
    assert [line.splitlines()[0] for line in found(workspace)] == [
        'robo/launch/go.launch.xml:2: turtlesim is launched here, but package.xml does not name it'
    ]


def test_a_setup_cfg_that_does_not_say_where_executables_go(robo: Any) -> None:
    robo.write('robo/setup.cfg', '')
    assert found(robo)[0].startswith('robo/setup.cfg: has no install_scripts=$base/lib/robo below [install]')


def test_scripts_of_a_cmake_package(workspace: Any, node: str) -> None:
    main = node + "\n\nif __name__ == '__main__':\n    main()\n"
    workspace.cmake(
        'robo',
        'install(PROGRAMS scripts/one.py DESTINATION lib/${PROJECT_NAME})\n'
        'install(FILES scripts/two.py DESTINATION lib/${PROJECT_NAME})',
        'rclpy',
    )
    for name in ('one', 'two', 'three'):
        workspace.write(f'robo/scripts/{name}.py', main)
    assert [line.splitlines()[0] for line in found(workspace)] == [
        'robo/scripts/one.py:1: this program has no first line that says what runs it, so it fails with "Exec format error"',
        'robo/scripts/three.py: this program is not installed, so `ros2 run robo three.py` does not find it',
        'robo/scripts/two.py: this program is installed as a plain file that may not be executed',
    ]


def test_files_that_are_no_python(robo: Any) -> None:
    robo.write('robo/robo/tabs.py', 'def f():\n\tif 1:\n        return 2\n')
    (robo.folder / 'robo/robo/latin.py').write_bytes(b'NAME = "gr\xfc\xdfe"\n')
    robo.write('robo/robo/words.py', 'NAME = "grüße"\n')
    lines = found(robo)
    assert len(lines) == 2 and 'latin.py' in lines[0] and lines[0].endswith('save the file as UTF-8')
    assert lines[1].startswith('robo/robo/tabs.py:3: Python cannot read this file: inconsistent use of tabs and spaces')


def test_the_same_package_twice(robo: Any) -> None:
    robo.manifest('robo', 'ament_python', folder='old/robo')
    assert any("there is a package 'robo' in" in line for line in found(robo))


def test_build_output_in_a_repository(robo: Any) -> None:
    (robo.folder / '.git').mkdir()
    robo.write('install/local_setup.bash')
    robo.write('install/robo/share/robo/package.xml', '<package><name>robo</name></package>')
    assert found(robo) == [
        'install: colcon made this folder; it belongs to one machine and is ignored here\n'
        '  help: put install/ into .gitignore, and take it out of the repository with: git rm -r --cached install'
    ]
    robo.write('.gitignore', 'install/\n')
    assert found(robo) == []


def test_a_package_at_the_root_of_its_repository(tmp_path: Path) -> None:
    (tmp_path / '.git').mkdir()
    (tmp_path / 'package.xml').write_text('<package><name>robo</name></package>')
    (tmp_path / 'CMakeLists.txt').write_text('project(robo)\n')
    assert 'the package is the root of the repository' in find_mistakes(str(tmp_path)).mistakes[0].sentence


def test_a_folder_without_packages(tmp_path: Path) -> None:
    assert [mistake.sentence for mistake in find_mistakes(str(tmp_path)).mistakes] == [
        'no package is here: no folder has a package.xml'
    ]


@pytest.mark.parametrize('file', ['test/test_robo.launch.py', 'test/robo_launch.py', 'robo_test.launch.py'])
def test_a_launch_test_need_not_be_installed(workspace: Any, node: str, file: str) -> None:
    workspace.python('robo', 'drive = robo.drive:main')
    workspace.write('robo/robo/drive.py', node)
    workspace.write(f'robo/{file}', 'def generate_test_description():\n    return None\n')
    assert find_mistakes(str(workspace.folder)).mistakes == []
