"""A timer on ROS time."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.actions.timer_action import TimerAction

from ..ros_adapters import get_ros_node

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext
    from launch.some_entities_type import SomeEntitiesType


class ROSTimer(TimerAction):
    """A TimerAction whose period counts on the clock of launch's own node: `/clock` when SetUseSimTime(True) came before.

    :param period: seconds, as a float, a text or substitutions.
    """

    def __init__(self, *, period: Any, actions: SomeEntitiesType, **kwargs: Any) -> None:
        super().__init__(period=period, actions=actions, **kwargs)

    async def _wait_to_fire_event(self, context: LaunchContext) -> None:
        import asyncio
        from launch.events.timer_event import TimerEvent
        node = get_ros_node(context)
        period = self._period_seconds(context)
        fired: asyncio.Future[None] = context.asyncio_loop.create_future()
        timer = node.create_timer(period, lambda: fired.done() or fired.set_result(None))
        try:
            done, _ = await asyncio.wait([fired, self._canceled_future], return_when=asyncio.FIRST_COMPLETED)
        finally:
            node.destroy_timer(timer)
        if fired in done:
            await context.emit_event(TimerEvent(timer_action=self))


RosTimer = ROSTimer
