"""Service calls of launch's own node, awaited in launch's event loop."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .ros_adapters import get_ros_node

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_POLL_S = 0.1


async def call_service(context: LaunchContext, service_type: Any, name: str, request: Any) -> Any:
    """Wait for the service, then for its answer; None when launch shuts down before there is one."""
    import asyncio
    client = get_ros_node(context).create_client(service_type, name)
    try:
        while not client.service_is_ready():
            if context.is_shutdown:
                return None
            await asyncio.sleep(_POLL_S)
        future = client.call_async(request)
        while not future.done():
            if context.is_shutdown:
                client.remove_pending_request(future)
                return None
            await asyncio.sleep(_POLL_S / 10)
        return future.result()
    finally:
        get_ros_node(context).destroy_client(client)
