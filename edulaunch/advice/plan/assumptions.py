"""Replacements for missing packages in a dry run, and a list of what is missing."""

from __future__ import annotations

import os
from collections.abc import Sequence
from shutil import which
from typing import TYPE_CHECKING, Any

from edulaunch.engine.underlay_place import underlay_prefix

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class Assumptions:
    """Replaces missing packages, programs, commands and files in a dry run, and records every request for them.

    :param placeholders: the prefix that contains the placeholder packages.
    :ivar packages: the names of missing packages, in the order in which launch asked for them.
    :ivar others: descriptions of missing programs, commands and files.
    """

    def __init__(self, placeholders: str) -> None:
        self._placeholders = placeholders + os.sep
        self._programs: set[str] = set()
        self.packages: list[str] = []
        self.others: list[str] = []

    @property
    def share(self) -> str:
        """Return the folder that contains the share folders of the placeholders, with a separator at its end."""
        return os.path.join(self._placeholders, 'share', '')

    def package(self, name: str) -> None:
        """Record that launch asked for a missing package."""
        if name not in self.packages:
            self.packages.append(name)

    def program(self, name: str) -> str:
        """Record a program that is not on PATH. Return its name, which launch uses in place of a path."""
        self._programs.add(name)
        self._note(f'program {name}')
        return name

    def output_of(self, argv: Sequence[str], path: str | None) -> str | None:
        """Return an empty string as the output of a command whose program or file is missing.

        Return None if the command can run.
        """
        if not argv:
            return None
        lacking = any(self._is_missing(word) for word in argv)
        unknown = argv[0] in self._programs or (argv[0] != 'ros2' and which(argv[0], path=path) is None)
        if not lacking and not unknown:
            return None
        self._note(f'output of the command {" ".join(map(self.shown, argv))}')
        return ''

    def lacks_file(self, path: str) -> bool:
        """Return whether a file belongs to a placeholder package, so that it cannot exist. If so, record the request."""
        missing = self._is_missing(path)
        if missing:
            self._note(f'file {self.shown(path)}')
        return missing

    def shown(self, path: str) -> str:
        """Return a short form of a path.

        The short form is 'package/rest' inside a placeholder package, the name for a program of edulaunch, and otherwise the
        path itself.
        """
        if os.path.dirname(path) == os.path.join(underlay_prefix(), 'bin'):
            return os.path.basename(path)
        if not path.startswith(self._placeholders):
            return path
        inside = path[len(self._placeholders) :]
        return inside[len('share/') :] if inside.startswith('share/') else inside

    def _is_missing(self, path: str) -> bool:
        return path.startswith(self._placeholders) and not os.path.exists(path)

    def _note(self, text: str) -> None:
        if text not in self.others:
            self.others.append(text)


def include_if_there(assumptions: Assumptions, action: Any, context: LaunchContext) -> Any:
    """Execute an IncludeLaunchDescription. If the file belongs to a placeholder package, only set the launch arguments.

    :raises Exception: the error that loading any other file raises.
    """
    try:
        return type(action).execute(action, context)
    except Exception:
        if not assumptions.lacks_file(action.launch_description_source.described_location):
            raise
        from launch.actions import SetLaunchConfiguration  # imported here, because this module may be loaded before launch

        return [SetLaunchConfiguration(name, value) for name, value in action.launch_arguments]
