"""Pictures of a Recording.

A recording and a time become a *scene* (plain data, `*_scene.py`), a scene is drawn on matplotlib's axes (`draw_*.py`). Each
`plot_*` gives a `Picture`, which a notebook shows; with `ax=` it draws on those axes and returns them, so that one can go on.
matplotlib is loaded when the first picture is drawn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.canvas.picture import Picture, shown
from edulaunch.engine.recording import views

if TYPE_CHECKING:
    from edulaunch.canvas.table import Table
    from edulaunch.engine.recording import Recording

__all__ = [
    'Picture',
    'parameter_table',
    'plot_distance',
    'plot_frames',
    'plot_graph',
    'plot_series',
    'plot_system',
    'plot_tf_tree',
    'plot_turtles',
]


def plot_turtles(
    recording: Recording,
    time_s: float | None = None,
    *,
    frames: bool | Sequence[str] = False,
    colours: bool = True,
    ax: Any = None,
) -> Any:
    """The turtle windows, and the field of each robot, as they look at a time.

    :param time_s: seconds since the start; default: the end of the recording.
    :param frames: draw tf frames on top: all, or the named ones, such as ['carrot1'].
    :param colours: trails of turtles that share a window have their own colours, as long as nobody gave them a pen.
    :param ax: matplotlib axes to draw on, in metres; a list of them when there are several windows.
    :returns: a Picture, or what was given as `ax`.
    :raises ValueError: when nothing moved in the recording, or for another number of axes than of windows.
    :raises KeyError: when a named frame is not there; the message names the nearest one.
    """
    from edulaunch.canvas.turtle_scene import turtle_scene
    from edulaunch.canvas.worlds import read_worlds

    when = recording.duration_s if time_s is None else time_s
    known = recording.frames_at(when) if frames is not False else {}
    only = frames if isinstance(frames, Sequence) else None
    scene = turtle_scene(read_worlds(recording), when, colours=colours, frames=known, only=only)
    return shown(scene, 'draw_turtles', ax)


def plot_frames(recording: Recording, time_s: float | None = None, *, side: str = 'xy', ax: Any = None) -> Any:
    """The tf frames from above or from a side, as rviz2 shows them: each tree of frames in its root frame.

    :param time_s: seconds since the start; default: the end of the recording.
    :param side: 'xy' from above; 'xz' or 'yz': which axes go across and up.
    :param ax: matplotlib axes to draw on, in metres; a list of them when there are several trees.
    :returns: a Picture, or what was given as `ax`.
    :raises ValueError: when no frame had been broadcast by then, for another side, or another number of axes than of trees.
    """
    from edulaunch.canvas.frames_scene import frames_scene

    return shown(frames_scene(recording, recording.duration_s if time_s is None else time_s, side), 'draw_turtles', ax)


def plot_tf_tree(recording: Recording, *, ax: Any = None) -> Any:
    """Which frame is whose parent over the whole run, which node broadcasts it and how often; trees that are not connected stand
    side by side.

    :param ax: matplotlib axes to draw on.
    :returns: a Picture, or what was given as `ax`.
    :raises ValueError: when no frame was broadcast.
    """
    from edulaunch.canvas.graph_scene import tree_scene

    return shown(tree_scene(recording), 'draw_graph', ax)


def plot_graph(recording: Recording, *, unused: bool = False, services: bool = False, ax: Any = None) -> Any:
    """Nodes and the topics between them, as `rqt_graph` shows them.

    :param unused: also show topics that nobody listens to. `/rosout` and `/parameter_events` are never shown.
    :param services: also show services that a node calls.
    :param ax: matplotlib axes to draw on.
    :returns: a Picture, or what was given as `ax`.
    """
    from edulaunch.canvas.graph_scene import graph_scene

    return shown(graph_scene(recording, unused=unused, services=services), 'draw_graph', ax)


def plot_system(
    system: Any, other: Any = None, changed: Mapping[str, list[str]] | None = None, *, services: bool = False, ax: Any = None
) -> Any:
    """Nodes, topics and frames as a launch file plans them, or two systems side by side.

    :param system, other: see `edulaunch.advice.explaining.systems.System`.
    :param changed: for each node that both have and that differs, the names of the parameters that do.
    :param services: also show services that a node calls.
    :param ax: matplotlib axes to draw on; a list of two for two systems.
    :returns: a Picture, or what was given as `ax`.
    """
    from edulaunch.canvas.system_scene import system_scene

    return shown(system_scene(system, other, changed, services=services), 'draw_system', ax)


def plot_distance(recording: Recording, first: str, second: str, close_m: float = 1.0, *, ax: Any = None) -> Any:
    """How far a follower is from what it follows, over time, in metres; below `close_m` it counts as close.

    :param first, second: turtles as in `Recording.trajectory`, or tf frames.
    :param ax: matplotlib axes to draw on: seconds across, metres up.
    :returns: a Picture, or what was given as `ax`.
    :raises KeyError: when there is no such thing; the message names what there is.
    :raises ValueError: when the two were never there at the same time.
    """
    from edulaunch.canvas.series_scene import distance_scene

    return shown(distance_scene(recording, first, second, close_m), 'draw_series', ax)


def plot_series(recording: Recording, topic: str, *fields: str, ax: Any = None) -> Any:
    """Numbers of a topic over time, a line for each field.

    :param fields: paths such as 'x', 'twist.linear.x' or 'ranges[0]'.
    :param ax: matplotlib axes to draw on: seconds across.
    :returns: a Picture, or what was given as `ax`.
    :raises NotRecorded: when there is no such topic or field; the message names the nearest one.
    :raises NothingToDraw: when nothing was published there, or a field is no number.
    """
    from edulaunch.canvas.series_scene import series_scene

    return shown(series_scene(recording, topic, fields), 'draw_series', ax)


def parameter_table(recording: Recording, node: str | None = None, *, every: bool = False) -> Table:
    """Parameters at the end of the run, with where each value came from.

    :param node: fully qualified name; default: all nodes.
    :param every: also those that each node has anyway (`use_sim_time`, `qos_overrides...`).
    :raises KeyError: when there was no such node.
    """
    from edulaunch.canvas.table import Table, table_rows

    return Table(table_rows(recording, node, every))


views.register(
    parameter_table=parameter_table,
    plot_distance=plot_distance,
    plot_frames=plot_frames,
    plot_graph=plot_graph,
    plot_series=plot_series,
    plot_system=plot_system,
    plot_tf_tree=plot_tf_tree,
    plot_turtles=plot_turtles,
)
