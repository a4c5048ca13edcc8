"""The actions `ComposableNodeContainer` and `LoadComposableNodes`, which use each other."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import launch.logging
from launch._engine import inside
from launch.action import Action
from launch.substitution import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import ensure_argument_type

from ..descriptions.composable_node import ComposableNode
from ..ros_adapters import call_service
from ..utilities.evaluate_parameters import evaluate_parameters
from ..utilities.namespace_utils import make_namespace_absolute, prefix_namespace
from ..utilities.to_parameters_list import to_parameters_list
from ..utilities.track_node_names import add_node_name, get_node_name_count
from .node import Node

if TYPE_CHECKING:
    from composition_interfaces.srv import LoadNode
    from launch.launch_context import LaunchContext
    from launch.launch_description_entity import LaunchDescriptionEntity

_LOGGER = 'launch_ros.actions.load_composable_nodes'


class ComposableNodeContainer(Node):
    """A container process into which other nodes are loaded.

    :param composable_node_descriptions: the nodes to load; an empty list loads nothing.
    :param kwargs: the arguments of :class:`launch_ros.actions.Node`.
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
        """Start the container, and load the nodes whose conditions are true."""
        load_actions: list[LaunchDescriptionEntity] = []
        wanted = [
            description
            for description in self.__composable_node_descriptions or ()
            if (condition := description.condition()) is None or condition.evaluate(context)
        ]
        if wanted:
            load_actions = [LoadComposableNodes(composable_node_descriptions=wanted, target_container=self)]
        actions = super().execute(context)
        return [*(actions or ()), *load_actions] or None


class LoadComposableNodes(Action):
    """Load nodes one after another into a container, with the container's service `<container>/_container/load_node`.

    :param target_container: the container action, or the container's full name.
    """

    def __init__(
        self,
        *,
        composable_node_descriptions: list[ComposableNode],
        target_container: SomeSubstitutionsType | ComposableNodeContainer,
        **kwargs: Any,
    ) -> None:
        ensure_argument_type(
            target_container,
            (*SomeSubstitutionsType_types_tuple, ComposableNodeContainer),
            'target_container',
            'LoadComposableNodes',
        )
        super().__init__(**kwargs)
        self.__composable_node_descriptions = composable_node_descriptions
        self.__target_container = target_container
        self.__final_target_container_name: str | None = None

    @property
    def descriptions_to_load(self) -> list[ComposableNode]:
        """The descriptions of the nodes, for code that inspects a launch file without running it."""
        return self.__composable_node_descriptions

    def execute(self, context: LaunchContext) -> None:
        """Create the requests while the scope exists, and send them when the container is available."""
        self.__final_target_container_name = self.__container_name(context)
        requests = [get_composable_node_load_request(description, context) for description in self.__composable_node_descriptions]
        wanted = [request for request in requests if request is not None]
        if wanted:
            context.add_completion_future(context.asyncio_loop.create_task(self.__load_all(context, wanted)))

    def __container_name(self, context: LaunchContext) -> str:
        target: Any = self.__target_container
        if not isinstance(target, ComposableNodeContainer):
            return perform_substitutions(context, normalize_to_list_of_substitutions(target))
        if target.is_node_name_fully_specified():
            return target.node_name
        launch.logging.get_logger(_LOGGER).warning(
            f"node name '{target.node_name}' is not fully specified; loading into the container may fail"
        )
        return target.node_name.replace(target.UNSPECIFIED_NODE_NAMESPACE, '')

    async def __load_all(self, context: LaunchContext, requests: list[LoadNode.Request]) -> None:
        for request in requests:
            if not await self.__load(context, request):
                return

    async def __load(self, context: LaunchContext, request: LoadNode.Request) -> bool:
        """Load one node. Return False if launch shuts down before the reply."""
        from composition_interfaces.srv import LoadNode

        logger = launch.logging.get_logger(_LOGGER)
        container = self.__final_target_container_name
        service = f'{container}/_container/load_node'
        response: Any = await call_service(context, LoadNode, service, request)
        if response is None:
            logger.warning(f"Abandoning wait for the '{service}' service, due to shutdown.")
            return False
        if not response.success:
            logger.error(
                f"Failed to load node '{response.full_node_name or request.node_name}' "
                f"of type '{request.plugin_name}' "
                f"in container '{container}': {response.error_message}"
            )
            return True
        name = response.full_node_name or request.node_name
        add_node_name(context, name)
        count = get_node_name_count(context, name)
        if count > 1:
            launch.logging.get_logger(container).warning(
                f'there are now at least {count} nodes with the name {name} created within this launch context'
            )
        logger.info(f"Loaded node '{response.full_node_name}' in container '{container}'")
        return True


def get_composable_node_load_request(
    composable_node_description: ComposableNode, context: LaunchContext
) -> LoadNode.Request | None:
    """Return the request that loads a node, with evaluated substitutions. Return None if the condition of the node is false."""
    condition = composable_node_description.condition()
    if condition is not None and not condition.evaluate(context):
        return None
    from composition_interfaces.srv import LoadNode

    request: Any = LoadNode.Request()
    request.package_name = perform_substitutions(context, composable_node_description.package)
    request.plugin_name = perform_substitutions(context, composable_node_description.node_plugin)
    if composable_node_description.node_name is not None:
        request.node_name = perform_substitutions(context, composable_node_description.node_name)
    request.node_namespace = _namespace(composable_node_description, context)
    request.remap_rules = _remap_rules(composable_node_description, context)
    request.parameters = _parameters(composable_node_description, request, context)
    if composable_node_description.extra_arguments is not None:
        evaluated = evaluate_parameters(context, composable_node_description.extra_arguments)
        request.extra_arguments = _messages(context, request, evaluated)
    made: LoadNode.Request = request
    return made


def _namespace(description: ComposableNode, context: LaunchContext) -> str:
    namespace = None if description.node_namespace is None else perform_substitutions(context, description.node_namespace)
    base = context.launch_configurations.get('ros_namespace')
    return make_namespace_absolute(prefix_namespace(base, namespace)) or ''


def _remap_rules(description: ComposableNode, context: LaunchContext) -> list[str]:
    rules = [f'{source}:={target}' for source, target in context.launch_configurations.get('ros_remaps', ())]
    return rules + [
        f'{perform_substitutions(context, source)}:={perform_substitutions(context, target)}'
        for source, target in description.remappings or ()
    ]


def _parameters(description: ComposableNode, request: Any, context: LaunchContext) -> list[Any]:
    from pathlib import Path

    evaluated: list[Any] = [
        dict([entry]) if isinstance(entry, tuple) else Path(inside(entry)).absolute()
        for entry in context.launch_configurations.get('global_params', ())
    ]
    if description.parameters is not None:
        evaluated += evaluate_parameters(context, description.parameters)
    return _messages(context, request, tuple(evaluated))


def _messages(context: LaunchContext, request: Any, evaluated: Any) -> list[Any]:
    parameters = to_parameters_list(context, request.node_name, request.node_namespace, evaluated)
    return [parameter.to_parameter_msg() for parameter in parameters]
