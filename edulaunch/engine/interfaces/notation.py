"""The notation of interface files: sections between `---`, types (`float64`, `string<=10`, `geometry_msgs/Point[]`), and the
values of constants and defaults.
"""

from __future__ import annotations

import re
from typing import Any, NamedTuple, NoReturn

from edulaunch.engine.interfaces.spec import KINDS, PRIMITIVE_NAMES, FieldType, primitive_name
from edulaunch.engine.nearest import did_you_mean
from edulaunch.engine.underlay_place import help_text
from edulaunch.errors import InterfaceError


class Line(NamedTuple):
    """One line of an interface file, without its comment."""

    file: str
    number: int
    text: str

    def fail(self, message: str, help: str | None = None) -> NoReturn:
        """Raise an InterfaceError that names the file and the line."""
        raise InterfaceError(f'{self.file}:{self.number}: {message}', help=help)


def sections_of(text: str, file: str, kind: str, wanted: int) -> list[list[Line]]:
    """Return the lines of each section of an interface file, without comments and blank lines. `---` separates the sections.

    :param text: the content of an interface file.
    :param file: the path of the file, for error messages.
    :param kind: 'msg', 'srv' or 'action'.
    :param wanted: the number of sections of that kind: 1, 2 or 3.
    :raises InterfaceError: if the number of `---` lines is wrong, or if other text follows `---` on a line.
    """
    sections: list[list[Line]] = [[]]
    number = 0
    for number, raw in enumerate(re.split('\r\n|\r|\n', text.removeprefix('\ufeff')), 1):
        line = Line(file, number, raw.partition('#')[0].replace('\t', ' ').strip())
        if line.text.startswith('---'):
            if line.text != '---':
                line.fail(f"expected '---' alone on its line, not '{line.text}'")
            sections.append([])
            if len(sections) > wanted:
                lines = f'{wanted - 1 or "no"} line{"s" * (wanted > 2)}'
                line.fail(f"a .{kind} file has {lines} with '---'; this is one too many")
        elif line.text:
            sections[-1].append(line)
    if len(sections) < wanted:
        names = {2: 'request --- response', 3: 'goal --- result --- feedback'}[wanted]
        Line(file, number, '').fail(
            f"expected {wanted - len(sections)} more line{'s' * (wanted - len(sections) > 1)} with '---'",
            help=help_text('parts', kind=kind, names=names),
        )
    return sections


_TYPE = re.compile(
    r'(?P<base>[A-Za-z][\w/]*)(?:<=(?P<string>\d{1,9}))?'
    r'(?P<array>\[(?:(?P<upper><=)?(?P<size>\d{1,9}))?\])?$',
    re.ASCII,
)
_NESTED = re.compile(r'(?:(?P<package>[a-z]\w*)/(?:msg/)?)?(?P<name>[A-Z][A-Za-z0-9]*)$', re.ASCII)
# Type names of other languages and of ROS 1 that students often write.
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
    """Return the type that a string describes, or None if the string is not a type. The base name stays as written."""
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
    """Return the type of a field. Its base is a primitive kind or a full type name.

    :raises InterfaceError: if the string does not describe a type. This function does not check whether a nested type exists.
    """
    written = split_type(text)
    if written is None:
        line.fail(f"'{text}' is not a type", help=help_text('type'))
    bound = written.string_bound
    if bound is not None and written.base not in ('string', 'wstring'):
        line.fail(
            f"only strings have a bound, not '{written.base}'", help=help_text('bounded-list', base=written.base, bound=bound)
        )
    if bound == 0 or (written.array in ('fixed', 'bounded') and written.size == 0):
        line.fail(f"'{text}' has room for nothing: a size must be at least 1")
    return written._replace(base=_base(line, written.base, package))


def _base(line: Line, name: str, package: str) -> str:
    """Return the full name of a type: the name of a primitive kind, or 'pkg/msg/Type'."""
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
    help = help_text('other-word', word=other) if other else did_you_mean(name, PRIMITIVE_NAMES) or help_text('message-type')
    line.fail(f"unknown type '{name}'", help=help)


def constant_value(base: str, text: str) -> Any:
    """Return the value of a constant. A string does not need quotation marks, as in ROS.

    :raises ValueError: if the value is invalid. The message states the expected form.
    """
    if base in ('string', 'wstring'):
        return _string(text, None)
    return _scalar(FieldType(primitive_name(base)), text)


def default_value(field_type: FieldType, text: str) -> Any:
    """Return the default of a field: a scalar, or a tuple for `[1, 2, 3]`.

    :raises ValueError: if the value is invalid. The message states the expected form.
    """
    if not field_type.array:
        return _scalar(field_type, text)
    if not (text.startswith('[') and text.endswith(']')):
        raise ValueError(f'a list in brackets such as [1, 2], not {text}')
    values = tuple(_scalar(field_type.element, item) for item in _items(text[1:-1]))
    wanted = field_type.size
    if field_type.array == 'fixed' and len(values) != wanted:
        raise ValueError(f'{wanted} values, not {len(values)}')
    if field_type.array == 'bounded' and len(values) > wanted:
        raise ValueError(f'at most {wanted} values, not {len(values)}')
    return values


def _items(text: str) -> list[str]:
    """Split a string at the commas that are outside quotation marks."""
    items, start, quote = [], 0, ''
    for index, char in enumerate(text):
        if quote:
            quote = '' if char == quote and text[index - 1] != '\\' else quote
        elif char in '\'"':
            quote = char
        elif char == ',':
            items.append(text[start:index].strip())
            start = index + 1
    last = text[start:].strip()
    return items + [last] if last or items else []


def _scalar(field_type: FieldType, text: str) -> Any:
    kind = KINDS[field_type.base]
    if kind.python is str:
        return _string(text, field_type.string_bound)
    if kind.python is bool:
        return _bool(text)
    if kind.python is float:
        return _float(text, kind.low, kind.high)
    number = _int(text, kind.low, kind.high)
    return bytes([number]) if kind.python is bytes else number


def _bool(text: str) -> bool:
    try:
        return {'true': True, '1': True, 'false': False, '0': False}[text.lower()]
    except KeyError:
        raise ValueError(f'true or false, not {text}') from None


def _float(text: str, low: float, high: float) -> float:
    try:
        value = float(text)
    except ValueError:
        raise ValueError(f'a number, not {text}') from None
    if low <= value <= high or value != value or value in (float('inf'), float('-inf')):
        return value
    raise ValueError(f'a number in [{low!r}, {high!r}], not {text}')


def _int(text: str, low: float, high: float) -> int:
    try:
        value = int(text, 0)
    except ValueError:
        raise ValueError(f'a whole number, not {text}') from None
    if not low <= value <= high:
        raise ValueError(f'a whole number in [{low}, {high}], not {text}')
    return value


def _string(text: str, bound: int | None) -> str:
    value = _unquoted(text)
    if bound is not None and len(value) > bound:
        raise ValueError(f'at most {bound} characters, not {len(value)}')
    return value


def _unquoted(text: str) -> str:
    quote = text[:1]
    if quote not in ('"', "'") or not quote:
        return text
    if len(text) < 2 or text[-1] != quote:
        # ROS cuts a line at the first #, also inside quotes, and would silently keep half a string.
        raise ValueError(f'a closing {quote} on the same line (ROS cuts a line at #, even inside quotes)')
    body = text[1:-1]
    if re.search(rf'(?<!\\){quote}', body):
        raise ValueError(f'one quoted string with a backslash before each inner {quote}, not {text}')
    return body.replace('\\' + quote, quote)
