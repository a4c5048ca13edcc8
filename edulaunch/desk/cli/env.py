"""`edulaunch env` prints the folder of ROS's import packages. With `--install` or `--shell`, it makes shells find them.

`edulaunch python node.py` runs Python with these packages and with the packages of the current workspaces.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Mapping

from edulaunch.engine.packages.discovery import find_workspaces
from edulaunch.engine.underlay_place import underlay_prefix, underlay_python


def env_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options that choose what the command prints."""
    parser.add_argument(
        '--install',
        action='store_true',
        help='make `source .venv/bin/activate` set up completion, ROS imports and answers to set-up lines, too (bash, zsh, fish)',
    )
    parser.add_argument(
        '--shell',
        action='store_true',
        help='print lines for a shell outside of a virtual environment: eval "$(edulaunch env --shell)"',
    )
    parser.add_argument(
        '--answer', nargs=argparse.REMAINDER, metavar='WORD', help="explain whether a tutorial's set-up line is needed here"
    )


def env_verb(arguments: argparse.Namespace) -> int:
    """Print the folder that contains `rclpy`, `launch` and so on, for editors and type checkers.

    With `--shell`, print shell code.
    """
    if arguments.answer is not None:
        return _answer(arguments.answer)
    if arguments.install:
        return _install()
    if not arguments.shell:
        print(underlay_python())
        return 0
    from shlex import quote

    from edulaunch.desk.cli.activation import functions

    for name, value in sorted(sourced_environment(os.environ).items()):
        print(f'export {name}={quote(value)}')
    print(f'if [ -n "$BASH_VERSION$ZSH_VERSION" ]; then eval {quote(functions())}; fi')
    return 0


def _install() -> int:
    from edulaunch.desk.cli.activation import install_here

    for path in install_here():
        command = 'config.fish' if path.suffix == '.fish' else '~/.bashrc or ~/.zshrc'
        print(f'source {path}    # type this in each terminal, or put it into {command} once')
    return 0


def _answer(words: list[str]) -> int:
    """Explain a set-up command for ROS 2, or show where the picture of a window is. Return 1 for any other command."""
    from edulaunch.advice.workspace.not_needed import WINDOWS, answer

    printed = answer(words)
    if printed is None:
        return 1
    if words[0] in WINDOWS and sys.stdout.isatty():
        sys.stdout.flush()
        os.execv(sys.executable, [sys.executable, '-m', 'edulaunch', 'view', '--tab', WINDOWS[words[0]]])
    print(printed)
    return 0


def sourced_environment(env: Mapping[str, str]) -> dict[str, str]:
    """Return the environment variables that make Python find `rclpy` and the packages of the current workspaces."""
    workspaces = find_workspaces(os.getcwd(), env)
    first = {
        'PATH': [os.path.dirname(sys.executable)],
        'PYTHONPATH': [os.path.join(underlay_prefix(), 'shell'), underlay_python()],
        'AMENT_PREFIX_PATH': [underlay_prefix()],
    }
    found = {
        name: os.pathsep.join(dict.fromkeys([*paths, *filter(None, env.get(name, '').split(os.pathsep))]))
        for name, paths in first.items()
    }
    found.update(ROS_DISTRO='jazzy', ROS_VERSION='2', ROS_PYTHON_VERSION='3')
    if workspaces:
        found['EDULAUNCH_WORKSPACES'] = os.pathsep.join(workspaces)
    return found


def python_arguments(parser: argparse.ArgumentParser) -> None:
    """Accept all command-line arguments of Python."""
    parser.add_argument('rest', nargs=argparse.REMAINDER, metavar='WORD', help='the arguments of python3')


def python_verb(arguments: argparse.Namespace) -> int:
    """Replace this process by Python with the environment of ROS. On Windows, run Python and return its exit code."""
    env = {**os.environ, **sourced_environment(os.environ)}
    words = [sys.executable, *arguments.rest]
    if os.name != 'nt':
        os.execve(sys.executable, words, env)
    import subprocess  # on Windows, a shell does not wait for a process that replaces itself

    return subprocess.run(words, env=env, check=False).returncode
