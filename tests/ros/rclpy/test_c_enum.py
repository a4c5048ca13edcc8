"""Enumerations of C++: their members have names and integers, and cannot be listed."""

from __future__ import annotations

from typing import Any

import pytest
from rclpy.action.server import GoalEvent
from rclpy.event_handler import QoSPublisherEventType, QoSSubscriptionEventType
from rclpy.service_introspection import ServiceIntrospectionState

KINDS = (GoalEvent, QoSPublisherEventType, QoSSubscriptionEventType, ServiceIntrospectionState)


@pytest.mark.parametrize('kind', KINDS)
def test_members_equal_their_integer_and_are_true(kind: Any) -> None:
    first, second = list(kind.__members__.values())[:2]
    assert (first == 0, first != 1, first == second, bool(first), hash(second), kind(1)) == (True, True, False, True, 1, second)
    assert isinstance(first, int) is False and f'{first}' == f'{kind.__name__}.{first.name}'


@pytest.mark.parametrize('kind', KINDS)
def test_members_cannot_be_listed_searched_or_ordered(kind: Any) -> None:
    for misuse in (
        lambda: list(kind),
        lambda: len(kind),
        lambda: kind(0) in kind,
        lambda: kind['OFF'],
        lambda: kind(0) < kind(1),
    ):
        with pytest.raises(TypeError):
            misuse()


def test_event_types_have_the_names_of_c() -> None:
    assert str(QoSPublisherEventType.RCL_PUBLISHER_MATCHED) == 'rcl_publisher_event_type_t.RCL_PUBLISHER_MATCHED'
    assert str(QoSSubscriptionEventType.RCL_SUBSCRIPTION_MATCHED) == 'rcl_subscription_event_type_t.RCL_SUBSCRIPTION_MATCHED'
