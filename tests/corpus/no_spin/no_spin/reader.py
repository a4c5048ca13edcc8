import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String


def main(args=None):
    rclpy.init(args=args)
    node = Node('reader')
    ok, msg = wait_for_message(String, node, 'news')
    print(ok, msg.data)
    node.get_clock().sleep_for(Duration(seconds=1.2))
    ok, msg = wait_for_message(String, node, 'news', time_to_wait=2.0)
    print(ok, msg.data)
    print(wait_for_message(String, node, 'olds', time_to_wait=0.5))
    print(node.wait_for_node('/sender', 1.0), node.wait_for_node('/nobody', 0.3))
