import threading

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

rclpy.init()
first, second = Node('first'), Node('second')
thread = threading.Thread(target=rclpy.spin_once, args=(first,), kwargs={'timeout_sec': 1.0})
thread.start()
rclpy.spin_once(second, timeout_sec=1.0)
thread.join()
