"""Finds the submissions in a folder, in archives, and in a table of repositories."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from typing import NamedTuple

from edulaunch.errors import UnusableInput

from ...faults import raise_fault
from ...files import read_regular
from ...sandbox.remove_tree import remove_tree
from ...submission import ENDINGS, LARGEST_BYTES, exercise_of, package_at
from ...worker import TooLong, cpu_limit
from .students import ARCHIVES, Student, clone_all, namer, plain_name
from .unpack import OF_A_CLASS, OF_A_STUDENT, unpack

DEEPEST = 8  # levels of folders below the given one
MOST_NESTED = 2  # levels of archives inside archives
MOST_OF_ONE = 50  # number of submissions of one student
LONGEST_UNPACKING_S = 20.0
STRANGE_ARCHIVES = ('.7z', '.rar', '.xz', '.zst')
BY_THE_WAY = ('__MACOSX', '__pycache__', 'build', 'install', 'log')
LINK = 'it is a link, and links are not followed'
NOTHING = 'it contains no launch file or package of an exercise'
NAMED = 'name the launch file after its exercise'
MOST_NAMES = 5  # names of files that a message lists


class Entry(NamedTuple):
    """A submission of a class.

    :ivar path: the path of the submission, relative to the directory of all submissions. An archive counts as a directory.
    :ivar student: the student who submitted it. The attribute `id` is the student's number or name on a learning platform.
    :ivar file: the path of the file to grade, unpacked if necessary. It is '' for a rejected submission, whose problem `refused`
        and `help` explain.
    :ivar origin: repository and commit of a cloned submission.
    :ivar root: the folder with everything that the student submitted, unpacked if necessary.
    """

    path: str
    student: str
    id: str = ''
    file: str = ''
    refused: str = ''
    help: str | None = None
    origin: str = ''
    root: str = ''


def refuse_nothing(given: str) -> None:
    """Check that a path is a directory, an archive or a table, before a directory for the results is created.

    :raises UnusableInput: when the path is something else. The message contains the path.
    """
    if not os.path.isdir(given) and not (given.lower().endswith(('.csv', *ARCHIVES)) and os.path.isfile(given)):
        is_there = os.path.lexists(given)
        raise UnusableInput(
            f'{given} is not a folder, an archive or a table' if is_there else f'{given} does not exist',
            help='name a folder that contains one folder, archive or launch file per student, or a zip file of such a folder',
        )


class Finder:
    """Finds the submissions of a class.

    :param given: a folder with a folder, an archive or a launch file for each student, an archive of such a folder, or a table
        (.csv).
    :param unpacked: a new directory for archives and repositories.
    :param is_wanted: a function that returns whether the name of a launch file or package belongs to an exercise to grade.
    :param pattern: the pattern that finds the student in a path; see `namer`.
    """

    def __init__(self, given: str, unpacked: str, is_wanted: Callable[[str], bool], pattern: str | None = None) -> None:
        if os.path.lexists(unpacked):
            remove_tree(unpacked)
        self._unpacked = unpacked
        self._folders = 0
        self._is_wanted = is_wanted
        self._pattern = pattern
        self._given = given

    def entries(self) -> list[Entry]:
        """Return all submissions in the order of their paths. A student without a submission has an entry with the reason.

        :raises UnusableInput: when there are no submissions.
        """
        given = self._given
        if given.lower().endswith('.csv') and os.path.isfile(given):
            return [entry for row in clone_all(given, os.path.join(self._unpacked, 'table')) for entry in self._of_row(*row)]
        if given.lower().endswith(ARCHIVES) and os.path.isfile(given):
            unpack(given, os.path.join(self._unpacked, 'all'), OF_A_CLASS)
            given = os.path.join(self._unpacked, 'all')
        refuse_nothing(given)
        student_of = namer(given, self._pattern)
        return [entry for item in _sorted(given) for entry in self._of_item(item, student_of)]

    def _of_row(self, student: Student, folder: str, origin: str, refused: str) -> list[Entry]:
        """Return the submissions of one line of a table."""
        shown = os.path.basename(folder)
        if refused:
            return [Entry(shown, *student, refused=refused, origin=origin)]
        found = list(self._walk(folder, shown, lambda path: student, 0))[:MOST_OF_ONE]
        found = found or [Entry(shown, *student, refused=_nothing_in(folder), help=NAMED)]
        return [entry._replace(origin=origin, root=self._root_of(entry, folder)) for entry in found]

    def _of_item(self, item: os.DirEntry[str], student_of: Callable[[str], Student]) -> Iterator[Entry]:
        """Yield the submissions of one student. Only directories, archives and launch files count."""
        folder = os.path.dirname(item.path)
        if item.is_symlink():
            yield Entry(item.name, *student_of(item.name), refused=LINK)
            return
        found = list(self._item(folder, item, item.name, student_of, 0))[:MOST_OF_ONE]
        if not found and item.is_dir(follow_symlinks=False) and item.name not in BY_THE_WAY:
            found = [Entry(item.name, *student_of(item.name + '/'), refused=_nothing_in(item.path), help=NAMED)]
        yield from (entry._replace(root=self._root_of(entry, item.path)) for entry in found)

    def _root_of(self, entry: Entry, folder: str) -> str:
        """Return the folder of the whole submission that contains this path, or the folder of its unpacked archive."""
        if entry.file.startswith(os.path.join(folder, '')):
            return folder
        if not entry.file.startswith(os.path.join(self._unpacked, '')):
            return ''
        return os.path.join(self._unpacked, os.path.relpath(entry.file, self._unpacked).split(os.sep)[0])

    def _walk(self, folder: str, shown: str, student_of: Callable[[str], Student], nested: int) -> Iterator[Entry]:
        """Yield the submissions in a folder, whose path is `shown`."""
        if shown.count('/') > DEEPEST:
            return
        package = package_at(folder)
        if package is not None:
            if self._is_wanted(package.name):
                yield Entry(shown, *student_of(shown + '/'), file=folder)
            return
        for item in _sorted(folder):
            if item.name not in BY_THE_WAY:
                yield from self._item(folder, item, f'{shown}/{item.name}', student_of, nested)

    def _item(
        self, folder: str, item: os.DirEntry[str], shown: str, student_of: Callable[[str], Student], nested: int
    ) -> Iterator[Entry]:
        path, name = os.path.join(folder, item.name), plain_name(item.name)
        is_exercise = name.endswith(ENDINGS) and self._is_wanted(exercise_of(name))
        if item.is_symlink():
            yield from [Entry(shown, *student_of(shown), refused=LINK)] if is_exercise else []
        elif item.is_dir(follow_symlinks=False):
            yield from self._walk(path, shown, student_of, nested)
        elif item.name.lower().endswith(ARCHIVES):
            yield from self._archive(path, shown, student_of, nested)
        elif item.name.lower().endswith(STRANGE_ARCHIVES):
            yield Entry(
                shown, *student_of(shown), refused='edugrade cannot read this kind of archive', help='pack it as .zip or .tar.gz'
            )
        elif is_exercise:
            yield self._launch_file(Entry(shown, *student_of(shown), file=path))

    def _launch_file(self, entry: Entry) -> Entry:
        """Return the entry of a launch file. If a learning platform has renamed the file, a copy has the original name."""
        name = os.path.basename(entry.file)
        if plain_name(name) == name:
            return entry
        try:
            data = read_regular(entry.file, LARGEST_BYTES + 1)
        except OSError as error:
            return entry._replace(file='', refused=f'it cannot be read: {error.strerror or error}')
        copy = os.path.join(self._new_folder(), plain_name(name))
        os.makedirs(os.path.dirname(copy))
        with open(copy, 'wb') as file:
            file.write(data)
        return entry._replace(file=copy)

    def _archive(self, path: str, shown: str, student_of: Callable[[str], Student], nested: int) -> Iterator[Entry]:
        student = student_of(shown)
        target = self._new_folder()
        try:
            if nested == MOST_NESTED:
                raise UnusableInput(f'archives contain archives, more than {MOST_NESTED} deep')
            with cpu_limit(LONGEST_UNPACKING_S):
                unpack(path, target, OF_A_STUDENT)
        except UnusableInput as error:
            remove_tree(target)
            yield Entry(shown, *student, refused=error.message, help=error.help)
            return
        except TooLong as error:
            remove_tree(target)
            yield Entry(shown, *student, refused=f'the archive cannot be unpacked: {error}')
            return
        found = list(self._walk(target, shown, student_of, nested + 1))
        yield from found or [Entry(shown, *student, refused=_nothing_in(target), help=NAMED)]

    def _new_folder(self) -> str:
        """Return the path of a new folder for one archive or file."""
        os.makedirs(self._unpacked, exist_ok=True)
        self._folders += 1
        return os.path.join(self._unpacked, str(self._folders))


def _nothing_in(folder: str) -> str:
    """Return a message that a folder contains no submission, with the names of its first files."""
    names: list[str] = []
    for _, folders, files in os.walk(folder):
        folders.sort()
        names += sorted(name for name in files if not name.startswith('.'))
        if len(names) >= MOST_NAMES:
            break
    shown = [name if name.isprintable() else ascii(name) for name in names[:MOST_NAMES]]
    return f'{NOTHING}; it contains {", ".join(shown)}' if shown else NOTHING


def _sorted(folder: str) -> list[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as found:
            return sorted((item for item in found if not item.name.startswith('.')), key=lambda item: item.name)
    except OSError as error:
        raise_fault(
            error
        )  # otherwise, a student whose folder is unreadable for a moment would count as a student without a submission
        return []
