"""Parameter files and `-p` values, read according to the rules of rcl's YAML parser (stricter than YAML: typed lists, no
aliases).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from edulaunch.engine.facts import with_facts
from edulaunch.engine.graph.parameters import scalar_from_text, sequence_type_name

PARAMETERS_KEY = 'ros__parameters'
LAYOUT = 'launch.parameter-file'
_YAML_MARKS = frozenset('\'"[]{}!&*#|>:%@`,\n')


class ParameterFileError(ValueError):
    """A parameter file or value that rcl would reject. The message is the reason in the words of rcl."""


class Entry(NamedTuple):
    """One parameter of a file: its node pattern, its dotted name, its value, and its line (from 1)."""

    pattern: str
    name: str
    value: Any
    line: int


def read_parameter_file(text: str) -> list[Entry]:
    """Return all parameters of a parameter file, in order.

    :param text: the content of the file.
    :raises ParameterFileError: with the reason that rcl gives and, in most cases, the line.
    """
    reader = _Reader(text)
    if not reader.skip_to_root():
        return []
    entries: list[Entry] = []
    try:
        _read_nodes(reader, '', entries)
    except RecursionError:
        raise ParameterFileError('The mappings of the file are nested too deep') from None
    return entries


def read_value(text: str) -> Any:
    """Return the value of a `-p name:=value` argument, or None if `text` is only a comment.

    :raises ParameterFileError: if `text` is not a scalar or a list of scalars of one type.
    """
    if text.strip() and text == text.strip() and not _YAML_MARKS.intersection(text) and text[:2] not in ('-', '- ', '?', '? '):
        return scalar_from_text(text)
    if not text:
        raise ParameterFileError('error not set')
    reader = _Reader(text, of_a_file=False)
    if not reader.skip_to_root(mapping=False):
        return None  # the line is only a comment
    if type(event := reader.next()).__name__ == 'MappingStartEvent':
        raise with_facts(ParameterFileError('Unknown YAML event'), 'launch.parameter-value', value=text)
    return _read_value(reader, event)


class _Reader:
    """A reader that returns the YAML events of a string one at a time."""

    def __init__(self, text: str, of_a_file: bool = True) -> None:
        import yaml

        self.of_a_file = of_a_file
        self._line = 1
        self._events: Iterator[Any] = yaml.parse(text, Loader=getattr(yaml, 'CLoader', yaml.Loader))
        self._error = yaml.YAMLError

    def next(self) -> Any:
        try:
            event = next(self._events)
        except self._error as error:
            reason = f'Error parsing a event near line {self._line}' if self.of_a_file else 'Error parsing an event'
            raise with_facts(ParameterFileError(reason), 'launch.yaml', **_problem(error)) from None
        self._line = line_of(event)  # an error of rcl names the last line that it could read
        if type(event).__name__ == 'AliasEvent':
            reason = f'Will not support aliasing at line {self._line}' if self.of_a_file else 'Unknown YAML event'
            raise ParameterFileError(reason)
        return event

    def skip_to_root(self, mapping: bool = True) -> bool:
        """Move to the root value of the document. Return False if the string contains no document."""
        for skipped in ('StreamStartEvent', 'DocumentStartEvent'):
            if type(self.next()).__name__ != skipped:
                return False
        if mapping:
            root = self.next()
            if type(root).__name__ != 'MappingStartEvent':
                raise _too_early(root, '')
        return True


def _problem(error: Any) -> dict[str, Any]:
    mark = getattr(error, 'problem_mark', None)
    return {'at': None if mark is None else mark.line + 1, 'problem': str(getattr(error, 'problem', error))}


def line_of(event: Any) -> int:
    """Return the line in which an event starts, counted from 1."""
    return int(event.start_mark.line) + 1


def _read_nodes(reader: _Reader, path: str, entries: list[Entry]) -> None:
    """Read a mapping of namespaces and node names at `path`.

    rcl treats /sim and sim as two patterns for the same nodes, and uses the values of the later pattern.
    """
    while type(key := reader.next()).__name__ != 'MappingEndEvent':
        name = _key_text(key)
        value = reader.next()
        if type(value).__name__ != 'MappingStartEvent':
            raise _no_colon(value) if name == PARAMETERS_KEY else _too_early(value, path)
        if name != PARAMETERS_KEY:
            _read_nodes(reader, f'{path}/{name.strip("/")}' if path else name.rstrip('/'), entries)
        elif path:
            _read_parameters(reader, path, '', entries)
        else:
            raise with_facts(
                ParameterFileError(f'There are no node names before {PARAMETERS_KEY} at line {line_of(key)}'), LAYOUT
            )


def _no_colon(event: Any) -> ParameterFileError:
    """Return the error for a scalar in place of the mapping of parameters, such as the string `speed 2.0`."""
    error = _too_early(event, PARAMETERS_KEY)
    name, blank, value = str(getattr(event, 'value', '')).partition(' ')
    if not blank or ':' in name or not name.isidentifier():
        return error
    return with_facts(error, 'launch.parameter-no-space', at=line_of(event), words=f'{name} {value}', spaced=f'{name}: {value}')


def _too_early(event: Any, path: str) -> ParameterFileError:
    """Return the error for a value that is not nested deeply enough; `path` is the place of the value."""
    error = ParameterFileError(f'Cannot have a value before {PARAMETERS_KEY} at line {line_of(event)}')
    name, colon, value = str(getattr(event, 'value', '')).partition(':')
    if name.split()[:1] == [PARAMETERS_KEY]:
        return with_facts(error, 'launch.parameter-no-space', at=line_of(event), words=name, spaced=f'{PARAMETERS_KEY}:')
    if colon and name and value and ' ' not in name + value:
        return with_facts(
            error, 'launch.parameter-no-space', at=line_of(event), squeezed=f'{name}:{value}', spaced=f'{name}: {value}'
        )
    misspelt = next((name for name in path.split('/') if 'param' in name.lower()), None)
    if misspelt in (None, PARAMETERS_KEY):  # the key is right, and the value is not indented below it
        return with_facts(error, LAYOUT)
    return with_facts(error, 'launch.parameters-key', found=misspelt, at=line_of(event))


def _read_parameters(reader: _Reader, pattern: str, prefix: str, entries: list[Entry]) -> None:
    """Read the mapping under `ros__parameters`; nested mappings become dotted names."""
    while type(key := reader.next()).__name__ != 'MappingEndEvent':
        name = prefix + _key_text(key)
        value = reader.next()
        if type(value).__name__ == 'MappingStartEvent':
            _read_parameters(reader, pattern, name + '.', entries)
        else:
            entries.append(Entry(pattern, name, _read_value(reader, value), line_of(value)))


def _key_text(event: Any) -> str:
    kind = type(event).__name__
    if kind != 'ScalarEvent':
        what = 'Sequences' if kind == 'SequenceStartEvent' else 'Mappings'
        raise ParameterFileError(f'{what} can only be values and not keys in params. Error at line {line_of(event)}')
    return str(event.value)


def _read_value(reader: _Reader, event: Any) -> Any:
    kind = type(event).__name__
    if kind == 'ScalarEvent':
        return _scalar(event)
    if kind == 'SequenceStartEvent':
        return _read_sequence(reader) or None  # rcl does not know the type of an empty list, so it does not set the parameter
    raise ParameterFileError(f'Expected a value or a list of values at line {line_of(event)}')


def _read_sequence(reader: _Reader) -> list[Any]:
    items: list[Any] = []
    while type(event := reader.next()).__name__ != 'SequenceEndEvent':
        if type(event).__name__ != 'ScalarEvent':
            what = 'Sequences' if type(event).__name__ == 'SequenceStartEvent' else 'Mappings'
            refused = ParameterFileError(f'{what} cannot be values of a sequence. Error at line {line_of(event)}')
            raise with_facts(refused, 'launch.nested-list', at=line_of(event))
        items.append(item := _scalar(event))
        if type(item) is not type(items[0]):
            word = next((value for value in (item, items[0]) if isinstance(value, str)), None)
            other = f"Value type '{sequence_type_name(item)}' do not belong at line_num {line_of(event)}"
            refused = ParameterFileError(f'Sequence should be of same type. {other}')
            raise with_facts(refused, 'launch.list-of-one-type', word=word, at=line_of(event))
    return items


def _scalar(event: Any) -> Any:
    text = str(event.value)
    if event.style in ('"', "'") or event.tag == 'tag:yaml.org,2002:str':
        return text
    if not text:
        raise with_facts(ParameterFileError(f'No value at line {line_of(event)}'), 'launch.no-value')
    return scalar_from_text(text)
