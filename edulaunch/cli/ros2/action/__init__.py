"""`ros2 action`: one file per verb."""

from __future__ import annotations
