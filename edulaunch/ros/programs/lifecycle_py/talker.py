"""The program lifecycle_talker: it publishes while it is active."""

from __future__ import annotations

import rclpy
from rclpy.lifecycle import LifecycleNode, LifecyclePublisher, State, TransitionCallbackReturn
from rclpy.timer import Timer
from std_msgs.msg import String

from edulaunch.ros.running import run


class LifecycleTalker(LifecycleNode):
    """Creates its publisher and timer on configure, destroys them on cleanup, and publishes while it is active."""

    def __init__(self, node_name: str) -> None:
        super().__init__(node_name)
        self._count = 0
        self._pub: LifecyclePublisher | None = None
        self._timer: Timer | None = None

    def publish(self) -> None:
        """Publish the next number. An inactive publisher sends nothing."""
        message = String(data=f'Lifecycle HelloWorld #{self._count}')
        self._count += 1
        if self._pub is None or not self._pub.is_activated:
            self.get_logger().info('Lifecycle publisher is inactive. Messages are not published.')
        else:
            self.get_logger().info(f'Lifecycle publisher is active. Publishing: [{message.data}]')
        if self._pub is not None:
            self._pub.publish(message)

    def on_configure(self, state: State) -> TransitionCallbackReturn:
        """Create the publisher and the timer."""
        self._pub = self.create_lifecycle_publisher(String, 'lifecycle_chatter', 10)
        self._timer = self.create_timer(1.0, self.publish)
        self.get_logger().info('on_configure() is called.')
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: State) -> TransitionCallbackReturn:
        """Activate the publisher, as the base class does."""
        self.get_logger().info('on_activate() is called.')
        return super().on_activate(state)

    def on_deactivate(self, state: State) -> TransitionCallbackReturn:
        """Deactivate the publisher, as the base class does."""
        self.get_logger().info('on_deactivate() is called.')
        return super().on_deactivate(state)

    def on_cleanup(self, state: State) -> TransitionCallbackReturn:
        """Destroy the publisher and the timer."""
        self._give_back()
        self.get_logger().info('on_cleanup() is called.')
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: State) -> TransitionCallbackReturn:
        """Destroy the publisher and the timer."""
        self._give_back()
        self.get_logger().info('on_shutdown() is called.')
        return TransitionCallbackReturn.SUCCESS

    def _give_back(self) -> None:
        if self._timer is not None:
            self.destroy_timer(self._timer)
        if self._pub is not None:
            self.destroy_publisher(self._pub)
        self._timer = self._pub = None


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(lambda: rclpy.spin(LifecycleTalker('lc_talker')), args)


if __name__ == '__main__':
    main()
