import math
import os
from enum import Enum, auto

import rclpy
import yaml
from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import Twist
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Empty
from turtlesim.msg import Pose
from turtlesim.srv import SetPen, TeleportAbsolute


class State(Enum):
    START = auto()
    TURN = auto()
    DRIVE = auto()
    DONE = auto()


class Patrol(Node):

    def __init__(self):
        super().__init__('patrol')
        default = os.path.join(get_package_share_directory('patrol'), 'config', 'waypoints.yaml')
        with open(self.declare_parameter('file', default).value) as file:
            self.waypoints = yaml.safe_load(file)['waypoints']
        group = ReentrantCallbackGroup()
        self.pen = self.create_client(SetPen, 'turtle1/set_pen', callback_group=group)
        self.teleport = self.create_client(TeleportAbsolute, 'turtle1/teleport_absolute', callback_group=group)
        self.clear = self.create_client(Empty, 'clear', callback_group=group)
        for client in (self.pen, self.teleport, self.clear):
            while not client.wait_for_service(timeout_sec=0.5):
                self.get_logger().info(f'waiting for {client.srv_name}')
        self.pose = None
        self.state = State.START
        self.create_subscription(Pose, 'turtle1/pose', self.on_pose, 10)
        self.pub = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.timer = self.create_timer(0.05, self.step, callback_group=MutuallyExclusiveCallbackGroup())

    def on_pose(self, msg):
        self.pose = msg

    def step(self):
        if self.pose is None or self.state is State.DONE:
            return
        getattr(self, 'do_' + self.state.name.lower())()

    def do_start(self):
        """Blocking calls: they need the other callback group and the other threads."""
        self.pen.call(SetPen.Request(off=1))
        self.teleport.call(TeleportAbsolute.Request(x=1.0, y=1.0, theta=math.pi / 2))
        self.pen.call(SetPen.Request(r=255, width=4, off=0))
        self.clear.call(Empty.Request())
        self.go(State.TURN)

    def do_turn(self):
        _, error = self.to_waypoint()
        if abs(error) < 0.01:
            self.go(State.DRIVE)
        else:
            self.drive(0.0, 4.0 * error)

    def do_drive(self):
        distance, error = self.to_waypoint()
        if distance > 0.1:
            self.drive(min(2.0, 2.0 * distance), 4.0 * error)
            return
        self.drive(0.0, 0.0)
        reached = self.waypoints.pop(0)
        self.get_logger().info(f"reached {reached['name']} at ({self.pose.x:.2f}, {self.pose.y:.2f})")
        if self.waypoints:
            self.go(State.TURN)
        else:
            self.go(State.DONE)
            self.timer.cancel()
            rclpy.shutdown()

    def to_waypoint(self):
        goal = self.waypoints[0]
        dx, dy = goal['x'] - self.pose.x, goal['y'] - self.pose.y
        error = math.atan2(dy, dx) - self.pose.theta
        return math.hypot(dx, dy), math.atan2(math.sin(error), math.cos(error))

    def drive(self, forward, turn):
        msg = Twist()
        msg.linear.x = forward
        msg.angular.z = turn
        self.pub.publish(msg)

    def go(self, state):
        self.get_logger().info(f'{self.state.name} -> {state.name}')
        self.state = state


def main():
    rclpy.init()
    node = Patrol()
    executor = MultiThreadedExecutor(num_threads=3)
    executor.add_node(node)
    try:
        executor.spin()
    finally:
        executor.shutdown()
        node.destroy_node()
        rclpy.try_shutdown()
        print('off duty')
