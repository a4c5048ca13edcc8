import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import StaticTransformBroadcaster


class Stand(Node):
    def __init__(self):
        super().__init__('stand')
        self.broadcaster = StaticTransformBroadcaster(self)
        self.height = 1.0
        self.send()
        self.create_timer(1.0, self.send)

    def send(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'lamp'
        t.transform.translation.z = self.height
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)
        self.height += 0.1


rclpy.init()
rclpy.spin(Stand())
