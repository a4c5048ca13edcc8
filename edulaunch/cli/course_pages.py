"""`edulaunch course reader|slides|notes`: what teachers make of a course, and read about it."""

from __future__ import annotations

import argparse
import os
from typing import Any


def add_verbs(verbs: Any) -> None:
    """The sub-verbs, each with the course that it is about."""
    reader = verbs.add_parser('reader', help='Make accessible HTML pages of all lessons, to be read without Jupyter and network')
    reader.add_argument('out', metavar='OUT', help='a folder for the pages')
    reader.add_argument('--teacher', action='store_true', help='with what was right, and the notes for teachers')
    reader.add_argument('--kept', action='store_true', help='run nothing: the outputs that are kept, without pictures')
    reader.add_argument('--pdf', action='store_true', help='OUT/course.pdf too, by a Chromium that is on this computer')
    slides = verbs.add_parser('slides', help='Make slides of a lesson: one HTML file that needs no network')
    slides.add_argument('lesson', metavar='LESSON', help='its name, or its number')
    slides.add_argument('out', nargs='?', metavar='OUT', help='the file (default: LESSON.slides.html)')
    slides.add_argument('--kept', action='store_true', help='run nothing: the outputs that are kept, without pictures')
    notes = verbs.add_parser('notes', help='Show the notes for teachers on a lesson, or which there are')
    notes.add_argument('lesson', nargs='?', metavar='LESSON', help='its name, or its number')
    for parser in (reader, slides, notes):
        parser.add_argument('--course', metavar='COURSE', help='its folder (default: the one around this folder, else ours)')


def reader(arguments: argparse.Namespace) -> int:
    """`edulaunch course reader OUT`."""
    from edulaunch.course.reader import write_reader

    out = arguments.out
    names, problem = write_reader(_course(arguments), out, teacher=arguments.teacher, kept=arguments.kept, pdf=arguments.pdf)
    print(f'{out}: {len(names)} pages. Begin with {os.path.join(out, names[0])}')
    if arguments.pdf:
        print(problem or f'{os.path.join(out, "course.pdf")}: the whole course')
    return 1 if problem else 0


def slides(arguments: argparse.Namespace) -> int:
    """`edulaunch course slides LESSON [OUT]`."""
    from edulaunch.course.slides import write_slides

    out, count = write_slides(_course(arguments), arguments.lesson, arguments.out, kept=arguments.kept)
    print(f'{out}: {count} slides. Open it in a browser: arrow keys, N for the whole text, O for all slides, or print it')
    return 0


def notes(arguments: argparse.Namespace) -> int:
    """`edulaunch course notes [LESSON]`."""
    from edulaunch.course.notes import list_of_notes, notes_of

    course = _course(arguments)
    print(notes_of(course, arguments.lesson) if arguments.lesson else list_of_notes(course))
    return 0


def _course(arguments: argparse.Namespace) -> str:
    from edulaunch.course.place import course_around, given_course

    return given_course(arguments.course) if arguments.course else course_around('.')
