import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import String


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', qos_profile_sensor_data)
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
executor.add_node(Listener())
executor.spin()
