"""Options of plug-ins are looked for only when a word is not known otherwise."""

from __future__ import annotations

import argparse

import pytest

from edulaunch.desk.cli.plugin_options import add_plugin_options, plugins_of
from edulaunch.errors import UnusableInput
from edulaunch.runtime import plugins


def launch_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog='launch')
    parser.add_argument('--debug', '-d', action='store_true')
    parser.add_argument('rest', nargs='*')
    return parser


@pytest.mark.parametrize('words', [[], ['demo.launch.py', 'radius:=2'], ['-d'], ['--debug', 'a']])
def test_known_words_look_for_no_plug_in(words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plugins, 'plugins', lambda: pytest.fail('looked for plug-ins'))
    parser = launch_parser()
    add_plugin_options('launch', parser, words)
    assert plugins_of(parser.parse_args(words)) == []


class Slowly:
    """A module with an option."""

    @staticmethod
    def add_options(parser: argparse.ArgumentParser) -> None:
        parser.add_argument('--slowly', action='store_true')


@pytest.mark.parametrize('words', [['--slowly'], ['--help'], ['-h'], ['--slowly=1']])
def test_other_options_and_help_add_those_of_plug_ins(words: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plugins, 'options_of_plugins', {'launch': [Slowly]}.__getitem__)
    parser = launch_parser()
    add_plugin_options('launch', parser, words)
    arguments = parser.parse_args(['--slowly', 'demo'])
    assert arguments.slowly and plugins_of(arguments) == [Slowly]


@pytest.mark.parametrize(('command', 'word'), [('launch', 'edulaunch launch --real'), ('ros2 launch', 'ros2 launch --network')])
def test_an_option_of_a_plug_in_that_is_not_installed_names_it(command: str, word: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plugins, 'plugins', dict)
    with pytest.raises(UnusableInput, match=f"^{word} needs the plug-in 'network', which is not installed"):
        add_plugin_options(command, launch_parser(), [word.split()[-1]])
    add_plugin_options(command, launch_parser(), ['--no-such-option'])
