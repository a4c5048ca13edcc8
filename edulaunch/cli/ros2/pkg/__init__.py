"""`ros2 pkg`: one file per verb."""

from __future__ import annotations
