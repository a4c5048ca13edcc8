"""The program for the arrow keys of the live view. It reads velocities line by line and publishes them, as a teleop node does.

It runs inside the simulation, so the recording contains the user's commands as messages of a node. A line is
`NAMESPACE LINEAR ANGULAR` (m/s, rad/s).
"""

import sys
from typing import Any

import rclpy
from geometry_msgs.msg import Twist, TwistStamped

TYPES: dict[str, Any] = {'geometry_msgs/msg/Twist': Twist, 'geometry_msgs/msg/TwistStamped': TwistStamped}


def main() -> None:
    rclpy.init()
    node = rclpy.create_node('_desk')
    publishers: dict[tuple[str, str], Any] = {}
    for line in sys.stdin:
        who, linear, angular = line.split()
        topic = f'{who}/cmd_vel'.replace('//', '/')
        subscribed_types = {end.topic_type for end in node.get_subscriptions_info_by_topic(topic)}
        kind = next((name for name in TYPES if name in subscribed_types), 'geometry_msgs/msg/Twist')
        if (topic, kind) not in publishers:
            publishers[topic, kind] = node.create_publisher(TYPES[kind], topic, 10)
        message: Any = TYPES[kind]()
        twist = message
        if kind.endswith('Stamped'):
            message.header.stamp = node.get_clock().now().to_msg()
            twist = message.twist
        twist.linear.x, twist.angular.z = float(linear), float(angular)
        publishers[topic, kind].publish(message)


if __name__ == '__main__':
    main()
