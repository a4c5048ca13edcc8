from importlib.metadata import version

print(version('robot'))
import rclpy


def main(args=None):
    rclpy.init(args=args)
    rclpy.create_node('arm')
