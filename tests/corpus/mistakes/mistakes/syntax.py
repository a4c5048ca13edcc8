import rclpy

def main()
    rclpy.init()
