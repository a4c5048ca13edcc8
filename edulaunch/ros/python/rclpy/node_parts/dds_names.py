"""The names of ROS 2's topics and services in DDS, for callers that request names without demangling."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

NamesAndTypes = list[tuple[str, list[str]]]
Directions = frozenset[tuple[str, str]]
"""Pairs of an endpoint's kind and the kind of data that it sends or receives: 'topic', 'request' or 'reply'."""

WRITES: Directions = frozenset((('publisher', 'topic'), ('client', 'request'), ('service', 'reply')))
READS: Directions = frozenset((('subscription', 'topic'), ('service', 'request'), ('client', 'reply')))
DISCOVERY = ('ros_discovery_info', ['rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_'])
"""The topic by which the participants of ROS 2 announce their nodes to each other."""
_FORMS = {'topic': ('rt', '', ''), 'request': ('rq', 'Request', '_Request'), 'reply': ('rr', 'Reply', '_Response')}
"""The prefix of the name, the suffix of the name and the suffix of the type, for each kind of data."""


def dds_names_and_types(endpoints: Iterable[Any], directions: Directions) -> NamesAndTypes:
    """Return (name, sorted types) in DDS form for the topics of endpoints, sorted by name.

    For example, a name is `rt/chatter`, and a type is `pkg::msg::dds_::String_`.

    :param directions: pairs of the kind of an endpoint and its kind of data, which is 'topic', 'request' or 'reply'.
    """
    found: dict[str, set[str]] = {}
    for end in endpoints:
        for kind, what in directions:
            if kind == end.kind:
                before, behind, part = _FORMS[what]
                package, folder, name = end.type_name.split('/')
                found.setdefault(f'{before}{end.name}{behind}', set()).add(f'{package}::{folder}::dds_::{name}{part}_')
    return [(name, sorted(types)) for name, types in sorted(found.items())]
