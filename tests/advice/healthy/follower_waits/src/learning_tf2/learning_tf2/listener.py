import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener
from turtlesim.srv import Spawn


class FrameListener(Node):

    def __init__(self):
        super().__init__('turtle_tf2_frame_listener')
        self.target_frame = self.declare_parameter('target_frame', 'turtle1').get_parameter_value().string_value
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.spawner = self.create_client(Spawn, 'spawn')
        self.publisher = self.create_publisher(Twist, 'turtle2/cmd_vel', 1)
        self.spawned = False
        self.timer = self.create_timer(0.1, self.on_timer)

    def on_timer(self):
        if not self.spawned:
            if self.spawner.service_is_ready():
                request = Spawn.Request(x=4.0, y=2.0, theta=0.0, name='turtle2')
                self.spawner.call_async(request)
                self.spawned = True
            return
        try:
            t = self.tf_buffer.lookup_transform('turtle2', self.target_frame, rclpy.time.Time(), timeout=rclpy.duration.Duration(seconds=0.05))
        except TransformException as ex:
            self.get_logger().info(f'Could not transform turtle2 to {self.target_frame}: {ex}')
            return
        msg = Twist()
        msg.angular.z = 1.0 * math.atan2(t.transform.translation.y, t.transform.translation.x)
        msg.linear.x = 0.5 * math.hypot(t.transform.translation.x, t.transform.translation.y)
        self.publisher.publish(msg)


def main():
    rclpy.init()
    node = FrameListener()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    rclpy.shutdown()
