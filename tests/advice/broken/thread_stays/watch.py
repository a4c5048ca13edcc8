import threading
import time

import rclpy
from rclpy.node import Node


class Watch(Node):
    def __init__(self):
        super().__init__('watch')
        self.thread = threading.Thread(target=self.loop)
        self.thread.start()

    def loop(self):
        while True:
            time.sleep(0.5)


rclpy.init()
node = Watch()
try:
    rclpy.spin(node)
except KeyboardInterrupt:
    pass
