"""Rules about problems between computers that cause no error: no other computer, another clock, or another type definition."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.rule import Finding, found, rule

if TYPE_CHECKING:
    from edulaunch.engine.recording import Note, Recording

LESSON = '18_real_network'
REMOTE = 'network'
"""The process of nodes on another machine."""


def _notes(recording: Recording, kind: str) -> Iterator[Note]:
    return (note for note in recording.notes if note.kind == f'network {kind}')


@rule(
    'programs.alone-on-network',
    what='this machine found no other computer in domain {domain} of the network (discovery range: {range})',
    why='ROS 2 reports no error if the other computer uses another domain or is unreachable',
    do=(
        'set ROS_DOMAIN_ID={domain} and ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET in every terminal of both computers; '
        'without multicast, name the other computer in ROS_STATIC_PEERS'
    ),
    lesson=LESSON,
    level='info',
)
def alone(recording: Recording) -> Iterator[Finding]:
    """Report a network without other computers, unless a node appeared later. The hidden node of the bridge does not count."""
    if any(node.process == REMOTE and '/_' not in node.name for node in recording.nodes):
        return
    for note in list(_notes(recording, 'alone'))[-1:]:
        domain, _, reach = note.text.partition(' ')
        yield found('process', REMOTE, time_s=note.time_s, domain=domain, range=reach)


@rule(
    'time.other-clock',
    what='the clock of the computer that runs {node} differs from the clock of this computer',
    why='time stamps of one computer are in the past or the future of the other, so tf lookups fail and filters drop messages',
    do='synchronize the clocks of both computers with NTP, and compare them with `date`',
    lesson=LESSON,
)
def other_clock(recording: Recording) -> Iterator[Finding]:
    """Report each node once if its time stamps come from another clock."""
    for note in _notes(recording, 'clock'):
        yield found('node', note.text, time_s=note.time_s)


@rule(
    'messages.other-definition',
    what='{type} has a different definition on the other computer, so its messages are misread or dropped',
    why='the type has the same name on both computers, but not the same type hash, which depends on its fields',
    do=(
        'build the same version of the package {package} on both computers, and compare the hashes with `ros2 '
        'topic info --verbose`'
    ),
    lesson=LESSON,
    level='error',
)
def other_definition(recording: Recording) -> Iterator[Finding]:
    """Report each type once if another computer has another definition of the type."""
    for note in _notes(recording, 'hash'):
        package = note.text.partition('/')[0]
        yield found('package', package, time_s=note.time_s, type=note.text)
