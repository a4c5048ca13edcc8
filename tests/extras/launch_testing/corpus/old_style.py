"""`ready_fn`, threads, and a process started by the test itself."""

import threading
import time
import unittest

import launch_testing
import launch_testing.asserts
import launch_testing.util
import pytest
from launch import LaunchDescription
from launch.actions import OpaqueFunction
from launch.events.matchers import matches_action
from launch.events.process import ShutdownProcess
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
        launch_service.include_launch_description(LaunchDescription([talker]))
        proc_info.assertWaitForStartup(talker)
        proc_output.assertWaitFor('World: 3', process=talker, timeout=20)
        launch_service.emit_event(ShutdownProcess(process_matcher=matches_action(talker)))
        proc_info.assertWaitForShutdown(talker, timeout=10)
        launch_testing.asserts.assertExitCodes(proc_info, process=talker)
