"""`ros2 service`: one file per verb."""

from __future__ import annotations
