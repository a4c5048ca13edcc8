"""`ros2 lifecycle`: one file per verb."""

from __future__ import annotations
