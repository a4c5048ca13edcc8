#!/usr/bin/env python
import sys
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from math import pow, atan2, sqrt


class TurtleBot(Node):

    def __init__(self):
        super().__init__('turtlebot_controller')
        self.velocity_publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.pose_subscriber = self.create_subscription(Pose, '/turtle1/pose', self.update_pose, 10)
        self.pose = Pose()
        self.goal_pose = Pose()
        self.goal_pose.x = float(sys.argv[1])
        self.goal_pose.y = float(sys.argv[2])
        self.distance_tolerance = float(sys.argv[3])
        self.timer = self.create_timer(0.1, self.move2goal)

    def update_pose(self, data):
        self.pose = data
        self.pose.x = round(self.pose.x, 4)
        self.pose.y = round(self.pose.y, 4)

    def euclidean_distance(self, goal_pose):
        return sqrt(pow((goal_pose.x - self.pose.x), 2) + pow((goal_pose.y - self.pose.y), 2))

    def steering_angle(self, goal_pose):
        return atan2(goal_pose.y - self.pose.y, goal_pose.x - self.pose.x)

    def move2goal(self):
        vel_msg = Twist()
        if self.euclidean_distance(self.goal_pose) >= self.distance_tolerance:
            vel_msg.linear.x = 1.5 * self.euclidean_distance(self.goal_pose)
            vel_msg.angular.z = 6 * (self.steering_angle(self.goal_pose) - self.pose.theta)
        else:
            self.velocity_publisher.publish(Twist())
            self.get_logger().info("arrived at %.1f %.1f" % (self.pose.x, self.pose.y))
            raise SystemExit
        self.velocity_publisher.publish(vel_msg)


def main(args=None):
    rclpy.init(args=args)
    node = TurtleBot()
    try:
        rclpy.spin(node)
    except SystemExit:
        rclpy.logging.get_logger("Quitting").info('Done')
    node.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
