import rclpy
from rclpy.node import Node
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Mine(LifecycleNode):
    def __init__(self):
        super().__init__('talker')

    def on_configure(self, state):
        self.publisher = self.create_lifecycle_publisher(String, '/chatter', 10)
        self.create_timer(0.5, lambda: self.publisher.publish(String(data='hi')))
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        return super().on_activate(state)


def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()
