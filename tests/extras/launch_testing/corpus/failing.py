"""One test passes, one claims what is not so, one breaks."""

import unittest

import launch_testing.actions
import launch_testing.util
import pytest
from launch import LaunchDescription


@pytest.mark.rostest
def generate_test_description():
    return LaunchDescription([launch_testing.util.KeepAliveProc(), launch_testing.actions.ReadyToTest()])


class TestClaims(unittest.TestCase):
    def test_a_right(self):
        self.assertTrue(True)

    def test_b_wrong(self, proc_output):
        proc_output.assertWaitFor('hello', timeout=3)

    def test_c_broken(self):
        raise KeyError('no such thing')

    @unittest.skip('not today')
    def test_d_skipped(self):
        raise AssertionError
