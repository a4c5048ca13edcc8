"""A node with a managed lifecycle."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import launch.logging
from launch._engine import running_process
from launch.event_handler import EventHandler
from launch.substitution import SomeSubstitutionsType

from ..events.lifecycle.change_state import ChangeState
from ..events.lifecycle.state_transition import StateTransition
from ..ros_adapters import call_service, get_ros_node
from .node import Node

if TYPE_CHECKING:
    from launch.event import Event
    from launch.launch_context import LaunchContext
    from launch.launch_description_entity import LaunchDescriptionEntity


class LifecycleNode(Node):
    """A Node whose state launch can observe and change.

    The transitions of the node are emitted as :class:`launch_ros.events.lifecycle.StateTransition` events. A
    :class:`launch_ros.events.lifecycle.ChangeState` event requests a transition. Both events use the node's topic
    `transition_event` and service `change_state`.

    :raises RuntimeError: on execution, when the launch file does not set the name or the namespace.
    """

    def __init__(self, *, name: SomeSubstitutionsType, namespace: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__subscription: Any = None
        self.__current_state: int | None = None

    @property
    def is_lifecycle(self) -> bool:
        """Whether this is a lifecycle node, which is always true."""
        return True

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the node, subscribe to its transitions, and handle ChangeState events."""
        self._perform_substitutions(context)
        if not self.is_node_name_fully_specified():
            raise RuntimeError('node_name unexpectedly incomplete for lifecycle node')
        from lifecycle_msgs.msg import TransitionEvent

        def on_transition(msg: Any) -> None:
            self.__current_state = msg.goal_state.id
            context.asyncio_loop.call_soon_threadsafe(context.emit_event_sync, StateTransition(action=self, msg=msg))

        self.__subscription = get_ros_node(context).create_subscription(
            TransitionEvent, f'{self.node_name}/transition_event', on_transition, 10
        )
        context.register_event_handler(
            EventHandler(
                matcher=lambda event: isinstance(event, ChangeState) and event.lifecycle_node_matcher(self),
                entities=[_change_state_action(self)],
            )
        )
        return super().execute(context)


def _change_state_action(node: LifecycleNode) -> LaunchDescriptionEntity:
    """Return an action that sends the request of the current ChangeState event."""
    from launch.actions.opaque_function import OpaqueFunction

    def send(context: LaunchContext) -> None:
        event: Event = context.locals.event
        context.add_completion_future(context.asyncio_loop.create_task(_change_state(context, node, event)))

    return OpaqueFunction(function=send)


async def _change_state(context: LaunchContext, node: LifecycleNode, event: Any) -> None:
    logger = launch.logging.get_logger(node.process_description.final_name)
    imagined = running_process().state.get('launch.change_state')  # in a plan, no node is running
    is_done = await _ask(context, node, event) if imagined is None else imagined(context, node, event.transition_id)
    if is_done is None:
        logger.warning(f"Abandoning wait for the '{node.node_name}/change_state' service response, due to shutdown.")
    elif not is_done:
        logger.error(
            f"Failed to make transition '{ChangeState.valid_transitions[event.transition_id]}' "
            f"for LifecycleNode '{node.node_name}'"
        )


async def _ask(context: LaunchContext, node: LifecycleNode, event: Any) -> bool | None:
    """Return whether the node has made the transition. Return None if launch shuts down before the node replies."""
    from lifecycle_msgs.srv import ChangeState as ChangeStateService

    request: Any = ChangeStateService.Request()
    request.transition.id = event.transition_id
    response = await call_service(context, ChangeStateService, f'{node.node_name}/change_state', request)
    return None if response is None else bool(response.success)
