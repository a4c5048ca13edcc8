"""A test that waits for ever."""

import threading
import unittest

import launch_testing.actions
import launch_testing.util
import pytest
from launch import LaunchDescription


@pytest.mark.launch_test
def generate_test_description():
    return LaunchDescription([launch_testing.util.KeepAliveProc(), launch_testing.actions.ReadyToTest()])


class TestWaiting(unittest.TestCase):
    def test_waiting(self):
        threading.Event().wait()
