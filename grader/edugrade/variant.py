"""The use of a course secret: runs that students cannot predict, and each student's own variant of an exercise.

An exercise's entry in course.toml lists the variants, such as ``variants = [['0.4', '0.3', '0.5'], ['lamp', 'mirror']]``.
Each row begins with the string that the starter file, the solution, the rubric and the hints contain. The other strings can
replace it. A course without a secret uses the first string of each row.
"""

from __future__ import annotations

import hmac
import json
import os
import re
import stat
from collections.abc import Mapping
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from .course import Exercise, course_manifest, find_course, read_course, read_toml
from .faults import raise_fault
from .files import read_given

LEAST_BYTES, MOST_BYTES = 16, 4096


class CourseSecret:
    """A secret from a file. It is never read from environment variables or the command line, because other programs can see
    these.

    :raises UnusableInput: if the file cannot be read, is too short to be a secret, or all users of the computer can change it.
    """

    def __init__(self, path: str) -> None:
        self._key = read_given(path, MOST_BYTES, 'the course secret ').strip()
        if os.name == 'posix' and os.stat(path).st_mode & stat.S_IWOTH:
            raise UnusableInput(f'every user of this computer can change the course secret {path}', help=f'run: chmod 600 {path}')
        if len(self._key) < LEAST_BYTES:
            raise UnusableInput(
                f'the course secret {path} is shorter than {LEAST_BYTES} bytes',
                help='create one with openssl rand -hex 32 > secret',
            )

    @classmethod
    def of(cls, key: bytes) -> CourseSecret:
        """Return a secret from bytes, for experiments."""
        found = cls.__new__(cls)
        found._key = key
        return found

    @property
    def name(self) -> str:
        """A string that identifies the secret without revealing it."""
        return hmac.digest(self._key, b'edugrade: which secret', 'sha256').hex()[:16]

    def number(self, *words: str) -> int:
        """Return a number that depends on this secret and these words."""
        message = '\0'.join(('edugrade: variant', *words)).encode('utf-8', 'surrogateescape')
        return int.from_bytes(hmac.digest(self._key, message, 'sha256')[:8], 'big')

    def seed(self, exercise: str, student: str, sha256: str) -> int:
        """Return the seed for the runs of a submission. The seed differs for each student and each version of the file."""
        message = '\0'.join((exercise, student, sha256)).encode('utf-8', 'surrogateescape')
        return int.from_bytes(hmac.digest(self._key, message, 'sha256')[:4], 'big')


FILE = 'my_variant.toml'
"""The file in the folder ``exercises`` of a student's copy with the values of each exercise, which the grader reads, too."""
MARK = re.compile(r'Variant ([0-9a-f]{8})\b')


class Variant(NamedTuple):
    """The values that replace the usual strings in one student's exercise.

    :param student: the name of the student.
    :param tag: the string that identifies the variant in the student's file.
    :param values: the student's string for each usual string.
    """

    student: str
    tag: str
    values: Mapping[str, str]

    def of(self, text: str) -> str:
        """Return a string of the course with the student's values. Only whole words and numbers are replaced, all at the same
        time.
        """
        if not self.values:
            return text
        words = '|'.join(re.escape(word) for word in sorted(self.values, key=len, reverse=True))
        return re.sub(rf'(?<![\w.])(?:{words})(?!\w|\.\d)', lambda found: self.values[found[0]], text)

    def stub(self, text: str) -> str:
        """Return the starter file with the student's values, and with a line that contains the tag of the variant."""
        line = f'Variant {self.tag}, made for {self.student}.\n\n'
        return re.sub(r'^(?=Grade it )', lambda found: line, self.of(text), count=1, flags=re.MULTILINE)

    def is_of_another(self, text: str) -> bool:
        """Return whether the content of a file belongs to another student's variant."""
        return any(tag != self.tag for tag in MARK.findall(text))


def personal(exercise: Exercise, student: str, secret: CourseSecret) -> Variant | None:
    """Return the variant of a student, or None for an exercise that is the same for all students.

    The same student, exercise and secret give the same variant on every computer and with every version of Python.
    """
    if not exercise.variants or not student:
        return None
    choices = {row[0]: row[secret.number(exercise.name, student, row[0]) % len(row)] for row in exercise.variants}
    tag = f'{secret.number(exercise.name, student, "") & 0xFFFFFFFF:08x}'
    return Variant(student, tag, choices)


def variant_for(name: str, student: str, secret: CourseSecret | None) -> Variant | None:
    """Return the variant for grading an exercise, or None if the exercise has no variant.

    With a secret, the variant is computed for this student. Otherwise, it is read from the student's copy of the course. The
    search for the course begins in the current folder, never in the submission.

    :raises UnusableInput: if the course, or the student's file in it, cannot be read.
    """
    if secret is not None:
        known = read_course(course_manifest() or find_course(os.sep))
        return next((personal(item, student, secret) for item in known if item.name == name), None)
    manifest = course_manifest()
    return None if manifest is None else _read(_beside(manifest)).get(name)


def write_variants(student: str, variants: Mapping[str, Variant]) -> bytes:
    """Return the content of the file in a student's copy of the course that contains the values of each exercise."""
    lines = [f'# The values of the exercises as they were made for {student}. check() and edugrade read them.\n']
    for name, variant in variants.items():
        lines.append(f'\n[{name}]\nstudent = {json.dumps(student)}\ntag = "{variant.tag}"\n[{name}.values]\n')
        lines += [f'{json.dumps(key)} = {json.dumps(value)}\n' for key, value in variant.values.items()]
    return ''.join(lines).encode()


def _beside(manifest: str) -> str:
    folder = os.path.dirname(manifest)
    inside = os.path.join(folder, 'exercises', FILE)
    return inside if os.path.isfile(inside) else os.path.join(folder, FILE)


def _read(path: str) -> dict[str, Variant]:
    try:
        tables: dict[str, Any] = read_toml(path)
        return {name: Variant(table['student'], table['tag'], dict(table['values'])) for name, table in tables.items()}
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise_fault(error)
        raise UnusableInput(f'{path} cannot be read: {error}', help='copy it from your course again') from None
