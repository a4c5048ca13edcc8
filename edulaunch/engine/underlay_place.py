"""The path of the underlay (the built-in packages, with the layout of a ROS install prefix), and the data files in it."""

from __future__ import annotations

import os
from typing import Any


def engine_folder() -> str:
    """Return the folder of the Python package edulaunch."""
    return os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def underlay_prefix() -> str:
    """Return the underlay's prefix folder. It contains `python/` (import packages) and `share/` (package data)."""
    return os.path.join(engine_folder(), 'ros')


def underlay_data(file: str) -> Any:
    """Return the content of a JSON file in the underlay's prefix folder."""
    import json  # imported here, because `import edulaunch` does not need it

    with open(os.path.join(underlay_prefix(), file), encoding='utf-8') as stream:
        return json.load(stream)


def help_text(key: str, **facts: object) -> str:
    """Return a line of help for an error of the engine. The sentences are in a data file, because they name commands.

    :param key: the key of the sentence in `engine_help.json`.
    :param facts: the values for the names in braces in the sentence.
    """
    sentence: str = underlay_data('engine_help.json')[key]
    return sentence.format(**facts)


def underlay_python() -> str:
    """Return the folder that `edulaunch.source()` puts on the path."""
    return os.path.join(underlay_prefix(), 'python')


def is_students(filename: str) -> bool:
    """Return whether a file is a student's own: it belongs neither to edulaunch nor to Python nor to an installed package.

    Files in the underlay's `share/` are treated as a student's own files.
    """
    python = os.path.dirname(os.path.abspath(os.__file__)) + os.sep
    if filename.startswith(('<', python)) or 'site-packages' in filename or filename.endswith('.pyx'):
        return False
    shared = os.path.join(underlay_prefix(), 'share') + os.sep
    return filename.startswith(shared) or not filename.startswith(engine_folder() + os.sep)
