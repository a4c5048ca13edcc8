import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
import tf2_ros


def main():
    rclpy.init()
    node = Node('patient')
    buffer = tf2_ros.Buffer()
    # the listener spins in a thread of its own, so main may wait
    listener = tf2_ros.TransformListener(buffer, node, spin_thread=True)
    when = node.get_clock().now() + Duration(seconds=0.33)
    t = buffer.lookup_transform('world', 'base_link', when, Duration(seconds=1.0))
    node.get_logger().info('%.2f' % t.transform.translation.x)
    try:
        buffer.lookup_transform('world', 'base_lnik', rclpy.time.Time(), Duration(seconds=0.5))
    except tf2_ros.LookupException as e:
        node.get_logger().error(str(e))
    rclpy.shutdown()
