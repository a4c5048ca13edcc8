"""The replay of a run: a small player over state data, in a frame of its own that asks nothing of any other machine."""

from __future__ import annotations

import html
import json
import os
from base64 import b64encode
from pathlib import Path
from typing import TYPE_CHECKING, Any

from edulaunch.canvas.picture import digest
from edulaunch.canvas.replay_data import replay_data
from edulaunch.canvas.shapes import LOOKS, SHELLS, robot, turtle
from edulaunch.canvas.worlds import World, read_worlds

if TYPE_CHECKING:
    from edulaunch.recording.recording import Recording

ONE, SEVERAL, CONTROLS, CAPTION = 420, 340, 92, 26
"""Side of a world's view in pixels when it stands alone or beside others; height of the player's bar and of a view's title."""


class Replay:
    """Turtles, robots and tf frames over time, with play, pause, speed and a slider.

    A notebook or an HTML page made from it shows the player; where scripts do not run there is a filmstrip of eight pictures;
    `repr()` is one line with a digest of the data.
    """

    def __init__(self, recording: Recording) -> None:
        self._worlds: list[World] = read_worlds(recording)
        self.duration_s = recording.duration_s
        self.data: dict[str, Any] = replay_data(recording, self._worlds)

    @property
    def caption(self) -> str:
        """One line that says what is to be seen."""
        worlds = [
            f'{world["title"]} with {", ".join(dict.fromkeys(life["name"] for life in world["lives"])) or "nobody"}'
            for world in self.data['worlds']
        ]
        return f'replay of {self.duration_s:.2f} s: {"; ".join(worlds)}'

    def __repr__(self) -> str:
        return f'{self.caption} [scene {digest(json.dumps(self.data))}]'

    def filmstrip(self) -> str:
        """Small pictures of the run as an SVG."""
        from edulaunch.canvas.filmstrip import filmstrip

        return filmstrip(self._worlds, self.duration_s)

    def page(self) -> str:
        """The player as an HTML page that needs no other file."""
        drawing = {
            'side': self._side(),
            'shells': SHELLS,
            'looks': LOOKS,
            'shapes': {
                kind: [[part, [value for corner in corners for value in corner]] for part, corners in shape()]
                for kind, shape in (('turtlesim', turtle), ('robot', robot))
            },
        }
        text = json.dumps({**self.data, **drawing}, separators=(',', ':')).replace('</', '<\\/')
        template = Path(__file__).with_name('player.html').read_text(encoding='utf-8')
        return template.replace('{{data}}', text)

    def _side(self) -> int:
        return ONE if len(self.data['worlds']) == 1 else SEVERAL

    def html(self) -> str:
        """What a notebook shows: the player in an isolated frame, over a picture for places that allow no frames or scripts."""
        worlds, side = len(self.data['worlds']), self._side()
        width = max(min(worlds, 2) * (side + 12) + 8, 448)
        height = -(-worlds // 2) * (side + CAPTION) + CONTROLS
        alternative, picture = html.escape(self.caption), b64encode(self.filmstrip().encode()).decode()
        return (
            f'<div style="position:relative;max-width:{width}px;height:{height}px;overflow:hidden">'
            f'<img alt="{alternative}" style="max-width:100%;max-height:100%;object-fit:contain" '
            f'src="data:image/svg+xml;base64,{picture}">'
            f'<iframe title="{alternative}" sandbox="allow-scripts" '
            f'style="position:absolute;inset:0;width:100%;height:100%;border:0" '
            f'srcdoc="{html.escape(self.page())}"></iframe></div>'
        )

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, Any]:
        return {'text/plain': repr(self), 'text/html': self.html()}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the player as an HTML file that any browser plays, without a network."""
        Path(path).write_text(self.page(), encoding='utf-8')
