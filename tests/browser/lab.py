"""What a student does in JupyterLab."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

RUN_MS = 90_000
RUN_ALL = "async () => { await window.jupyterapp.commands.execute('notebook:run-all-cells') }"
ALL_RAN = """() => {
  const cells = window.jupyterapp.shell.currentWidget.content.widgets.filter(cell => cell.model.type === 'code');
  const failed = cell => !(cell.model.getMetadata('tags') || []).includes('raises-exception')
    && cell.model.outputs.toJSON().some(output => output.output_type === 'error');
  return cells.every(cell => cell.model.executionCount !== null) || cells.some(failed);
}"""
CELLS = """() => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  return notebook.widgets.filter(cell => cell.model.type === 'code').map(cell => ({
    id: cell.model.id, count: cell.model.executionCount, outputs: cell.model.outputs.toJSON()}));
}"""


class Page:
    """One notebook in a browser tab."""

    def __init__(self, page: Any, shots: Path, name: str) -> None:
        self.page = page
        self.requests: list[str] = []
        self._shots = shots
        self._name = name

    def run_all(self) -> None:
        """*Run → Run All Cells*, and wait until the last one has run."""
        self.page.evaluate(RUN_ALL)
        self.page.wait_for_function(ALL_RAN, timeout=RUN_MS)
        self.page.get_by_text('Python 3 (ipykernel) | Idle').wait_for(timeout=RUN_MS)

    def cells(self) -> dict[str, dict[str, Any]]:
        """The code cells as the page has them now, by id: count and outputs."""
        return {cell['id']: cell for cell in self.page.evaluate(CELLS)}

    def show(self, ident: str, part: str = '') -> None:
        """Scroll to a cell, and keep a picture of what is to be seen."""
        self.page.evaluate(
            """async ident => {
            const content = window.jupyterapp.shell.currentWidget.content;
            const index = content.widgets.findIndex(cell => cell.model.id === ident);
            content.activeCellIndex = index;
            await content.scrollToItem(index, 'start');
        }""",
            ident,
        )
        self.page.wait_for_timeout(150)
        self.page.screenshot(path=self._shots / f'{self._name}-{part or ident}.png')


class Lab:
    """A JupyterLab that serves the course."""

    def __init__(self, browser: Any, url: str, shots: Path) -> None:
        self._browser = browser
        self._url = url
        self._shots = shots

    @contextlib.contextmanager
    def open(self, lesson: str) -> Iterator[Page]:
        """Open a lesson in a fresh kernel. Requests to anywhere else are noted, and refused."""
        context = self._browser.new_context(viewport={'width': 1280, 'height': 900})
        page = Page(context.new_page(), self._shots, lesson)

        def watch(route: Any) -> None:
            if route.request.url.startswith((self._url, 'data:', 'blob:', 'about:')):
                route.continue_()
            else:
                page.requests.append(route.request.url)
                route.abort()

        context.route('**/*', watch)
        try:
            page.page.goto(f'{self._url}/lab/tree/lessons/{lesson}.ipynb?reset')
            page.page.wait_for_selector('.jp-Notebook', timeout=RUN_MS)
            page.page.get_by_text('Python 3 (ipykernel) | Idle').wait_for(timeout=RUN_MS)
            yield page
        finally:
            page.page.evaluate('() => window.jupyterapp.serviceManager.sessions.shutdownAll()')
            context.close()
