"""The command line: `edulaunch VERB ...`, one file per verb.

A verb module has `add_arguments(parser)` and `main(arguments) -> int`."""

from __future__ import annotations
