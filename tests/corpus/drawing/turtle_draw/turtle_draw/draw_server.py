#!/usr/bin/env python3
import math
import threading
import time

import rclpy
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.action.server import ServerGoalHandle
from rclpy.callback_groups import ReentrantCallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from draw_interfaces.action import DrawShape
from draw_interfaces.msg import Stroke
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from turtlesim.srv import SetPen, TeleportAbsolute


class DrawServer(Node):

    def __init__(self):
        super().__init__('draw_server')
        self.goal_handle_: ServerGoalHandle = None
        self.goal_lock_ = threading.Lock()
        self.pose = None
        self.cb_group = ReentrantCallbackGroup()
        self.declare_parameter('kp_lin', 3.0)
        self.declare_parameter('kp_ang', 8.0)
        self.declare_parameter('tolerance', 0.1)
        self.create_subscription(Pose, '/turtle1/pose', self.pose_cb, 10, callback_group=self.cb_group)
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.pen_client = self.create_client(SetPen, '/turtle1/set_pen', callback_group=self.cb_group)
        self.tele_client = self.create_client(TeleportAbsolute, '/turtle1/teleport_absolute',
                                              callback_group=MutuallyExclusiveCallbackGroup())
        self.server_ = ActionServer(self, DrawShape, 'draw_shape',
                                    goal_callback=self.goal_callback,
                                    handle_accepted_callback=self.handle_accepted_callback,
                                    cancel_callback=self.cancel_callback,
                                    execute_callback=self.execute_callback,
                                    callback_group=self.cb_group)
        self.get_logger().info("Action server has been started")

    def pose_cb(self, msg):
        self.pose = msg

    def goal_callback(self, goal_request: DrawShape.Goal):
        self.get_logger().info("Received a goal with %d strokes" % len(goal_request.strokes))
        with self.goal_lock_:
            if self.goal_handle_ is not None and self.goal_handle_.is_active:
                self.get_logger().info("A goal is already active, reject new goal")
                return GoalResponse.REJECT
        if not goal_request.strokes:
            return GoalResponse.REJECT
        return GoalResponse.ACCEPT

    def handle_accepted_callback(self, goal_handle):
        self.goal_handle_ = goal_handle
        goal_handle.execute()

    def cancel_callback(self, goal_handle: ServerGoalHandle):
        self.get_logger().info("Received a cancel request")
        return CancelResponse.ACCEPT

    def set_pen(self, down, color):
        req = SetPen.Request()
        req.r, req.g, req.b = int(color.r * 255), int(color.g * 255), int(color.b * 255)
        req.width = 3
        req.off = 0 if down else 1
        self.pen_client.call(req)

    def execute_callback(self, goal_handle: ServerGoalHandle):
        with self.goal_lock_:
            self.goal_handle_ = goal_handle
        self.get_logger().info("Executing the goal")
        feedback = DrawShape.Feedback()
        result = DrawShape.Result()
        total = sum(len(s.points) for s in goal_handle.request.strokes)
        n = 0
        while self.pose is None:
            time.sleep(0.05)
        for stroke in goal_handle.request.strokes:
            self.set_pen(False, stroke.color)
            first = stroke.points[0]
            self.tele_client.call(TeleportAbsolute.Request(x=first.x, y=first.y, theta=0.0))
            self.set_pen(stroke.pen == Stroke.PEN_DOWN, stroke.color)
            for p in stroke.points:
                if not (0.0 < p.x < 11.08 and 0.0 < p.y < 11.08):
                    result.error_code = DrawShape.Result.ERR_WALL
                    goal_handle.abort()
                    return result
                result.length += self.go_to(p, goal_handle)
                if goal_handle.is_cancel_requested:
                    goal_handle.canceled()
                    self.get_logger().info('canceled')
                    self.pub.publish(Twist())
                    return result
                n += 1
                feedback.current = n
                feedback.percent = 100.0 * n / total
                feedback.position = p
                goal_handle.publish_feedback(feedback)
        result.done = True
        goal_handle.succeed()
        return result

    def go_to(self, p, goal_handle):
        klin = self.get_parameter('kp_lin').get_parameter_value().double_value
        kang = self.get_parameter('kp_ang').get_parameter_value().double_value
        tol = self.get_parameter('tolerance').value
        sx, sy = self.pose.x, self.pose.y
        while rclpy.ok() and not goal_handle.is_cancel_requested:
            dx, dy = p.x - self.pose.x, p.y - self.pose.y
            dist = math.hypot(dx, dy)
            if dist < tol:
                break
            err = math.atan2(dy, dx) - self.pose.theta
            err = math.atan2(math.sin(err), math.cos(err))
            cmd = Twist()
            cmd.angular.z = kang * err
            if abs(err) < 0.3:
                cmd.linear.x = min(klin * dist, goal_handle.request.speed)
            self.pub.publish(cmd)
            time.sleep(0.02)
        self.pub.publish(Twist())
        return math.hypot(self.pose.x - sx, self.pose.y - sy)


def main(args=None):
    rclpy.init(args=args)
    node = DrawServer()
    executor = MultiThreadedExecutor(num_threads=4)
    try:
        rclpy.spin(node, executor)
    except KeyboardInterrupt:
        node.get_logger().info('bye')
    finally:
        node.destroy_node()
        if rclpy.ok():
            rclpy.shutdown()


if __name__ == '__main__':
    main()
