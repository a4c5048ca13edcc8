import rclpy
from rclpy.node import Node
from std_msgs.msg import String

rclpy.init()
node = Node('greeter')
publisher = node.create_publisher(String, 'greeting', 10)
publisher.publish(String(data='hello'))
