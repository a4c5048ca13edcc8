"""The program of `KeepAliveProc`, which waits for SIGINT."""

from __future__ import annotations

import threading


def main() -> None:
    """Wait for SIGINT, and then end with exit code 0."""
    try:
        threading.Event().wait()
    except KeyboardInterrupt:
        return
