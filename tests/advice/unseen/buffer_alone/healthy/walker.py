import rclpy
from rclpy.node import Node
import rclpy.time
from tf2_ros import Buffer, TransformException, TransformListener


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(1.0, self.look)

    def look(self):
        try:
            t = self.buffer.lookup_transform('world', 'turtle1', rclpy.time.Time())
        except TransformException as error:
            self.get_logger().warn(str(error))
            return
        self.get_logger().info(f'x is {t.transform.translation.x:.1f}')


def main():
    rclpy.init()
    node = Walker()
    rclpy.spin(node)
    rclpy.shutdown()


main()
