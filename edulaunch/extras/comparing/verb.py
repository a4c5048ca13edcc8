"""`edulaunch compare`: run launch files in simulation and on the real rclpy, and list the differences."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from typing import TYPE_CHECKING

from edulaunch.desk.cli.launch import split_words
from edulaunch.engine.packages.discovery import workspaces_of_command
from edulaunch.errors import UnusableInput
from edulaunch.runtime.session import index_for

if TYPE_CHECKING:
    from collections.abc import Sequence

    from edulaunch.extras.comparing.differing import Difference
    from edulaunch.extras.comparing.known import Known
    from edulaunch.extras.comparing.observation import Observation
    from edulaunch.extras.comparing.sweep import Row

EXAMPLES = """examples:
  edulaunch compare turtle_tf2_py turtle_tf2_demo.launch.py
  edulaunch compare my.launch.py background_r:=200 --for 5 --json
  edulaunch compare src/my_package                       all launch files in a folder
  edulaunch compare demo_nodes_cpp other.launch.py --jobs 4

exit codes: 0 no differences, 1 some differences, 2 the comparison is not possible, 130 stopped by Ctrl-C"""
WIDEST = 60
"""The maximum length of a table cell; --json has everything."""


def compare_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the launch files, the duration, and the form of the output."""
    parser.epilog = EXAMPLES
    parser.add_argument('target', metavar='PACKAGE | PATH', help='package of the launch file, its path, or a folder of them')
    parser.add_argument(
        'rest', nargs='*', default=[], metavar='FILE | name:=value', help='launch file name, launch arguments; or more paths'
    )
    parser.add_argument(
        '--for',
        dest='seconds',
        type=float,
        default=10.0,
        metavar='SECONDS',
        help='press Ctrl-C after this time, in both worlds (default: 10)',
    )
    parser.add_argument('--json', action='store_true', help='print JSON')
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')
    parser.add_argument('--jobs', type=int, metavar='N', help='compare this many files at once (default: one for each processor)')
    parser.add_argument(
        '--known', metavar='FILE', help='YAML list of known differences, which do not count (file, why, kind, name ...)'
    )


def compare_verb(arguments: argparse.Namespace) -> int:
    """Run all launch files in simulation and in reality, and print the differences. Return the exit code."""
    from edulaunch.extras.comparing.known import BY_DESIGN, read_known
    from edulaunch.extras.native.environment import needed

    needed()
    known = [*(read_known(arguments.known) if arguments.known else []), *BY_DESIGN]
    items = _items(arguments)
    signal.signal(
        signal.SIGTERM, lambda *_: os.kill(os.getpid(), signal.SIGINT)
    )  # end in order, together with all started programs
    try:
        return _many(arguments, items, known) if len(items) != 1 else _one(arguments, items[0], known)
    except KeyboardInterrupt:
        print('stopped before the end of the comparison; all its programs have ended', file=sys.stderr)
        return 130


def _items(arguments: argparse.Namespace) -> list[tuple[str, ...]]:
    """Return the words of each comparison.

    :raises UnusableInput: for a folder or package without launch files.
    """
    from edulaunch.extras.comparing.sweep import launch_files

    target, rest = arguments.target, arguments.rest
    paths = [word for word in (target, *rest) if ':=' not in word]
    given = tuple(word for word in rest if ':=' in word)
    if len(paths) == 1 and not os.path.exists(target):
        paths = [index_for(workspaces_of_command(arguments.workspace, target)).share(target) or target]
    if not all(map(os.path.exists, paths)):
        return [(target, *rest)]
    found = [file for path in paths for file in (launch_files(path) if os.path.isdir(path) else (path,))]
    if not found:
        raise UnusableInput(f'there are no launch files in {target!r}.', help='name a launch file, or a folder with launch files')
    return [(path, *given) for path in found]


def _one(arguments: argparse.Namespace, words: Sequence[str], known: Sequence[Known]) -> int:
    from edulaunch.extras.comparing.known import reason, split
    from edulaunch.extras.comparing.pair import compare

    path, file, given = split_words(words[0], list(words[1:]))
    workspaces = list(workspaces_of_command(arguments.workspace, path))
    print(
        f'{" ".join(words)}: running in simulation, then on real rclpy, for at least {arguments.seconds:g} s ...', file=sys.stderr
    )
    found, slow, chance, not_up, simulated, real = compare(
        path, file, given, arguments.seconds, workspaces, lambda each: reason(known, words, each) is not None
    )
    found, explained = split(known, words, found)
    if arguments.json:
        _print_json(found, slow, explained, simulated, real)
    else:
        print(report(found, slow, explained, chance, not_up))
        print(f'Compared, in simulation/for real: {counts(simulated, real)}.')
    return 1 if found else 0


def _many(arguments: argparse.Namespace, items: Sequence[Sequence[str]], known: Sequence[Known]) -> int:
    from edulaunch.extras.comparing.sweep import gone, sweep

    jobs = arguments.jobs or os.cpu_count() or 1
    print(f'{len(items)} launch files, {jobs} at a time ...', file=sys.stderr)
    options = [f'--workspace={folder}' for folder in arguments.workspace]
    options += [f'--known={arguments.known}'] if arguments.known else []
    rows = sweep(items, arguments.seconds, jobs, options, progress=lambda row: print(row_line(row), file=sys.stderr))
    if arguments.json:
        _print_rows_as_json(rows)
    else:
        print(table(rows))
    for each in gone(known, rows):
        print(f'a known difference did not occur: {each.file}: {each.why}', file=sys.stderr)
    return 0 if all(row.is_well for row in rows) else 1


def row_line(row: Row) -> str:
    """Return the line that summarizes one comparison."""
    return f'{row.verdict}: {" ".join(row.words)}'


def table(rows: Sequence[Row]) -> str:
    """Return a table of all differences, and the number of launch files with each verdict."""
    from edulaunch.canvas.table import TextTable

    lines: list[tuple[str, ...]] = []
    for row in rows:
        name = ' '.join(row.words)
        lines += [(name, row.problem, '', '', '')] if row.problem else []
        lines += [(name, *each[:4]) for each in row.found]
        lines += [(name, 'known', each.why, '', '') for each in row.known]
    verdicts = [row.verdict for row in rows]
    counts = ', '.join(f'{verdicts.count(each)} {each}' for each in dict.fromkeys(sorted(verdicts)))
    heads = ('launch file', 'differs', 'of', 'in simulation', 'for real')
    return '\n'.join([*([str(TextTable('differences', heads, _narrow(lines)))] if lines else []), f'of {len(rows)}: {counts}'])


def _print_rows_as_json(rows: Sequence[Row]) -> None:
    import json

    row_line = [
        {
            'launch': ' '.join(row.words),
            'verdict': row.verdict,
            'differences': [each._asdict() for each in row.found],
            'known': [each.why for each in row.known],
            'trouble': row.problem,
        }
        for row in rows
    ]
    print(json.dumps(row_line, indent=1))


def _narrow(rows: Sequence[tuple[str, ...]]) -> list[tuple[str, ...]]:
    return [tuple(cell if len(cell) <= WIDEST else f'{cell[: WIDEST - 3]}...' for cell in row) for row in rows]


def _subjects(found: Sequence[Difference]) -> str:
    """Return the subjects of differences, without their states."""
    return ', '.join(dict.fromkeys(f'{each.kind} {each.name}' for each in found))


def _print_json(
    found: Sequence[Difference], slow: Sequence[Difference], explained: Sequence[Known], simulated: Observation, real: Observation
) -> None:
    import json

    sizes = {'simulated': _sizes(simulated), 'real': _sizes(real)}
    rows = {
        'differences': [each._asdict() for each in found],
        'by_speed': [each._asdict() for each in slow],
        'known': [each._asdict() for each in explained],
    }
    print(json.dumps({'equal': not found, **rows, 'compared': sizes}, indent=1))


def report(
    found: Sequence[Difference],
    slow: Sequence[Difference],
    explained: Sequence[Known],
    chance: Sequence[Difference],
    not_up: set[str],
) -> str:
    """Return the lines on one comparison: the outcome, the differences, and the ignored differences with reasons."""
    from edulaunch.canvas.table import TextTable

    lines = ['The real run does not differ from the simulation.']
    if found:
        heads = ('differs', 'of', 'in simulation', 'for real')
        things = '1 thing' if len(found) == 1 else f'{len(found)} things'
        lines = [
            f'The real run differs from the simulation in {things}:',
            str(TextTable('differences', heads, _narrow([each[:4] for each in found]))),
        ]
    if slow:
        lines.append('These differences depend on the speed of this computer, and do not count:')
        lines += [f'  {kind} {name}: {here} in simulation, {there} for real' for kind, name, here, there, _ in slow]
    if explained:
        lines += ['These differences are known:', *(f'  {each.why}' for each in explained)]
    if chance:
        lines.append(f'These also differ between simulations with other random numbers: {_subjects(chance)}.')
    lines += [f'{name} was stopped before it had started: its output and exit code do not count.' for name in sorted(not_up)]
    return '\n'.join(lines)


def counts(simulated: Observation, real: Observation) -> str:
    """Return how many items were compared. Each count has the number in simulation and the number in reality."""
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
