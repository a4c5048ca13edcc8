"""`ros2 bag`: one file per verb."""

from __future__ import annotations
