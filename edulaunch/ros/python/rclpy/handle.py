"""What is raised when something destroyed is used."""

from rclpy._rclpy_pybind11 import InvalidHandle

__all__ = ['InvalidHandle']
