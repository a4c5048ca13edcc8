"""Waits that can never end, put into words: ROS 2 only hangs, here the recording says who waits for what, and where."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.processes.current import current_process
from rclpy.execution.names import callback_name, node_name
from rclpy.impl.student_place import student_place
from rclpy.node_parts.core import core_of

if TYPE_CHECKING:
    from rclpy.executors import Executor
    from rclpy.node import Node
    from rclpy.readiness import Entity

LATER = 'Use {}_async() with add_done_callback(), or give the {} a callback group of its own and spin a MultiThreadedExecutor.'
INSTEAD = 'Use add_done_callback() in place of waiting, or async and await with the client in a callback group of its own.'
POLLS = 5
"""How often one callback looks at a future, with simulated time passing in between, until that counts as waiting for it."""


def note_wait(waiting: str, entity: Entity, awaited: str, advice: str, place: str = '') -> None:
    """Note that code running in a callback waits, by `waiting`, for what only `entity` can bring: `awaited`."""
    callback = _name_of(_running_entity(entity))
    current_process().note(
        'deadlock',
        (
            f'{waiting} in {callback} of node {_node_of(entity)}{place or student_place()} waits for ever: {awaited} can only be '
            f'taken when {callback} has ended. {advice}'
        ),
    )


def note_call(call: str, entity: Any, kind: str) -> None:
    """Note a blocking call of a service or action client."""
    note_wait(f'{call}()', entity, entity.awaited_words(), LATER.format(call.rpartition('.')[2], f'{kind} client'))


def note_future_wait(waiting: str, entity: Any, place: str = '') -> None:
    """Note that a callback waits for a future of a service or action client: by spinning, looking in a loop, or await."""
    note_wait(waiting, entity, entity.awaited_words(), INSTEAD, place)


def note_spin(function: str, node: Node, executor: Executor) -> None:
    """Note that a node is spun inside one of its callbacks; that brings nothing when all that could come is shut out by it."""
    core = core_of(node)
    others = [entity for kind in (core.timers, core.subscriptions, core.services, core.clients, core.guards) for entity in kind]
    callback = _name_of(executor.running_entity())
    start = f"{function}() in {callback} of node '{core_of(node).full_name}'{student_place()}"
    if any(entity.callback_group.can_execute(entity) for entity in others):
        current_process().note(
            'nested spin',
            (
                f'{start}: until {callback} has ended no other callback of its group can run. '
                'Use add_done_callback(), or async and await.'
            ),
        )
    else:
        current_process().note(
            'deadlock',
            (
                f'{start} cannot bring anything: all callbacks of the node are in the callback group of {callback} and wait for '
                f'its end. Return from {callback} and let the next message or timer go on.'
            ),
        )


def note_lost_node(function: str, node: Node, executor: Executor) -> None:
    """Note that a callback gives its node to another executor: the one that runs the callback will not spin it any more."""
    callback = _name_of(executor.running_entity())
    current_process().note(
        'nested spin',
        (
            f"{function}() in {callback} of node '{core_of(node).full_name}'{student_place()} takes the node out of the executor "
            'that '
            f'runs {callback}, which does not spin it any more afterwards. Use add_done_callback(), or async and await.'
        ),
    )


def note_foreign_future(node: Node, entity: Any) -> None:
    """Note that a node is spun until the client of another one, which nobody spins, gets its answer."""
    current_process().note(
        'deadlock',
        (
            f"rclpy.spin_until_future_complete() of node '{core_of(node).full_name}'{student_place()} waits for ever: "
            f"{entity.awaited_words()} comes to a client of another node, which nobody spins. Spin the client's node."
        ),
    )


def note_rate(entity: Entity) -> None:
    """Note a `rate.sleep()` where nobody is left to call the rate's timer."""
    callback = _name_of(_running_entity(entity))
    current_process().note(
        'deadlock',
        (
            f'rate.sleep() in {callback} of node {_node_of(entity)}{student_place()} waits for ever: the executor that would '
            'call '
            f'the timer of the rate is busy with {callback}. Let a timer call you, or spin in another thread.'
        ),
    )


def _running_entity(entity: Entity) -> Any:
    executor = entity.ready_list.executor
    busy = entity.callback_group.busy_with
    return busy if busy is not None or executor is None else executor.running_entity()


def _name_of(entity: Any) -> str:
    """The name of an entity's callback, as people call it."""
    name = callback_name(entity)
    return 'a callback' if name is None else 'a lambda' if name == '<lambda>' else f'{name}()'


def _node_of(entity: Entity) -> str:
    name = node_name(entity)
    return '?' if name is None else f"'{name}'"
