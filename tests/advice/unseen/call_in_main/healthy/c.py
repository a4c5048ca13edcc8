import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


def main():
    rclpy.init()
    node = Node('asker')
    client = node.create_client(AddTwoInts, 'add')
    client.wait_for_service()
    future = client.call_async(AddTwoInts.Request(a=1, b=2))
    rclpy.spin_until_future_complete(node, future)
    node.get_logger().info(str(future.result().sum))
    rclpy.spin(node)

main()
