"""What every program of this package does: start ROS, let a node work, stop ROS."""
import rclpy
from rclpy.executors import ExternalShutdownException


def run(make_node):
    """Let the node that `make_node()` makes work until somebody presses Ctrl-C."""
    rclpy.init()
    try:
        rclpy.spin(make_node())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
