import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Talker(LifecycleNode):
    def __init__(self):
        super().__init__('talker')
        self.publisher = None

    def on_configure(self, state):
        self.publisher = self.create_lifecycle_publisher(String, 'chatter', 10)
        self.create_timer(0.5, self.say)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        self.get_logger().info('active')
        return super().on_activate(state)

    def say(self):
        self.publisher.publish(String(data='hello'))


def main():
    rclpy.init()
    rclpy.spin(Talker())
