import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import Buffer, TransformBroadcaster, TransformException, TransformListener


class Follower(Node):
    def __init__(self):
        super().__init__('follower')
        self.broadcaster = TransformBroadcaster(self)
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.create_timer(0.1, self.send)
        self.create_timer(1.0, self.follow)

    def send(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'carrot1'
        t.transform.translation.x = 2.0
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)
        t.header.frame_id = 'world'
        t.child_frame_id = 'base'
        self.broadcaster.sendTransform(t)

    def follow(self):
        try:
            self.tf_buffer.lookup_transform('base', 'carrot1', rclpy.time.Time())
        except TransformException:
            return


rclpy.init()
rclpy.spin(Follower())
