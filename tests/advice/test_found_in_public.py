"""Wrong or weak advice that public launch files and packages of students got, each as a small case of its own."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice import judge_sources
from edulaunch.desk.cli.main import main
from edulaunch.errors import LaunchFileError

UNSEEN = Path(__file__).parent / 'unseen'
LAUNCH = """{imports}
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
{body}
"""
SIM = "Node(package='turtlesim', executable='turtlesim_node', name='sim'{})"


def launch_file(folder: Path, body: str, imports: str = 'import os') -> Path:
    lines = ''.join(f'    {line}\n' for line in body.splitlines())
    (folder / 'main.launch.py').write_text(LAUNCH.format(imports=imports, body=lines.rstrip('\n')))
    return folder / 'main.launch.py'


def reports(file: Path) -> list[str]:
    try:
        return edulaunch.run(file, duration_s=2.0, workspaces=[], console=lambda *_: None).warnings
    except LaunchFileError as error:
        return [str(error)]


def test_launch_description_has_the_classes_that_the_real_module_imports(tmp_path: Path) -> None:
    names = 'from launch.launch_description import Action, DeclareLaunchArgument, LaunchContext, LaunchDescription'
    assert reports(launch_file(tmp_path, f'return LaunchDescription([{SIM.format("")}])', names)) == []


def test_a_misspelt_module_of_launch_has_its_nearest_name(tmp_path: Path) -> None:
    file = launch_file(tmp_path, f'return LaunchDescription([{SIM.format("")}])', 'from launch import acitons')
    assert 'acitons; write actions' in reports(file)[0]


def test_a_declaration_that_comes_later_in_the_list_blames_no_group(tmp_path: Path) -> None:
    use = SIM.format(", parameters=[{'background_r': LaunchConfiguration('red')}]")
    body = f"argument = DeclareLaunchArgument(\n    'red', default_value='100')\nsim = {use}\nreturn LaunchDescription([sim, argument])"
    report = reports(launch_file(tmp_path, body))[0]
    assert "move DeclareLaunchArgument('red', ...) to the beginning" in report and 'GroupAction' not in report


def test_a_parameter_file_that_the_launch_file_writes_is_not_missing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    body = (
        "path = os.path.join(os.path.dirname(__file__), 'made.yaml')\n"
        "with open(path, 'w') as file:\n"
        "    file.write('sim:\\n  ros__parameters:\\n    background_r: 10\\n')\n"
        f'return LaunchDescription([{SIM.format(", parameters=[path]")}])'
    )
    assert main(['doctor', str(launch_file(tmp_path, body)), '--for', '1']) == 0
    assert 'made.yaml' not in capsys.readouterr().out


def test_a_terminal_window_is_a_note(tmp_path: Path) -> None:
    prefix = ", prefix='gnome-terminal --'"
    teleop = f"Node(package='teleop_twist_keyboard', executable='teleop_twist_keyboard', name='teleop'{prefix})"
    report = reports(launch_file(tmp_path, f'return LaunchDescription([{teleop}])'))
    assert [one.splitlines()[0].partition(' (')[0] for one in report if 'teleop' in one or 'terminal' in one] == [
        'gnome-terminal-1 opens a terminal window on a real computer, but in edulaunch its program receives no keys'
    ]


def test_a_repeated_targets_of_install_names_both_programs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    package = tmp_path / 'src' / 'mine'
    (package / 'launch').mkdir(parents=True)
    node = "Node(package='mine', executable='second')"
    launch_file(package / 'launch', f'return LaunchDescription([{node}])')
    (package / 'package.xml').write_text('<package format="3"><name>mine</name><version>0.0.1</version></package>')
    (package / 'CMakeLists.txt').write_text(
        'project(mine)\nfind_package(ament_cmake REQUIRED)\nadd_executable(first a.cpp)\nadd_executable(second b.cpp)\n'
        'install(TARGETS first TARGETS second DESTINATION lib/${PROJECT_NAME})\nament_package()\n'
    )
    assert main(['doctor', str(package / 'launch' / 'main.launch.py'), '--for', '1']) == 1
    assert 'this program is built from C++' in capsys.readouterr().out


def test_of_sibling_packages_the_one_of_the_launch_file_is_judged(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for week in ('week2', 'week3'):
        shutil.copytree(UNSEEN / 'script_dot' / 'healthy' / 'robo', tmp_path / 'src' / week / 'robo')
    (tmp_path / 'src' / 'week2' / 'robo' / 'setup.cfg').unlink()
    node = "Node(package='robo', executable='walker')"
    file = launch_file(tmp_path / 'src' / 'week3' / 'robo' / 'launch', f'return LaunchDescription([{SIM.format("")}, {node}])')
    assert main(['doctor', str(file), '--for', '1']) == 0
    assert 'setup.cfg' not in capsys.readouterr().out


def test_a_committed_symlink_install_is_not_an_old_build(tmp_path: Path) -> None:
    shutil.copytree(UNSEEN / 'script_dot' / 'healthy' / 'robo', tmp_path / 'src' / 'robo')
    share = tmp_path / 'install' / 'robo' / 'share' / 'robo'
    site = tmp_path / 'install' / 'robo' / 'lib' / 'python3.12' / 'site-packages'
    for folder in (share / 'launch', site):
        folder.mkdir(parents=True)
    shutil.copy(tmp_path / 'src' / 'robo' / 'package.xml', share)
    os.symlink('/home/student/ws/src/robo/launch/robo.launch.py', share / 'launch' / 'robo.launch.py')
    (site / 'robo.egg-link').write_text('/home/student/ws/build/robo\n.')
    assert 'packages.changed-after-build' not in [one.rule for one in judge_sources(str(tmp_path / 'src'))]
