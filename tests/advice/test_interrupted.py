"""What Ctrl-C ends is explained as at the end of a run: a loop in main(), in a constructor or in a callback."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice import Finding, judge
from edulaunch.runtime.session import Session

LAUNCH = """from launch import LaunchDescription
from launch.actions import ExecuteProcess


def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {program!r}], output='screen')])
"""
RATE = """import rclpy

rclpy.init()
node = rclpy.create_node('driver')
rate = node.create_rate(2)
while rclpy.ok():
    rate.sleep()
"""
NODE = """import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.publisher = self.create_publisher(String, 'news', 10)
        self.create_subscription(String, 'news', self.heard, 10)
        {start}

    def heard(self, message):
        pass

    def drive(self):
        while True:
            self.publisher.publish(String(data='on'))
            time.sleep(0.5)


rclpy.init()
rclpy.spin(Driver())
"""


def found_after_interrupt(folder: Path, program: str) -> list[Finding]:
    """Launch a program, press Ctrl-C after 15 simulated seconds, and return the advice."""
    path, launch = folder / 'driver.py', folder / 'drive.launch.py'
    path.write_text(program, encoding='utf-8')
    launch.write_text(LAUNCH.format(program=str(path)), encoding='utf-8')
    with Session() as session:
        session.launch(launch)
        session.run(15.0)
        session.interrupt()
        session.run(5.0)
        return judge(session.recording())


@pytest.mark.parametrize(
    ('program', 'rule', 'line'),
    [
        (RATE, 'time.rate-not-spun', 7),
        (NODE.format(start='self.drive()'), 'programs.never-spun', 21),
        (NODE.format(start='self.create_timer(0.5, self.drive)'), 'programs.callback-goes-on', 21),
    ],
    ids=['rate in main', 'loop in the constructor', 'loop in a callback'],
)
def test_a_loop_that_ctrl_c_ended_is_explained_at_its_line(tmp_path: Path, program: str, rule: str, line: int) -> None:
    found = found_after_interrupt(tmp_path, program)
    assert [(one.rule, one.line) for one in found] == [(rule, line)]


def test_a_callback_that_returns_is_not_reported(tmp_path: Path) -> None:
    program = NODE.format(start='self.create_timer(0.5, self.drive)').replace('while True', 'for _ in range(1)')
    program = program.replace('time.sleep(0.5)', 'time.sleep(0.005)')
    assert found_after_interrupt(tmp_path, program) == []
