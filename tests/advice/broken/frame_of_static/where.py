import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.create_timer(1.0, self.look)

    def look(self):
        if self.tf_buffer.can_transform('world', 'camera_link', rclpy.time.Time()):
            print('there')


rclpy.init()
rclpy.spin(Where())
