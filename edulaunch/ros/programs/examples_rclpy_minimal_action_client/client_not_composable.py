"""The program client_not_composable: an action client written with functions instead of a class."""

from __future__ import annotations

import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient

from edulaunch.ros.running import run

ORDER = 10


def work() -> None:
    """Send a goal. Wait for the server, for the acceptance of the goal, and for the result."""
    node = rclpy.create_node('minimal_action_client')
    log = node.get_logger()
    client = ActionClient(node, Fibonacci, 'fibonacci')
    log.info('Waiting for action server...')
    client.wait_for_server()
    log.info('Sending goal request...')
    sent = client.send_goal_async(
        Fibonacci.Goal(order=ORDER), feedback_callback=lambda message: log.info(f'Received feedback: {message.feedback.sequence}')
    )
    rclpy.spin_until_future_complete(node, sent)
    goal_handle = sent.result()
    if not goal_handle.accepted:
        log.info('Goal rejected :(')
        return
    log.info('Goal accepted :)')
    reply = goal_handle.get_result_async()
    rclpy.spin_until_future_complete(node, reply)
    if reply.result().status == GoalStatus.STATUS_SUCCEEDED:
        log.info(f'Goal succeeded! Result: {reply.result().result.sequence}')
    else:
        log.info('Goal failed!')


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()
