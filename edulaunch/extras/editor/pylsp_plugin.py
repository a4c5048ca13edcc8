"""A plug-in of python-lsp-server that adds edulaunch's diagnostics, completion and hover to Python files.

JupyterLab uses one server for each language. pylsp calls these functions by their names and parameters.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, TypeVar

import pylsp

from edulaunch.advice.reader import reader_here
from edulaunch.advice.texts import Around, Text, check, kind_of
from edulaunch.advice.texts.lsp import diagnostics, offset_of, path_of, range_of, uri_of
from edulaunch.errors import EdulaunchError
from edulaunch.extras.editor.completing import choices
from edulaunch.extras.editor.pointing import Target, definition, hover, references

Hook = TypeVar('Hook', bound=Callable[..., Any])
hookimpl: Callable[[Hook], Hook] = pylsp.hookimpl
VALUE = 12
"""`CompletionItemKind.Value` of the protocol."""


def _text(document: Any) -> Text | None:
    """Return the document, or None for a Python file without ROS 2."""
    path = os.path.abspath(path_of(document.uri))
    return Text(document.source, path) if kind_of(path, document.source) is not None else None


@hookimpl
def pylsp_settings(config: Any) -> dict[str, Any]:
    """Return settings that enable the plug-in."""
    return {'plugins': {'edulaunch': {'enabled': True}}}


@hookimpl
def pylsp_lint(config: Any, workspace: Any, document: Any, is_saved: bool = False) -> list[dict[str, Any]]:
    """Return the mistakes in the file, without executing it."""
    text = _text(document)
    if text is None:
        return []
    try:
        return diagnostics(check(text.text, text.path), text, reader_here())
    except EdulaunchError:
        return []


@hookimpl
def pylsp_completions(config: Any, workspace: Any, document: Any, position: dict[str, int]) -> list[dict[str, Any]]:
    """Return the completions at the cursor."""
    text = _text(document)
    found = None if text is None else choices(text, offset_of(text, position['line'], position['character']), Around(text.path))
    if found is None or text is None:
        return []
    place = range_of(text, found[1])
    return [
        {'label': one.label, 'detail': one.detail, 'kind': VALUE, 'textEdit': {'range': place, 'newText': one.label}}
        for one in found[0]
    ]


@hookimpl
def pylsp_hover(config: Any, workspace: Any, document: Any, position: dict[str, int]) -> dict[str, Any] | None:
    """Return a description of the object at the cursor, or None if there is nothing to describe."""
    text = _text(document)
    found = None if text is None else hover(text, offset_of(text, position['line'], position['character']), Around(text.path), {})
    if found is None or text is None:
        return None
    return {'contents': {'kind': 'markdown', 'value': found[0]}, 'range': range_of(text, found[1])}


@hookimpl
def pylsp_definitions(config: Any, workspace: Any, document: Any, position: dict[str, int]) -> list[dict[str, Any]]:
    """Return the definition of the object at the cursor."""
    text = _text(document)
    target = (
        None if text is None else definition(text, offset_of(text, position['line'], position['character']), Around(text.path))
    )
    return [] if target is None else [_location(target)]


@hookimpl
def pylsp_references(document: Any, position: dict[str, int], exclude_declaration: bool = False) -> list[dict[str, Any]]:
    """Return all uses of the launch argument at the cursor."""
    text = _text(document)
    if text is None:
        return []
    return [
        _location(one) for one in references(text, offset_of(text, position['line'], position['character']), Around(text.path))
    ]


def _location(target: Target) -> dict[str, Any]:
    start = {'line': target.line - 1, 'character': target.column}
    return {'uri': uri_of(target.path), 'range': {'start': start, 'end': {**start, 'character': target.end or target.column}}}
