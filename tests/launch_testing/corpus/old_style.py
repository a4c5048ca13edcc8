"""`ready_fn`, threads, and a process started by the test itself."""

import threading
import time
import unittest

import launch_testing
import launch_testing.tools
import launch_testing.util
import pytest
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch_ros.actions import Node


@pytest.mark.launch_test
def generate_test_description(ready_fn):
    return LaunchDescription([launch_testing.util.KeepAliveProc(), OpaqueFunction(function=lambda context: ready_fn())])


class TestMore(unittest.TestCase):
    def test_threads_wait_in_simulated_time(self):
        event = threading.Event()
        threading.Timer(30.0, event.set).start()
        before = time.monotonic()
        self.assertTrue(event.wait(timeout=60))
        self.assertEqual(time.monotonic() - before, 30.0)

    def test_process_of_the_test(self, launch_service, proc_info, proc_output):
        talker = Node(package='demo_nodes_py', executable='talker')
        with launch_testing.tools.launch_process(launch_service, talker, proc_info, proc_output) as process:
            self.assertTrue(process.wait_for_output(lambda text: 'World: 3' in text, timeout=20))
            self.assertTrue(process.running)
        self.assertTrue(process.wait_for_shutdown(timeout=10))
        self.assertEqual(process.exit_code, 0)
