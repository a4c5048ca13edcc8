"""Makes a class from a spec."""

from __future__ import annotations

from array import array
from collections.abc import Callable
from operator import attrgetter
from struct import Struct
from typing import Any

from edulaunch.interfaces.field_rule import FieldRule
from edulaunch.interfaces.kinds import KINDS
from edulaunch.interfaces.layout import default_wire, is_fixed_numbers, is_number_sequence, layout_of
from edulaunch.interfaces.message import Lazy, Message, set_fields
from edulaunch.interfaces.naming import module_name
from edulaunch.interfaces.source import ClassSource
from edulaunch.interfaces.spec import Field, MessageSpec

MessageOf = Callable[[str], type[Message]]


def make_message(spec: MessageSpec, message_of: MessageOf) -> type[Message]:
    """The class of a message; `message_of` gives the classes of the types it contains."""
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
    """Everything that needs no generated code."""
    cls.TYPE = spec.type
    cls._SPEC = spec
    cls._FIELDS = {field.name: field.type.ros_text for field in spec.fields}
    own_slots = [f'_{field.name}' for field in spec.fields]
    # Read by copy, deepcopy and pickle instead of __slots__, which rclpy's own extra slot must be part of.
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
    from edulaunch.interfaces.slot_types import slot_types  # late: few programs ever look at it

    return slot_types(spec)


def default_object(field: Field) -> Any:
    """A field's default as its reader sees it."""
    if is_fixed_numbers(field.type):
        return FieldRule(field, None).to_numpy(default_wire(field))
    if is_number_sequence(field.type):
        return array(KINDS[field.type.base].code, field.default)
    return list(field.default) if field.type.array else default_wire(field)


def module_of(type_name: str) -> str:
    """The module that a class says it comes from: 'geometry_msgs.msg._transform_stamped'. Parts of a service
    share its module.
    """
    package, kind, name = type_name.split('/')
    return f'{package}.{kind}._{module_name(name.partition("_")[0])}'
