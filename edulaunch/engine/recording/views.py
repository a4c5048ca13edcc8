"""Views of a recording that other parts of edulaunch provide: pictures and tables (canvas), findings (advice), the replay (view).

The engine provides none of these views. A package registers its views when it is imported. `edulaunch.engine.outside` has the
function that imports the package of a view on first use.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from edulaunch.engine import outside

_VIEWS: dict[str, Callable[..., Any]] = {}


def register(**views: Callable[..., Any]) -> None:
    """Register views by name. A later view replaces an earlier view with the same name."""
    _VIEWS.update(views)


def view(name: str) -> Callable[..., Any]:
    """Return the view with this name, and import the package that registers it if necessary."""
    if name not in _VIEWS:
        outside.load_view(name)
    return _VIEWS[name]


class Views:
    """The methods with which a recording shows its content. Methods that draw with matplotlib accept `ax`, the axes to draw on,
    and return the axes.
    """

    def plot(self, topic: str, *fields: str, ax: Any = None) -> Any:
        """Plot numbers of a topic over time, such as `recording.plot('/turtle1/pose', 'x', 'y')`.

        The parameters `topic`, `fields` and `ax` are those of :func:`edulaunch.canvas.plot_series`.
        """
        return view('plot_series')(self, topic, *fields, ax=ax)

    def table(self, topic: str, *fields: str) -> Any:
        """Return the messages of a topic as a table.

        The parameters `topic` and `fields` are those of :func:`edulaunch.canvas.table.message_table`.
        """
        return view('message_table')(self, topic, fields)

    def log_table(self, process: str | None = None, level: str = 'DEBUG', word: str = '') -> Any:
        """Return log messages as a table.

        :param process: the launch name of a process (default: all processes).
        :param level: the lowest severity to show, such as 'WARN'.
        :param word: show only messages that contain this word.
        """
        return view('log_table')(self, process, level, word)

    def plot_turtles(self, time_s: float | None = None, **looks: Any) -> Any:
        """Draw the turtle windows at a given time.

        :param time_s: seconds since the start (default: the end of the run).
        :param looks: the other parameters of :func:`edulaunch.canvas.plot_turtles`.
        """
        return view('plot_turtles')(self, time_s, **looks)

    def plot_frames(self, time_s: float | None = None, *, side: str = 'xy', ax: Any = None) -> Any:
        """Draw tf frames from above or from a side, at a given time.

        The parameters `time_s`, `side` and `ax` are those of :func:`edulaunch.canvas.plot_frames`.
        """
        return view('plot_frames')(self, time_s, side=side, ax=ax)

    def plot_tf_tree(self, *, ax: Any = None) -> Any:
        """Draw the tf tree of the run; `ax` is that of :func:`edulaunch.canvas.plot_tf_tree`."""
        return view('plot_tf_tree')(self, ax=ax)

    def plot_graph(self, *, unused: bool = False, services: bool = False, ax: Any = None) -> Any:
        """Draw nodes and topics; `unused`, `services` and `ax` are those of :func:`edulaunch.canvas.plot_graph`."""
        return view('plot_graph')(self, unused=unused, services=services, ax=ax)

    def plot_distance(self, first: str, second: str, close_m: float = 1.0, *, ax: Any = None) -> Any:
        """Plot the distance between two turtles, robots or tf frames over time.

        The parameters `first`, `second`, `close_m` and `ax` are those of :func:`edulaunch.canvas.plot_distance`.
        """
        return view('plot_distance')(self, first, second, close_m, ax=ax)

    def parameter_table(self, node: str | None = None, *, every: bool = False) -> Any:
        """Return a table of parameters with their values and origins.

        The parameters `node` and `every` are those of :func:`edulaunch.canvas.parameter_table`.
        """
        return view('parameter_table')(self, node, every=every)

    def foxglove(self, port: int = 0, origins: Any = ()) -> Any:
        """Serve the run to Foxglove and Lichtblick from a notebook. Return the server, which has `address` and `close()`.

        :param port: a port of this computer, or 0 for any free port.
        :param origins: the origins of pages that may connect, in addition to the origin of Foxglove.
        """
        return view('foxglove')(self, port, origins)

    def replay(self, other: Any = None) -> Any:
        """Return a replay of the whole run with a slider; see :class:`edulaunch.desk.view.replay.Replay`.

        :param other: another recording, which the tab *Plot* draws over this one.
        """
        return view('replay')(self, other)
