"""What comparing adds: the verb `edulaunch compare`."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

ABOUT = 'Run a launch file in simulation and on the real rclpy, and say what differs'
PLUGIN = Plugin(
    needs=('edulaunch.extras.native', 'edulaunch.extras.network'),
    verbs={'compare': Verb(ABOUT, 'edulaunch.extras.comparing.verb')},
)
