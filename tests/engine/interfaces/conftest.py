"""Fixtures: the underlay's classes, a way to write interface files, and arbitrary legal wire tuples."""

from __future__ import annotations

import math
import struct
from functools import cache
from random import Random

import pytest

from edulaunch.engine.interfaces.layout import is_byte_like
from edulaunch.engine.interfaces.registry import Registry, underlay_registry


@pytest.fixture(scope='session')
def registry():
    return underlay_registry()


@pytest.fixture(scope='session')
def get(registry):
    """get('std_msgs/msg/String') -> the class."""
    return registry.get


@pytest.fixture
def define(tmp_path, registry):
    """define('Num.msg', 'int64 num') -> the class of my_interfaces' only file."""

    def write(file, text):
        name, kind = file.split('.')
        path = tmp_path / 'my_interfaces' / kind / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding='utf-8')
        return Registry([tmp_path], base=registry).get(f'my_interfaces/{kind}/{name}')

    return write


def _scalar(field_type, some):
    """The ends of what the field can hold, and anything between."""
    kind = field_type.kind
    if kind.python is float:
        number = some.choice([0.0, -0.0, math.inf, -math.inf, 3.4e38, some.uniform(-1e6, 1e6), some.uniform(-1, 1) * 1e-40])
        return struct.unpack('f', struct.pack('f', number))[0] if kind.name == 'float32' else number
    if kind.python is int:
        return some.choice([kind.low, kind.high, some.randint(kind.low, kind.high)])
    if kind.python is str:
        length = some.randint(0, field_type.string_bound or 5)
        return ''.join(
            chr(some.choice([some.randrange(1, 128), some.randrange(1, 0xD800), some.randrange(0xE000, 0x110000)]))
            for _ in range(length)
        )
    return some.random() < 0.5 if kind.python is bool else some.randbytes(1)


def _entry(field_type, get, some):
    if not field_type.array:
        return _scalar(field_type, some)
    least = field_type.size if field_type.array == 'fixed' else 0
    length = some.randint(least, 2 if field_type.array == 'unbounded' else field_type.size)
    if is_byte_like(field_type):
        return some.randbytes(length)
    if field_type.kind is None:
        return tuple(wire(get(field_type.base), get, some) for _ in range(length))
    return tuple(_scalar(field_type.element, some) for _ in range(length))


def wire(cls, get, some):
    """Some legal wire tuple of a message class."""
    return tuple(_entry(leaf.type, get, some) for leaf in cls.LAYOUT.leaves)


@pytest.fixture(scope='session')
def some_wires(get):
    """some_wires(cls) -> three arbitrary wire tuples, the same in every run."""
    return cache(lambda cls: [wire(cls, get, Random(f'{cls.TYPE} {number}')) for number in range(3)])


@pytest.fixture(scope='session')
def message_classes(registry):
    """Every message class of the underlay, with the parts of services and actions."""
    classes = []
    for type_name in registry.types():
        cls = registry.get(type_name)
        parts = ('Request', 'Response', 'Event', 'Goal', 'Result', 'Feedback')
        classes += [getattr(cls, part) for part in parts if hasattr(cls, part)] or [cls]
    return classes
