"""Wrong advice on files of repositories of a fourth draw, each as a small case of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.advice.test_found_in_draws import CONFIG, MANIFEST, launch, program, write
from tests.advice.test_found_on_28_november import launch_file, report

ROBOT = '<robot name="r" {xmlns}>\n{comment}\n<link name="base"/>\n</robot>\n'
COMMENT = '<!-- <xacro:wheel name="left" prefix="$(arg prefix)"/> -->'


def described(folder: Path, robot: str, value: str) -> Path:
    """Write a launch file whose robot_state_publisher gets `value`; `path` is the file with the robot."""
    (folder / 'robot.urdf').write_text(robot)
    parameters = f"parameters=[{{'robot_description': {value}}}]"
    text = launch_file(f"Node(package='robot_state_publisher', executable='robot_state_publisher', {parameters})")
    above = f'path = {str(folder / "robot.urdf")!r}\n\n\ndef generate'
    more = 'from pathlib import Path\n\nfrom launch.substitutions import Command\nfrom launch_ros.parameter_descriptions import ParameterValue\n'
    (folder / 'a.launch.py').write_text(more + text.replace('def generate', above))
    return folder / 'a.launch.py'


@pytest.mark.parametrize('value', ["ParameterValue(Command(['cat ', path]), value_type=str)", 'Path(path).read_text()'])
def test_a_comment_of_a_robot_description_may_contain_tags_and_arguments_of_xacro(
    value: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert report(capsys, described(tmp_path, ROBOT.format(xmlns='', comment=COMMENT), value), code=0) == 'no problems found\n'


def test_a_tag_of_xacro_outside_of_comments_is_still_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = ROBOT.format(xmlns='xmlns:xacro="x"', comment=COMMENT).replace('</robot>', '<xacro:arm/></robot>')
    assert '1. robot_description contains xacro tags such as <xacro:arm>' in report(
        capsys, described(tmp_path, robot, 'Path(path).read_text()')
    )


@pytest.mark.parametrize(
    ('text', 'is_field'),
    [
        ('ros2 topic pub --once /reset std_msgs/Bool {data: true}', False),
        ('{data: 2.0, other: 0.5}', False),
        ('the data is {data}', True),
        ('{data:.2f} m', True),
        ('{data:>8}', True),
        ('{data!r}', True),
    ],
)
def test_a_message_in_yaml_is_not_a_field_of_an_f_string(
    text: str, is_field: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    walker = program(constructor=f"super().__init__('walker'); self.data = 1; self.get_logger().info({text!r})")
    start = "ExecuteProcess(cmd=['python3', HERE + '/walker.py'])"
    write(tmp_path, walker_py=walker, main_launch_py=launch(start))
    printed = report(capsys, tmp_path / 'main.launch.py', code=int(is_field))
    assert ('because the string has no f before it' in printed) == is_field


@pytest.mark.parametrize('mode', [0o755, 0o644])
def test_a_program_among_the_data_files_in_lib_is_installed_if_it_may_run(
    mode: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files = {
        'package_xml': MANIFEST.format(more='<exec_depend>ros2launch</exec_depend>', kind='ament_python'),
        'setup_cfg': CONFIG,
    }
    listed = "('lib/robo', ['scripts/walker.py']), ('share/robo/launch', ['launch/a.launch.py'])"
    write(
        tmp_path / 'src' / 'robo',
        setup_py=f"from setuptools import setup\nsetup(name='robo', version='0.0.1', data_files=[{listed}])\n",
        resource__robo='',
        scripts__walker_py='#!/usr/bin/env python3\n' + program(),
        launch__a_launch_py=launch_file('Node(package="robo", executable="walker.py")'),
        **files,
    )
    (tmp_path / 'src' / 'robo' / 'scripts' / 'walker.py').chmod(mode)
    printed = report(capsys, tmp_path / 'src' / 'robo' / 'launch' / 'a.launch.py', code=int(mode == 0o644))
    assert ('no problems found' in printed) == (mode == 0o755)


@pytest.mark.parametrize(
    ('module', 'cure'),
    [
        ('robo.wawalker', "write 'walker = robo.walker:main'"),
        ('robo.walker.main', "write 'walker = robo.walker:main'"),
        ('robo.walker', "write 'walker = robo.walker:main'"),
    ],
)
def test_an_entry_point_without_a_function_names_a_module_that_is_there(
    module: str, cure: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    setup = (
        "from setuptools import setup\nsetup(name='robo', version='0.0.1', packages=['robo'], "
        f"entry_points={{'console_scripts': ['walker = {module}']}})\n"
    )
    files = {'package_xml': MANIFEST.format(more='<depend>rclpy</depend>', kind='ament_python'), 'setup_cfg': CONFIG}
    write(tmp_path / 'robo', setup_py=setup, resource__robo='', robo__walker_py=program(), **files)
    (tmp_path / 'robo' / 'robo' / '__init__.py').touch()
    printed = report(capsys, tmp_path / 'robo')
    assert f"1. the entry point 'walker = {module}' has no function after a colon" in printed and cure in printed


def test_a_robot_in_sdf_is_not_called_a_faulty_urdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = '<?xml version="1.0"?>\n<!-- made by hand -->\n<sdf version="1.9"><model name="r"><link name="base"/></model></sdf>\n'
    printed = report(capsys, described(tmp_path, robot, 'Path(path).read_text()'), code=0)
    assert printed.startswith('1. note: robot_description of robot_state_publisher-1 is written in SDF') and '2.' not in printed


def test_a_missing_marker_of_a_package_is_to_be_created(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    listed = "('share/ament_index/resource_index/packages', ['resource/robo']), ('share/robo', ['package.xml'])"
    files = {'package_xml': MANIFEST.format(more='', kind='ament_python'), 'setup_cfg': CONFIG}
    write(tmp_path / 'robo', setup_py=f"from setuptools import setup\nsetup(name='robo', data_files=[{listed}])\n", **files)
    assert 'do:    create the empty file resource/robo, which marks' in report(capsys, tmp_path / 'robo')


def test_a_misspelt_key_of_a_parameter_file_is_told_with_its_file_and_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / 'sim.yaml').write_text('/sim:\n  ros_parameters:\n    background_r: 200\n')
    sim = f"Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{str(tmp_path / 'sim.yaml')!r}])"
    (tmp_path / 'a.launch.py').write_text(launch_file(sim))
    printed = report(capsys, tmp_path / 'a.launch.py')
    assert "1. in sim.yaml, 'ros_parameters' (above line 3) is not a key of parameter files" in printed
