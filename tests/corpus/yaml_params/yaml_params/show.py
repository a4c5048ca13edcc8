import rclpy
from rclpy.node import Node


class Show(Node):
    def __init__(self):
        super().__init__('show', allow_undeclared_parameters=True,
                         automatically_declare_parameters_from_overrides=True)
        for name in sorted(self.get_parameters_by_prefix('')):
            if name in ('use_sim_time', 'start_type_description_service'):
                continue
            value = self.get_parameter(name).value
            print(self.get_fully_qualified_name(), name, repr(value))
        self.default = self.get_parameter_or('missing').value
        print('missing:', self.default)


def main(args=None):
    rclpy.init(args=args)
    Show()
