"""Event loops and programs."""

from typing import TYPE_CHECKING, Any

from .async_execute_process import async_execute_process, get_loop
from .execute_process_nopty import execute_process, execute_process_split
from .impl import which

if TYPE_CHECKING:
    from .async_subprocess_protocol import AsyncSubprocessProtocol

__all__ = ['async_execute_process', 'AsyncSubprocessProtocol', 'execute_process', 'execute_process_split', 'get_loop', 'which']


def __getattr__(name: str) -> Any:
    # It needs asyncio, which launch can do without until it runs.
    if name == 'AsyncSubprocessProtocol':
        from .async_subprocess_protocol import AsyncSubprocessProtocol

        return AsyncSubprocessProtocol
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
