"""A run for real, observed: by a node beside it, and by what its processes write."""

from __future__ import annotations

import base64
import json
import os
import random
import subprocess
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import IO, Any

from edulaunch.comparing.observation import (
    NOT_COMPARED,
    End,
    Flow,
    Line,
    Observation,
    add_messages,
    is_compared,
    lines_of,
    program_of,
)
from edulaunch.errors import EdulaunchError
from edulaunch.interfaces.cdr import decode
from edulaunch.native.command import command
from edulaunch.native.host import NativeHost, NativeSession
from edulaunch.packages import Program
from edulaunch.packages.index import interfaces_of
from edulaunch.processes.spec import ProcessSpec
from edulaunch.session import Session

END_S = 15.0
"""After Ctrl-C: launch kills what has not ended by then."""
ASKING_S = 2.0
"""So long before Ctrl-C nodes are asked for their parameters."""
DOMAINS = 101
"""ROS_DOMAIN_IDs that are safe on every system, from 1; one by chance, so that two comparisons at a time rarely meet."""
_OBSERVER = Program('entry_point', '', 'observer', 'observer', module='edulaunch.native.observer', function='main')


def run_for_real(
    path: str, file: str | None, arguments: Mapping[str, str], seconds: float, workspaces: Sequence[str]
) -> Observation:
    """Launch it in a domain of its own on this computer, press Ctrl-C after `seconds`, and say what was seen.

    :raises UnusableInput: when it cannot be launched at all, or the real rclpy is not installed.
    """
    env = {
        **os.environ,
        'ROS_DOMAIN_ID': str(1 + random.SystemRandom().randrange(DOMAINS)),
        'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST',
    }
    with NativeSession(workspaces=workspaces, env=env) as session, _observer(session) as (tell, hear):
        began_s = time.time()
        launch = session.launch(path, file, arguments)
        session.run(max(0.0, seconds - ASKING_S), speed=1.0)
        tell.write('end\n')
        tell.flush()
        session.run(min(seconds, ASKING_S), speed=1.0)
        launch.raise_error()
        seen = json.loads(hear.readline() or 'null')
        session.interrupt()
        session.run(END_S, speed=1.0)
        assert isinstance(session.host, NativeHost)
        return _observation(seen, session, began_s, seconds)


@contextmanager
def _observer(session: Session) -> Iterator[tuple[IO[str], IO[str]]]:
    """A node that notes what it sees: what it is told by, and what it tells by.

    :raises EdulaunchError: it did not come up.
    """
    assert isinstance(session.host, NativeHost)
    words = command(session.host.environment, _OBSERVER, ProcessSpec((), 'observer'), session.index)
    pipes: dict[str, Any] = {'stdin': subprocess.PIPE, 'stdout': subprocess.PIPE, 'stderr': subprocess.PIPE}
    with subprocess.Popen([*words, 'observer'], env=session.host.env, text=True, start_new_session=True, **pipes) as child:
        assert child.stdin is not None and child.stdout is not None and child.stderr is not None
        try:
            if child.stdout.readline() != 'ready\n':
                raise EdulaunchError('nothing could be observed:\n' + ''.join(child.stderr.readlines()[-5:]))
            yield child.stdin, child.stdout
        finally:
            child.kill()


def _observation(seen: Any, session: Session, began_s: float, asked_s: float) -> Observation:
    """What the observer saw, with what the processes wrote."""
    if seen is None:
        raise EdulaunchError('the observer of the real run died.')
    ends: dict[End, tuple[str, float]] = {}
    for kind, name, type_name, node, qos, when in seen['ends']:
        if is_compared(node):
            ends.setdefault(End(kind, name, type_name, node), (qos, when - began_s))
    registry = interfaces_of(session.index)[1]
    flows: dict[str, Flow] = {}
    for topic, (type_name, rows) in seen['messages'].items():
        if topic not in NOT_COMPARED:
            cls: Any = registry.get(type_name)
            wires = ((when - began_s, decode(cls, base64.b64decode(data))) for when, data in rows)
            add_messages(flows, topic, type_name, wires, registry.get)
    assert isinstance(session.host, NativeHost)
    codes: dict[str, list[int]] = {}
    lines: list[Line] = []
    for run in session.host.runs:
        for stream in ('stdout', 'stderr'):
            pieces = [(when, text) for when, each, text in run.written if each == stream]
            lines += lines_of(program_of(run.name), pieces)
        if run.returncode is not None:
            codes.setdefault(program_of(run.name), []).append(run.returncode)
    nodes = {node: when - began_s for node, when in seen['nodes'].items() if is_compared(node)}
    return Observation(nodes, ends, seen['parameters'], flows, lines, codes, asked_s)
