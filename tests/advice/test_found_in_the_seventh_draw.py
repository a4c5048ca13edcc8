"""Wrong advice on files of repositories of a seventh draw, each as a small case of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.engine.nearest import nearest_file
from tests.advice.test_found_in_draws import CONFIG, MANIFEST, SETUP, WALKER, launch, package, program, rules, write
from tests.advice.test_found_on_28_november import report

SIM = "Node(package='turtlesim', executable='turtlesim_node', name='sim')"
FOLLOWER = """        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.sent = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.1, lambda: self.sent.publish(Twist(linear=Vector3(x=4.0))))
"""
FOLLOWS = 'from geometry_msgs.msg import Twist, Vector3\nfrom tf2_ros import Buffer, TransformListener'


@pytest.mark.parametrize(
    ('name', 'near'), [('cr3_robot_full.ros2.urdf', None), ('cr3_robott.urdf', 'cr3_robot.urdf'), ('cr3.urdf', None)]
)
def test_another_file_of_the_same_robot_is_not_the_one_that_is_meant(name: str, near: str | None) -> None:
    assert nearest_file(name, ['cr3_robot.urdf', 'robot.rviz']) == near


@pytest.mark.parametrize(('reads', 'code'), [('LaunchConfiguration(view)', 0), ('view', 1)])
def test_an_argument_is_used_if_a_launch_configuration_reads_it_by_a_variable(
    reads: str, code: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = launch('DeclareLaunchArgument(view, default_value="false")', SIM)
    text = text.replace('ExecuteProcess', 'DeclareLaunchArgument').replace(
        '    return', f"    view = 'use_image_view'\n    kept = {reads}\n    return"
    )
    (tmp_path / 'main.launch.py').write_text(
        text.replace('import os\n', 'import os\n\nfrom launch.substitutions import LaunchConfiguration\n')
    )
    printed = report(capsys, tmp_path / 'main.launch.py', code=code)
    assert ("'use_image_view' is declared but never used" in printed) == (code == 1)


@pytest.mark.parametrize(
    ('body', 'imports', 'cure'),
    [
        (FOLLOWER, FOLLOWS, 'check the frame that /walker follows, and the velocities that /walker calculates from it'),
        (FOLLOWER.split('\n', 2)[2], FOLLOWS, 'turn when x or y is below 1 or above 10'),
    ],
)
def test_a_follower_of_a_frame_does_not_turn_at_the_wall(
    body: str, imports: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path, walker_py=program(body, imports), main_launch_py=launch(SIM, WALKER))
    assert cure in report(capsys, tmp_path / 'main.launch.py')


def test_a_command_that_the_computer_does_not_have_is_to_be_installed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(
        tmp_path,
        walker_py=program("        subprocess.run(['iwgetid-absent', '-r'])\n", 'import subprocess'),
        main_launch_py=launch(WALKER),
    )
    assert 'install the program iwgetid-absent on this computer' in report(capsys, tmp_path / 'main.launch.py')


@pytest.mark.parametrize(
    ('listed', 'cure'),
    [
        ('resource/best.pt', 'create the file resource/best.pt, or remove it from data_files in setup.py'),
        ('resource/robo', 'create the empty file resource/robo, which marks an installed package'),
    ],
)
def test_only_the_file_of_the_packages_name_marks_it(
    listed: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    setup = SETUP.format(packages="['robo']", entries='[]', more='').replace("'resource/robo'", f"'{listed}'")
    files = {'package_xml': MANIFEST.format(more='', kind='ament_python'), 'setup_cfg': CONFIG, 'robo____init___py': ''}
    write(tmp_path / 'robo', **files, setup_py=setup)
    assert cure in report(capsys, tmp_path / 'robo')


@pytest.mark.parametrize(
    ('expression', 'cure'),
    [
        ("[LaunchConfiguration('sim'), ' and True']", "LaunchConfiguration('x'), \"' == 'true'\"]"),
        ("[LaunchConfiguration('sim'), \" == 'false'\"]", "LaunchConfiguration('x'), \"' == 'false'\"]"),
    ],
)
def test_the_cure_of_a_word_without_quotes_does_not_turn_a_condition_round(
    expression: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = launch(
        f"DeclareLaunchArgument('sim', default_value='false'), {SIM[:-1]}, condition=IfCondition(PythonExpression({expression})))"
    )
    more = 'import os\n\nfrom launch.conditions import IfCondition\nfrom launch.substitutions import LaunchConfiguration, PythonExpression\n'
    (tmp_path / 'main.launch.py').write_text(text.replace('ExecuteProcess', 'DeclareLaunchArgument').replace('import os\n', more))
    assert cure in report(capsys, tmp_path / 'main.launch.py')


@pytest.mark.parametrize(
    ('clause', 'told'), [('', False), ('PATTERN "a.launch.py" EXCLUDE', False), ('PATTERN "b.launch.py" EXCLUDE', True)]
)
def test_a_launch_file_that_cmake_excludes_by_name_is_not_to_be_installed(clause: str, told: bool, tmp_path: Path) -> None:
    folder = 'launch' if not told else 'other'
    build = f'project(robo)\ninstall(DIRECTORY {folder} DESTINATION share/robo {clause})\nament_package()\n'
    files = {'package_xml': MANIFEST.format(more='', kind='ament_cmake'), 'CMakeLists_txt': build, 'other__notes_txt': ''}
    write(tmp_path / 'robo', **files, launch__a_launch_py=launch(SIM))
    assert ('packages.launch-file-not-installed' in rules(tmp_path / 'robo')) == told


def test_a_module_that_an_entry_point_of_another_name_starts_is_installed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = package(tmp_path / 'src', "['walk = robo.walker_node:main']")
    write(
        folder,
        robo____init___py='',
        robo__walker_node_py=program(),
        launch__a_launch_py=launch("Node(package='robo', executable='walker_node')"),
    )
    printed = report(capsys, '--workspace', tmp_path, folder / 'launch' / 'a.launch.py')
    assert "has no executable named 'walker_node'" in printed and "write 'walk'" in printed
