"""Waits that can never end, put into words: ROS 2 only hangs, here the recording says who waits for what, and where."""
from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any

import edulaunch
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.readiness import Entity

ENGINE = os.path.dirname(os.path.abspath(edulaunch.__file__)) + os.sep
LATER = 'Use {}_async() with add_done_callback(), or give the {} a callback group of its own and spin a MultiThreadedExecutor.'
INSTEAD = 'Use add_done_callback() in place of waiting, or async and await with the client in a callback group of its own.'
POLLS = 5
"""How often one callback looks at a future, with simulated time passing in between, until that counts as waiting for it."""


def note_wait(waiting: str, entity: Entity, awaited: str, advice: str, place: str = '') -> None:
    """Note that code running in a callback waits, by `waiting`, for what only `entity` can bring: `awaited`."""
    callback = _name_of(_running_entity(entity))
    current_process().note('deadlock', (
        f'{waiting} in {callback} of node {_node_of(entity)}{place or _student_place()} waits for ever: {awaited} can only be '
        f'taken when {callback} has ended. {advice}'))


def note_call(call: str, entity: Any, kind: str) -> None:
    """Note a blocking call of a service or action client."""
    note_wait(f'{call}()', entity, entity._awaited_words(), LATER.format(call.rpartition('.')[2], f'{kind} client'))


def note_future_wait(waiting: str, entity: Any, place: str = '') -> None:
    """Note that a callback waits for a future of a service or action client: by spinning, by looking again and again, by await."""
    note_wait(waiting, entity, entity._awaited_words(), INSTEAD, place)


def note_rate(entity: Entity) -> None:
    """Note a `rate.sleep()` where nobody is left to call the rate's timer."""
    callback = _name_of(_running_entity(entity))
    current_process().note('deadlock', (
        f'rate.sleep() in {callback} of node {_node_of(entity)}{_student_place()} waits for ever: the executor that would call '
        f'the timer of the rate is busy with {callback}. Let a timer call you, or spin in another thread.'))


def _running_entity(entity: Entity) -> Any:
    executor = entity._ready_list.executor
    busy = entity.callback_group.busy_with
    return busy if busy is not None or executor is None else executor._running_entity()


def _name_of(entity: Any) -> str:
    """The name of an entity's callback, as people call it."""
    callback = getattr(entity, 'callback', None)
    while hasattr(callback, 'func'):
        callback = callback.func
    name = getattr(callback, '__name__', None)
    return 'a callback' if name is None else 'a lambda' if name == '<lambda>' else f'{name}()'


def _node_of(entity: Entity) -> str:
    executor = entity._ready_list.executor
    nodes = [] if executor is None else executor.get_nodes()
    return next((f"'{node.get_fully_qualified_name()}'" for node in nodes if node._rclpy.ready_list is entity._ready_list), '?')


def _student_place() -> str:
    """Where in the student's code the running call stands: ` (file.py:12)`."""
    frame = sys._getframe()
    while frame is not None and frame.f_code.co_filename.startswith((ENGINE, '<')):
        frame = frame.f_back   # type: ignore[assignment]
    return '' if frame is None else f' ({os.path.basename(frame.f_code.co_filename)}:{frame.f_lineno})'


def coroutine_place(coroutine: Any) -> str:
    """Where a coroutine waits, in the student's code."""
    place = ''
    while getattr(coroutine, 'cr_frame', None) is not None:
        file = coroutine.cr_frame.f_code.co_filename
        if not file.startswith((ENGINE, '<')):
            place = f' ({os.path.basename(file)}:{coroutine.cr_frame.f_lineno})'
        coroutine = coroutine.cr_await
    return place
