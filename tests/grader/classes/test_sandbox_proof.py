"""The confinement of a run holds, as root and as somebody else; and the examination sees when it does not."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys

import pytest
from edugrade.classes.sandbox_proof import Finding, examine, report
from edugrade.cli import main
from edugrade.job import Limits
from edugrade.sandbox import landlock, seccomp

pytestmark = pytest.mark.processes

CONFINES = pytest.mark.skipif(
    landlock.version() < 6 or seccomp.filter_program() is None, reason='this system lacks Landlock 6, or is of an unknown kind'
)


@CONFINES
def test_every_attempt_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['doctor']) == 0
    shown = capsys.readouterr().out
    assert 'NOT HELD' not in shown
    assert shown.count('held ') == 29
    assert shown.endswith('Every attempt was refused.\n')


@CONFINES
@pytest.mark.skipif(os.getuid() != 0 or shutil.which('setpriv') is None, reason='only root can become somebody else')
def test_somebody_who_is_not_root_is_confined_alike() -> None:
    """Nobody may read files of others here, so that Python is found in a home of root, too."""
    become = ['setpriv', '--reuid=65534', '--regid=65534', '--clear-groups']
    may_read = ['--inh-caps=+dac_read_search', '--ambient-caps=+dac_read_search', '--bounding-set=-all,+dac_read_search']
    command = [*become, *may_read, sys.executable, '-m', 'edugrade', 'doctor']
    environment = {**os.environ, 'TMPDIR': '/tmp', 'HOME': '/', 'PYTHONPATH': os.pathsep.join(filter(None, sys.path))}
    found = subprocess.run(command, env=environment, cwd='/', capture_output=True, text=True)
    missing = {line.split()[2] for line in found.stdout.splitlines() if line.startswith('NOT HELD')}
    assert missing == {'view'}, found.stdout + found.stderr  # such a user reads by a right that is lost in a namespace


def test_without_confinement_the_attempts_succeed() -> None:
    findings = {item.attempt: item for item in examine(Limits(sandbox='off'))}
    could = {attempt for attempt, item in findings.items() if not item.held}
    assert {
        'read a file beside the submission',
        'read a rubric',
        'change the mode of a file beside the submission',
        'see the size of a file beside the submission',
        'send to a socket in the file system',
        'write beside the submission',
        'connect to a server on this machine',
        'connect to a socket in the file system',
        'signal the grader',
        "read the grader's environment",
    } <= could
    assert findings['outlive the run'].held
    assert findings['leave its folder behind'].held
    assert findings['find a token in its environment'].held
    assert findings["use the grader's open files"].held


def test_a_layer_that_does_not_hold_is_named() -> None:
    shown = report([Finding('files', 'read', False, 'it could'), Finding('network', 'connect', True, 'OSError')])
    assert shown.splitlines()[0] == 'NOT HELD files       read (it could)'
    assert shown.endswith('A submission on this machine is NOT confined: files.\n')
