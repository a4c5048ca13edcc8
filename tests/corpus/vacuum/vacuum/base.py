"""Differential drive: /cmd_vel in, wheel speeds, odometry and tf out."""
import math

import rclpy
from geometry_msgs.msg import Quaternion, TransformStamped, Twist
from nav_msgs.msg import Odometry
from rclpy.duration import Duration
from rclpy.node import Node
from std_msgs.msg import Float64MultiArray, MultiArrayDimension, MultiArrayLayout
from std_srvs.srv import Empty
from tf2_ros import TransformBroadcaster


class Base(Node):
    def __init__(self):
        super().__init__('base')
        self.declare_parameters('', [('wheel_separation', 0.5), ('wheel_radius', 0.05), ('cmd_timeout', 1.0)])
        self.sep, self.radius = (p.value for p in self.get_parameters(['wheel_separation', 'wheel_radius']))
        self.timeout = Duration(seconds=self.get_parameter('cmd_timeout').value)
        self.x = self.y = self.theta = 0.0
        self.cmd, self.heard = Twist(), None
        self.create_subscription(Twist, 'cmd_vel', self.on_cmd, 1)
        self.odom_pub = self.create_publisher(Odometry, '~/odom', 10)
        self.wheel_pub = self.create_publisher(Float64MultiArray, 'wheels', 10)
        self.create_service(Empty, '~/reset', self.on_reset)
        self.broadcaster = TransformBroadcaster(self)
        self.before = self.get_clock().now()
        self.create_timer(1 / 20, self.step)

    def on_cmd(self, msg):
        self.cmd, self.heard = msg, self.get_clock().now()

    def on_reset(self, request, response):
        self.x = self.y = self.theta = 0.
        self.get_logger().info('odometry reset')
        return response

    def step(self):
        now = self.get_clock().now()
        dt = (now - self.before).nanoseconds / 1e9
        self.before = now
        if self.heard is not None and now - self.heard > self.timeout:
            self.get_logger().warning('nobody steers, stopping')
            self.cmd, self.heard = Twist(), None
        v, w = self.cmd.linear.x, self.cmd.angular.z
        self.theta += w * dt
        self.x += v * math.cos(self.theta) * dt
        self.y += v * math.sin(self.theta) * dt
        odom = Odometry()
        odom.header.stamp = now.to_msg()
        odom.header.frame_id = 'odom'
        odom.child_frame_id = 'base_link'
        odom.pose.pose.position.x, odom.pose.pose.position.y = self.x, self.y
        odom.pose.pose.orientation = Quaternion(z=math.sin(self.theta / 2), w=math.cos(self.theta / 2))
        odom.pose.covariance[0] = odom.pose.covariance[7] = 0.01
        odom.twist.twist = self.cmd
        self.odom_pub.publish(odom)
        t = TransformStamped(header=odom.header, child_frame_id=odom.child_frame_id)
        t.transform.translation.x, t.transform.translation.y = self.x, self.y
        t.transform.rotation = odom.pose.pose.orientation
        self.broadcaster.sendTransform(t)
        wheels = Float64MultiArray(layout=MultiArrayLayout(dim=[MultiArrayDimension(label='wheel', size=2, stride=2)]))
        wheels.data = [(v - w * self.sep / 2) / self.radius, (v + w * self.sep / 2) / self.radius]
        self.wheel_pub.publish(wheels)


def main(args=None):
    rclpy.init(args=args)
    node = Base()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
