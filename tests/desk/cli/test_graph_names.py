"""Names of the graph as the `ros2` commands list them."""

from __future__ import annotations

import argparse
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.desk.cli.ros2 import graph_names

LISTED = [('/a', ['p/msg/A']), ('/_h', ['p/msg/B']), ('/b/_c/d', ['p/msg/A', 'p/msg/B'])]


@pytest.mark.parametrize(('name', 'is_hidden'), [('/a', False), ('/_a', True), ('/a/_b/c', True), ('/a_b', False), ('_a', True)])
def test_hidden_names_have_a_part_that_begins_with_a_line(name: str, is_hidden: bool) -> None:
    assert graph_names.is_hidden(name) is is_hidden


def test_only_visible_names_unless_all_are_asked_for() -> None:
    assert graph_names.visible(LISTED, False) == LISTED[:1]
    assert graph_names.visible(LISTED, True) == LISTED
    node: Any = SimpleNamespace(get_fully_qualified_node_names=lambda: ['/b', '/_cli', '/a'])
    assert (graph_names.node_names(node), graph_names.node_names(node, False)) == (['/_cli', '/a', '/b'], ['/a', '/b'])


def test_names_become_absolute() -> None:
    assert (graph_names.absolute('a/b'), graph_names.absolute('/a')) == ('/a/b', '/a')


def options(add: Any, *words: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    add(parser)
    return parser.parse_args(words)


def test_lists_have_types_and_counts_if_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    monkeypatch.setattr(graph_names, 'say', said.append)
    monkeypatch.setattr(graph_names, 'say_lines', said.extend)
    for words in ((), ('-t',), ('--show-types',), ('-c',), ('--count-topics', '-t')):
        graph_names.say_names(LISTED[1:], options(lambda parser: graph_names.add_list_arguments(parser, 'topic'), *words))
        said.append('')
    with_types = ['/_h [p/msg/B]', '/b/_c/d [p/msg/A, p/msg/B]']
    assert said == ['/_h', '/b/_c/d', '', *with_types, '', *with_types, '', '2', '', '2', '']
    said.clear()
    graph_names.say_found(LISTED, 'p/msg/A', count=False)
    graph_names.say_found(LISTED, 'p/msg/A', count=True)
    assert said == ['/a', '/b/_c/d', '2']
    said.clear()
    assert (graph_names.say_types('/b/_c/d', LISTED), graph_names.say_types('/nothing', LISTED)) == (0, 1)
    assert said == ['p/msg/A', 'p/msg/B']
    assert (graph_names.types_of('/a', LISTED), graph_names.types_of('a', LISTED)) == (['p/msg/A'], [])


def test_options_of_names_and_types() -> None:
    found = options(
        lambda parser: graph_names.add_find_arguments(parser, 'service', 'x'), 'p/srv/A', '-c', '--include-hidden-services'
    )
    assert (found.service_type, found.count, found.include_hidden_services) == ('p/srv/A', True, True)
    found = options(lambda parser: graph_names.add_find_arguments(parser, 'service', 'x'), 'p/srv/A')
    assert (found.count, found.include_hidden_services) == (False, False)
    assert options(lambda parser: graph_names.add_name_arguments(parser, 'topic', 'tap into', '/x'), '/a').topic_name == '/a'


def test_actions_are_seen_by_their_feedback() -> None:
    topics = [('/a/_action/feedback', ['p/action/F_FeedbackMessage']), ('/a/_action/status', ['x']), ('/b', ['p/msg/A'])]
    node: Any = SimpleNamespace(
        get_topic_names_and_types=lambda: topics,
        get_publisher_names_and_types_by_node=lambda name, namespace: topics if (name, namespace) == ('n', '/') else [],
        get_subscriber_names_and_types_by_node=lambda name, namespace: topics if (name, namespace) == ('m', '/') else [],
    )
    actions = [('/a', ['p/action/F'])]
    assert graph_names.action_names_and_types(node) == actions
    assert [graph_names.servers_by_node(node, name, '/') for name in 'nm'] == [actions, []]
    assert [graph_names.clients_by_node(node, name, '/') for name in 'nm'] == [[], actions]


@pytest.mark.parametrize(
    ('add', 'lines'),
    [
        (
            lambda parser: graph_names.add_find_arguments(parser, 'topic', 'std_msgs/msg/String'),
            [
                "topic_type Name of the ROS topic type to filter for (e.g. 'std_msgs/msg/String')",
                '-c, --count-topics Only display the number of topics discovered',
                '--include-hidden-topics Consider hidden topics as well',
            ],
        ),
        (
            lambda parser: graph_names.add_list_arguments(parser, 'service'),
            [
                '-t, --show-types Additionally show the service type',
                '-c, --count-services Only display the number of services discovered',
            ],
        ),
        (
            lambda parser: graph_names.add_name_arguments(parser, 'action', 'get info', '/fibonacci'),
            ["action_name Name of the ROS action to get info (e.g. '/fibonacci')"],
        ),
    ],
)
def test_the_help_is_that_of_ros(add: Any, lines: list[str]) -> None:
    parser = argparse.ArgumentParser()
    add(parser)
    shown = ' '.join(parser.format_help().split())
    assert [line for line in lines if line not in shown] == []
