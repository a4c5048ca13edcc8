"""Converts evaluated parameters to the words of a node's command line."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from launch._engine import assumptions, generated_files, inside, running_process, state_of

from ._generated_file import GeneratedFile, GeneratedParameters, temporary_path
from ._parameter_origins import Given, ParameterOrigins, given_by_file, given_by_global, given_by_launch_file, in_force
from .parameter_descriptions import Parameter, ParameterFile
from .parameters_type import Parameters
from .utilities.evaluate_parameters import evaluate_parameter_dict

if TYPE_CHECKING:
    from pathlib import Path

    from launch.launch_context import LaunchContext

    from edulaunch.engine.processes import Origin


NO_NAMESPACE = '<node_namespace_unspecified>'
"""The value in a node action for the namespace that the program chooses, which is nearly always the root."""


class ParameterArguments:
    """The parameters of one node.

    This module only names generated files. The host stores the files, and passes their content to simulated programs.

    :param number: the number of the node's process, which distinguishes the files of nodes with the same name.
    :param node_name: the node's name as far as it is known.
    :param node_key: the key above the values in generated files: the node's full name, or `/**`.
    :ivar items: (path, True) for a parameter file, (`name:=value`, False) for a single value, in order.
    """

    def __init__(self, number: int, node_name: str, node_key: str) -> None:
        self.items: list[tuple[str, bool]] = []
        self.missing_files: list[str] = []
        self._full_name = node_name.replace(f'{NO_NAMESPACE}/', '/').replace('<', '').replace('>', '')
        self._owner = f'{number} {node_name} {node_key}'
        self._node_key = node_key
        self._sources: list[tuple[Any, Any]] = []
        self._generated: list[GeneratedFile] = []
        self._entries_of = running_process().host.parameter_entries
        self._origins: ParameterOrigins | None = None

    def add_global(self, entries: Iterable[str | tuple[str, Any]]) -> None:
        """Add the names and values of SetParameter and the paths of SetParametersFromFile."""
        for entry in entries:
            if isinstance(entry, tuple):
                name, value = entry
                self._add((f'{name}:={value}', False), written=entry)
            else:
                path = os.path.abspath(inside(entry))
                assumed = assumptions()
                if assumed is not None and assumed.lacks_file(path):
                    self.missing_files.append(path)
                    continue
                assert os.path.isfile(path), f'{path} is not a file'
                self._add((path, True))

    def add_own(self, context: LaunchContext, parameters: Parameters) -> None:
        """Add the node's own normalized parameters."""
        state, files = state_of(context), generated_files()
        for written in parameters:
            if isinstance(written, dict):
                values = evaluate_parameter_dict(context, written)
                name = temporary_path(f'{self._owner} {len(self.items)} {values}', state)
                self._add_generated(GeneratedParameters(name, self._node_key, values), files, values, written)
            elif isinstance(written, ParameterFile):
                path, file = written.performed(context)
                if file is None:
                    self._add_file(path)
                else:
                    self._add_generated(file, files)
            else:
                self._add_rule(context, written)

    def write_files(self) -> None:
        """Write the generated files in :attr:`items` to the disk."""
        for file in self._generated:
            file.write()

    def _add(self, item: tuple[str, bool], values: dict[str, Any] | None = None, written: Any = None) -> None:
        self.items.append(item)
        self._sources.append((values, written))

    def _add_generated(self, file: GeneratedFile, files: dict[str, Any], values: Any = None, written: Any = None) -> None:
        self._generated.append(file)
        files[file.path] = file
        self._add((file.path, True), values, written)

    def _add_file(self, path: Path) -> None:
        if os.path.isfile(inside(path)):
            self._add((str(path), True))
            return
        import launch.logging

        self.missing_files.append(str(path))
        launch.logging.get_logger('launch_ros.actions.node').warning(f'Parameter file path is not a file: {path}')

    def _add_rule(self, context: LaunchContext, parameter: Parameter) -> None:
        import yaml

        name, value = parameter.evaluate(context)
        self._add((f'{name}:={yaml.safe_dump(value)}', False), {name: value}, {name: parameter})

    def in_force(self, node: Origin | None) -> list[Given]:
        """Return all values that are given for this node's parameters. If a parameter has several values, the last value
        counts.

        :param node: the place in the launch file that created the node.
        """
        found: list[Given] = []
        for (text, is_file), (values, written) in zip(self.items, self._sources, strict=True):
            if isinstance(written, dict):
                found += given_by_launch_file(self._node_key if is_file else '/**', values, written, node)
            else:
                found += given_by_file(text, self._entries_of) if is_file else given_by_global(written)
        return in_force(found, self._full_name)

    def origins(self, node: Origin | None) -> ParameterOrigins:
        """Return the place of each value by parameter name, for values that do not come from a parameter file.

        :param node: the place in the launch file that created the node.
        """
        if self._origins is None:  # computed once, although plans and restarted programs need it again
            self._origins = ParameterOrigins(lambda: self.in_force(node))
        return self._origins
