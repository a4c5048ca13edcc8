import rclpy
from rclpy.node import Node
from std_srvs.srv import Empty


def main():
    rclpy.init()
    asker, other = Node('asker'), Node('other')
    client = asker.create_client(Empty, '/clear')
    client.wait_for_service()
    rclpy.spin_until_future_complete(other, client.call_async(Empty.Request()))
    print('never')
