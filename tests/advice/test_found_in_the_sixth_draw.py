"""Wrong advice on files of repositories of a sixth draw, each as a small case of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.engine.nearest import nearest_spelling
from tests.advice.test_found_in_draws import CONFIG, MANIFEST, SETUP, WALKER, launch, program, write
from tests.advice.test_found_on_28_november import report

TWIST = 'from geometry_msgs.msg import Twist'


def test_a_node_is_not_told_to_publish_on_a_topic_on_which_it_publishes_already(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    body = (
        "        self.plain = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)\n"
        "        self.other = self.create_publisher(Twist, '/turtle1/holonomic_cmd_vel', 10)\n"
        '        self.create_timer(0.5, lambda: [one.publish(Twist()) for one in (self.plain, self.other)])\n'
    )
    sim = "Node(package='turtlesim', executable='turtlesim_node')"
    write(tmp_path, walker_py=program(body, TWIST), main_launch_py=launch(sim, WALKER))
    printed = report(capsys, tmp_path / 'main.launch.py')
    assert 'sends commands on /turtle1/holonomic_cmd_vel' in printed and 'publish on /turtle1/cmd_vel' not in printed
    only_other = body.replace("'/turtle1/cmd_vel'", "'/turtle1/speed'")
    write(tmp_path, walker_py=program(only_other, TWIST))
    assert 'publish on /turtle1/cmd_vel, which has a subscription' in report(capsys, tmp_path / 'main.launch.py')


@pytest.mark.parametrize(
    ('ends', 'cure'),
    [
        (
            "raise TimeoutError('timed out')",
            'check that the device or program with which line 13 communicates is on and reachable',
        ),
        ("open('/dev/ttyUSB99')", 'check that the device or program with which line 13 communicates is on and reachable'),
        ("raise ValueError('unknown mode')", 'check the values that lead to line 13, where the program raises this error itself'),
        ('print(1 / 0)', 'correct line 13, where the program ended'),
    ],
)
def test_the_cure_of_a_program_that_ends_depends_on_its_error(
    ends: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write(tmp_path, walker_py=program(f'        {ends}\n').replace('\n\n        ', '\n        '), main_launch_py=launch(WALKER))
    line = (tmp_path / 'walker.py').read_text().splitlines().index(f'        {ends}') + 1
    assert cure.replace('13', str(line)) in report(capsys, tmp_path / 'main.launch.py')


def test_a_file_that_a_robot_file_includes_and_that_does_not_exist_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    robot = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="/absent/wheels.xacro"/></robot>'
    (tmp_path / 'robot.xacro').write_text(robot)
    text = launch("Node(package='turtlesim', executable='turtlesim_node')")
    text = text.replace('    return', "    xacro.process_file(os.path.join(HERE, 'robot.xacro'))\n    return").replace(
        'os\n', 'os\nimport xacro\n', 1
    )
    (tmp_path / 'main.launch.py').write_text(text)
    printed = report(capsys, tmp_path / 'main.launch.py')
    assert 'create the file /absent/wheels.xacro, or correct its path' in printed and 'check this line' not in printed


@pytest.mark.parametrize(
    ('module', 'cure'),
    [
        ('def main():\n    pass\n', "write 'walker = robo.walker:main'"),
        ('class Walker:\n    pass\n', 'remove the entry point, or write a function in robo/walker.py'),
    ],
)
def test_an_entry_point_gets_the_function_main_only_if_its_module_has_one(
    module: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    setup = SETUP.format(packages="['robo']", entries="['walker = robo.walker']", more='')
    files = {'package_xml': MANIFEST.format(more='', kind='ament_python'), 'setup_cfg': CONFIG, 'resource__robo': ''}
    write(tmp_path / 'robo', **files, setup_py=setup, robo____init___py='', robo__walker_py=module)
    assert cure in report(capsys, tmp_path / 'robo')


def test_options_of_ros_in_one_string_are_separated_with_their_two_dashes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    sim = "Node(package='turtlesim', executable='turtlesim_node', arguments=['--ros-args -remap turtle1/pose:=pose'])"
    write(tmp_path, main_launch_py=launch(sim))
    assert "'--ros-args', '--remap', 'turtle1/pose:=pose'" in report(capsys, tmp_path / 'main.launch.py')


@pytest.mark.parametrize(('name', 'near'), [('xarm_description', None), ('arn_description', 'arm_description')])
def test_a_word_with_a_letter_before_it_is_another_word(name: str, near: str | None) -> None:
    assert nearest_spelling(name, ['arm_description']) == near


def test_the_note_on_dependencies_of_launch_files_names_launch_before_the_index(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {'package_xml': MANIFEST.format(more='', kind='ament_cmake'), 'CMakeLists_txt': 'project(robo)\nament_package()\n'}
    text = launch("LogInfo(msg='hello')").replace('ExecuteProcess', 'LogInfo')
    text = text.replace('from launch import', 'from ament_index_python import packages\nfrom launch import', 1)
    write(tmp_path / 'robo', **files, launch__a_launch_py=text)
    assert 'a launch file uses launch, but package.xml names no package' in report(capsys, tmp_path / 'robo')
