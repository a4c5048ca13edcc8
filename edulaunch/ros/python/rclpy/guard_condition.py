"""Guard conditions, whose callback is called when the program triggers them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from rclpy.impl.entity import GUARD, Entity, Handle, ReadyList
from rclpy.impl.refusals import invalid_handle
from rclpy.task import is_coroutine_function

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.context import Context
    from rclpy.impl.protocols import ExecutorProtocol


class GuardCondition(Entity):
    """A guard condition, created by `Node.create_guard_condition`. After `trigger()`, the executor calls the callback once."""

    rcl_category = GUARD

    def __init__(
        self,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup,
        context: Context | None = None,
        *,
        ready_list: ReadyList | None = None,
        number: int = 0,
    ) -> None:
        super().__init__(ready_list or ReadyList(), callback_group, number)
        self.callback = callback
        self.rcl_is_async = is_coroutine_function(callback)

    @property
    def handle(self) -> Handle:
        """The guard condition itself, because it has no separate handle."""
        return Handle(self, lambda: self.destroyed)

    def trigger(self) -> None:
        """Make the executor call the callback. Several triggers before the call count as one trigger. Raise InvalidHandle after
        destroy.
        """
        if self.destroyed:
            raise invalid_handle()
        self.rcl_signal()

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        return self.callback() if self.callback is not None and not self.destroyed else None

    def destroy(self) -> None:
        """Destroy the guard condition. Later triggers raise InvalidHandle."""
        self.destroyed = True


__getattr__ = passed_on(__name__)
