"""Waiting for topics, as tests of ROS nodes do."""

import time
import unittest

import launch_testing.actions
import pytest
from launch import LaunchDescription
from launch_ros.actions import Node
from launch_testing_ros import WaitForTopics
from std_msgs.msg import String


@pytest.mark.rostest
def generate_test_description():
    return LaunchDescription([Node(package='demo_nodes_py', executable='talker'), launch_testing.actions.ReadyToTest()])


class TestTopics(unittest.TestCase):
    def test_messages_come(self):
        with WaitForTopics([('chatter', String)], timeout=10.0, messages_received_buffer_length=2) as topics:
            self.assertEqual(topics.topics_received(), {'chatter'})
            time.sleep(3.5)
            self.assertEqual(len(topics.received_messages('chatter')), 2)

    def test_messages_do_not_come(self):
        asked = []
        topics = WaitForTopics(
            [('chatter', String), ('silence', String)],
            timeout=3.0,
            trigger=lambda node, what: asked.append((node.get_name(), what)),
        )
        self.assertFalse(topics.wait('please'))
        self.assertEqual((topics.topics_not_received(), asked), ({'silence'}, [('wait_for_topics', 'please')]))
        topics.shutdown()
        with self.assertRaisesRegex(RuntimeError, 'Did not receive messages on these topics: .*silence'):
            WaitForTopics([('silence', String)], timeout=1.0).__enter__()
