"""A grader process that continues to run. It grades one submission after another, and its starter has loaded the engine.

A Dask worker has threads, so it cannot fork safely. It keeps such graders as child processes, one for each of its
threads, and sends each request as a line of JSON. As in a batch, each run is a fork of the starter and sees no other
submission.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from contextlib import suppress
from typing import Any

from edulaunch.errors import UnusableInput

from ...grading import WarmGrader, plan_work
from ...job import Limits
from ...readiness import is_readable
from ...reports.document import document
from ...submission import Submission

Request = dict[str, Any]
Answer = dict[str, Any]
COMMAND = 'from edugrade.classes.batch.warm import main; main()'


class Lost(Exception):
    """The grader process has ended, or did not reply in time."""


class WarmProcess:
    """A grader in a process of its own.

    :ivar is_there: whether the process accepts more requests.
    """

    def __init__(self) -> None:
        self.is_there = True
        command = [sys.executable, '-c', COMMAND]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, cwd=os.sep
        )

    def ask(self, request: Request, patience_s: float) -> Answer:
        """Send a request, and return the reply.

        :raises Lost: when the process ends first, or does not reply within `patience_s`. Then the process no longer exists.
        :raises UnusableInput: when the submission cannot be graded.
        :raises RuntimeError: when the grader fails, with the error of the grader.
        """
        process = self._process
        assert process.stdin is not None and process.stdout is not None
        try:
            process.stdin.write(json.dumps(request).encode() + b'\n')
            process.stdin.flush()
            line = process.stdout.readline() if is_readable(process.stdout.fileno(), patience_s) else b''
        except OSError:
            line = b''
        if not line.endswith(b'\n'):
            self.close()
            raise Lost(f'the grader of this worker ended, or did not answer in {patience_s:g} s')
        answer: Answer = json.loads(line)
        if 'unusable' in answer:
            message, help = answer['unusable']
            raise UnusableInput(message, help=help)
        if 'fault' in answer:
            raise RuntimeError(answer['fault'])
        return answer

    def close(self) -> None:
        """End the process."""
        self.is_there = False
        self._process.kill()
        self._process.wait()
        for end in (self._process.stdin, self._process.stdout):
            assert end is not None
            with suppress(OSError):  # some results may not have been written
                end.close()


_idle: list[WarmProcess] = []
_lock = threading.Lock()


def ask_warm(request: Request, patience_s: float) -> Answer:
    """Grade with an idle grader of this process, or with a new grader; see `WarmProcess.ask`."""
    with _lock:
        process = _idle.pop() if _idle else WarmProcess()
    try:
        return process.ask(request, patience_s)
    finally:
        if process.is_there:
            with _lock:
                _idle.append(process)


def main() -> None:
    """Reply to each line of the standard input until the input ends."""
    answers = os.fdopen(os.dup(1), 'wb')
    os.dup2(2, 1)  # printed output is not part of the reply
    grader: WarmGrader | None = None
    limits = None
    for line in sys.stdin.buffer:
        request = json.loads(line)
        wanted = Limits(request['limit'], sandbox=request['sandbox'])
        if grader is None or limits != wanted:
            if grader is not None:
                grader.close()
            grader, limits = WarmGrader(wanted), wanted
        answers.write(json.dumps(_answer(grader, request)).encode() + b'\n')
        answers.flush()
    if grader is not None:
        grader.close()


def _answer(grader: WarmGrader, request: Request) -> Answer:
    try:
        work = plan_work(Submission(request['file']), request['rubric'], request['seed'], only=request['only'])
        report = grader.report(work, request['workspaces'])
        page = None
        if request['page']:
            from ...reports.page import page as page_of

            page = page_of([report], [], is_small=not request['replays'])
        return {'report': document(report), 'page': page, 'run_s': sum(outcome.real_s for outcome in report.outcomes)}
    except UnusableInput as error:
        return {'unusable': [error.message, error.help]}
    except Exception as error:
        return {'fault': f'{type(error).__name__}: {error}'}
