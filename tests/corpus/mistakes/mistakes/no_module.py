import rclpy
import cv2


def main():
    rclpy.init()
