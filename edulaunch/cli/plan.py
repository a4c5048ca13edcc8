"""`edulaunch plan`: what a launch file would start, without starting anything."""
from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Iterator
from typing import Any

from edulaunch.cli.launch import split_words
from edulaunch.launching import find_launch_file
from edulaunch.plan import make_plan
from edulaunch.session import Session

PHASES = {'on_start': 'when a process has started', 'on_exit': 'when a process has ended', 'on_shutdown': 'at shutdown'}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The launch file as for `edulaunch launch`, and how to show the plan."""
    parser.add_argument('package_or_path', metavar='PACKAGE | PATH', help='package of the launch file, or its path')
    parser.add_argument('rest', nargs='*', metavar='FILE | name:=value', help='launch file name, launch arguments')
    parser.add_argument('--json', action='store_true', help='as JSON (plan format 1)')
    parser.add_argument('--assume-packages', action='store_true', help='pretend that missing packages are there')
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def main(arguments: argparse.Namespace) -> int:
    """Print the plan. 0 when the launch file can be visited, 1 when it fails, 2 for unusable input."""
    package_or_path, file, given = split_words(arguments.package_or_path, arguments.rest)
    with Session(workspaces=arguments.workspace) as session:
        path = find_launch_file(session.index, package_or_path, file)
        plan = make_plan(path, given, session.index, session.host.env, assume_packages=arguments.assume_packages)
    if arguments.json:
        import json
        print(json.dumps(plan, indent=1, sort_keys=True))
    else:
        print('\n'.join(lines(plan)))
    error = plan['error']
    if error is not None and not arguments.json:
        place = f'\n  at {error["origin"]}' if error.get('origin') else ''
        help = f'\n  help: {error["help"]}' if error.get('help') else ''
        print(f'error: {error["text"]}{place}{help}', file=sys.stderr)
    return 0 if error is None else 1


def lines(plan: dict[str, Any]) -> Iterator[str]:
    """The plan for people, one line after the other; indented under what an item belongs to."""
    yield f'{plan["file"]}'
    for argument in plan['arguments']:
        default = 'required' if argument['default'] is None else f'default {argument["default"]}'
        value = plan['configurations'].get(argument['name'])
        yield f'  argument {argument["name"]} = {value!r} ({default})'
    for item in plan['items']:
        yield from _item_lines(item, '  ')
    if not plan['items'] and plan['error'] is None:
        yield '  starts nothing'


def _item_lines(item: dict[str, Any], indent: str) -> Iterator[str]:
    when = f' (after {item["time"]:g} s)' if 'time' in item else f' ({PHASES[item["phase"]]})' if item['phase'] in PHASES else ''
    if item['kind'] == 'node':
        name = item['runtime_name'] or "(the program's own name)"
        yield f'{indent}node {name}: {item["package"] or ""} {item["executable"]}{when}'.replace(':  ', ': ')
        yield from (f'{indent}    parameter {key} = {value!r}' for key, value in item['parameters'].items())
        yield from (f'{indent}    remap {old} -> {new}' for old, new in item['remappings'])
        if item['arguments']:
            yield f'{indent}    arguments {" ".join(item["arguments"])}'
    elif item['kind'] == 'process':
        yield f'{indent}process {" ".join(item["cmd"])}{when}'
    elif item['kind'] == 'include':
        yield f'{indent}include {os.path.basename(item["file"])}{when}'
    elif item['kind'] == 'log':
        yield f'{indent}log {item["msg"]}{when}'
    elif item['kind'] == 'timer':
        yield f'{indent}timer: {item["number_of_actions"]} actions after {item["period"]} s{when}'
    elif item['kind'] != 'argument':
        details = ', '.join(f'{key} {value}' for key, value in item.items() if key not in ('kind', 'phase', 'time', 'index'))
        yield f'{indent}{item["kind"].replace("_", " ")} {details}{when}'
