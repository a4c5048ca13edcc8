"""When two endpoints can talk."""

from __future__ import annotations

import pytest

from edulaunch.engine.graph.qos import BEST_EFFORT, KEEP_ALL, MANUAL_BY_TOPIC, TRANSIENT_LOCAL, QoS, incompatible_policy


@pytest.mark.parametrize(
    ('offered', 'requested', 'policy'),
    [
        (QoS(), QoS(), None),
        (QoS(reliability=BEST_EFFORT), QoS(), 'RELIABILITY'),
        (QoS(), QoS(reliability=BEST_EFFORT), None),
        (QoS(), QoS(durability=TRANSIENT_LOCAL), 'DURABILITY'),
        (QoS(durability=TRANSIENT_LOCAL), QoS(), None),
        (QoS(), QoS(deadline_ns=10), 'DEADLINE'),
        (QoS(deadline_ns=10), QoS(deadline_ns=10), None),
        (QoS(deadline_ns=11), QoS(deadline_ns=10), 'DEADLINE'),
        (QoS(deadline_ns=10), QoS(), None),
        (QoS(), QoS(liveliness=MANUAL_BY_TOPIC), 'LIVELINESS'),
        (QoS(liveliness=MANUAL_BY_TOPIC), QoS(), None),
        (QoS(), QoS(lease_ns=10), 'LIVELINESS'),
        (QoS(depth=1), QoS(depth=100, history=KEEP_ALL), None),
        (QoS(reliability=BEST_EFFORT), QoS(durability=TRANSIENT_LOCAL, lease_ns=10), 'RELIABILITY'),
        (QoS(), QoS(durability=TRANSIENT_LOCAL, deadline_ns=10, lease_ns=10), 'LIVELINESS'),
        (QoS(), QoS(durability=TRANSIENT_LOCAL, deadline_ns=10), 'DEADLINE'),
    ],
)
def test_offered_must_be_at_least_requested(offered: QoS, requested: QoS, policy: str | None) -> None:
    assert incompatible_policy(offered, requested) == policy
