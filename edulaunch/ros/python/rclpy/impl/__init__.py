"""What rclpy.logging is made of."""

from __future__ import annotations
