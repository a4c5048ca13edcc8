"""A class as a table: one line for each student, with the repository or the folder of the work."""

from __future__ import annotations

import csv
import io
import os
import re
import subprocess
from collections.abc import Iterator, Mapping

from edulaunch.errors import UnusableInput

from ..regular_file import read_regular
from .names import Student

LONGEST_CLONE_S = 120
LARGEST_TABLE = 10_000_000
PROTOCOLS = 'https:http:ssh:git:file'
_URL = re.compile(r'(?:https?|ssh|git|file)://|[\w.-]+@[\w.-]+:')


def clone_all(table: str, folder: str) -> Iterator[tuple[Student, str, str, str]]:
    """For each line of a table (student, its folder, where it is from, why it is refused or '').

    The table is CSV with a head: ``student``; ``url`` (of a git repository) or ``path`` (a folder, relative to the table);
    perhaps ``id``, and ``ref`` (a branch or tag).

    :param folder: where repositories are cloned to.
    :raises UnusableInput: when the table lacks a column or cannot be read.
    """
    for number, row in enumerate(_rows(table), 1):
        name = row.get('student') or f'line {number + 1}'
        student = Student(name, row.get('id', ''))
        if row.get('path'):
            path = os.path.join(os.path.dirname(table), row['path'])
            yield student, path, '', '' if os.path.isdir(path) else f'there is no folder {row["path"]}'
            continue
        target = os.path.join(folder, re.sub(r'[^\w.-]', '_', name).lstrip('.') or '_')
        target = f'{target}-{number}' if os.path.lexists(target) else target
        url = row.get('url', '')
        if url and not _URL.match(url):
            url = os.path.abspath(os.path.join(os.path.dirname(table), url))  # a repository on this machine
        refused = _clone(url, row.get('ref', ''), target)
        yield student, target, url + ('' if refused else f' {_commit(target)}'), refused


def _rows(table: str) -> list[Mapping[str, str]]:
    try:
        text = read_regular(table, LARGEST_TABLE).decode('utf-8-sig', 'replace')
    except OSError as error:
        raise UnusableInput(f'the table {table} cannot be read: {error.strerror or error}') from None
    reader = csv.DictReader(io.StringIO(text))
    head = [(name or '').strip().lower() for name in reader.fieldnames or ()]
    if 'student' not in head or not {'url', 'path'} & set(head):
        raise UnusableInput(
            f'the table {table} has the columns {", ".join(head) or "none"}', help='its head is: student,url or student,path'
        )
    reader.fieldnames = head
    return [{key: (value or '').strip() for key, value in row.items() if isinstance(value, str)} for row in reader]


def _clone(url: str, ref: str, target: str) -> str:
    """Clone one repository: no hooks, links, submodules or questions. Gives why it could not be cloned, or ''."""
    if not (_URL.match(url) or os.path.isdir(url)) or ref.startswith('-'):
        return f'{url!r} is no address of a git repository'
    os.makedirs(os.path.dirname(target), exist_ok=True)
    safe = ['-c', 'core.symlinks=false', '-c', f'core.hooksPath={os.devnull}', '-c', 'core.fsmonitor=false']
    words = ['git', *safe, 'clone', '--quiet', '--depth=1', '--no-tags', *(['--branch', ref] if ref else []), '--', url, target]
    environment = {**os.environ, 'GIT_TERMINAL_PROMPT': '0', 'GIT_ALLOW_PROTOCOL': PROTOCOLS, 'GIT_LFS_SKIP_SMUDGE': '1'}
    try:
        done = subprocess.run(words, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=LONGEST_CLONE_S)
    except (OSError, subprocess.TimeoutExpired) as error:
        return f'the repository could not be cloned: {error}'
    lines = done.stderr.decode('utf-8', 'replace').strip().splitlines()
    return '' if done.returncode == 0 else f'the repository could not be cloned: {lines[-1] if lines else "git says nothing"}'


def _commit(folder: str) -> str:
    done = subprocess.run(['git', '-C', folder, 'rev-parse', 'HEAD'], stdin=subprocess.DEVNULL, capture_output=True)
    return done.stdout.decode('ascii', 'replace').strip()
