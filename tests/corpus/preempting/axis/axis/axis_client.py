import rclpy
from action_msgs.msg import GoalStatus
from axis_interfaces.action import MoveAxis
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle
from rclpy.node import Node

WORDS = {GoalStatus.STATUS_SUCCEEDED: 'succeeded', GoalStatus.STATUS_ABORTED: 'aborted', GoalStatus.STATUS_CANCELED: 'canceled'}


class AxisClient(Node):

    def __init__(self):
        super().__init__('axis_client')
        self.client = ActionClient(self, MoveAxis, 'move_axis')
        self.last: ClientGoalHandle = None
        self.steps = [(75, 10), (20, 15), (200, 5), (90, 5), 'cancel']
        self.client.wait_for_server()
        self.timer = self.create_timer(1.2, self.step)

    def step(self):
        if not self.steps:
            self.timer.cancel()
            return
        step = self.steps.pop(0)
        if step == 'cancel':
            self.last.cancel_goal_async().add_done_callback(
                lambda f: self.get_logger().info(f'canceling {len(f.result().goals_canceling)}'))
            return
        goal = MoveAxis.Goal(position=step[0], speed=step[1])
        self.get_logger().info(f'go to {goal.position}')
        future = self.client.send_goal_async(goal, feedback_callback=lambda m: print('at', m.feedback.position))
        future.add_done_callback(self.on_response)

    def on_response(self, future):
        handle = future.result()
        if not handle.accepted:
            self.get_logger().info('refused')
            return
        self.last = handle
        handle.get_result_async().add_done_callback(self.on_result)

    def on_result(self, future):
        answer = future.result()
        self.get_logger().info(f'{WORDS[answer.status]} at {answer.result.position}: {answer.result.message}')


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(AxisClient())
