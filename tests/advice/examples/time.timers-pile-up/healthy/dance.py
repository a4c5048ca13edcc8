import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose


class Dance(Node):
    def __init__(self):
        super().__init__('dance')
        self.turn = 1.0
        self.pub = self.create_publisher(Twist, '/turtle1/cmd_vel', 10)
        self.create_subscription(Pose, '/turtle1/pose', self.listen, 10)
        self.timer = self.create_timer(0.5, self.move)

    def listen(self, msg):
        self.turn = 1.0 if msg.x < 5.6 else -1.0
        

    def move(self):
        t = Twist()
        t.angular.z = self.turn
        self.pub.publish(t)


def main(args=None):
    rclpy.init(args=args)
    node = Dance()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
