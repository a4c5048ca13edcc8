"""Pictures of a Recording.

A recording and a time become a *scene* (plain data, `*_scene.py`), a scene becomes a picture (`draw_*.py`). matplotlib is
loaded when the first picture is drawn.
"""
from __future__ import annotations

from typing import TYPE_CHECKING

from edulaunch.canvas.picture import Picture

if TYPE_CHECKING:
    from edulaunch.recording import Recording

__all__ = ['Picture', 'plot_distance', 'plot_frames', 'plot_graph', 'plot_tf_tree', 'plot_turtles']


def plot_turtles(recording: Recording, time_s: float | None = None) -> Picture:
    """The turtle windows, and the field of each robot, as they look at a time.

    :param time_s: seconds since the start; default: the end of the recording.
    :raises ValueError: when nothing moved in the recording.
    """
    from edulaunch.canvas.turtle_scene import turtle_scene
    from edulaunch.canvas.worlds import read_worlds
    scene = turtle_scene(read_worlds(recording), recording.duration_s if time_s is None else time_s)

    def draw() -> bytes:
        from edulaunch.canvas.draw_turtles import draw_turtles
        return draw_turtles(scene)
    return Picture(draw, scene.caption(), scene)


def plot_frames(recording: Recording, time_s: float | None = None) -> Picture:
    """The tf frames from above, as rviz2 shows them: each tree of frames in its root frame.

    :param time_s: seconds since the start; default: the end of the recording.
    :raises ValueError: when no frame had been broadcast by then.
    """
    from edulaunch.canvas.frames_scene import frames_scene
    scene = frames_scene(recording, recording.duration_s if time_s is None else time_s)

    def draw() -> bytes:
        from edulaunch.canvas.draw_frames import draw_frames
        return draw_frames(scene)
    return Picture(draw, scene.caption(), scene)


def plot_graph(recording: Recording, *, unused: bool = False) -> Picture:
    """Nodes and the topics between them, as `rqt_graph` shows them.

    :param unused: also show topics that nobody listens to. `/rosout` and `/parameter_events` are never shown.
    """
    from edulaunch.canvas.graph_scene import graph_scene
    scene = graph_scene(recording, unused)

    def draw() -> bytes:
        from edulaunch.canvas.draw_graph import draw_graph
        return draw_graph(scene)
    return Picture(draw, scene.caption(), scene)
