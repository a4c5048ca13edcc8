"""Properties that only show."""

from __future__ import annotations

import pickle

import pytest

from edulaunch.ros.read_only import ReadOnly


class _Turtle:
    def __init__(self, name: str) -> None:
        self.__name = name
        self.__legs = self._owner = [name]

    name: ReadOnly[str] = ReadOnly('What it is called.')
    feet: ReadOnly[list[str]] = ReadOnly('Under its legs.', '__legs')
    owner: ReadOnly[list[str]] = ReadOnly('Whose it is.', '_owner')


def test_it_shows_what_the_object_keeps_for_itself() -> None:
    turtle = pickle.loads(pickle.dumps(_Turtle('tim')))
    assert (turtle.name, turtle.feet, turtle.owner) == ('tim', ['tim'], ['tim'])
    assert turtle.feet is turtle.owner


def test_it_is_a_property_with_a_text() -> None:
    assert isinstance(vars(_Turtle)['name'], property) and _Turtle.name.__doc__ == 'What it is called.'
    with pytest.raises(AttributeError):
        _Turtle('tim').name = 'tom'
