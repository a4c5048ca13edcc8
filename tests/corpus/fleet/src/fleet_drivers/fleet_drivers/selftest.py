import time

import rclpy
from fleet_msgs.srv import SetMode


def main():
    rclpy.init()
    node = rclpy.create_node('selftest')
    cli = node.create_client(SetMode, 'set_mode')
    if not cli.wait_for_service(timeout_sec=2.0):
        node.get_logger().fatal('no motor driver')
        return 3
    fut = cli.call_async(SetMode.Request(mode=SetMode.Request.AUTO))
    rclpy.spin_until_future_complete(node, fut)
    print('selftest:', fut.result().message, flush=True)
    time.sleep(0.5)
    node.destroy_node()
    rclpy.shutdown()
    return 0 if fut.result().accepted else 1
