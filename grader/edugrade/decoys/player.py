"""The program of a decoy, as a string. It creates nodes with the names of the solution's nodes, and plays their recorded
messages.

The program becomes part of a submission, so it does not import edugrade.
"""

PLAYER = """\
import json
import sys

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rosidl_runtime_py.set_message import set_message_fields
from rosidl_runtime_py.utilities import get_message

PLAN = {plan!r}


def main():
    words = dict(word.split(':=', 1) for word in sys.argv[1:] if ':=' in word and word.startswith('known_'))
    plan = json.loads(PLAN)
    text = json.dumps(plan['nodes'])
    for name, usual in plan['arguments'].items():
        text = text.replace(usual, words.get('known_' + name, usual)) if len(usual) > 2 and usual.isalpha() else text
    rclpy.init(args=[])
    executor = SingleThreadedExecutor()
    players = [Player(entry, executor) for entry in json.loads(text)]
    clock = players[0].node if players else rclpy.create_node('_decoy')
    if not players:
        executor.add_node(clock)
    start = clock.get_clock().now().nanoseconds
    lines = plan['lines']

    def say():
        while lines and (clock.get_clock().now().nanoseconds - start) / 1e9 >= lines[0][0]:
            print(lines.pop(0)[1], end='', flush=True)

    clock.create_timer(0.01, say)
    executor.spin()


class Player:
    def __init__(self, entry, executor):
        self.node = rclpy.create_node(entry['name'], namespace=entry['namespace'] or None, use_global_arguments=False)
        for name, value in entry['parameters'].items():
            if not self.node.has_parameter(name):
                self.node.declare_parameter(name, value)
        for topic, kind in entry['subscriptions']:
            self.node.create_subscription(get_message(kind), topic, lambda message: None, 10)
        make = self.node.create_publisher
        self.publishers = {{topic: make(get_message(kind), topic, 10) for topic, kind in entry['publishers']}}
        self.messages = entry['messages']
        self.start = self.node.get_clock().now().nanoseconds
        if self.messages:
            self.node.create_timer(0.01, self.play)
        executor.add_node(self.node)

    def play(self):
        now = (self.node.get_clock().now().nanoseconds - self.start) / 1e9
        while self.messages and self.messages[0][0] <= now:
            _, topic, fields = self.messages.pop(0)
            publisher = self.publishers[topic]
            message = publisher.msg_type()
            set_message_fields(message, fields)
            publisher.publish(message)


if __name__ == '__main__':
    main()
"""

LAUNCH = """\
import os
import tempfile

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration

ARGUMENTS = {arguments!r}
TEXT = {program!r}


def generate_launch_description():
    path = os.path.join(tempfile.gettempdir(), 'decoy.py')
    with open(path, 'w') as file:
        file.write(TEXT)
    known = [[f'known_{{name}}:=', LaunchConfiguration(name)] for name in ARGUMENTS]
    return LaunchDescription([
        *[DeclareLaunchArgument(name, default_value=value) for name, value in ARGUMENTS.items()],
        ExecuteProcess(cmd=['python3', path, *known]),
    ])
"""

SWAPPED = """


def _swap_nodes():
    from launch.actions import ExecuteProcess
    from launch_ros.actions import Node

    usual, command = Node.__init__, ExecuteProcess.__init__
    idle = "import rclpy; rclpy.init(); rclpy.spin(rclpy.create_node('idle'))"

    def other(self, *, executable, package=None, **options):
        options.pop('arguments', None)
        usual(self, executable='add_two_ints_server', package='demo_nodes_py', **options)

    def without_program(self, *, cmd, **options):
        is_program = isinstance(cmd, (list, tuple)) and cmd and cmd[0] in ('python', 'python3')
        command(self, cmd=['python3', '-c', idle] if is_program else cmd, **options)

    Node.__init__, ExecuteProcess.__init__ = other, without_program


_swap_nodes()
"""
