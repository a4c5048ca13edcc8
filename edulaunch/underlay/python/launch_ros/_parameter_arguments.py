"""From evaluated parameters to the words of a node's command line."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from launch._engine import assumptions, generated_files, running_process, state_of

from ._generated_file import GeneratedFile, GeneratedParameters, temporary_path
from .parameter_descriptions import Parameter, ParameterFile
from .parameters_type import Parameters
from .utilities.evaluate_parameters import evaluate_parameter_dict

if TYPE_CHECKING:
    from pathlib import Path

    from launch.launch_context import LaunchContext

    from edulaunch.processes import Origin


class ParameterArguments:
    """The parameters of one node.

    Generated files are only named here and left with the host, which tells simulated programs what is in them.

    :param number: of the node's process; it keeps the files of equal nodes apart.
    :param node_name: the node's name as far as it is known.
    :param node_key: what stands above the values in generated files: the node's full name, or `/**`.
    :ivar items: (path, True) for a parameter file, (`name:=value`, False) for a single value, in order.
    """

    def __init__(self, number: int, node_name: str, node_key: str) -> None:
        self.items: list[tuple[str, bool]] = []
        self.missing_files: list[str] = []
        self._full_name = node_name.replace('<', '').replace('>', '')
        self._owner = f'{number} {node_name} {node_key}'
        self._node_key = node_key
        self._sources: list[tuple[Any, Any]] = []
        self._generated: list[GeneratedFile] = []
        self._has_files = False
        self._origins: dict[str, str] | None = None

    def add_global(self, entries: Iterable[str | tuple[str, Any]]) -> None:
        """What SetParameter and SetParametersFromFile left: pairs, and paths of files."""
        for entry in entries:
            if isinstance(entry, tuple):
                name, value = entry
                self.items.append((f'{name}:={value}', False))
                self._sources.append((name, entry))
            else:
                path = os.path.abspath(entry)
                assumed = assumptions()
                if assumed is not None and assumed.lacks_file(path):
                    self.missing_files.append(path)
                    continue
                assert os.path.isfile(path), f'{path} is not a file'
                self.items.append((path, True))
                self._has_files = True

    def add_own(self, context: LaunchContext, parameters: Parameters) -> None:
        """The node's own, normalized ones."""
        state, files = state_of(context), generated_files()
        for written in parameters:
            if isinstance(written, dict):
                values = evaluate_parameter_dict(context, written)
                name = temporary_path(f'{self._owner} {len(self.items)} {values}', state)
                self._add_generated(GeneratedParameters(name, self._node_key, values), files)
                self._sources.append((values, written))
            elif isinstance(written, ParameterFile):
                path, file = written.performed(context)
                if file is None:
                    self._add_file(path)
                else:
                    self._add_generated(file, files)
            else:
                self._add_rule(context, written)

    def write_files(self) -> None:
        """Put the generated files that :attr:`items` names on the disk, for somebody who looks."""
        for file in self._generated:
            file.write()

    def _add_generated(self, file: GeneratedFile, files: dict[str, Any]) -> None:
        self._generated.append(file)
        files[file.path] = file
        self.items.append((file.path, True))

    def _add_file(self, path: Path) -> None:
        if path.is_file():
            self.items.append((str(path), True))
            self._has_files = True
            return
        import launch.logging

        self.missing_files.append(str(path))
        launch.logging.get_logger('launch_ros.actions.node').warning(f'Parameter file path is not a file: {path}')

    def _add_rule(self, context: LaunchContext, parameter: Parameter) -> None:
        import yaml

        name, value = parameter.evaluate(context)
        self.items.append((f'{name}:={yaml.safe_dump(value)}', False))
        self._sources.append((name, parameter))

    def origins(self, node: Origin | None) -> dict[str, str]:
        """Parameter name -> where its value was written, for values that do not come from a parameter file.

        :param node: where the launch file made the node.
        """
        if self._origins is None:  # a plan, and a program that is started again, asks once more
            self._origins = self._found_origins(node)
        return self._origins

    def _found_origins(self, node: Origin | None) -> dict[str, str]:
        from ._parameter_origins import origin_of_global, origins_of

        found: dict[str, str] = {}
        for what, written in self._sources:
            if isinstance(what, dict):
                found.update(origins_of(what, written, node))
            elif isinstance(written, tuple):
                found[what] = origin_of_global(written)
            else:
                found.update(origins_of({what: None}, {what: written}, node))
        return self._without_overridden(found) if self._has_files else found

    def _without_overridden(self, origins: dict[str, str]) -> dict[str, str]:
        """Those whose value is not overridden by a parameter file, by the rules of rcl."""
        from edulaunch.graph.ros_arguments import RosArgumentsError, parse_ros_arguments

        words = [word for text, is_file in self.items for word in ('--params-file' if is_file else '-p', text)]
        try:
            given = parse_ros_arguments(['--ros-args', *words], running_process().host.parameter_entries)
        except (RosArgumentsError, OSError, ValueError):
            return origins  # the node says what is wrong
        values = given.overrides_for(self._full_name)
        return {
            name: text
            for name, text in origins.items()
            if name not in values or values[name].origin.startswith(('launch_params_', 'command line'))
        }
