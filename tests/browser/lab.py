"""What a student does in JupyterLab."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

WAIT_MS = 240_000
"""When something has not come by then it never will; nothing is measured by it."""
WANTED = 'EDULAUNCH_SCREENSHOTS' in os.environ
PROGRAMS = ('chromium-headless-shell', 'chromium', 'chromium-browser')
"""The first one has no windows, and takes 0.6 of the processor time of the second one for the same tests."""
STARTED = '() => window.jupyterapp?.restored.then(() => true)'
OPEN = """async path => {
  const widget = await window.jupyterapp.commands.execute('docmanager:open', {path, factory: 'Notebook'});
  await widget.context.ready;
  await widget.sessionContext.ready;
}"""
CLOSE = """async () => {
  const widget = window.jupyterapp.shell.currentWidget;
  await widget.sessionContext.shutdown();
  widget.context.model.dirty = false;  // or JupyterLab would ask whether it should be saved
  widget.close();
}"""
RUN_ALL = "() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }"
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


def find_browser() -> str | None:
    """The path of a Chromium, or None where there is none."""
    return next((path for name in PROGRAMS if (path := shutil.which(name))), None)


def write_notebook(folder: Path, name: str, cells: dict[str, str]) -> str:
    """Write a notebook with these code cells by id; returns its name."""
    parts = [
        {'cell_type': 'code', 'id': ident, 'metadata': {}, 'source': source, 'outputs': [], 'execution_count': None}
        for ident, source in cells.items()
    ]
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    content = {'cells': parts, 'metadata': kernel, 'nbformat': 4, 'nbformat_minor': 5}
    (folder / f'{name}.ipynb').write_text(json.dumps(content), encoding='utf-8')
    return name


class Page:
    """One notebook in a browser tab.

    :ivar requests: addresses of other machines that were asked.
    """

    def __init__(self, page: Any, shots: Path, name: str, requests: list[str]) -> None:
        self.page = page
        self.requests = requests
        self._shots = shots
        self._name = name

    def run_all(self) -> None:
        """*Run → Run All Cells*, and wait until the last one has run, or one has failed."""
        self.page.evaluate(RUN_ALL)
        self.page.wait_for_function(ALL_RAN, polling=500)  # not with every picture of the screen: it looks at all outputs
        self.page.get_by_text('Python 3 (ipykernel) | Idle').wait_for()

    def cells(self) -> dict[str, dict[str, Any]]:
        """The code cells as the page has them now, by id: count and outputs."""
        return {cell['id']: cell for cell in self.page.evaluate(CELLS)}

    def show(self, ident: str, part: str = '') -> None:
        """Scroll to a cell, and keep a picture of what is to be seen where pictures are wanted."""
        self.page.evaluate(
            """async ident => {
            const content = window.jupyterapp.shell.currentWidget.content;
            const index = content.widgets.findIndex(cell => cell.model.id === ident);
            content.activeCellIndex = index;
            await content.scrollToItem(index, 'start');
        }""",
            ident,
        )
        if WANTED:
            self.page.wait_for_timeout(150)
            self.page.screenshot(path=self._shots / f'{self._name}-{part or ident}.png')


class Lab:
    """A JupyterLab that serves the course, open in one tab in which lesson after lesson is opened and closed again."""

    def __init__(self, browser: Any, url: str, shots: Path) -> None:
        self._browser = browser
        self._url = url
        self._shots = shots
        self._tab: Any = None
        self._requests: list[str] = []

    @contextlib.contextmanager
    def open(self, lesson: str) -> Iterator[Page]:
        """Open a lesson in a fresh kernel. Requests to anywhere else are noted; the browser finds nobody there."""
        tab = self._tab or self._new_tab()
        self._tab = None  # where the test fails, the next one has a new tab
        self._requests.clear()
        tab.evaluate(OPEN, f'lessons/{lesson}.ipynb')
        tab.get_by_text('Python 3 (ipykernel) | Idle').wait_for(timeout=WAIT_MS)
        is_well = False
        try:
            yield Page(tab, self._shots, lesson, self._requests)
            is_well = True
        finally:
            if is_well:
                tab.evaluate(CLOSE)
                self._tab = tab
            else:
                tab.evaluate('() => window.jupyterapp.serviceManager.sessions.shutdownAll()')
                tab.context.close()

    def _new_tab(self) -> Any:
        context = self._browser.new_context(viewport={'width': 1280, 'height': 900})
        context.set_default_timeout(WAIT_MS)
        context.on('request', self._note)
        tab = context.new_page()
        tab.goto(f'{self._url}/lab?reset')
        tab.wait_for_function(STARTED, polling=100)
        return tab

    def _note(self, request: Any) -> None:
        if not request.url.startswith((self._url, 'data:', 'blob:', 'about:')):
            self._requests.append(request.url)
