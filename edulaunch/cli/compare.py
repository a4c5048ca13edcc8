"""`edulaunch compare`: a launch file in simulation and on the real rclpy, and what differs."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from edulaunch.cli.launch import split_words
from edulaunch.packages.discovery import workspaces_of_command

if TYPE_CHECKING:
    from edulaunch.comparing.differing import Difference
    from edulaunch.comparing.observation import Observation

EXAMPLES = """examples:
  edulaunch compare turtle_tf2_py turtle_tf2_demo.launch.py
  edulaunch compare my.launch.py background_r:=200 --for 5 --json

exit codes: 0 nothing differs, 1 something does, 2 the comparison is not possible"""
WIDEST = 60
"""Letters of a cell of the table; --json has all of them."""


def compare_arguments(parser: argparse.ArgumentParser) -> None:
    """The launch file as for `edulaunch launch`, how long, and how to say it."""
    parser.epilog = EXAMPLES
    parser.add_argument('package_or_path', metavar='PACKAGE | PATH', help='package of the launch file, or its path')
    parser.add_argument('rest', nargs='*', metavar='FILE | name:=value', help='launch file name, launch arguments')
    parser.add_argument(
        '--for', dest='seconds', type=float, default=10.0, metavar='SECONDS', help='until Ctrl-C, in both worlds (default: 10)'
    )
    parser.add_argument('--json', action='store_true', help='as plain data')
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def compare_verb(arguments: argparse.Namespace) -> int:
    """Run both, and say what differs."""
    from edulaunch.comparing.differing import differences
    from edulaunch.comparing.for_real import run_for_real
    from edulaunch.comparing.simulated import simulate
    from edulaunch.native.environment import needed

    needed()
    path, file, given = split_words(arguments.package_or_path, arguments.rest)
    workspaces = list(workspaces_of_command(arguments.workspace, path))
    simulated = simulate(path, file, given, arguments.seconds, workspaces)
    print(f'running it for real, {arguments.seconds:g} s ...', file=sys.stderr)
    real = run_for_real(path, file, given, arguments.seconds, workspaces)
    found = differences(simulated, real)
    if arguments.json:
        _print_json(found, simulated, real)
    else:
        _print_table(found)
        print(f'compared: {counts(simulated, real)}')
    return 1 if found else 0


def _print_json(found: list[Difference], simulated: Observation, real: Observation) -> None:
    import json

    sizes = {'simulated': _sizes(simulated), 'real': _sizes(real)}
    print(json.dumps({'equal': not found, 'differences': [each._asdict() for each in found], 'compared': sizes}, indent=1))


def _print_table(found: list[Difference]) -> None:
    from edulaunch.canvas.table import TextTable

    rows = [tuple(cell if len(cell) <= WIDEST else f'{cell[: WIDEST - 3]}...' for cell in each) for each in found]
    print(TextTable('differences', ('differs', 'of', 'in simulation', 'for real'), rows) if rows else 'nothing differs')


def counts(simulated: Observation, real: Observation) -> str:
    """How much there was to compare, in words; of each the number in simulation and for real."""
    here, there = _sizes(simulated), _sizes(real)
    return ', '.join(f'{what} {here[what]}/{there[what]}' for what in here)


def _sizes(seen: Observation) -> dict[str, int]:
    return {
        'nodes': len(seen.nodes),
        'endpoints': len(seen.ends),
        'parameters': sum(map(len, seen.parameters.values())),
        'topics and frames': len(seen.flows),
        'messages': sum(len(flow.times) for flow in seen.flows.values()),
        'lines': len(seen.lines),
        'programs that ended': sum(map(len, seen.codes.values())),
    }
