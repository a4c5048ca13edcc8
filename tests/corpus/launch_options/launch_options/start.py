import rclpy
from rclpy.node import Node
from std_msgs.msg import String


def main():
    rclpy.init()
    node = Node('start')
    node.declare_parameter('word', 'x')
    pub = node.create_publisher(String, 'first', 10)
    node.create_subscription(String, 'last', lambda m: node.get_logger().info('last: ' + m.data), 10)
    node.create_timer(1.0, lambda: pub.publish(String(data=node.get_parameter('word').value)))
    rclpy.spin(node)
