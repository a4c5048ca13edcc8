"""The options of `edulaunch view --foxglove` and `edulaunch view RECORDING --foxglove`."""

from __future__ import annotations

import argparse
import os
from collections.abc import Coroutine
from typing import TYPE_CHECKING, Any

from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.extras.foxglove.lines import Line
    from edulaunch.extras.foxglove.server import Open


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the verb `view`."""
    parser.add_argument('recording', nargs='?', metavar='RECORDING', help='with --foxglove: play this recording')
    parser.add_argument('--foxglove', action='store_true', help='serve Foxglove and Lichtblick in place of the page')
    parser.add_argument('--trusted', action='store_true', help='with --foxglove: read the recording without limits on its size')
    parser.add_argument(
        '--origin',
        action='append',
        default=[],
        metavar='URL',
        help='with --foxglove: accept pages of this origin, such as http://localhost:8080',
    )


def view(arguments: argparse.Namespace) -> Coroutine[Any, Any, None] | None:
    """Return the coroutine to run instead of the page, or None without the option.

    :raises UnusableInput: for a recording without the option.
    :raises RecordingError: when the recording cannot be read.
    """
    if not arguments.foxglove:
        if arguments.recording is not None:
            raise UnusableInput(
                'edulaunch view shows the machine, not a recording',
                help=f'type edulaunch recording show {arguments.recording} --open',
            )
        return None
    from edulaunch.extras.foxglove.server import serve

    line = _machine() if arguments.recording is None else _player(arguments.recording, arguments.trusted)
    ending = '  Ctrl-C ends it' + ('; the machine continues\n' if arguments.recording is None else '\n')

    def opened(address: str) -> None:
        print(f'Foxglove and Lichtblick can connect to {address}\n{ending}', end='', flush=True)

    return serve(line, port=arguments.port, origins=arguments.origin, opened=opened)


def _machine() -> Open:
    from edulaunch.desk.cli.machine import connected
    from edulaunch.extras.foxglove.lines import MachineLine

    async def line(subprotocol: str) -> Line:
        return MachineLine(*connected('serve', 'foxglove'))

    return line


def _player(path: str, trusted: bool) -> Open:
    from edulaunch.engine.recording import Recording
    from edulaunch.extras.foxglove.conversation import Conversation
    from edulaunch.extras.foxglove.lines import HereLine
    from edulaunch.extras.foxglove.protocol import SDK
    from edulaunch.extras.foxglove.recorded import RecordingFeed
    from edulaunch.ros.sourcing import source

    source()
    recording = Recording.load(path, trusted=trusted)

    async def line(subprotocol: str) -> Line:
        return HereLine(Conversation(RecordingFeed(recording, os.path.basename(path), subprotocol == SDK)))

    return line
