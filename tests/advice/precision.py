"""Broken exercises and packages, written as beginners write them, each with one planted mistake: is that named first?

`broken/NAME/` holds the exercise, or a workspace with `src/`, and `planted.txt`: the mistake in words, the rules that name it, a
word that the sentence must have, and how it is run (as behind `edulaunch doctor`).

`healthy/NAME/` holds twins of some of them with nothing wrong, of which nothing may be said.

`python -m tests.advice.precision [NAME...]` prints what is said of each.
"""

from __future__ import annotations

import sys
from functools import cache
from pathlib import Path
from typing import NamedTuple

import edulaunch
from edulaunch.advice import Finding, judge, judge_plan, judge_sources, rendered
from edulaunch.advice.judging import in_order
from edulaunch.runtime.session import Session

BROKEN = Path(__file__).parent / 'broken'
HEALTHY = Path(__file__).parent / 'healthy'
NAMES = sorted(path.name for path in BROKEN.iterdir() if path.is_dir())
TWINS = sorted(path.name for path in HEALTHY.iterdir() if path.is_dir())


class Planted(NamedTuple):
    """What is wrong in one of them, and how it is run."""

    rules: list[str]
    word: str
    run: list[str]


def folder_of(name: str) -> Path:
    """Where a broken exercise or a healthy twin lies."""
    return BROKEN / name if name in NAMES else HEALTHY / name


def planted(name: str) -> Planted:
    """What `planted.txt` says."""
    lines = (folder_of(name) / 'planted.txt').read_text(encoding='utf-8').splitlines()
    fields = dict(line.split(': ', 1) for line in lines)
    return Planted(fields['rule'].split('|'), fields['names'], fields['run'].split())


@cache
def remarks(name: str) -> list[Finding]:
    """All that is said of a broken exercise: of its sources, of its dry run, and of its run."""
    folder, words = folder_of(name), planted(name).run
    seconds = float(words[words.index('--for') + 1]) if '--for' in words else 5.0
    words = words[: words.index('--for')] if '--for' in words else words
    workspace = [folder] if (folder / 'src').is_dir() else []
    sources = judge_sources(str(folder)) if workspace else []
    return in_order([*sources, *_of_launch(folder, words, workspace, seconds)])


def _of_launch(folder: Path, words: list[str], workspace: list[Path], seconds: float) -> list[Finding]:
    from edulaunch.advice.plan import rehearse
    from edulaunch.runtime.launching import find_launch_file

    with Session(workspaces=workspace) as session:
        first = words[0] if workspace else str(folder / words[0])
        path = find_launch_file(session.index, first, words[1] if workspace else None)
        given = dict(word.split(':=') for word in words if ':=' in word)
        rehearsal = rehearse(path, given, session.index, session.host.env, command_set=session.host.command_set)
        if rehearsal.plan['error'] is not None:
            return judge_plan(rehearsal)
        session.launch(path, None, given)
        session.run(seconds)
        return [*judge_plan(rehearsal), *judge(session.recording())]


def is_named_first(name: str) -> bool:
    """Whether the first remark is about the planted mistake, and names it."""
    mistake, said = planted(name), remarks(name)
    return bool(said) and said[0].rule in mistake.rules and mistake.word in str(rendered(said[0]))


def main(names: list[str]) -> None:
    """Print what is said."""
    for name in names or [*NAMES, *TWINS]:
        print(
            'twin  ' if name in TWINS else 'first ' if is_named_first(name) else 'MISSED', name, f'({len(remarks(name))} remarks)'
        )
        for finding in remarks(name):
            print(f'    [{finding.rule}] {rendered(finding).what}')


if __name__ == '__main__':
    edulaunch.source()
    main(sys.argv[1:])
