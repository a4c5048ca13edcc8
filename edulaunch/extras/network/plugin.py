"""The plug-in of the network. It adds `edulaunch network`, `ros2 launch --network`, `edulaunch launch --real`, and a service."""

from __future__ import annotations

from edulaunch.runtime.plugins import Plugin, Verb

ABOUT = 'connect the machine to a real ROS 2 network, or install real rclpy'
PLUGIN = Plugin(
    needs=('edulaunch.extras.native',),
    verbs={'network': Verb(ABOUT, 'edulaunch.extras.network.verb')},
    options={'launch': 'edulaunch.extras.network.edulaunch_launch', 'ros2 launch': 'edulaunch.extras.network.ros2_launch'},
    services={'network': 'edulaunch.extras.network.service'},
)
