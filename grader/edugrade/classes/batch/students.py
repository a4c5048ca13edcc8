"""Finds the student of a submission: in a path from a learning platform, with a pattern, or in a table of repositories."""

from __future__ import annotations

import csv
import io
import os
import re
import subprocess
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from ...files import read_given, read_regular

ARCHIVES = ('.zip', '.tar', '.tar.gz', '.tgz', '.tar.bz2', '.tbz2')
LARGEST_METADATA = 20_000_000
_MOODLE = re.compile(r'(?P<student>[^/]+?)_(?P<id>\d+)_assignsubmission_[a-z]+(?:_|/|$)')
_CANVAS = re.compile(r'(?P<student>[^/_]+)_(?:LATE_)?(?P<id>\d+)_\d+_[^/]+')
_CANVAS_BEFORE = re.compile(r'[^/_]+_(?:LATE_)?\d+_\d+_')
_AGAIN = re.compile(r'-\d+(?=\.(?:py|xml|ya?ml)$)')  # Canvas numbers repeated submissions: circle.launch-1.py
# Browsers number downloads of one name: circle.launch (1).py. Students also copy a file as circle (1).launch.py.
_DOWNLOADED = re.compile(r' ?\(\d+\)(?=(?:[._]launch)?\.(?:py|xml|ya?ml)$)')
_GRADESCOPE = re.compile(r'(?:[^/]*/)?(?P<key>submission_\d+)(?:/|$)')


class Student(NamedTuple):
    """The name of a student, and the number or name on a learning platform, which is '' if the path does not contain it."""

    name: str
    id: str = ''


def namer(folder: str, pattern: str | None = None) -> Callable[[str], Student]:
    """Return a function that finds the student in a path, which is relative to the folder of all submissions and uses ``/``.

    The function tries the pattern first. Then it tries the paths of Moodle (``Ada Lovelace_123_assignsubmission_file_/``),
    of Gradescope (``submission_123/`` with the names of ``submission_metadata.yml``) and of Canvas
    (``lovelaceada_123_456_circle.launch.py``). If no path matches, it uses the first part of the path.

    :param pattern: a regular expression with a group ``student`` and optionally a group ``id``, searched anywhere in the path.
    :raises UnusableInput: when the pattern is not a valid regular expression, or has no such group.
    """
    own = _compiled(pattern) if pattern else None
    people = _gradescope_people(folder)

    def student_of(path: str) -> Student:
        for known in (own, _MOODLE, _CANVAS):
            match = known and (known.search(path) if known is own else known.match(path))
            if match and match['student']:
                return Student(match['student'].strip(), (match.groupdict().get('id') or ''))
        match = _GRADESCOPE.match(path)
        if match and match['key'] in people:
            return people[match['key']]
        return Student(_stem(path.split('/')[0]))

    return student_of


def plain_name(name: str) -> str:
    """Return the name that the student gave a launch file: without the parts that Moodle, Canvas and browsers add."""
    for before in (_MOODLE, _CANVAS_BEFORE):
        match = before.match(name)
        if match and match.end() < len(name):
            name = _AGAIN.sub('', name[match.end() :]) if before is _CANVAS_BEFORE else name[match.end() :]
            break
    return _DOWNLOADED.sub('', name)


def _stem(name: str) -> str:
    from ...submission import ENDINGS

    ending = next(
        (ending for ending in sorted((*ENDINGS, *ARCHIVES), key=len, reverse=True) if name.lower().endswith(ending)), ''
    )
    return name[: -len(ending)] if ending and len(ending) < len(name) else name


def _compiled(pattern: str) -> re.Pattern[str]:
    try:
        compiled = re.compile(pattern)
    except re.error as error:
        raise UnusableInput(f'the name pattern {pattern} is not a valid regular expression: {error}') from None
    if 'student' not in compiled.groupindex:
        raise UnusableInput(
            f'the name pattern {pattern} has no group "student"',
            help="give, for example, --name-pattern '^hw1-(?P<student>[^/]+)'",
        )
    return compiled


def _gradescope_people(folder: str) -> Mapping[str, Student]:
    """Return the submitters by the folder of their submission, from the file that Gradescope exports with the submissions."""
    for place in ('', *_folders(folder)):
        try:
            text = read_regular(os.path.join(folder, place, 'submission_metadata.yml'), LARGEST_METADATA)
        except OSError:
            continue
        import yaml

        try:
            found = yaml.load(text, getattr(yaml, 'CSafeLoader', yaml.SafeLoader))
        except (yaml.YAMLError, ValueError, RecursionError):
            return {}
        return dict(filter(None, (_person(key, value) for key, value in found.items()))) if isinstance(found, dict) else {}
    return {}


def _folders(folder: str) -> list[str]:
    try:
        return sorted(entry.name for entry in os.scandir(folder) if entry.is_dir(follow_symlinks=False))[:3]
    except OSError:
        return []


def _person(key: Any, value: Any) -> tuple[str, Student] | None:
    """Return all students who submitted one submission. Gradescope writes the keys as Ruby symbols."""
    submitters = value.get(':submitters') if isinstance(value, dict) else None
    if not isinstance(submitters, list) or not all(isinstance(each, dict) for each in submitters):
        return None
    names = [str(each.get(':name') or each.get(':email') or '') for each in submitters]
    ids = [str(each.get(':sid') or each.get(':email') or '') for each in submitters]
    return (str(key), Student(' and '.join(names), ids[0])) if names and all(names) else None


LONGEST_CLONE_S = 120
LARGEST_TABLE = 10_000_000
PROTOCOLS = 'https:http:ssh:git:file'
_URL = re.compile(r'(?:https?|ssh|git|file)://|[\w.-]+@[\w.-]+:')


def clone_all(table: str, folder: str) -> Iterator[tuple[Student, str, str, str]]:
    """Clone or find the submission of each line of a table.

    Yield the student, the folder, the origin of the submission, and the reason why it is refused, or ''. The table is CSV with a
    header. It has a column ``student``, and a column ``url`` (of a git repository) or ``path`` (a directory, relative to the
    table). The columns ``id`` and ``ref`` (a branch or tag) are optional.

    :param folder: the folder for cloned repositories.
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
    text = read_given(table, LARGEST_TABLE, 'the table ').decode('utf-8-sig', 'replace')
    reader = csv.DictReader(io.StringIO(text))
    head = [(name or '').strip().lower() for name in reader.fieldnames or ()]
    if 'student' not in head or not {'url', 'path'} & set(head):
        raise UnusableInput(
            f'the table {table} has the columns {", ".join(head) or "none"}', help='write the header student,url or student,path'
        )
    reader.fieldnames = head
    return [{key: (value or '').strip() for key, value in row.items() if isinstance(value, str)} for row in reader]


def _clone(url: str, ref: str, target: str) -> str:
    """Clone one repository without hooks, links, submodules or questions. Return the reason of a failure, or ''."""
    if not (_URL.match(url) or os.path.isdir(url)) or ref.startswith('-'):
        return f'{url!r} is not an address of a git repository'
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
