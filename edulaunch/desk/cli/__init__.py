"""The command line: `edulaunch VERB ...`; `main` reads the verb and loads its file only.

For each verb its file has `VERB_arguments(parser)` and `VERB_verb(arguments)`, which returns the exit code.
"""

from __future__ import annotations

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`
if TYPE_CHECKING:
    import argparse


def arguments_of(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    """All that a parser takes, options and words, in order; argparse has no public name for it."""
    return parser._actions


def options_of(parser: argparse.ArgumentParser) -> dict[str, argparse.Action]:
    """Each way to write an option, and the option."""
    return {text: action for action in arguments_of(parser) for text in action.option_strings}
