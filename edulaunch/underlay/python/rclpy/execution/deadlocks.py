"""Waits that can never end: ROS 2 only hangs, here facts say who waits for what, and where. Advice is made of them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.processes.current import current_process
from edulaunch.processes.student_line import student_line
from rclpy.execution.names import callback_name, node_name
from rclpy.node_parts.core import core_of

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.node import Node
    from rclpy.readiness import Entity

POLLS = 5
"""How often one callback looks at a future, with simulated time passing in between, until that counts as waiting for it."""


def note_wait(waiting: str, entity: Any, line: dict[str, Any] | None = None) -> None:
    """Code that runs in a callback waits for what only `entity` can bring, which cannot while the callback goes on.

    :param waiting: how: 'call', 'look' (in a loop), 'await', or the function that spins.
    """
    _note('callback waits', entity, {'waiting': waiting, **entity.awaited()}, line)


def note_rate(entity: Entity) -> None:
    """`rate.sleep()` where nobody is left to call the rate's timer."""
    _note('rate in callback', entity, {})


def _note(kind: str, entity: Entity, data: dict[str, Any], line: dict[str, Any] | None = None) -> None:
    data = {'node': node_name(entity), 'callback': callback_name(_running_entity(entity)), **data}
    _keep(kind, {**data, **(student_line() if line is None else line)})


def note_spin(function: str, node: Node, executor: Executor) -> None:
    """A node is spun inside one of its callbacks; that brings nothing when all that could come is shut out by it."""
    core = core_of(node)
    others = [entity for kind in (core.timers, core.subscriptions, core.services, core.clients, core.guards) for entity in kind]
    in_vain = not any(entity.callback_group.can_execute(entity) for entity in others)
    _note_spin('spin in callback in vain' if in_vain else 'spin in callback', function, node, executor)


def note_lost_node(function: str, node: Node, executor: Executor) -> None:
    """A callback gives its node to another executor: the one that runs the callback will not spin it any more."""
    _note_spin('node taken away', function, node, executor)


def _note_spin(kind: str, function: str, node: Node, executor: Executor) -> None:
    data = {'node': core_of(node).full_name, 'callback': callback_name(executor.running_entity()), 'spins': function}
    _keep(kind, {**data, **student_line()})


def note_foreign_future(node: Node, entity: Any) -> None:
    """A node is spun until the client of another one, which nobody spins, gets its answer."""
    data = {'node': core_of(node).full_name, 'other': entity.node_name(), **entity.awaited()}
    _keep('other node spun', {**data, **student_line()})


def _keep(kind: str, data: dict[str, Any]) -> None:
    current_process().fact(kind, (data.get('file'), data.get('line')), data)


def _running_entity(entity: Entity) -> Any:
    executor = entity.ready_list.executor
    busy = entity.callback_group.busy_with
    return busy if busy is not None or executor is None else executor.running_entity()
