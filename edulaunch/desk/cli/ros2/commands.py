"""`ros2 ...` inside the simulation: the list of commands, and functions that parse and run a command line.

A command has verbs, or an empty table of verbs if it does its work itself. Only the file of the chosen command is loaded. As
in ros2cli, argparse parses the words. The parser writes to the streams of the running process.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

from edulaunch.desk.cli.plugin_options import add_plugin_options
from edulaunch.desk.cli.ros2.output import with_help
from edulaunch.engine.graph.names import UnknownSubstitution
from edulaunch.engine.nearest import nearest
from edulaunch.engine.processes.current import current_process
from edulaunch.errors import FAULTS, EdulaunchError, fault_text

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

COMMANDS: dict[str, tuple[str, dict[str, str]]] = {
    'action': (
        'Various action related sub-commands',
        {
            'info': 'Print information about an action',
            'list': 'Output a list of action names',
            'send_goal': 'Send an action goal',
            'type': "Print a action's type",
        },
    ),
    'bag': (
        'Various rosbag related sub-commands',
        {
            'info': 'Print information about a bag to the screen',
            'play': 'Play back ROS data from a bag',
            'record': 'Record ROS data to a bag',
        },
    ),
    'component': (
        'Various component related sub-commands',
        {
            'list': 'Output a list of running containers and components',
            'load': 'Load a component into a container node',
            'standalone': 'Run a component into its own standalone container node',
            'types': 'Output a list of components registered in the ament index',
            'unload': 'Unload a component from a container node',
        },
    ),
    'daemon': (
        'Various daemon related sub-commands',
        {
            'start': "Start the daemon if it isn't running",
            'status': 'Output the status of the daemon',
            'stop': 'Stop the daemon if it is running',
        },
    ),
    'doctor': ('Check ROS setup and other potential issues', {}),
    'interface': (
        'Show information about ROS interfaces',
        {
            'list': 'List all interface types available',
            'package': 'Output a list of available interface types within one package',
            'packages': 'Output a list of packages that provide interfaces',
            'proto': 'Output an interface prototype',
            'show': 'Output the interface definition',
        },
    ),
    'launch': ('Run a launch file', {}),
    'lifecycle': (
        'Various lifecycle related sub-commands',
        {
            'get': 'Get lifecycle state for one or more nodes',
            'list': 'Output a list of available transitions',
            'nodes': 'Output a list of nodes with lifecycle',
            'set': 'Trigger lifecycle state transition',
        },
    ),
    'multicast': (
        'Various multicast related sub-commands',
        {'receive': 'Receive a single UDP multicast packet', 'send': 'Send a single UDP multicast packet'},
    ),
    'node': (
        'Various node related sub-commands',
        {'info': 'Output information about a node', 'list': 'Output a list of available nodes'},
    ),
    'param': (
        'Various param related sub-commands',
        {
            'delete': 'Delete parameter',
            'describe': 'Show descriptive information about declared parameters',
            'dump': 'Show all of the parameters of a node in a YAML file format',
            'get': 'Get parameter',
            'list': 'Output a list of available parameters',
            'load': 'Load parameter file for a node',
            'set': 'Set parameter',
        },
    ),
    'pkg': (
        'Various package related sub-commands',
        {
            'create': 'Create a new ROS 2 package',
            'executables': 'Output a list of package specific executables',
            'list': 'Output a list of available packages',
            'prefix': 'Output the prefix path of a package',
            'xml': 'Output the XML of the package manifest or a specific tag',
        },
    ),
    'run': ('Run a package specific executable', {}),
    'service': (
        'Various service related sub-commands',
        {
            'call': 'Call a service',
            'echo': 'Echo a service',
            'find': 'Output a list of available services of a given type',
            'info': 'Print information about a service',
            'list': 'Output a list of available services',
            'type': "Output a service's type",
        },
    ),
    'topic': (
        'Various topic related sub-commands',
        {
            'bw': 'Display bandwidth used by topic',
            'delay': 'Display delay of topic from timestamp in header',
            'echo': 'Output messages from a topic',
            'find': 'Output a list of available topics of a given type',
            'hz': 'Print the average publishing rate to screen',
            'info': 'Print information about a topic',
            'list': 'Output a list of available topics',
            'pub': 'Publish a message to a topic',
            'type': "Print a topic's type",
        },
    ),
    'wtf': ('Use `wtf` as alias to `doctor`', {}),
}
MODULES = {
    'bag play': 'bag_play',
    'bag record': 'bag_record',
    'daemon': 'system_checks',
    'doctor': 'system_checks',
    'multicast': 'system_checks',
    'run': 'launch',
    'topic bw': 'topic_measuring',
    'topic delay': 'topic_measuring',
    'topic hz': 'topic_measuring',
    'wtf': 'system_checks',
}
"""The file of each verb that has its own file, and of each command that is in the file of another command."""
NOT_HERE = {
    'control': 'edulaunch has no ros2_control',
    'plugin': 'plugins are C++ libraries, which cannot run here',
    'security': 'a simulated machine has no network to protect',
    'trace': 'every run is recorded: see `edulaunch recording`',
}
"""Commands that many ROS 2 installations have, and why edulaunch does not have them."""
WIDTH = 100
BUFFERING = '--use-python-default-buffering'
BUFFERING_HELP = f"""  {BUFFERING}
                        accepted; each line is always written immediately
"""
INTERRUPTED = 2
"""The exit code of `ros2` after Ctrl-C: the number of the signal."""


class Verb(NamedTuple):
    """The two functions of a verb, or of a command without verbs: one adds its arguments, and one runs it."""

    add_arguments: Callable[[argparse.ArgumentParser], None]
    main: Callable[[argparse.Namespace], Any]


def load(command: str, verb: str | None) -> Verb:
    """Return the functions `VERB_arguments` and `VERB_verb` from the file of a command.

    VERB is the name of the command if the command has no verbs, or if one function serves all its verbs.
    """
    home = MODULES.get(f'{command} {verb}') or MODULES.get(command, command)
    names = vars(import_module(f'edulaunch.desk.cli.ros2.{home}'))
    name = next(name for name in (verb, command) if f'{name}_verb' in names)
    return Verb(names[f'{name}_arguments'], names[f'{name}_verb'])


class Parser(argparse.ArgumentParser):
    """A parser that writes to the streams of the simulated program, in lines of a fixed width."""

    def __init__(self, prog: str, description: str) -> None:
        super().__init__(
            prog=prog, description=description, formatter_class=lambda prog: argparse.HelpFormatter(prog, width=WIDTH)
        )

    def _print_message(self, message: str, file: Any = None) -> None:
        process = current_process()
        (process.streams.stderr if file is sys.stderr else process.streams.stdout).write(message)

    def parse(self, words: Sequence[str]) -> argparse.Namespace:
        """Return the parsed arguments. Unlike `parse_args`, also accept optional positional words after options.

        argparse itself accepts these words only in newer versions of Python.
        """
        arguments, others = self.parse_known_args(words)
        for action in self._get_positional_actions():
            if action.nargs == '*':
                while others and not others[0].startswith('-'):
                    getattr(arguments, action.dest).append(others.pop(0))
            elif (
                action.nargs == '?'
                and others
                and getattr(arguments, action.dest) == action.default
                and not others[0].startswith('-')
            ):
                setattr(arguments, action.dest, others.pop(0))
        if others:
            self.error(f'unrecognized arguments: {" ".join(others)}')
        return arguments

    def error(self, message: str) -> NoReturn:
        """Print the usage, the message and a suggestion on standard error. Exit with status 2."""
        self.print_usage(sys.stderr)
        unknown = message.partition('unrecognized arguments: ')[2].split()
        near = nearest(unknown[0], self._option_string_actions) if unknown and unknown[0].startswith('-') else None
        help = f'did you mean {near}?' if near else None
        if unknown and unknown[-1].endswith('}'):
            help = 'put the values into double quotes, because the shell splits them at each space: "{x: 1.0, y: 2.0}"'
        self.exit(2, with_help(f'{self.prog}: error: {message}', help) + '\n')


def command_line(words: Sequence[str]) -> tuple[Verb, argparse.Namespace]:
    """Return the functions of the command that `ros2 WORDS...` names, and its parsed arguments.

    :raises SystemExit: with status 0 after showing help, and with status 2 after an error.
    :raises UnusableInput: for an option of one of edulaunch's own plug-ins that is not installed.
    """
    words = words[words[:1] == [BUFFERING] :]
    command = _chosen('ros2', 'command', words, {name: text for name, (text, _) in COMMANDS.items()})
    text, verbs = COMMANDS[command]
    prog, rest = f'ros2 {command}', words[1:]
    verb = None
    if verbs:
        verb = _chosen(prog, 'verb', rest, verbs, text)
        prog, text, rest = f'{prog} {verb}', verbs[verb], rest[1:]
    parser = Parser(prog, text)
    parser.set_defaults(verb=verb)
    found = load(command, verb)
    found.add_arguments(parser)
    if command == 'launch':
        add_plugin_options('ros2 launch', parser, rest)
    return found, parser.parse(rest)


def _chosen(prog: str, kind: str, words: Sequence[str], known: dict[str, str], text: str = '') -> str:
    """Return the first word if it is a known command or verb. Without a word, show the help."""
    option = '' if text else f' [{BUFFERING}]'
    usage = f'usage: {prog} [-h]{option} Call `{prog} <{kind}> -h` for more detailed usage. ...\n'
    if not words or words[0] in ('-h', '--help'):
        about = text or 'ros2 is an extensible command-line tool for ROS 2.'
        options = '  -h, --help            show this help message and exit\n' + ('' if text else BUFFERING_HELP)
        title = f'{usage}\n{about}\n\noptions:\n{options}\nCommands:\n'
        current_process().streams.stdout.write(f'{title}{_listed(known)}\n  Call `{prog} <{kind}> -h` for more detailed usage.\n')
        raise SystemExit(0)
    word = words[0]
    if word in known:
        return word
    near = nearest(word, known)
    choices = ', '.join(repr(name) for name in known)
    message = with_help(
        f'{prog}: error: argument Call `{prog} <{kind}> -h` for more detailed usage.: invalid choice: {word!r} '
        f'(choose from {choices})',
        (NOT_HERE.get(word) if prog == 'ros2' else None) or (near and f'did you mean `{prog} {near}`?'),
    )
    current_process().streams.stderr.write(f'{usage}{message}\n')
    raise SystemExit(2)


def _listed(known: dict[str, str]) -> str:
    width = max(map(len, known))
    return ''.join(f'  {name:<{width}}  {text}\n' for name, text in known.items())


def main(process: Process) -> int:
    """Run the command line of a process inside this process. Return the exit code.

    As in ROS 2, the error message of a verb goes to standard error, with exit code 1. Wrong usage has exit code 2.

    :param process: the process, whose `argv` begins with 'ros2'.
    """

    try:
        verb, arguments = command_line(process.argv[1:])
        return _exit_code(process, verb.main(arguments))
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0
    except KeyboardInterrupt:
        return INTERRUPTED
    except (EdulaunchError, RuntimeError, UnknownSubstitution) as error:
        return _exit_code(process, str(error))
    except OSError as error:
        if error.errno not in FAULTS:
            raise
        return _exit_code(process, f'error: {fault_text(error)}')


def _exit_code(process: Process, outcome: Any) -> int:
    """Return the exit code for the result of a verb: None, a number, or an error message, which is printed."""
    if isinstance(outcome, str):
        process.streams.stderr.write(outcome + '\n')
        return 1
    return int(outcome or 0)
