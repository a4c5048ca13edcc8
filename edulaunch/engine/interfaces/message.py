"""The base class of all generated message classes, and class attributes that are computed on first use."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn

from edulaunch.engine.facts import with_facts
from edulaunch.engine.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.layout import Layout
    from edulaunch.engine.interfaces.spec import MessageSpec


class Lazy:
    """A class attribute that is computed when it is first read. The result is then stored on the class."""

    def __init__(self, compute: Callable[[], Any]) -> None:
        self._compute = compute

    def __set_name__(self, owner: type, name: str) -> None:
        self._name = name

    def __get__(self, instance: object, owner: type) -> Any:
        value = self._compute()
        setattr(owner, self._name, value)
        return value


class ConstantsStay(type):
    """The base class of the metaclasses of messages. A program cannot assign to the constants of a message type, as in rclpy."""

    _TYPE_SUPPORT: Any = None
    _constants: frozenset[str] = frozenset()

    def __setattr__(cls, name: str, value: object) -> None:
        if name in cls._constants:
            error = AttributeError(f"property {name!r} of 'Metaclass_{cls.__name__}' object has no setter")
            raise with_facts(error, 'messages.constant', constant=name, type=cls.__name__)
        super().__setattr__(name, value)

    @classmethod
    def __import_type_support__(mcs) -> None:
        """Do nothing, because only the real rclpy needs type support in C."""


class Message(metaclass=ConstantsStay):
    """The common base of all message classes; their fields behave as in rclpy.

    `to_wire(msg)` returns the flat immutable snapshot of a message (see `layout`), and `from_wire(wire)` creates a message from a
    snapshot.
    """

    __slots__: list[str] = []
    TYPE: ClassVar[str]
    LAYOUT: ClassVar[Layout]
    SLOT_TYPES: ClassVar[tuple[Any, ...]]
    _SPEC: ClassVar[MessageSpec]
    _FIELDS: ClassVar[dict[str, str]]
    _RULES: ClassVar[dict[str, Any]]
    _CODEC: ClassVar[Any]
    to_wire: ClassVar[Callable[[Any], tuple[Any, ...]]]
    from_wire: ClassVar[Callable[[Any], Any]]
    if TYPE_CHECKING:

        def __init__(self, **kwargs: Any) -> None: ...

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Return the type of each field as a string, by field name, such as {'linear': 'geometry_msgs/Vector3'}."""
        return dict(cls._FIELDS)

    @classmethod
    def wire_type(cls) -> tuple[tuple[str, str], ...]:
        """Return the entries of a wire tuple, in order, as pairs (dotted path, type in .msg notation)."""
        return tuple((leaf.path, leaf.type.text) for leaf in cls.LAYOUT.leaves)

    @property
    def _check_fields(self) -> bool:
        """True, because fields are always checked. In ROS 2 Jazzy, `check_fields` can switch these checks off."""
        return True

    def __repr__(self) -> str:
        cls = type(self)
        package, kind = cls.TYPE.split('/')[:2]
        values = []
        for name, text in cls._FIELDS.items():
            value = getattr(self, name)
            # Sequences of numbers are shown as plain lists, as rclpy does; everything else as itself.
            shown = value.tolist() if text.startswith('sequence<') and hasattr(value, 'typecode') else value
            values.append(f'{name}={shown!r}')
        return f'{package}.{kind}.{cls.__name__}({", ".join(values)})'


def spec_of(message: Message | type[Message]) -> MessageSpec:
    """Return the definition of a message. The class has no public attribute for it, because a field could have the same name."""
    return message._SPEC


def rules_of(message: Message | type[Message]) -> dict[str, Any]:
    """Return the rule of each field by name; `rules_of(m)['pose'].message` is the class of a nested message."""
    return message._RULES


class Notices:
    """The functions to call for mistakes that a message class accepts without an error.

    :ivar ignored: called with the class, the ignored name, and the nearest field name or None.
    """

    ignored: ClassVar[Callable[[type[Message], str, str | None], None] | None] = None


def set_fields(message: Message, values: dict[str, Any]) -> None:
    """Set the fields of a message from the keyword arguments of its constructor.

    As in Jazzy, unknown names are ignored, unless `check_fields` is true.

    :raises AssertionError: with rclpy's message, for the first value of a wrong type. With `check_fields`, also for unknown
        names.
    """
    fields = message._FIELDS
    if not values.keys() <= fields.keys():
        unknown = sorted(values.keys() - fields.keys() - {'check_fields'})
        if unknown and values.get('check_fields'):
            _refuse_arguments(message, unknown)
        if unknown and Notices.ignored is not None:
            Notices.ignored(type(message), unknown[0], nearest(unknown[0], fields))
        values = {name: value for name, value in values.items() if name in fields}
    for name, value in values.items():
        setattr(message, name, value)


def _refuse_arguments(message: Message, unknown: list[str]) -> NoReturn:
    fields = message._FIELDS
    error = AssertionError(f'Invalid arguments passed to constructor: {", ".join(unknown)}')
    near, name = nearest(unknown[0], fields), type(message).__name__
    raise with_facts(error, 'messages.field', type=name, field=unknown[0], near=near, fields=list(fields))
