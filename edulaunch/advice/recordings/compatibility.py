"""Ends of one topic or service that cannot talk to each other."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.advice.runs import asking_place, ends_by_name, node_place, speaker

if TYPE_CHECKING:
    from edulaunch.recording import Recording

LESSON = '09_broadcaster_and_listener'


def _unfit(recording: Recording, *policies: str) -> Iterator[Finding]:
    """Pairs that one of the policies keeps apart."""
    for misfit in recording.misfits:
        if misfit.why in policies:
            file, line = node_place(recording, misfit.subscriber)
            pair = {
                'node': speaker(recording, misfit.publisher),
                'other': speaker(recording, misfit.subscriber),
                'policy': misfit.why,
            }
            yield found('topic', misfit.topic, file=file, line=line, time_s=misfit.note.time_s, **pair)


@rule(
    'messages.best-effort',
    what='{node} publishes on {topic} as best effort, but {other} wants it reliable: it hears nothing',
    why='a subscription may ask for no more than its publisher offers; the two are never joined',
    do='let {other} take best effort: create_subscription(..., qos_profile_sensor_data), or publish reliably',
    lesson=LESSON,
    level='error',
)
def best_effort(recording: Recording) -> Iterator[Finding]:
    """Told at the end, too, although it happened when the two met."""
    return _unfit(recording, 'RELIABILITY')


@rule(
    'messages.not-kept',
    what='{other} wants the last messages of {topic} kept for it (transient local), but {node} keeps none: it hears nothing',
    why='a subscription may ask for no more than its publisher offers; the two are never joined',
    do=(
        'publish with QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL) in {node}, or leave the durability of the '
        'subscription at VOLATILE'
    ),
    lesson=LESSON,
    level='error',
)
def not_kept(recording: Recording) -> Iterator[Finding]:
    """A volatile publisher and a transient-local subscription."""
    return _unfit(recording, 'DURABILITY')


@rule(
    'messages.qos',
    what='{node} publishes on {topic}, but {other} hears nothing: their quality of service differs in {policy}',
    why='a subscription may ask for no more than its publisher offers; the two are never joined',
    do='give both ends the same QoSProfile; compare them with: ros2 topic info {topic} --verbose',
    lesson=LESSON,
    level='error',
)
def quality(recording: Recording) -> Iterator[Finding]:
    """Deadlines and liveliness."""
    return _unfit(recording, 'DEADLINE', 'LIVELINESS')


@rule(
    'messages.types',
    what='{node} publishes {sent} on {topic}, but {other} expects {heard}: they do not hear each other',
    why='a topic carries messages of one type; ends of two types are never joined, and ROS 2 says nothing',
    do='use one message type on both sides, or two topics',
    lesson=LESSON,
    level='error',
)
def different_types(recording: Recording) -> Iterator[Finding]:
    """A pair of ends that is joined by neither type, while each of them has nobody else to talk to on that topic."""
    ends = ends_by_name(recording)
    for misfit in recording.misfits:
        if misfit.why != 'TYPE':
            continue
        publishers, subscriptions = ends['publisher', misfit.topic], ends['subscription', misfit.topic]
        sent = {end.type for end in publishers}
        heard = {end.type for end in subscriptions if end.node == misfit.subscriber}
        offered = {end.type for end in publishers if end.node == misfit.publisher}
        wanted = {end.type for end in subscriptions}
        if not heard & sent or not offered & wanted:
            file, line = node_place(recording, misfit.publisher)
            pair = {'node': speaker(recording, misfit.publisher), 'other': speaker(recording, misfit.subscriber)}
            types = {'sent': sorted(offered), 'heard': sorted(heard)}
            yield found('topic', misfit.topic, file=file, line=line, time_s=misfit.note.time_s, **pair, **types)


@rule(
    'messages.service-type',
    what='{node} asks the service {service} as {asked}, but it is a {served}',
    why='a client and a server of two types never meet; the client waits for ever',
    do='import and use {served} in the client',
    lesson=LESSON,
    level='error',
)
def service_type(recording: Recording) -> Iterator[Finding]:
    """A client for whose type there is no server of that name, though there is one of another type."""
    ends = ends_by_name(recording)
    for (kind, name), clients in ends.items():
        servers = ends.get(('service', name))
        if kind != 'client' or not servers:
            continue
        served = {end.type for end in servers}
        for end in clients:
            if end.type not in served:
                file, line = asking_place(recording, end.node, name)
                types = {'asked': end.type, 'served': servers[0].type}
                yield found('service', name, file=file, line=line, time_s=end.made_s, node=speaker(recording, end.node), **types)
