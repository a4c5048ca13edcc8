"""The program lifecycle_service_client: it triggers the transitions of lc_talker."""

from __future__ import annotations

import time

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rclpy.node import Node

from edulaunch.ros.running import run

STEPS = (
    ('TRANSITION_CONFIGURE', 10.0),
    ('TRANSITION_ACTIVATE', 10.0),
    ('TRANSITION_DEACTIVATE', 10.0),
    ('TRANSITION_ACTIVATE', 10.0),
    ('TRANSITION_DEACTIVATE', 10.0),
    ('TRANSITION_CLEANUP', 10.0),
    ('TRANSITION_UNCONFIGURED_SHUTDOWN', 0.0),
)
"""Transitions, each with the seconds to wait after it."""


class LifecycleServiceClient(Node):
    """Calls the services of lc_talker."""

    def __init__(self) -> None:
        super().__init__('lc_client')
        self._get = self.create_client(GetState, 'lc_talker/get_state')
        self._change = self.create_client(ChangeState, 'lc_talker/change_state')

    def get_state(self) -> bool:
        """Log the state of lc_talker. Return False if no reply arrives."""
        if not self._get.wait_for_service(timeout_sec=5.0):
            self.get_logger().error('Service /lc_talker/get_state is not available.')
            return False
        future = self._get.call_async(GetState.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=5.0)
        answer = future.result()
        if answer is None:
            self.get_logger().error('Server time out while getting current state for node lc_talker')
            return False
        self.get_logger().info(f'Node lc_talker has current state {answer.current_state.label}.')
        return True

    def change_state(self, transition: int) -> bool:
        """Trigger a transition and log its result."""
        if not self._change.wait_for_service(timeout_sec=5.0):
            self.get_logger().error('Service /lc_talker/change_state is not available.')
            return False
        future = self._change.call_async(ChangeState.Request(transition=Transition(id=transition)))
        rclpy.spin_until_future_complete(self, future, timeout_sec=5.0)
        answer = future.result()
        if answer is None:
            self.get_logger().error('Server time out while getting current state for node lc_talker')
            return False
        text = (
            f'Transition {transition} successfully triggered.' if answer.success else f'Failed to trigger transition {transition}'
        )
        self.get_logger().info(text) if answer.success else self.get_logger().warning(text)
        return bool(answer.success)


def work() -> None:
    """Trigger the transitions one after the other, until one fails."""
    client = LifecycleServiceClient()
    if not client.get_state():
        return
    for name, pause_s in STEPS:
        if not client.change_state(getattr(Transition, name)) or not client.get_state():
            return
        time.sleep(pause_s)


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
