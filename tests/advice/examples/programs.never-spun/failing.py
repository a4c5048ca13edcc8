import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, self.talk)

    def talk(self):
        self.publisher.publish(String(data='hello'))


class Listener(Node):
    def __init__(self):
        super().__init__('listener')
        self.create_subscription(String, 'chatter', self.heard, 10)

    def heard(self, msg):
        self.get_logger().info(msg.data)


rclpy.init()
executor = SingleThreadedExecutor()
executor.add_node(Talker())
listener = Listener()
executor.spin()
