"""The live desk in a notebook: a widget whose page is the same as everywhere, with the kernel as its machine.

It asks for nothing of JupyterLab's own: whatever shows ipywidgets shows it (Notebook, VS Code, Colab).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.machine.started import Machine

TABS = ('frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal')
DeskWidget = Any
"""An `anywidget.AnyWidget`, which is loaded late."""


def desk_widget(machine: Machine, tab: str) -> DeskWidget:
    """See `Machine.view`."""
    from edulaunch.nearest import did_you_mean

    if tab not in TABS:
        raise UnusableInput(f'there is no tab {tab!r}', help=did_you_mean(tab, TABS) or f'one of {", ".join(TABS)}')
    try:
        import anywidget
        import traitlets
    except ImportError:
        raise UnusableInput('the live view needs anywidget', help="pip install 'edulaunch[notebook]'") from None

    from edulaunch.view.page import module
    from edulaunch.view.viewer import Viewer

    class Desk(anywidget.AnyWidget):
        """One widget; each place that shows it is a page of its own."""

        _esm = module()
        tab = traitlets.Unicode('graph').tag(sync=True)
        film = traitlets.Unicode('').tag(sync=True)

        def __init__(self) -> None:
            super().__init__(tab=tab)
            self._pages: dict[str, Viewer] = {}
            self.on_msg(self._hear)

        def _hear(self, widget: object, words: Any, buffers: object) -> None:
            page = words.get('page') if isinstance(words, dict) else None
            if not isinstance(page, str):
                return
            op = words.get('op')
            if op == 'bye':
                self._pages.pop(page, None)
                return
            if page not in self._pages:
                self._pages[page] = Viewer(machine, lambda message: self.send({**message, 'page': page}))
            if op in ('next', 'hello'):
                self._pages[page].show()
            else:
                machine.do_for(self._pages[page], words)

        def _repr_mimebundle_(self, **options: Any) -> Any:
            bundle = super()._repr_mimebundle_(**options)
            data = dict(bundle[0] if isinstance(bundle, tuple) else bundle or {})
            data['text/plain'] = f'live view of {machine!r}: nothing to see where no front end is'
            return (data, *bundle[1:]) if isinstance(bundle, tuple) else data

    return Desk()
