import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node


class Driver(Node):
    def __init__(self):
        super().__init__('driver')
        self.declare_parameter('speed', 1.0)
        self.add_on_set_parameters_callback(self.changed)
        self.create_timer(1.0, self.faster)

    def faster(self):
        self.set_parameters([rclpy.parameter.Parameter('speed', value=self.get_parameter('speed').value + 0.5)])

    def changed(self, parameters):
        self.get_logger().info(str(len(parameters)))
        return True


def main():
    rclpy.init()
    rclpy.spin(Driver())
