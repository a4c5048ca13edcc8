"""Converts single values according to the rules of YAML 1.1."""

from __future__ import annotations

import re
from typing import Any

YAML_BOOLEANS = {
    spelling: value
    for word, value in (('true', True), ('yes', True), ('on', True), ('false', False), ('no', False), ('off', False))
    for spelling in (word, word.capitalize(), word.upper())
}

_WORD = re.compile(r'[A-Za-z_/][A-Za-z0-9_/.]*\Z')
_INTEGER = re.compile(r'-?(?:0|[1-9][0-9]*)\Z')
_DECIMAL = re.compile(r'-?[0-9]+\.[0-9]+\Z')
_SHORT = 200
"""The maximum length of a string that, without aliases, can be neither nested too deeply nor too large."""
_NULLS = ('null', 'Null', 'NULL')


def load_yaml_value(text: str) -> Any:
    """Return a value as `yaml.safe_load` does. Words and plain numbers, which are nearly all values, are converted without the
    parser, which takes 50 us for each value.

    :raises yaml.YAMLError: when the text is not YAML.
    :raises ValueError: when the data are nested too deeply, or aliases make them too large.
    """
    if _WORD.match(text):
        if text in YAML_BOOLEANS:
            return YAML_BOOLEANS[text]
        return None if text in _NULLS else text
    if _INTEGER.match(text):
        return int(text)
    if _DECIMAL.match(text):
        return float(text)
    import yaml

    if '*' in text or len(text) > _SHORT:
        _check_size(text)
    return yaml.safe_load(text)


def _check_size(text: str) -> None:
    import yaml

    from .yaml_reader import read

    try:
        read(text)
    except yaml.YAMLError:
        return  # the function that loads the file reports the error
