"""Reads the text of .msg, .srv and .action files."""

from __future__ import annotations

import re
from keyword import iskeyword
from typing import NamedTuple, NoReturn

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.kinds import KINDS, PRIMITIVE_NAMES, primitive_name
from edulaunch.interfaces.literals import constant_value, default_value
from edulaunch.interfaces.naming import did_you_mean
from edulaunch.interfaces.spec import (
    ActionSpec,
    Constant,
    Field,
    FieldType,
    InterfaceSpec,
    MessageSpec,
    ServiceSpec,
)

FIELD_NAME = '^(?!.*__)(?!.*_$)[a-z][a-z0-9_]*$'
CONSTANT_NAME = '^[A-Z]([A-Z0-9_]?[A-Z0-9]+)*$'
_TYPE = re.compile(
    r'(?P<base>[A-Za-z][\w/]*)(?:<=(?P<string>\d{1,9}))?(?P<array>\[(?:(?P<upper><=)?(?P<size>\d{1,9}))?\])?$',
    re.ASCII,
)
_NESTED = re.compile(r'(?:(?P<package>[a-z]\w*)/(?:msg/)?)?(?P<name>[A-Z][A-Za-z0-9]*)$', re.ASCII)
_CONSTANT_NAME = re.compile(
    '[A-Z](?:_?[A-Z0-9])*$'
)  # the same names as ROS's pattern, without its exponential backtracking
_CONSTANT = re.compile(r'(?P<name>\w+)\s*=\s*(?P<value>.*)$')
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
# Names that the generated classes use themselves.
_RESERVED = frozenset(
    {
        'to_wire',
        'from_wire',
        'wire_type',
        'get_fields_and_field_types',
        'check_fields',
        'TYPE',
        'SLOT_TYPES',
        'LAYOUT',
    }
)


class _Line(NamedTuple):
    file: str
    number: int
    text: str

    def fail(self, message: str, help: str | None = None) -> NoReturn:
        raise InterfaceError(f'{self.file}:{self.number}: {message}', help=help)


def parse(text: str, type_name: str, file: str = '') -> InterfaceSpec:
    """The interface that `text` describes; the kind (msg, srv, action) is taken from `type_name`, such as
    'turtlesim/srv/Spawn'.

    :param file: named in errors; the type name is used when it is empty.
    :raises InterfaceError: with file, line, what was expected and the nearest known name.
    """
    package, kind, name = type_name.split('/')
    file = file or type_name
    parts = {'msg': [''], 'srv': ['_Request', '_Response'], 'action': ['_Goal', '_Result', '_Feedback']}[kind]
    sections = _sections(text, file, kind, len(parts))
    messages = [
        _message(lines, f'{package}/{kind}/{name}{part}', file)
        for lines, part in zip(sections, parts, strict=True)
    ]
    if kind == 'srv':
        return ServiceSpec(type_name, *messages)
    return ActionSpec(type_name, *messages) if kind == 'action' else messages[0]


def _sections(text: str, file: str, kind: str, wanted: int) -> list[list[_Line]]:
    """The lines between the `---`, without comments and blanks."""
    sections: list[list[_Line]] = [[]]
    number = 0
    for number, raw in enumerate(re.split('\r\n|\r|\n', text.removeprefix('\ufeff')), 1):
        line = _Line(file, number, raw.partition('#')[0].replace('\t', ' ').strip())
        if line.text.startswith('---'):
            if line.text != '---':
                line.fail(f"expected '---' alone on its line, not '{line.text}'")
            sections.append([])
            if len(sections) > wanted:
                line.fail(
                    f"a .{kind} file has {wanted - 1 or 'no'} line{'s' * (wanted > 2)} with '---'; this is one too many"
                )
        elif line.text:
            sections[-1].append(line)
    if len(sections) < wanted:
        names = {2: 'request --- response', 3: 'goal --- result --- feedback'}[wanted]
        _Line(file, number, '').fail(
            f"expected {wanted - len(sections)} more line{'s' * (wanted - len(sections) > 1)} with '---'",
            help=f'a .{kind} file is: {names}; a part may be empty',
        )
    return sections


def _message(lines: list[_Line], type_name: str, file: str) -> MessageSpec:
    fields: list[Field] = []
    constants: list[Constant] = []
    seen: dict[str, int] = {}
    for line in lines:
        entry = _entry(line, type_name.split('/')[0])
        if entry.name in seen:
            line.fail(f"'{entry.name}' is already the name of line {seen[entry.name]}")
        seen[entry.name] = line.number
        if isinstance(entry, Field):
            fields.append(entry)
        else:
            constants.append(entry)
    return MessageSpec(type_name, tuple(fields), tuple(constants), file)


def _entry(line: _Line, package: str) -> Field | Constant:
    type_text, _, rest = line.text.partition(' ')
    rest = rest.strip()
    if not rest:
        line.fail(f"expected a type and a name, such as 'float64 x', not '{line.text}'")
    field_type = _field_type(line, type_text, package)
    constant = _CONSTANT.match(rest)
    if constant:
        return _constant(line, field_type, constant['name'], constant['value'].strip())
    return _field(line, field_type, rest)


def _constant(line: _Line, field_type: FieldType, name: str, text: str) -> Constant:
    if field_type.array or field_type.kind is None:
        line.fail(
            f"a constant must have a primitive type, not '{field_type.text}'",
            help='a default has no =: int32[] values [1, 2]',
        )
    if not _CONSTANT_NAME.match(name):
        line.fail(
            f"'{name}' is an invalid constant name. It should have the pattern '{CONSTANT_NAME}'",
            help=f"write {name.upper()} for a constant, or leave out the '=' for a default value",
        )
    _refuse_reserved(line, name)
    try:
        return Constant(name, field_type.base, constant_value(field_type.base, text))
    except ValueError as error:
        line.fail(f"constant '{name}' of type '{field_type.text}' expected {error}")


def _field(line: _Line, field_type: FieldType, rest: str) -> Field:
    name, _, text = rest.partition(' ')
    if not re.match(FIELD_NAME, name, re.ASCII):
        line.fail(
            f"'{name}' is an invalid field name. It should have the pattern '{FIELD_NAME}'",
            help='lower-case letters, digits and single underscores, starting with a letter',
        )
    _refuse_reserved(line, name)
    text = text.strip()
    if not text:
        return Field(name, field_type, None, line.number)
    if field_type.kind is None:
        line.fail(
            f"field '{name}' of type '{field_type.text}' cannot have a default",
            help='only primitive types have defaults',
        )
    try:
        return Field(name, field_type, default_value(field_type, text), line.number)
    except ValueError as error:
        line.fail(f"the default of '{name}' of type '{field_type.text}' expected {error}")


def _refuse_reserved(line: _Line, name: str) -> None:
    if name in _RESERVED or iskeyword(name):
        why = 'a word of Python' if iskeyword(name) else 'used by every message class'
        line.fail(
            f"'{name}' cannot be a name here: it is {why}", help=f"choose another, such as '{name}_value'"
        )


def _field_type(line: _Line, text: str, package: str) -> FieldType:
    match = _TYPE.match(text)
    if match is None:
        line.fail(
            f"'{text}' is not a type",
            help='types look like float64, string<=10, int32[], int32[3], int32[<=3], pkg/Type',
        )
    bound = int(match['string']) if match['string'] else None
    if bound is not None and match['base'] not in ('string', 'wstring'):
        line.fail(
            f"only strings have a bound, not '{match['base']}'",
            help=f'for a bounded list write {match["base"]}[<={bound}]',
        )
    array = (
        ''
        if match['array'] is None
        else 'bounded'
        if match['upper']
        else 'fixed'
        if match['size']
        else 'unbounded'
    )
    size = int(match['size'] or 0)
    if bound == 0 or (array in ('fixed', 'bounded') and size == 0):
        line.fail(f"'{text}' has room for nothing: a size must be at least 1")
    return FieldType(_base(line, match['base'], package), bound, array, size)


def _base(line: _Line, name: str, package: str) -> str:
    """The full name of a type: a primitive, or 'pkg/msg/Type'."""
    if primitive_name(name) in KINDS:
        return primitive_name(name)
    if name == 'Header':
        return 'std_msgs/msg/Header'
    nested = _NESTED.match(name)
    if nested:
        return f'{nested["package"] or package}/msg/{nested["name"]}'
    if name in _OTHER_WORDS:
        line.fail(f"unknown type '{name}'", help=f'did you mean {_OTHER_WORDS[name]}?')
    line.fail(
        f"unknown type '{name}'",
        help=did_you_mean(name, PRIMITIVE_NAMES)
        or 'a message type starts with a capital letter: Name for this package, other_package/Name for another one',
    )
