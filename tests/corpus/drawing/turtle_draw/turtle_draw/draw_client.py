#!/usr/bin/env python3
import sys
import argparse
import rclpy
from rclpy.node import Node
from rclpy.action import ActionClient
from rclpy.action.client import ClientGoalHandle, GoalStatus
from rclpy.utilities import remove_ros_args
from draw_interfaces.action import DrawShape
from draw_interfaces.srv import GetShape
from geometry_msgs.msg import Pose2D


class DrawClient(Node):
    def __init__(self, opts):
        super().__init__('draw_client')
        self.cli = self.create_client(GetShape, 'get_shape')
        while not self.cli.wait_for_service(timeout_sec=1.0):
            self.get_logger().warning('service not available, waiting again...')
        self.ac = ActionClient(self, DrawShape, 'draw_shape')
        self.opts = opts

    def ask(self):
        req = GetShape.Request(sides=self.opts.sides, size=self.opts.size)
        if self.opts.twice:
            req.offsets = [Pose2D(x=1.0, y=1.0, theta=0.0)]
        self.future = self.cli.call_async(req)
        rclpy.spin_until_future_complete(self, self.future)
        return self.future.result()

    def send(self, drawing):
        goal = DrawShape.Goal()
        goal.strokes = drawing.strokes
        if self.opts.speed:
            goal.speed = self.opts.speed
        self.ac.wait_for_server()
        self.get_logger().info("Sending goal, speed %.2f" % goal.speed)
        self.ac.send_goal_async(goal, feedback_callback=self.fb).add_done_callback(self.goal_response)

    def fb(self, msg):
        f = msg.feedback
        self.get_logger().info(f'{f.current} {f.percent:.1f}% at ({f.position.x:.2f}, {f.position.y:.2f})')

    def goal_response(self, future):
        self.goal_handle: ClientGoalHandle = future.result()
        if not self.goal_handle.accepted:
            self.get_logger().warn("Goal got rejected")
            rclpy.shutdown()
            return
        self.get_logger().info("Goal got accepted")
        self.goal_handle.get_result_async().add_done_callback(self.result_cb)
        if self.opts.cancel_after:
            self.t = self.create_timer(self.opts.cancel_after, self.cancel)

    def cancel(self):
        self.t.cancel()
        self.get_logger().info('Send a cancel request')
        self.goal_handle.cancel_goal_async().add_done_callback(
            lambda f: self.get_logger().info(f'{len(f.result().goals_canceling)} canceling, return code {f.result().return_code}'))

    def result_cb(self, future):
        status = future.result().status
        result = future.result().result
        if status == GoalStatus.STATUS_SUCCEEDED:
            self.get_logger().info("Success")
        elif status == GoalStatus.STATUS_ABORTED:
            self.get_logger().error("Aborted")
        elif status == GoalStatus.STATUS_CANCELED:
            self.get_logger().warn("Canceled")
        self.get_logger().info(f"Result: {result.done} {result.error_code} {result.length:.2f}")
        rclpy.shutdown()


def main(args=None):
    rclpy.init(args=args)
    parser = argparse.ArgumentParser(description='draws')
    parser.add_argument('--sides', type=int, default=GetShape.Request.SQUARE)
    parser.add_argument('--size', type=float, default=2.0)
    parser.add_argument('--speed', type=float)
    parser.add_argument('--cancel-after', type=float, default=0)
    parser.add_argument('--twice', action='store_true')
    opts = parser.parse_args(remove_ros_args(sys.argv)[1:])
    node = DrawClient(opts)
    resp = node.ask()
    if not resp.success:
        node.get_logger().error(f'no shape: code={resp.code}')
        node.destroy_node()
        rclpy.shutdown()
        sys.exit(1)
    stroke = resp.drawing.strokes[0]
    print(stroke.name, len(stroke.points), stroke.tags, [round(float(v), 2) for v in stroke.bbox], stroke.pen == stroke.PEN_DOWN)
    node.send(resp.drawing)
    rclpy.spin(node)


if __name__ == '__main__':
    main()
