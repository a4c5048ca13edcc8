"""Timers, and the rates that are based on them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy.exceptions import ROSInterruptException
from rclpy.impl.entity import NEVER_NS, TIMER, Handle, ReadyList, TimedEntity
from rclpy.impl.refusals import invalid_handle
from rclpy.process_state import process_state
from rclpy.task import is_coroutine_function

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.context import Context
    from rclpy.impl.protocols import ExecutorProtocol


class Timer(TimedEntity):
    """Calls its callback on an exact grid of nanoseconds. The first call is one period after the creation of the timer.

    The timer skips grid points that have passed when the executor checks it. `Node.create_timer` creates timers.

    :ivar _next_ns: the next grid point, in the clock's own time.
    :ivar rcl_due_ns: the same point in simulated time; `NEVER_NS` while the timer is cancelled, or while it depends on /clock.
    """

    rcl_category = TIMER

    def __init__(
        self,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup,
        timer_period_ns: int,
        clock: Clock,
        *,
        context: Context | None = None,
        autostart: bool = True,
        ready_list: ReadyList | None = None,
        number: int = 0,
    ) -> None:
        super().__init__(ready_list or ReadyList(), callback_group, number)
        self.callback = callback
        self.rcl_is_async = is_coroutine_function(callback)
        self._clock = clock
        self._period_ns = timer_period_ns
        self._canceled = not autostart
        self._last_ns = clock.rcl_now_ns()
        self._next_ns = self._last_ns + timer_period_ns
        self.rcl_due_ns = NEVER_NS
        self._credit_ns = 0
        clock.timers.append(self)
        self.ready_list.timers.append(self)
        self._plan()

    clock: ReadOnly[Clock] = ReadOnly('The clock that the timer goes by.', '_clock')

    @property
    def handle(self) -> Handle:
        """The object that owns the timer."""
        return Handle(self, lambda: self.destroyed)

    @property
    def timer_period_ns(self) -> int:
        """The period in nanoseconds. A new period applies after the next call."""
        self._check()
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        self._period_ns = int(value)

    def _plan(self) -> None:
        """Compute when the timer is due in simulated time, and make the executor check again."""
        if self._canceled:
            self.rcl_due_ns = NEVER_NS
        elif self._clock.override_ns is None:
            self.rcl_due_ns = self._next_ns
        else:
            self.rcl_due_ns = 0 if self._next_ns <= self._clock.override_ns else NEVER_NS
        self.ready_list.plan()
        self.ready_list.notify()

    def rcl_clock_jumped(self, before_ns: int, source_changed: bool) -> None:
        """Handle a time jump as rcl does. A forward jump past the grid point makes the timer ready once. A backward jump
        restarts the timer.

        As in rcl, a new time source uses the remaining time as if it were the elapsed time. Time 0 counts as unknown.
        """
        now = self._clock.rcl_now_ns()
        if source_changed:
            if before_ns:
                self._credit_ns = self._next_ns - before_ns
            if now and self._credit_ns:
                self._last_ns = now - self._credit_ns
                self._next_ns = self._last_ns + self._period_ns
                self._credit_ns = 0
        elif now < self._next_ns and now < self._last_ns:
            self._last_ns = now
            self._next_ns = now + self._period_ns
        self._plan()

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        if self._canceled or self.destroyed:
            return None
        clock = self._clock
        now = clock.sim.now_ns if clock.override_ns is None else clock.override_ns
        period = self._period_ns
        next_ns = self._next_ns
        if next_ns > now:
            return None
        next_ns += period
        if next_ns <= now:
            next_ns = now + period - (now - next_ns) % period if period else now
            if clock.override_ns is None and period:
                self._note_skipped(now)
        self._last_ns = now
        self._next_ns = next_ns
        self.rcl_due_ns = next_ns if clock.override_ns is None or next_ns <= now else NEVER_NS
        self.ready_list.plan()
        self.ready_list.notify()
        return self.callback()  # type: ignore[misc]  # None ends the program, as in ROS 2

    def _note_skipped(self, now_ns: int) -> None:
        """Record that the executor called the timer at least one whole period late, because something blocked the executor."""
        from rclpy.impl.facts import callback_name, node_name

        late_s = round((now_ns - self._next_ns) / 1e9, 9)
        data = {'callback': callback_name(self), 'node': node_name(self), 'period_s': self._period_ns / 1e9, 'late_s': late_s}
        process_state().process.fact('timer skipped', self.order, data)

    def cancel(self) -> None:
        """Stop calling the callback until `reset` is called."""
        self._check()
        self._canceled = True
        self._plan()

    def reset(self) -> None:
        """Restart the timer. The next call is one period from now."""
        self._check()
        self._canceled = False
        self._next_ns = self._clock.rcl_now_ns() + self._period_ns
        self._plan()

    def is_ready(self) -> bool:
        """Return whether the next call is due."""
        self._check()
        return not self._canceled and self._next_ns <= self._clock.rcl_now_ns()

    def is_canceled(self) -> bool:
        """Return whether the timer was cancelled."""
        self._check()
        return self._canceled

    def time_until_next_call(self) -> int | None:
        """Return the nanoseconds until the next call. The value is negative if the call is overdue, and None while the timer is
        cancelled.
        """
        self._check()
        return None if self._canceled else self._next_ns - self._clock.rcl_now_ns()

    def time_since_last_call(self) -> int:
        """Return the nanoseconds since the last call. Before the first call, return the nanoseconds since the creation."""
        self._check()
        return self._clock.rcl_now_ns() - self._last_ns

    def _check(self) -> None:
        if self.destroyed:
            raise invalid_handle()

    def destroy(self) -> None:
        """Destroy the timer. Prefer `Node.destroy_timer`."""
        if not self.destroyed:
            self.destroyed = True
            self.rcl_due_ns = NEVER_NS
            self._clock.timers.remove(self)
            self.ready_list.timers.remove(self)
            self.ready_list.plan()


class Rate:
    """A rate, created by `Node.create_rate`. `sleep()` waits for the next call of the rate's timer, so another thread must
    spin.
    """

    def __init__(self, timer: Timer, *, context: Context) -> None:
        self._clock = timer.clock
        self.timer = timer
        self._context = context
        self._is_destroyed = False
        self._has_called = False
        self._sleepers = 0
        timer.callback = self._on_call

    def _on_call(self) -> None:
        self._has_called = True
        for task in self._context.parked:
            task.wake()

    def destroy(self) -> None:
        """Destroy the rate, and wake the threads that sleep in `sleep()`."""
        self._is_destroyed = True
        self._on_call()
        self.timer.destroy()

    def sleep(self) -> None:
        """Wait for a call of the timer. As in ROS 2, a timer call before the wait ends the wait immediately.

        :raises ROSInterruptException: when ROS 2 is shut down during the wait.
        :raises RuntimeError: when the rate was destroyed before this method was called. If it is destroyed during the wait,
            the wait ends without an error.
        """
        self._check()
        executor = self.timer.ready_list.executor
        if not self._has_called and executor is not None and executor.rcl_cannot_serve(self.timer):
            from rclpy.impl.facts import note_rate

            note_rate(self.timer)
        self._sleepers += 1
        while not self._has_called and self._context.alive and not self._is_destroyed:
            self._context.rcl_park()
        self._sleepers -= 1
        self._has_called = self._has_called and self._sleepers > 0
        self._check_context()

    def _check(self) -> None:
        self._check_context()
        if self._is_destroyed:
            raise RuntimeError('Rate cannot sleep because it has been destroyed')

    def _check_context(self) -> None:
        if not self._context.alive:
            raise ROSInterruptException()


__getattr__ = passed_on(__name__)
