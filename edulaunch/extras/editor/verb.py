"""The verb `edulaunch lsp`."""

from __future__ import annotations

import argparse
import os
import sys
from importlib.util import find_spec

from edulaunch.errors import MissingExtra


def lsp_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of the verb."""
    parser.add_argument('--stdio', action='store_true', help='use standard input and output (this is always so)')
    parser.add_argument(
        '--no-run', action='store_true', help='never execute a file (default: run each saved launch file in a sandbox)'
    )
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def lsp_verb(arguments: argparse.Namespace) -> int:
    """Serve one editor until it disconnects.

    :raises UnusableInput: when pygls is not installed.
    """
    if find_spec('pygls') is None:
        raise MissingExtra('edulaunch lsp', 'pygls', 'editor')
    from edulaunch.extras.editor.server import serve

    serve(runs=not arguments.no_run, workspaces=arguments.workspace)
    sys.stdout = open(os.devnull, 'w')  # noqa: SIM115  # pygls has closed the old one
    return 0
