"""The command line of edulaunch. `main` reads the verb of `edulaunch VERB ...` and loads only the file of that verb.

The file of a verb defines `VERB_arguments(parser)` and `VERB_verb(arguments)`. The second function returns the exit code.
"""

from __future__ import annotations

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    import argparse


def arguments_of(parser: argparse.ArgumentParser) -> list[argparse.Action]:
    """Return the options and positional arguments of a parser in the order in which they were added.

    argparse has no public name for this list.
    """
    return parser._actions


def options_of(parser: argparse.ArgumentParser) -> dict[str, argparse.Action]:
    """Map each option string of a parser, such as '-h' or '--help', to its argparse action."""
    return {text: action for action in arguments_of(parser) for text in action.option_strings}
