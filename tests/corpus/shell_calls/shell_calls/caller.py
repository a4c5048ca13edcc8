import os
import signal
import subprocess
import time

import rclpy
from rclpy.node import Node


class Caller(Node):
    """Does everything by commands."""

    def __init__(self):
        super().__init__('caller')
        self.create_timer(1.0, self.once)

    def once(self):
        log = self.get_logger()
        log.info('spawn: %d' % os.system('ros2 service call /spawn turtlesim/srv/Spawn "{x: 2.0, y: 2.0, name: bob}" > /dev/null 2>&1'))
        os.system('ros2 topic pub -r 2 /bob/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 1.0}}" > /dev/null &')
        time.sleep(2.0)
        done = subprocess.run(['ros2', 'topic', 'list'], capture_output=True, text=True)
        log.info(f'{done.returncode} {[t for t in done.stdout.split() if "bob" in t]}')
        nodes = subprocess.check_output('ros2 node list', shell=True).decode().splitlines()
        log.info(f'nodes: {[n for n in nodes if "ros2cli" not in n]}')
        with subprocess.Popen(['ros2', 'topic', 'echo', '/bob/pose', '--field', 'x'], stdout=subprocess.PIPE, text=True) as echo:
            log.info('x is %.2f' % float(echo.stdout.readline()))
            echo.send_signal(signal.SIGINT)
        log.info(f'echo ended with {echo.returncode}')
        log.info(os.popen('ros2 param get /turtlesim background_r').read().strip())
        try:
            subprocess.run(['ros2', 'service', 'call', '/nobody', 'std_srvs/srv/Empty'], stdout=subprocess.DEVNULL, timeout=1.5)
        except subprocess.TimeoutExpired as e:
            log.warn(f'gave up after {e.timeout} s')
        if subprocess.call(['ros2', 'service', 'kall'], stderr=subprocess.DEVNULL):
            log.error('no such command')
        raise SystemExit


def main():
    rclpy.init()
    node = Caller()
    try:
        rclpy.spin(node)
    except SystemExit:
        node.get_logger().info('done')
    node.destroy_node()
    rclpy.shutdown()
