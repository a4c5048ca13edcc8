"""Comparisons need the real rclpy, as the tests in tests/extras/native do."""

from tests.extras.native.conftest import edulaunch as edulaunch
from tests.extras.native.conftest import real as real
