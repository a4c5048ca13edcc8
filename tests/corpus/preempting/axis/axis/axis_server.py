import threading
import time

import rclpy
from axis_interfaces.action import MoveAxis
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class AxisServer(Node):
    """One goal at a time: a new one ends the old one, or waits for it (parameter `policy`)."""

    def __init__(self):
        super().__init__('axis_server')
        self.policy = self.declare_parameter('policy', 'preempt').value
        self.position = 50
        self.lock = threading.Lock()
        self.current: ServerGoalHandle = None
        self.queue = []
        self.server = ActionServer(
            self, MoveAxis, 'move_axis',
            goal_callback=self.on_goal,
            handle_accepted_callback=self.on_accepted,
            cancel_callback=self.on_cancel,
            execute_callback=self.execute,
            callback_group=ReentrantCallbackGroup())
        self.get_logger().info(f'axis at {self.position}, policy {self.policy}')

    def on_goal(self, goal: MoveAxis.Goal):
        if goal.position not in range(0, 101) or goal.speed <= 0:
            self.get_logger().warn(f'no such position or speed: {goal.position}, {goal.speed}')
            return GoalResponse.REJECT
        return GoalResponse.ACCEPT

    def on_accepted(self, goal_handle: ServerGoalHandle):
        with self.lock:
            if self.current is not None and self.policy == 'queue':
                self.queue.append(goal_handle)
                self.get_logger().info(f'{goal_handle.request.position} has to wait')
                return
            if self.current is not None and self.current.is_active:
                self.get_logger().info(f'{self.current.request.position} gives way to {goal_handle.request.position}')
                self.current.abort()
            self.current = goal_handle
        goal_handle.execute()

    def on_cancel(self, goal_handle: ServerGoalHandle):
        return CancelResponse.ACCEPT

    def execute(self, goal_handle: ServerGoalHandle):
        request = goal_handle.request
        result, feedback = MoveAxis.Result(), MoveAxis.Feedback()
        while True:
            if not goal_handle.is_active:
                result.message = 'somebody else moves it'
                break
            if goal_handle.is_cancel_requested:
                result.message = 'stopped'
                goal_handle.canceled()
                break
            rest = request.position - self.position
            if rest == 0:
                result.message = 'there'
                goal_handle.succeed()
                break
            self.position += max(-request.speed, min(request.speed, rest))
            feedback.position = self.position
            goal_handle.publish_feedback(feedback)
            time.sleep(0.5)
        result.position = self.position
        self.next_goal(goal_handle)
        return result

    def next_goal(self, ended: ServerGoalHandle):
        with self.lock:
            if self.current is ended:
                self.current = self.queue.pop(0) if self.queue else None
                if self.current is not None:
                    self.current.execute()


def main(args=None):
    rclpy.init(args=args)
    node = AxisServer()
    executor = MultiThreadedExecutor()
    executor.add_node(node)
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass
    node.destroy_node()
