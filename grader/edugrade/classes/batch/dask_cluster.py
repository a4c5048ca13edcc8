"""Grades a class on several machines with Dask. Each worker receives the files of a submission, grades it, and returns the result
as data.

If a worker dies, another worker grades its submissions. All workers need the same version of edulaunch. Each worker keeps a
grader, so that it loads the engine once and not for each submission.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from edulaunch.errors import MissingExtra, UnusableInput
from edulaunch.runtime.version import __version__

from ...faults import REPORT_IT
from ...files import read_regular
from ...grading import COPIED, Work, is_copied, progress_bar
from ...results import BROKEN_GRADER
from .entries import Entry
from .store import Store
from .warm import ask_warm
from .work import Options, keep, keep_document, keep_page, refusal

TRIES = 3  # attempts at a submission whose workers end; after that, it gets no mark
PATIENCE_S = 600.0  # time for one submission, in addition to its own limits
LARGEST_FILE = 2_000_000

Parcel = dict[str, Any]


def grade_there(address: str, todo: Sequence[tuple[Entry, Work]], store: Store, options: Options) -> None:
    """Grade on the cluster with this scheduler, and store each result when it arrives.

    :raises UnusableInput: when Dask is not installed, or no scheduler responds at the address.
    """
    try:
        from distributed import Client, as_completed
    except ImportError:
        raise MissingExtra('--dask', 'Dask', 'dask') from None
    try:
        client = Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError) as error:
        raise UnusableInput(f'no Dask scheduler answers at {address}: {error}', help='start one: dask scheduler') from None
    for entry, work in todo:
        if is_copied(work):
            keep(store, entry, refusal(BROKEN_GRADER, COPIED, 'look at it'))
    with client:
        entries = {
            client.submit(
                grade_parcel, parcel(work, options), pure=False, retries=TRIES, key=f'edugrade-{number}-{os.urandom(4).hex()}'
            ): entry
            for number, (entry, work) in enumerate(todo)
            if not is_copied(work)
        }

        with progress_bar(len(entries)) as advance:
            for future in as_completed(entries, loop=client.loop):
                entry = entries.pop(future)
                try:
                    _keep(store, entry, future.result(), options)
                except Exception as error:  # whatever ended the worker, the submission gets no mark
                    words = f'the grader broke: {type(error).__name__}: {error}'
                    keep(store, entry, refusal(BROKEN_GRADER, words, REPORT_IT))
                advance()


def parcel(work: Work, options: Options) -> Parcel:
    """Return everything that is needed to grade a submission, as plain data."""
    submission = work.submission
    name = submission.package.name if submission.package else submission.name
    return {
        'version': __version__,
        'name': name,
        'files': _files(submission.folder) if submission.package else {submission.name: submission.data},
        'launch': os.path.relpath(submission.file, submission.folder),
        'rubric': (f'{work.name}{os.path.splitext(work.rubric.file)[1]}', work.rubric.text),
        'seed': work.seed,
        'secret': work.secret,
        'only': options.only,
        'workspaces': [_files(folder) for folder in _workspaces(work, options)],
        'variant': None if work.variant is None else {**work.variant._asdict(), 'values': dict(work.variant.values)},
        'limit': options.limits.wall_s,
        'sandbox': options.limits.sandbox,
        'page': options.html is not None,
        'replays': options.replays,
    }


def _workspaces(work: Work, options: Options) -> list[str]:
    """Return the workspace folders that contain packages other than the graded one."""
    own = work.submission.package
    return [
        os.path.abspath(each) for each in (*options.workspaces, *work.submission.workspaces) if own is None or each != own.path
    ]


def _files(folder: str) -> dict[str, bytes]:
    """Return the regular files of a package by path. Links are left out, as in the grader."""
    found = {}
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if not name.startswith('.') and name not in ('build', 'install', 'log', '__pycache__')
        )
        for name in sorted(names):
            path = os.path.join(place, name)
            with suppress(OSError):
                if not os.path.islink(path):
                    found[os.path.relpath(path, folder)] = read_regular(path, LARGEST_FILE)
    return found


def grade_parcel(given: Parcel) -> dict[str, Any]:
    """Unpack a submission on the worker, and grade it with the grader of this worker."""
    if given['version'] != __version__:
        raise UnusableInput(f'this worker has edulaunch {__version__}, and not {given["version"]}')
    with tempfile.TemporaryDirectory(prefix='edugrade-parcel-', ignore_cleanup_errors=True) as temporary:
        home = Path(temporary)
        _put(home / 'submission' / given['name'], given['files'])
        for number, files in enumerate(given['workspaces']):
            _put(home / 'workspaces' / str(number), files)
        rubric = home / 'rubrics' / given['rubric'][0]
        rubric.parent.mkdir()
        rubric.write_bytes(given['rubric'][1])
        request = {key: given[key] for key in ('seed', 'limit', 'sandbox', 'only', 'page', 'replays')}
        request['file'] = str(home / 'submission' / given['name'] / given['launch'])
        request['rubric'] = str(rubric)
        request['workspaces'] = [str(home / 'workspaces' / str(number)) for number in range(len(given['workspaces']))]
        found = ask_warm(request, PATIENCE_S + 10 * given['limit'])
    found['report']['receipt']['secret'] = given['secret']
    if given['variant'] is not None:
        found['report']['variant'] = given['variant']
    return found


def _put(folder: Path, files: dict[str, bytes]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def _keep(store: Store, entry: Entry, came: dict[str, Any], options: Options) -> None:
    if options.html and came['page'] is not None and not options.only:
        keep_page(store.path(entry, '.html', options.html), came['page'])
    store.record_duration(entry, came['run_s'])
    keep_document(store, entry, came['report'], options)
