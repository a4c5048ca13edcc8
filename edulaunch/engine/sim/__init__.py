"""The kernel: simulated time, the agenda, and tasks that take turns.

Nothing in this package knows about ROS. Read `simulation.py` first (time and the agenda), then `task.py` (programs that
block), then the rest, which is built from those two.
"""

from __future__ import annotations
