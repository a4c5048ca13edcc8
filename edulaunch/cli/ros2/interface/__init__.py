"""`ros2 interface`: one file per verb."""

from __future__ import annotations
