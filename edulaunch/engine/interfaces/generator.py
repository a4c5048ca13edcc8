"""Creates message classes: their Python source, and the objects that the source needs.

A simulation spends most of its time in snapshots, so each class has generated code without loops and calls. The code for
nested messages is inlined, and their slots are set directly without checks. All values outside lists are copied together, as
one tuple. All float32 values are rounded together, with one call of `pack` and `unpack` of `struct`.
"""

from __future__ import annotations

from array import array
from collections.abc import Callable
from math import isfinite
from operator import attrgetter
from struct import Struct
from typing import Any

from edulaunch.engine.interfaces.field_rule import FieldRule
from edulaunch.engine.interfaces.layout import (
    Branch,
    Layout,
    Leaf,
    default_wire,
    is_byte_like,
    is_fixed_numbers,
    is_number_sequence,
    layout_of,
)
from edulaunch.engine.interfaces.message import ConstantsStay, Lazy, Message, set_fields
from edulaunch.engine.interfaces.spec import KINDS, Field, FieldType, MessageSpec, module_name


class ClassSource:
    """The generator of the source of one class. Call :meth:`text` first; then `names` contains the globals that the source needs.

    `names` maps a global name to its meaning: ('class', type), ('rule', type, field name), or ('default', wire value).
    """

    def __init__(self, spec: MessageSpec, layout: Layout) -> None:
        self._spec = spec
        self._branches = layout.branches
        self._leaves = layout.leaves
        self._name = spec.type.split('/')[2]
        self._ids: dict[tuple[object, ...], str] = {}

    @property
    def names(self) -> dict[str, tuple[object, ...]]:
        """The global names in the generated source, each with its meaning."""
        return {name: key for key, name in self._ids.items()}

    def text(self) -> str:
        """Return the source of the whole class."""
        slots = ', '.join(f"'_{field.name}'" for field in self._spec.fields)
        lines = [
            f'class Metaclass_{self._name}(_Metaclass):',
            f' "Metaclass of message {self._name!r}."',
            f'class {self._name}(_Message, metaclass=Metaclass_{self._name}):',
            f' "Message class {self._name!r}."',
            f' __slots__ = ({slots}{"," if slots else ""})',
        ]
        for part in (self._init(), self._to_wire(), self._from_wire(), self._eq(), *map(self._field, self._spec.fields)):
            lines += [f' {line}' for line in part]
        return '\n'.join(lines) + '\n'

    def _global(self, *key: object) -> str:
        if key not in self._ids:
            self._ids[key] = f'_{str(key[0])[0].upper()}{len(self._ids)}'
        return self._ids[key]

    def _rule(self, leaf: Leaf) -> str:
        return self._global('rule', leaf.owner, leaf.field.name)

    def _create(self, branch: Branch) -> str:
        return f' {branch.variable} = {branch.holder}.{branch.slot} = _new({self._global("class", branch.type)})'

    # Construction

    def _init(self) -> list[str]:
        single = [leaf for leaf in self._leaves if not leaf.type.array]
        lines = ['def __init__(m, /, **kwargs):', *map(self._create, self._branches)]
        if single:
            targets, values = (
                ', '.join(part) for part in zip(*((leaf.target, self._constant(leaf)) for leaf in single), strict=True)
            )
            lines.append(f' {targets} = {values}')
        lines += [f' {leaf.target} = {self._fresh(leaf)}' for leaf in self._leaves if leaf.type.array]
        return [*lines, ' if kwargs: _set_fields(m, kwargs)']

    def _constant(self, leaf: Leaf) -> str:
        value = default_wire(leaf.field)
        return self._global('default', leaf.path, value) if isinstance(value, float) and not isfinite(value) else repr(value)

    def _fresh(self, leaf: Leaf) -> str:
        """Return an expression for the default of a repeated field: a new object unless it is immutable."""
        field_type = leaf.type
        if field_type.kind is None:
            one = self._global('class', field_type.base)
            return f'[{one}() for _ in range({field_type.size})]' if field_type.array == 'fixed' else '[]'
        if is_fixed_numbers(field_type):
            return self._global('default', leaf.path, default_wire(leaf.field))
        if is_number_sequence(field_type):
            values = f', {self._global("default", leaf.path, leaf.field.default)}' if leaf.field.default else ''
            return f"_array('{field_type.kind.code}'{values})"
        return repr(list(leaf.field.default)) if leaf.field.default is not None else self._zeros(field_type)

    @staticmethod
    def _zeros(field_type: FieldType) -> str:
        assert field_type.kind is not None
        one = "b'\\x00'" if field_type.base == 'byte' else repr(field_type.kind.python())
        return f'[{one}] * {field_type.size}' if field_type.array == 'fixed' else '[]'

    # Snapshots

    def _to_wire(self) -> list[str]:
        lines = [
            '@staticmethod',
            'def to_wire(m):',
            *(f' {branch.variable} = {branch.holder}.{branch.slot}' for branch in self._branches),
        ]
        rounded = [leaf for leaf in self._leaves if leaf.type == FieldType('float32')]
        round_trip = f'_unpack(_pack({", ".join(leaf.target for leaf in rounded)}))'
        if rounded and len(rounded) == len(self._leaves):
            return [*lines, f' return {round_trip}']
        names = {leaf.path: f'f{index}' for index, leaf in enumerate(rounded)}
        if rounded:
            lines.append(f' {"".join(f"{name}, " for name in names.values())} = {round_trip}')
        for leaf in self._leaves:
            if leaf.type.kind is None:
                lines += self._check_elements(leaf)
        values = ''.join(f'{names.get(leaf.path) or self._wire_of(leaf)}, ' for leaf in self._leaves)
        return [*lines, f' return ({values})']

    def _check_elements(self, leaf: Leaf) -> list[str]:
        """Add code that checks lists of messages, because such a list is an ordinary list, to which a student may append any
        object.
        """
        cls, refuse = (self._global('class', leaf.type.base), f'{self._rule(leaf)}.refuse_elements({leaf.target})')
        lines = [f' for i in {leaf.target}:', f'  if type(i) is not {cls}: {refuse}']
        if leaf.type.array != 'unbounded':
            operator = '!=' if leaf.type.array == 'fixed' else '>'
            lines.append(f' if len({leaf.target}) {operator} {leaf.type.size}: {refuse}')
        return lines

    def _wire_of(self, leaf: Leaf) -> str:
        field_type, target = leaf.type, leaf.target
        if not field_type.array:
            return target
        if field_type.kind is None:
            to_wire = f'{self._global("to_wire", field_type.base)}'
            return f'tuple([{to_wire}(i) for i in {target}])'
        if is_fixed_numbers(field_type):
            stored = 'bytes' if is_byte_like(field_type) else 'tuple'
            return f'({target} if type({target}) is {stored} else {self._rule(leaf)}.fixed_to_wire({target}))'
        if field_type.array == 'unbounded' and is_number_sequence(field_type):
            return f'{target}.tobytes()' if is_byte_like(field_type) else f'tuple({target})'
        return f'{self._rule(leaf)}.{"array" if is_number_sequence(field_type) else "list"}_to_wire({target})'

    def _from_wire(self) -> list[str]:
        lines = ['@staticmethod', 'def from_wire(wire):', f' m = _new({self._name})', *map(self._create, self._branches)]
        names = {
            leaf.path: f'v{index}'
            for index, leaf in enumerate(self._leaves)
            if leaf.type.array and not is_fixed_numbers(leaf.type)
        }
        if self._leaves:
            lines.append(f' {"".join(f"{names.get(leaf.path, leaf.target)}, " for leaf in self._leaves)} = wire')
        lines += [
            f' {leaf.target} = {self._object_of(leaf.type, names[leaf.path])}' for leaf in self._leaves if leaf.path in names
        ]
        return [*lines, ' return m']

    def _object_of(self, field_type: FieldType, name: str) -> str:
        if field_type.kind is None:
            return f'[{self._global("from_wire", field_type.base)}(i) for i in {name}]'
        if is_number_sequence(field_type):
            return f"_array('{field_type.kind.code}', {name})"
        return f'[{name}[i:i + 1] for i in range(len({name}))]' if is_byte_like(field_type) else f'list({name})'

    def _eq(self) -> list[str]:
        fixed = {leaf.field.name: leaf for leaf in self._leaves if is_fixed_numbers(leaf.type) and leaf.holder == 'm'}
        tests = []
        for field in self._spec.fields:
            leaf = fixed.get(field.name)
            mine, other = (
                (f'm._{field.name}', f'o._{field.name}')
                if leaf is None
                else (self._wire_of(leaf), self._wire_of(leaf.held_by('o')))
            )
            tests.append(f' and {mine} == {other}')
        return ['def __eq__(m, o, /):', f' return isinstance(o, {self._name})' + ''.join(tests)]

    # Properties

    def _field(self, field: Field) -> list[str]:
        slot = f'm._{field.name}'
        rule = self._global('rule', self._spec.type, field.name)
        lines = [f'def {field.name}(m, value):']
        test = self._is_right(field.type)
        if test:
            lines += [f' if {test}: {slot} = value', f' else: {slot} = {rule}.accept(value)']
        else:
            lines.append(f' {slot} = {rule}.accept(value)')
        getter = f"_get('_{field.name}')"
        if is_fixed_numbers(field.type):
            getter = f'_read_{field.name}'
            stored = 'bytes' if is_byte_like(field.type) else 'tuple'
            lines += [f'def {getter}(m):', f' if type({slot}) is {stored}: {slot} = {rule}.to_numpy({slot})', f' return {slot}']
        return [*lines, f'{field.name} = _property({getter}, {field.name})']

    def _is_right(self, field_type: FieldType) -> str:
        """Return the source of a quick test that accepts the most common valid values. The rule of the field checks all
        others.
        """
        kind = field_type.kind
        if field_type.array or field_type.string_bound is not None or field_type.base == 'byte':
            return ''
        if kind is None:
            return f'type(value) is {self._global("class", field_type.base)}'
        limits = f' and {kind.low!r} <= value <= {kind.high!r}' if kind.is_number and kind.name != 'float64' else ''
        return f'type(value) is {kind.python.__name__}{limits}'


MessageOf = Callable[[str], type[Message]]


def make_message(spec: MessageSpec, message_of: MessageOf) -> type[Message]:
    """Return the class of a message.

    :param spec: the definition of the message.
    :param message_of: a function that returns the class of a nested message type.
    """
    nested = {field.name: message_of(field.type.base) for field in spec.fields if field.type.kind is None}
    layout = layout_of(spec, lambda type_name: message_of(type_name)._SPEC)
    rules = {field.name: FieldRule(field, nested.get(field.name)) for field in spec.fields}
    source = ClassSource(spec, layout)
    text = source.text()
    names = _globals(spec, sum(leaf.type.text == 'float32' for leaf in layout.leaves))
    for name, key in source.names.items():
        names[name] = _meaning(key, spec.type, rules, message_of)
    exec(compile(text, f'<interface {spec.type}>', 'exec', dont_inherit=True), names)
    cls: type[Message] = names[spec.type.split('/')[2]]
    _complete(cls, spec)
    cls.LAYOUT = layout
    cls._RULES = rules
    return cls


def _globals(spec: MessageSpec, float32s: int) -> dict[str, Any]:
    rounding = Struct(f'<{float32s}f')
    return {
        '__name__': module_of(spec.type),
        '_Message': Message,
        '_Metaclass': ConstantsStay,
        '_new': object.__new__,
        '_array': array,
        '_get': attrgetter,
        '_property': property,
        '_set_fields': set_fields,
        '_pack': rounding.pack,
        '_unpack': rounding.unpack,
    }


def _meaning(key: tuple[Any, ...], own: str, rules: dict[str, FieldRule], message_of: MessageOf) -> Any:
    what, *rest = key
    if what == 'class':
        return message_of(rest[0])
    if what == 'rule':
        return rules[rest[1]] if rest[0] == own else message_of(rest[0])._RULES[rest[1]]
    return getattr(message_of(rest[0]), what) if what in ('to_wire', 'from_wire') else rest[1]


def _complete(cls: type[Message], spec: MessageSpec) -> None:
    """Add all attributes that are not part of the generated source."""
    cls.TYPE = spec.type
    cls._SPEC = spec
    cls._FIELDS = {field.name: field.type.ros_text for field in spec.fields}
    own_slots = [f'_{field.name}' for field in spec.fields]
    # copy, deepcopy and pickle read this instead of __slots__, which has an extra slot in rclpy.
    cls.__slotnames__ = own_slots
    cls.__slots__ = [*own_slots, '_check_fields']
    lazy = {'SLOT_TYPES': Lazy(lambda: _slot_types(spec))}
    for field in spec.fields:
        if field.default is not None:
            lazy[f'{field.name.upper()}__DEFAULT'] = Lazy(lambda field=field: default_object(field))  # type: ignore[misc]
    for name, attribute in lazy.items():
        attribute.__set_name__(cls, name)
        setattr(cls, name, attribute)
    for constant in spec.constants:
        setattr(cls, constant.name, constant.value)
    if spec.constants:
        cls._constants = frozenset(constant.name for constant in spec.constants)


def _slot_types(spec: MessageSpec) -> tuple[object, ...]:
    from edulaunch.engine.interfaces.slot_types import slot_types  # imported here, because few programs read the slot types

    return slot_types(spec)


def default_object(field: Field) -> Any:
    """Return the default of a field as the object that a program gets when it reads the field."""
    if is_fixed_numbers(field.type):
        return FieldRule(field, None).to_numpy(default_wire(field))
    if is_number_sequence(field.type):
        return array(KINDS[field.type.base].code, field.default)
    return list(field.default) if field.type.array else default_wire(field)


def module_of(type_name: str) -> str:
    """Return the `__module__` of the class of a type: 'geometry_msgs.msg._transform_stamped'.

    The parts of a service have the same module as the service.
    """
    package, kind, name = type_name.split('/')
    return f'{package}.{kind}._{module_name(name.partition("_")[0])}'
