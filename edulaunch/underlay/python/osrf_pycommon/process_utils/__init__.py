"""Event loops and programs."""
from .async_execute_process import get_loop
from .impl import which

__all__ = ['get_loop', 'which']
