"""The program parameter_blackboard: a node that keeps any parameter it is given."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from rclcpp_like import CppNode, run_program


class ParameterBlackboard(CppNode):
    """Takes undeclared parameters, and those of the command line, as declared."""

    def __init__(self, **options: Any) -> None:
        super().__init__(
            'parameter_blackboard',
            allow_undeclared_parameters=True,
            automatically_declare_parameters_from_overrides=True,
            **options,
        )
        count = len(self.list_parameters([], 0).names)
        self.get_logger().info(
            f"Parameter blackboard node named '{self.get_fully_qualified_name()}' ready, "
            f"and serving '{count}' parameters already!"
        )


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(lambda: rclpy.spin(ParameterBlackboard())))


if __name__ == '__main__':
    main()
