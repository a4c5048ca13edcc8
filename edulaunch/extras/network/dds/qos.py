"""Convert quality of service between edulaunch's classes and cyclonedds."""

from __future__ import annotations

import ctypes
import re
from typing import Any

from cyclonedds.internal import dds_c_t
from cyclonedds.qos import Policy, Qos, _CQos

from edulaunch.engine.graph.qos import (
    AUTOMATIC,
    BEST_EFFORT,
    INFINITE_NS,
    KEEP_ALL,
    MANUAL_BY_TOPIC,
    RELIABLE,
    TRANSIENT_LOCAL,
    VOLATILE,
    QoS,
)
from edulaunch.extras.network.network_link import KEPT, WAITING

LONGEST_BLOCK_NS = 10_000_000
"""The longest time that a reliable publisher waits for slow readers before it drops a message. The machine waits meanwhile."""
NEVER_NS = (1 << 63) - 1
PLAIN = Policy.DataRepresentation(use_cdrv0_representation=True, use_xcdrv2_representation=False)
_ENCLAVE = re.compile(r'(?:^|;)enclave=([^;]*);')
HASH = re.compile(r'(?:^|;)typehash=(RIHS01_[0-9a-f]{64});')


class _FreeingQos(_CQos):  # type: ignore[misc]
    """Frees the user data that Cyclone DDS copies for each sample of discovery; the base class keeps the copies."""

    @classmethod
    def _get_p_userdata(cls, qos: Any) -> Any:
        found = super()._get_p_userdata(qos)
        cls.free(cls._gc_data_value)
        cls._gc_data_value.value = None
        return found


def qos_from(pointer: Any) -> Qos:
    """Return the policies at an address of Cyclone DDS, as `cyclonedds.builtin_types.cqos_to_qos` does."""
    return _FreeingQos.cqos_to_qos(ctypes.cast(pointer, dds_c_t.qos_p))


def to_dds(qos: QoS, type_hash: str, is_reader: bool) -> Qos:
    """Return the DDS policies for an endpoint of this link. As in ROS 2, they include the hash of its type."""
    is_kept = qos.reliability == RELIABLE and qos.durability != TRANSIENT_LOCAL
    depth = max(qos.depth, WAITING if is_reader else KEPT if is_kept else 1)
    life = Policy.Liveliness.ManualByTopic if qos.liveliness == MANUAL_BY_TOPIC else Policy.Liveliness.Automatic
    policies: list[Any] = [
        PLAIN,
        Policy.IgnoreLocal.Participant,
        Policy.Userdata(f'typehash={type_hash};'.encode()),
        Policy.Reliability.Reliable(LONGEST_BLOCK_NS) if qos.reliability == RELIABLE else Policy.Reliability.BestEffort,
        Policy.Durability.TransientLocal if qos.durability == TRANSIENT_LOCAL else Policy.Durability.Volatile,
        Policy.History.KeepAll if qos.history == KEEP_ALL and not is_reader else Policy.History.KeepLast(depth),
        Policy.Deadline(qos.deadline_ns or NEVER_NS),
        life(qos.lease_ns or NEVER_NS),
    ]
    if qos.durability == TRANSIENT_LOCAL and not is_reader:
        kept = Policy.History.KeepAll if qos.history == KEEP_ALL else Policy.History.KeepLast(depth)
        policies.append(Policy.DurabilityService(0, kept, -1, -1, -1))
    return Qos(*policies, *([] if is_reader else [Policy.Lifespan(qos.lifespan_ns or NEVER_NS)]))


def from_dds(qos: Qos) -> tuple[QoS, str]:
    """Return the policies of an endpoint on the network, and the hash of its type ('' if the endpoint announces no hash).

    DDS does not announce the depth. ROS 2 shows UNKNOWN, but this function returns the usual depth.
    """
    found = HASH.search(_user_data(qos))
    reliable = Policy.Reliability in qos and qos[Policy.Reliability] != Policy.Reliability.BestEffort
    stays = Policy.Durability in qos and qos[Policy.Durability] != Policy.Durability.Volatile
    by_hand = Policy.Liveliness in qos and isinstance(qos[Policy.Liveliness], Policy.Liveliness.ManualByTopic)
    return QoS(
        reliability=RELIABLE if reliable else BEST_EFFORT,
        durability=TRANSIENT_LOCAL if stays else VOLATILE,
        deadline_ns=_time(qos, Policy.Deadline, 'deadline'),
        lifespan_ns=_time(qos, Policy.Lifespan, 'lifespan'),
        liveliness=MANUAL_BY_TOPIC if by_hand else AUTOMATIC,
        lease_ns=_time(qos, Policy.Liveliness, 'lease_duration'),
    ), found.group(1) if found else ''


def enclave_of(qos: Qos) -> str:
    """Return the enclave that a participant announces, or '' for a participant that does not use ROS 2."""
    found = _ENCLAVE.search(_user_data(qos))
    return found[1] if found else ''


def _user_data(qos: Qos) -> str:
    data: bytes = qos[Policy.Userdata].data if Policy.Userdata in qos else b''
    return data[:1000].decode('ascii', 'replace')


def _time(qos: Qos, policy: Any, name: str) -> int:
    value = int(getattr(qos[policy], name)) if policy in qos else NEVER_NS
    return value if 0 < value < NEVER_NS else INFINITE_NS
