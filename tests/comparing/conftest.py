"""Comparisons need the real rclpy, as the tests in tests/native do."""

from tests.native.conftest import edulaunch as edulaunch
from tests.native.conftest import real as real
