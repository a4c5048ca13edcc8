"""The words of a node's command line that say its name and namespace."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch.substitutions.local_substitution import LocalSubstitution

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class _SpecificArgument(LocalSubstitution):
    """One of the context's local `ros_specific_arguments`, which a node sets when it is executed."""

    def __init__(self, key: str, description: str) -> None:
        super().__init__(f"ros_specific_arguments['{key}']", description=description)
        self._key = key

    def perform(self, context: LaunchContext) -> str:
        """As the base class, without compiling an expression."""
        arguments: dict[str, str] = context.local('ros_specific_arguments')
        return arguments[self._key]


NODE_NAME = _SpecificArgument('name', 'node name')
NODE_NAMESPACE = _SpecificArgument('ns', 'node namespace')
