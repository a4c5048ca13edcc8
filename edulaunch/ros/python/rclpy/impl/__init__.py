"""The implementation of rclpy. Programs do not import these modules."""

from __future__ import annotations
