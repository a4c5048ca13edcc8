import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


def main():
    rclpy.init()
    client = Node('result_too_early').create_client(Trigger, 'do_it')
    client.wait_for_service()
    print(client.call_async(Trigger.Request()).result().success)
