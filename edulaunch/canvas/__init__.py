"""Functions that draw pictures of a Recording.

A recording and a time become a *scene* (plain data, `*_scene.py`), and `draw_*.py` draws it on matplotlib's axes. Each
`plot_*` function returns a `Picture` that a notebook shows. With `ax=`, the function draws on these axes and returns the
axes instead. The first picture loads matplotlib. An import is inside a function only if most uses of the module do not need
it.
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
    """Draw the turtle windows, and the field of each robot, at one time.

    :param recording: the run.
    :param time_s: seconds since the start; None means the end of the recording.
    :param frames: True draws all tf frames on top; a list draws only the named frames, such as ['carrot1'].
    :param colours: whether to draw each trail in a separate colour, unless a program has set the pen.
    :param ax: matplotlib axes to draw on, in metres; a list of axes for several windows.
    :returns: a Picture, or `ax`.
    :raises ValueError: when nothing moved in the recording, or the number of axes is not the number of windows.
    :raises KeyError: for an unknown frame; the message contains the most similar name.
    """
    from edulaunch.canvas.turtle_scene import turtle_scene
    from edulaunch.canvas.worlds import read_worlds

    when = recording.duration_s if time_s is None else time_s
    known = recording.frames_at(when) if frames is not False else {}
    only = frames if isinstance(frames, Sequence) else None
    scene = turtle_scene(read_worlds(recording), when, colours=colours, frames=known, only=only)
    return shown(scene, 'draw_turtles', ax)


def plot_frames(recording: Recording, time_s: float | None = None, *, side: str = 'xy', ax: Any = None) -> Any:
    """Draw the tf frames from above or from a side, as rviz2 shows them. Each tree of frames is drawn in its root frame.

    :param recording: the run.
    :param time_s: seconds since the start; None means the end of the recording.
    :param side: the axes of the root that point right and up: 'xy' (from above), 'xz' or 'yz' (from a side).
    :param ax: matplotlib axes to draw on, in metres; a list of axes for several trees.
    :returns: a Picture, or `ax`.
    :raises ValueError: when no frame was broadcast before `time_s`, for another side, or if the numbers of axes and trees differ.
    """
    from edulaunch.canvas.frames_scene import frames_scene

    return shown(frames_scene(recording, recording.duration_s if time_s is None else time_s, side), 'draw_turtles', ax)


def plot_tf_tree(recording: Recording, *, ax: Any = None) -> Any:
    """Draw the tf tree of the whole run, with the parent, the broadcaster and the rate of each frame.

    Trees that are not connected appear side by side.

    :param recording: the run.
    :param ax: matplotlib axes to draw on.
    :returns: a Picture, or `ax`.
    :raises ValueError: when no frame was broadcast.
    """
    from edulaunch.canvas.graph_scene import tree_scene

    return shown(tree_scene(recording), 'draw_graph', ax)


def plot_graph(recording: Recording, *, unused: bool = False, services: bool = False, ax: Any = None) -> Any:
    """Draw the nodes and the topics between them, as `rqt_graph` does.

    :param recording: the run.
    :param unused: whether to show topics without a subscription. The graph never shows `/rosout` and `/parameter_events`.
    :param services: whether to show services that a node calls.
    :param ax: matplotlib axes to draw on.
    :returns: a Picture, or `ax`.
    """
    from edulaunch.canvas.graph_scene import graph_scene

    return shown(graph_scene(recording, unused=unused, services=services), 'draw_graph', ax)


def plot_system(
    system: Any, other: Any = None, changed: Mapping[str, list[str]] | None = None, *, services: bool = False, ax: Any = None
) -> Any:
    """Draw the nodes, topics and frames of a planned or recorded system, or of two systems side by side.

    :param system: the system; see `edulaunch.advice.explaining.systems.System`.
    :param other: a second system to compare with the first system; None draws one system.
    :param changed: for each node with different parameters in the two systems, the names of these parameters.
    :param services: whether to show services that a node calls.
    :param ax: matplotlib axes to draw on; a list of two axes for two systems.
    :returns: a Picture, or `ax`.
    """
    from edulaunch.canvas.system_scene import system_scene

    return shown(system_scene(system, other, changed, services=services), 'draw_system', ax)


def plot_distance(recording: Recording, first: str, second: str, close_m: float = 1.0, *, ax: Any = None) -> Any:
    """Plot the distance between a follower and its leader over time, in metres.

    :param recording: the run.
    :param first: the follower: a turtle as in `Recording.trajectory`, or a tf frame.
    :param second: the leader: a turtle as in `Recording.trajectory`, or a tf frame.
    :param close_m: the largest distance, in metres, that counts as close.
    :param ax: matplotlib axes to draw on; x is the time in seconds, y the distance in metres.
    :returns: a Picture, or `ax`.
    :raises KeyError: for an unknown name; the message lists the known names.
    :raises ValueError: when the two objects did not exist at the same time.
    """
    from edulaunch.canvas.series_scene import distance_scene

    return shown(distance_scene(recording, first, second, close_m), 'draw_series', ax)


def plot_series(recording: Recording, topic: str, *fields: str, ax: Any = None) -> Any:
    """Plot numbers of a topic over time, with one line for each field.

    :param recording: the run.
    :param topic: the full name of the topic.
    :param fields: paths such as 'x', 'twist.linear.x' or 'ranges[0]'.
    :param ax: matplotlib axes to draw on; x is the time in seconds, y the value in the unit of the field.
    :returns: a Picture, or `ax`.
    :raises NotRecorded: for an unknown topic or field; the message contains the most similar name.
    :raises NothingToDraw: when the topic has no messages, or a field is not a number.
    """
    from edulaunch.canvas.series_scene import series_scene

    return shown(series_scene(recording, topic, fields), 'draw_series', ax)


def parameter_table(recording: Recording, node: str | None = None, *, every: bool = False) -> Table:
    """Return a table of the parameters at the end of the run, with the origin of each value.

    :param recording: the run.
    :param node: the full name of a node; None means all nodes.
    :param every: whether to list the parameters that every node has, too (`use_sim_time`, `qos_overrides...`).
    :raises KeyError: for an unknown node.
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
