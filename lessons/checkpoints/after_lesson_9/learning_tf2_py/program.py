"""Start ROS, let a node work, stop ROS: every program of this package does this."""
import rclpy
from rclpy.executors import ExternalShutdownException


def run(make_node):
    """Spin the node that `make_node()` returns until the user presses Ctrl-C."""
    rclpy.init()
    try:
        rclpy.spin(make_node())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()
