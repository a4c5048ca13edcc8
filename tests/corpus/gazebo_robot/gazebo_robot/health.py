import diagnostic_updater
import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('health')
    updater = diagnostic_updater.Updater(node)
    rclpy.spin(node)
