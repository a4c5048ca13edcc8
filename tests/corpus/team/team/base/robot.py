from rclpy.node import Node


class Robot(Node):
    counter = 0

    def __init__(self, name, **kwargs):
        super().__init__(name, **kwargs)
        Robot.counter += 1
        self.declare_parameter('greeting', 'hi')

    def greet(self):
        self.get_logger().info('%s from %d' % (self.get_parameter('greeting').value, Robot.counter))
