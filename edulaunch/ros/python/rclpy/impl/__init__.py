"""The implementation of rclpy, which programs do not import."""

from __future__ import annotations
