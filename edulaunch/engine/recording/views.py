"""What other wings make of a recording: pictures and tables (canvas), findings and their words (advice), the replay (desk).

The engine makes none of these. A wing registers its views when it is imported; the facade sets the loader, which imports the wing
that has a view when somebody asks for it the first time.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine import outside

_VIEWS: dict[str, Callable[..., Any]] = {}


def register(**views: Callable[..., Any]) -> None:
    """Register views by name; a later one of the same name takes its place."""
    _VIEWS.update(views)


def view(name: str) -> Callable[..., Any]:
    """Return the view of that name."""
    if name not in _VIEWS:
        outside.load_view(name)
    return _VIEWS[name]


class Views:
    """The part of a recording that shows it. Every picture takes `ax=`, axes of matplotlib to draw on, and returns them."""

    def plot(self, topic: str, *fields: str, ax: Any = None) -> Any:
        """Numbers of a topic over time: `recording.plot('/turtle1/pose', 'x', 'y')`; see :func:`edulaunch.canvas.plot_series`."""
        return view('plot_series')(self, topic, *fields, ax=ax)

    def table(self, topic: str, *fields: str) -> Any:
        """The messages of a topic as a table; see :func:`edulaunch.canvas.table.message_table`."""
        return view('message_table')(self, topic, fields)

    def log_table(self, process: str | None = None, level: str = 'DEBUG', word: str = '') -> Any:
        """Log lines as a table: of one process, from a level up ('WARN'), with a word in them."""
        return view('log_table')(self, process, level, word)

    def plot_turtles(self, time_s: float | None = None, **looks: Any) -> Any:
        """The turtle windows at a time (default: the end); for `looks` see :func:`edulaunch.canvas.plot_turtles`."""
        return view('plot_turtles')(self, time_s, **looks)

    def plot_frames(self, time_s: float | None = None, *, side: str = 'xy', ax: Any = None) -> Any:
        """tf frames from above or from a side, at a time (default: the end); see :func:`edulaunch.canvas.plot_frames`."""
        return view('plot_frames')(self, time_s, side=side, ax=ax)

    def plot_tf_tree(self, *, ax: Any = None) -> Any:
        """Which frame is whose parent, and who broadcasts it; see :func:`edulaunch.canvas.plot_tf_tree`."""
        return view('plot_tf_tree')(self, ax=ax)

    def plot_graph(self, *, unused: bool = False, services: bool = False, ax: Any = None) -> Any:
        """Nodes and topics; see :func:`edulaunch.canvas.plot_graph`."""
        return view('plot_graph')(self, unused=unused, services=services, ax=ax)

    def plot_distance(self, first: str, second: str, close_m: float = 1.0, *, ax: Any = None) -> Any:
        """How far a turtle, robot or tf frame is from another over time; see :func:`edulaunch.canvas.plot_distance`."""
        return view('plot_distance')(self, first, second, close_m, ax=ax)

    def parameter_table(self, node: str | None = None, *, every: bool = False) -> Any:
        """Parameters with their values and where these came from; see :func:`edulaunch.canvas.parameter_table`."""
        return view('parameter_table')(self, node, every=every)

    def replay(self, other: Any = None) -> Any:
        """Everything of the run over time, with a slider; see :class:`edulaunch.desk.view.replay.Replay`.

        :param other: another recording, which the tab *Plot* draws over this one.
        """
        return view('replay')(self, other)
