import sys
import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


def main(args=None):
    rclpy.init(args=args)
    node = Node("add_two_ints_no_oop")
    client = node.create_client(AddTwoInts, "add_two_ints")
    while client.wait_for_service(timeout_sec=1.0) == False:
        node.get_logger().warn("service not available, waiting again...")
    request = AddTwoInts.Request(a=3, b=int(sys.argv[1]))
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    try:
        node.get_logger().info("%d + %d = %d" % (request.a, request.b, future.result().sum))
    except Exception as e:
        node.get_logger().error("Service call failed %r" % (e,))
    node.destroy_node()
    rclpy.shutdown()
