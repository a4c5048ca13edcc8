"""Check a saved launch file by executing it: a dry run in a confined child process, with a deadline."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from tempfile import TemporaryDirectory
from typing import Any

DEADLINE_S = 10.0
MEMORY_BYTES = 2 << 30
Outcome = dict[str, Any]


def saved_check(path: str, workspaces: Sequence[str], deadline_s: float = DEADLINE_S) -> Outcome | None:
    """Return the findings of a launch file's dry run as `findings`, and the steps of each launch argument as `values`.

    If the dry run did not end, return None. The file runs in another process. Where the system allows it, the process can
    write only in a temporary folder, and opens no socket.
    """
    with TemporaryDirectory(prefix='edulaunch-editor-') as home:
        job = json.dumps({'path': path, 'workspaces': list(workspaces), 'home': home})
        command = [sys.executable, '-m', 'edulaunch.extras.editor.saving']
        child = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            encoding='utf-8',
            start_new_session=True,
            cwd=home,  # not the folder of the file, from which Python would import modules
        )
        try:
            answer, _ = child.communicate(job, timeout=deadline_s)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            child.communicate()
            return None
    try:
        outcome: Outcome = json.loads(answer)
    except ValueError:
        return None
    return outcome


def confined(home: str, readable: Sequence[str]) -> dict[str, str]:
    """Confine this process permanently, as far as the system can. Return for each layer 'held', or the reason why it is not
    active.
    """
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.environ['TMPDIR'] = home
    try:
        from edugrade.sandbox.confine import Confinement
    except ImportError:
        return {'all': 'the grader is not installed'}
    return Confinement([*readable, *sys.path, sys.base_prefix, '/usr', '/lib', '/lib64', '/etc'], ['/']).put_on([], home)


def outcome_of(path: str, workspaces: Sequence[str]) -> Outcome:
    """Return the findings of a dry run of a launch file, and the steps of its launch arguments."""
    from edulaunch.advice.judging import judge_plan
    from edulaunch.advice.plan import rehearse
    from edulaunch.advice.plan.why import argument_chain
    from edulaunch.runtime.session import Session

    with Session(workspaces=workspaces) as session:
        host = session.host
        rehearsal = rehearse(path, {}, session.index, host.env, command_set=host.command_set)
        findings = [list(finding) for finding in judge_plan(rehearsal)]
        values = {}
        if rehearsal.plan['error'] is None:
            values = {one['name']: argument_chain(rehearsal.outline, one['name']) for one in rehearsal.plan['arguments']}
    return {'findings': findings, 'values': values, 'not_done': rehearsal.plan.get('not_done', [])}


def main() -> None:
    """Run the child process: read the job, confine the process, run the file, and write the outcome."""
    job = json.load(sys.stdin)
    out = os.fdopen(os.dup(1), 'w', encoding='utf-8')
    os.dup2(2, 1)  # discard the output of the launch file
    folders = [os.path.dirname(job['path']), *job['workspaces']]

    from edulaunch.ros.sourcing import source

    source()
    os.chdir(os.path.dirname(job['path']))
    tempfile.tempdir = job['home']
    layers = confined(job['home'], folders)
    json.dump({**outcome_of(job['path'], job['workspaces']), 'confined': layers}, out, default=str)
    out.flush()
    os._exit(0)


if __name__ == '__main__':
    main()
