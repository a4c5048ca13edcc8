from cv_bridge import CvBridge
import cv2
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Image


class Eye(Node):
    def __init__(self):
        super().__init__('eye')
        self.bridge = CvBridge()
        self.create_subscription(Image, 'image_raw', self.on_image, 10)

    def on_image(self, msg):
        cv2.imshow('eye', self.bridge.imgmsg_to_cv2(msg, 'bgr8'))


def main():
    rclpy.init()
    rclpy.spin(Eye())
