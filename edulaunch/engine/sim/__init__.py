"""The kernel: simulated time, the agenda, and tasks that take turns.

This package does not depend on ROS. Read `simulation.py` first (time and the agenda), then `task.py` (programs that block), then
the other files, which use these two.
"""

from __future__ import annotations
