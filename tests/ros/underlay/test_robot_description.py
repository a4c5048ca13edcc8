"""robot_state_publisher, joint_state_publisher and xacro: from a description and joint positions to frames."""

from __future__ import annotations

from math import cos, pi, sin
from pathlib import Path
from typing import Any

import pytest
from robot_state_publisher._joints import read_joints
from sensor_msgs.msg import JointState
from std_msgs.msg import String

import edulaunch

ARM = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="arm">
  <xacro:arg name="reach" default="1.0"/>
  <xacro:property name="half" value="${pi / 2}"/>
  <link name="base"/><link name="upper"/><link name="slide"/><link name="wheel"/><link name="tip"/><link name="twin"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 1" rpy="0 0 ${half}"/><axis xyz="0 0 2"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="slider" type="prismatic"><parent link="upper"/><child link="slide"/>
    <origin xyz="$(arg reach) 0 0"/><axis xyz="1 0 0"/><limit lower="0.2" upper="0.6" effort="1" velocity="1"/></joint>
  <joint name="spin" type="continuous"><parent link="slide"/><child link="wheel"/><axis xyz="0 1 0"/></joint>
  <joint name="end" type="fixed"><parent link="wheel"/><child link="tip"/><origin xyz="0 0 0.5" rpy="${pi} 0 0"/></joint>
  <joint name="follow" type="revolute"><parent link="base"/><child link="twin"/><axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="1" velocity="1"/><mimic joint="shoulder" multiplier="-2" offset="0.1"/></joint>
  <gazebo reference="tip"><material>Gazebo/Red</material></gazebo>
</robot>
"""
URDF = ARM.replace('$(arg reach)', '1.0').replace('${half}', str(pi / 2)).replace('${pi}', str(pi))
URDF = '\n'.join(line for line in URDF.splitlines() if 'xacro:' not in line or line.startswith('<robot'))


@pytest.fixture
def urdf(tmp_path: Path) -> str:
    path = tmp_path / 'arm.urdf'
    path.write_text(URDF)
    return str(path)


def frames(stage: Any, topic: str) -> dict[str, Any]:
    return {one.child_frame_id: one for message in stage.messages(topic) for one in message.transforms}


def place(stamped: Any) -> tuple[float, ...]:
    move, turn = stamped.transform.translation, stamped.transform.rotation
    return (move.x, move.y, move.z, turn.x, turn.y, turn.z, turn.w)


def state(positions: dict[str, float], seconds: int = 1_700_000_000) -> JointState:
    message = JointState(name=list(positions), position=list(positions.values()))
    message.header.stamp.sec = seconds
    return message


def test_fixed_joints_are_told_once_and_the_description_is_published(stage: Any, urdf: str) -> None:
    stage.start('robot_state_publisher', 'robot_state_publisher', urdf)
    stage.until(100)
    assert stage.texts() == ['Robot initialized']
    assert stage.messages('/robot_description') == [String(data=URDF)]
    fixed = frames(stage, '/tf_static')
    assert list(fixed) == ['tip'] and fixed['tip'].header.frame_id == 'wheel'
    assert place(fixed['tip']) == pytest.approx((0, 0, 0.5, 1, 0, 0, 0), abs=1e-9)
    assert stage.messages('/tf') == []


def test_moving_joints_follow_joint_states_with_its_stamp(stage: Any, urdf: str) -> None:
    stage.start('robot_state_publisher', 'robot_state_publisher', urdf, '--ros-args', '-p', 'frame_prefix:=one/')
    stage.until(100)
    stage.publish('/joint_states', state({'shoulder': 0.4, 'slider': 0.25, 'spin': pi, 'unknown': 3.0}, 1_700_000_005))
    stage.until(200)
    found = frames(stage, '/tf')
    assert list(found) == ['one/upper', 'one/slide', 'one/wheel', 'one/twin']
    assert {one.header.stamp.sec for one in found.values()} == {1_700_000_005}
    turned = (pi / 2 + 0.4) / 2
    assert place(found['one/upper']) == pytest.approx((0, 0, 1, 0, 0, sin(turned), cos(turned)))
    assert place(found['one/slide']) == pytest.approx((1.25, 0, 0, 0, 0, 0, 1))
    assert place(found['one/wheel']) == pytest.approx((0, 0, 0, 0, 1, 0, 0), abs=1e-9)
    twin = (-2 * 0.4 + 0.1) / 2
    assert place(found['one/twin']) == pytest.approx((0, 0, 0, 0, 0, sin(twin), cos(twin)))
    assert found['one/upper'].header.frame_id == 'one/base'


def test_a_sliding_joint_slides_along_its_turned_axis() -> None:
    [joint] = read_joints(
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="prismatic"><parent link="a"/><child link="b"/>'
        f'<origin xyz="1 2 3" rpy="0 0 {pi / 2}"/><axis xyz="2 0 0"/><limit lower="0" upper="1" effort="1" velocity="1"/>'
        '</joint></robot>'
    )
    assert joint.transform(0.5)[0] == pytest.approx((1, 2.5, 3))


def test_states_come_through_at_most_so_often_unless_stamps_do_not_count(stage: Any, urdf: str) -> None:
    for number, ignore in enumerate(('false', 'true')):
        stage.start('robot_state_publisher', 'robot_state_publisher', urdf, '--ros-args', '-p', f'ignore_timestamp:={ignore}')
        stage.until(1000 * number + 100)
        before = len(stage.messages('/tf'))
        for _ in range(3):
            stage.publish('/joint_states', state({'spin': 1.0}, 1_700_000_000 + number))
            stage.until(1000 * number + 200)
        assert len(stage.messages('/tf')) - before == (1, 4)[number]  # the first one still runs: 1 + 3


@pytest.mark.parametrize(
    ('text', 'what'),
    [
        ('', 'robot_description parameter must not be empty'),
        ('<robot', 'Unable to initialize urdf::model from robot description'),
    ],
)
def test_without_a_description_it_aborts_as_the_original(stage: Any, tmp_path: Path, text: str, what: str) -> None:
    (tmp_path / 'x.urdf').write_text(text)
    process = stage.start('robot_state_publisher', 'robot_state_publisher', str(tmp_path / 'x.urdf'))
    stage.until(100)
    assert process.returncode == -6 and f'what():  {what}' in ''.join(text for _, text in stage.tape.outputs)


def test_joint_states_hold_every_joint_in_the_middle_unless_0_is_within(stage: Any, urdf: str) -> None:
    stage.start('joint_state_publisher', 'joint_state_publisher', '--ros-args', '-p', 'zeros.shoulder:=0.5')
    stage.until(500)
    assert stage.texts() == ['Waiting for robot_description to be published on the robot_description topic...']
    assert stage.messages('/joint_states') == []
    stage.start('robot_state_publisher', 'robot_state_publisher', urdf)
    stage.until(1550)
    states = stage.messages('/joint_states')
    assert len(states) == 10 and states[0].name == ['shoulder', 'slider', 'spin', 'follow']
    assert list(states[0].position) == pytest.approx([0.5, 0.4, 0.0, -0.9])
    assert set(frames(stage, '/tf')) == {'upper', 'slide', 'wheel', 'twin'}


def test_other_topics_and_delta_move_the_joints(stage: Any, urdf: str) -> None:
    stage.start(
        'joint_state_publisher', 'joint_state_publisher', urdf, '--ros-args', '-p', 'source_list:=[wheels]', '-p', 'delta:=0.1'
    )
    stage.until(50)
    stage.publish('/wheels', state({'spin': 2.0, 'follow': 9.0}))
    stage.until(1000)
    positions = [dict(zip(one.name, one.position, strict=True)) for one in stage.messages('/joint_states')]
    assert positions[0] == pytest.approx({'shoulder': 0.1, 'slider': 0.5, 'spin': 2.1, 'follow': -0.1})
    assert [round(one['slider'], 2) for one in positions[:5]] == [0.5, 0.6, 0.5, 0.4, 0.3]


def test_the_gui_says_that_it_has_no_window(stage: Any, urdf: str) -> None:
    stage.start('joint_state_publisher_gui', 'joint_state_publisher_gui')
    stage.start('robot_state_publisher', 'robot_state_publisher', urdf)
    stage.until(1000)
    assert any('no window with sliders' in text for text in stage.texts()) and stage.messages('/joint_states')


@pytest.mark.parametrize(
    'command', ["[FindExecutable(name='xacro'), ' ', FILE, ' reach:=2.0']", "['xacro ', FILE, ' reach:=2.0']"]
)
def test_a_launch_file_fills_in_its_xacro(tmp_path: Path, command: str) -> None:
    (tmp_path / 'arm.urdf.xacro').write_text(ARM)
    (tmp_path / 'arm.launch.py').write_text(
        f"""
from launch import LaunchDescription
from launch.substitutions import Command, FindExecutable
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
FILE = {str(tmp_path / 'arm.urdf.xacro')!r}
def generate_launch_description():
    description = ParameterValue(Command({command}), value_type=str)
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{{'robot_description': description}}]),
        Node(package='joint_state_publisher', executable='joint_state_publisher')])
"""
    )
    recording = edulaunch.run(tmp_path / 'arm.launch.py', duration_s=1.0)
    assert recording.digest() == edulaunch.run(tmp_path / 'arm.launch.py', duration_s=1.0).digest()
    frame = recording.frames_at(1.0)['slide']
    assert (frame.parent, frame.translation[0]) == ('upper', pytest.approx(2.4))


def test_relative_paths_count_from_the_folder_of_the_command(tmp_path: Path) -> None:
    (tmp_path / 'part').mkdir()
    (tmp_path / 'part' / 'arm.urdf.xacro').write_text(ARM)
    (tmp_path / 'arm.launch.py').write_text(
        f"""
from launch import LaunchDescription
from launch.actions import ExecuteProcess, RegisterEventHandler
from launch.event_handlers import OnProcessExit
def generate_launch_description():
    here = {str(tmp_path)!r}
    xacro = ExecuteProcess(cmd=['ros2', 'run', 'xacro', 'xacro', 'part/arm.urdf.xacro', '-o', 'part/arm.urdf'], cwd=here)
    robot = ExecuteProcess(cmd=['ros2', 'run', 'robot_state_publisher', 'robot_state_publisher', 'part/arm.urdf'], cwd=here)
    return LaunchDescription([xacro, RegisterEventHandler(OnProcessExit(target_action=xacro, on_exit=[robot]))])
"""
    )
    recording = edulaunch.run(tmp_path / 'arm.launch.py', duration_s=3.0)
    assert (tmp_path / 'part' / 'arm.urdf').read_text().startswith('<?xml')
    assert 'tip' in recording.frames_at(3.0)


def test_xacro_tells_of_a_mistake_in_its_file(tmp_path: Path, stage: Any) -> None:
    (tmp_path / 'a.xacro').write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><link name="${nope}"/></robot>'
    )
    process = stage.start('xacro', 'xacro', str(tmp_path / 'a.xacro'))
    stage.until(10)
    assert process.returncode == 2 and "error: name 'nope' is not defined" in stage.tape.outputs[0][1]


def test_xacro_finds_packages_and_writes_a_file(tmp_path: Path, stage: Any) -> None:
    (tmp_path / 'a.xacro').write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><link name="$(find turtlesim)"/></robot>'
    )
    process = stage.start('xacro', 'xacro', str(tmp_path / 'a.xacro'), '-o', str(tmp_path / 'out.urdf'))
    stage.until(10)
    assert process.returncode == 0 and 'share/turtlesim' in (tmp_path / 'out.urdf').read_text()


LINK = '<link name="base"/><link name="arm"/>'
JOINT = '<joint name="j" type="fixed"><parent link="{}"/><child link="arm"/></joint>'


@pytest.mark.parametrize(
    ('body', 'text'),
    [
        ('', 'No link elements found in urdf file'),
        (LINK + JOINT.format('bas'), r"parent link \[bas\] of joint \[j\] not found; did you mean 'base'\?"),
        (LINK, r'Two root links found: \[base\] and \[arm\]'),
        ('<link name="arm"/>' + JOINT.format('arm'), 'No root link found'),
        (
            LINK + JOINT.format('base').replace('fixed', 'revolute'),
            r'Joint \[j\] is of type REVOLUTE but it does not specify limits',
        ),
    ],
)
def test_links_that_do_not_hang_together_refuse_the_description(body: str, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        read_joints(f'<robot name="r">{body}</robot>')


def test_xacro_keeps_comments_and_ends_with_one_newline(tmp_path: Path) -> None:
    file = tmp_path / 'arm.urdf.xacro'
    file.write_text(f'<!-- of the student -->\n{ARM}<!-- the end -->\n')
    (tmp_path / 'arm.launch.py').write_text(
        f"""
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import Command
def generate_launch_description():
    return LaunchDescription([LogInfo(msg=['got:', Command(['xacro ', {str(file)!r}]), 'over'])])
"""
    )
    recording = edulaunch.run(tmp_path / 'arm.launch.py', duration_s=1.0)
    text = '\n'.join(line.text for line in recording.output)
    assert '?>\n<!-- of the student -->\n<robot' in text
    assert '</robot>\n<!-- the end -->\nover' in text


def test_without_the_parser_the_program_ends_with_the_line_that_installs_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('robot_state_publisher._joints.find_spec', lambda name: None)
    with pytest.raises(SystemExit, match=r"urdf-parser-py, which is not installed\n.*pip install '\.\[urdf\]'"):
        read_joints('<robot name="r"/>')


def test_a_file_that_is_not_there_ends_a_built_in_program_without_frames_of_edulaunch(tmp_path: Path) -> None:
    """Its path came from the student, so nothing in edulaunch is wrong."""
    (tmp_path / 'arm.launch.py').write_text("""
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='joint_state_publisher', executable='joint_state_publisher', arguments=['/no.urdf'])])
""")
    recording = edulaunch.run(tmp_path / 'arm.launch.py', duration_s=1.0)
    printed = [line.text for line in recording.output if line.process == 'joint_state_publisher-1']
    assert printed == ["FileNotFoundError: [Errno 2] No such file or directory: '/no.urdf'\n"]
