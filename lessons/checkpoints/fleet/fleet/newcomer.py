import rclpy
from turtlesim.srv import Spawn


def main():
    rclpy.init()
    node = rclpy.create_node('newcomer')
    me = node.declare_parameter('me', 'turtle2').value
    client = node.create_client(Spawn, 'spawn')
    client.wait_for_service()
    future = client.call_async(Spawn.Request(x=2.0, y=2.0, name=me))
    rclpy.spin_until_future_complete(node, future)
    if future.result().name == me:
        node.get_logger().info(f'here is {me}')
    else:
        node.get_logger().error(f'no place for {me}')


if __name__ == '__main__':
    main()
