"""Fixtures: the underlay's classes, a way to write interface files, and arbitrary legal wire tuples."""

from __future__ import annotations

import math

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from edulaunch.interfaces.layout import is_byte_like
from edulaunch.interfaces.registry import Registry
from edulaunch.interfaces.underlay import underlay_registry


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


def _scalar(field_type):
    kind = field_type.kind
    if kind.name == 'float32':
        return st.floats(width=32, allow_nan=False).filter(lambda x: math.isinf(x) or abs(x) <= kind.high)
    if kind.python is float:
        return st.floats(allow_nan=False)
    if kind.python is int:
        return st.integers(kind.low, kind.high)
    if kind.python is str:
        alphabet = st.characters(exclude_categories=['Cs'], exclude_characters='\0')
        return st.text(alphabet, max_size=field_type.string_bound or 5)
    return st.booleans() if kind.python is bool else st.binary(min_size=1, max_size=1)


def _entry(field_type, get):
    if not field_type.array:
        return _scalar(field_type)
    least = field_type.size if field_type.array == 'fixed' else 0
    most = 2 if field_type.array == 'unbounded' else field_type.size
    if is_byte_like(field_type):
        return st.binary(min_size=least, max_size=most)
    one = wires(get(field_type.base), get) if field_type.kind is None else _scalar(field_type.element)
    return st.lists(one, min_size=least, max_size=most).map(tuple)


def wires(cls, get):
    """Any legal wire tuple of a message class."""
    return st.tuples(*(_entry(leaf.type, get) for leaf in cls.LAYOUT.leaves))


@pytest.fixture(scope='session')
def some_wires(get):
    """some_wires(cls) -> three arbitrary wire tuples, the same in every run."""
    known = {}

    def collect(cls):
        if cls not in known:
            found = known[cls] = []

            @settings(
                max_examples=3,
                database=None,
                derandomize=True,
                deadline=None,
                phases=[Phase.generate],
                suppress_health_check=list(HealthCheck),
            )
            @given(wires(cls, get))
            def body(wire):
                found.append(wire)

            body()
        return known[cls]

    return collect


@pytest.fixture(scope='session')
def message_classes(registry):
    """Every message class of the underlay, with the parts of services and actions."""
    classes = []
    for type_name in registry.types():
        cls = registry.get(type_name)
        parts = ('Request', 'Response', 'Event', 'Goal', 'Result', 'Feedback')
        classes += [getattr(cls, part) for part in parts if hasattr(cls, part)] or [cls]
    return classes
