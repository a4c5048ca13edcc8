"""Plug-ins are found by entry points; one that is broken, or whose folder was taken away, costs the others nothing."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterator
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.errors import UnusableInput
from edulaunch.runtime import plugins


def forget() -> None:
    """As in a fresh process."""
    plugins.plugins.cache_clear()
    plugins.plugins_of_others.cache_clear()
    plugins._loaded.cache_clear()


Installed = Callable[..., None]


@pytest.fixture
def installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Installed]:
    """Puts a distribution with a plug-in on the path, beside those that are there."""

    def install(name: str, entry: str, text: str = '') -> None:
        (tmp_path / f'{name}_plugin.py').write_text(text)
        info = tmp_path / f'{name}-1.0.dist-info'
        info.mkdir()
        (info / 'METADATA').write_text(f'Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n')
        (info / 'entry_points.txt').write_text(f'[edulaunch.plugins]\n{name} = {entry}\n')
        forget()

    monkeypatch.syspath_prepend(tmp_path)
    yield install
    forget()
    for name in [name for name in sys.modules if name.endswith('_plugin') and not name.startswith('edulaunch')]:
        del sys.modules[name]


GREETING = """
from edulaunch.runtime.plugins import Plugin, Verb
PLUGIN = Plugin(verbs={'greet': Verb('Say hello', 'greeting_plugin')}, functions={'greet': 'greeting_plugin:greet'})
def greet_arguments(parser):
    parser.add_argument('name')
def greet_verb(arguments):
    print(greet(arguments.name))
    return 3
def greet(name):
    return f'hello {name}'
"""


def test_a_verb_stands_in_the_help_and_runs(installed: Installed, capsys: pytest.CaptureFixture[str]) -> None:
    installed('greeting', 'greeting_plugin:PLUGIN', GREETING)
    assert main(['greet', 'turtle']) == 3
    assert capsys.readouterr().out == 'hello turtle\n'
    with pytest.raises(SystemExit):
        main(['--help'])
    listed = capsys.readouterr().out.partition('commands:\n')[2].partition('\n\n')[0]
    verbs = [line.split()[0] for line in listed.splitlines()]
    assert verbs == sorted(verbs) and {'greet', 'launch', 'rosdep'} <= set(verbs)


def test_the_package_offers_a_function_of_a_plug_in(installed: Installed) -> None:
    with pytest.raises(UnusableInput, match='no plug-in provides edulaunch.greet'):
        plugins.offered('greet')
    installed('greeting', 'greeting_plugin:PLUGIN', GREETING)
    assert plugins.offered('greet')('you') == 'hello you'


@pytest.mark.parametrize(
    ('text', 'why'),
    [
        ('1 / 0', 'ZeroDivisionError: division by zero'),
        ('import no_such_module', "ModuleNotFoundError: No module named 'no_such_module'"),
        ('PLUGIN = {}', 'odd_plugin:PLUGIN is not an edulaunch.runtime.plugins.Plugin'),
    ],
)
def test_a_broken_plug_in_is_named_and_the_others_are_there(
    installed: Installed, capsys: pytest.CaptureFixture[str], text: str, why: str
) -> None:
    installed('greeting', 'greeting_plugin:PLUGIN', GREETING)
    installed('odd', 'odd_plugin:PLUGIN', text)
    assert 'greeting' in plugins.plugins() and 'odd' not in plugins.plugins()
    assert capsys.readouterr().err == (
        f"warning: the plug-in 'odd' of odd cannot be used: {why}\n  help: fix odd_plugin, or remove it: pip uninstall odd\n"
    )


def test_one_whose_folder_was_taken_away_is_not_there(installed: Installed, capsys: pytest.CaptureFixture[str]) -> None:
    installed('gone', 'gone_away.plugin:PLUGIN')
    assert 'gone' not in plugins.plugins()
    assert capsys.readouterr().err == ''


def test_one_that_needs_a_plug_in_that_is_not_there_is_not_there_either(installed: Installed) -> None:
    text = "from edulaunch.runtime.plugins import Plugin\nPLUGIN = Plugin(needs=('edulaunch', {!r}))"
    installed('first', 'first_plugin:PLUGIN', text.format('edulaunch.extras.no_such_one'))
    installed('second', 'second_plugin:PLUGIN', text.format('edulaunch.runtime'))
    assert {'first', 'second'} & set(plugins.plugins()) == {'second'}


def test_what_our_own_would_bring_is_named_with_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plugins, 'entries', list)
    error = plugins.absent('edulaunch network')
    assert str(error) == (
        "edulaunch network needs the plug-in 'network', which is not installed.\n"
        "  help: install it: pip install --force-reinstall '.[network]' in the folder of edulaunch's setup.sh"
    )
    assert plugins.absent('edulaunch launch') is None


def test_one_of_ours_names_what_it_needs(installed: Installed, monkeypatch: pytest.MonkeyPatch) -> None:
    installed(
        'ferry', 'ferry_plugin:PLUGIN', "from edulaunch.runtime.plugins import Plugin\nPLUGIN = Plugin(needs=('lake.water',))"
    )
    monkeypatch.setitem(plugins.SOURCES, 'edulaunch ferry', plugins.Provider('ferry', 'pip install ferry'))
    assert str(plugins.absent('edulaunch ferry')) == (
        "edulaunch ferry needs the plug-in 'water', which is not installed.\n  help: install it: pip install ferry"
    )


def test_the_entry_points_are_those_that_the_standard_library_finds(installed: Installed) -> None:
    installed('greeting', 'greeting_plugin:PLUGIN', GREETING)
    there = {(entry.name, entry.value) for entry in entry_points(group=plugins.GROUP)}
    assert {(entry.name, entry.place) for entry in plugins.entries()} == there and len(there) > 1


def test_the_current_folder_brings_no_plug_in(installed: Installed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    installed('greeting', 'greeting_plugin:PLUGIN', GREETING)
    assert 'greeting' in {entry.name for entry in plugins.entries()}
    monkeypatch.chdir(tmp_path)
    for here in ('', '.', str(tmp_path)):
        monkeypatch.setattr(sys, 'path', [here, *(folder for folder in sys.path if folder != str(tmp_path))])
        assert 'greeting' not in {entry.name for entry in plugins.entries()}


def test_a_built_in_verb_looks_for_no_plug_in(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(plugins, 'entries', lambda: pytest.fail('looked for plug-ins'))
    forget()
    assert main(['env']) == 0


@pytest.mark.processes
def test_help_loads_the_descriptions_of_plug_ins_and_nothing_that_they_use() -> None:
    code = 'import sys\nfrom edulaunch.desk.cli.main import all_verbs\nall_verbs()\n'
    code += "print([name for name in sys.modules if name.startswith('edugrade.')])"
    done = subprocess.run([sys.executable, '-c', code], capture_output=True, text=True, check=True)
    assert done.stdout == "['edugrade.classes', 'edugrade.classes.plugin', 'edugrade.plugin']\n"
