import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.node import Node
from rclpy.qos import LivelinessPolicy, QoSProfile
from std_msgs.msg import UInt32

QOS = QoSProfile(
    depth=5,
    deadline=Duration(seconds=0.6),
    liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
    liveliness_lease_duration=Duration(seconds=1.0),
)


class Sender(Node):
    """Beats five times, holds its breath, beats again, then only says that it is alive."""

    def __init__(self):
        super().__init__('sender')
        events = PublisherEventCallbacks(
            deadline=lambda e: self.get_logger().warn(f'too slow {e.total_count}'),
            liveliness=lambda e: self.get_logger().error(f'taken for dead {e.total_count}'),
            matched=lambda e: self.get_logger().info(f'{e.current_count} listeners'),
        )
        self.pub = self.create_publisher(UInt32, 'heartbeat', QOS, event_callbacks=events)
        self.count = 0
        self.create_timer(0.5, self.beat)

    def beat(self):
        self.count += 1
        if self.count <= 3 or self.count == 8:
            self.pub.publish(UInt32(data=self.count))
        elif self.count in (9, 10):
            self.pub.assert_liveliness()


def main(args=None):
    rclpy.init(args=args)
    try:
        rclpy.spin(Sender())
    except KeyboardInterrupt:
        pass
