import queue

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.answers = queue.Queue()
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_subscription(String, 'chatter', self.heard, 10)
        self.publisher.publish(String(data='one'))
        self.publisher.publish(String(data='two'))

    def heard(self, msg):
        self.answers.put(msg.data)
        self.answers.get()


rclpy.init()
rclpy.spin(Listener())
