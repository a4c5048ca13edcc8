"""The methods of a node that create and destroy timers and rates."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.frame_owner import student_line
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy.constants import S_TO_NS
from rclpy.impl.own_names import FOR_TIMERS, check_own_names
from rclpy.node_parts.core import NodeCore
from rclpy.timer import Rate, Timer

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock

SHORT_NS, LONG_NS = 100_000, 45_000_000_000
"""The limits of plausible periods of timers."""
MANY_TIMERS = 12
"""The number of timers at which a node checks whether one line creates them again and again."""


class NodeTimers:
    """The part of `Node` that creates and destroys timers and rates."""

    _rclpy: NodeCore

    @property
    def timers(self) -> Iterator[Timer]:
        """All timers of the node."""
        yield from self._rclpy.timers

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer. Its callback is first called one period from now.

        :param clock: the clock of the timer; None means the node's clock.
        :param autostart: if False, the timer is cancelled until `reset()` is called.
        """
        check_callback(self._rclpy, callback, 'create_timer')
        check_own_names(self, FOR_TIMERS)  # type: ignore[arg-type]  # a Node inherits this class
        return _new_timer(self._rclpy, timer_period_sec, callback, callback_group, clock, autostart)

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate of `frequency` hertz. Raise ValueError unless `frequency` is positive."""
        if frequency <= 0:
            raise ValueError('frequency must be > 0')
        from rclpy.callback_groups import MutuallyExclusiveCallbackGroup

        timer = _new_timer(self._rclpy, 1.0 / frequency, None, MutuallyExclusiveCallbackGroup(), clock, True)
        rate = Rate(timer, context=self._rclpy.context)
        self._rclpy.rates.append(rate)
        return rate

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer. Return whether it belonged to this node."""
        return destroy_entity(self._rclpy.timers, timer)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate."""
        if rate in self._rclpy.rates:
            self._rclpy.rates.remove(rate)
        if rate.timer in self._rclpy.timers:
            self._rclpy.timers.remove(rate.timer)
        rate.destroy()
        return True


def _new_timer(
    core: NodeCore,
    period_s: float,
    callback: Callable[[], Any] | None,
    group: CallbackGroup | None,
    clock: Clock | None,
    autostart: bool,
) -> Timer:
    period_ns = int(float(period_s) * S_TO_NS)
    if period_ns >= 2**63:
        raise TypeError(f'__init__(): incompatible constructor arguments: a period must fit into 64 bits, not {period_ns} ns')
    if period_ns < 0:
        raise RCLError('failed to create timer: timer period must be non-negative')
    core.check_context('failed to create timer')
    group = group or core.default_callback_group
    timer = Timer(
        callback,
        group,
        period_ns,
        clock or core.clock,
        context=core.context,
        autostart=autostart,
        ready_list=core.ready_list,
        number=core.next_number(),
    )
    group.add_entity(timer)
    core.timers.append(timer)
    if not SHORT_NS <= period_ns <= LONG_NS:
        _note_period(core, timer)
    if len(core.timers) % MANY_TIMERS == 0:
        _note_many(core, timer)
    return timer


def _note_many(core: NodeCore, timer: Timer) -> None:
    """Record that many running timers of a node call the function of the newest timer."""
    from rclpy.impl.facts import callback_name

    name = callback_name(timer)
    same = sum(callback_name(one) == name and not one.is_canceled() for one in core.timers)
    if same > MANY_TIMERS // 2:
        data = {'node': core.full_name, 'callback': name, 'count': same}
        core.process.fact('timers pile up', (core.entry.index, name), {**data, **student_line()})


def _note_period(core: NodeCore, timer: Timer) -> None:
    """Record an improbable period: 0, or minutes where the program probably means milliseconds."""
    from rclpy.impl.facts import callback_name

    data = {'node': core.full_name, 'callback': callback_name(timer), 'period_s': timer.timer_period_ns / 1e9}
    core.process.fact('timer period', (core.entry.index, timer.order), {**data, **student_line()})


def check_callback(core: NodeCore, callback: Any, function: str) -> None:
    """Record that a program passed the result of `self.tick()` in place of `self.tick`. ROS 2 does not report this mistake."""
    if callback is not None:
        return
    line = student_line()
    data = {'node': core.full_name, 'function': function, 'file': line.get('file'), 'line': line.get('line')}
    core.process.fact('callback missing', (core.entry.index, core.next_number()), data)


def destroy_entity(entities: list[Any], entity: Any) -> bool:
    if entity not in entities:
        return False
    entities.remove(entity)
    try:
        entity.destroy()
    except InvalidHandle:
        return False
    return True
