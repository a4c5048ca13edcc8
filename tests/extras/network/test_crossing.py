"""Which topics and services cross to a real network, and in which direction."""

from __future__ import annotations

import argparse
from typing import Any

import pytest

from edulaunch.errors import UnusableInput
from edulaunch.extras.network.crossing import EVERYTHING, Crossing, JoinRequest, add_options, join_request, option_words
from edulaunch.extras.network.network_link import CLIENT, PUBLISHER, SERVICE, SUBSCRIPTION

from .places import turns

KINDS = (PUBLISHER, SUBSCRIPTION, SERVICE, CLIENT)
TOPICS = ['/tf', '/turtle1/pose', '/turtle10/pose']


@pytest.mark.parametrize(
    ('names', 'crossing'),
    [
        ([], '/tf /turtle1/pose /turtle10/pose'),
        (['/'], '/tf /turtle1/pose /turtle10/pose'),
        (['turtle1', '/tf'], '/tf /turtle1/pose'),
        (['/turtle1/'], '/turtle1/pose'),
        (['/turtle1/pose'], '/turtle1/pose'),
    ],
)
def test_names_and_namespaces_that_cross(names: list[str], crossing: str) -> None:
    assert ' '.join(name for name in TOPICS if Crossing(names).allows(PUBLISHER, name, True)) == crossing


def test_what_is_denied_does_not_cross_whatever_else_is_named() -> None:
    crossing = Crossing(['/turtle1', '/tf'], deny=['/turtle1/cmd_vel'])
    assert [crossing.allows(kind, '/turtle1/cmd_vel', own) for kind in KINDS for own in (True, False)] == [False] * 8
    assert crossing.allows(PUBLISHER, '/turtle1/pose', True) and not crossing.allows(PUBLISHER, '/rosout', True)


@pytest.mark.parametrize(
    ('crossing', 'own', 'remote'),
    [
        (Crossing(incoming=[]), [PUBLISHER, CLIENT], [SUBSCRIPTION, SERVICE]),
        (Crossing(outgoing=[]), [SUBSCRIPTION, SERVICE], [PUBLISHER, CLIENT]),
        (Crossing(incoming=['/a'], outgoing=['/b']), [SUBSCRIPTION, SERVICE], [PUBLISHER, CLIENT]),
    ],
)
def test_each_direction_has_its_own_list(crossing: Crossing, own: list[str], remote: list[str]) -> None:
    assert [kind for kind in KINDS if crossing.allows(kind, '/a', True)] == own
    assert [kind for kind in KINDS if crossing.allows(kind, '/a', False)] == remote


@pytest.mark.parametrize(
    ('words', 'request_'),
    [
        ('', JoinRequest()),
        ('--topics /a b,c --deny d', JoinRequest(crossing=Crossing(('/a', 'b', 'c'), ('d',)))),
        ('--in /a --in /b --out /c', JoinRequest(crossing=Crossing((), (), ('/a', '/b'), ('/c',)))),
        ('--readonly --clock --link rclpy', JoinRequest('rclpy', True, Crossing((), (), (), None))),
    ],
)
@pytest.mark.parametrize('prefix', ['', 'network-'])
def test_options_survive_their_way_to_the_machine(words: str, request_: JoinRequest, prefix: str) -> None:
    parser = argparse.ArgumentParser()
    add_options(parser, prefix)
    typed = words.replace('/a b,c', '/a,b,c' if prefix else '/a b,c').replace('--', f'--{prefix}').split()
    assert join_request(option_words(parser.parse_args(typed), prefix)) == request_


def test_an_option_of_a_launch_leaves_package_and_file_alone() -> None:
    parser = argparse.ArgumentParser()
    add_options(parser, 'network-')
    parser.add_argument('package')
    assert parser.parse_args(['--network-deny', '/a,/b', 'turtlesim']).package == 'turtlesim'


@pytest.mark.parametrize(
    ('words', 'text'),
    [
        (['--topic=/a'], "no option '--topic=/a'"),
        (['/a'], "no option '/a'"),
        (['--topics'], 'expected at least one argument'),
        (['--readonly', '--in=/a'], 'leave one of them out'),
        (['--topics=,'], '--topics names no topic'),
        (['--deny=/a,b c'], "--deny names 'b c': "),
        (['--out=/turtle*'], "--out names '/turtle*': topic name must not contain characters other than"),
    ],
)
def test_options_that_make_no_sense_are_refused(words: list[str], text: str) -> None:
    with pytest.raises(UnusableInput) as error:
        join_request(words)
    assert text in str(error.value)


def test_the_status_names_the_lists() -> None:
    assert str(EVERYTHING) == 'all topics'
    assert str(Crossing(['/a'], ['/a/b'], [], ['/c', '/d'])) == '/a, not /a/b, in: nothing, out: /c /d'


def test_nothing_from_outside_reaches_a_readonly_machine(place: Any) -> None:
    """A stranger sees the poses. He cannot drive the turtle, call a service, or be heard."""
    here, there = place('a', crossing=join_request(['--readonly']).crossing), place('b')
    pose = here.publisher('/turtle1/pose')
    here.subscription('/turtle1/cmd_vel')
    here.service('/reset')
    there.subscription('/turtle1/pose')
    drive = there.publisher('/turtle1/cmd_vel')
    call = there.client('/reset')
    turns(here, there)
    pose.publish(('here',))
    drive.publish(('away',))
    call.send(())
    turns(here, there)
    assert there.heard == [('here',)] and here.heard == [] and here.asked == []
    assert sorted(end.name for end in here.link.ends.values()) == ['/turtle1/pose']
    assert list(here.graph.publishers.get('/turtle1/cmd_vel', ())) == []


def test_nothing_leaves_a_machine_whose_outgoing_list_names_something_else(place: Any) -> None:
    here, there = place('a', crossing=join_request(['--out', '/tf']).crossing), place('b')
    pose, tf = here.publisher('/turtle1/pose'), here.publisher('/tf')
    there.subscription('/turtle1/pose')
    there.subscription('/tf')
    here.subscription('/cmd')
    command = there.publisher('/cmd')
    turns(here, there)
    for publisher, text in ((pose, 'pose'), (tf, 'tf'), (command, 'command')):
        publisher.publish((text,))
    turns(here, there)
    assert there.heard == [('tf',)] and here.heard == [('command',)]
