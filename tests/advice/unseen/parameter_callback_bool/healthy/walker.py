import rclpy
from rclpy.node import Node
from rcl_interfaces.msg import SetParametersResult
from rclpy.parameter import Parameter


class Walker(Node):
    def __init__(self):
        super().__init__('walker')
        self.declare_parameter('speed', 0.2)
        self.add_on_set_parameters_callback(self.changed)
        self.timer = self.create_timer(1.0, self.faster)

    def changed(self, parameters):
        return SetParametersResult(successful=True)

    def faster(self):
        self.set_parameters([Parameter('speed', value=0.4)])


def main():
    rclpy.init()
    rclpy.spin(Walker())


if __name__ == '__main__':
    main()
