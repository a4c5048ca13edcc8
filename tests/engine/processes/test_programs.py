"""Python programs that a command line names itself run in the simulation."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.engine.processes.programs import python_command
from edulaunch.engine.processes.spec import ProcessSpec

SAYS = 'import sys, time\ntime.sleep(1)\nprint(__name__, __package__, sys.argv[1:], time.time())\n'


def said(folder: Path, *words: str, shell: bool = False) -> str:
    """What a command line writes, in a session with a workspace of one package."""
    texts: list[str] = []
    with edulaunch.Session(workspaces=[folder / 'ws']) as session:
        spec = ProcessSpec(argv=words, cwd=str(folder), shell=shell)
        assert session.host.knows(spec) == (words[-1] != 'known')
        session.host.start(spec, lambda stream, text: texts.append(text))
        session.run(2)
    return ''.join(texts)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    package = tmp_path / 'ws' / 'robo'
    (package / 'robo').mkdir(parents=True)
    (package / 'package.xml').write_text(
        '<package><name>robo</name><export><build_type>ament_python</build_type></export></package>'
    )
    (package / 'setup.py').write_text("from setuptools import setup\nsetup(packages=['robo'])")
    (package / 'robo' / '__init__.py').write_text('')
    (package / 'robo' / 'helper.py').write_text('word = "helped"')
    (package / 'robo' / 'node.py').write_text('from .helper import word\nprint(word)\n' + SAYS)
    (package / 'robo' / '__main__.py').write_text(SAYS)
    (tmp_path / 'node.py').write_text('#!/usr/bin/env python3\n' + SAYS)
    (tmp_path / 'node.py').chmod(0o755)
    (tmp_path / 'plain.py').write_text(SAYS)
    return tmp_path


@pytest.mark.parametrize(
    'words', [['python3', 'node.py', 'a'], ['/usr/bin/python3.12', '-u', '-W', 'ignore', './node.py', 'a'], ['./node.py', 'a']]
)
def test_a_script_runs_in_simulated_time(folder: Path, words: list[str]) -> None:
    assert said(folder, *words) == "__main__ None ['a'] 1700000001.0\n"


def test_a_module_needs_no_arguments(folder: Path) -> None:
    assert said(folder, 'python3', '-m', 'plain') == '__main__  [] 1700000001.0\n'


def test_a_shell_line_may_name_a_script_too(folder: Path) -> None:
    assert said(folder, 'python3 plain.py "a b"', shell=True) == "__main__ None ['a b'] 1700000001.0\n"


@pytest.mark.parametrize(
    ('module', 'output'),
    [
        ('robo.node', "helped\n__main__ robo ['x'] 1700000001.0\n"),
        ('robo', "__main__ robo ['x'] 1700000001.0\n"),
        ('plain', "__main__  ['x'] 1700000001.0\n"),
    ],
)
def test_a_module_runs_in_its_package(folder: Path, module: str, output: str) -> None:
    assert said(folder, 'python3', '-m', module, 'x') == output


@pytest.mark.parametrize(
    'words', [['python3', '-m', 'http.server'], ['python3', '-c', 'print(1)'], ['./plain.py'], ['python3', 'no.py'], ['ls']]
)
def test_other_commands_are_real(folder: Path, words: list[str]) -> None:
    with edulaunch.Session(workspaces=[folder / 'ws']) as session:
        assert not session.host.knows(ProcessSpec(argv=tuple(words), cwd=str(folder)))


def test_a_package_of_the_workspace_is_not_installed_and_says_so(folder: Path) -> None:
    (folder / 'asks.py').write_text('from importlib.metadata import version\nprint(version("pytest") > "1")\nversion("robo")')
    wrote = said(folder, 'python3', 'asks.py')
    assert wrote.startswith('True\n') and 'read its package.xml' in wrote


@pytest.mark.parametrize('words', [['python3', '-m'], ['python3'], ['python3', '-u', '-W'], []])
def test_a_command_that_names_no_program_is_real(folder: Path, words: list[str]) -> None:
    assert python_command(words, str(folder), frozenset()) is None


@pytest.fixture
def entry(monkeypatch: pytest.MonkeyPatch, folder: Path) -> Iterator[Callable[[str], dict[str, Any]]]:
    """The facts of the error that the program of an entry point ends with."""

    def facts(target: str) -> dict[str, Any]:
        setup = f"from setuptools import setup\nsetup(packages=['robo'], entry_points={{'console_scripts': ['go = {target}']}})"
        (folder / 'ws/robo/setup.py').write_text(setup)
        config = '[develop]\nscript_dir=$base/lib/robo\n[install]\ninstall_scripts=$base/lib/robo\n'
        (folder / 'ws/robo/setup.cfg').write_text(config)
        with edulaunch.Session(workspaces=[folder / 'ws']) as session:
            process = session.host.start(
                ProcessSpec((f'{session.host.index.prefix("robo")}/lib/robo/go',), package='robo', executable='go'),
                lambda stream, text: None,
            )
            session.run(2)
            exception: dict[str, Any] = process.exception
            return {'type': exception['type'], **exception['facts']}

    yield facts


@pytest.mark.parametrize(
    ('target', 'found'),
    [
        (
            'robo.nod:main',
            {'type': 'ModuleNotFoundError', 'about': 'packages.entry-module', 'missing': 'robo.nod', 'near': 'robo.node'},
        ),
        ('robo.clean:mian', {'type': 'AttributeError', 'about': 'packages.entry-function', 'missing': 'mian', 'near': 'main'}),
        ('robo.clean', {'type': 'TypeError', 'about': 'packages.entry-no-function', 'near': 'robo.clean:main'}),
        ('robo.clean.main', {'type': 'ModuleNotFoundError', 'about': 'packages.entry-no-function', 'near': 'robo.clean:main'}),
        ('robo.helper', {'type': 'TypeError', 'about': 'packages.entry-no-function', 'near': None}),
    ],
)
def test_an_entry_point_that_leads_nowhere_says_what_it_misses(
    folder: Path, entry: Callable[[str], dict[str, Any]], target: str, found: dict[str, Any]
) -> None:
    (folder / 'ws/robo/robo/clean.py').write_text('def main():\n    pass\n')
    facts = entry(target)
    assert {name: facts.get(name) for name in found} == found
    assert (facts['executable'], facts['package'], facts['entry']) == ('go', 'robo', f'go = {target}')
