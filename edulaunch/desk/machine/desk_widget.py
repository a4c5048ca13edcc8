"""The live view in a notebook: a widget that shows the same page as in a browser. The notebook's kernel runs the machine.

The widget does not depend on JupyterLab. Any front end for ipywidgets shows it, such as Notebook, VS Code or Colab. This
module is imported late, because it needs anywidget.
"""

from __future__ import annotations

from base64 import b64encode
from html import escape
from typing import TYPE_CHECKING, Any

import anywidget
import traitlets

from edulaunch.canvas.filmstrip import still
from edulaunch.canvas.worlds import read_worlds
from edulaunch.desk.machine.live import LiveMachine, Page
from edulaunch.desk.view.page import module
from edulaunch.desk.view.viewer import Viewer
from edulaunch.engine.recording.absent import NothingToDraw

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording


class DeskWidget(anywidget.AnyWidget):  # type: ignore[misc, no-any-unimported, unused-ignore]
    """A live view of a machine as a widget. Each output that shows the widget has its own page."""

    _esm = module()
    tab = traitlets.Unicode('graph').tag(sync=True)

    def __init__(self, machine: LiveMachine, tab: str) -> None:
        super().__init__(tab=tab)
        self._machine = machine
        self._pages: dict[str, Page] = {}
        self.on_msg(self._hear)

    def _hear(self, widget: object, request: Any, buffers: object) -> None:
        """Handle a message of the page on the machine's thread.

        The message may arrive on another thread (a subshell of the kernel).
        """
        self._machine.soon(lambda: self._take(request))

    def _take(self, request: Any) -> None:
        name = request.get('page') if isinstance(request, dict) else None
        if not isinstance(name, str):
            return
        if request.get('op') == 'bye':
            page = self._pages.pop(name, None)
            if page is not None:
                self._machine.pages.remove(page)
            return
        if name not in self._pages:
            self._pages[name] = Page(Viewer(self._machine, lambda message: self.send({**message, 'page': name})))
            self._machine.pages.append(self._pages[name])
        if request.get('op') == 'next':
            self._pages[name].ask()
        else:
            self._machine.do_for(self._pages[name].viewer, request)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        """Return the widget, with a picture and a description of its current state for places without widgets, such as GitHub."""
        bundle = super()._repr_mimebundle_(**options)
        data = dict(bundle[0] if isinstance(bundle, tuple) else bundle or {})
        data.update(_still(self._machine.recording()))
        return (data, *bundle[1:]) if isinstance(bundle, tuple) else data


def _still(recording: Recording) -> dict[str, str]:
    """Return the final state of a recording as a picture of turtles and robots, and as a description, by MIME type."""
    try:
        picture, caption = still(read_worlds(recording), recording.duration_s)
    except NothingToDraw:
        return {'text/plain': f'live view, t={recording.duration_s:.3f} s: {who_is_there(recording)}'}
    text = f'live view, {caption}; {who_is_there(recording)}'
    shown = f'<img alt="{escape(text)}" src="data:image/svg+xml;base64,{b64encode(picture.encode()).decode()}">'
    return {'text/plain': text, 'text/html': shown, 'image/svg+xml': picture}


def who_is_there(recording: Recording) -> str:
    """Return a description of the nodes and frames at the end of a recording."""
    nodes = [node.name for node in recording.nodes if node.ended_s is None and not node.name.rpartition('/')[2].startswith('_')]
    frames = list(recording.frames_at(recording.duration_s))
    return f'nodes: {", ".join(nodes) or "none"}' + (f'; frames: {", ".join(frames)}' if frames else '')
