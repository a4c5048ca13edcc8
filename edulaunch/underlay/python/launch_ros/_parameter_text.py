"""The text of a generated parameter file.

Nearly all parameters are plain words, numbers and lists of these, which need no YAML library: it takes
half a millisecond for three values. The text is the same, character by character.
"""

from __future__ import annotations

import re
from typing import Any

# What YAML writes without quotes, and on one line: it cannot be taken for anything but a text.
_WORD = re.compile(r'[A-Za-z_/](?:[A-Za-z0-9_/.*-]|[A-Za-z0-9_/.*-] (?=[A-Za-z0-9_/.*-])){0,59}')
_MEANINGS = frozenset(('true', 'false', 'yes', 'no', 'on', 'off', 'null', 'y', 'n'))
_DECIMAL = re.compile(r'-?[0-9]+\.[0-9]+')


def parameter_file_text(node_key: str, values: dict[str, Any]) -> str:
    """The values below `node_key` and `ros__parameters`, as `yaml.dump` writes them.

    :param node_key: the node's full name, or `/**`.
    :param values: tuples are written as lists.
    """
    lines: list[str] = []
    for name in sorted(values):
        written = _lines_of(values[name])
        if written is None or not _is_word(name):
            return _by_yaml(node_key, values)
        lines += [f'    {name}:{written[0]}', *written[1:]]
    if not lines or not _is_word(node_key):
        return _by_yaml(node_key, values)
    return '\n'.join([f'{node_key}:', '  ros__parameters:', *lines, ''])


def _lines_of(value: Any) -> list[str] | None:
    """What stands behind the colon, and the lines below it; None when that is for YAML to decide."""
    if not isinstance(value, (list, tuple)):
        text = _scalar(value)
        return None if text is None else [f' {text}']
    texts = [_scalar(item) for item in value]
    return ['', *(f'    - {text}' for text in texts)] if texts and None not in texts else None


def _scalar(value: Any) -> str | None:
    kind = type(value)
    if kind is str:
        return value if _is_word(value) else None
    if kind is bool:
        return 'true' if value else 'false'
    text = repr(value)
    return text if kind is int or (kind is float and _DECIMAL.fullmatch(text)) else None


def _is_word(text: str) -> bool:
    return _WORD.fullmatch(text) is not None and text.lower() not in _MEANINGS


def _by_yaml(node_key: str, values: dict[str, Any]) -> str:
    import yaml

    plain = {name: list(value) if isinstance(value, tuple) else value for name, value in values.items()}
    dumper: Any = getattr(yaml, 'CSafeDumper', yaml.SafeDumper)
    content = {node_key: {'ros__parameters': plain}}
    text: str = yaml.dump(content, Dumper=dumper, default_flow_style=False, allow_unicode=True)
    return text
