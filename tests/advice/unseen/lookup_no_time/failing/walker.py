import rclpy
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.timer = self.create_timer(0.5, self.look)

    def look(self):
        if self.buffer.can_transform('world', 'turtle1', Time()):
            found = self.buffer.lookup_transform('world', 'turtle1')
            self.get_logger().info(f'{found.transform.translation.x:.1f}')


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()
