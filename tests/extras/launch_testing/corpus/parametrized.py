"""Two launches, with what a test sees of its parameters."""

import unittest

import launch_testing
import launch_testing.actions
import pytest
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch_ros.actions import Node


@pytest.mark.launch_test
@launch_testing.markers.keep_alive
@launch_testing.parametrize('topic, rate', [('one', 1), ('two', 2)])
def generate_test_description(topic, rate):
    listener = Node(package='demo_nodes_py', executable='listener', name=topic)
    return LaunchDescription(
        [DeclareLaunchArgument('who', default_value='nobody'), listener, launch_testing.actions.ReadyToTest()]
    ), locals()


class TestParameters(unittest.TestCase):
    def test_arguments(self, topic, rate, listener, test_args, launch_service, proc_info):
        proc_info.assertWaitForStartup(listener)
        self.assertEqual({'one': 1, 'two': 2}[topic], rate)
        self.assertEqual(test_args, {'who': 'me'})
        self.assertEqual(launch_service.context.launch_configurations['who'], 'me')
        self.assertIs(proc_info, self.proc_info)
        self.assertEqual(listener.node_name, f'<node_namespace_unspecified>/{topic}')
