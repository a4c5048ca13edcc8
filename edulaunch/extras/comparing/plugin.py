"""The plug-in for comparing: it adds the verb `edulaunch compare`."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

ABOUT = 'run a launch file in simulation and on real rclpy, and list the differences'
PLUGIN = Plugin(
    needs=('edulaunch.extras.native', 'edulaunch.extras.network'),
    verbs={'compare': Verb(ABOUT, 'edulaunch.extras.comparing.verb')},
)
