import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, State, TransitionCallbackReturn
from std_msgs.msg import String


class LifecycleTalker(LifecycleNode):
    def __init__(self):
        super().__init__('lc_talker')
        self.count = 0
        self.pub = None
        self.timer = None

    def publish(self):
        msg = String()
        msg.data = 'lifecycle %d' % self.count
        self.count += 1
        if self.pub is None or not self.pub.is_activated:
            self.get_logger().warn('publisher is inactive')
        self.pub.publish(msg)

    def on_configure(self, state: State) -> TransitionCallbackReturn:
        self.pub = self.create_lifecycle_publisher(String, 'lifecycle_chatter', 10)
        self.timer = self.create_timer(0.5, self.publish)
        self.get_logger().info('on_configure() from ' + state.label)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state):
        self.get_logger().info('on_activate()')
        return super().on_activate(state)

    def on_deactivate(self, state):
        self.get_logger().info('on_deactivate()')
        return super().on_deactivate(state)

    def on_cleanup(self, state):
        self.destroy_timer(self.timer)
        self.destroy_publisher(self.pub)
        self.get_logger().info('on_cleanup()')
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state):
        self.get_logger().info('on_shutdown() from ' + state.label)
        return TransitionCallbackReturn.SUCCESS


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    node = LifecycleTalker()
    executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, rclpy.executors.ExternalShutdownException):
        node.destroy_node()
