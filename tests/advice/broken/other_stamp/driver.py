import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster


class Carrot(Node):
    def __init__(self):
        super().__init__('carrot')
        self.broadcaster = TransformBroadcaster(self)
        self.count = 0
        self.create_timer(0.1, self.send)

    def send(self):
        self.count += 1
        t = TransformStamped()
        t.header.stamp.sec = self.count
        t.header.frame_id = 'turtle1'
        t.child_frame_id = 'carrot1'
        t.transform.translation.x = 2.0
        t.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(t)


rclpy.init()
rclpy.spin(Carrot())
