from threading import Thread
import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


def main(args=None):
    rclpy.init(args=args)
    node = Node('threaded_client')
    cli = node.create_client(AddTwoInts, 'add')
    spin_thread = Thread(target=rclpy.spin, args=(node,))
    spin_thread.start()
    cli.wait_for_service()
    result = cli.call(AddTwoInts.Request(a=1, b=2))
    print('result:', result.sum)
    node.destroy_node()
    rclpy.shutdown()
    spin_thread.join()
