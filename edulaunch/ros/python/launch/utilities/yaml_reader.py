"""Converts YAML text to plain data whose mappings contain their lines.

Launch files can come from untrusted sources, so the size of expanded aliases and the depth of nesting are limited.
"""

from __future__ import annotations

from io import StringIO
from typing import Any

import yaml

from edulaunch.engine.facts import with_facts


class Mapping(dict):  # type: ignore[type-arg]
    """A mapping in the file, with its line.

    :ivar line: the line of the first key, from 1.
    """

    __slots__ = ('line',)

    line: int


MAX_DEPTH = 100
"""The maximum depth of nested lists and mappings."""
MAX_GROWTH = 10
"""The most values per character of a string after replacing its aliases."""
SMALL = 1_000
"""The number of values that is always allowed."""
LONGEST_READ_TWICE = 100_000
"""The maximum number of characters to read a second time. PyYAML's own reader reads about a million characters in ten seconds."""
SAFE_DEPTH = 1_000
"""libyaml's composer uses the machine's stack, half a kilobyte per level; this is safe even in a thread."""


def read(text: str) -> Any:
    """Return the data of the single document in `text`, as `yaml.safe_load` returns it; dicts are :class:`Mapping`.

    :raises yaml.YAMLError: when the text is not a single YAML document with plain data.
    :raises ValueError: when the data are nested too deeply, aliases make them too large, or a date is impossible.
    """
    loader_class: Any = getattr(yaml, 'CSafeLoader', yaml.SafeLoader)
    depth = _possible_depth(text)
    if depth > SAFE_DEPTH:
        _check_depth_of_events(text, loader_class)
    loader = loader_class(text)
    try:
        node = loader.get_single_node()
        if node is None:
            return None
        if depth > MAX_DEPTH or '*' in text:  # without an alias, there is less than one value per character
            _Size(SMALL + MAX_GROWTH * len(text)).check(node)
        return _data_of(node, loader)
    except RecursionError:
        raise _too_deep(1) from None
    finally:
        loader.dispose()


def read_file(text: str, name: str) -> Any:
    """Return the data in a file, like :func:`read`. Errors contain the name of the file."""
    try:
        return read(text)
    except yaml.YAMLError as error:
        raise (_error_in_full(text, name) or error) from None


def _error_in_full(text: str, name: str) -> yaml.YAMLError | None:
    """Return the error that users of upstream see. libyaml reads several times as fast, but the errors of PyYAML's own reader
    are more detailed.
    """
    if len(text) > LONGEST_READ_TWICE:
        return None
    stream = StringIO(text)
    stream.name = name
    try:
        yaml.safe_load(stream)
    except yaml.YAMLError as error:
        if r"character '\t'" in str(error):
            with_facts(error, 'launch.yaml-tab')
        return error
    except (RecursionError, ValueError):
        return None
    return None


def _data_of(node: Any, loader: Any) -> Any:
    """Return the data that PyYAML's constructor creates from a node. For common tags, this function is several times as fast."""
    tag = node.tag
    if tag == 'tag:yaml.org,2002:str' and isinstance(node, yaml.ScalarNode):
        return node.value
    if tag == 'tag:yaml.org,2002:map' and isinstance(node, yaml.MappingNode):
        return _mapping_of(node, loader)
    if tag == 'tag:yaml.org,2002:seq' and isinstance(node, yaml.SequenceNode):
        return [_data_of(item, loader) for item in node.value]
    return loader.construct_object(node, deep=True)


def _mapping_of(node: Any, loader: Any) -> Mapping:
    loader.flatten_mapping(node)  # merge keys
    mapping = Mapping()
    mapping.line = node.start_mark.line + 1
    for key_node, value_node in node.value:
        key, value = _data_of(key_node, loader), _data_of(value_node, loader)
        try:
            mapping[key] = value
        except TypeError:
            raise yaml.constructor.ConstructorError(
                'while constructing a mapping', node.start_mark, 'found unhashable key', key_node.start_mark
            ) from None
    return mapping


def _possible_depth(text: str) -> int:
    """Return a quickly computed upper bound of the nesting, so that nearly all files need no closer examination.

    A bracket opens one level. It does not count if its own line certainly closes it, without a quotation mark or comment nearby.
    An indentation by one column opens two levels at most.
    """
    longest = brackets = 0
    for line in text.split('\n'):
        longest = max(longest, len(line))
        opened = line.count('[') + line.count('{')
        if opened and '"' not in line and "'" not in line and '#' not in line:
            opened -= line.count(']') + line.count('}')
        brackets += max(opened, 0)
    return brackets + 2 * longest + 1


def _check_depth_of_events(text: str, loader_class: Any) -> None:
    depth = 0
    for event in yaml.parse(text, Loader=loader_class):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > MAX_DEPTH:
                raise _too_deep(event.start_mark.line + 1 if event.start_mark is not None else 1)
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1


def _too_deep(line: int) -> ValueError:
    return _refused(f'lists and mappings are nested more than {MAX_DEPTH} levels deep', line)


def _refused(text: str, line: int) -> ValueError:
    error: Any = ValueError(text)
    error.edulaunch_line = line
    return error  # type: ignore[no-any-return]


class _Size:
    """Counts the values below a node. A node with several aliases counts once for each alias, but is visited only once."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        self.sizes: dict[int, int] = {}

    def check(self, node: Any, depth: int = 1) -> int:
        known = self.sizes.get(id(node))
        if known is not None:
            return known
        if depth > MAX_DEPTH:
            raise _too_deep(node.start_mark.line + 1)
        size = 1
        if not isinstance(node, yaml.ScalarNode):
            for child in _children(node):
                size += self.check(child, depth + 1)
                if size > self.limit:
                    raise _refused(f'aliases multiply the text to more than {self.limit} values', child.start_mark.line + 1)
        self.sizes[id(node)] = size
        return size


def _children(node: Any) -> list[Any]:
    if isinstance(node, yaml.MappingNode):
        return [part for pair in node.value for part in pair]
    return node.value  # type: ignore[no-any-return]
