"""Systems of nodes and frames: planned, recorded, and compared."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice.explaining.systems import (
    NOT_KNOWN,
    System,
    SystemNode,
    changed_parameters,
    differences,
    pictured,
    run_differences,
    system_of_run,
)

TEXT = """
import os
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    os.system('touch started')
    return LaunchDescription([
        DeclareLaunchArgument('turtle', default_value='turtle1'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='left', remappings=[('turtle1/pose', '/here')]),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='tf', parameters=[{'turtlename': LaunchConfiguration('turtle')}]),
        Node(package='mine', executable='talker', remappings=[('news', 'old')]),
        Node(package='absent', executable='program', name='other'),
    ])
"""
TALKER = """#!/usr/bin/env python3
open('started', 'w')
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.create_publisher(String, 'news', 10)
"""


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    package = tmp_path / 'mine'
    (package / 'mine').mkdir(parents=True)
    (package / 'resource').mkdir()
    (package / 'resource' / 'mine').touch()
    (package / 'mine' / '__init__.py').touch()
    (package / 'mine' / 'talker.py').write_text(TALKER)
    (package / 'setup.cfg').write_text('[install]\ninstall_scripts=$base/lib/mine\n')
    (package / 'package.xml').write_text(
        '<package format="3"><name>mine</name><version>0.0.0</version><description>x</description>'
        '<maintainer email="a@b.c">a</maintainer><license>MIT</license><export><build_type>ament_python</build_type></export></package>'
    )
    (package / 'setup.py').write_text(
        "from setuptools import setup\nsetup(name='mine', version='0', packages=['mine'], "
        "data_files=[('share/ament_index/resource_index/packages', ['resource/mine']), ('share/mine', ['package.xml']), "
        "], entry_points={'console_scripts': ['talker = mine.talker:main']})\n"
    )
    path = tmp_path / 'my.launch.py'
    path.write_text(TEXT)
    return path


def planned(file: Path, **arguments: str) -> System:
    return edulaunch.explain(file, arguments=arguments, workspaces=[file.parent], assume_packages=True).system()


def test_endpoints_come_from_the_source_and_from_edulaunch(file: Path) -> None:
    nodes = {node.name: node for node in planned(file).nodes}
    assert [(name, node.source) for name, node in nodes.items()] == [
        ('/left/sim', 'built-in'),
        ('/tf', 'built-in'),
        ('/talker', 'source'),
        ('/other', ''),
    ]
    assert ('publisher', '/here', 'turtlesim/msg/Pose') in nodes['/left/sim'].ends
    assert ('subscription', '/turtle1/pose', 'turtlesim/msg/Pose') in nodes['/tf'].ends
    assert nodes['/talker'].ends == [('publisher', '/old', 'String')]
    assert nodes['/other'].unknown == [NOT_KNOWN]


def test_a_plan_starts_no_program_of_the_student(file: Path) -> None:
    planned(file)
    assert not (file.parent / 'started').exists()


def test_another_argument_changes_a_parameter_and_an_endpoint(file: Path) -> None:
    found = differences(planned(file), planned(file, turtle='turtle2'))
    assert [(one.sign, one.text) for one in found] == [
        ('-', '/tf subscribes to /turtle1/pose [turtlesim/msg/Pose]'),
        ('+', '/tf subscribes to /turtle2/pose [turtlesim/msg/Pose]'),
        ('~', "/tf parameter turtlename = 'turtle2', before 'turtle1'"),
    ]
    assert changed_parameters(found) == {'/tf': ['turtlename']}


def test_an_earlier_run_says_what_its_nodes_have() -> None:
    run = edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=3)
    system = edulaunch.explain('turtle_tf2_py', 'turtle_tf2_demo.launch.py').system(run)
    assert {node.source for node in system.nodes} == {'run'}
    assert ('publisher', '/turtle2/pose', 'turtlesim/msg/Pose') in next(node for node in system.nodes if 'sim' in node.name).ends
    assert [(frame.parent, frame.child) for frame in system.frames] == [('world', 'turtle1'), ('world', 'turtle2')]
    assert differences(system, system_of_run(run)) == []


def test_two_runs_differ_in_arguments_messages_and_advice() -> None:
    runs = [
        edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=4, arguments={'target_frame': frame})
        for frame in ('turtle1', 'carrot9')
    ]
    found = run_differences(*runs)
    assert '~ argument target_frame: carrot9, before turtle1' in found
    assert any(line.startswith('+ advice:') and 'carrot9' in line for line in found)
    assert run_differences(runs[0], runs[0]) == []


def test_the_words_of_a_system_and_its_picture() -> None:
    one = System('a', [SystemNode('/x', 'p q', 'source', [('publisher', '/t', '')], ['client (name: n)'], {'k': 1})], [])
    other = one._replace(title='b', nodes=[one.nodes[0]._replace(parameters={'k': 2})])
    assert list(one.lines()) == ['node /x (p q)', '  publishes /t', '  not known: client (name: n)']
    assert '/x: k = 2' in pictured(one, other).caption
