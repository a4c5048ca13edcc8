"""Asking only the handlers that can match gives the same answer as asking all, newest first."""

from __future__ import annotations

from collections import deque
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from launch._handler_table import HandlerTable
from launch.event import Event
from launch.event_handler import BaseEventHandler


class About(Event):
    """An event of an action."""

    def __init__(self, action: object) -> None:
        self.action = action


class AboutMore(About):
    """A more special one."""


ACTIONS = ('a', 'b')
TYPES = (Event, About, AboutMore)


def make_handler(event_type: Any, action: Any) -> BaseEventHandler:
    handler = BaseEventHandler(
        matcher=lambda event: (
            (event_type is None or isinstance(event, event_type)) and (action is None or getattr(event, 'action', None) is action)
        )
    )
    if event_type in (About, AboutMore):
        handler.only_action = action
    return handler


@given(st.lists(st.tuples(st.sampled_from((None, *TYPES)), st.sampled_from((None, *ACTIONS)), st.booleans(), st.booleans())))
def test_the_same_handlers_in_the_same_order_as_a_plain_list(steps: list[Any]) -> None:
    table, plain = HandlerTable(), deque[BaseEventHandler]()
    for event_type, action, append, remove in steps:
        handler = make_handler(event_type, action)
        table.add(handler, append=append)
        plain.append(handler) if append else plain.appendleft(handler)
        if remove:
            table.remove(plain[len(plain) // 2])
            del plain[len(plain) // 2]
    assert table.as_deque() == plain
    for event in (Event(), About('a'), AboutMore('b')):
        expected = [handler for handler in plain if handler.matches(event)]
        assert [handler for handler in table.candidates(event) if handler.matches(event)] == expected
        assert table.matches(event) == bool(expected)


def test_a_handler_that_is_not_there_cannot_be_removed() -> None:
    with pytest.raises(ValueError, match='is not registered'):
        HandlerTable().remove(make_handler(None, None))


def test_an_event_of_another_action_costs_no_question() -> None:
    table = HandlerTable()
    for _ in range(10):
        table.add(make_handler(About, 'a'), append=False)
    assert table.candidates(About('b')) == []
