"""The program set_parameters_callback: the three moments at which a node has its say on a new value."""

from __future__ import annotations

from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.parameter import Parameter

from demo_nodes_py._running import spin


class SetParametersCallback(Node):
    """Setting param1 sets param2 to 4.0 too (before); neither may be negative (on); both are kept (after)."""

    def __init__(self) -> None:
        super().__init__('set_parameters_callback')
        self.remembered = {name: self.declare_parameter(name, 0.0).value for name in ('param1', 'param2')}
        self.add_pre_set_parameters_callback(self._before)
        self.add_on_set_parameters_callback(self._check)
        self.add_post_set_parameters_callback(self._after)

    def _before(self, parameters: list[Parameter]) -> list[Parameter]:
        if any(parameter.name == 'param1' for parameter in parameters):
            return [*parameters, Parameter('param2', Parameter.Type.DOUBLE, 4.0)]
        return parameters

    def _check(self, parameters: list[Parameter]) -> SetParametersResult:
        for parameter in parameters:
            if parameter.name in self.remembered and not parameter.value >= 0.0:
                return SetParametersResult(successful=False, reason=f'{parameter.name} must not be negative')
        return SetParametersResult(successful=True)

    def _after(self, parameters: list[Parameter]) -> None:
        for parameter in parameters:
            if parameter.name in self.remembered:
                self.remembered[parameter.name] = parameter.value
                self.get_logger().info(f'{parameter.name} is now {parameter.value}')


def main() -> None:
    """Run the program until Ctrl-C or a shutdown."""
    spin(SetParametersCallback)


if __name__ == '__main__':
    main()
