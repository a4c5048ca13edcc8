"""`ros2 param`: one file per verb."""

from __future__ import annotations
