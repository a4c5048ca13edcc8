"""`ros2 topic`: one file per verb."""

from __future__ import annotations
