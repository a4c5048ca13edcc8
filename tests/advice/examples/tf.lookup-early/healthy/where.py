import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.create_timer(1.0, self.look)

    def look(self):
        try:
            t = self.tf_buffer.lookup_transform('world', 'camera', rclpy.time.Time())
        except TransformException:
            return
        self.get_logger().info(f'the camera is at {t.transform.translation.x}')


rclpy.init()
rclpy.spin(Where())
