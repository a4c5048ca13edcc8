"""Everything has ended before the tests are through."""

import time
import unittest

import launch_testing.actions
import pytest
from launch import LaunchDescription
from launch.actions import ExecuteProcess


@pytest.mark.launch_test
def generate_test_description():
    return LaunchDescription(
        [ExecuteProcess(cmd=['ros2', 'pkg', 'prefix', 'no_such_package']), launch_testing.actions.ReadyToTest()]
    )


class TestLong(unittest.TestCase):
    def test_long(self):
        time.sleep(100)
