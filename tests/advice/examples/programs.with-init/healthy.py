import rclpy

rclpy.init()
