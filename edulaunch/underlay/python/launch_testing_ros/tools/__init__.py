"""Tools for tests of ROS nodes."""

from launch_testing.tools import ProcessProxy, expect_output, expected_output_from_file, launch_process

from .output import basic_output_filter, get_rmw_output_filter

__all__ = [
    'ProcessProxy',
    'basic_output_filter',
    'expect_output',
    'expected_output_from_file',
    'get_rmw_output_filter',
    'launch_process',
]
