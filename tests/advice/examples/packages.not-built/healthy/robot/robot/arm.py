from ament_index_python.packages import get_package_share_directory

print(get_package_share_directory('robot'))
import rclpy


def main(args=None):
    rclpy.init(args=args)
    rclpy.create_node('arm')
