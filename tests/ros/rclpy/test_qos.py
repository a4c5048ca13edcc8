"""rclpy.qos."""

from __future__ import annotations

import pytest
from rclpy import qos
from rclpy.duration import Duration


@pytest.mark.parametrize(
    ('keywords', 'text'),
    [
        ({}, 'History and/or depth settings are required.'),
        ({'history': qos.HistoryPolicy.KEEP_LAST}, 'History set to KEEP_LAST without a depth setting.'),
    ],
)
def test_a_profile_needs_history_or_depth(keywords: dict[str, object], text: str) -> None:
    with pytest.raises(qos.InvalidQoSProfileException) as caught:
        qos.QoSProfile(**keywords)
    assert caught.value.args == ('Invalid QoSProfile', text)


def test_an_unknown_keyword_is_an_assertion() -> None:
    with pytest.raises(AssertionError, match='Invalid arguments passed to constructor'):
        qos.QoSProfile(depth=1, reliabilty=1)


def test_defaults_are_reliable_and_volatile() -> None:
    profile = qos.QoSProfile(depth=3)
    assert (profile.reliability, profile.durability, profile.depth) == (
        qos.ReliabilityPolicy.RELIABLE,
        qos.DurabilityPolicy.VOLATILE,
        3,
    )


@pytest.mark.parametrize(
    ('value', 'error', 'text'),
    [
        (-1, ValueError, 'history depth must be greater than or equal to zero'),
        ('10', TypeError, "Expected QoSProfile or int, but received <class 'str'>"),
    ],
)
def test_the_qos_argument_is_a_depth_or_a_profile(value: object, error: type[Exception], text: str) -> None:
    with pytest.raises(error) as caught:
        qos.validate_qos(value)  # type: ignore[arg-type]
    assert str(caught.value) == text


def test_presets_are_found_by_their_short_key() -> None:
    assert qos.QoSPresetProfiles.get_from_short_key('sensor_data') == qos.qos_profile_sensor_data


def test_policies_are_found_by_their_short_key() -> None:
    assert qos.ReliabilityPolicy.get_from_short_key('best_effort') == qos.QoSReliabilityPolicy.BEST_EFFORT
    assert [policy.short_key for policy in qos.HistoryPolicy] == ['system_default', 'keep_last', 'keep_all', 'unknown']
    assert qos.LivelinessPolicy.short_keys() == ['system_default', 'automatic', 'manual_by_topic', 'unknown', 'best_available']


def test_policies_have_the_numbers_of_rmw() -> None:
    numbers = {policy: [value.value for value in policy] for policy in qos.QoSPolicyEnum.__subclasses__()}
    assert numbers[qos.HistoryPolicy] == [0, 1, 2, 3]
    assert numbers[qos.ReliabilityPolicy] == numbers[qos.DurabilityPolicy] == [0, 1, 2, 3, 4]
    assert numbers[qos.LivelinessPolicy] == [0, 1, 3, 4, 5]


@pytest.mark.parametrize(
    ('offered', 'requested', 'reason'),
    [
        ({'reliability': 2}, {'reliability': 1}, 'ERROR: Best effort publisher and reliable subscription;'),
        ({'durability': 2}, {'durability': 1}, 'ERROR: Volatile publisher and transient local subscription;'),
        ({}, {'deadline': Duration(seconds=1)}, 'ERROR: Subscription has a deadline, but publisher does not;'),
        (
            {'liveliness': 1},
            {'liveliness': 3},
            "ERROR: Publisher's liveliness is automatic and subscription's is manual by topic;",
        ),
    ],
)
def test_incompatible_profiles_are_explained(offered: dict[str, object], requested: dict[str, object], reason: str) -> None:
    check = qos.qos_check_compatible(qos.QoSProfile(depth=1, **offered), qos.QoSProfile(depth=1, **requested))
    assert check == (qos.QoSCompatibility.ERROR, reason)


@pytest.mark.parametrize(
    ('offered', 'requested', 'reason'),
    [
        ({'reliability': 0}, {'reliability': 1}, 'Reliable subscription, but publisher is system_default'),
        ({'reliability': 2}, {'reliability': 3}, 'Best effort publisher, but subscription is unknown'),
        (
            {'durability': 0},
            {'durability': 0},
            'Publisher durabilty is system_default and subscription durability is system_default',
        ),
        ({'liveliness': 1}, {'liveliness': 0}, "Publisher's liveliness is automatic, but subscription's is system_default"),
    ],
)
def test_open_policies_make_warnings(offered: dict[str, object], requested: dict[str, object], reason: str) -> None:
    automatic = {'depth': 1, 'liveliness': 1}
    check = qos.qos_check_compatible(qos.QoSProfile(**automatic | offered), qos.QoSProfile(**automatic | requested))
    assert check == (qos.QoSCompatibility.WARNING, f'WARNING: {reason};')
    assert type(check) is tuple, 'a program prints it'


def test_a_depth_of_zero_that_is_set_later_warns_too() -> None:
    profile = qos.QoSProfile(depth=5)
    with pytest.warns(UserWarning, match='A zero depth with KEEP_LAST') as caught:
        profile.depth = 0
    assert len(caught) == 1


def test_a_flag_of_a_profile_is_a_bool() -> None:
    with pytest.raises(AssertionError):
        qos.QoSProfile(depth=1, avoid_ros_namespace_conventions=1)


def test_a_profile_is_shown_alike_on_every_python() -> None:
    assert str(qos.QoSProfile(depth=3)).startswith('QoSProfile(history=1, depth=3, reliability=1, durability=2, ')


def test_system_defaults_are_those_of_fast_dds() -> None:
    writer, reader = (qos.engine_qos(qos.qos_profile_system_default, side) for side in ('publisher', 'subscription'))
    assert writer[:3] == (1, 'reliable', 'transient_local')
    assert reader[:3] == (1, 'best_effort', 'volatile')


def test_a_profile_of_the_c_layer_gives_its_values_as_numbers() -> None:
    profile = qos.QoSProfile(depth=7, reliability=qos.ReliabilityPolicy.BEST_EFFORT)
    inner = profile.get_c_qos_profile()
    profile.depth = 3
    values = inner.to_dict()
    assert str(type(inner)) == "<class 'rclpy._rclpy_pybind11.rmw_qos_profile_t'>"
    assert list(values.items())[:4] == [('depth', 7), ('history', 1), ('reliability', 2), ('durability', 2)]
    assert (type(values['history']), qos.QoSProfile(**values).depth) == (int, 7)
