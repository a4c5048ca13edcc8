import rclpy
from rclpy.node import Node
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster, StaticTransformBroadcaster, Buffer, TransformListener, TransformException
from rclpy.time import Time


class Mine(Node):
    def __init__(self):
        super().__init__('watcher')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(0.5, self.tick)

    def tick(self):
        try:
            t = self.buffer.lookup_transform('world', 'cart', self.get_clock().now())
            self.get_logger().info(str(t.transform.translation.x))
        except TransformException as error:
            self.get_logger().info(str(error))

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()
