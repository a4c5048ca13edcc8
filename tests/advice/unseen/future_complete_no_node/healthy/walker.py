import rclpy
from example_interfaces.srv import AddTwoInts


def main():
    rclpy.init()
    node = rclpy.create_node('asker')
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(1.0):
        node.get_logger().info('waiting')
    future = client.call_async(AddTwoInts.Request(a=1, b=2))
    rclpy.spin_until_future_complete(node, future)
    node.get_logger().info(str(future.result().sum))
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
