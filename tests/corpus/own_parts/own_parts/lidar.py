import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode, State, TransitionCallbackReturn
from sensor_msgs.msg import LaserScan


class Lidar(LifecycleNode):
    def __init__(self, **kwargs):
        self.pub = None
        super().__init__('lidar', **kwargs)
        self.declare_parameter('port', '')
        self.declare_parameter('rpm', 0)

    def on_configure(self, state: State) -> TransitionCallbackReturn:
        self.get_logger().info(f"{state.label}, port {self.get_parameter('port').value}, {self.get_parameter('rpm').value} rpm")
        if 'S1' in self.get_parameter('port').value:
            self.get_logger().error('no device')
            return TransitionCallbackReturn.FAILURE
        self.pub = self.create_lifecycle_publisher(LaserScan, '~/scan', 10)
        self.timer = self.create_timer(0.5, self.scan)
        return TransitionCallbackReturn.SUCCESS

    def scan(self):
        if not self.pub.is_activated:
            self.get_logger().info('not active yet', once=True)
            return
        self.pub.publish(LaserScan(ranges=[1.0, 2.0]))
        self.get_logger().info('scanned', throttle_duration_sec=1.0)


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    node = Lidar()
    executor.add_node(node)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        node.destroy_node()
