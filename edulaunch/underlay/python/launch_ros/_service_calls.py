"""Service calls of launch's own node, awaited in launch's event loop."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .ros_adapters import get_ros_node

if TYPE_CHECKING:
    import asyncio

    from launch.launch_context import LaunchContext


async def call_service(context: LaunchContext, service_type: Any, name: str, request: Any) -> Any:
    """Wait for the service, then for its answer; None when launch shuts down before there is one."""
    from launch.event_handlers.general import OnShutdown

    from edulaunch.processes import current_process

    loop = context.asyncio_loop
    node = get_ros_node(context)
    client = node.create_client(service_type, name)
    answer: asyncio.Future[Any] = loop.create_future()

    def ask() -> None:
        client.wait_for_service()
        future = client.call_async(request)
        future.add_done_callback(lambda done: loop.call_soon_threadsafe(_settle, answer, done.result()))

    abandon = OnShutdown(on_shutdown=lambda *_: _settle(answer, None))
    context.register_event_handler(abandon)
    thread = current_process().start_thread(ask, name, daemon=True)
    try:
        return await answer
    finally:
        thread.kill()
        node.destroy_client(client)
        context.unregister_event_handler(abandon)


def _settle(answer: asyncio.Future[Any], value: Any) -> None:
    if not answer.done():
        answer.set_result(value)
