import rclpy
from rclpy.node import Node
from rclpy.qos_event import SubscriptionEventCallbacks
from std_msgs.msg import UInt32

from heartbeat.sender import QOS


class Doctor(Node):

    def __init__(self):
        super().__init__('doctor')
        callbacks = SubscriptionEventCallbacks(
            deadline=self.on_deadline, liveliness=self.on_liveliness, matched=self.on_matched)
        self.sub = self.create_subscription(UInt32, 'heartbeat', self.on_beat, QOS, event_callbacks=callbacks)

    def on_beat(self, msg):
        self.get_logger().info('beat %d' % msg.data)

    def on_deadline(self, event):
        self.get_logger().warning(f'no beat in time: {event.total_count} (+{event.total_count_change})')

    def on_liveliness(self, event):
        self.get_logger().info(f'alive {event.alive_count}, not alive {event.not_alive_count}')

    def on_matched(self, event):
        self.get_logger().info(f'patients {event.current_count}')


def main():
    rclpy.init()
    rclpy.spin(Doctor())
