"""A student's own copy of a course: the names and numbers of its exercises are chosen for the student by the course's secret."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from edugrade.course import MANIFEST, read_course
from edugrade.variant import FILE, CourseSecret, personal, write_variants

from edulaunch.errors import UnusableInput

from .place import EXERCISES, manifest

LONGEST_NAME = 80


def personal_files(files: Mapping[str, bytes], course: str, student: str, secret: CourseSecret) -> dict[str, bytes]:
    """What is handed out, made for one student: exercises that have variants in hers, and the file by which she is graded.

    :param files: what all students get, by path.
    :raises UnusableInput: when the name is none, or no exercise of the course has variants.
    """
    if not student.isprintable() or not 0 < len(student) <= LONGEST_NAME:
        raise UnusableInput(f'{student!r} is no name of a student', help='the name of the folder with what the student hands in')
    path = manifest(course)
    known = read_course(path) if path else []
    variants = {item.name: found for item in known if (found := personal(item, student, secret)) is not None}
    if not variants:
        raise UnusableInput('no exercise of this course has variants', help=f'variants = [["usual", "other"], ...] in {MANIFEST}')
    made = dict(files)
    for item in known:
        for name in files:
            inside = name.split('/')
            if item.name in variants and inside[0] == EXERCISES and inside[1:2] == [item.path]:
                made[name] = _made(files[name], variants[item.name].stub)
    made[f'{EXERCISES}/{FILE}'] = write_variants(student, variants)
    return dict(sorted(made.items()))


def _made(data: bytes, personal: Callable[[str], str]) -> bytes:
    try:
        return personal(data.decode('utf-8')).encode()
    except UnicodeDecodeError:
        return data  # a picture, say
