import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', OFTEN)
        self.create_timer(0.5, self.talk)

    def talk(self):
        self.publisher.publish(String(data='hello'))


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'chatter', self.heard, OFTEN)

    def heard(self, msg):
        self.get_logger().info(msg.data)


OFTEN = QoSProfile(depth=10, deadline=Duration(seconds=1))

rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(Talker())
executor.add_node(Listener())
executor.spin()
