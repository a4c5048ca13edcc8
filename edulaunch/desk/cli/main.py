"""`edulaunch`: reads the verb, loads that verb's file only, and turns errors into one message and an exit code."""

from __future__ import annotations

import argparse
import errno
import os
import re
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import NoReturn

from edulaunch.desk.cli import options_of
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import EdulaunchError, UnusableInput
from edulaunch.version import __version__

VERBS = {
    'colcon': 'Say what of building is not needed here',
    'compare': 'Run a launch file in simulation and on the real rclpy, and say what differs',
    'completion': 'Print the script that completes commands with the Tab key',
    'course': 'Copy the course, see how far you are, or make a course of your own',
    'doctor': 'Say what is wrong with a launch file, a package or a run, and what to do',
    'env': 'Print where rclpy, launch and the others are, for editors, type checkers and shells',
    'explain': 'Show what a launch file would start, and where every value comes from, without starting anything',
    'launch': 'Run a launch file, as `ros2 launch` does',
    'machine': 'Look at the machine that the terminals share, pause or stop it',
    'network': 'Join the machine to a real ROS 2 network, let it leave, or install the real rclpy',
    'pkg': 'Make a package, or look for common mistakes in packages',
    'plan': 'The same as explain; with --json, the plan of a launch file for programs',
    'python': 'Run Python with rclpy and the packages of the workspace',
    'recording': 'Look into a recording',
    'view': 'Show the live page of the machine in a browser',
    'rosdep': 'Name the dependencies of packages that are not here',
}
HOMES = {'colcon': 'rosdep', 'network': 'machine', 'plan': 'explain', 'python': 'env', 'view': 'machine'}
"""Verbs that stand in the file of another one."""
VERBATIM = ('colcon', 'python')
"""Verbs that hand on all their words, options and all."""
EXAMPLES = """examples:
  edulaunch launch turtlesim multisim.launch.py --for 5
  edulaunch launch solutions/circle.launch.py circle_radius:=0.8 --fast --for 60 --record circle.rec
  edulaunch launch solutions/circle.launch.py -s
  edulaunch recording info circle.rec
  edulaunch ros2 topic list    (any command of ros2, also where a real ROS 2 is sourced)

exit codes: 0 all went well, 1 the launch failed, 2 the input cannot be used, 130 interrupted"""


def main(argv: Sequence[str] | None = None) -> int:
    """The entry point of the command. Returns the exit code."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, 'reconfigure'):
            stream.reconfigure(errors='backslashreplace')  # what programs print may not fit the terminal's encoding
    words = list(sys.argv[1:] if argv is None else argv)
    if words[:1] == ['ros2']:
        from edulaunch.desk.machine.command import run

        return run(words[1:])
    parser = _parser(words[0] if words else None)
    verbatim = words[:1] != [] and words[0] in VERBATIM and words[1:] not in (['-h'], ['--help'])
    arguments, others = parser.parse_known_args(words[:1] if verbatim else words)
    if verbatim:
        arguments.rest = words[1:]
    wrong = not hasattr(arguments, 'rest') or any(word.startswith('-') for word in others)
    if others and wrong and not hasattr(arguments, 'takes_anything'):
        parser.error(_unrecognized(others, arguments.verb))
    if others:
        arguments.rest += others  # launch arguments may stand behind options too
    if arguments.verb is None:
        parser.print_help()
        return 2
    try:
        code = load(arguments.verb)[1](arguments)
        sys.stdout.flush()
        return code
    except EdulaunchError as error:
        print(f'error: {error}', file=sys.stderr)
        return 2 if isinstance(error, UnusableInput) else 1
    except BrokenPipeError:
        sys.stderr.close()
        return 141
    except OSError as error:
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            raise
        print(f'error: {error.strerror}: what the command says or keeps cannot be written', file=sys.stderr)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # else Python tries once more at its end
        return 1


def load(verb: str) -> tuple[Callable[[argparse.ArgumentParser], None], Callable[[argparse.Namespace], int]]:
    """The functions `VERB_arguments` and `VERB_verb` of the verb's file."""
    names = vars(import_module(f'edulaunch.desk.cli.{HOMES.get(verb, verb)}'))
    return names[f'{verb}_arguments'], names[f'{verb}_verb']


class _Parser(argparse.ArgumentParser):
    """With the nearest of the words that can stand where an unknown one does."""

    def error(self, message: str) -> NoReturn:
        """Usage and message on standard error; exit code 2."""
        said = re.search(r"invalid choice: '(.*)' \(choose from (.*)\)", message)
        near = did_you_mean(said[1], re.findall(r'[\w-]+', said[2])) if said else None
        super().error(f'{message}\n  help: {near}' if near else message)


def _unrecognized(words: Sequence[str], verb: str) -> str:
    """What argparse says of words that are no option, with the option that was meant."""
    sub = argparse.ArgumentParser(prog=verb)
    load(verb)[0](sub)
    wrong = next(word for word in words if word.startswith('-')) if any(word.startswith('-') for word in words) else words[0]
    near = did_you_mean(f'--{wrong.lstrip("-")}', options_of(sub))
    return f'unrecognized arguments: {" ".join(words)}' + (f'\n  help: {near}' if near else '')


def _parser(wanted: str | None) -> argparse.ArgumentParser:
    """The parser; only the wanted verb's own arguments are filled in, so that the others need not be loaded."""
    parser = _Parser(
        prog='edulaunch',
        description='ROS 2 launch, tf2 and turtlesim in a deterministic simulation.',
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument('--version', action='version', version=f'edulaunch {__version__}')
    verbs = parser.add_subparsers(dest='verb', metavar='VERB')
    for verb, text in VERBS.items():
        sub = verbs.add_parser(verb, help=text, description=text + '.', formatter_class=argparse.RawDescriptionHelpFormatter)
        if verb == wanted:
            load(verb)[0](sub)
    return parser


if __name__ == '__main__':
    raise SystemExit(main())
