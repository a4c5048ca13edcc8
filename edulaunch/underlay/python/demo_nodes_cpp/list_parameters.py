"""The program list_parameters: says which of its parameters lie under given prefixes."""

from __future__ import annotations

import sys

from rclcpp_like import run_program

from demo_nodes_cpp._four_parameters import VALUES, make_node


def work() -> None:
    """List, say it, and end."""
    node = make_node('list_parameters')
    log = node.get_logger()
    log.info('Listing parameters...')
    found = node.list_parameters([*VALUES], 10)
    names, prefixes = (''.join(f'\n {name}' for name in group) for group in (found.names, found.prefixes))
    log.info(f'\nParameter names:{names}\nParameter prefixes:{prefixes}')


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(work))


if __name__ == '__main__':
    main()
