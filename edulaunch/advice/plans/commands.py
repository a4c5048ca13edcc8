"""Command lines that name no program."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.outlines import branches, nodes, place_of
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal
    from edulaunch.plan.outline import Branch

LESSON = '01_first_launch'


@rule(
    'launch.command-in-one-word',
    what="'{command}' is taken for the name of one program",
    why='without a shell nobody takes the text apart, so no such program is found',
    do='write each word by itself: cmd=[{words}], or add shell=True',
    lesson=LESSON,
    level='error',
)
def command_in_one_word(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of an ExecuteProcess without a shell whose first word has spaces in it."""
    for branch, item in _commands(rehearsal):
        first = item['cmd'][0]
        if len(first.split()) > 1 and not os.path.exists(first):
            words = ', '.join(repr(part) for word in item['cmd'] for part in word.split())
            yield found('command', first, **place_of(branch), words=words)


@rule(
    'launch.command-of-letters',
    what="cmd is one text, '{command}', of which every letter is taken for a word",
    why='cmd= wants a list: a text is a list of letters to Python',
    do='write a list: cmd=[{words}]',
    lesson=LESSON,
    level='error',
)
def command_of_letters(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of an ExecuteProcess."""
    for branch, item in _commands(rehearsal):
        if len(item['cmd']) > 2 and all(len(word) == 1 for word in item['cmd']):
            text = ''.join(item['cmd'])
            yield found('command', text, **place_of(branch), words=', '.join(map(repr, text.split())))


def _commands(rehearsal: Rehearsal) -> Iterator[tuple[Branch, dict[str, Any]]]:
    for branch in branches(rehearsal):
        if branch.item is not None and branch.item['kind'] == 'process' and not branch.item['shell']:
            yield branch, branch.item


@rule(
    'launch.no-package',
    what="the Node has executable='{executable}' and no package, so it is looked for among the commands of this machine",
    why='executables of ROS 2 packages are not on the PATH',
    do="write package='{package}' beside it",
    lesson=LESSON,
    level='error',
)
def no_package(rehearsal: Rehearsal) -> Iterator[Finding]:
    """When a package of ours has an executable of that name, and the PATH has none."""
    from shutil import which

    for branch, item in nodes(rehearsal):
        name = item['executable']
        if item['package'] is None and os.sep not in name and which(name) is None:
            package = _package_with(name)
            if package is not None:
                yield found('executable', name, **place_of(branch), package=package)


def _package_with(executable: str) -> str | None:
    from edulaunch.packages import Index

    index = Index()
    return next((package for package in sorted(index.packages()) if executable in index.executables(package)), None)
