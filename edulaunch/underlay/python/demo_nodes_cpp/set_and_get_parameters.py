"""The program set_and_get_parameters: sets its parameters, reads them back and says so."""

from __future__ import annotations

import sys
from typing import Any

from rclcpp_like import run_program

from demo_nodes_cpp._four_parameters import VALUES, make_node

TYPE_NAMES = {int: 'integer', str: 'string', float: 'double', bool: 'bool'}


def work() -> None:
    """Read back, say it, and end."""
    node = make_node('set_and_get_parameters')
    lines = [_described(name, node.get_parameter(name).value) for name in VALUES]
    node.get_logger().info(''.join(lines))


def _described(name: str, value: Any) -> str:
    text = str(value)
    if isinstance(value, float):
        text = f'{value:f}'
    elif isinstance(value, bool):
        text = text.lower()
    return f'\nParameter name: {name}\nParameter value ({TYPE_NAMES[type(value)]}): {text}'


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(work))


if __name__ == '__main__':
    main()
