"""The language server (pygls): diagnostics, quick fixes, completion, hover, definitions and uses of launch arguments.

While the student types, only `check` runs, which executes nothing. When a launch file is saved, a child process performs a dry
run (`saving.py`), unless an option disables it.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

from lsprotocol import types
from pygls.lsp.server import LanguageServer

from edulaunch.advice.reader import Reader, reader_here
from edulaunch.advice.rule import Finding
from edulaunch.advice.texts import Around, Marked, Text, check, kind_of, marked
from edulaunch.advice.texts.check import LAUNCH_MARKUP, LAUNCH_PYTHON
from edulaunch.advice.texts.lsp import diagnostic, offset_of, path_of, range_of, uri_of
from edulaunch.errors import EdulaunchError
from edulaunch.extras.editor.cells import written_file
from edulaunch.extras.editor.completing import choices
from edulaunch.extras.editor.pointing import Target, Values, definition, hover, references
from edulaunch.extras.editor.saving import saved_check
from edulaunch.runtime.version import __version__

KINDS = {
    'package': types.CompletionItemKind.Module,
    'executable': types.CompletionItemKind.Function,
    'interface': types.CompletionItemKind.Class,
}


class Documents:
    """The server's data about open documents, in addition to their content.

    :param runs: whether the server may execute a saved launch file.
    """

    def __init__(self, runs: bool, workspaces: Sequence[str]) -> None:
        self.runs = runs
        self.workspaces = list(workspaces)
        self.reader: Reader = reader_here()
        self._around: dict[str, Around] = {}
        self._executed: dict[str, tuple[str, list[Finding]]] = {}
        self.values: dict[str, Values] = {}

    def around(self, path: str) -> Around:
        """Return the packages around a file. They are read again after a file was saved."""
        folder = os.path.dirname(path)
        if folder not in self._around:
            self._around[folder] = Around(path, self.workspaces)
        return self._around[folder]

    def forget(self) -> None:
        """Forget the packages, which are then read again at their next use."""
        self._around.clear()

    def executed(self, text: Text, findings: list[Finding], values: Values) -> None:
        """Store the findings of a saved file's dry run."""
        self._executed[text.path] = text.text, findings
        if values:
            self.values[text.path] = values

    def marks(self, text: Text) -> list[Marked]:
        """Return the mistakes in a document. If the document has not changed since it was saved, include the findings of its
        dry run.
        """
        found = check(text.text, text.path, self.around(text.path))
        saved, findings = self._executed.get(text.path, ('', []))
        if saved != text.text:
            return found
        rules = {(mark.finding.rule, mark.finding.line) for mark in found}
        lines = {mark.finding.line for mark in found}
        more = [
            one
            for one in findings
            if (one.rule, one.line) not in rules and not (one.rule == 'launch.fails' and one.line in lines)
        ]
        return [*found, *(marked(one, text) for one in more)]


def make_server(documents: Documents) -> LanguageServer:
    """Return the server with its features."""
    server = LanguageServer('edulaunch', __version__, text_document_sync_kind=types.TextDocumentSyncKind.Full)
    _follow_documents(server, documents)
    _answer_questions(server, documents)
    return server


def _text_of(server: LanguageServer, uri: str) -> Text:
    """Return the content of a document. For a cell that writes a file, return the content of that file."""
    content = server.workspace.get_text_document(uri).source
    written = written_file(content)
    path = path_of(uri)
    if written is None:
        return Text(content, path)
    name, content = written
    return Text(content, os.path.join(os.path.dirname(path), name))


def _follow_documents(server: LanguageServer, documents: Documents) -> None:
    """Register the handlers for documents that are opened, changed, saved or closed."""

    def show(uri: str) -> None:
        text = _text_of(server, uri)
        found = [_diagnostic(diagnostic(mark, text, documents.reader)) for mark in documents.marks(text)]
        server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri=uri, diagnostics=found))

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def did_open(params: types.DidOpenTextDocumentParams) -> None:
        show(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def did_change(params: types.DidChangeTextDocumentParams) -> None:
        show(params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def did_close(params: types.DidCloseTextDocumentParams) -> None:
        server.text_document_publish_diagnostics(types.PublishDiagnosticsParams(uri=params.text_document.uri, diagnostics=[]))

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    @server.thread()
    def did_save(params: types.DidSaveTextDocumentParams) -> None:
        uri = params.text_document.uri
        documents.forget()
        text = _text_of(server, uri)
        is_launch_file = kind_of(text.path, text.text) in (LAUNCH_PYTHON, LAUNCH_MARKUP)
        if documents.runs and is_launch_file and os.path.isfile(text.path):
            with _one_at_a_time:
                outcome = saved_check(text.path, documents.around(text.path).workspaces)
            if outcome is not None:
                findings = [Finding(*one) for one in outcome['findings']]
                own = [one for one in findings if one.file is None or os.path.realpath(one.file) == os.path.realpath(text.path)]
                documents.executed(text, own, outcome['values'])
        show(uri)

    @server.feature(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
    def did_change_configuration(params: types.DidChangeConfigurationParams) -> None:
        settings = params.settings if isinstance(params.settings, dict) else {}
        runs = settings.get('edulaunch', {}).get('runOnSave') if isinstance(settings.get('edulaunch'), dict) else None
        documents.runs = documents.runs if runs is None else bool(runs)


def _answer_questions(server: LanguageServer, documents: Documents) -> None:
    """Register the handlers of requests about a place in a document."""

    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions(code_action_kinds=[types.CodeActionKind.QuickFix]))
    def code_action(params: types.CodeActionParams) -> list[types.CodeAction]:
        return [_action(params.text_document.uri, one) for one in params.context.diagnostics if _fix_of(one)]

    @server.feature(
        types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=["'", '"', '(', ' ', '<', '/', '.'])
    )
    def completion(params: types.CompletionParams) -> list[types.CompletionItem]:
        text = _text_of(server, params.text_document.uri)
        if kind_of(text.path, text.text) is None:
            return []
        found = choices(text, _offset(text, params.position), documents.around(text.path))
        if found is None:
            return []
        place = _range(range_of(text, found[1]))
        return [_item(choice.label, choice.detail, place) for choice in found[0]]

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    def hovering(params: types.HoverParams) -> types.Hover | None:
        text = _text_of(server, params.text_document.uri)
        found = hover(text, _offset(text, params.position), documents.around(text.path), documents.values.get(text.path, {}))
        if found is None:
            return None
        content = types.MarkupContent(kind=types.MarkupKind.Markdown, value=found[0])
        return types.Hover(contents=content, range=_range(range_of(text, found[1])))

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    def defining(params: types.DefinitionParams) -> types.Location | None:
        text = _text_of(server, params.text_document.uri)
        target = definition(text, _offset(text, params.position), documents.around(text.path))
        return None if target is None else _location(target, text, params.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    def uses(params: types.ReferenceParams) -> list[types.Location]:
        text = _text_of(server, params.text_document.uri)
        found = references(text, _offset(text, params.position), documents.around(text.path))
        return [_location(target, text, params.text_document.uri) for target in found]


_one_at_a_time = threading.Lock()


def _position(data: dict[str, int]) -> types.Position:
    return types.Position(line=data['line'], character=data['character'])


def _range(data: dict[str, Any]) -> types.Range:
    return types.Range(start=_position(data['start']), end=_position(data['end']))


def _offset(text: Text, position: types.Position) -> int:
    return offset_of(text, position.line, position.character)


def _diagnostic(data: dict[str, Any]) -> types.Diagnostic:
    return types.Diagnostic(
        range=_range(data['range']),
        message=data['message'],
        severity=types.DiagnosticSeverity(data['severity']),
        code=data['code'],
        source=data['source'],
        data=data.get('data'),
    )


def _fix_of(diagnostic: types.Diagnostic) -> Any:
    """Return the edits of a diagnostic of edulaunch, which pygls has converted to an object."""
    return diagnostic.data if diagnostic.source == 'edulaunch' else None


def _action(uri: str, diagnostic: types.Diagnostic) -> types.CodeAction:
    fix = _plain(diagnostic.data)
    edits = [types.TextEdit(range=_range(change['range']), new_text=change['newText']) for change in fix['changes']]
    return types.CodeAction(
        title=fix['title'],
        kind=types.CodeActionKind.QuickFix,
        diagnostics=[diagnostic],
        is_preferred=True,
        edit=types.WorkspaceEdit(changes={uri: edits}),
    )


def _plain(data: Any) -> Any:
    """Convert the data of a message to plain data."""
    if isinstance(data, (list, tuple)) and not hasattr(data, '_asdict'):
        return [_plain(one) for one in data]
    if hasattr(data, '_asdict'):
        data = data._asdict()
    return {name: _plain(value) for name, value in data.items()} if isinstance(data, dict) else data


def _item(label: str, detail: str, place: types.Range) -> types.CompletionItem:
    edit = types.TextEdit(range=place, new_text=label)
    return types.CompletionItem(label=label, detail=detail or None, text_edit=edit, kind=types.CompletionItemKind.Value)


def _location(target: Target, text: Text, uri: str) -> types.Location:
    """Return a place of a file. A place in the document itself gets the document's address."""
    is_own = target.path == os.path.realpath(text.path)
    start = types.Position(line=target.line - 1, character=target.column)
    end = types.Position(line=target.line - 1, character=target.end or target.column)
    return types.Location(uri=uri if is_own else uri_of(target.path), range=types.Range(start=start, end=end))


def serve(runs: bool = True, workspaces: Sequence[str] = ()) -> None:
    """Serve the editor that started this process, through standard input and output."""
    documents = Documents(runs, workspaces)
    with suppress(EdulaunchError):  # each document will show the error
        check('from launch.actions import LogInfo\nLogInfo(msg="warm")\n', os.path.abspath('warm.launch.py'))
    make_server(documents).start_io()
