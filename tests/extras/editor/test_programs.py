"""What programs have: a student's program is read, a built-in one runs for a moment."""

from __future__ import annotations

from pathlib import Path

from edulaunch.advice.texts import Around, Text
from edulaunch.desk.cli.main import main
from edulaunch.extras.editor.completing import choices
from edulaunch.extras.editor.pointing import definition, hover
from edulaunch.extras.editor.programs import file_of, frames, interface_of, launch_files_around

NODE = """import rclpy
from geometry_msgs.msg import Twist


def main():
    node = rclpy.create_node('walk')
    node.declare_parameter('speed', 1.5)
    node.create_publisher(Twist, 'cmd_vel', 10)
    transform.child_frame_id = 'carrot1'
    raise SystemExit('it was run')
"""


def test_a_package_of_a_student(tmp_path: Path) -> None:
    words = ['--build-type', 'ament_python', '--node-name', 'walk', '--license', 'MIT', '--destination-directory', str(tmp_path)]
    assert main(['pkg', 'create', *words, 'patrol']) == 0
    source = tmp_path / 'patrol/patrol/walk.py'
    source.write_text(NODE, encoding='utf-8')
    path = tmp_path / 'patrol/launch/a.launch.py'
    path.parent.mkdir()
    path.write_text('', encoding='utf-8')
    around = Around(str(path))
    assert file_of(around, 'patrol', 'walk') == (str(source), 5)
    assert interface_of(around, 'patrol', 'walk') == ({'speed': '1.5'}, {'cmd_vel': 'Twist'})
    assert (frames(around, ''), launch_files_around(around)) == (['carrot1'], [str(path)])
    text = Text("Node(package='patrol', executable='walk', parameters=[{''}])", str(path))
    found = choices(text, text.text.index("''") + 1, around)
    assert found is not None and [choice.label for choice in found[0]] == ['speed']
    target = definition(text, text.text.index('walk') + 1, around)
    assert target is not None and (target.path, target.line) == (str(source), 5)
    shown = hover(text, text.text.index('walk') + 1, around, {})
    assert shown is not None and 'walk.py:5' in shown[0] and 'parameter `speed`, default `1.5`' in shown[0]


def test_a_built_in_program(tmp_path: Path) -> None:
    known = interface_of(Around(str(tmp_path / 'a.launch.py')), 'turtlesim', 'turtlesim_node')
    assert known.parameters['background_b'] == '255' and known.topics['turtle1/pose'] == 'turtlesim/msg/Pose'
    assert not any(name.startswith('qos_overrides') for name in known.parameters)


def test_a_program_that_no_package_has_has_no_file(tmp_path: Path) -> None:
    words = ['--build-type', 'ament_python', '--node-name', 'walk', '--license', 'MIT', '--destination-directory', str(tmp_path)]
    assert main(['pkg', 'create', *words, 'patrol']) == 0
    around = Around(str(tmp_path / 'patrol/launch/a.launch.py'))
    assert file_of(around, 'patrol', 'run') is None and file_of(around, 'patroll', 'walk') is None
