"""An editor in a few lines: it uses the Language Server Protocol with `edulaunch lsp`, without any library for it."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


class Editor:
    """The other end of a language server.

    :ivar diagnostics: the latest ones of each document, by address.
    """

    def __init__(self, folder: Path, *words: str) -> None:
        command = [sys.executable, '-m', 'edulaunch', 'lsp', *words]
        self._child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=folder)
        self._number = 0
        self.diagnostics: dict[str, list[dict[str, Any]]] = {}
        self._texts: dict[str, str] = {}
        self.about = self.request('initialize', {'processId': None, 'rootUri': folder.as_uri(), 'capabilities': {}})
        self.notify('initialized', {})

    def _send(self, **message: Any) -> None:
        body = json.dumps({'jsonrpc': '2.0', **message}).encode()
        assert self._child.stdin is not None
        self._child.stdin.write(b'Content-Length: %d\r\n\r\n' % len(body) + body)
        self._child.stdin.flush()

    def _next(self) -> dict[str, Any]:
        assert self._child.stdout is not None
        length = 0
        while (line := self._child.stdout.readline().strip()) or not length:
            assert line, 'the server has ended'
            name, _, value = line.partition(b':')
            length = int(value) if name.lower() == b'content-length' else length
        message: dict[str, Any] = json.loads(self._child.stdout.read(length))
        if message.get('method') == 'textDocument/publishDiagnostics':
            self.diagnostics[message['params']['uri']] = message['params']['diagnostics']
        return message

    def notify(self, method: str, params: Any) -> None:
        """Say something that has no answer."""
        self._send(method=method, params=params)

    def request(self, method: str, params: Any) -> Any:
        """Ask, and wait for the answer."""
        self._number += 1
        self._send(id=self._number, method=method, params=params)
        while (message := self._next()).get('id') != self._number or 'method' in message:
            pass
        assert 'error' not in message, message
        return message['result']

    def _shown(self) -> list[dict[str, Any]]:
        while (message := self._next()).get('method') != 'textDocument/publishDiagnostics':
            pass
        found: list[dict[str, Any]] = message['params']['diagnostics']
        return found

    def open(self, path: Path, text: str) -> list[dict[str, Any]]:
        """Open a document, and return its diagnostics."""
        self._texts[path.as_uri()] = text
        self.notify(
            'textDocument/didOpen', {'textDocument': {'uri': path.as_uri(), 'languageId': 'python', 'version': 1, 'text': text}}
        )
        return self._shown()

    def type(self, path: Path, text: str) -> list[dict[str, Any]]:
        """Replace the content of an open document, and return its diagnostics."""
        self._texts[path.as_uri()] = text
        self.notify(
            'textDocument/didChange', {'textDocument': {'uri': path.as_uri(), 'version': 2}, 'contentChanges': [{'text': text}]}
        )
        return self._shown()

    def save(self, path: Path) -> list[dict[str, Any]]:
        """Write the document to its file, and return the diagnostics that follow."""
        path.write_text(self._texts[path.as_uri()], encoding='utf-8')
        self.notify('textDocument/didSave', {'textDocument': {'uri': path.as_uri()}})
        return self._shown()

    def fixed(self, path: Path, diagnostic: dict[str, Any]) -> str:
        """The document after the quick fix of a diagnostic, whose edits are made as an editor does."""
        words = {'textDocument': {'uri': path.as_uri()}, 'range': diagnostic['range'], 'context': {'diagnostics': [diagnostic]}}
        (action,) = self.request('textDocument/codeAction', words)
        text = self._texts[path.as_uri()]
        for change in sorted(action['edit']['changes'][path.as_uri()], key=lambda one: str(one['range']), reverse=True):
            start, end = (_offset(text, change['range'][side]) for side in ('start', 'end'))
            text = text[:start] + change['newText'] + text[end:]
        return text

    def at(self, method: str, path: Path, text: str, **more: Any) -> Any:
        """Ask about the place marked `|` in a document that has this content."""
        before, _, behind = text.partition('|')
        self.type(path, before + behind)
        position = {'line': before.count('\n'), 'character': len(before) - before.rfind('\n') - 1}
        return self.request(f'textDocument/{method}', {'textDocument': {'uri': path.as_uri()}, 'position': position, **more})

    def close(self) -> int:
        """Shut the server down; returns its exit code."""
        self.request('shutdown', None)
        self.notify('exit', None)
        self._child.communicate()
        return self._child.returncode


def _offset(text: str, position: dict[str, int]) -> int:
    start = sum(len(line) + 1 for line in text.split('\n')[: position['line']])
    units = text[start:].encode('utf-16-le')[: 2 * position['character']]
    return start + len(units.decode('utf-16-le'))


@contextmanager
def editor(folder: Path, *words: str) -> Iterator[Editor]:
    """An editor whose server ends with the block."""
    found = Editor(folder, *words)
    try:
        yield found
    finally:
        assert found.close() == 0
