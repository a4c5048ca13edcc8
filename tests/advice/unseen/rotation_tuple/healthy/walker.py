import rclpy
from rclpy.node import Node
from geometry_msgs.msg import Quaternion, TransformStamped
from tf2_ros import TransformBroadcaster


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.broadcaster = TransformBroadcaster(self)
        self.timer = self.create_timer(0.1, self.send)

    def send(self):
        message = TransformStamped()
        message.header.stamp = self.get_clock().now().to_msg()
        message.header.frame_id = 'world'
        message.child_frame_id = 'camera'
        message.transform.rotation = Quaternion(x=0.0, y=0.0, z=0.0, w=1.0)
        self.broadcaster.sendTransform(message)


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()
