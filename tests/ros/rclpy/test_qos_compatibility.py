"""Which pairs of profiles connect, which do not, and what is said of each pair."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSCompatibility, QoSProfile, ReliabilityPolicy, qos_check_compatible
from rclpy.qos_compatibility import PolicyKindOfEvent, QoSPolicyKind, qos_policy_name_from_kind

R, D, L = ReliabilityPolicy, DurabilityPolicy, LivelinessPolicy
SET = {'reliability': R.RELIABLE, 'durability': D.VOLATILE, 'liveliness': L.AUTOMATIC}


def checked(publisher: dict[str, Any], subscription: dict[str, Any]) -> tuple[QoSCompatibility, str]:
    profiles = [QoSProfile(depth=1, **{**SET, **changes}) for changes in (publisher, subscription)]
    return qos_check_compatible(*profiles)


def s(seconds: float) -> Duration:
    return Duration(seconds=seconds)


@pytest.mark.parametrize(
    ('publisher', 'subscription', 'reason'),
    [
        ({'reliability': R.BEST_EFFORT}, {}, 'Best effort publisher and reliable subscription'),
        ({}, {'durability': D.TRANSIENT_LOCAL}, 'Volatile publisher and transient local subscription'),
        ({}, {'deadline': s(1)}, 'Subscription has a deadline, but publisher does not'),
        ({'deadline': s(2)}, {'deadline': s(1)}, 'Subscription deadline is less than publisher deadline'),
        ({}, {'liveliness': L.MANUAL_BY_TOPIC}, "Publisher's liveliness is automatic and subscription's is manual by topic"),
        ({}, {'liveliness_lease_duration': s(1)}, 'Subscription has a liveliness lease duration, but publisher does not'),
        (
            {'liveliness_lease_duration': s(2)},
            {'liveliness_lease_duration': s(1)},
            'Subscription liveliness lease duration is less than publisher',
        ),
    ],
)
def test_what_separates_two_ends(publisher: dict[str, Any], subscription: dict[str, Any], reason: str) -> None:
    assert checked(publisher, subscription) == (QoSCompatibility.ERROR, f'ERROR: {reason};')
    assert checked({}, {}) == (QoSCompatibility.OK, '')


@pytest.mark.parametrize(
    ('publisher', 'subscription'),
    [
        ({}, {'reliability': R.BEST_EFFORT}),
        ({'durability': D.TRANSIENT_LOCAL}, {}),
        ({'liveliness': L.MANUAL_BY_TOPIC}, {}),
        ({'deadline': s(1)}, {}),
        ({'deadline': s(1)}, {'deadline': s(1)}),
        ({'deadline': s(1)}, {'deadline': s(2)}),
        ({'liveliness_lease_duration': s(1)}, {}),
        ({'liveliness_lease_duration': s(1)}, {'liveliness_lease_duration': s(1)}),
    ],
)
def test_who_offers_as_much_as_is_asked_for_is_heard(publisher: dict[str, Any], subscription: dict[str, Any]) -> None:
    assert checked(publisher, subscription) == (QoSCompatibility.OK, '')


def test_all_reasons_are_told() -> None:
    kind, text = checked({'reliability': R.BEST_EFFORT}, {'durability': D.TRANSIENT_LOCAL, 'deadline': s(1)})
    assert (kind, text.count('ERROR: '), text.count(';')) == (QoSCompatibility.ERROR, 3, 3)


@pytest.mark.parametrize(
    ('publisher', 'subscription', 'doubt'),
    [
        ({'reliability': R.SYSTEM_DEFAULT}, {}, 'Reliable subscription, but publisher is system_default'),
        ({'reliability': R.SYSTEM_DEFAULT}, {'reliability': R.BEST_EFFORT}, ''),
        (
            {'reliability': R.BEST_EFFORT},
            {'reliability': R.SYSTEM_DEFAULT},
            'Best effort publisher, but subscription is system_default',
        ),
        ({}, {'reliability': R.SYSTEM_DEFAULT}, ''),
        (
            {'reliability': R.SYSTEM_DEFAULT},
            {'reliability': R.UNKNOWN},
            'Publisher reliability is system_default and subscription reliability is unknown',
        ),
        (
            {'durability': D.SYSTEM_DEFAULT},
            {'durability': D.TRANSIENT_LOCAL},
            'Transient local subscription, but publisher is system_default',
        ),
        ({}, {'durability': D.UNKNOWN}, 'Volatile publisher, but subscription is unknown'),
        (
            {'durability': D.SYSTEM_DEFAULT},
            {'durability': D.SYSTEM_DEFAULT},
            'Publisher durabilty is system_default and subscription durability is system_default',
        ),
        (
            {'liveliness': L.UNKNOWN},
            {'liveliness': L.MANUAL_BY_TOPIC},
            "Subscription's liveliness is manual by topic, but publisher's is unknown",
        ),
        ({}, {'liveliness': L.SYSTEM_DEFAULT}, "Publisher's liveliness is automatic, but subscription's is system_default"),
        ({'liveliness': L.SYSTEM_DEFAULT}, {}, ''),
    ],
)
def test_what_is_left_open_is_a_warning(publisher: dict[str, Any], subscription: dict[str, Any], doubt: str) -> None:
    expected = (QoSCompatibility.WARNING, f'WARNING: {doubt};') if doubt else (QoSCompatibility.OK, '')
    assert checked(publisher, subscription) == expected


policies = st.fixed_dictionaries(
    {
        'reliability': st.sampled_from([R.RELIABLE, R.BEST_EFFORT]),
        'durability': st.sampled_from([D.VOLATILE, D.TRANSIENT_LOCAL]),
        'deadline': st.sampled_from([s(0), s(1), s(2)]),
    }
)


@given(policies, policies)
def test_a_profile_fits_itself_and_more_on_offer_never_harms(publisher: dict[str, Any], subscription: dict[str, Any]) -> None:
    assert checked(publisher, publisher) == (QoSCompatibility.OK, '')
    best = {'reliability': R.RELIABLE, 'durability': D.TRANSIENT_LOCAL, 'deadline': s(1)}
    assert checked(best, subscription)[0] == QoSCompatibility.OK
    if checked(publisher, subscription)[0] == QoSCompatibility.OK:
        assert checked({**publisher, 'reliability': R.RELIABLE}, subscription)[0] == QoSCompatibility.OK


def test_policies_have_the_numbers_of_rmw() -> None:
    assert [(kind.name, kind.value) for kind in QoSPolicyKind] == [
        ('INVALID', 1),
        ('DURABILITY', 2),
        ('DEADLINE', 4),
        ('LIVELINESS', 8),
        ('RELIABILITY', 16),
        ('HISTORY', 32),
        ('LIFESPAN', 64),
        ('DEPTH', 128),
        ('LIVELINESS_LEASE_DURATION', 256),
        ('AVOID_ROS_NAMESPACE_CONVENTIONS', 512),
    ]
    assert (qos_policy_name_from_kind(QoSPolicyKind.DEADLINE), qos_policy_name_from_kind(16)) == ('DEADLINE', 'RELIABILITY')
    assert PolicyKindOfEvent.RMW_QOS_POLICY_DEADLINE.value == 4
    assert [kind.value for kind in (QoSCompatibility.OK, QoSCompatibility.WARNING, QoSCompatibility.ERROR)] == [0, 1, 2]
