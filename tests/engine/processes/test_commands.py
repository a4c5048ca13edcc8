"""Which command lines a machine runs itself, and what it needs to be handed for that."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import pytest

from edulaunch.engine.processes.commands import CommandSet, Main
from edulaunch.engine.processes.spec import ProcessSpec


class EchoShell:
    """A shell whose lines begin with '!' and write themselves."""

    def needs_shell(self, line: str) -> bool:
        return line.startswith('!')

    def script_of(self, words: Sequence[str]) -> Sequence[str] | None:
        return words[1:] if words[0] == 'shell' else None

    def main_of(self, line: str, arguments: Sequence[str], knows: Callable[[Sequence[str]], bool]) -> Main | None:
        if not knows([line[1:]]):
            return None
        return lambda process: process.write('stdout', ' '.join([line, *arguments]))


def tool(process: Any) -> int:
    process.write('stdout', f'tool {process.argv}')
    return 5


def output(world: Any, *words: str, shell: bool = False) -> list[str]:
    wrote: list[str] = []
    process = world.host.start(ProcessSpec(argv=words, name='line', shell=shell), lambda stream, text: wrote.append(text))
    world.sim.run()
    return [*wrote, str(process.returncode)]


@pytest.mark.parametrize('words', [('tool', 'a'), ('/opt/bin/tool', 'a'), ('nice', 'tool', 'a')])
def test_a_tool_is_found_by_its_name_behind_a_path_and_a_wrapper(world: Any, words: tuple[str, ...]) -> None:
    world.host.command_set = CommandSet({'tool': tool})
    assert output(world, *words) == [f'tool {list(words[words.index("a") - 1 :])}', '5']


def test_a_machine_without_tools_and_shell_leaves_both_to_this_computer(world: Any) -> None:
    assert not world.host.knows(ProcessSpec(argv=('ros2', 'topic', 'list'), name=''))
    assert not world.host.knows(ProcessSpec(argv=('sh', '-c', world.write('a.py', '')), name=''))
    assert world.host.knows(ProcessSpec(argv=(world.write('a.py', '') + ' x',), name='', shell=True)), 'plain words need no shell'


def test_a_line_is_followed_by_the_shell_that_was_handed_in(world: Any) -> None:
    world.host.command_set = CommandSet({'tool': tool}, EchoShell())
    assert output(world, '!tool', shell=True) == ['!tool', '0']
    assert output(world, 'shell', '!tool', 'x') == ['!tool x', '0']
    assert not world.host.knows(ProcessSpec(argv=('!other',), name='', shell=True)), 'a line without a simulated command'


def test_a_tool_behind_another_word_is_an_argument(world: Any) -> None:
    world.host.command_set = CommandSet({'tool': tool})
    assert not world.host.knows(ProcessSpec(argv=('ls', 'tool'), name=''))


@pytest.mark.parametrize(
    'words',
    [('python3', '{file}', 'a'), ('/usr/bin/python3.12', '{file}', 'a'), ('{file}', 'a'), ('nice', 'python3', '{file}', 'a')],
)
def test_python_and_a_file_of_python_run_here(world: Any, words: tuple[str, ...]) -> None:
    file = world.write('says.py', 'import sys\nprint(*sys.argv[1:])\nsys.exit(3)')
    *wrote, code = output(world, *(word.format(file=file) for word in words))
    assert (''.join(wrote), code) == ('a\n', '3')


@pytest.mark.parametrize('words', [(), ('cat', 'says.py'), ('python3',), ('pythonic', 'x'), ('python3', '-m', 'nobody_has_it')])
def test_what_is_neither_python_nor_known_is_left_to_this_computer(world: Any, words: tuple[str, ...]) -> None:
    assert not world.host.knows(ProcessSpec(argv=words, name=''))
