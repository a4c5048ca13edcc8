"""The topics and services that cross to a real network, the directions in which they cross, and the options for them."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import NamedTuple, NoReturn

from edulaunch.engine.graph.names import full_topic_name_problem
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import UnusableInput
from edulaunch.extras.network.links import DEFAULT
from edulaunch.extras.network.network_link import CLIENT, PUBLISHER

LISTS = {
    'topics': 'let only these topics, services and namespaces cross',
    'deny': 'let these not cross',
    'in': 'let only these come in from the network',
    'out': 'let only these go out to the network',
}
"""The options that take lists of names, with their help."""


class Crossing(NamedTuple):
    """The names that cross. A name includes that topic or service, and everything in the namespace of that name; '/' means
    everything.

    Incoming data are messages for subscriptions of this machine and calls of its services. Outgoing data are messages of its
    publishers and calls of its clients.

    :ivar names: the names that may cross; empty means everything.
    :ivar deny: the names that do not cross, even if other lists contain them.
    :ivar incoming: the names that cross from the network to this machine; None means everything.
    :ivar outgoing: the names that cross from this machine to the network; None means everything.
    """

    names: Sequence[str] = ()
    deny: Sequence[str] = ()
    incoming: Sequence[str] | None = None
    outgoing: Sequence[str] | None = None

    def allows(self, kind: str, name: str, is_own: bool) -> bool:
        """Return whether the messages or calls of an endpoint may cross.

        :param kind: 'publisher', 'subscription', 'service' or 'client'.
        :param name: the expanded name of the topic or service.
        :param is_own: whether the endpoint belongs to this machine.
        """
        goes_out = (kind in (PUBLISHER, CLIENT)) == is_own
        one_way = self.outgoing if goes_out else self.incoming
        if self.deny and covers(self.deny, name):
            return False
        return (not self.names or covers(self.names, name)) and (one_way is None or covers(one_way, name))

    def __str__(self) -> str:
        parts = [' '.join(self.names) or 'all topics']
        if self.deny:
            parts.append(f'not {" ".join(self.deny)}')
        for label, names in (('in', self.incoming), ('out', self.outgoing)):
            if names is not None:
                parts.append(f'{label}: {" ".join(names) or "nothing"}')
        return ', '.join(parts)


EVERYTHING = Crossing()


class JoinRequest(NamedTuple):
    """The settings of a join.

    :ivar link: the link that carries the messages.
    :ivar clock: whether the machine's time is published on /clock.
    """

    link: str = DEFAULT
    clock: bool = False
    crossing: Crossing = EVERYTHING


def covers(names: Sequence[str], name: str) -> bool:
    """Return whether a name is one of `names`, or is in one of these namespaces."""
    wanted = ['/' + each.strip('/') for each in names]
    return any(each in ('/', name) or name.startswith(each + '/') for each in wanted)


def add_options(parser: argparse.ArgumentParser, prefix: str = '') -> None:
    """Add the options of a join. Commas may separate the names of a list.

    :param prefix: the beginning of the name of each option, which is 'network-' for a launch. For a launch, each option
        takes one word, so that an option cannot also take the package and the launch file.
    """
    for name, text in LISTS.items():
        parser.add_argument(
            f'--{prefix}{name}', nargs=1 if prefix else '+', action='extend', default=[], metavar='NAMES', help=text
        )
    parser.add_argument(f'--{prefix}readonly', action='store_true', help='let nothing in, so that others can only observe')
    parser.add_argument(f'--{prefix}clock', action='store_true', help="publish the machine's time on /clock, for use_sim_time")
    parser.add_argument(f'--{prefix}link', metavar='LINK', help='link that carries the messages: cyclonedds (default) or rclpy')


def option_words(arguments: argparse.Namespace, prefix: str = '') -> list[str]:
    """Return the options of :func:`add_options` as command-line words again, without the prefix."""
    start = prefix.replace('-', '_')
    words = [f'--{name}={value}' for name in LISTS for value in getattr(arguments, start + name)]
    words += [f'--{name}' for name in ('readonly', 'clock') if getattr(arguments, start + name)]
    link = getattr(arguments, start + 'link')
    return words if link is None else [*words, f'--link={link}']


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise UnusableInput(f'edulaunch network on: {message}', help='see edulaunch network --help')


def _names(option: str, values: Sequence[str]) -> tuple[str, ...]:
    """Return the names of a list.

    :raises UnusableInput: for a list without names, which would mean everything, and for a name that no topic can have.
    """
    names = tuple(each for value in values for each in value.split(',') if each)
    if values and not names:
        raise UnusableInput(f'{option} names no topic', help='name a topic, a service or a namespace')
    for name in names:
        problem = name.strip('/') and full_topic_name_problem('/' + name.strip('/'))
        if problem:
            raise UnusableInput(
                f'{option} names {name!r}: {problem[0]}', help='name a topic, a service or a namespace, such as /turtle1'
            )
    return names


def join_request(words: Sequence[str]) -> JoinRequest:
    """Return the join request that the options describe.

    :raises UnusableInput: for unknown options, and for contradictory lists.
    """
    parser = _Parser(prog='edulaunch network on', add_help=False, allow_abbrev=False)
    add_options(parser)
    found, unknown = parser.parse_known_args(list(words))
    if unknown:
        known = [f'--{name}' for name in (*LISTS, 'readonly', 'clock', 'link')]
        raise UnusableInput(f'edulaunch network on has no option {unknown[0]!r}', help=did_you_mean(unknown[0], known) or None)
    lists = {name: _names(f'--{name}', getattr(found, name)) for name in LISTS}
    if found.readonly and lists['in']:
        raise UnusableInput('--readonly lets nothing in, but --in names topics that come in', help='leave one of them out')
    incoming = () if found.readonly else lists['in'] or None
    return JoinRequest(
        found.link or DEFAULT, found.clock, Crossing(lists['topics'], lists['deny'], incoming, lists['out'] or None)
    )
