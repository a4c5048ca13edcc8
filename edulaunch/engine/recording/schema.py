"""Checks for the valid form of each part of a recording file, so that other code can rely on it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

Check = Callable[[Any], bool]
FAR = 1 << 63


def text(value: Any) -> bool:
    """Return whether a value is a string."""
    return type(value) is str


def number(value: Any) -> bool:
    """Return whether a value is an integer that fits in 64 bits (True and False do not count)."""
    return type(value) is int and -FAR <= value < FAR


def quantity(value: Any) -> bool:
    """Return whether a value is an integer or a float."""
    return type(value) in (int, float)


def numbers(value: Any) -> bool:
    """Return whether a value is a list of integers. For the times of messages, this takes a fifth of the time of
    `each(number)`.
    """
    if type(value) is not list or not set(map(type, value)) <= {int}:
        return False
    return not value or (min(value) >= -FAR and max(value) < FAR)


def maybe(check: Check) -> Check:
    """Return a check that accepts None, and the values that the given check accepts."""
    return lambda value: value is None or check(value)


def each(check: Check) -> Check:
    """Return a check for a list in which every entry passes the given check."""
    return lambda value: type(value) is list and all(map(check, value))


def row(*checks: Check) -> Check:
    """Return a check for a list with one entry for each of the given checks."""
    return lambda value: (
        type(value) is list and len(value) == len(checks) and all(check(item) for check, item in zip(checks, value, strict=True))
    )


def table(check: Check) -> Check:
    """Return a check for a mapping from names to values that pass the given check."""
    return lambda value: type(value) is dict and all(map(check, value.values()))


def record(needed: dict[str, Check], optional: dict[str, Check] | None = None) -> Check:
    """Return a check for a mapping with all `needed` keys and possibly some `optional` keys. Each value must pass its check."""
    known = {**needed, **(optional or {})}
    return lambda value: (
        type(value) is dict and needed.keys() <= value.keys() <= known.keys() and all(known[key](value[key]) for key in value)
    )


def wire(value: Any) -> bool:
    """Return whether a value may be a wire tuple. `wire_check` compares it with the type when it is read."""
    return type(value) is list


def wires(value: Any) -> bool:
    """Return whether a value is a list of possible wire tuples."""
    return type(value) is list and set(map(type, value)) <= {list}


def truth(value: Any) -> bool:
    """Return whether a value is True or False."""
    return type(value) is bool


def anything(value: Any) -> bool:
    """Return True, because any plain data are valid here, such as the value of a parameter."""
    return True


def fact(value: Any) -> bool:
    """Return whether a value can be part of a fact: a string, a number, a list of strings, or None."""
    return value is None or text(value) or isinstance(value, (int, float)) or each(text)(value)


def root(value: Any) -> bool:
    """Return whether a value is a pair: a folder, and the short name that replaces it in a digest."""
    return row(text, text)(value) and value[1].startswith('@') and len(value[1]) <= 40


_words, _word, _count = each(text), maybe(text), maybe(number)
_error = record({'type': text, 'message': text, 'file': _word, 'line': _count}, {'facts': table(fact)})
PARTS: dict[str, Check] = {
    'roots': each(root),
    'launch': record(
        {},
        {
            'file': text,
            'arguments': table(text),
            'declared': each(row(text, _word, text, maybe(_words), _word, _count)),
            'includes': _words,
            'returncode': _count,
            'error': _word,
            'error_file': _word,
            'error_line': _count,
            'error_type': _word,
            'error_cause': _word,
            'error_facts': table(fact),
            'help': _word,
            'warnings': _words,
            'unread': each(row(text, _words, _word, _word, _count)),
        },
    ),
    'processes': each(
        record(
            {
                'name': text,
                'pid': number,
                'argv': _words,
                'package': _word,
                'executable': _word,
                'file': _word,
                'line': _count,
                'parameter_origins': table(text),
                'started': number,
                'ended': _count,
                'returncode': _count,
                'exception': maybe(_error),
            }
        )
    ),
    'nodes': each(row(text, text, number, _count, number)),
    'endpoints': each(row(text, text, text, number, number, number, wire)),
    'parameters': each(row(number, text, text, anything, text)),
    'calls': each(row(number, text, text, text, wire, truth, _count, maybe(wire))),
    'logs': each(row(number, text, text, number, text)),
    'output': each(row(number, text, text, text)),
    'notes': each(row(number, _word, text, text)),
}
OPTIONAL: dict[str, Check] = {
    'facts': each(row(number, _word, text, table(anything), number, number)),
    'descriptors': each(row(number, text, text, text, truth, maybe(row(quantity, quantity, quantity)))),
    'beside': table(each(table(anything))),
}
"""Optional parts, which are never empty. Unusual facts have a time, process, kind, data, count, and last time. Descriptors of
parameters have a time, node, name, description, whether it is read-only, and (least, largest, step). The last part has the
records of other wings by name.
"""
TOPIC: dict[str, Check] = {'topic': text, 'type': text, 'times': numbers, 'publishers': numbers, 'messages': wires}
