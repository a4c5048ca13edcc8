"""The results of a class: one file for each submission. A file is written completely or not at all."""

from __future__ import annotations

import fcntl
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from typing import Any

from edulaunch.errors import UnusableInput

from ...files import read_regular, write_whole
from ...reports.document import json_text
from ...results import ALL_PASSED, BROKEN_GRADER, GRADER_BROKE, PASSED, SOME_FAILED, UNUSABLE_INPUT, VERDICTS, rounded
from ...sandbox.remove_tree import remove_tree
from .entries import Entry

LARGEST_RESULT = 10_000_000
LONGEST_PART = 240  # bytes of a file name, including our ending
UNPACKED, LOCK, TIMES = '.unpacked', '.lock', '.times'
OURS = ('teacher.csv', 'index.html', 'students')
"""Names in a folder of results or pages that never belong to a student, even if a student's folder has such a name."""

Result = dict[str, Any]


class Store:
    """A folder of results. The file of each submission is ``<path of the submission>.json``.

    :ivar unkept: paths of submissions whose new results could not be written. An older stored result does not belong to them.
    """

    def __init__(self, folder: str) -> None:
        self.folder = folder
        self.unkept: set[str] = set()  # submissions whose new results could not be written
        self._times: dict[str, float] = {}

    @property
    def unpacked(self) -> str:
        """The folder for unpacked archives and cloned repositories. It remains after grading, so that teachers can inspect
        the files.
        """
        return os.path.join(self.folder, UNPACKED)

    @contextmanager
    def locked(self) -> Iterator[None]:
        """Lock these results against other batches, and remove incomplete files of a killed batch.

        :raises UnusableInput: when another batch uses the results, or they cannot be written.
        """
        is_new = not os.path.lexists(self.folder)
        try:
            os.makedirs(self.folder, exist_ok=True)
            lock = os.open(os.path.join(self.folder, LOCK), os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        except OSError as error:
            raise UnusableInput(
                f'results cannot be written to {self.folder}: {error.strerror}',
                help='add --out FOLDER with a folder that you may write to',
            ) from None
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            for place, folders, names in os.walk(self.folder):
                folders[:] = [name for name in folders if name != UNPACKED]
                for name in names:
                    if name.endswith('.part'):
                        os.unlink(os.path.join(place, name))
            yield
        except UnusableInput:
            if is_new and set(os.listdir(self.folder)) <= {LOCK, UNPACKED}:  # nothing was graded, so remove the folder
                remove_tree(self.folder)
            raise
        except BlockingIOError:
            raise UnusableInput(f'another batch writes its results to {self.folder}', help='wait for it, or give --out') from None
        finally:
            os.close(lock)

    def path(self, entry: Entry, ending: str = '.json', folder: str | None = None) -> str:
        """Return the path of a stored file for a submission. The file name is a hash if the submission's path is too long, or
        if the path has another meaning in this folder.
        """
        name = entry.path
        is_ours = name.split(os.sep)[0].lower() in OURS
        if is_ours or any(len(os.fsencode(part)) > LONGEST_PART for part in name.split(os.sep)) or len(os.fsencode(name)) > 900:
            name = sha256(os.fsencode(name)).hexdigest()
        return os.path.join(folder or self.folder, name + ending)

    def result(self, entry: Entry) -> Result | None:
        """Return the stored result, or None when there is no complete result."""
        return None if entry.path in self.unkept else _read(self.path(entry))

    def save(self, entry: Entry, content: Result) -> None:
        """Write one result.

        :raises UnusableInput: when the result cannot be written.
        """
        path = self.path(entry)
        with suppress(OSError):  # the error is reported when the file is written
            os.makedirs(os.path.dirname(path), exist_ok=True)
        about = {'student': entry.student, 'student_id': entry.id or None, 'path': entry.path, 'origin': entry.origin or None}
        write_whole(path, json_text({**about, **content}))

    def record_duration(self, entry: Entry, seconds: float) -> None:
        """Record the duration of a submission's runs. Results do not contain this time, so equal runs have equal results."""
        self._times[entry.path] = round(seconds, 2)

    def times(self) -> dict[str, float]:
        """Store the durations of this batch. Return the duration of each submission's runs in this batch or an earlier batch,
        by path.
        """
        path = os.path.join(self.folder, TIMES)
        known: dict[str, float] = {}
        with suppress(OSError, ValueError, RecursionError):
            found = json.loads(read_regular(path, LARGEST_RESULT))
            known = {str(key): float(value) for key, value in found.items() if isinstance(value, (int, float))}
        with suppress(UnusableInput):
            write_whole(path, json.dumps({**known, **self._times}, indent=1))
        return {**known, **self._times}

    def all(self) -> list[Result]:
        """Return all stored results of a batch in the order of their paths, for exports.

        :raises UnusableInput: when there is no result.
        """
        found = []
        for place, folders, names in os.walk(self.folder):
            folders[:] = sorted(name for name in folders if name != UNPACKED)
            found += [result for name in names if name.endswith('.json') and (result := _read(os.path.join(place, name)))]
        if not found:
            raise UnusableInput(
                f'there are no results in {self.folder}', help='name the folder that `edugrade batch` has written'
            )
        return sorted(found, key=lambda result: str(result['path']))


def _read(path: str) -> Result | None:
    with suppress(OSError, ValueError, RecursionError):
        found = json.loads(read_regular(path, LARGEST_RESULT))
        if isinstance(found, dict) and isinstance(found.get('student'), str) and 'path' in found:
            return found
    return None


def merged(earlier: dict[str, Any], again: dict[str, Any], name: str) -> dict[str, Any]:
    """Return the earlier result with one check replaced, and everything that depends on it, such as the points.

    :param again: the report of the check and of the checks that it needs.
    """
    new = {check['name']: check for check in again['checks']}
    checks = [new[name] if check['name'] == name else check for check in earlier['checks']]
    if name not in {check['name'] for check in checks}:
        checks.append(new[name])
    statuses = {check['status'] for check in checks}
    exit_code = BROKEN_GRADER if GRADER_BROKE in statuses else ALL_PASSED if statuses == {PASSED} else SOME_FAILED
    if again['exit_code'] == UNUSABLE_INPUT:
        exit_code = UNUSABLE_INPUT
    earned = None if exit_code == BROKEN_GRADER else rounded(sum(check['earned'] for check in checks))
    return {
        **earlier,
        **{key: again[key] for key in ('receipt', 'seed', 'rubric', 'submission', 'scenarios', 'sandbox', 'gaps', 'graph')},
        'verdict': VERDICTS[exit_code],
        'exit_code': exit_code,
        'points': {'earned': earned, 'possible': sum(check['points'] for check in checks)},
        'checks': checks,
        'regraded': sorted({*earlier.get('regraded', ()), name}),
    }
