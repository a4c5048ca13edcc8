"""`ros2 node`: one file per verb."""

from __future__ import annotations
