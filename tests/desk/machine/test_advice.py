"""Advice belongs to one command of one terminal, whatever else the machine runs or has run."""

from __future__ import annotations

import shlex
import signal

from tests.desk.machine.shells import ROS2, Desk, Shell

PROGRAM = """import sys

import rclpy
from geometry_msgs.msg import TransformStamped, Twist
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class Program(Node):
    def __init__(self):
        super().__init__('program')
        self.count = 0
        {setup}
        self.create_timer(0.05, self.work)

    def work(self):
        self.count += 1
        print('works', self.count, flush=True)
        {work}


def main():
    rclpy.init()
    rclpy.spin(Program())


main()
"""
LAUNCH = """import os

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

HERE = os.path.dirname(__file__)


def generate_launch_description():
    return LaunchDescription([
        {items}
    ])
"""
OWN = "ExecuteProcess(cmd=['python3', os.path.join(HERE, 'program.py')], output='screen'),"
SIM = "Node(package='turtlesim', executable='turtlesim_node', name='sim'),"
DRIVES = "self.publisher = self.create_publisher(Twist, '/turtle1/{}', 10)"
SENDS = 'message = Twist(); message.linear.x = {}; message.angular.z = {}; self.publisher.publish(message)'
STATIC = "Node(package='tf2_ros', executable='static_transform_publisher', name='{}', arguments=['--x', '{}', '--frame-id', 'map', '--child-frame-id', 'arm']),"


def write(desk: Desk, name: str, *items: str, setup: str = 'pass', work: str = 'pass') -> None:
    """A launch file, and the program that it starts."""
    (desk.folder / name).write_text(LAUNCH.format(items='\n        '.join(items)))
    (desk.folder / 'program.py').write_text(PROGRAM.format(setup=setup, work=work))


def ctrl_c(shell: Shell) -> str:
    """Press Ctrl-C; returns what is reported behind the end."""
    shell.type('\x03')
    shell.end()
    head, sign, reported = shell.output.replace('\r', '').partition('warning: ')
    return sign + reported


def launched(desk: Desk, name: str, ready: str = 'works 25', **env: str) -> str:
    """Launch, wait for a line, press Ctrl-C; returns what is reported."""
    shell = desk.ros2(f'launch {name}', **env)
    shell.until(ready)
    return ctrl_c(shell)


def test_each_run_of_a_mistake_is_reported_and_no_run_without_it(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    reported = []
    for topic in ('cmd_val', 'cmd_vel', 'cmd_val', 'cmd_val'):
        write(desk, 'main.launch.py', SIM, OWN, setup=DRIVES.format(topic), work=SENDS.format(0.1, 0.5))
        reported.append(launched(desk, 'main.launch.py').partition(' (')[0])
    line = (
        'warning: /program publishes on /turtle1/cmd_val, but no node subscribes to it; /sim subscribes to /turtle1/cmd_vel, but no node '
        'publishes on it'
    )
    assert reported == [line, '', line, line]


def test_a_node_of_a_launch_that_has_ended_is_nobodys_partner(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    write(desk, 'sim.launch.py', SIM)
    assert launched(desk, 'sim.launch.py', 'Spawning turtle') == ''
    write(desk, 'own.launch.py', OWN, setup=DRIVES.format('cmd_val'), work=SENDS.format(0.1, 0.5))
    reported = launched(desk, 'own.launch.py')
    assert '/sim' not in reported
    assert reported.startswith('warning: /program sends commands on /turtle1/cmd_val, but no node subscribes to it')


def test_a_frame_of_an_earlier_launch_does_not_hide_that_nobody_broadcasts_it(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    setup = 'self.buffer = Buffer(); self.listener = TransformListener(self.buffer, self)'
    work = (
        "\n        try:\n            self.buffer.lookup_transform('map', 'arm', Time())\n"
        '        except TransformException:\n            return'
    )
    write(desk, 'both.launch.py', STATIC.format('static', 1), OWN, setup=setup, work=work)
    assert launched(desk, 'both.launch.py') == ''
    write(desk, 'own.launch.py', OWN, setup=setup, work=work)
    assert "/program looks up the frame 'arm', which no node broadcasts" in launched(desk, 'own.launch.py')


def test_two_static_publishers_one_after_the_other_are_not_two_broadcasters(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    for number in (1, 2):
        write(desk, 'main.launch.py', STATIC.format(f'static_{number}', number), OWN)
        assert launched(desk, 'main.launch.py', 'works 5') == ''
    first = desk.ros2('launch main.launch.py')
    first.until('works 5')
    write(desk, 'other.launch.py', STATIC.format('static_3', 3))
    second = desk.ros2('launch other.launch.py')
    second.until('Spinning until stopped')
    assert "two nodes broadcast the frame 'arm': /static_2 and /static_3" in ctrl_c(second)


def test_a_parameter_file_for_another_node_is_reported_in_each_run(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    (desk.folder / 'sim.yaml').write_text('turtlesim:\n  ros__parameters:\n    background_r: 200\n')
    item = "Node(package='turtlesim', executable='turtlesim_node', name='{}', parameters=[os.path.join(HERE, 'sim.yaml')]),"
    reported = []
    for name in ('turtlesim', 'sim', 'sim'):
        write(desk, 'main.launch.py', item.format(name), OWN)
        reported.append('`turtlesim`' in launched(desk, 'main.launch.py', 'works 5'))
    assert reported == [False, True, True]


def test_a_wall_is_reported_with_the_launch_file_that_drives_now(desk: Desk) -> None:
    write(desk, 'sim.launch.py', SIM)
    desk.ros2('launch sim.launch.py').until('Spawning turtle')
    write(desk, 'slow.launch.py', OWN, setup=DRIVES.format('cmd_vel'), work=SENDS.format(0.0, 1.0))
    assert launched(desk, 'slow.launch.py', 'works 5') == ''
    write(desk, 'fast.launch.py', OWN, setup=DRIVES.format('cmd_vel'), work=SENDS.format(20.0, 0.0))
    reported = launched(desk, 'fast.launch.py', 'works 30')
    assert reported.startswith('warning: /turtle1 drove into the wall') and 'slow.launch.py' not in reported
    assert 'program.py:14' in reported


def test_a_launch_that_runs_in_another_terminal_is_named(desk: Desk) -> None:
    write(desk, 'main.launch.py', OWN)
    desk.ros2('launch main.launch.py').until('works 5')
    reported = launched(desk, 'main.launch.py', 'works 5')
    assert reported.startswith('warning: two nodes have the name /program: one in python3-1 (pid ')
    assert (
        'press Ctrl-C in the terminal where `ros2 launch main.launch.py` is running' in reported
        and 'rename one of them' not in reported
    )


def test_of_many_findings_it_is_said_how_to_see_all(desk: Desk) -> None:
    desk.ros2('multicast receive').until('Waiting')  # the machine stays between the launch and the next command
    items = [f"Node(package='demo_nodes_py', executable='talker', name='talker_{number // 2}')," for number in range(14)]
    write(desk, 'main.launch.py', *items, OWN)
    reported = launched(desk, 'main.launch.py')
    assert reported.count('warning: ') == 5
    assert 'and 2 more; show all of them with ros2 doctor' in reported
    assert desk.said('doctor').count('two nodes have the name') == 7


def test_the_mistakes_of_one_terminal_are_not_reported_in_another(desk: Desk) -> None:
    write(desk, 'bad.launch.py', SIM, OWN, setup=DRIVES.format('cmd_val'), work=SENDS.format(0.1, 0.5))
    desk.ros2('launch bad.launch.py').until('works 25')
    dies = desk.folder / 'dies.py'
    dies.write_text("raise SystemExit('it broke')\n")
    (desk.folder / 'dies.launch.py').write_text(LAUNCH.format(items=OWN.replace('program.py', 'dies.py')))
    third = desk.ros2('launch dies.launch.py')
    third.end()
    assert 'died with exit code 1' in third.output
    other = desk.ros2('run demo_nodes_py listener')
    other.until(lambda output: True)
    assert 'warning' not in desk.said('topic list')
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing')
    assert ctrl_c(talker) == '' and ctrl_c(other) == ''


def test_a_closed_terminal_is_no_death(desk: Desk) -> None:
    write(desk, 'main.launch.py', OWN)
    launch = desk.ros2('launch main.launch.py')
    launch.until('works 5')
    echo = desk.ros2('topic echo /rosout')
    echo.until(lambda output: True)
    desk.said('node list')
    echo.send(signal.SIGHUP)
    echo.end()
    assert ctrl_c(launch) == ''


def test_the_last_words_of_an_earlier_program_are_not_those_of_a_new_one(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    for words in ('first words', 'second words'):
        write(desk, 'main.launch.py', OWN, setup=f'sys.exit({words!r})')
        shell = desk.ros2('launch main.launch.py')
        shell.end()
        reported = shell.output.replace('\r', '').partition('warning: ')[2]
    assert 'check the last output of the program: second words' in reported and 'first words' not in reported


def test_a_pipe_that_closes_early_is_no_death(desk: Desk) -> None:
    write(desk, 'main.launch.py', OWN)
    launch = desk.ros2('launch main.launch.py')
    launch.until('works 5')
    piped = Shell(
        '-c', f'{shlex.join(ROS2)} topic echo /rosout | head -n 1', cwd=desk.folder, env=desk.env, program=['/bin/bash']
    )
    desk.shells.append(piped)
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    piped.end()
    assert 'died' not in piped.output and 'exit code' not in piped.output
    assert ctrl_c(launch) == ''
