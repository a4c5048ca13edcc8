import rclpy
from rclpy.node import Node
from tf2_ros import Buffer, TransformListener


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        t = self.tf_buffer.lookup_transform('world', 'camera', rclpy.time.Time())
        print(t.transform.translation.x)


rclpy.init()
rclpy.spin(Where())
