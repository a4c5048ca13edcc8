from enum import Enum

import numpy as np
import rclpy
import rclpy.qos
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import LaserScan


class State(Enum):
    FORWARD = 0
    LEFT = 1
    RIGHT = 2


class Brain(Node):
    def __init__(self):
        super().__init__('brain')
        self.state = State.FORWARD
        self.turns = 0
        self.pub = self.create_publisher(Twist, 'cmd_vel', 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, rclpy.qos.QoSPresetProfiles.SENSOR_DATA.value)

    def on_scan(self, msg):
        ranges = np.array(msg.ranges)
        ranges[np.isinf(ranges)] = msg.range_max
        mid, wide = len(ranges) // 2, len(ranges) // 12
        front = ranges[mid - wide:mid + wide].min()
        left, right = ranges[mid + wide:mid + 3 * wide], ranges[mid - 3 * wide:mid - wide]
        before = self.state
        if front > 0.8:
            self.state = State.FORWARD
        elif self.state is State.FORWARD:
            self.state = State.LEFT if left.mean() > right.mean() + 0.01 else State.RIGHT
        if before is not self.state:
            self.turns += self.state is not State.FORWARD
            self.get_logger().info(f'{before.name} -> {self.state.name} at {front:.2f} m, {type(msg.ranges).__name__} of {msg.ranges.typecode}')
        if self.turns == 3:
            self.get_logger().info('battery empty')
            raise SystemExit
        cmd = Twist()
        if self.state is State.FORWARD:
            cmd.linear.x = 0.5
        else:
            cmd.angular.z = 1.0 if self.state is State.LEFT else -1.0
        self.pub.publish(cmd)


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Brain())
