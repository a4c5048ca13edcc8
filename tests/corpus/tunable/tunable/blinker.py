import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult


class Blinker(Node):
    def __init__(self):
        super().__init__('blinker')
        self.declare_parameter('word', 'blink')
        self.declare_parameter('period', 1.0, ParameterDescriptor(
            description='seconds between two blinks',
            floating_point_range=[FloatingPointRange(from_value=0.1, to_value=5.0, step=0.0)]))
        self.declare_parameters(namespace='led', parameters=[('color', 'red'), ('number', 3), ('on', True)])
        self.period = self.get_parameter('period').get_parameter_value().double_value
        self.add_on_set_parameters_callback(self.parameters_callback)
        self.add_post_set_parameters_callback(self.after)
        self.timer = self.create_timer(self.period, self.blink)

    def parameters_callback(self, params):
        for param in params:
            if param.name == 'word' and param.type_ == Parameter.Type.STRING and param.value == 'forbidden':
                return SetParametersResult(successful=False, reason='bad word')
            if param.name == 'period':
                self.period = param.value
        return SetParametersResult(successful=True)

    def after(self, params):
        for param in params:
            self.get_logger().info('now %s is %r' % (param.name, param.value))
            if param.name == 'period':
                self.timer.cancel()
                self.timer = self.create_timer(self.period, self.blink)

    def blink(self):
        self.get_logger().info(self.get_parameter('word').value)
        if self.get_parameter('led.number').value > 0:
            n = self.get_parameter('led.number').value - 1
            self.set_parameters([Parameter('led.number', Parameter.Type.INTEGER, n)])


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Blinker())
