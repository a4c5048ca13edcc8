import rclpy
from rclpy.action import ActionClient
from rclpy.node import Node
from turtlesim.action import RotateAbsolute
from math import radians


class Turn(Node):
    def __init__(self):
        super().__init__('turn')
        self.client = ActionClient(self, RotateAbsolute, '/turtle1/rotate_absolute')

    def send(self, angle):
        self.client.wait_for_server()
        goal = RotateAbsolute.Goal()
        goal.theta = angle
        self.future = self.client.send_goal_async(goal)
        self.future.add_done_callback(self.accepted)

    def accepted(self, future):
        self.get_logger().info('accepted: %s' % future.result().accepted)


def main():
    rclpy.init()
    node = Turn()
    node.send(radians(90.0))
    rclpy.spin(node)


main()
