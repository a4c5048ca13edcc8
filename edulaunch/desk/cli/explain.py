"""`edulaunch explain`: show what a launch file would start and where each value comes from, or explain a rule of advice.

The command starts no program. `edulaunch plan --json` prints the plan of a launch file for other programs.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import shlex
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.desk.cli.explain_rule import explain_rule, is_rule
from edulaunch.desk.cli.launch import split_words
from edulaunch.engine.recording.views import view
from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.advice.explaining.explained import Explanation, Tree
    from edulaunch.advice.explaining.systems import System
    from edulaunch.engine.recording import Recording

EXAMPLES = """examples:
  edulaunch explain turtlesim multisim.launch.py
  edulaunch explain my.launch.py background_r:=200             with an argument, as for `ros2 launch`
  edulaunch explain my.launch.py /sim background_g             why this parameter has this value
  edulaunch explain my.launch.py background_r                  why this launch argument has this value
  edulaunch explain tf.unknown-frame                           a rule of advice: cause, example and fix
  edulaunch explain my.launch.py --graph plan.png              a picture of the planned nodes, topics and frames
  edulaunch explain --diff my.launch.py other.launch.py        what differs between two launch files
  edulaunch explain --diff my.launch.py gui:=true gui:=false   ... between two sets of arguments ("a:=1 b:=2" for several)"""


def explain_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments for the launch file, and for the node, parameter or launch argument to explain."""
    parser.epilog = EXAMPLES
    parser.add_argument('package_or_path', metavar='PACKAGE | PATH | RULE', help='package of the launch file, or its path')
    parser.add_argument(
        'rest',
        nargs='*',
        default=[],
        metavar='FILE | name:=value | NODE PARAMETER | ARGUMENT',
        help='launch file name, launch arguments, and the node, parameter or argument to explain (default: everything)',
    )
    parser.add_argument('--diff', action='store_true', help='compare two launch files, or two sets of arguments of one file')
    parser.add_argument(
        '--graph', metavar='OUT', help='write the planned nodes, topics and frames as a picture (.png) or page (.html)'
    )
    parser.add_argument('--run', metavar='RECORDING', help='an earlier run, from which --graph takes the endpoints of nodes')
    parser.add_argument('--services', action='store_true', help='show services with clients in --graph, too')
    parser.add_argument('--json', action='store_true', help='print JSON')
    parser.add_argument('--assume-packages', action='store_true', help='replace missing packages by empty ones, and list them')
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def explain_verb(arguments: argparse.Namespace) -> int:
    """Print the explanation. Return 0 if launch can visit the file, 1 if the launch file fails, and 2 for invalid input."""
    if is_rule(arguments.package_or_path):
        return explain_rule(arguments.package_or_path)
    gc.disable()  # collecting garbage takes longer than drawing the tree, and this process ends soon
    if arguments.diff:
        return _compare(arguments)
    explanation, subject = explained(arguments)
    if subject:
        _print(explanation.why(*subject), arguments)
        return 0
    if arguments.graph:
        write_graph([explanation.system(_earlier(arguments))], arguments.graph, arguments.services)
        gc.collect()  # some nodes ran for a moment, and their objects must be deleted before Python ends
        return report(explanation)
    _print(explanation, arguments)
    if not arguments.json:
        data = explanation.data
        reason = data['shutdown_reason'] or 'none'
        print(f'nodes: {data["nodes"]}, other processes: {data["processes"]}, reason for the shutdown: {reason}')
    return report(explanation)


def _earlier(arguments: argparse.Namespace) -> Recording | None:
    from edulaunch.engine.recording import Recording

    return Recording.load(arguments.run) if arguments.run else None


def write_graph(systems: list[System], path: str, services: bool = False) -> None:
    """Write one system, or the differences of two systems, as a picture or page. Also print their text and the path.

    :param systems: one system, or the two systems to compare.
    :param path: the path of the new file, which ends with .png or .html.
    :param services: whether to draw services, too.
    :raises UnusableInput: when the path has another ending, or the file cannot be written.
    """
    from edulaunch.advice.explaining.systems import differences, pictured
    from edulaunch.desk.view.compared import compared_page
    from edulaunch.desk.view.planned import planned_page

    if not path.endswith(('.png', '.html')):
        raise UnusableInput(f'--graph cannot write {path}.', help='name a file that ends with .png or .html')
    if len(systems) == 2:
        found = [f'{one.sign} {one.text}' for one in differences(*systems)]
        print('\n'.join(found) or 'no difference in nodes, topics, parameters and frames')
        picture = pictured(systems[0], systems[1], services=services)
    else:
        print('\n'.join(systems[0].lines()))
        picture = view('plot_system')(systems[0], services=services)
    try:
        if path.endswith('.png'):
            picture.save(path)
        else:
            with open(path, 'w', encoding='utf-8') as file:
                if len(systems) == 2:
                    file.write(compared_page(systems[0].title, systems[1].title, found, picture))
                else:
                    file.write(planned_page(systems[0]))
    except OSError as error:
        raise UnusableInput(f'cannot write {path}: {error.strerror}') from None
    print(path)


def explained(arguments: argparse.Namespace) -> tuple[Explanation, list[str]]:
    """Return the explanation of a launch file, and the words that name the node, parameter or launch argument to show."""
    first, file, words, subject = _words(arguments.package_or_path, arguments.rest)
    return _explained(first, file, words, arguments), subject


def _explained(first: str, file: str | None, given: dict[str, str], arguments: argparse.Namespace) -> Explanation:
    from edulaunch.advice.explaining import explain

    assume = arguments.assume_packages
    return explain(first, file, arguments=given, workspaces=arguments.workspace, assume_packages=assume)


def _words(first: str, rest: Sequence[str]) -> tuple[str, str | None, dict[str, str], list[str]]:
    """Split the words of the command line.

    :return: the package or path, the file name after a package (or None), the launch arguments, and the subject. The subject is
        the words that name the node, parameter or launch argument to explain.
    """
    words = [word for word in rest if ':=' in word]
    names = [word for word in rest if ':=' not in word]
    file = names.pop(0) if names and not os.path.isfile(first) and not _is_path(first) else None
    if len(names) > 2 or any('=' in name for name in names):
        split_words(first, list(rest))  # if a word is misspelt, this raises an error that names it
        raise UnusableInput(f'too many words: {" ".join(names)}.', help='name a node and a parameter, or a launch argument')
    return first, file, split_words(first, words)[2], names


def _is_path(word: str) -> bool:
    return os.sep in word or word.endswith(('.py', '.xml', '.yaml', '.yml', '.launch'))


def _compare(arguments: argparse.Namespace) -> int:
    files = [arguments.package_or_path, *(word for word in arguments.rest if ':=' not in word)]
    sets = [shlex.split(word) for word in arguments.rest if ':=' in word]
    is_package = not (os.path.isfile(files[0]) or _is_path(files[0]))
    named = [(files[0], file) for file in files[1:]] if is_package else [(file, None) for file in files]
    if len(named) == 2:
        both = [word for words in sets for word in words]
        cases = [(*name, both) for name in named]
    elif len(named) == 1 and 1 <= len(sets) <= 2:
        cases = [(*named[0], words) for words in ([[], *sets] if len(sets) == 1 else sets)]
    else:
        raise UnusableInput(
            '--diff compares two launch files, or one launch file with two sets of arguments.',
            help='write --diff A.launch.py B.launch.py, or --diff A.launch.py name:=1 name:=2',
        )
    before, after = (_explained(first, file, split_words(first, words)[2], arguments) for first, file, words in cases)
    _print(before.compare(after), arguments)
    if arguments.graph:
        earlier = _earlier(arguments)
        write_graph([before.system(earlier), after.system(earlier)], arguments.graph, arguments.services)
        gc.collect()
    return max(report(before), report(after))


def _print(tree: Tree, arguments: argparse.Namespace) -> None:
    if arguments.json:
        data: Any = tree.data
        print(json.dumps(data, indent=1, sort_keys=True))
        return
    from edulaunch.advice.explaining.tree import ASCII_TWIGS, TWIGS, drawn, print_in_colour

    try:
        ''.join(TWIGS).encode(sys.stdout.encoding or 'ascii')
        twigs = TWIGS
    except UnicodeEncodeError:
        twigs = ASCII_TWIGS
    if sys.stdout.isatty():
        print_in_colour(tree.title, tree.entries, twigs)
        return
    print('\n'.join((tree.title, *drawn(tree.entries, twigs))))


def report(explanation: Explanation) -> int:
    """Print missing packages and the error of the launch file on standard error. Return the exit code."""
    packages, others = explanation.missing
    if packages:
        print(f'missing packages, replaced by empty ones: {", ".join(packages)}', file=sys.stderr)
    for other in others:
        print(f'missing: {other}', file=sys.stderr)
    for undone in explanation.plan.get('not_done', ()):
        print(f'the dry run skipped: {undone}', file=sys.stderr)
    error = explanation.plan['error']
    if error is None:
        return 0
    place = f'\n  at {error["origin"]}' if error.get('origin') else ''
    help = f'\n  help: {error["help"]}' if error.get('help') else ''
    print(f'error: {error["text"]}{place}{help}', file=sys.stderr)
    return 1


def plan_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the same arguments as for `edulaunch explain`."""
    explain_arguments(parser)


def plan_verb(arguments: argparse.Namespace) -> int:
    """With `--json`, print the plan in plan format 1. Otherwise, do the same as `edulaunch explain`."""
    if not arguments.json or arguments.diff:
        print('`edulaunch plan` is now `edulaunch explain`; only `plan --json` keeps its name', file=sys.stderr)
        return explain_verb(arguments)
    explanation, _ = explained(arguments)
    print(json.dumps(explanation.plan, indent=1, sort_keys=True))
    return report(explanation)
