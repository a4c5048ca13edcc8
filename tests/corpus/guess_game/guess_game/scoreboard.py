import rclpy
from std_msgs.msg import String


def main(args=None):
    rclpy.init(args=args)
    node = rclpy.create_node('scoreboard')
    node.create_subscription(String, 'score', lambda msg: node.get_logger().info(msg.data), 10)
    rclpy.spin(node)
