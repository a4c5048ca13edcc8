"""The runs of a student's own nodes are made twice; what differs is said, with the first difference."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade import grading
from edugrade.evidence import Outcome, Scenario
from edugrade.grading import grade, plan_work
from edugrade.results import Report
from edugrade.submission import Submission

ROOT = Path(__file__).resolve().parents[2]
RUBRIC = """
from edugrade import Evidence, Rubric, Scenario, check

@check(points=1)
def a(run: Evidence) -> None:
    'Anything'

RUBRIC = Rubric(title='Own', scenarios=lambda random: [Scenario('one', {}, 3.0)], checks=[a])
"""
NODE = """
import random
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node('talker')
publisher = node.create_publisher(String, 'chatter', 10)
node.create_timer(0.5, lambda: publisher.publish(String(data={data})))
rclpy.spin(node)
"""


def report(tmp_path: Path, data: str) -> Report:
    package = tmp_path / 'own'
    (package / 'launch').mkdir(parents=True)
    (package / 'own').mkdir()
    (package / 'package.xml').write_text(
        '<package format="3"><name>own</name><version>0.0.0</version><description>d</description>'
        '<maintainer email="a@example.org">a</maintainer><license>none</license><export><build_type>ament_python</build_type></export></package>'
    )
    (package / 'setup.py').write_text(
        "from setuptools import setup\nsetup(name='own', packages=['own'], entry_points={'console_scripts': ['talk = own.talk:main']},\n"
        "data_files=[('share/own', ['package.xml']), ('share/own/launch', ['launch/own.launch.py'])])\n"
    )
    (package / 'resource').mkdir()
    (package / 'resource' / 'own').write_text('')
    (package / 'setup.cfg').write_text('[develop]\nscript_dir=$base/lib/own\n[install]\ninstall_scripts=$base/lib/own\n')
    (package / 'own' / '__init__.py').write_text('')
    (package / 'own' / 'talk.py').write_text(
        'def main():\n' + ''.join(f'    {line}\n' for line in NODE.format(data=data).splitlines())
    )
    (package / 'launch' / 'own.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n'
        "def generate_launch_description():\n    return LaunchDescription([Node(package='own', executable='talk')])\n"
    )
    (tmp_path / 'own.py').write_text(RUBRIC)
    (found,) = grade([plan_work(Submission(str(package)), str(tmp_path / 'own.py'))])
    return found


@pytest.mark.processes
@pytest.mark.parametrize('data', ["'always'", 'str(random.random())', 'str(node.get_clock().now().nanoseconds)'])
def test_what_repeats_is_said_to_repeat(tmp_path: Path, data: str) -> None:
    found = report(tmp_path, data)
    assert [(result.name, result.status, result.reason) for result in found.results] == [
        ('launches', 'passed', ''),
        ('repeats', 'passed', ''),
        ('a', 'passed', ''),
    ]


@pytest.mark.processes
def test_the_first_difference_is_told(tmp_path: Path) -> None:
    found = report(tmp_path, '__import__("posix").urandom(4).hex()')
    result = found.results[1]
    assert (found.exit_code, found.earned, result.status) == (1, 1, 'failed')
    assert result.reason == 'two runs with no arguments differ'
    assert (result.seen or '').startswith('at 0.5') and 'a message on /chatter' in (result.seen or '')


@pytest.mark.parametrize(
    ('kind', 'text', 'statuses'),
    [
        ('stopped', 'the run did not finish within 30 s of real time', []),
        ('broke', 'this computer has no memory left', []),
        ('unusable', 'name is not defined', ['failed']),
    ],
)
def test_a_busy_computer_is_no_difference(monkeypatch: pytest.MonkeyPatch, kind: str, text: str, statuses: list[str]) -> None:
    monkeypatch.setattr('edugrade.repeated.has_own_programs', lambda recording: True)
    first = Outcome(Scenario('one'), 'recorded', recording=object())  # type: ignore[arg-type]
    work = grading.plan_work(Submission(str(ROOT / 'solutions' / 'circle.launch.py')))
    found = grading._repeated(work, [first], lambda scenarios: [Outcome(scenario, kind, text=text) for scenario in scenarios])
    assert [result.status for result in found] == statuses
