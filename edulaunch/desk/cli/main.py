"""The command `edulaunch`: read the verb, load only the file of that verb, and convert errors to a message and an exit code."""

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
from edulaunch.desk.cli.plugin_options import add_plugin_options
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import FAULTS, EdulaunchError, UnusableInput, fault_text
from edulaunch.runtime.version import __version__

VERBS = {
    'colcon': 'report which build steps are not needed here',
    'completion': 'print a shell completion script',
    'doctor': 'find mistakes in a launch file, package or recording, and suggest fixes',
    'env': 'print the paths that editors and type checkers need, or set up a shell',
    'explain': 'show what a launch file would start, and where each value comes from',
    'launch': 'run a launch file, like `ros2 launch`',
    'machine': 'show, pause, resume or stop the machine that your terminals share',
    'pkg': 'create a package, or check packages for common mistakes',
    'plan': 'like explain; with --json, output for other programs',
    'python': 'run a Python script with rclpy and your workspace available',
    'recording': 'show or export a recording',
    'ros2': 'run a ros2 command, even where a real ROS 2 is sourced',
    'rosdep': 'list dependencies that neither edulaunch nor your workspace provides',
    'view': 'open the live view of the shared machine in a browser',
}
"""The built-in verbs; plug-ins add more."""
HOMES = {'colcon': 'rosdep', 'plan': 'explain', 'python': 'env', 'view': 'machine'}
"""Verbs that are in the file of another verb."""
VERBATIM = ('colcon', 'python')
"""Verbs that pass on all their words, including options."""
EXAMPLES = """examples:
  edulaunch launch turtlesim multisim.launch.py --for 5
  edulaunch launch solutions/circle.launch.py circle_radius:=0.8 --fast --for 60 --record circle.rec
  edulaunch explain solutions/circle.launch.py
  edulaunch recording info circle.rec

exit status: 0 success, 1 the launch failed, 2 invalid input, 130 interrupted"""
NEXT_STEPS = """What would you like to do next?
  ros2 launch turtle_tf2_py turtle_tf2_demo.launch.py    start two turtles; then type `edulaunch view` in a second terminal
  edulaunch course copy my_course                        copy the lessons; then type `edulaunch course open my_course`
  edulaunch explain FILE.launch.py                       show what your launch file would start
`edulaunch --help` lists all commands."""
"""The output of `edulaunch` without a verb."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command `edulaunch`. Return the exit code.

    :param argv: the words after `edulaunch` (default: the words of `sys.argv`).
    """
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, 'reconfigure'):
            stream.reconfigure(errors='backslashreplace')  # the output of programs may not fit the terminal's encoding
    words = list(sys.argv[1:] if argv is None else argv)
    if words[:1] == ['ros2']:
        from edulaunch.desk.machine.command import run

        return run(words[1:])
    try:
        parser = _parser(words)
    except UnusableInput as error:
        return _unusable(error)
    verbatim = words[:1] != [] and words[0] in VERBATIM and words[1:] not in (['-h'], ['--help'])
    arguments, others = parser.parse_known_args(words[:1] if verbatim else words)
    if verbatim:
        arguments.rest = words[1:]
    wrong = not hasattr(arguments, 'rest') or any(word.startswith('-') for word in others)
    if others and wrong and not hasattr(arguments, 'takes_anything'):
        parser.error(_unrecognized(others, arguments.verb))
    if others:
        arguments.rest += others  # launch arguments may follow options
    if arguments.verb is None:
        print(NEXT_STEPS)
        return 0
    try:
        code = load(arguments.verb)[1](arguments)
        sys.stdout.flush()
        return code
    except UnusableInput as error:
        return _unusable(error)
    except EdulaunchError as error:
        print(f'error: {error}', file=sys.stderr)
        return 1
    except BrokenPipeError:
        sys.stderr.close()
        return 141
    except OSError as error:
        if error.errno not in FAULTS:
            raise
        if error.errno not in (errno.ENOSPC, errno.EDQUOT):
            print(f'error: {fault_text(error)}', file=sys.stderr)
            return 1
        print(f'error: {error.strerror}: cannot write the output of the command', file=sys.stderr)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # otherwise, Python tries to write again when it ends
        return 1


def _unusable(error: UnusableInput) -> int:
    print(f'error: {error}', file=sys.stderr)
    return 2


def all_verbs() -> dict[str, str]:
    """Return the line of help of each verb, with the verbs in alphabetical order. The verbs of plug-ins are included."""
    from edulaunch.runtime import plugins

    return dict(sorted({**{word: verb.about for word, verb in plugins.verbs().items()}, **VERBS}.items()))


def load(verb: str) -> tuple[Callable[[argparse.ArgumentParser], None], Callable[[argparse.Namespace], int]]:
    """Return the functions `VERB_arguments` and `VERB_verb` from the file of a verb.

    :raises KeyError: for an unknown verb.
    """
    if verb in VERBS:
        module = f'edulaunch.desk.cli.{HOMES.get(verb, verb)}'
    else:
        from edulaunch.runtime import plugins

        module = plugins.verbs()[verb].module
    names = vars(import_module(module))
    return names[f'{verb}_arguments'], names[f'{verb}_verb']


class _Parser(argparse.ArgumentParser):
    """A parser that suggests the most similar valid word for an unknown word."""

    def error(self, message: str) -> NoReturn:
        """Print the usage and the message on standard error, and exit with code 2."""
        match = re.search(r"invalid choice: '(.*)' \(choose from (.*)\)", message)
        near = did_you_mean(match[1], re.findall(r'[\w-]+', match[2])) if match else None
        super().error(f'{message}\n  help: {near}' if near else message)


def _unrecognized(words: Sequence[str], verb: str | None) -> str:
    """Return argparse's message for unknown options, with the most similar known option."""
    sub = argparse.ArgumentParser(prog=verb)
    if verb is not None:
        load(verb)[0](sub)
    wrong = next(word for word in words if word.startswith('-')) if any(word.startswith('-') for word in words) else words[0]
    near = did_you_mean(f'--{wrong.lstrip("-")}', options_of(sub))
    return f'unrecognized arguments: {" ".join(words)}' + (f'\n  help: {near}' if near else '')


def _parser(words: Sequence[str]) -> argparse.ArgumentParser:
    """Return the parser. Only the chosen verb has its arguments, so that no file of another verb is loaded.

    :raises UnusableInput: for a verb of one of edulaunch's own plug-ins that is not installed.
    """
    wanted = words[0] if words else None
    known = VERBS if wanted in VERBS else all_verbs()
    listed = ''.join(f'  {verb:<11} {about}\n' for verb, about in known.items())
    parser = _Parser(
        prog='edulaunch',
        usage='%(prog)s [-h] [--version] COMMAND ...',
        description='Run ROS 2 launch files, tf2 and turtlesim in a deterministic simulation.',
        epilog=f'commands:\n{listed}\n{EXAMPLES}',
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument('--version', action='version', version=f'edulaunch {__version__}')
    verbs = parser.add_subparsers(dest='verb', metavar='COMMAND', prog='edulaunch', help=argparse.SUPPRESS)
    for verb, text in known.items():
        about = f'{text[:1].upper()}{text[1:]}.'
        sub = verbs.add_parser(verb, help=text, description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
        if verb == wanted:
            load(verb)[0](sub)
            add_plugin_options(verb, sub, words[1:])
    if wanted is not None and wanted not in verbs.choices:
        _refuse_absent(f'edulaunch {wanted}')
    return parser


def _refuse_absent(what: str) -> None:
    from edulaunch.runtime.plugins import absent

    error = absent(what)
    if error is not None:
        raise error


if __name__ == '__main__':
    raise SystemExit(main())
