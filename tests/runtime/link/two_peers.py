"""Runs a launch alone and over the link, each in this interpreter; as a program it prints the digests of many."""

from __future__ import annotations

import json
import os
import signal
import socket
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[3]
MACHINE = {'USER': 'student', 'PATH': '/usr/bin:/bin'}
Launch = tuple[str, str, 'str | None', dict[str, str], float, int, list[str], dict[str, str]]
"""A name for it, path or package, file, arguments, seconds, seed, workspaces, what is typed."""


def alone(launch: Launch) -> str:
    """The digest of a launch in one process."""
    from edulaunch.runtime.session import Session

    _, what, file, arguments, duration_s, seed, workspaces, stdin = launch
    with Session(seed=seed, workspaces=workspaces, env=MACHINE, stdin=stdin) as session:
        session.launch(what, file, arguments)
        session.run(duration_s)
        return session.recording().digest()


def linked(launch: Launch) -> str:
    """The digest of the same launch in two peers."""
    from edulaunch.engine.recording import Recording
    from edulaunch.runtime.link.trusted import Trusted

    ours, theirs = socket.socketpair()
    pid = os.fork()
    if pid == 0:
        ours.close()
        be_confined(theirs, launch)
    theirs.close()
    try:
        return Recording(Trusted(ours, launch[5]).run(launch[4])).digest()
    finally:
        ours.close()
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)


def be_confined(end: socket.socket, launch: Launch) -> None:
    from edulaunch.runtime.link.confined import ConfinedSession

    _, what, file, arguments, _, seed, workspaces, stdin = launch
    try:
        session = ConfinedSession(end, seed=seed, workspaces=workspaces, env=MACHINE, stdin=stdin)
        session.launch(what, file, arguments)
        session.run_as_asked()
    finally:
        os._exit(1)


def solutions() -> Iterator[Launch]:
    for seed in (0, 7):
        for path in sorted((ROOT / 'solutions').glob('*.launch.py')):
            yield path.name, str(path), None, {}, 20.0, seed, [], {}


def large_project() -> Iterator[Launch]:
    folder = ROOT / 'solutions' / 'large_project'
    yield 'large_project', 'large_project', 'large_project.launch.py', {}, 12.0, 0, [str(folder)], {}


def exercises() -> Iterator[Launch]:
    for path in sorted((ROOT / 'exercises').glob('*.launch.py')):
        yield path.name, str(path), None, {}, 10.0, 0, [], {}


def underlay() -> Iterator[Launch]:
    share = ROOT / 'edulaunch' / 'ros' / 'share'
    for path in sorted(share.rglob('launch/**/*launch*.*')):
        if path.suffix in ('.py', '.xml', '.yaml'):
            yield str(path.relative_to(share)), str(path), None, {}, 8.0, 0, [], {}


def corpus() -> Iterator[Launch]:
    from tests.packages_corpus.cases import CASES, CORPUS

    for name, case in CASES.items():
        for seed in (0, 1) if case.random else (0,):
            workspaces = [str(CORPUS / name)]
            yield name, case.package or name, case.file, dict(case.arguments), case.duration_s, seed, workspaces, dict(case.stdin)


def seeds() -> Iterator[Launch]:
    for path in sorted((ROOT.parent / 'shared' / 'seeds').rglob('*launch*.py')):
        yield str(path), str(path), None, {}, 6.0, 0, [], {}


GROUPS = {
    'large_project': large_project,
    'solutions': solutions,
    'exercises': exercises,
    'underlay': underlay,
    'corpus': corpus,
    'seeds': seeds,
}


def main() -> None:
    """Print (name, digest alone or what is wrong with the file, digest over the link) for each launch of a group."""
    sys.path.insert(0, str(ROOT))
    from edulaunch.errors import UnusableInput

    for launch in GROUPS[sys.argv[1]]():
        row: list[Any] = [launch[0]]
        try:
            row += [alone(launch), linked(launch)]
        except UnusableInput as error:
            row += [str(error)] * 2
        print(json.dumps(row), flush=True)


if __name__ == '__main__':
    main()
