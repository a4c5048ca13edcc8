import math
import rclpy
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose

node = None
publisher = None
x = y = theta = 0.0


def pose_callback(msg):
    global x, y, theta
    x, y, theta = msg.x, msg.y, msg.theta


def timer_callback():
    vel = Twist()
    vel.linear.x = 2.0
    vel.angular.z = math.pi / 2
    publisher.publish(vel)
    node.get_logger().info('(%.1f, %.1f) %.1f' % (x, y, theta))


def main(args=None):
    global node, publisher
    rclpy.init(args=args)
    node = rclpy.create_node('circle')
    publisher = node.create_publisher(Twist, 'turtle1/cmd_vel', 10)
    subscription = node.create_subscription(Pose, 'turtle1/pose', pose_callback, 10)
    timer = node.create_timer(1.0, timer_callback)
    while rclpy.ok():
        rclpy.spin_once(node)
    timer.cancel()
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
