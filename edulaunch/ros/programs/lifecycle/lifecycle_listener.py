"""The program lifecycle_listener: it logs the talker's messages and state changes."""

from __future__ import annotations

from lifecycle_msgs.msg import TransitionEvent
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.ros.running import spin


class LifecycleListener(Node):
    """Subscribes to the talker's messages and transitions."""

    def __init__(self) -> None:
        super().__init__('lc_listener')
        self.create_subscription(String, '/lifecycle_chatter', self.data_callback, 10)
        self.create_subscription(TransitionEvent, '/lc_talker/transition_event', self.notification_callback, 10)

    def data_callback(self, msg: String) -> None:
        """Log a message."""
        self.get_logger().info(f'data_callback: {msg.data}')

    def notification_callback(self, msg: TransitionEvent) -> None:
        """Log a state change."""
        self.get_logger().info(f'notify callback: Transition from state {msg.start_state.label} to {msg.goal_state.label}')


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    spin(LifecycleListener, args)


if __name__ == '__main__':
    main()
