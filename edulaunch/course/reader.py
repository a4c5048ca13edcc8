"""`edulaunch course reader`: write a course as accessible HTML pages that need neither a network nor Jupyter, and as PDF."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator
from html import unescape
from pathlib import Path
from shutil import which
from subprocess import TimeoutExpired, run
from tempfile import TemporaryDirectory
from typing import NamedTuple

from edugrade.course import read_toml

from edulaunch.errors import UnusableInput

from .copying import write_file
from .lesson_parts import FOLDER, Part, environment, heading_id, lesson_parts, markdown
from .lessons import LESSONS, manifest, read_lessons, read_notes
from .notebook_file import read_notebook
from .questions import questions_file, read_questions
from .runs import Say, run_lessons
from .stored import read_outputs

REPLAYS = 'replays'
_HEADING = {level: re.compile(rf'<h{level} id="[^"]*">(.*?)</h{level}>', re.DOTALL) for level in (1, 2)}


class Page(NamedTuple):
    """One lesson as a page of a reader.

    :param sections: the ID and the HTML of each heading of the second level.
    :param came: the parts whose outputs answer a prediction.
    :param notes: the notes for the teacher, as Markdown.
    """

    name: str
    title: str
    parts: tuple[Part, ...]
    sections: tuple[tuple[str, str], ...]
    came: tuple[Part, ...]
    notes: str = ''


def write_reader(
    course: str, target: str, *, teacher: bool = False, kept: bool = False, pdf: bool = False, say: Say = lambda line: None
) -> tuple[list[str], str]:
    """Write the pages of a course to a folder. Return their names, and the reason if a requested PDF was not written.

    :param teacher: whether to include right answers, open all answers, and add the notes for teachers.
    :param kept: whether to use the outputs stored beside the lessons, which have no pictures. If False, the lessons run.
    :param say: called with one line for each lesson that has run.
    :raises UnusableInput: when the folder has other files in it, a lesson cannot be read or run, or nbconvert is missing.
    """
    templates = environment()
    pages = list(read_pages(course, teacher=teacher, kept=kept, say=say))
    if not pages:
        raise UnusableInput(f'there is no lesson in {os.path.join(course, LESSONS)}', help='name lessons like 01_name.ipynb')
    _make_room(target)
    shutil.copy(os.path.join(FOLDER, 'reader.css'), os.path.join(target, 'reader.css'))
    page, about = templates.get_template('page.html.j2'), {'course': course_title(course), 'teacher': teacher, 'language': 'en'}
    for number, found in enumerate(pages):
        options = {
            'prefix': f'{found.name}-',
            'lower': 0,
            'teacher': teacher,
            'flat': False,
            'replays': _write_replays(target, found),
        }
        around = {
            'before': pages[number - 1] if number else None,
            'after': pages[number + 1] if number + 1 < len(pages) else None,
        }
        write_file(target, f'{found.name}.html', page.render(title=found.title, page=found, options=options, **around, **about))
    flat = [{'prefix': f'{found.name}-', 'lower': 1, 'teacher': teacher, 'flat': True, 'replays': {}} for found in pages]
    write_file(
        target,
        'course.html',
        page.render(title=f'{about["course"]}, all lessons', whole=True, pages=pages, options=flat, **about),
    )
    problem = write_pdf(os.path.join(target, 'course.html'), os.path.join(target, 'course.pdf')) if pdf else ''
    write_file(target, 'index.html', page.render(title=about['course'], pages=pages, pdf=pdf and not problem, **about))
    return ['index.html', 'course.html', *(f'{found.name}.html' for found in pages)], problem


def read_pages(
    course: str, *, teacher: bool, kept: bool, only: str | None = None, say: Say = lambda line: None
) -> Iterator[Page]:
    """Yield the lessons of a course as pages, in their order.

    :param only: the name of a single lesson; None means all lessons.
    :param say: called with one line for each lesson that has run.
    """
    folder = os.path.join(course, LESSONS)
    questions = read_questions(questions_file(folder))
    names = [lesson.name for lesson in read_lessons(folder)]
    names = names[: names.index(only) + 1] if only else names
    wanted = [only] if only else names
    if kept:
        outputs = {name: read_outputs(os.path.join(folder, f'{name}.ipynb')) for name in wanted}
    else:
        outputs = run_lessons(course, names, wanted, say)
    for name in wanted:
        cells = read_notebook(os.path.join(folder, f'{name}.ipynb')).cells
        parts = tuple(lesson_parts(cells, outputs[name], questions, teacher))
        yield _page(name, parts, read_notes(course).get(name, '') if teacher else '')


def course_title(course: str) -> str:
    """Return the title of a course, which is `title` in its course.toml, or else the name of its folder."""
    path = manifest(course)
    try:
        return str(read_toml(path)['title']) if path else os.path.basename(os.path.abspath(course))
    except (OSError, ValueError, KeyError):
        return os.path.basename(os.path.abspath(course))


def _page(name: str, parts: tuple[Part, ...], notes: str) -> Page:
    html = '\n'.join(markdown(part.text) for part in parts if part.kind == 'text')
    title = next(iter(_HEADING[1].findall(html)), name)
    sections = [(heading_id(f'{name}-', text), text) for text in _HEADING[2].findall(html)]
    sections += [(f'{name}-notes', 'For the teacher')] if notes else []
    return Page(name, unescape(title), parts, tuple(sections), tuple(part for part in parts if part.folded), notes)


def _write_replays(target: str, page: Page) -> dict[str, str]:
    """Write the replays of a lesson as separate pages. Return the address of each page, by the caption of the replay."""
    places: dict[str, str] = {}
    for output in (output for part in page.parts for output in part.outputs if output.kind == 'replay' and output.page):
        places[output.text] = f'{REPLAYS}/{page.name}-{len(places) + 1}.html'
        write_file(target, places[output.text], output.page)
    return places


def _make_room(target: str) -> None:
    """Create a folder for pages, or delete the pages of an older reader in it.

    :raises UnusableInput: when the folder contains other files.
    """
    if os.path.isdir(target) and os.listdir(target):
        if not os.path.isfile(os.path.join(target, 'reader.css')):
            raise UnusableInput(f'{target} contains other files', help='name a new folder')
        for name in os.listdir(target):
            if name.endswith('.html') or name == 'course.pdf':
                os.remove(os.path.join(target, name))
        shutil.rmtree(os.path.join(target, REPLAYS), ignore_errors=True)
    os.makedirs(target, exist_ok=True)


BROWSERS = (
    'chromium',
    'chromium-browser',
    'google-chrome',
    'chrome',
    'msedge',
    'google-chrome-stable',
    'chromium-headless-shell',
)
WAIT_S = 300.0


def write_pdf(page: str, pdf: str) -> str:
    """Print an HTML file to PDF, with its headings as an outline and its structure kept for screen readers.

    Return an empty string. If there is no PDF, return the reason and what to do instead.
    """
    browser = next(filter(None, map(which, BROWSERS)), None)
    instead = f'open {page} in a browser and print it to a file'
    if browser is None:
        return f'no PDF, because no Chromium is installed ({", ".join(BROWSERS[:3])}); {instead}'
    with TemporaryDirectory(prefix='edulaunch-pdf-', ignore_cleanup_errors=True) as profile:
        words = ['--headless', '--disable-gpu', '--no-pdf-header-footer', '--generate-pdf-document-outline']
        words += ['--no-sandbox'] if hasattr(os, 'geteuid') and os.geteuid() == 0 else []  # root cannot use the sandbox
        words += [f'--user-data-dir={profile}', f'--print-to-pdf={os.path.abspath(pdf)}', Path(page).resolve().as_uri()]
        try:
            done = run([browser, *words], capture_output=True, text=True, errors='replace', timeout=WAIT_S)
        except (OSError, TimeoutExpired) as error:
            return f'no PDF: {browser} failed: {error}; {instead}'
    return '' if os.path.isfile(pdf) else f'no PDF: {browser} failed: {done.stderr[-300:].strip()}; {instead}'
