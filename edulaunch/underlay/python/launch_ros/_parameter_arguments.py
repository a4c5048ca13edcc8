"""From evaluated parameters to the words of a node's command line."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ._parameter_text import parameter_file_text
from ._temporary_files import TemporaryFiles
from .parameter_descriptions import Parameter
from .parameters_type import Parameters
from .utilities.evaluate_parameters import evaluate_parameters

if TYPE_CHECKING:
    from pathlib import Path

    from launch.launch_context import LaunchContext

    from edulaunch.processes import Origin


class ParameterArguments:
    """The parameters of one node.

    :param node_name: the node's name as far as it is known.
    :param node_key: what stands above the values in generated files: the node's full name, or `/**`.
    :param origin: where the launch file made the node.
    :ivar items: (path, True) for a parameter file, (`name:=value`, False) for a single value, in order.
    """

    def __init__(self, node_name: str, node_key: str, origin: Origin | None) -> None:
        self.items: list[tuple[str, bool]] = []
        self._node_key = node_key
        self._origin = origin
        place = 'launch file' if origin is None else f'{os.path.basename(origin.file)} line {origin.line}'
        self._files = TemporaryFiles(f'{node_name} {place}')
        self._sources: list[tuple[Any, Any]] = []

    def add_global(self, entries: Iterable[str | tuple[str, Any]]) -> None:
        """What SetParameter and SetParametersFromFile left: pairs, and paths of files."""
        for entry in entries:
            if isinstance(entry, tuple):
                name, value = entry
                self.items.append((f'{name}:={value}', False))
                self._sources.append((name, entry))
            else:
                path = os.path.abspath(entry)
                assert os.path.isfile(path), f'{path} is not a file'
                self.items.append((path, True))

    def add_own(self, context: LaunchContext, parameters: Parameters) -> None:
        """The node's own, normalized ones."""
        for written, value in zip(parameters, evaluate_parameters(context, parameters), strict=True):
            if isinstance(value, dict):
                self.items.append((self._promise(value), True))
                self._sources.append((value, written))
            elif isinstance(value, Parameter):
                self._add_rule(context, value)
            else:
                self._add_file(value)

    def keep_promises(self) -> None:
        """Write the generated files that :attr:`items` names."""
        self._files.keep_promises()

    def _promise(self, values: dict[str, Any]) -> str:
        key = self._node_key
        return self._files.promise(f'{key}\n{values}', lambda: parameter_file_text(key, values))

    def _add_file(self, path: Path) -> None:
        if path.is_file():
            self.items.append((str(path), True))
            self._sources.append((path, None))
            return
        import launch.logging

        launch.logging.get_logger('launch_ros.actions.node').warning(
            f'Parameter file path is not a file: {path}'
        )

    def _add_rule(self, context: LaunchContext, parameter: Parameter) -> None:
        import yaml

        name, value = parameter.evaluate(context)
        self.items.append((f'{name}:={yaml.safe_dump(value)}', False))
        self._sources.append((name, parameter))

    def origins(self) -> dict[str, str]:
        """Parameter name -> where its value was written, for values that do not come from a file."""
        from ._parameter_origins import origin_of_global, origins_of, names_in_file

        found: dict[str, str] = {}
        for what, written in self._sources:
            if isinstance(what, dict):
                found.update(origins_of(what, written, self._origin))
            elif not isinstance(what, str):
                for name in names_in_file(what):
                    found.pop(name, None)
            elif isinstance(written, tuple):
                found[what] = origin_of_global(written)
            else:
                found.update(origins_of({what: None}, {what: written}, self._origin))
        return found
