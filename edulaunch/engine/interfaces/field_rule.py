"""Check assignments to fields as rclpy does, with its error messages."""

from __future__ import annotations

import sys
from array import array
from collections import UserList, UserString
from collections.abc import Collection, Sequence, Set
from typing import Any, NoReturn

from edulaunch.engine.facts import with_facts
from edulaunch.engine.interfaces.layout import is_byte_like, is_fixed_numbers, is_number_sequence
from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.interfaces.spec import Field, Primitive


def python_values(values: Any, kind: Primitive) -> Any:
    """Convert values to a list or an array of Python numbers, as Jazzy does.

    Integers are accepted for floats, and numbers of numpy for numbers of Python.

    :param values: any iterable, such as a list, an `array.array` or a numpy array.
    :param kind: the kind of the field's elements.
    :return: an array for a numpy array of exactly that kind (such as an image), otherwise a list of Python numbers. Values
        that Jazzy rejects are returned unchanged, such as an array with several dimensions, floats for integers, or strings.
    """
    numpy = sys.modules.get('numpy')
    numbers: tuple[type, ...] = (int, float) if kind.python is float else (int,)
    if numpy is not None:
        numbers += (numpy.integer, numpy.floating) if kind.python is float else (numpy.integer,)
        if isinstance(values, numpy.ndarray):
            if values.ndim != 1 or not issubclass(values.dtype.type, numbers):
                return values
            return array(kind.code, values.tobytes()) if values.dtype == kind.name else list(map(kind.python, values.tolist()))
    if isinstance(values, (str, bytes, bytearray, memoryview)):
        return values
    try:
        return [kind.python(value) if isinstance(value, numbers) else value for value in values]
    except (TypeError, OverflowError):  # `values` is not iterable, or has an integer that is too large for a float
        return values


_INF = float('inf')


class FieldRule:
    """The rule that checks the values of one field. `message` is the class of a nested message, or None.

    Generated setters handle the most common valid values themselves, and call `accept` for all other values.
    """

    __slots__ = ('name', 'type', 'kind', 'message')

    def __init__(self, field: Field, message: type[Message] | None) -> None:
        self.name = field.name
        self.type = field.type
        self.kind = field.type.kind
        self.message = message

    def accept(self, value: Any) -> Any:
        """Check a value, and return it in the form in which the slot stores it.

        :raises AssertionError: with rclpy's message, if the value has a wrong type, length or range.
        :raises TypeError, ValueError, OverflowError: from `array.array`, if a sequence of numbers cannot contain the value.
        """
        if not self.type.array:
            return self._accept_one(value)
        if is_fixed_numbers(self.type):
            return self._accept_fixed_numbers(value)
        if isinstance(value, array) and is_number_sequence(self.type):
            return self._accept_array(value)
        return self._accept_several(value)

    # One value

    def _accept_one(self, value: Any) -> Any:
        if not self._is_one(value):
            self._refuse(f'must be {self._one_words()}', value)
        if self.kind is None:
            return value
        if not self._is_in_range(value):
            words = self.kind.range_words or f'string value not longer than {self.type.string_bound}'
            article = 'an ' if words[0] in 'iu' else 'a ' if self.kind.range_words else ''
            self._refuse(f'must be {article}{words}', value)
        # Subclasses (numpy.float64, IntEnum, bool as a number) become the plain values that wires need.
        return self.kind.python(value)

    def _one_words(self) -> str:
        if self.message is not None:
            return f"a sub message of type '{self.message.__name__}'"
        if self.kind is not None and self.kind.python is bytes:
            return "of type 'bytes' or 'ByteString' with length 1"
        if self.type.string_bound is not None:
            return f'string value not longer than {self.type.string_bound}'
        return f"of type '{self._python_name()}'"

    def _python_name(self) -> str:
        return self.message.__name__ if self.kind is None and self.message else self.kind.python.__name__ if self.kind else ''

    def _is_one(self, value: Any) -> bool:
        if self.kind is None:
            return self.message is not None and isinstance(value, self.message)
        if self.kind.python is bytes:
            return isinstance(value, (bytes, bytearray, memoryview)) and len(value) == 1
        return isinstance(value, self.kind.python)

    def _is_in_range(self, value: Any) -> bool:
        kind = self.kind
        if kind is None or kind.python is bytes or kind.python is bool:
            return True
        if kind.python is str:
            return self.type.string_bound is None or len(value) <= self.type.string_bound
        return bool(kind.low <= value <= kind.high) or (kind.python is float and (value != value or abs(value) == _INF))

    # Several values

    def _accept_several(self, value: Any) -> Any:
        if self.kind is None or not is_number_sequence(self.type):
            if not self._are_right(value):
                self._refuse(f'must be {self._several_words()}', value)
            return value
        numbers = value
        if not self._are_right(value):
            numbers = python_values(value, self.kind)
            if isinstance(numbers, array):
                return self._accept_array(numbers)
            if not self._are_right(numbers):
                return self._array_of(value)
        return array(self.kind.code, numbers)

    def _are_right(self, value: Any) -> bool:
        listed = isinstance(value, (Sequence, Set, UserList)) and not isinstance(value, (str, UserString))
        return listed and self._is_right_length(len(value)) and self._each_is_right(value)

    def _is_right_length(self, length: int) -> bool:
        return {'fixed': length == self.type.size, 'bounded': length <= self.type.size}.get(self.type.array, True)

    def _each_is_right(self, values: Collection[Any]) -> bool:
        return self._are_plain_numbers(values) or all(self._is_one(value) and self._is_in_range(value) for value in values)

    def _are_plain_numbers(self, values: Collection[Any]) -> bool:
        """Return whether a quick check finds only plain numbers, which is nearly always so. An image has a million values."""
        kind = self.kind
        if kind is None or not kind.is_number or not values:
            return False
        if isinstance(values, (bytes, bytearray)):
            return kind.low == 0 or (kind.python is int and max(values) <= kind.high)
        return set(map(type, values)) == {kind.python} and kind.low <= min(values) and max(values) <= kind.high

    def _several_words(self) -> str:
        words = ['a set or sequence']
        if self.type.array != 'unbounded':
            words.append(f'with length {"<= " if self.type.array == "bounded" else ""}{self.type.size}')
        words.append(f"and each value of type '{self._python_name()}'")
        if self.kind is not None and self.kind.range_words:
            words.append(f'and each {self.kind.range_words}')
        if self.type.string_bound is not None:
            words.append(f'and each string value not longer than {self.type.string_bound}')
        return ' '.join(words)

    def _accept_array(self, value: array[Any]) -> array[Any]:
        assert self.kind is not None
        if value.typecode != self.kind.code:
            facts = {'given': f'array({value.typecode!r})', 'write': f"array.array('{self.kind.code}', values)"}
            return self._array_of(value, **facts)
        if not self._is_right_length(len(value)):
            words = f'array.array() must have a size <= {self.type.size}'
            self._refuse_array(words, count=len(value), size=self.type.size)
        return value

    def _array_of(self, value: Any, **facts: Any) -> array[Any]:
        """Return the array that Python creates from unusual values, because Jazzy assigns the same array.

        :param facts: facts that replace the usual facts of the error.
        """
        from edulaunch.engine.interfaces.mistakes import value_facts

        assert self.kind is not None
        try:
            made = array(self.kind.code, value)
        except (TypeError, ValueError, OverflowError) as error:
            raise with_facts(error, **{**value_facts(self.type, self.message, self.name, value), **facts}) from None
        if not self._is_right_length(len(made)):
            self._refuse(f'must be {self._several_words()}', value)
        return made

    def _accept_fixed_numbers(self, value: Any) -> Any:
        """Return the value to store. A numpy array is stored as it is, and any other value as its wire value.

        A wire value becomes a numpy array when the field is first read.
        """
        assert self.kind is not None
        numpy = sys.modules.get('numpy')
        if numpy is not None and isinstance(value, numpy.ndarray):
            return self._accept_ndarray(value)
        given = value if self._are_right(value) else python_values(value, self.kind)
        if not self._are_right(given):
            self._refuse(f'must be {self._several_words()}', value)
        numbers = array(self.kind.code, given)
        return numbers.tobytes() if is_byte_like(self.type) else tuple(numbers)

    def _accept_ndarray(self, value: Any) -> Any:
        assert self.kind is not None
        if value.dtype != self.kind.name:
            numbers = python_values(value, self.kind)
            if self._are_right(numbers):
                return value.astype(self.kind.name)
            self._refuse_array(
                f"numpy.ndarray() must have the dtype of 'numpy.{self.kind.name}'",
                given=f'numpy.ndarray({value.dtype})',
                write=f"value.astype('{self.kind.name}')",
            )
        if value.size != self.type.size:
            words = f'numpy.ndarray() must have a size of {self.type.size}'
            self._refuse_array(words, count=int(value.size), size=self.type.size)
        return value

    # Rejected values

    def _refuse(self, words: str, value: Any) -> NoReturn:
        from edulaunch.engine.interfaces.mistakes import value_facts

        error = AssertionError(f"The '{self.name}' field {words}")
        raise with_facts(error, **value_facts(self.type, self.message, self.name, value))

    def _refuse_array(self, words: str, **facts: Any) -> NoReturn:
        assert self.kind is not None
        error = AssertionError(f"The '{self.name}' {words}")
        raise with_facts(error, 'messages.field-value', field=self.name, wanted=f'{self.kind.python.__name__}[]', **facts)

    # Snapshots of the fields whose content may have changed since it was assigned

    def list_to_wire(self, values: Any) -> Any:
        """Return the wire value of a list field (bool, byte, strings).

        :raises AssertionError: when an invalid value was appended to the list after its assignment.
        """
        if values.__class__ is list and not values and self.type.array != 'fixed':
            return b'' if is_byte_like(self.type) else ()
        if not self._are_right(values):
            self._refuse(f'must be {self._several_words()}', values)
        return b''.join(values) if is_byte_like(self.type) else tuple(values)

    def refuse_elements(self, values: Any) -> None:
        """Raise an AssertionError unless every message in the list is of the right class and the length of the list is valid."""
        if not self._are_right(values):
            self._refuse(f'must be {self._several_words()}', values)

    def array_to_wire(self, values: array[Any]) -> tuple[Any, ...] | bytes:
        """Return the wire value of a bounded sequence of numbers."""
        self._accept_array(values)
        return values.tobytes() if is_byte_like(self.type) else tuple(values)

    def fixed_to_wire(self, values: Any) -> tuple[Any, ...] | bytes:
        """Return the wire value of a fixed array of numbers that is stored as a numpy array."""
        raw = self._accept_fixed_numbers(values)
        if isinstance(raw, (tuple, bytes)):
            return raw
        return raw.tobytes() if is_byte_like(self.type) else tuple(raw.ravel().tolist())

    def to_numpy(self, wire: Any) -> Any:
        """Return the wire value of a fixed array of numbers as a new numpy array."""
        import numpy  # imported here, because few runs read a covariance

        assert self.kind is not None
        if isinstance(wire, bytes):
            return numpy.frombuffer(wire, self.kind.name).copy()
        return numpy.array(wire, self.kind.name)
