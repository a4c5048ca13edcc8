"""Waiting for a program to say that it is ready."""

from .stdout_ready_listener import StdoutReadyListener

__all__ = ['StdoutReadyListener']
