"""A container for composable nodes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.some_substitutions_type import SomeSubstitutionsType

from ..descriptions import ComposableNode
from .node import Node

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext
    from launch.launch_description_entity import LaunchDescriptionEntity


class ComposableNodeContainer(Node):
    """A Node that nodes are loaded into once it runs.

    :param composable_node_descriptions: what to load; nothing when there are none.
    :param kwargs: those of :class:`launch_ros.actions.Node`.
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        composable_node_descriptions: list[ComposableNode] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__composable_node_descriptions = composable_node_descriptions

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the container, and load those nodes whose condition holds."""
        load_actions: list[LaunchDescriptionEntity] = []
        wanted = [
            description
            for description in self.__composable_node_descriptions or ()
            if (condition := description.condition()) is None or condition.evaluate(context)
        ]
        if wanted:
            from .load_composable_nodes import LoadComposableNodes

            load_actions = [LoadComposableNodes(composable_node_descriptions=wanted, target_container=self)]
        actions = super().execute(context)
        return [*(actions or ()), *load_actions] or None
