from threading import Event, Thread

import rclpy
from rclpy.node import Node


def work(event):
    event.wait()


rclpy.init()
node = Node('worker')
stop = Event()
Thread(target=work, args=[stop]).start()
rclpy.spin(node)
