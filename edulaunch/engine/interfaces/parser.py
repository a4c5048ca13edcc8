"""Parses the content of .msg, .srv and .action files."""

from __future__ import annotations

import re
from keyword import iskeyword

from edulaunch.engine.interfaces.notation import Line, constant_value, default_value, field_type, sections_of
from edulaunch.engine.interfaces.spec import ActionSpec, Constant, Field, FieldType, InterfaceSpec, MessageSpec, ServiceSpec
from edulaunch.engine.underlay_place import help_text

FIELD_NAME = '^(?!.*__)(?!.*_$)[a-z][a-z0-9_]*$'
CONSTANT_NAME = '^[A-Z]([A-Z0-9_]?[A-Z0-9]+)*$'
# The same names as ROS's pattern above, without its exponential backtracking.
_CONSTANT_NAME = re.compile('[A-Z](?:_?[A-Z0-9])*$')
_CONSTANT = re.compile(r'(?P<name>\w+)\s*=\s*(?P<value>.*)$')
# Names that the generated classes use themselves.
_RESERVED = frozenset(
    ('to_wire', 'from_wire', 'wire_type', 'get_fields_and_field_types', 'check_fields', 'TYPE', 'SLOT_TYPES', 'LAYOUT')
)


def parse(text: str, type_name: str, file: str = '') -> InterfaceSpec:
    """Return the interface that `text` defines.

    :param text: the content of the interface file.
    :param type_name: the full name, such as 'turtlesim/srv/Spawn', which contains the kind of interface.
    :param file: the path of the file, for error messages (default: the type name).
    :raises InterfaceError: with file, line, the expected form and, for a misspelt name, the nearest known name.
    """
    package, kind, name = type_name.split('/')
    file = file or type_name
    parts = {'msg': [''], 'srv': ['_Request', '_Response'], 'action': ['_Goal', '_Result', '_Feedback']}[kind]
    sections = sections_of(text, file, kind, len(parts))
    messages = [_message(lines, f'{package}/{kind}/{name}{part}', file) for lines, part in zip(sections, parts, strict=True)]
    if kind == 'srv':
        return ServiceSpec(type_name, *messages)
    return ActionSpec(type_name, *messages) if kind == 'action' else messages[0]


def _message(lines: list[Line], type_name: str, file: str) -> MessageSpec:
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


def _entry(line: Line, package: str) -> Field | Constant:
    type_text, _, rest = line.text.partition(' ')
    rest = rest.strip()
    if not rest:
        line.fail(f"expected a type and a name, such as 'float64 x', not '{line.text}'")
    written = field_type(line, type_text, package)
    constant = _CONSTANT.match(rest)
    if constant:
        return _constant(line, written, constant['name'], constant['value'].strip())
    return _field(line, written, rest)


def _constant(line: Line, type_: FieldType, name: str, text: str) -> Constant:
    if type_.array or type_.kind is None:
        line.fail(f"a constant must have a primitive type, not '{type_.text}'", help=help_text('constant-type'))
    if not _CONSTANT_NAME.match(name):
        line.fail(
            f"'{name}' is an invalid constant name. It should have the pattern '{CONSTANT_NAME}'",
            help=help_text('constant-name', name=name.upper()),
        )
    _refuse_reserved(line, name)
    try:
        return Constant(name, type_.base, constant_value(type_.base, text))
    except ValueError as error:
        line.fail(f"constant '{name}' of type '{type_.text}' expected {error}")


def _field(line: Line, type_: FieldType, rest: str) -> Field:
    name, _, text = rest.partition(' ')
    if not re.match(FIELD_NAME, name, re.ASCII):
        line.fail(f"'{name}' is an invalid field name. It should have the pattern '{FIELD_NAME}'", help=help_text('field-name'))
    _refuse_reserved(line, name)
    text = text.strip()
    if not text:
        return Field(name, type_, None, line.number)
    if type_.kind is None:
        line.fail(f"field '{name}' of type '{type_.text}' cannot have a default", help=help_text('default'))
    try:
        return Field(name, type_, default_value(type_, text), line.number)
    except ValueError as error:
        line.fail(f"the default of '{name}' of type '{type_.text}' expected {error}")


def _refuse_reserved(line: Line, name: str) -> None:
    if name in _RESERVED or iskeyword(name):
        why = 'a word of Python' if iskeyword(name) else 'used by every message class'
        line.fail(f"'{name}' cannot be a name here: it is {why}", help=help_text('reserved', name=name))
