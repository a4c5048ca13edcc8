"""Wire tuples without their classes: legality, JSON, columns.

A recording stores, beside its wire tuples, the *form* of each type: the dotted path and the .msg notation of
every entry. That is enough to read the recording back when the interface files are gone, and to refuse data
that no real message could have produced.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from struct import Struct
from typing import Any, NoReturn

from edulaunch.errors import InterfaceError
from edulaunch.interfaces.layout import is_byte_like
from edulaunch.interfaces.message import Message
from edulaunch.interfaces.spec import FieldType
from edulaunch.interfaces.type_text import split_type

Form = Sequence[Sequence[str]]
"""(path, type text) of each entry of a wire tuple; survives JSON."""

_ROUND = Struct('<f')


def forms_of(cls: type[Message]) -> dict[str, tuple[tuple[str, str], ...]]:
    """The forms of a message class and of all message types that its repeated fields hold, by type name."""
    forms: dict[str, tuple[tuple[str, str], ...]] = {}
    waiting = [cls]
    while waiting:
        each = waiting.pop()
        forms.setdefault(each.TYPE, each.wire_type())
        found = [rule.message for rule in _rules(each) if rule.type.array and rule.message is not None]
        waiting += [message for message in found if message.TYPE not in forms]
    return forms


def _rules(cls: type[Message]) -> list[Any]:
    """The rules of a class's fields and of its nested messages' fields."""
    rules = []
    for rule in cls._RULES.values():
        rules.append(rule)
        if rule.message is not None and not rule.type.array:
            rules += _rules(rule.message)
    return rules


class Forms:
    """Reads and checks wire data by the forms of its types.

    :param forms: type name -> form, as `forms_of` gives it or as JSON gives it back.
    :raises InterfaceError: when a form is damaged.
    """

    def __init__(self, forms: Mapping[str, Form]) -> None:
        self._forms = {name: tuple((path, _type_of(text)) for path, text in form) for name, form in forms.items()}

    def columns(self, type_name: str, wires: Iterable[tuple[Any, ...]]) -> dict[str, tuple[Any, ...]]:
        """The entries of many wire tuples by path: {'linear.x': (2.0, 2.0, ...), ...}."""
        paths = [path for path, _ in self._form(type_name)]
        columns = tuple(zip(*wires, strict=True)) or ((),) * len(paths)
        return dict(zip(paths, columns, strict=True))

    def to_json(self, type_name: str, wire: tuple[Any, ...]) -> list[Any]:
        """The wire tuple as lists, numbers and strings; bytes become strings of the characters 0 to 255."""
        return [
            self._entry_to_json(field_type, value) for (_, field_type), value in zip(self._form(type_name), wire, strict=True)
        ]

    def _entry_to_json(self, field_type: FieldType, value: Any) -> Any:
        if isinstance(value, bytes):
            return value.decode('latin-1')
        if not field_type.array:
            return value
        return list(value) if field_type.kind else [self.to_json(field_type.base, item) for item in value]

    def wire(self, type_name: str, data: Any) -> tuple[Any, ...]:
        """The wire tuple in `data`, which may be JSON's lists and strings or come from a stranger as a tuple.

        :raises InterfaceError: naming the path, unless a message of this type could have that wire tuple.
        """
        form = self._form(type_name)
        if not isinstance(data, (list, tuple)) or len(data) != len(form):
            raise InterfaceError(f'{type_name}: expected {len(form)} values, not {_brief(data)}')
        return tuple(
            self._entry(f'{type_name}: {path}', field_type, value) for (path, field_type), value in zip(form, data, strict=True)
        )

    def _form(self, type_name: str) -> tuple[tuple[str, FieldType], ...]:
        try:
            return self._forms[type_name]
        except KeyError:
            raise InterfaceError(f"the form of '{type_name}' is missing") from None

    def _entry(self, where: str, field_type: FieldType, value: Any) -> Any:
        if not field_type.array:
            return _single(where, field_type, value)
        if is_byte_like(field_type):
            several: Any = _bytes(where, value)
        elif not isinstance(value, (list, tuple)):
            _refuse(where, field_type, value)
        elif field_type.kind is None:
            several = tuple(self.wire(field_type.base, item) for item in value)
        else:
            several = tuple(_single(where, field_type.element, item) for item in value)
        legal = {'fixed': len(several) == field_type.size, 'bounded': len(several) <= field_type.size}
        if not legal.get(field_type.array, True):
            _refuse(where, field_type, value)
        return several


def _single(where: str, field_type: FieldType, given: Any) -> Any:
    kind = field_type.kind
    if kind is None:  # a damaged form: nested messages have no entry of their own
        _refuse(where, field_type, given)
    value: Any = _bytes(where, given) if kind.python is bytes else given
    if not _has_type(value, kind.python):
        _refuse(where, field_type, value)
    if kind.python is bytes:
        legal = len(value) == 1
    elif kind.python is str:
        legal = field_type.string_bound is None or len(value) <= field_type.string_bound
    else:
        legal = kind.low <= value <= kind.high or (kind.python is float and (value != value or abs(value) == float('inf')))
    if not legal:
        _refuse(where, field_type, value)
    return _ROUND.unpack(_ROUND.pack(value))[0] if kind.name == 'float32' else value


def _has_type(value: Any, wanted: type) -> bool:
    return type(value) is wanted  # True is no int, and 1 no float


def _bytes(where: str, value: Any) -> bytes:
    try:
        return value if type(value) is bytes else bytes(value.encode('latin-1'))
    except (AttributeError, UnicodeEncodeError):
        raise InterfaceError(f'{where}: expected bytes, not {_brief(value)}') from None


def _refuse(where: str, field_type: FieldType, value: Any) -> NoReturn:
    raise InterfaceError(f'{where}: expected {field_type.text}, not {_brief(value)}')


def _type_of(text: str) -> FieldType:
    written = split_type(text)
    if written is None:
        raise InterfaceError(f"'{text}' is no type of a wire form")
    return written


def _brief(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f'{text[:57]}...'
