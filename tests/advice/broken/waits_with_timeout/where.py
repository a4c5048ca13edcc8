import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.node import Node
from tf2_ros import Buffer, TransformBroadcaster, TransformException, TransformListener


class Where(Node):
    def __init__(self):
        super().__init__('where')
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self.send)
        self.create_timer(2.0, self.look)

    def send(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'camera'
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)

    def look(self):
        try:
            self.tf_buffer.lookup_transform('world', 'camera', self.get_clock().now(), timeout=Duration(seconds=1.0))
        except TransformException as error:
            print(error)


rclpy.init()
rclpy.spin(Where())
