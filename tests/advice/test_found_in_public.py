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
        'edulaunch cannot open the terminal window of gnome-terminal-1, so the program in it receives no keyboard input'
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
    assert main(['doctor', str(package / 'launch' / 'main.launch.py'), '--for', '1']) == 0
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


def package(folder: Path, name: str, entry_points: str = "['go = {0}.go:main']", program: str = '') -> Path:
    """A Python package with the program `go` and a launch file that starts it."""
    for place in ('resource', name, 'launch'):
        (folder / name / place).mkdir(parents=True)
    shown = f'<package format="3"><name>{name}</name><version>0.0.0</version><exec_depend>ros2launch</exec_depend></package>'
    (folder / name / 'package.xml').write_text(shown)
    (folder / name / 'setup.cfg').write_text(f'[install]\ninstall_scripts=$base/lib/{name}\n')
    (folder / name / 'resource' / name).touch()
    (folder / name / name / '__init__.py').touch()
    (folder / name / name / 'go.py').write_text(program or 'import rclpy\ndef main():\n    rclpy.init()\n')
    (folder / name / 'setup.py').write_text(
        f"from glob import glob\nfrom setuptools import setup\nsetup(name='{name}', packages=['{name}'], data_files=[\n"
        f"    ('share/{name}', ['package.xml']), ('share/{name}/launch', glob('launch/*'))],\n"
        f"    entry_points={{'console_scripts': {entry_points.format(name)}}})\n"
    )
    return launch_file(folder / name / 'launch', f"return LaunchDescription([Node(package='{name}', executable='go')])")


def test_the_packages_beside_a_package_are_there_when_only_its_folder_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    package(tmp_path / 'src', 'helper')
    package(tmp_path / 'src', 'robo', program='import helper.go\ndef main():\n    helper.go.main()\n')
    main(['doctor', 'src/robo', '--for', '1'])
    out = capsys.readouterr().out
    assert 'ran for 1 simulated seconds each: launch/main.launch.py' in out and 'helper.go' not in out


def test_a_missing_comma_between_entry_points_is_the_cause(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    file = package(tmp_path / 'src', 'robo', "['stop = robo.go:main' 'go = robo.go:main']")
    assert main(['doctor', str(file), '--for', '1']) == 1
    out = capsys.readouterr().out
    assert 'src/robo/setup.py:5: lists the console_scripts stop, go without a comma' in out
    assert str(tmp_path) not in out and 'does not install it' not in out


def test_a_parameter_file_of_a_package_is_told_once_and_without_a_generated_path(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    file = package(tmp_path / 'src', 'robo')
    for name in ('speed.yaml', 'main.launch.xml'):
        (file.parent / name).write_text('{}')
    node = '<node pkg="robo" exec="go" name="{}"><param from="$(find-pkg-share robo)/launch/speeed.yaml"/></node>'
    (file.parent / 'main.launch.xml').write_text(f'<launch>\n{node.format("a")}\n{node.format("b")}\n</launch>\n')
    assert main(['doctor', str(file.parent / 'main.launch.xml'), '--for', '1']) == 1
    out = capsys.readouterr().out
    assert 'speeed.yaml does not exist, so /a starts' in out and 'write speed.yaml' in out and 'so a node starts' not in out
    edulaunch.run('robo', 'main.launch.xml', duration_s=1.0, workspaces=[tmp_path / 'src'])
    said = capsys.readouterr().err
    assert 'the parameter file share/robo/launch/speeed.yaml does not exist' in said and 'write speed.yaml' in said


def test_the_keys_of_other_nodes_are_not_to_be_replaced(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / 'p.yaml').write_text('sonar_node:\n  ros__parameters: {a: 1}\ndvl_node:\n  ros__parameters: {a: 1}\n')
    node = SIM.replace("'sim'", "'sensor_node'").format(f", parameters=['{tmp_path}/p.yaml']")
    main(['doctor', str(launch_file(tmp_path, f'return LaunchDescription([{node}])')), '--for', '1'])
    out = capsys.readouterr().out
    assert 'p.yaml sets no parameter of /sensor_node' in out and 'replace the key' not in out


def test_empty_brackets_of_a_type_are_no_missing_comma(tmp_path: Path) -> None:
    (tmp_path / 'd.py').write_text('def changed(values: list[]):\n    pass\n')
    body = f"return LaunchDescription([ExecuteProcess(cmd=['python3', '{tmp_path}/d.py'])])"
    assert 'comma is missing' not in '\n'.join(reports(launch_file(tmp_path, body)))


def test_a_name_that_only_setup_uses_is_no_mistake(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    package(tmp_path / 'src', 'robo', "['go = robo.go.py:main']")
    setup = tmp_path / 'src' / 'robo' / 'setup.py'
    setup.write_text(setup.read_text().replace("name='robo'", "name='other'"))
    main(['doctor', 'src/robo', '--for', '1'])
    out = capsys.readouterr().out
    assert 'calls it' not in out and 'write robo.go instead of robo.go.py' in out


def test_a_topic_that_has_none_in_its_name_has_a_variable_without_a_value(tmp_path: Path) -> None:
    program = tmp_path / 'drive.py'
    program.write_text(
        'import rclpy\nfrom geometry_msgs.msg import Twist\nfrom rclpy.node import Node\n'
        "rclpy.init()\nnode = Node('drive')\npublisher = node.create_publisher(Twist, f'/{None}/cmd_vel', 10)\n"
        'node.create_timer(0.1, lambda: publisher.publish(Twist()))\nrclpy.spin(node)\n'
    )
    drive = f"ExecuteProcess(cmd=['python3', '{program}'])"
    sims = ', '.join(SIM.format(f", namespace='{name}'") for name in ('t1', 't2'))
    report = reports(launch_file(tmp_path, f'return LaunchDescription([{sims}, {drive}])'))[0]
    assert (
        '/None/cmd_vel' in report
        and 'its value is None, which becomes the word None in a string' in report
        and 'turtle1' not in report
    )


def test_the_keyboard_program_in_a_window_of_its_own_is_not_the_students(tmp_path: Path) -> None:
    teleop = (
        "Node(package='turtlesim', executable='turtle_teleop_key', prefix='xterm -e', "
        "remappings=[('/turtle1/cmd_vel', '/t1/turtle1/cmd_vel')])"
    )
    sims = ', '.join(SIM.format(f", namespace='{name}'") for name in ('t1', 't2'))
    report = '\n'.join(reports(launch_file(tmp_path, f'return LaunchDescription([{sims}, {teleop}])')))
    assert 'rotate_absolute' not in report and 'cannot open the terminal window' in report


def test_a_robot_with_two_links_of_one_name_is_refused(tmp_path: Path) -> None:
    urdf = tmp_path / 'robot.urdf'
    urdf.write_text('<robot name="r"><link name="base"/><link name="base"/></robot>')
    publisher = f"Node(package='robot_state_publisher', executable='robot_state_publisher', arguments=['{urdf}'])"
    report = '\n'.join(reports(launch_file(tmp_path, f'return LaunchDescription([{publisher}])')))
    assert "link 'base' is not unique" in report


def test_a_remapping_that_only_one_of_two_nodes_has_is_not_reversed(tmp_path: Path) -> None:
    head = 'import rclpy\nfrom std_msgs.msg import Int64\nfrom rclpy.node import Node\nrclpy.init()\n'
    (tmp_path / 'counter.py').write_text(
        f"{head}node = Node('counter')\nsent = node.create_publisher(Int64, 'numbers', 10)\n"
        'node.create_timer(0.1, lambda: sent.publish(Int64()))\nrclpy.spin(node)\n'
    )
    (tmp_path / 'adder.py').write_text(
        f"{head}node = Node('adder')\nnode.create_subscription(Int64, 'numbers', print, 10)\nrclpy.spin(node)\n"
    )
    count, add = (f"'python3', '{tmp_path / name}'" for name in ('counter.py', 'adder.py'))
    processes = f"ExecuteProcess(cmd=[{count}, '--ros-args', '-r', 'numbers:=other']), ExecuteProcess(cmd=[{add}])"
    report = reports(launch_file(tmp_path, f'return LaunchDescription([{processes}])'))[0]
    assert 'add the same remapping to /adder' in report and 'swap' not in report


def test_a_path_of_one_machine_becomes_the_path_that_the_build_makes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    package(tmp_path / 'src', 'robo')
    (tmp_path / 'src' / 'robo' / 'urdf').mkdir()
    (tmp_path / 'src' / 'robo' / 'urdf' / 'car.urdf').touch()
    names = "place = '/home/ana/ws/src/robo/urdf/car.urdf'\nreturn LaunchDescription([])"
    file = launch_file(tmp_path / 'src' / 'robo' / 'launch', names)
    main(['doctor', str(file), '--for', '1'])
    assert (
        "let the build install urdf/car.urdf, and find it by its package with FindPackageShare('robo')" in capsys.readouterr().out
    )
    setup = tmp_path / 'src' / 'robo' / 'setup.py'
    setup.write_text(setup.read_text().replace("('share/robo', [", "('share/robo', ['urdf/car.urdf', "))
    main(['doctor', str(file), '--for', '1'])
    assert "PathJoinSubstitution([FindPackageShare('robo'), 'car.urdf'])" in capsys.readouterr().out


def test_a_script_that_the_build_installs_with_its_ending_is_started_with_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    robo = tmp_path / 'src' / 'robo'
    file = package(tmp_path / 'src', 'robo')
    for name in ('setup.py', 'setup.cfg'):
        (robo / name).unlink()
    manifest = (robo / 'package.xml').read_text()
    kind = '<buildtool_depend>ament_cmake</buildtool_depend><export><build_type>ament_cmake</build_type></export></package>'
    (robo / 'package.xml').write_text(manifest.replace('</package>', kind))
    lines = 'project(robo)\nfind_package(ament_cmake REQUIRED)\n{}ament_package()\n'
    (robo / 'CMakeLists.txt').write_text(lines.format('install(PROGRAMS robo/go.py DESTINATION lib/${PROJECT_NAME})\n'))
    assert main(['doctor', str(file), '--for', '1']) == 1
    out = capsys.readouterr().out
    assert "the package 'robo' has no executable named 'go'\n" in out and "write 'go.py'" in out
    (robo / 'CMakeLists.txt').write_text(lines.format(''))
    assert main(['doctor', str(file), '--for', '1']) == 1
    assert 'add install(PROGRAMS robo/go.py DESTINATION lib/${PROJECT_NAME} RENAME go)' in capsys.readouterr().out


@pytest.mark.parametrize('entry', ['robo.go', 'robo.go.main'])
def test_an_entry_point_without_a_colon_is_built_and_then_dies(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, entry: str
) -> None:
    monkeypatch.chdir(tmp_path)
    package(tmp_path / 'src', 'robo', f"['go = {entry}']")
    for words in (['src'], ['src/robo/launch/main.launch.py', '--for', '1']):
        assert main(['doctor', *words]) == 1
        out = capsys.readouterr().out
        assert f"the entry point 'go = {entry}'" in out and "write 'go = robo.go:main'" in out
        assert 'cannot be built' not in out and 'which does not exist' not in out
