"""`edulaunch doctor --fix`: show the edits of the findings as a diff, and apply them if the user agrees.

The command changes only files that the user names. It writes each file completely or not at all.
"""

from __future__ import annotations

import difflib
import os
import stat
import sys
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from edulaunch.advice.rule import Finding
from edulaunch.advice.texts import Around, Text, check, kind_of
from edulaunch.advice.texts.edits import FILES, applied, edits_of, written
from edulaunch.engine.packages.discovery import package_around
from edulaunch.engine.recording.safe_file import write_safely

PASSES = 10
"""A fixed mistake may have hidden another one; after this many rounds, the doctor stops."""
PASSED_OVER = frozenset(('build', 'install', 'log', 'node_modules', '__pycache__'))


class Change(NamedTuple):
    """The path of a file, with its current and its new content as bytes."""

    path: str
    before: bytes
    after: bytes

    def difference(self) -> Iterator[str]:
        """Yield the lines of the change as a unified diff."""
        name = os.path.relpath(self.path)
        old, new = (content.decode().splitlines(keepends=True) for content in (self.before, self.after))
        for line in difflib.unified_diff(old, new, name, name):
            yield line.rstrip('\r\n')


def changes_for(target: str, findings: Sequence[Finding]) -> list[Change]:
    """Return the changes that fix the findings, one for each file that changes, in the order of their paths.

    :param target: the file or folder to change.
    :param findings: the findings of the doctor. In addition, the files are checked as in an editor.
    """
    changes = []
    for path in named_files(target):
        try:
            with open(path, 'rb') as file:
                before = file.read()
            text = before.decode()
        except (OSError, UnicodeDecodeError):
            continue
        after = cured(path, text, findings).encode()
        if after != before:
            changes.append(Change(path, before, after))
    return changes


def named_files(target: str) -> list[str]:
    """Return the paths that the doctor may change: the file itself, or the files below a folder. Skip symbolic links."""
    root = os.path.realpath(target)
    if os.path.isfile(root):
        return [root]
    found = []
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in PASSED_OVER and not name.startswith('.'))
        found += [path for name in sorted(names) if not os.path.islink(path := os.path.join(folder, name))]
    return found


def cured(path: str, text: str, findings: Sequence[Finding]) -> str:
    """Return the new content of a file, after all edits that certainly fix a finding."""
    for finding in findings:
        form = written(finding) if finding.rule else None
        if form is not None and _file_of(finding, form[2]) == path:
            text = applied(text, edits_of(finding, Text(text, path)))
    if kind_of(path, text) is None:
        return text
    around = Around(path)
    for _ in range(PASSES):
        edits = tuple(edit for mark in check(text, path, around) for edit in mark.edits if edit.file == path)
        after = applied(text, edits)
        if after == text:
            break
        text = after
    return text


def _file_of(finding: Finding, place: str) -> str | None:
    """Return the path of the file that the edit of a finding changes, or None if the finding has no file."""
    if finding.file is None:
        return None
    path = os.path.realpath(finding.file)
    if place not in FILES:
        return path
    package = package_around(path)
    return None if package is None else os.path.join(package, FILES[place])


def fix(changes: Sequence[Change], agreed: bool) -> int:
    """Show the changes, ask the user, and write the files. Return 0 if all files were written, otherwise 1.

    :param agreed: whether the user has already agreed with `--yes`.
    """
    for change in changes:
        print('\n'.join(change.difference()))
    if not changes:
        print('no finding has a certain edit, so nothing was changed')
        return 1
    if not agreed and not _asked(len(changes)):
        print('nothing was changed')
        return 1
    for number, change in enumerate(changes):
        problem = _made(change)
        if problem:
            rest = len(changes) - number - 1
            print(f'error: {os.path.relpath(change.path)} could not be changed: {problem}', file=sys.stderr)
            print(f'  help: {number} files are changed, {rest} are not; repeat the command', file=sys.stderr)
            return 1
        print(f'changed {os.path.relpath(change.path)}')
    return 0


def _asked(count: int) -> bool:
    if not sys.stdin.isatty():
        print('add --yes to make these changes')
        return False
    files = 'this file' if count == 1 else f'these {count} files'
    return input(f'change {files}? [y/N] ').strip().lower() in ('y', 'yes')


def _made(change: Change) -> str:
    """Write one file. Return the reason if that failed, otherwise an empty string."""
    try:
        with open(change.path, 'rb') as file:
            if file.read() != change.before:
                return 'another program has changed it in the meantime'
        mode = stat.S_IMODE(os.stat(change.path).st_mode)
        write_safely(change.path, [change.after])
        os.chmod(change.path, mode)
    except OSError as error:
        return error.strerror or str(error)
    return ''
