"""`edulaunch.explain(file)`."""

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
    """Return the default of each parameter of a program's first node, or {} if the program fails earlier."""
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
    """A tree of entries. A notebook shows it so that each entry can be opened; elsewhere it is shown as lines."""

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
        """Return the tree as text, for users who cannot see it."""
        return str(self)


class Explanation(Tree):
    """What a launch file does: its includes, arguments, conditions and nodes, and the origin of every value."""

    def __init__(self, rehearsal: Rehearsal, workspaces: Sequence[str]) -> None:
        self._rehearsal = rehearsal
        self._workspaces = workspaces
        self.title = rehearsal.plan['file']

    @cached_property
    def data(self) -> Entry:
        """The explanation as plain data; see :mod:`edulaunch.advice.plan.explanation`."""
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
        """The dry run in the plan format 1."""
        return self._rehearsal.plan

    @property
    def missing(self) -> tuple[list[str], list[str]]:
        """The names of packages and descriptions of other things that are missing and were assumed to exist."""
        return self._rehearsal.missing

    def system(self, earlier: Recording | None = None) -> System:
        """Return the nodes, endpoints and frames that the launch file plans; see :mod:`edulaunch.advice.explaining.systems`.

        :param earlier: an earlier run, from which its nodes get their endpoints.
        """
        from edulaunch.advice.explaining.systems import planned_system

        with Session(workspaces=self._workspaces) as session:
            return planned_system(self.plan, session.index, earlier, _subject(self))

    def graph(self, earlier: Recording | None = None, *, services: bool = False) -> Any:
        """Return a picture of :meth:`system`; see :func:`edulaunch.canvas.plot_system`."""
        return view('plot_system')(self.system(earlier), services=services)

    def why(self, name: str, parameter: str | None = None) -> Reason:
        """Return why a node's parameter, or a launch argument, has the value it has.

        :param name: the name of a node ('/sim'). Without `parameter`, it may also be the name of a launch argument.
        :raises UnusableInput: if that name does not exist; the error has the nearest name.
        """
        from edulaunch.advice.explaining.reasons import reasons

        return Reason(reasons(self._rehearsal.outline, name, parameter, self._declared))

    def compare(self, other: Explanation) -> Comparison:
        """Return the differences to another launch file, or to the same file with other arguments."""
        return Comparison(self, other)

    def _declared(self, package: str, executable: str) -> dict[str, Any]:
        return declared_parameters(package, executable, self._workspaces)


class Comparison(Tree):
    """The differences between two explanations. `data` is a list of entries that each have a `sign`."""

    def __init__(self, before: Explanation, after: Explanation) -> None:
        self._both = before, after
        self.data = self.entries = differences(before.data, after.data)
        self.title = f'{_subject(before)}  ->  {_subject(after)}' + ('' if self.entries else '\nno difference')

    def graph(self, *, services: bool = False) -> Any:
        """Return a picture of both plans, with what differs; see :func:`edulaunch.canvas.plot_system`."""
        from edulaunch.advice.explaining.systems import pictured

        before, after = self._both
        return pictured(before.system(), after.system(), services=services)


def _subject(explanation: Explanation) -> str:
    words_of_arguments = ' '.join(f'{name}:={value}' for name, value in explanation.data['given'].items())
    return ' '.join(filter(None, (os.path.basename(explanation.data['file']), words_of_arguments)))


class Reason(Tree):
    """The chain of values that led to a value. `data` has `name`, `value` and `steps`; see :mod:`edulaunch.advice.plan.why`."""

    def __init__(self, data: list[dict[str, Any]]) -> None:
        from edulaunch.advice.explaining.reasons import rendered_reasons

        self.data = data
        self.title, self.entries = rendered_reasons(data)


def _name_sources(plan: dict[str, Any], source_path: Callable[[str], str]) -> None:
    """Name the student's own files in a plan instead of the links of a generated prefix."""
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
    """Return what a launch file would do, as a tree, without starting anything.

    The result is a tree of its includes, decisions and actions. Each value has its origin, and the values that it replaced.

    :param path_or_package: path of a launch file, or name of a package.
    :param file: name of a launch file in the package.
    :param arguments: launch arguments by name.
    :param workspaces: folders with packages; by default, the workspaces of the current folder.
    :param assume_packages: continue if packages are missing, with empty packages instead.
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
