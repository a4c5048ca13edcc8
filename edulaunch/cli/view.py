"""`edulaunch view`: the live page of the machine in a browser, in place of turtlesim's window, rviz2 and the rqt tools."""

from __future__ import annotations

import argparse
import asyncio
import socket
from contextlib import suppress

from edulaunch.errors import UnusableInput
from edulaunch.view import TABS


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the verb."""
    parser.add_argument('--tab', choices=TABS, default='graph', help='what stands on the right side at first')
    parser.add_argument('--port', type=int, default=0, help='port on this computer (default: any that is free)')
    parser.add_argument('--no-browser', action='store_true', help='only say where the page is')
    parser.add_argument('--until-eof', action='store_true', help=argparse.SUPPRESS)


def main(arguments: argparse.Namespace) -> int:
    """Serve the page until Ctrl-C. Returns the exit code.

    :raises UnusableInput: when the port is taken, or no machine can be started.
    """
    from edulaunch.machine.place import UnsafePlace, folder
    from edulaunch.machine.web import serve, show, tell

    try:
        folder()
    except UnsafePlace as error:
        raise UnusableInput(str(error)) from None

    def opened(address: str) -> None:
        tell(address, '' if arguments.until_eof else '  Ctrl-C ends it; the machine goes on\n')
        if not arguments.no_browser:
            show(address)

    async def page() -> None:
        serving = asyncio.ensure_future(serve(_connect, port=arguments.port, tab=arguments.tab, opened=opened))
        if arguments.until_eof:  # whoever started us ends, or is killed
            asyncio.get_running_loop().add_reader(0, serving.cancel)
        with suppress(asyncio.CancelledError):
            await serving

    try:
        asyncio.run(page())
    except KeyboardInterrupt:
        return 0
    except (OSError, OverflowError) as error:
        raise UnusableInput(f'cannot serve the page: {error}', help='choose another --port, or none') from None
    return 0


def _connect() -> tuple[socket.socket, bytes]:
    """A new connection to the machine, which starts if it has to."""
    from edulaunch.machine.client import hello
    from edulaunch.machine.place import domain
    from edulaunch.machine.starting import connect

    found = connect(domain(), start=True)
    if found is None:
        raise OSError('the machine does not answer')
    client, token = found
    client.setblocking(False)
    return client, hello(token, ['machine', 'view'], keyboard=False)
