"""Help below ROS's errors, for what is in the sources and would not be installed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.advice import judge_sources
from edulaunch.advice.rendering import help_of_facts
from edulaunch.engine.packages import Index
from edulaunch.ros.sources import read_source
from edulaunch.ros.sources.missing import installed_file, missing_executable, missing_launch_file, missing_package


@pytest.fixture
def robo(workspace: Any, node: str) -> Any:
    workspace.python('robo', 'drive = robo.drive:main')
    workspace.write('robo/robo/drive.py', node)
    workspace.write('robo/robo/brake.py', node)
    workspace.write('robo/launch/go.launch.py', 'def generate_launch_description():\n    return None\n')
    workspace.write('robo/config/wheels.yaml', '{}')
    return workspace


@pytest.fixture
def index(robo: Any) -> Index:
    return Index([], [robo.folder], read_source=read_source)


def test_ros2_launch_tells_of_a_launch_file_that_is_not_installed(robo: Any) -> None:
    with pytest.raises(edulaunch.UnusableInput) as caught:
        edulaunch.run('robo', 'go.launch.py', workspaces=[robo.folder])
    assert str(caught.value.help).startswith(
        f'{robo.folder}/robo/launch/go.launch.py exists, but the build does not install it; add (os.path.join('
    )


def test_a_node_action_tells_of_a_missing_entry_point(robo: Any, launch_text: Any) -> None:
    robo.write('go.launch.py', launch_text(('robo', 'brake')))
    with pytest.raises(edulaunch.LaunchFileError) as caught:
        edulaunch.run(robo.folder / 'go.launch.py', workspaces=[robo.folder])
    assert str(caught.value.help).endswith("add 'brake = robo.brake:main' to console_scripts of setup.py")


@pytest.mark.parametrize(
    'mistake', ['x = undefined', 'return LaunchDescription([Node(package="robo", executable="brake")])', 'return [']
)
def test_the_console_names_the_students_own_launch_file(workspace: Any, node: str, mistake: str) -> None:
    workspace.python('robo', 'drive = robo.drive:main', data="('share/robo/launch', glob('launch/*')),")
    workspace.write('robo/robo/drive.py', node)
    file = workspace.write(
        'robo/launch/go.launch.py',
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n'
        f'def generate_launch_description():\n    {mistake}\n',
    )
    written: list[str] = []
    with edulaunch.Session(workspaces=[workspace.folder], console=lambda stream, text: written.append(text)) as session:
        session.launch('robo', 'go.launch.py')
        session.run(1)
    helps = [line for line in ''.join(written).splitlines() if line.startswith('  help: ')]
    assert len(helps) == 1 and helps[0].startswith(f'  help: {file}:4')


def test_a_tutorials_command_finds_ros2_on_the_path(workspace: Any) -> None:
    file = workspace.write(
        'go.launch.py',
        """
        from launch import LaunchDescription
        from launch.actions import ExecuteProcess
        from launch.substitutions import FindExecutable
        from launch_ros.actions import Node
        def generate_launch_description():
            return LaunchDescription([
                Node(package='turtlesim', executable='turtlesim_node', name='sim'),
                ExecuteProcess(cmd=[[FindExecutable(name='ros2'), ' service call ', '/spawn turtlesim/srv/Spawn ',
                                     '"{x: 2, y: 2, theta: 0.2}"']], shell=True)])
        """,
    )
    recording = edulaunch.run(file, duration_s=2)
    assert any('Spawning turtle [turtle2]' in line.text for line in recording.output) and not recording.notes


def test_a_file_that_is_only_in_the_source(index: Index, robo: Any) -> None:
    share = index.share('robo')
    assert help_of_facts(installed_file(index, f'{share}/config/wheels.yaml')) == (
        f'{robo.folder}/robo/config/wheels.yaml exists, but the build does not install it; '
        "add (os.path.join('share', package_name, 'config'), glob('config/*')) to data_files of setup.py"
    )
    assert installed_file(index, f'{share}/config/other.yaml') == {}


def test_what_nobody_has_gets_no_hint(index: Index) -> None:
    assert missing_launch_file(index, 'robo', 'other.launch.py') == {}
    assert missing_executable(index, 'robo', 'fly')['about'] == 'packages.no-executable'
    assert missing_launch_file(index, 'turtlesim', 'x.launch.py') == {}


def test_a_package_that_is_not_found(index: Index, robo: Any, tmp_path: Path) -> None:
    robo.write('empty_folder/notes.txt')
    robo.manifest('zzz', 'ament_python', folder='ignored_one')
    robo.write('ignored_one/COLCON_IGNORE')
    assert missing_package(index, 'robbo')['near'] == 'robo'
    assert missing_package(index, 'empty_folder') == {'about': 'packages.no-manifest', 'folder': f'{robo.folder}/empty_folder'}
    assert missing_package(index, 'ignored_one')['ignored_by'] == 'COLCON_IGNORE'
    robo.manifest('zzy', 'ament_python', folder='left_out/inner/zzy')
    robo.write('left_out/COLCON_IGNORE')
    facts = missing_package(index, 'zzy')
    assert (facts['folder'], facts['ignored_by']) == (f'{robo.folder}/left_out', 'COLCON_IGNORE')
    robo.manifest('zzx', 'ament_python', folder='robo/src/zzx')
    assert help_of_facts(missing_package(index, 'zzx')) == (
        f'colcon does not search the folder {robo.folder}/robo/src/zzx, because it is inside the package {robo.folder}/robo; '
        f'move the folder out of {robo.folder}/robo'
    )
    assert help_of_facts(missing_package(index, 'qqqqq')) == (
        f'no package.xml below {robo.folder} contains <name>qqqqq</name>; check the <name> in the package.xml '
        f'files below {robo.folder}'
    )
    assert 'change to its workspace with cd, or name the workspace with --workspace DIR' in help_of_facts(
        missing_package(Index(), 'qqqqq')
    )


def test_an_executable_that_goes_to_the_wrong_folder(robo: Any) -> None:
    robo.write('robo/setup.cfg', '')
    assert (
        missing_executable(Index([], [robo.folder], read_source=read_source), 'robo', 'drive')['about'] == 'packages.no-setup-cfg'
    )


def test_a_package_with_an_unreadable_package_xml_is_named_with_its_line(index: Index, robo: Any) -> None:
    robo.write('robo_two/package.xml', '<package>\n<name>robo_two</nam>\n</package>')
    reason = missing_package(index, 'robo_two')['reason']
    assert reason.startswith(f'{robo.folder}/robo_two/package.xml:2: this is not well-formed XML')


def test_a_package_that_lies_deeper_below_the_current_folder_is_named_before_one_that_sounds_alike(
    workspace: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    workspace.manifest('learning_tf2_py', 'ament_python', folder='a/b/learning_tf2_py')
    monkeypatch.chdir(workspace.folder)
    assert help_of_facts(missing_package(Index(), 'learning_tf2_py')) == (
        'the package learning_tf2_py is in a/b/learning_tf2_py, where edulaunch does not search from the current folder; '
        'change to that workspace with cd, or name it with --workspace a/b/learning_tf2_py'
    )


@pytest.mark.parametrize(
    ('file', 'data', 'help'),
    [
        ('launch/go.launch.py', '', "add (os.path.join('share', package_name, 'launch'), glob('launch/*launch.[pxy][yma]*'))"),
        ('launch/go.launch', '', "add (os.path.join('share', package_name, 'launch'), glob('launch/*.launch'))"),
        ('launch/go.py', '', "add (os.path.join('share', package_name, 'launch'), glob('launch/*.py'))"),
        ('starts/go.launch.py', '', "add (os.path.join('share', package_name, 'starts'), glob('starts/*launch.[pxy][yma]*'))"),
        (
            'go.launch.py',
            '',
            "move it into the folder launch, and add (os.path.join('share', package_name, 'launch'), "
            "glob('launch/*launch.[pxy][yma]*'))",
        ),
        (
            'go.launch.py',
            "('share/robo/launch', glob('launch/*')),",
            'move it into the folder launch, where the installed files are',
        ),
    ],
)
def test_what_is_advised_finds_the_launch_file(workspace: Any, file: str, data: str, help: str) -> None:
    workspace.python('robo', data=data)
    workspace.write('robo/launch/other.launch.py')
    workspace.write(f'robo/{file}', 'def generate_launch_description():\n    return None\n')
    said = help_of_facts(
        missing_launch_file(Index([], [workspace.folder], read_source=read_source), 'robo', file.rpartition('/')[2])
    )
    assert said.partition('does not install it; ')[2].removesuffix(' to data_files of setup.py') == help


def test_a_package_whose_build_stops_says_so_instead_of_what_is_missing(robo: Any) -> None:
    setup = (robo.folder / 'robo' / 'setup.py').read_text()
    robo.write('robo/setup.py', setup.replace("name='robo'", 'name=package_name'))
    index = Index([], [robo.folder], read_source=read_source)
    said = f"{robo.folder}/robo/setup.py:3: a build stops with NameError: name 'package_name' is not defined"
    assert missing_launch_file(index, 'robo', 'go.launch.py')['reason'] == said
    assert missing_executable(index, 'robo', 'drive')['reason'] == said
    assert [finding.facts['said'] for finding in judge_sources(str(robo.folder))] == [said.partition(': ')[2]]
