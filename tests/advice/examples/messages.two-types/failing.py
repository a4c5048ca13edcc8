import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String

rclpy.init()
node = Node('robot')
node.create_publisher(String, 'count', 10).publish(String(data='1'))
heard = node.create_subscription(Int32, 'count', print, 10)
rclpy.spin_once(node)
