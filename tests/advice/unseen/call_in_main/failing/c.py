import rclpy
from rclpy.node import Node
from example_interfaces.srv import AddTwoInts


def main():
    rclpy.init()
    node = Node('asker')
    client = node.create_client(AddTwoInts, 'add')
    client.wait_for_service()
    answer = client.call(AddTwoInts.Request(a=1, b=2))
    node.get_logger().info(str(answer.sum))
    rclpy.spin(node)

main()
