import rclpy
from turtlesim.srv import Spawn


def main():
    rclpy.init()
    node = rclpy.create_node('spawner')
    client = node.create_client(Spawn, 'spawn')
    client.wait_for_service()
    request = Spawn.Request(name='turtle2', x=4.0, y=2.0, theta=0.0)
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    node.get_logger().info(f'Successfully spawned {future.result().name}')
    rclpy.shutdown()
