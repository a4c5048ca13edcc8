"""Our own plug-ins: each word of theirs can be named when it is missing, and each module that they name is there."""

from __future__ import annotations

import argparse

import pytest

from edulaunch.desk.cli.plugin_options import add_plugin_options, plugins_of
from edulaunch.runtime import plugins

OURS = ('classes', 'comparing', 'course', 'editor', 'foxglove', 'grader', 'network')


def test_every_word_of_our_own_plug_ins_can_be_named_when_it_is_missing() -> None:
    ours = {name: plugins.plugins()[name] for name in OURS}
    words = {f'edulaunch {word}' for plugin in ours.values() for word in plugin.verbs}
    words |= {f'edugrade {word}' for plugin in ours.values() for word in plugin.grading}
    words |= {f'edulaunch course template {name}' for plugin in ours.values() for name in plugin.templates}
    words |= {f'edulaunch.{name}' for plugin in ours.values() for name in plugin.functions}
    words |= {'edulaunch launch --network', 'edulaunch launch --real', 'ros2 launch --network', 'edulaunch view --foxglove'}
    assert words == set(plugins.SOURCES)
    assert {source.plugin for source in plugins.SOURCES.values()} == set(ours)


@pytest.mark.parametrize('words', [['--real'], ['--help'], ['--network-link=rclpy']])
def test_options_of_the_network_are_those_of_launch(words: list[str]) -> None:
    parser = argparse.ArgumentParser(prog='launch')
    add_plugin_options('launch', parser, words)
    arguments = parser.parse_args(['--real', '--network'])
    assert arguments.real and [module.__name__ for module in plugins_of(arguments)] == [
        'edulaunch.extras.network.edulaunch_launch'
    ]


def test_every_module_that_a_plug_in_names_is_there() -> None:
    for name in OURS:
        plugin = plugins.plugins()[name]
        named = [*plugin.options.values(), *plugin.services.values(), *(verb.module for verb in plugin.verbs.values())]
        assert all(map(plugins.is_here, [*plugin.needs, *named]))
        for place in (
            *plugin.functions.values(),
            *plugin.templates.values(),
            *(verb.function for verb in plugin.grading.values()),
        ):
            assert callable(plugins.function(place))


def test_our_own_bring_no_packages_and_no_rules() -> None:
    assert set(plugins.plugins()) - set(plugins.plugins_of_others()) == set(OURS)
    assert [name for name in OURS if plugins.plugins()[name].packages or plugins.plugins()[name].rules] == []
