"""Functions that run the dry run of a launch file and return its plan."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import NamedTuple

from edulaunch.advice.plan.assumptions import Assumptions
from edulaunch.advice.plan.planner import Plan, Planner
from edulaunch.advice.plan.titles import Branch
from edulaunch.engine.packages import Index
from edulaunch.engine.packages.workspace import Image
from edulaunch.engine.processes.commands import CommandSet
from edulaunch.errors import UnusableInput


class AssumingIndex(Index):
    """An index that adds an empty placeholder for each missing package, and accepts every executable.

    The placeholders are in a temporary folder that is deleted with this object.

    :param real: the index that contains the existing packages.
    :ivar assumptions: the assumptions that the index has made.
    """

    def __init__(self, real: Index) -> None:
        super().__init__((), (), underlay=None)
        self._places = [*real._places]
        self._image = Image('placeholders')
        self.assumptions = Assumptions(self._image.path)

    def search_paths(self) -> list[str]:
        """Return the real search paths, followed by the folder of the placeholders."""
        return [*super().search_paths(), self._image.path]

    def prefix(self, package: str) -> str:
        """Return the prefix of an existing package. For a missing package, create a placeholder and return its prefix."""
        found = super().prefix(package)
        if found is not None:
            return found
        self.assumptions.package(package)
        self._image.add_folder(os.path.join('share', package))
        return self._image.path

    def find_executable(self, package: str, executable: str) -> str:
        """Return the path that the executable would have. The path may not exist."""
        return os.path.join(self.prefix(package), 'lib', package, executable)


class Rehearsal(NamedTuple):
    """The result of a dry run.

    :ivar plan: the plan in plan format 1: plain data with sorted keys. It has `arguments` (declared), `configurations` (after the
        first visit), `given`, `items`, `log`, `warnings`, `stdout` and `shutdown_reason`. After an error, `error` has type, text,
        stage, origin and help. `not_done` lists the changes that the dry run did not make.
    :ivar outline: the plan as a tree for users, including the actions that were not executed.
    :ivar missing: the names of the packages that were assumed to exist, and descriptions of other missing things.
    :ivar placeholders: the share folder of the assumed packages, or None if the dry run assumes no packages.
    :ivar read: the names of the launch configurations that substitutions have read, in order.
    """

    plan: Plan
    outline: Branch
    missing: tuple[list[str], list[str]]
    placeholders: str | None
    read: list[str]


def rehearse(
    path: str | os.PathLike[str],
    arguments: Mapping[str, str] | Iterable[str],
    index: Index,
    environ: Mapping[str, str],
    *,
    assume_packages: bool = False,
    command_set: CommandSet | None = None,
) -> Rehearsal:
    """Return what `ros2 launch path arguments...` would do.

    :param path: the path of the launch file.
    :param arguments: the launch arguments, as a mapping or as strings 'name:=value'.
    :param index: the index of the packages.
    :param environ: the environment variables of launch.
    :param assume_packages: whether to assume an empty share folder for every missing package, and to accept every executable.
    :param command_set: the tools and the shell for commands whose output the launch file needs. By default, no command runs.
    :raises UnusableInput: for an argument that does not have the form 'name:=value'.
    """
    by_name = _by_name(arguments)
    assuming = AssumingIndex(index) if assume_packages else None
    planner = Planner(os.path.abspath(os.fspath(path)), by_name, assuming or index, environ, command_set)
    planner.assumptions = None if assuming is None else assuming.assumptions
    plan = planner.plan()
    missing = planner.assumptions
    if missing is None:
        return Rehearsal(plan, planner.outline, ([], []), None, list(planner.read))
    return Rehearsal(plan, planner.outline, (missing.packages, missing.others), missing.share, list(planner.read))


def _by_name(arguments: Mapping[str, str] | Iterable[str]) -> dict[str, str]:
    if isinstance(arguments, Mapping):
        return dict(arguments)
    by_name = {}
    for text in arguments:
        name, separator, value = text.partition(':=')
        if not (name and separator and value):
            raise UnusableInput(f"malformed launch argument '{text}', expected format '<name>:=<value>'")
        by_name[name] = value
    return by_name
