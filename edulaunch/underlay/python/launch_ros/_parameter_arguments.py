"""From evaluated parameters to the words of a node's command line."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from launch.substitutions.launch_configuration import LaunchConfiguration

from ._temporary_files import TemporaryFiles
from .parameter_descriptions import Parameter
from .parameters_type import Parameters
from .utilities import evaluate_parameters

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
    :ivar origins: parameter name -> where its value was written, for values that do not come from a file.
    """

    def __init__(self, node_name: str, node_key: str, origin: Origin | None) -> None:
        self.items: list[tuple[str, bool]] = []
        self.origins: dict[str, str] = {}
        self._node_key = node_key
        self._here = (
            'launch file' if origin is None else f'{os.path.basename(origin.file)} line {origin.line}'
        )
        self._files = TemporaryFiles(f'{node_name} {self._here}')

    def add_global(self, entries: Iterable[str | tuple[str, Any]]) -> None:
        """What SetParameter and SetParametersFromFile left: pairs, and paths of files."""
        for entry in entries:
            if isinstance(entry, tuple):
                name, value = entry
                self.items.append((f'{name}:={value}', False))
                self.origins[name] = 'SetParameter'
            else:
                path = os.path.abspath(entry)
                assert os.path.isfile(path), f'{path} is not a file'
                self.items.append((path, True))

    def add_own(self, context: LaunchContext, parameters: Parameters) -> None:
        """The node's own, normalized ones."""
        for written, value in zip(parameters, evaluate_parameters(context, parameters), strict=False):
            if isinstance(value, dict):
                self.items.append((self._write(value), True))
                self._note_origins(value, written)
            elif isinstance(value, Parameter):
                self._add_rule(context, value)
            else:
                self._add_file(value)

    def _add_file(self, path: Path) -> None:
        if path.is_file():
            self.items.append((str(path), True))
            return
        import launch.logging

        launch.logging.get_logger('launch_ros.actions.node').warning(
            f'Parameter file path is not a file: {path}'
        )

    def _add_rule(self, context: LaunchContext, parameter: Parameter) -> None:
        import yaml

        name, value = parameter.evaluate(context)
        self.items.append((f'{name}:={yaml.safe_dump(value)}', False))
        self.origins[name] = self._here

    def _write(self, values: dict[str, Any]) -> str:
        import yaml

        plain = {name: list(value) if isinstance(value, tuple) else value for name, value in values.items()}
        content = {self._node_key: {'ros__parameters': plain}}
        dumper = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)
        return self._files.write(
            yaml.dump(content, Dumper=dumper, default_flow_style=False, allow_unicode=True)
        )

    def _note_origins(self, values: dict[str, Any], written: Any) -> None:
        """Name and written value stand in the same order in both dicts, unless two names came out equal."""
        if len(values) != len(written):
            self.origins.update(dict.fromkeys(values, self._here))
            return
        for name, value in zip(values, written.values(), strict=False):
            self.origins[name] = _argument_in(value) or self._here


def _argument_in(value: Any) -> str | None:
    """'launch argument x', when a launch configuration decides the value."""
    value = getattr(value, 'value', value)
    for part in value if isinstance(value, (list, tuple)) else (value,):
        if isinstance(part, LaunchConfiguration):
            names = [getattr(text, 'text', '') for text in part.variable_name]
            return f'launch argument {"".join(names)}'
        if isinstance(part, (list, tuple)):
            found = _argument_in(part)
            if found is not None:
                return found
    return None
