import rclpy
from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class CountingExecutor(Executor):
    """Counts what it executes."""

    def __init__(self):
        super().__init__()
        self.executed = 0

    def spin_once(self, timeout_sec=None):
        try:
            handler, entity, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except StopIteration:
            pass
        else:
            self.executed += 1
            handler()
            if handler.exception() is not None:
                raise handler.exception()


class Estop(Node):
    def __init__(self):
        super().__init__('estop')
        self.sub = self.create_subscription(String, 'chatter', self.heard, 10)
        self.pub = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.5, self.say)
        self.n = 0

    def say(self):
        self.n += 1
        self.pub.publish(String(data='message %d' % self.n))

    def heard(self, msg):
        self.get_logger().info(msg.data)
        if self.n == 3:
            raise ValueError('three is too much')


def main():
    rclpy.init()
    executor = CountingExecutor()
    node = Estop()
    executor.add_node(node)
    try:
        executor.spin()
    except ValueError as e:
        print(e, 'after', executor.executed)
    with SingleThreadedExecutor() as second:
        second.add_node(node)
        while node.n < 5:
            second.spin_once(timeout_sec=0.2)
            print('turn', node.n)
    rclpy.shutdown()
