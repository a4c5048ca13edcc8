"""Errors for questions about missing parts of a recording: one message, without frames of edulaunch."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from edulaunch.engine.recording.records import Frame
from edulaunch.errors import EdulaunchError


class NotRecorded(EdulaunchError, KeyError):
    """There is nothing of that name in a recording."""


class NothingToDraw(EdulaunchError, ValueError):
    """A recording has nothing that a picture could show."""


def not_recorded(text: str, name: str, among: Iterable[str]) -> NotRecorded:
    """Return the error for an unknown name. It lists the known names, and the nearest one.

    :param text: a description of the missing thing that ends with its name.
    """
    from difflib import get_close_matches

    names = list(dict.fromkeys(among))
    near = get_close_matches(name, names, n=1)
    return NotRecorded(
        f'{text} in this recording; there are: {", ".join(names) or "none"}', help=f'did you mean {near[0]!r}?' if near else None
    )


class NodeParameters(dict[str, Any]):
    """The parameters of a node. The error for an unknown one lists them, and names the end of the node."""

    def __init__(self, node: str, ended_s: float | None) -> None:
        super().__init__()
        self._node, self._ended_s = node, ended_s

    def __missing__(self, name: str) -> Any:
        error = not_recorded(f'no parameter {name!r} of {self._node}', name, self)
        if self._ended_s is not None:
            error.help = f'{self._node} ended at {self._ended_s:.2f} s: look at what it printed last'
        raise error


class NoMessages(list[Any]):
    """The empty list of messages of a topic without publications. Asking for one of them raises an error that lists the topics.

    It is an empty list for code that counts or iterates, because a topic without messages is a valid result of a run, too.
    """

    def __init__(self, topic: str, among: Iterable[str]) -> None:
        super().__init__()
        self._topic, self._among = topic, among

    def __getitem__(self, which: Any) -> Any:
        if isinstance(which, slice):
            return []
        raise not_recorded(f'no topic {self._topic!r}', self._topic, self._among)


class RecordedFrames(dict[str, Frame]):
    """The tf frames at a time, by name; the error for an unknown one lists them."""

    def __missing__(self, name: str) -> Frame:
        raise not_recorded(f'no tf frame {name!r}', name, self)
