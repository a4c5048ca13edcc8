"""Errors that carry a line of help beside ROS 2's own text, shown when the error ends its program."""

from __future__ import annotations

from typing import TypeVar

SHUT_DOWN = 'ROS 2 has been shut down already (by rclpy.shutdown() or Ctrl-C)'

Error = TypeVar('Error', bound=BaseException)


def hinted(error: Error, hint: str | None) -> Error:
    """Give an error its line of help; the error's own text stays ROS 2's."""
    if hint is not None:
        error.edulaunch_hint = hint  # type: ignore[attr-defined]
    return error
