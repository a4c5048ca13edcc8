import threading

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node

rclpy.init()
node = Node('keys')
publisher = node.create_publisher(Twist, '/turtle1/cmd_vel', 10)
threading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()
while rclpy.ok():
    key = input('w/s? ')
    msg = Twist()
    msg.linear.x = 1.0 if key == 'w' else -1.0
    publisher.publish(msg)
