"""Field types as they are written: `float64`, `string<=10`, `int32[3]`, `geometry_msgs/Point[]`."""

from __future__ import annotations

import re
from typing import NoReturn

from edulaunch.interfaces.kinds import KINDS, PRIMITIVE_NAMES, primitive_name
from edulaunch.interfaces.sections import Line
from edulaunch.interfaces.spec import FieldType
from edulaunch.nearest import did_you_mean

_TYPE = re.compile(
    r'(?P<base>[A-Za-z][\w/]*)(?:<=(?P<string>\d{1,9}))?'
    r'(?P<array>\[(?:(?P<upper><=)?(?P<size>\d{1,9}))?\])?$',
    re.ASCII,
)
_NESTED = re.compile(r'(?:(?P<package>[a-z]\w*)/(?:msg/)?)?(?P<name>[A-Z][A-Za-z0-9]*)$', re.ASCII)
# Where students most often reach for a word of another language, or of ROS 1.
_OTHER_WORDS = {
    'float': 'float32 or float64',
    'double': 'float64',
    'int': 'int32 or int64',
    'integer': 'int32 or int64',
    'long': 'int64',
    'unsigned': 'uint32',
    'str': 'string',
    'text': 'string',
    'boolean': 'bool',
    'octet': 'byte',
    'list': 'T[], such as int32[]',
    'time': 'builtin_interfaces/Time',
    'duration': 'builtin_interfaces/Duration',
}


def split_type(text: str) -> FieldType | None:
    """The type that a text stands for, its base name as written; None for a text of another shape."""
    match = _TYPE.match(text)
    if match is None:
        return None
    bound = int(match['string']) if match['string'] else None
    size = int(match['size'] or 0)
    if match['array'] is None:
        return FieldType(match['base'], bound)
    if match['size'] is None:
        return FieldType(match['base'], bound, 'unbounded')
    return FieldType(match['base'], bound, 'bounded' if match['upper'] else 'fixed', size)


def field_type(line: Line, text: str, package: str) -> FieldType:
    """The type of a field, its base resolved to a primitive kind or a full type name.

    :raises InterfaceError: when the text is no type; types of other files are looked up later.
    """
    written = split_type(text)
    if written is None:
        line.fail(f"'{text}' is not a type", help='types look like float64, string<=10, int32[], int32[3], int32[<=3], pkg/Type')
    bound = written.string_bound
    if bound is not None and written.base not in ('string', 'wstring'):
        line.fail(f"only strings have a bound, not '{written.base}'", help=f'for a bounded list write {written.base}[<={bound}]')
    if bound == 0 or (written.array in ('fixed', 'bounded') and written.size == 0):
        line.fail(f"'{text}' has room for nothing: a size must be at least 1")
    return written._replace(base=_base(line, written.base, package))


def _base(line: Line, name: str, package: str) -> str:
    """The full name of a type: a primitive, or 'pkg/msg/Type'."""
    if primitive_name(name) in KINDS:
        return primitive_name(name)
    if name == 'Header':
        return 'std_msgs/msg/Header'
    nested = _NESTED.match(name)
    if nested is None:
        _refuse_name(line, name)
    return f'{nested["package"] or package}/msg/{nested["name"]}'


def _refuse_name(line: Line, name: str) -> NoReturn:
    other = _OTHER_WORDS.get(name)
    help = (
        f'did you mean {other}?'
        if other
        else did_you_mean(name, PRIMITIVE_NAMES) or 'a message type starts with a capital letter: Name, or other_package/Name'
    )
    line.fail(f"unknown type '{name}'", help=help)
