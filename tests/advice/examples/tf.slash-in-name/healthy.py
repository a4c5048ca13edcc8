import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster


class Broadcaster(Node):
    def __init__(self):
        super().__init__('broadcaster')
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self.send)

    def send(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'carrot1'
        t.transform.translation.x = 2.0
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)


rclpy.init()
rclpy.spin(Broadcaster())
