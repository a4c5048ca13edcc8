import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('talker')
publisher = node.create_publisher(String, 'chatter', 10)
subscription = node.create_subscription(String, 'chatter', lambda message: print(message.data), 10)
publisher.publish(String(dta='hello'))
rclpy.spin_once(node)
