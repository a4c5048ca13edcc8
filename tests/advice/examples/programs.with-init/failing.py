import rclpy

with rclpy.init():
    pass
