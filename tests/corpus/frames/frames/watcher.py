import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener
from tf_transformations import euler_from_quaternion


class Watcher(Node):
    def __init__(self):
        super().__init__('watcher')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.timer = self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        try:
            t = self.tf_buffer.lookup_transform('world', 'laser', rclpy.time.Time())
            r = t.transform.rotation
            yaw = euler_from_quaternion([r.x, r.y, r.z, r.w])[2]
            self.get_logger().info('laser at %.2f, yaw %.2f' % (t.transform.translation.x, yaw))
            past = self.get_clock().now() - Duration(seconds=0.25)
            t = self.tf_buffer.lookup_transform('world', 'base_link', past)
            self.get_logger().info('a quarter of a second ago %.2f' % t.transform.translation.x)
            now = self.get_clock().now() + Duration(seconds=0, nanoseconds=50000000)
            t = self.tf_buffer.lookup_transform('world', 'base_link', now, timeout=Duration(seconds=0.3))
        except TransformException as ex:
            self.get_logger().info(f'no transform: {ex}')


def main():
    rclpy.init()
    node = Watcher()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    rclpy.shutdown()
