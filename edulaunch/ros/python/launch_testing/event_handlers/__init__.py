"""An event handler that waits until a program prints that it is ready."""

from .stdout_ready_listener import StdoutReadyListener

__all__ = ['StdoutReadyListener']
