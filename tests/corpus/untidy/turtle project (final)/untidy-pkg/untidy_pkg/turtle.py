from queue import Empty
from re import S
from tokenize import String
import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty
from std_msgs.msg import String


def main(args=None):
    rclpy.init(args=args)
    node = Node('turtle')
    node.create_client(Empty, 'x')
    node.create_publisher(String, 'y', 10)
    node.get_logger().info('accidental imports do no harm')
