"""Wrong or misleading advice on files of repositories that were drawn on 24 November, each as a small case of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice import judge_sources
from edulaunch.desk.cli.main import main
from edulaunch.errors import LaunchFileError

SIM = "Node(package='turtlesim', executable='turtlesim_node', name='sim')"
NODE = """import rclpy
from rclpy.node import Node
{imports}

class Walker(Node):
    def __init__(self):
        {constructor}
{body}

def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()
"""


def write(folder: Path, **files: str) -> Path:
    """Write files below a folder; `__` in a name is a slash, and `_py`, `_xml`, `_txt` and `_cfg` are endings."""
    for name, text in files.items():
        path = folder.joinpath(*name.split('__'))
        for ending in ('py', 'xml', 'txt', 'cfg'):
            if path.name.endswith(f'_{ending}'):
                path = path.with_name(path.name.removesuffix(f'_{ending}').replace('_launch', '.launch') + f'.{ending}')
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return folder


def program(body: str = '', imports: str = '', constructor: str = "super().__init__('walker')") -> str:
    return NODE.format(body=body, imports=imports, constructor=constructor)


def launch(*actions: str) -> str:
    listed = ''.join(f'        {action},\n' for action in actions)
    return (
        'import os\n\nfrom launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        'from launch_ros.actions import Node\n\nHERE = os.path.dirname(os.path.abspath(__file__))\n\n\n'
        f'def generate_launch_description():\n    return LaunchDescription([\n{listed}    ])\n'
    )


WALKER = "ExecuteProcess(cmd=['python3', os.path.join(HERE, 'walker.py')])"
MANIFEST = '<package format="3"><name>robo</name><version>0.0.1</version>{more}<export><build_type>{kind}</build_type></export></package>'
SETUP = """from setuptools import setup

setup(
    name='robo',
    version='0.0.1',
    packages={packages},
    data_files=[('share/ament_index/resource_index/packages', ['resource/robo']), ('share/robo', ['package.xml'])],
    entry_points={{'console_scripts': {entries}}},
    {more}
)
"""
CONFIG = '[develop]\nscript_dir=$base/lib/robo\n[install]\ninstall_scripts=$base/lib/robo\n'


def package(folder: Path, entries: str, packages: str = "['robo']", more: str = '', kind: str = 'ament_python') -> Path:
    files = {'package_xml': MANIFEST.format(more='', kind=kind), 'setup_cfg': CONFIG, 'resource__robo': ''}
    return write(folder / 'robo', **files, setup_py=SETUP.format(packages=packages, entries=entries, more=more))


def told(folder: Path, workspaces: bool = False) -> list[str]:
    """What a run of main.launch.py reports."""
    try:
        places = [folder] if workspaces else []
        return edulaunch.run(folder / 'main.launch.py', duration_s=4.0, workspaces=places, console=lambda *_: None).warnings
    except LaunchFileError as error:
        return [str(error)]


def rules(folder: Path) -> list[str]:
    return [one.rule for one in judge_sources(str(folder))]


def test_a_speed_that_a_controller_calculates_is_not_in_degrees(tmp_path: Path) -> None:
    body = """        self.angle = 0.0
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_timer(0.1, self.turn)

    def turn(self):
        message = Twist()
        self.angle += 0.31
        message.angular.z = 90.0 {factor}
        self.publisher.publish(message)
"""
    imports = 'from geometry_msgs.msg import Twist\n'
    for factor, is_told in (('', True), ('* self.angle', False)):
        text = program(body.format(factor=factor), imports)
        found = told(write(tmp_path, main_launch_py=launch(SIM, WALKER), walker_py=text))
        assert any('a full turn in radians' in one for one in found) == is_told


def test_a_robot_description_with_the_prefix_slash_is_usual(tmp_path: Path) -> None:
    urdf = '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>'
    publisher = "Node(package='robot_state_publisher', executable='robot_state_publisher', parameters=[{{'robot_description': '{}', 'frame_prefix': '/'}}])"
    assert told(write(tmp_path, main_launch_py=launch(publisher.format(urdf)))) == []


def test_a_node_whose_frames_all_have_a_slash_is_told_once(tmp_path: Path) -> None:
    body = """        self.broadcaster = StaticTransformBroadcaster(self)
        for child in ('/left', '/right'):
            t = TransformStamped()
            t.header.stamp = self.get_clock().now().to_msg()
            t.header.frame_id = '/base'
            t.child_frame_id = child
            t.transform.rotation.w = 1.0
            self.broadcaster.sendTransform(t)
"""
    imports = 'from geometry_msgs.msg import TransformStamped\nfrom tf2_ros import StaticTransformBroadcaster\n'
    found = told(write(tmp_path, main_launch_py=launch(WALKER), walker_py=program(body, imports)))
    assert len([one for one in found if 'leading slash' in one]) == 1


def test_a_constructor_that_is_called_without_its_last_underscores(tmp_path: Path) -> None:
    text = program(constructor="super().__init('walker')")
    found = told(write(tmp_path, main_launch_py=launch(WALKER), walker_py=text))
    assert 'this line calls __init() of super()' in found[0] and 'write super().__init__(...)' in found[0]


def test_a_library_that_may_not_write_in_a_dry_run_is_no_mistake(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = launch(SIM).replace(
        '    return', "    import xacro\n\n    xacro.open_output(os.path.join(HERE, 'made.urdf'))\n    return"
    )
    main(['doctor', str(write(tmp_path, main_launch_py=text) / 'main.launch.py'), '--for', '1'])
    printed = capsys.readouterr().out
    assert 'the dry run stops at this line, which would write made.urdf' in printed and 'cannot run this file' not in printed


def test_a_package_with_both_build_files_is_built_as_its_manifest_says(tmp_path: Path) -> None:
    folder = package(tmp_path, "['other = robo.walker:main']")
    write(folder, robo____init___py='', robo__walker_py=program(), CMakeLists_txt='project(robo)\nament_package()\n')
    node = "Node(package='robo', executable='walker')"
    found = told(write(tmp_path, main_launch_py=launch(node)), workspaces=True)
    assert "write 'other'" in found[0] and 'CMakeLists.txt' not in found[0]


@pytest.mark.parametrize(
    ('entries', 'do'),
    [
        ("['walker = copied.walker:main']", 'write robo.walker instead of copied.walker'),
        ("['walker = robo.walker:main', 'other = robo.valker:main']", 'create the file robo/valker.py'),
    ],
)
def test_an_entry_point_that_names_no_module(tmp_path: Path, entries: str, do: str, capsys: pytest.CaptureFixture[str]) -> None:
    folder = write(package(tmp_path, entries), robo____init___py='', robo__walker_py=program())
    main(['doctor', str(folder)])
    printed = capsys.readouterr().out
    assert do in printed and 'has no entry point' not in printed


def test_a_module_that_a_launch_file_starts_with_m_needs_no_entry_point(tmp_path: Path) -> None:
    text = launch("ExecuteProcess(cmd=['python3', '-m', 'robo.walker'])")
    folder = write(package(tmp_path, '[]'), robo____init___py='', robo__walker_py=program())
    assert 'packages.node-without-entry-point' in rules(folder)
    write(folder, launch__main_launch_py=text)
    assert 'packages.node-without-entry-point' not in rules(folder)


def test_a_program_that_cmake_installs_below_share_is_installed(tmp_path: Path) -> None:
    lines = (
        'project(robo)\nfind_package(ament_cmake REQUIRED)\ninstall(PROGRAMS scripts/first.py DESTINATION lib/${PROJECT_NAME})\n'
    )
    for place, is_told in ((None, True), ('share/${PROJECT_NAME}/scripts', False)):
        more = '' if place is None else f'install(PROGRAMS scripts/walker.py DESTINATION {place})\n'
        folder = write(
            tmp_path / str(is_told) / 'robo',
            package_xml=MANIFEST.format(more='<buildtool_depend>ament_cmake</buildtool_depend>', kind='ament_cmake'),
            CMakeLists_txt=f'{lines}{more}ament_package()\n',
            scripts__first_py='#!/usr/bin/env python3\n' + program(),
            scripts__walker_py='#!/usr/bin/env python3\n' + program(),
        )
        assert ('packages.program-left-out' in rules(folder)) == is_told


def test_a_dotted_name_in_py_modules_does_not_hide_its_package(tmp_path: Path) -> None:
    folder = package(tmp_path, "['walker = robo.walker:main']", more="py_modules=['robo.walker'],")
    write(folder, robo____init___py='', robo__walker_py=program(imports='from robo.walker import rclpy as same\n'))
    node = "Node(package='robo', executable='walker')"
    assert told(write(tmp_path, main_launch_py=launch(node)), workspaces=True) == []


def test_a_topic_below_another_one_is_not_a_misspelling_of_it(tmp_path: Path) -> None:
    body = """        self.create_subscription(String, '/depth/target', print, 10)
        self.publisher = self.create_publisher(String, '/depth', 10)
        self.create_timer(1.0, lambda: self.publisher.publish(String()))
"""
    other = (
        program(body, 'from std_msgs.msg import String\n')
        .replace("'/depth/target'", "'/depth'")
        .replace("'/depth', 10)\n        self.create_timer", "'/x', 10)\n        self.create_timer")
    )
    other = other.replace("'walker'", "'second'")
    second = WALKER.replace('walker.py', 'second.py')
    text = program(body, 'from std_msgs.msg import String\n')
    found = told(write(tmp_path, main_launch_py=launch(WALKER, second), walker_py=text, second_py=other))
    assert any('/depth/target, but no node publishes on this topic' in one for one in found)
    assert not any('subscribe to /depth if' in one for one in found)


def test_a_node_that_waits_for_the_keyboard_is_not_too_slow(tmp_path: Path) -> None:
    body = """        self.create_subscription(Pose, '/turtle1/pose', self.see, 10)
        self.angle = input('angle? ')

    def see(self, message):
        pass
"""
    text = program(body, 'from turtlesim.msg import Pose\n')
    found = told(write(tmp_path, main_launch_py=launch(SIM, WALKER), walker_py=text))
    assert 'waits for keyboard input' in found[0] and not any('too slow' in one for one in found)


def test_an_action_in_a_text_of_three_quotes_was_left_out_on_purpose(tmp_path: Path) -> None:
    text = launch().partition('def ')[0] + (
        f'def generate_launch_description():\n    ld = LaunchDescription()\n    sim = {SIM}\n    other = {SIM}\n'
        '    ld.add_action(sim)\n{}    return ld\n'
    )
    left = '    """\n    ld.add_action(other)\n    """\n'
    assert told(write(tmp_path, main_launch_py=text.replace('{}', left))) == []
    assert 'write ld.add_action(other)' in told(write(tmp_path, main_launch_py=text.replace('{}', '')))[0]


def test_a_module_that_a_build_makes_from_parameters(tmp_path: Path) -> None:
    folder = package(tmp_path, "['walker = robo.walker:main']")
    text = (folder / 'setup.py').read_text()
    made = 'from generate_parameter_library_py.setup_helper import generate_parameter_module\n'
    (folder / 'setup.py').write_text(made + text + "\ngenerate_parameter_module('speeds', 'robo/speeds.yaml')\n")
    write(folder, robo____init___py='', robo__walker_py=program(imports='from robo.speeds import speeds\n'))
    node = "Node(package='robo', executable='walker')"
    found = told(write(tmp_path, main_launch_py=launch(node)), workspaces=True)
    assert 'a build makes the module robo.speeds' in found[0]


def test_a_file_of_parameters_in_an_element_of_its_own(tmp_path: Path) -> None:
    node = '<node pkg="turtlesim" exec="turtlesim_node"><param-file file="$(dirname)/sim.yaml"/></node>'
    (tmp_path / 'main.launch.xml').write_text(f'<launch>{node}</launch>')
    with pytest.raises(LaunchFileError, match='write <param from="..."/>'):
        edulaunch.run(tmp_path / 'main.launch.xml', duration_s=1.0, workspaces=[], console=lambda *_: None)


def test_no_place_of_a_simulated_build_is_shown(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    opens = "open(get_package_share_directory('robo') + '/arm.urdf')"
    text = 'from ament_index_python.packages import get_package_share_directory\n' + launch(SIM)
    opening = text.replace('    return', f'    {opens}\n    return')
    includes = '<launch><include file="$(find-pkg-share robo)/launch/wrong.launch.py"/></launch>'
    folder = write(
        package(tmp_path, '[]', more=''), launch__open_launch_py=opening, launch__wrong_launch_py=launch("Node(package='x')")
    )
    setup = (
        (folder / 'setup.py').read_text().replace("['package.xml'])", "['package.xml']), ('share/robo/launch', glob('launch/*'))")
    )
    (folder / 'setup.py').write_text('from glob import glob\n' + setup)
    (folder / 'launch' / 'main.launch.xml').write_text(includes)
    main(['doctor', str(folder)])
    printed = capsys.readouterr().out
    assert 'the file share/robo/arm.urdf does not exist' in printed
    assert 'edulaunch-' not in printed and printed.count('Node needs the argument executable=') == 1


def test_a_remapping_is_not_reversed_where_the_call_with_its_first_name_has_several_lines(tmp_path: Path) -> None:
    imports = 'from std_msgs.msg import String\n'
    body = """        self.publisher = self.create_publisher(
            String, 'numbers', 10
        )
        self.create_timer(0.5, lambda: self.publisher.publish(String()))
"""
    hears = "        self.create_subscription(String, 'numbers', print, 10)\n"
    remapped = WALKER.replace("'walker.py')", "'walker.py'), '--ros-args', '-r', '/numbers:=/others'")
    files = {'walker_py': program(body, imports), 'hearer_py': program(hears, imports, "super().__init__('hearer')")}
    found = told(write(tmp_path, main_launch_py=launch(remapped, WALKER.replace('walker', 'hearer')), **files))
    assert 'add the same remapping to /hearer' in found[0]


MIMIC = (
    "Node(package='turtlesim', executable='mimic', remappings=[('/input/pose', '/one/turtle1/pose'), ('/output/cmd_vel', '{}')])"
)


def test_a_launch_file_whose_other_half_is_elsewhere_is_not_told_to_join_its_topics(tmp_path: Path) -> None:
    two = SIM.replace("'sim'", "'sim', namespace='two'")

    found = told(write(tmp_path, main_launch_py=launch(two, MIMIC.format('/two/turtle1/cmd_vel'))))
    assert not any('use the same name in both' in one for one in found)
    typo = told(write(tmp_path, main_launch_py=launch(two, MIMIC.format('/two/turtle1/cmd_vel').replace('/one', '/twoo'))))
    assert any('/twoo/turtle1/pose' in one for one in typo)


def test_an_absolute_path_is_not_told_to_become_absolute(tmp_path: Path) -> None:
    text = launch(SIM).replace('    return', "    open('/home/ada/models/robot.sdf')\n    return")
    with pytest.raises(LaunchFileError) as caught:
        edulaunch.run(write(tmp_path, main_launch_py=text) / 'main.launch.py', duration_s=1.0, workspaces=[])
    assert '/home/ada/models/robot.sdf is not on this computer' in str(caught.value)


def test_a_path_up_from_the_share_folder_is_not_told_to_be_absent_in_the_workspace(tmp_path: Path) -> None:
    folder = package(tmp_path, '[]', more='')
    opens = "open(os.path.abspath(os.path.join(get_package_share_directory('robo'), '../../../../src/robo')) + '/arm.urdf', 'w')"
    text = 'from ament_index_python.packages import get_package_share_directory\n' + launch(SIM)
    write(tmp_path, main_launch_py=text.replace('    return', f'    {opens}\n    return'))
    found = told(tmp_path, workspaces=True)
    assert folder.exists() and 'the path goes up from the share folder of a package' in found[0]


def test_a_module_whose_file_has_no_ending_is_not_told_to_become_another_module(tmp_path: Path) -> None:
    folder = package(tmp_path, "['walker = robo.walker:main']")
    write(folder, robo____init___py='', robo__other_py=program())
    (folder / 'robo' / 'walker').write_text(program())
    found = told(write(tmp_path, main_launch_py=launch("Node(package='robo', executable='walker')")), workspaces=True)
    assert 'rename the file robo/walker to robo/walker.py' in found[0]


def test_a_fact_with_a_place_of_the_simulated_build_is_shown_with_the_source(tmp_path: Path) -> None:
    from edulaunch.advice.reader import Reader
    from edulaunch.engine.underlay_place import underlay_prefix

    source = write(tmp_path, src__robo__config__p_txt='') / 'src/robo/config/p.txt'
    built = tmp_path / 'edulaunch-0/ws-1/share/robo/config/p.txt'
    built.parent.mkdir(parents=True)
    built.symlink_to(source)
    reader = Reader(folder=str(tmp_path))
    assert reader.short(f"xacro '{built}'") == "xacro 'src/robo/config/p.txt'"
    assert reader.short(f'{built}2: no such file') == 'share/robo/config/p.txt2: no such file'
    assert reader.short(f'{underlay_prefix()}/bin/xacro a') == 'xacro a'
