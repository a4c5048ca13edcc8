"""A timer on ROS time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from launch.actions.timer_action import TimerAction
from launch.events.timer_event import TimerEvent
from launch.utilities.type_utils import perform_typed_substitution

from ..ros_adapters import get_ros_node

if TYPE_CHECKING:
    import asyncio

    from launch.launch_context import LaunchContext
    from launch.launch_description_entity import LaunchDescriptionEntity


class ROSTimer(TimerAction):
    """A TimerAction whose period is measured with the clock of launch's own node. After SetUseSimTime(True), this clock is
    `/clock`.

    :param period: the seconds to wait, as a float, a string or substitutions.
    """

    def __init__(self, *, period: Any, actions: Iterable[LaunchDescriptionEntity], **kwargs: Any) -> None:
        super().__init__(period=period, actions=actions, **kwargs)

    async def _wait_to_fire_event(self, context: LaunchContext) -> None:
        assert self._canceled_future is not None and self._completed_future is not None
        try:
            if await self.__fires(context):
                await context.emit_event(TimerEvent(timer_action=self))
        except Exception as error:
            self._completed_future.set_exception(error)
        else:
            self._completed_future.set_result(None)

    async def __fires(self, context: LaunchContext) -> bool:
        """Wait for the period. Return False if the timer was cancelled."""
        import asyncio

        loop, node = context.asyncio_loop, get_ros_node(context)
        fired: asyncio.Future[None] = loop.create_future()

        def fire() -> None:
            if not fired.done():
                fired.set_result(None)

        period: Any = perform_typed_substitution(context, self.period, float)
        timer = node.create_timer(period, lambda: loop.call_soon_threadsafe(fire))
        assert self._canceled_future is not None
        await asyncio.wait([fired, self._canceled_future], return_when=asyncio.FIRST_COMPLETED)
        node.destroy_timer(timer)
        return not self._canceled_future.done()


RosTimer = ROSTimer
