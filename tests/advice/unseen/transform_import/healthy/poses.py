import rclpy
import tf2_geometry_msgs
from geometry_msgs.msg import PoseStamped
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener


class Poses(Node):
    def __init__(self):
        super().__init__('poses')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.create_timer(1.0, self.tell)

    def tell(self):
        pose = PoseStamped()
        pose.header.frame_id = 'base'
        try:
            self.get_logger().info(f'x {self.buffer.transform(pose, "map").pose.position.x}')
        except TransformException as error:
            self.get_logger().info(str(error))


def main():
    rclpy.init()
    node = Poses()
    rclpy.spin(node)
    rclpy.shutdown()


if __name__ == '__main__':
    main()
