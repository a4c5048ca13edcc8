import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        first = self.declare_parameter('first', 'red').value
        # TODO 1: how many topics are there in this list?
        topics = [
            f'/{first}/chatter'
            '/blue/chatter',
        ]
        self.count = 0
        for topic in topics:
            self.create_subscription(String, topic, self.on_message, 10)

    def on_message(self, message):
        # TODO 2: what does the node remember from the last message?
        count = 0
        count += 1
        self.get_logger().info(f'messages: {count}')


def main():
    rclpy.init()
    rclpy.spin(Counter())
