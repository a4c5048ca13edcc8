"""A talker, tested while it runs and afterwards."""

import time
import unittest

import launch_testing
import launch_testing.actions
import pytest
import rclpy
from launch import LaunchDescription
from launch.actions import TimerAction
from launch_ros.actions import Node
from std_msgs.msg import String


@pytest.mark.launch_test
def generate_test_description():
    talker = Node(package='demo_nodes_py', executable='talker')
    ready = TimerAction(period=2.0, actions=[launch_testing.actions.ReadyToTest()])
    return LaunchDescription([talker, ready]), {'talker': talker}


class TestTalker(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rclpy.init()

    @classmethod
    def tearDownClass(cls):
        rclpy.shutdown()

    def test_publishes_once_a_second(self):
        node = rclpy.create_node('tester')
        heard = []
        node.create_subscription(String, 'chatter', lambda message: heard.append(message.data), 10)
        end = time.time() + 5
        while time.time() < end:
            rclpy.spin_once(node, timeout_sec=0.1)
        node.destroy_node()
        self.assertEqual(len(heard), 5)

    def test_waits_for_output(self, proc_output, talker):
        proc_output.assertWaitFor('Hello World: 20', process=talker, timeout=60)
        self.assertFalse(proc_output.waitFor('never said', timeout=1000))


@launch_testing.post_shutdown_test()
class TestShutdown(unittest.TestCase):
    def test_exit_code(self, proc_info, talker):
        launch_testing.asserts.assertExitCodes(proc_info, process=talker)
