import rclpy
from rclpy.node import Node
from geometry_msgs.msg import TransformStamped
from tf2_ros import TransformBroadcaster, StaticTransformBroadcaster, Buffer, TransformListener, TransformException
from rclpy.time import Time


class Mine(Node):
    def __init__(self):
        super().__init__('cart_broadcaster')
        self.broadcaster = TransformBroadcaster(self)
        self.create_timer(0.1, self.tick)

    def tick(self):
        t = TransformStamped()
        t.header.stamp = self.get_clock().now().to_msg()
        t.header.frame_id = 'world'
        t.child_frame_id = 'cart'
        t.transform.translation.x = 1.0
        self.broadcaster.sendTransform(t)

def main():
    rclpy.init()
    node = Mine()
    rclpy.spin(node)


main()
