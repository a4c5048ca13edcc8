"""Which classes are messages, services and actions; and hashes of types."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from example_interfaces.action import Fibonacci
from example_interfaces.srv import AddTwoInts
from rclpy.type_hash import TypeHash
from rclpy.type_support import (
    check_for_type_support,
    check_is_valid_action_type,
    check_is_valid_msg_type,
    check_is_valid_srv_type,
    wrong_class,
)
from std_msgs.msg import String

CHECKS: list[tuple[Callable[[Any], None], Any]] = [
    (check_is_valid_msg_type, String),
    (check_is_valid_srv_type, AddTwoInts),
    (check_is_valid_action_type, Fibonacci),
]


@pytest.mark.parametrize('check', [check for check, _ in CHECKS])
@pytest.mark.parametrize('interface', [interface for _, interface in CHECKS])
def test_each_kind_is_accepted_where_it_is_meant(check: Callable[[Any], None], interface: Any) -> None:
    if (check, interface) in CHECKS:
        check(interface)
    else:
        with pytest.raises(RuntimeError, match=r'type provided is not valid \(.*\), this might be a'):
            check(interface)


@pytest.mark.parametrize('check', [check_for_type_support, *(check for check, _ in CHECKS)])
@pytest.mark.parametrize('wrong', [int, 'std_msgs/msg/String', None])
def test_what_is_no_interface_is_refused(check: Callable[[Any], None], wrong: Any) -> None:
    with pytest.raises(AttributeError, match=f"type object '{type(wrong).__name__}' has no attribute '_TYPE_SUPPORT'"):
        check(wrong)


def test_a_class_in_place_of_a_request_has_its_own_advice() -> None:
    for given, facts in (
        (AddTwoInts.Request, {'about': 'messages.class-given', 'wanted': 'AddTwoInts.Request'}),
        (5, {'about': 'messages.other-class', 'wanted': 'AddTwoInts.Request', 'given': 'int'}),
    ):
        error: Any = wrong_class(given, AddTwoInts, 'Request')
        assert (type(error), error.edulaunch_facts) == (TypeError, facts)


@pytest.mark.parametrize(
    ('version', 'value', 'text'),
    [
        (1, bytes(range(32)), 'RIHS01_' + bytes(range(32)).hex()),
        (12, bytes(32), 'RIHS12_' + '00' * 32),
        (0, bytes(32), 'INVALID'),
        (-1, bytes(32), 'INVALID'),
        (1, bytes(31), 'INVALID'),
    ],
)
def test_a_hash_as_text(version: int, value: bytes, text: str) -> None:
    assert str(TypeHash(version, value)) == text


def test_hashes_are_equal_by_version_and_value() -> None:
    one = TypeHash(1, bytes(32))
    assert [one == other for other in (TypeHash(1, bytes(32)), TypeHash(2, bytes(32)), TypeHash(1, b'\1' * 32), 'x')] == [
        True,
        False,
        False,
        False,
    ]
    assert (str(TypeHash()), TypeHash().version, TypeHash().value) == ('INVALID', -1, bytes(32))
    for name, wrong in (('version', '1'), ('value', 'x')):
        with pytest.raises(AssertionError):
            setattr(one, name, wrong)
