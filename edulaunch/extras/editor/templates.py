"""`edulaunch course template vscode`: a VS Code extension for the folder of a course, and its settings."""

from __future__ import annotations

import os
from pathlib import Path

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'vscode')
PLACE = '.vscode/extensions/edulaunch'


def vscode(requirements: str, exercises: list[tuple[str, str]]) -> dict[str, bytes]:
    """Return the files of the template by path. VS Code suggests the extensions in this folder when a student opens the
    course.
    """
    names = sorted(name for name in os.listdir(FOLDER) if name.endswith(('.js', '.json', '.md')))
    return {f'{PLACE}/{name}': Path(FOLDER, name).read_bytes() for name in names}
