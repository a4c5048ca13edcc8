import time
import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Mover(Node):
    def __init__(self):
        super().__init__('mover')
        self.pose = None
        self.pub = self.create_publisher(Twist, 'turtle1/cmd_vel', 10)
        self.create_subscription(Pose, 'turtle1/pose', self.update, 10)

    def update(self, pose):
        self.pose = pose

    def drive(self, distance, speed=1.0):
        while self.pose is None:
            rclpy.spin_once(self)
        start = self.pose.x
        vel = Twist()
        vel.linear.x = speed
        while rclpy.ok() and abs(self.pose.x - start) < distance:
            self.pub.publish(vel)
            rclpy.spin_once(self, timeout_sec=0.1)
        self.pub.publish(Twist())
        self.get_logger().info('at %.2f' % self.pose.x)


def main():
    rclpy.init()
    mover = Mover()
    mover.drive(2.0)
    t0 = time.time()
    vel = Twist()
    vel.angular.z = 1.0
    while time.time() - t0 < 1.5:
        mover.pub.publish(vel)
    mover.pub.publish(Twist())
    rclpy.spin_once(mover, timeout_sec=0.5)
    mover.get_logger().info('turned to %.1f' % mover.pose.theta)
    while rclpy.ok():
        rclpy.spin_once(mover)
        if mover.pose.theta == 0.0:
            break
        time.sleep(1)


if __name__ == '__main__':
    main()
