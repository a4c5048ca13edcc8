import numpy as np
import rclpy
from geometry_msgs.msg import Point
from nav_msgs.msg import Odometry
from rclpy.node import Node
from std_msgs.msg import Float32, Float64, Float64MultiArray


class Filter(Node):
    def __init__(self):
        super().__init__('filter')
        self.x = np.zeros(2)
        self.P = np.eye(2)
        self.pub = self.create_publisher(Float64MultiArray, 'state', 10)
        self.odom = self.create_publisher(Odometry, 'odom', 10)
        self.point = self.create_publisher(Point, 'point', 10)
        self.sub = self.create_subscription(Float64, 'measured', self.update, 10)

    def update(self, msg):
        dt = 0.1
        F = np.array([[1, dt], [0, 1]])
        H = np.array([[1.0, 0.0]])
        self.x = F.dot(self.x)
        self.P = F @ self.P @ F.T + 0.01 * np.eye(2)
        K = self.P @ H.T @ np.linalg.inv(H @ self.P @ H.T + 0.1)
        self.x = self.x + K[:, 0] * (msg.data - self.x[0])
        self.P = (np.eye(2) - K @ H) @ self.P
        out = Float64MultiArray()
        out.data = self.x.tolist()
        self.pub.publish(out)
        odom = Odometry()
        odom.pose.pose.position.x = self.x[0]
        odom.pose.covariance = np.diag([0.5] * 6).flatten()
        self.odom.publish(odom)
        self.point.publish(Point(x=self.x[0], y=float(np.hypot(3, 4))))
        self.get_logger().info('%s' % np.round(self.x, 3))
        if msg.data > 0.35:
            self.point.publish(Point(x=np.float32(1.5)))


def main():
    rclpy.init()
    rclpy.spin(Filter())
