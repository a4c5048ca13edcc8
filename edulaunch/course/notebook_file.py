"""The one reader of notebooks from other people: a lesson of a course author, or a notebook that a student saved.

The reader checks the parts of Jupyter's format, version 4, that the course tools use: the keys `cells`, `cell_type`, `source`,
`id`, `metadata` and `outputs`. Each error message is one sentence that names the file, the cell and the key.
"""

from __future__ import annotations

import json
from base64 import b64decode
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

KINDS = ('code', 'markdown', 'raw')
LARGEST = 50 << 20
"""The size of the largest notebook that is read, in bytes."""
_OUTPUTS = {
    'stream': ('text',),
    'error': ('ename', 'evalue', 'traceback'),
    'display_data': ('data',),
    'execute_result': ('data',),
}
"""The keys that each kind of output must have."""


class Cell(NamedTuple):
    """A cell of a notebook.

    :ivar ident: the ID of the cell; empty in a notebook older than version 4.5.
    :ivar kind: one of `KINDS`.
    :ivar source: the text of the cell.
    :ivar outputs: the stored outputs in Jupyter's format; only code cells have outputs.
    :ivar counted: whether the cell has an execution count.
    """

    ident: str
    kind: str
    source: str
    outputs: tuple[Mapping[str, Any], ...] = ()
    counted: bool = False


class Notebook(NamedTuple):
    """The content of a notebook file.

    :ivar content: the content of the file as JSON data, for tools that write the notebook again.
    """

    cells: tuple[Cell, ...]
    content: dict[str, Any]


def read_notebook(path: str) -> Notebook:
    """Return the notebook in a file.

    :raises UnusableInput: when the file cannot be read, is too large, or is not a notebook of version 4.
    """
    try:
        with open(path, 'rb') as file:
            data = file.read(LARGEST + 1)
    except OSError as error:
        raise UnusableInput(f'the notebook {path} cannot be read: {error.strerror or error}') from None
    return parse_notebook(data, path)


def parse_notebook(data: bytes, path: str) -> Notebook:
    """Return the notebook in the bytes of a file.

    :param path: the name of the file in messages.
    :raises UnusableInput: when there are too many bytes, or they are not a notebook of version 4.
    """
    try:
        return _notebook(data)
    except _Wrong as error:
        raise UnusableInput(f'{path} is not a notebook: {error}', help='open it in JupyterLab and save it again') from None


class _Wrong(Exception):
    """A problem of a notebook. The message is the end of a sentence."""


def _notebook(data: bytes) -> Notebook:
    if len(data) > LARGEST:
        raise _Wrong(f'it has more than {LARGEST >> 20} MB')
    try:
        content = json.loads(data.decode())
    except UnicodeDecodeError:
        raise _Wrong('it is not text in UTF-8') from None
    except RecursionError:
        raise _Wrong('its lists are nested too deeply') from None
    except ValueError as error:
        raise _Wrong(f'it is not JSON ({error})') from None
    if not isinstance(content, dict):
        raise _Wrong('it is JSON, but not an object')
    if not isinstance(content.get('metadata', {}), dict):
        raise _Wrong('its "metadata" is not an object')
    if not isinstance(content.get('cells'), list):
        raise _Wrong('it has no list "cells"')
    return Notebook(tuple(_cells(content['cells'])), content)


def _cells(given: list[Any]) -> Iterator[Cell]:
    for number, cell in enumerate(given, 1):
        try:
            yield _cell(cell)
        except _Wrong as error:
            raise _Wrong(f'cell {number} {error}') from None


def read_outputs_file(path: str) -> dict[str, list[dict[str, Any]]]:
    """Read the file in which a course stores the outputs of a lesson. Return lists of outputs by the ID of their cell.

    :raises OSError: when the file cannot be read.
    :raises ValueError: when the file has any other content.
    """
    with open(path, 'rb') as file:
        data = file.read(LARGEST + 1)
    try:
        found = json.loads(data.decode())
    except RecursionError:
        raise ValueError('its lists are nested too deeply') from None
    if len(data) > LARGEST or not isinstance(found, dict) or not all(isinstance(given, list) for given in found.values()):
        raise ValueError('it is not an object with a list of outputs for each cell')
    try:
        return {ident: [_output(output) for output in given] for ident, given in found.items()}
    except _Wrong as error:
        raise ValueError(f'a cell in it {error}') from None


def _cell(cell: Any) -> Cell:
    if not isinstance(cell, dict):
        raise _Wrong('is not an object')
    kind, ident = cell.get('cell_type'), cell.get('id', '')
    if kind not in KINDS:
        raise _Wrong(f'has a "cell_type" that is not one of {", ".join(KINDS)}')
    if not isinstance(ident, str):
        raise _Wrong('has an "id" that is not a string')
    metadata = cell.setdefault('metadata', {})
    if not isinstance(metadata, dict) or not _is_strings(metadata.get('tags', [])):
        raise _Wrong('has "metadata" that is not an object with a list of tags')
    source = _joined(cell.get('source'), 'source')
    outputs = cell.get('outputs') or []
    if not isinstance(outputs, list):
        raise _Wrong('has "outputs" that are not a list')
    checked = tuple(_output(output) for output in outputs)
    return Cell(ident, str(kind), source, checked, bool(cell.get('execution_count')))


def _output(output: Any) -> dict[str, Any]:
    needed = _OUTPUTS.get(str(output.get('output_type'))) if isinstance(output, dict) else None
    if needed is None:
        raise _Wrong('has an output of an unknown kind')
    missing = [key for key in needed if key not in output]
    if missing:
        raise _Wrong(f'has an output without "{missing[0]}"')
    if 'text' in output:
        _joined(output['text'], 'text')
    if not isinstance(output.get('data', {}), dict):
        raise _Wrong('has an output with "data" that is not an object')
    if not _is_strings(output.get('traceback', [])):
        raise _Wrong('has an output with a "traceback" that is not a list of strings')
    for kind, value in output.get('data', {}).items():
        if kind.startswith(('text/', 'image/')):
            text = _joined(value, kind)
            if kind == 'image/png' and not _is_base64(text):
                raise _Wrong('has a picture that is not base64')
    checked: dict[str, Any] = output
    return checked


def _joined(value: Any, key: str) -> str:
    """Return a string that may be stored as a list of lines."""
    if isinstance(value, str):
        return value
    if not isinstance(value, list) or not _is_strings(value):
        raise _Wrong(f'has a "{key}" that is not a string or a list of strings')
    return ''.join(value)


def _is_base64(text: str) -> bool:
    try:
        b64decode(text)
    except ValueError:
        return False
    return True


def _is_strings(value: Any) -> bool:
    return isinstance(value, list) and all(isinstance(each, str) for each in value)
