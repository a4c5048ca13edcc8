import threading

import rclpy
from geometry_msgs.msg import Twist


def main():
    rclpy.init()
    node = rclpy.create_node('driver')
    pub = node.create_publisher(Twist, '/turtle1/cmd_vel', 10)
    thread = threading.Thread(target=rclpy.spin, args=(node,), daemon=True)
    thread.start()
    rate = node.create_rate(2)
    msg = Twist()
    msg.linear.x = 1.0
    msg.angular.z = 1.0
    while rclpy.ok():
        pub.publish(msg)
        rate.sleep()
    rclpy.shutdown()
