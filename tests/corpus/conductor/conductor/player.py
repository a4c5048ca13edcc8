import rclpy
from example_interfaces.msg import Int64
from rclpy.lifecycle import Node as LifecycleNode
from rclpy.lifecycle import State, TransitionCallbackReturn


class Player(LifecycleNode):
    """Publishes numbers while it is active. The second time, configuring fails; a broken string is an error."""

    def __init__(self):
        super().__init__('player')
        self.pub = None
        self.timer = None
        self.number = 0
        self.tries = 0

    def on_configure(self, previous_state: State):
        self.tries += 1
        self.get_logger().info(f'configure from {previous_state.label}')
        if self.tries == 2:
            return TransitionCallbackReturn.FAILURE
        self.pub = self.create_lifecycle_publisher(Int64, 'number', 10)
        self.timer = self.create_timer(0.5, self.play)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, previous_state: State):
        self.get_logger().info('activate')
        return super().on_activate(previous_state)

    def on_deactivate(self, previous_state: State):
        if self.tries == 3:
            raise RuntimeError('a string broke')
        return super().on_deactivate(previous_state)

    def on_cleanup(self, previous_state: State):
        self.destroy_timer(self.timer)
        self.destroy_lifecycle_publisher(self.pub)
        return TransitionCallbackReturn.SUCCESS

    def on_error(self, previous_state: State):
        self.get_logger().error(f'error, was {previous_state.label}')
        self.destroy_timer(self.timer)
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, previous_state: State):
        self.get_logger().info(f'shut down from {previous_state.label}')
        return TransitionCallbackReturn.SUCCESS

    def play(self):
        self.number += 1
        self.pub.publish(Int64(data=self.number))


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Player())
