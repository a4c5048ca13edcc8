import rclpy
from rclpy.node import Node
from rclpy.qos_overriding_options import QoSOverridingOptions
from std_msgs.msg import String

rclpy.init(args=['--ros-args', '-p', 'qos_overrides./chatter.publisher.reliability:=certain'])
node = Node('robot')
publisher = node.create_publisher(String, 'chatter', 10, qos_overriding_options=QoSOverridingOptions.with_default_policies())
heard = node.create_subscription(String, 'chatter', print, 1)
publisher.publish(String(data='hello'))
rclpy.spin_once(node, timeout_sec=1.0)
