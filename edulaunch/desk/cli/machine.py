"""`edulaunch machine` controls the machine that all terminals of this user and domain share. `edulaunch view` shows it.

The live view in a browser replaces turtlesim's window, rviz2 and the rqt tools.
"""

from __future__ import annotations

import argparse
from contextlib import suppress
from typing import TYPE_CHECKING

from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    import socket


def machine_arguments(parser: argparse.ArgumentParser) -> None:
    """Add two arguments: the command, such as `status` or `stop`, and its value, such as the speed."""
    commands = ('status', 'pause', 'resume', 'speed', 'stop')
    about = f'one of {", ".join(commands)} (default: status)'
    parser.add_argument('word', metavar='COMMAND', choices=commands, nargs='?', default='status', help=about)
    parser.add_argument('value', nargs='?', help='for speed: simulated seconds per second')


def machine_verb(arguments: argparse.Namespace) -> int:
    """Send the command to the machine. Return the exit code, which is 1 if no machine runs."""
    from edulaunch.desk.machine.client import run

    words = ['machine', arguments.word] + ([arguments.value] if arguments.value else [])
    return run(words, start=False)


def view_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of `edulaunch view`."""
    from edulaunch.desk.view import TABS

    parser.add_argument('--tab', choices=TABS, default='graph', help='the first tab on the right side')
    parser.add_argument('--port', type=int, default=0, help='port on this computer (default: any free port)')
    parser.add_argument('--no-browser', action='store_true', help='only print the address of the page')
    parser.add_argument('--until-eof', action='store_true', help=argparse.SUPPRESS)


def view_verb(arguments: argparse.Namespace) -> int:
    """Serve the page of the live view until Ctrl-C. Return the exit code.

    :raises UnusableInput: when the port is in use, or no machine can start.
    """
    import asyncio

    from edulaunch.desk.cli.plugin_options import plugins_of
    from edulaunch.desk.machine.place import UnsafePlace, folder
    from edulaunch.desk.machine.web import serve, show, tell

    try:
        folder()
    except UnsafePlace as error:
        raise UnusableInput(str(error)) from None

    def opened(address: str) -> None:
        tell(address, '' if arguments.until_eof else '  Press Ctrl-C to close the live view; the machine continues\n')
        if not arguments.no_browser:
            show(address)

    of_plugins = (options.view(arguments) for options in plugins_of(arguments))
    served = next((one for one in of_plugins if one is not None), None)

    async def page() -> None:
        serving = asyncio.ensure_future(served or serve(connected, port=arguments.port, tab=arguments.tab, opened=opened))
        if arguments.until_eof:  # the parent process ends, or is killed
            asyncio.get_running_loop().add_reader(0, serving.cancel)
        with suppress(asyncio.CancelledError):
            await serving

    try:
        asyncio.run(page())
    except KeyboardInterrupt:
        return 0
    except (OSError, OverflowError) as error:
        raise UnusableInput(f'cannot serve the page: {error}', help='choose another --port, or leave it out') from None
    return 0


def connected(*words: str) -> tuple[socket.socket, bytes]:
    """Connect to the machine, and start it if necessary. Return the connection and the first frame to send on it.

    :param words: the purpose of the connection: 'view', or 'serve' and the name of a plug-in's service.
    :raises OSError: when the machine does not answer.
    """
    from edulaunch.desk.machine.client import hello
    from edulaunch.desk.machine.place import domain
    from edulaunch.desk.machine.starting import connect

    found = connect(domain(), start=True)
    if found is None:
        raise OSError('the machine does not answer')
    client, address = found
    client.setblocking(False)
    return client, hello(address.token, ['machine', *(words or ('view',))], keyboard=False)
