"""The replay of a run: the live desk without a machine behind it, in a frame that asks nothing of other machines."""

from __future__ import annotations

import html
import os
from base64 import b64encode
from pathlib import Path
from typing import TYPE_CHECKING, Any

from edulaunch.canvas.filmstrip import filmstrip
from edulaunch.canvas.picture import scene_data
from edulaunch.canvas.worlds import World, read_worlds
from edulaunch.view.page import recorded_page
from edulaunch.view.sources import film_of

if TYPE_CHECKING:
    from edulaunch.recording import Recording

HEIGHT_PX = 780
MOVING = ('turtlesim/msg/Pose', 'nav_msgs/msg/Odometry')


class Replay:
    """Everything of a run over time: turtles, frames, graph, numbers, log, parameters, with play, pause, steps and a slider.

    A notebook or an HTML page made from it shows the desk; where scripts do not run there is a filmstrip of small pictures;
    `repr()` is one line; a digest of what moved goes with it, for tests of notebooks.

    :raises NothingToDraw: when nothing moved in the recording.
    """

    def __init__(self, recording: Recording) -> None:
        self._worlds: list[World] = read_worlds(recording)
        self._title = os.path.basename(recording.launch.file or '') or 'replay'
        self.duration_s = recording.duration_s
        self.film: dict[str, Any] = film_of(recording)

    @property
    def caption(self) -> str:
        """One line that says what is to be seen."""
        worlds = []
        for world in self._worlds:
            names = ', '.join(dict.fromkeys(track.name for track in world.tracks))
            worlds.append(f'{world.title} with {names or "nobody"}')
        return f'replay of {self.duration_s:.2f} s: {"; ".join(worlds)}'

    def __repr__(self) -> str:
        return self.caption

    def filmstrip(self) -> str:
        """Small pictures of the run as an SVG."""
        return filmstrip(self._worlds, self.duration_s)

    def page(self, *, small: bool = True) -> str:
        """The desk as an HTML page that needs no other file; with `small` off the same bytes with every version of zlib."""
        return recorded_page(self.film, self._title, small=small)

    def html(self) -> str:
        """What a notebook shows: the desk in an isolated frame, over a picture for places that allow no frames or scripts."""
        alternative, picture = html.escape(self.caption), b64encode(self.filmstrip().encode()).decode()
        return (
            f'<div style="position:relative;height:{HEIGHT_PX}px;overflow:hidden">'
            f'<img alt="{alternative}" style="max-width:100%;max-height:100%;object-fit:contain" '
            f'src="data:image/svg+xml;base64,{picture}">'
            f'<iframe title="{alternative}" sandbox="allow-scripts" '
            f'style="position:absolute;inset:0;width:100%;height:100%;border:0;background:#fff" '
            f'srcdoc="{html.escape(self.page(small=False))}"></iframe></div>'
        )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        moved = [topic for topic in self.film['topics'] if topic['type'] in MOVING]
        return {'text/plain': repr(self), 'text/html': self.html(), **scene_data([moved, self.film.get('tf')])}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the desk as an HTML file that any browser plays, without a network."""
        Path(path).write_text(self.page(), encoding='utf-8')
