import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from turtlesim.msg import Pose


class Square(Node):
    def __init__(self):
        super().__init__('square')
        self.publisher = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.on_pose, 10)
        self.create_timer(0.1, self.step)
        self.pose = None
        self.steps = 0

    def on_pose(self, msg):
        self.pose = msg

    def step(self):
        if self.pose is None:
            return
        self.steps += 1
        msg = Twist()
        if self.steps % 20 < 10:
            msg.linear.x = 1.0
        else:
            msg.angular.z = 1.57
        self.publisher.publish(msg)


rclpy.init()
rclpy.spin(Square())
