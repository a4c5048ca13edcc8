import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener


class Look(Node):
    def __init__(self):
        super().__init__('look')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(0.5, self.tick)

    def tick(self):
        try:
            t = self.buffer.lookup_transform('world', 'turtle1', rclpy.time.Time())
        except Exception:
            return
        self.get_logger().info('x = %.2f' % t.transform.translation.x)


def main(args=None):
    rclpy.init(args=args)
    node = Look()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
