"""Typed values from the texts of XML attributes."""

from __future__ import annotations

import re
from typing import Any

from launch.utilities.type_utils import get_typed_value

# What YAML 1.1 reads as a string for sure, unless it is one of the words below: ASCII, beginning like a word
# or a substitution, no colon and no comment, no space at the end. (YAML's own reader needs 50 us for it.)
_PLAIN = re.compile(r'[A-Za-z$_/](?:[ !"$-9;-~]*[!"$-9;-~])?')
_WORDS_WITH_A_MEANING = frozenset(('true', 'false', 'yes', 'no', 'on', 'off', 'null'))


def typed(value: str | list[str], data_type: Any, can_be_str: bool) -> Any:
    """The value of the data type (None: by YAML's rules) that the text stands for.

    :param can_be_str: give the text itself when it cannot be converted; it may hold a substitution.
    :raises ValueError: when it cannot be converted.
    """
    if data_type is None and isinstance(value, str):
        if _PLAIN.fullmatch(value) and value.lower() not in _WORDS_WITH_A_MEANING:
            return value
        if value.isdecimal() and value.isascii() and (value[0] != '0' or value == '0'):
            return int(value)
    return get_typed_value(value, data_type, can_be_str)
