"""Help in JupyterLab: mistakes in cells that write a launch file, and in launch files in XML, are marked with their cures."""

from __future__ import annotations

import json
import re
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from tests.browser.lab import STARTED, WAIT_MS, WANTED, Lab

PLAYWRIGHT = pytest.importorskip('playwright.sync_api', reason='playwright is not installed: pip install ".[browser]"')
pytestmark = pytest.mark.browser
for _name in ('pygls', 'jupyterlab_lsp', 'pylsp'):
    pytest.importorskip(_name, reason=f"{_name} is not installed: pip install 'edulaunch[editor,browser]'")

CELL = """%%writefile follow.launch.py
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesm', executable='turtlesim_node'),
        Node(package='turtlesim', executable='turtlesim_nod', nmae='b'),
    ])
"""
MARKUP = '<launch>\n  <node pkg="turtlesim" exec="turtlesim_nod"/>\n</launch>\n'
OPEN = """async ([path, factory]) => {
  const widget = await window.jupyterapp.commands.execute('docmanager:open', {path, factory});
  await widget.context.ready;
}"""
TYPE = """text => {
  const cell = window.jupyterapp.shell.currentWidget.content.widgets[0];
  cell.model.sharedModel.setSource(text);
}"""


@pytest.fixture(scope='module')
def tab(lab: Lab, course: Path) -> Iterator[Any]:
    cell = {'cell_type': 'code', 'id': 'write', 'metadata': {}, 'execution_count': None, 'outputs': [], 'source': ''}
    spec = {
        'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'},
        'language_info': {'name': 'python'},
    }
    notebook = {'nbformat': 4, 'nbformat_minor': 5, 'metadata': spec, 'cells': [cell]}
    for name in ('help', 'late'):
        (course / f'{name}.ipynb').write_text(json.dumps(notebook), encoding='utf-8')
    (course / 'help.launch.xml').write_text(MARKUP, encoding='utf-8')
    page = lab._new_tab()
    yield page
    page.evaluate('() => window.jupyterapp.serviceManager.sessions.shutdownAll()')
    page.context.close()


def marked(page: Any, words: list[str]) -> None:
    """Wait until these words are underlined."""
    page.wait_for_function(
        """words => {
            const found = [...document.querySelectorAll('.cm-lintRange')].map(one => one.textContent);
            return words.every(word => found.some(text => text.includes(word)));
        }""",
        arg=words,
        timeout=WAIT_MS,
        polling=500,
    )


def message(page: Any, word: str) -> str:
    """Return the message that appears while the pointer is on a word and Ctrl is held. A mark that is drawn again loses it."""
    mark = page.locator('.cm-lintRange:visible', has_text=word).first
    shown = page.locator('.cm-tooltip-lint, .lsp-tooltip, .cm-tooltip-hover').first
    page.keyboard.down('Control')
    try:
        for timeout_ms in (*[5000] * 9, WAIT_MS):
            page.mouse.move(0, 0)
            mark.hover(timeout=WAIT_MS)
            with suppress(PLAYWRIGHT.TimeoutError):
                shown.wait_for(timeout=timeout_ms)
                return str(shown.inner_text())
        pytest.fail(f'no message appears at {word}')
    finally:
        page.keyboard.up('Control')


def picture(page: Any, shots: Path, name: str) -> None:
    if WANTED:
        page.screenshot(path=shots / f'{name}.png')


def test_a_cell_that_writes_a_launch_file_is_marked_while_typing(tab: Any, shots: Path) -> None:
    tab.evaluate(OPEN, ['help.ipynb', 'Notebook'])
    tab.get_by_text('Python 3 (ipykernel) | Idle').wait_for(timeout=WAIT_MS)
    tab.evaluate(TYPE, CELL)
    marked(tab, ['turtlesm', 'turtlesim_nod', 'nmae='])
    assert 'write name=' in message(tab, 'nmae=')
    picture(tab, shots, 'editor-cell')
    tab.evaluate(
        TYPE, CELL.replace('turtlesm', 'turtlesim').replace('_nod', '_node').replace('_nodee', '_node').replace('nmae', 'name')
    )
    tab.wait_for_function("() => !document.querySelector('.cm-lintRange')", timeout=WAIT_MS, polling=500)


def test_a_launch_file_in_xml_is_marked(tab: Any, shots: Path) -> None:
    tab.evaluate(OPEN, ['help.launch.xml', 'Editor'])
    marked(tab, ['turtlesim_nod'])
    assert "write 'turtlesim_node'" in message(tab, 'turtlesim_nod')
    picture(tab, shots, 'editor-xml')


def test_what_is_typed_while_the_server_starts_is_marked(tab: Any, lab: Lab) -> None:
    """The server's answers are held back until JupyterLab has got to know the other server."""
    held: list[tuple[Any, Any]] = []
    told: list[str] = []
    answers = threading.Event()

    def hold(socket: Any) -> None:
        socket.connect_to_server().on_message(
            lambda message: socket.send(message) if answers.is_set() else held.append((socket, message))
        )

    page = lab._new_tab()
    page.route_web_socket(re.compile('/lsp/ws/edulaunch'), hold)
    page.on('websocket', lambda socket: socket.on('framesent', lambda frame: told.append(str(frame))))
    page.reload()
    page.wait_for_function(STARTED)
    page.evaluate(OPEN, ['late.ipynb', 'Notebook'])
    page.get_by_text('Python 3 (ipykernel) | Idle').wait_for(timeout=WAIT_MS)
    page.evaluate(TYPE, CELL.partition('        Node')[0] + '    ])\n')
    page.evaluate(TYPE, CELL)
    while not held or not any('textDocument/didOpen' in frame for frame in told):
        page.wait_for_timeout(100)
    answers.set()
    for socket, message in held:
        socket.send(message)
    marked(page, ['turtlesm', 'turtlesim_nod', 'nmae='])
    page.context.close()
