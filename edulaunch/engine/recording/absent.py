"""Errors for questions about missing parts of a recording. In a notebook, the traceback of such an error
shows only the message.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from edulaunch.engine.recording.records import Frame
from edulaunch.errors import EdulaunchError


class NotRecorded(EdulaunchError, KeyError):
    """A recording contains nothing with the requested name."""


class NothingToDraw(EdulaunchError, ValueError):
    """A recording contains nothing that the requested picture could show."""


def not_recorded(text: str, name: str, among: Iterable[str]) -> NotRecorded:
    """Return the error for an unknown name. Its message lists the known names, and its help suggests the nearest name.

    :param text: a description of the missing thing that ends with its name.
    :param name: the unknown name.
    :param among: the known names.
    """
    from difflib import get_close_matches

    names = list(dict.fromkeys(among))
    near = get_close_matches(name, names, n=1)
    return NotRecorded(
        f'{text} in this recording; there are: {", ".join(names) or "none"}', help=f'did you mean {near[0]!r}?' if near else None
    )


class NodeParameters(dict[str, Any]):
    """The parameters of a node, by name.

    The error for an unknown name lists the known names. If the node has ended, the help of the error states when.
    """

    def __init__(self, node: str, ended_s: float | None) -> None:
        super().__init__()
        self._node, self._ended_s = node, ended_s

    def __missing__(self, name: str) -> Any:
        error = not_recorded(f'no parameter {name!r} of {self._node}', name, self)
        if self._ended_s is not None:
            error.help = f'{self._node} ended at {self._ended_s:.2f} s: look at what it printed last'
        raise error


class NoMessages(list[Any]):
    """The empty list of messages of an unknown topic. Reading an item raises an error that lists the known topics.

    For code that counts or iterates, it is an ordinary empty list, because a run without this topic is a valid result, too.
    """

    def __init__(self, topic: str, among: Iterable[str]) -> None:
        super().__init__()
        self._topic, self._among = topic, among

    def __getitem__(self, which: Any) -> Any:
        if isinstance(which, slice):
            return []
        raise not_recorded(f'no topic {self._topic!r}', self._topic, self._among)


class RecordedFrames(dict[str, Frame]):
    """The tf frames at a time, by name. The error for an unknown name lists the known names."""

    def __missing__(self, name: str) -> Frame:
        raise not_recorded(f'no tf frame {name!r}', name, self)
