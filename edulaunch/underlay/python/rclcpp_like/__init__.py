"""What sets a C++ node apart from a Python one: our ports of C++ programs behave as the originals do."""

from rclcpp_like.node import CppNode
from rclcpp_like.program import run_program

__all__ = ['CppNode', 'run_program']
