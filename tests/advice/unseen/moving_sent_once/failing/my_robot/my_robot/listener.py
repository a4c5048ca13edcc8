import math

import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener
from turtlesim.srv import Spawn


class FrameListener(Node):

    def __init__(self):
        super().__init__('listener')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.spawner = self.create_client(Spawn, 'spawn')
        self.spawner.wait_for_service()
        self.spawner.call_async(Spawn.Request(x=4.0, y=2.0, theta=0.0, name='turtle2'))
        self.publisher = self.create_publisher(Twist, 'turtle2/cmd_vel', 1)
        self.timer = self.create_timer(0.2, self.on_timer)

    def on_timer(self):
        try:
            t = self.tf_buffer.lookup_transform('turtle2', 'laser', rclpy.time.Time())
        except TransformException as ex:
            self.get_logger().info(f'Could not transform: {ex}')
            return
        msg = Twist()
        msg.angular.z = 1.0 * math.atan2(t.transform.translation.y, t.transform.translation.x)
        msg.linear.x = 0.5 * math.sqrt(t.transform.translation.x ** 2 + t.transform.translation.y ** 2)
        self.publisher.publish(msg)


def main():
    rclpy.init()
    node = FrameListener()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    rclpy.shutdown()
