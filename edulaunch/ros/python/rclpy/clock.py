"""Clocks. All of them use simulated time, and /clock can control ROS time (`use_sim_time`)."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from edulaunch.engine.sim.task import current_task
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy._rclpy_pybind11 import RCLError
from rclpy.clock_type import ClockType, TypeOfTime
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.impl.c_enum import CEnum
from rclpy.impl.entity import Handle
from rclpy.time import Time, time_of_clock
from rclpy.utilities import get_default_context

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.timer import Timer

__all__ = ['Clock', 'ClockChange', 'ClockType', 'Duration', 'JumpHandle', 'JumpThreshold', 'ROSClock', 'Time', 'TimeJump']


class ClockChange(IntEnum):
    """The change of a clock's source in a time jump.

    In every version of Python, a member prints as its number, as in the Python version of ROS 2 Jazzy.
    """

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4

    __str__ = int.__repr__


class _ReportedChange(CEnum):
    """The change in the form that ROS 2's C++ passes to callbacks. It prints as `ClockChange.MEMBER`."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


_ReportedChange.__name__ = 'ClockChange'


class JumpThreshold:
    """The time jumps for which a callback is called.

    :param min_forward: the smallest forward jump (a positive Duration); None excludes forward jumps.
    :param min_backward: the smallest backward jump (a negative Duration); None excludes backward jumps.
    :param on_clock_change: whether the callback is called when the time source changes.
    :raises ValueError: for a duration of the wrong sign, or when no jump could call the callback.
    """

    def __init__(self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True) -> None:
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError('At least one jump threshold must be enabled')
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError('min_forward must be a positive non-zero duration')
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError('min_backward must be a negative non-zero duration')


class TimeJump:
    """A time jump in the form that callbacks receive."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError('clock_change must be an instance of rclpy.clock.ClockChange')
        self._clock_change: IntEnum = clock_change
        self._delta = delta

    clock_change: ReadOnly[IntEnum] = ReadOnly('How the time source changed.', '_clock_change')

    delta: ReadOnly[Duration] = ReadOnly('How far time jumped.', '_delta')


class JumpHandle:
    """A registered pair of jump callbacks. Store the handle: deleting it unregisters the callbacks."""

    def __init__(
        self,
        *,
        clock: Clock,
        threshold: JumpThreshold,
        pre_callback: Callable[[], object] | None,
        post_callback: Callable[[TimeJump], object] | None,
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError('One of pre_callback or post_callback must be callable')
        if pre_callback is not None and not callable(pre_callback):
            raise ValueError('pre_callback must be callable if given')
        if post_callback is not None and not callable(post_callback):
            raise ValueError('One of pre_callback or post_callback must be callable')  # ROS 2 prints the same message
        self._limits = (threshold.min_forward, threshold.min_backward, threshold.on_clock_change)
        self.pre_callback = pre_callback
        self.post_callback = post_callback
        self._clock: Clock | None = clock
        clock.jump_handles.append(self)

    def _is_reached(self, change: ClockChange, delta_ns: int) -> bool:
        """Return whether a jump of `delta_ns` reaches the threshold."""
        forward, backward, on_clock_change = self._limits
        if change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return on_clock_change
        return bool(
            (forward is not None and delta_ns >= forward.nanoseconds)
            or (backward is not None and delta_ns <= backward.nanoseconds)
        )

    def unregister(self) -> None:
        """Unregister the callbacks."""
        if self._clock is not None:
            self._clock.jump_handles.remove(self)
            self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(self, *_: Any) -> None:
        self.unregister()


class Clock:
    """A clock of the given kind. `Clock(clock_type=ClockType.ROS_TIME)` returns a :class:`ROSClock`."""

    _clock_type: ClockType

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, (ClockType, TypeOfTime)):
            raise TypeError('Clock type must be a ClockType enum')
        self = super().__new__(ROSClock if clock_type == ClockType.ROS_TIME else cls)
        self._clock_type = ClockType(clock_type)
        self.sim = current_task().sim
        self.override_ns = None
        self._received_ns = 0
        self.jump_handles = []
        self.timers = []
        return self

    sim: Any
    override_ns: int | None
    _received_ns: int
    jump_handles: list[JumpHandle]
    timers: list[Timer]

    clock_type: ReadOnly[ClockType] = ReadOnly('The kind of this clock.', '_clock_type')

    @property
    def handle(self) -> Handle:
        """The object that owns the clock."""
        return Handle(self)

    def __repr__(self) -> str:
        return f'Clock(clock_type={self._clock_type.name})'

    def now(self) -> Time:
        """Return the current time."""
        current_task().poll()
        if not self._clock_type:
            raise RCLError('failed to get current clock value: Clock is not initialized or does not have get_now registered.')
        override = self.override_ns
        return time_of_clock(self.sim.now_ns if override is None else override, self._clock_type)

    def rcl_now_ns(self) -> int:
        """Return the current time in nanoseconds. This call does not count as a check of the clock in a busy loop."""
        override: int | None = self.override_ns
        if override is not None:
            return override
        if self.sim.keep_up is not None:
            self.sim.keep_up()
        now: int = self.sim.now_ns
        return now

    def create_jump_callback(
        self,
        threshold: JumpThreshold,
        *,
        pre_callback: Callable[[], object] | None = None,
        post_callback: Callable[[TimeJump], object] | None = None,
    ) -> JumpHandle:
        """Register functions that the clock calls before and after time jumps."""
        return JumpHandle(clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Wait until this clock reaches `until`.

        While /clock controls the clock, only a message of /clock ends the wait, even for a time in the past (as in ROS 2).

        :returns: True if the clock reached `until`; False if the context was shut down or the time source changed before that.
        :raises NotInitializedException: before init.
        :raises ValueError: when `until` belongs to another kind of clock.
        """
        context = context or get_default_context()
        if not context.alive:
            raise NotInitializedException()
        if until.clock_type != self._clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        active = self.override_ns is not None
        task = current_task()
        jumps: list[TimeJump] = []

        def jumped(jump: TimeJump) -> None:
            jumps.append(jump)
            task.wake()

        handle = self.create_jump_callback(
            JumpThreshold(min_forward=Duration(nanoseconds=1), min_backward=Duration(nanoseconds=-1)), post_callback=jumped
        )
        with handle:
            while (
                context.alive
                and (self.override_ns is not None) is active
                and (self.rcl_now_ns() < until.nanoseconds or (active and not jumps))
            ):
                context.rcl_park(None if active else until.nanoseconds)
        return context.alive and self.rcl_now_ns() >= until.nanoseconds and (self.override_ns is not None) is active

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        """Wait for a duration; see :meth:`sleep_until`."""
        return self.sleep_until(self.now() + rel_time, context)


class ROSClock(Clock):
    """The clock of nodes: simulated time, or the time of /clock while `use_sim_time` is true."""

    def __new__(cls) -> ROSClock:
        clock = super().__new__(cls, clock_type=ClockType.ROS_TIME)
        assert isinstance(clock, ROSClock)
        return clock

    @property
    def ros_time_is_active(self) -> bool:
        """Whether /clock controls the clock."""
        return self.override_ns is not None

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        """Start to follow /clock from its last time (0 if there was none), or stop following it."""
        if enabled == self.ros_time_is_active:
            return
        change = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
        self._jump(change, self._received_ns if enabled else None)

    def set_ros_time_override(self, time: Time) -> None:
        """Set the time that the clock shows while /clock controls the clock. Raise TypeError for an object that is not a Time."""
        if not isinstance(time, Time):
            raise TypeError(f'Time must be specified as rclpy.time.Time. Received type: {type(time)}')
        self._received_ns = time.nanoseconds
        if self.ros_time_is_active:
            self._jump(ClockChange.ROS_TIME_NO_CHANGE, time.nanoseconds)

    def _jump(self, change: ClockChange, override_ns: int | None) -> None:
        before = self.rcl_now_ns()
        # As in rcl, a change of the source is reported without the size of the time jump.
        delta = override_ns - before if change is ClockChange.ROS_TIME_NO_CHANGE and override_ns is not None else 0
        handles = [handle for handle in self.jump_handles if handle._is_reached(change, delta)]
        for handle in handles:
            if handle.pre_callback is not None:
                handle.pre_callback()
        self.override_ns = override_ns
        for timer in list(self.timers):
            timer.rcl_clock_jumped(before, change is not ClockChange.ROS_TIME_NO_CHANGE)
        for handle in handles:
            if handle.post_callback is not None:
                jump = TimeJump(change, Duration(nanoseconds=delta))
                jump._clock_change = _ReportedChange(change)
                handle.post_callback(jump)


__getattr__ = passed_on(__name__)
