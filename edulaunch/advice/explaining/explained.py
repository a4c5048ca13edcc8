"""The function `edulaunch.explain(file)` and its results."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any

from edulaunch.advice.explaining.tree import drawn, html_tree
from edulaunch.advice.plan import rehearse
from edulaunch.advice.plan.explanation import differences, explanation_of
from edulaunch.engine.packages.discovery import folder_of, workspaces_of_command
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.recording.views import view
from edulaunch.runtime.launching import find_launch_file
from edulaunch.runtime.session import Session

if TYPE_CHECKING:
    from edulaunch.advice.explaining.systems import System
    from edulaunch.advice.plan import Rehearsal
    from edulaunch.advice.plan.explanation import Entry
    from edulaunch.engine.recording import Recording

MOMENT_S = 0.5


def declared_parameters(package: str, executable: str, workspaces: Sequence[str]) -> dict[str, Any]:
    """Return the parameters of a program's first node with their defaults.

    The program runs for a moment in a separate simulation. Return an empty dictionary if the program fails before it creates
    a node.
    """
    with Session(workspaces=workspaces) as session:
        session.host.start(ProcessSpec(argv=('ros2', 'run', package, executable), name=executable))
        session.run(MOMENT_S)
        recording = session.recording()
        for node in recording.nodes:
            found = recording.parameters(node.name)
            if found:
                return {name: parameter.value for name, parameter in found.items()}
    return {}


class Tree:
    """A tree of entries. In a notebook, each entry opens and closes; elsewhere, the tree consists of lines of text."""

    title: str
    entries: Any
    data: Any

    def __str__(self) -> str:
        return '\n'.join((self.title, *drawn(self.entries)))

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return html_tree(self.title, self.entries)

    @property
    def alt(self) -> str:
        """Return the tree as text, for users of a screen reader."""
        return str(self)


class Explanation(Tree):
    """The explanation of a launch file: its includes, arguments, conditions and nodes, and the origin of every value."""

    def __init__(self, rehearsal: Rehearsal, workspaces: Sequence[str]) -> None:
        self._rehearsal = rehearsal
        self._workspaces = workspaces
        self.title = rehearsal.plan['file']

    @cached_property
    def data(self) -> Entry:
        """The explanation as plain data (see :mod:`edulaunch.advice.plan.explanation`)."""
        return explanation_of(self._rehearsal)

    @cached_property
    def entries(self) -> list[Entry]:
        """The entries of the tree."""
        tree: list[Entry] = self.data['tree']
        return tree

    def __str__(self) -> str:
        error = self.data['error']
        return super().__str__() + ('' if error is None else f'\nerror: {error["text"]}')

    __repr__ = __str__

    def _repr_html_(self) -> str:
        error = self.data['error']
        return super()._repr_html_() + ('' if error is None else f'<p><b>error:</b> {escape(error["text"])}</p>')

    @property
    def plan(self) -> dict[str, Any]:
        """The result of the dry run in plan format 1."""
        return self._rehearsal.plan

    @property
    def missing(self) -> tuple[list[str], list[str]]:
        """The names of missing packages, and descriptions of other missing things, that the dry run assumed to exist."""
        return self._rehearsal.missing

    def system(self, earlier: Recording | None = None) -> System:
        """Return the nodes, endpoints and frames that the launch file plans (see :mod:`edulaunch.advice.explaining.systems`).

        :param earlier: the recording of an earlier run, whose nodes determine the endpoints, or None.
        """
        from edulaunch.advice.explaining.systems import planned_system

        with Session(workspaces=self._workspaces) as session:
            return planned_system(self.plan, session.index, earlier, _subject(self))

    def graph(self, earlier: Recording | None = None, *, services: bool = False) -> Any:
        """Return a picture of :meth:`system` (see :func:`edulaunch.canvas.plot_system`).

        :param earlier: the same as for :meth:`system`.
        :param services: whether to draw services, too.
        """
        return view('plot_system')(self.system(earlier), services=services)

    def why(self, name: str, parameter: str | None = None) -> Reason:
        """Return the reason for the value of a node's parameter or of a launch argument.

        :param name: the name of a node ('/sim'). Without `parameter`, it may also be the name of a launch argument.
        :param parameter: the name of the parameter, or None for all parameters of the node.
        :raises UnusableInput: when the name does not exist. The error suggests the most similar name.
        """
        from edulaunch.advice.explaining.reasons import reasons

        return Reason(reasons(self._rehearsal.outline, name, parameter, self._declared))

    def compare(self, other: Explanation) -> Comparison:
        """Return the differences from another launch file, or from the same launch file with other arguments."""
        return Comparison(self, other)

    def _declared(self, package: str, executable: str) -> dict[str, Any]:
        return declared_parameters(package, executable, self._workspaces)


class Comparison(Tree):
    """The differences between two explanations. `data` is a list of entries, and each entry has a `sign`."""

    def __init__(self, before: Explanation, after: Explanation) -> None:
        self._both = before, after
        self.data = self.entries = differences(before.data, after.data)
        self.title = f'{_subject(before)}  ->  {_subject(after)}' + ('' if self.entries else '\nno difference')

    def graph(self, *, services: bool = False) -> Any:
        """Return a picture of both plans and their differences (see :func:`edulaunch.canvas.plot_system`).

        :param services: whether to draw services, too.
        """
        from edulaunch.advice.explaining.systems import pictured

        before, after = self._both
        return pictured(before.system(), after.system(), services=services)


def _subject(explanation: Explanation) -> str:
    words_of_arguments = ' '.join(f'{name}:={value}' for name, value in explanation.data['given'].items())
    return ' '.join(filter(None, (os.path.basename(explanation.data['file']), words_of_arguments)))


class Reason(Tree):
    """The chain of values that led to a value.

    Each item of `data` has `name`, `value` and `steps` (see :mod:`edulaunch.advice.plan.why`).
    """

    def __init__(self, data: list[dict[str, Any]]) -> None:
        from edulaunch.advice.explaining.reasons import rendered_reasons

        self.data = data
        self.title, self.entries = rendered_reasons(data)


def _name_sources(plan: dict[str, Any], source_path: Callable[[str], str]) -> None:
    """Replace the links of a generated prefix in a plan by the paths of the student's own files."""
    plan['file'] = source_path(plan['file'])
    here = os.path.join(os.getcwd(), '')
    for item in plan['items']:
        if item['kind'] == 'include':
            item['file'] = source_path(item['file']).removeprefix(here)
    file, colon, line = ((plan['error'] or {}).get('origin') or '').rpartition(':')
    if colon:
        plan['error']['origin'] = f'{source_path(file)}:{line}'


def explain(
    path_or_package: str | os.PathLike[str],
    file: str | None = None,
    *,
    arguments: Mapping[str, object] | None = None,
    workspaces: Sequence[str | os.PathLike[str]] = (),
    assume_packages: bool = False,
) -> Explanation:
    """Return what a launch file would do, without starting a program.

    The result is a tree of includes, decisions and actions. Each value has its origin, and the values that it replaced.

    :param path_or_package: the path of a launch file, or the name of a package.
    :param file: the name of a launch file in the package.
    :param arguments: the launch arguments by name.
    :param workspaces: folders with packages (default: the workspaces of the current folder).
    :param assume_packages: whether to replace missing packages by empty packages and continue.
    :raises UnusableInput: when there is no such file or package.
    """
    where = workspaces_of_command(workspaces, path_or_package)
    with Session(workspaces=where, near=folder_of(path_or_package)) as session:
        path = find_launch_file(session.index, path_or_package, file)
        values = {name: str(value) for name, value in (arguments or {}).items()}
        host = session.host
        rehearsal = rehearse(path, values, session.index, host.env, assume_packages=assume_packages, command_set=host.command_set)
        _name_sources(rehearsal.plan, session.index.source_path)
    return Explanation(rehearsal, where)
