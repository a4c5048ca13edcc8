"""`edulaunch course`: what authors and students do with a whole course."""

from __future__ import annotations

import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The sub-verbs of `edulaunch course`."""
    verbs = parser.add_subparsers(dest='what', metavar='VERB', required=True)
    store = verbs.add_parser('store', help='Run lessons, and keep their outputs beside them for nbval')
    store.add_argument('notebooks', nargs='+', metavar='LESSON.ipynb')


def main(arguments: argparse.Namespace) -> int:
    """Returns the exit code."""
    from edulaunch.course.stored import store_outputs

    for notebook in arguments.notebooks:
        store_outputs(notebook)
        print(f'{notebook}: its outputs are kept, the notebook itself has none')
    return 0
