"""`edulaunch course slides`: a lesson as slides, in one HTML file.

The content of the slides depends only on the lesson. A heading begins a slide, and the answer to a prediction is on the next
slide. A slide shows the first sentence of a paragraph. The speaker's text below it has the whole paragraph.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import NamedTuple

from .lesson_parts import FOLDER, Part, environment
from .lessons import LESSONS, read_lessons, the_one
from .reader import read_pages
from .runs import Say

FULL = 16
"""The maximum number of lines on a slide."""
_WIDE = 80
_KEPT_WHOLE = re.compile(r'#|\||[-*] |\d+\. |<|    |\*\*(Predict|Explain|Change|Write|Repair|Find|Fill|Add)')
_LEADS = re.compile(r'(?!#)[^\n]*[^.!?\s]\n\n- ')
"""A line without a final stop, such as "After this lesson you can". The list after such a line is on the same slide."""
_PIECES = re.compile(r'(?:^|\n\n)((?:```.*?```|<details>.*?</details>|(?<![.!?])\n\n(?=- )|(?!\n\n).)+)', re.DOTALL)


class Slide(NamedTuple):
    """One slide.

    :param under: the heading of the section, if the slide does not begin the section.
    :param parts: the content of the slide.
    :param sources: the Markdown that the slide shows only in part.
    """

    under: str
    parts: list[Part]
    sources: list[str]


def write_slides(
    course: str, lesson: str, out: str | None = None, *, kept: bool = False, say: Say = lambda line: None
) -> tuple[str, int]:
    """Write the slides of a lesson. Return the file and the number of slides.

    :param lesson: the name of the lesson, or the beginning of the name.
    :param kept: whether to use the stored outputs, which have no pictures. If False, the lesson runs.
    :param say: called with one line before the run, and one line when the lesson has run.
    :raises UnusableInput: when there is no such lesson, or it cannot be run.
    """
    names = [found.name for found in read_lessons(os.path.join(course, LESSONS))]
    name = the_one(lesson, names, f'there is no lesson {lesson}')
    templates = environment()
    page = next(read_pages(course, teacher=True, kept=kept, only=name, say=say))
    slides = list(split(page.parts))
    files = {}
    for key in ('slides.css', 'slides.js', 'reader.css'):
        with open(os.path.join(FOLDER, key), encoding='utf-8') as file:
            files[key.replace('.', '_')] = file.read()
    options = {'prefix': '', 'lower': 0, 'teacher': False, 'flat': False, 'replays': None}
    target = out or f'{name}.slides.html'
    with open(target, 'w', encoding='utf-8') as file:
        file.write(templates.get_template('slides.html.j2').render(title=page.title, slides=slides, options=options, **files))
    return target, len(slides)


def split(parts: tuple[Part, ...]) -> Iterator[Slide]:
    """Return the slides for the parts of a lesson."""
    slide, lines, asked = Slide('', [], []), 0, False
    for part in (piece for whole in parts for piece in _pieces(whole)):
        short = _short(part)
        needs, heading = _lines(short), part.text.startswith('## ') if part.kind == 'text' else False
        answers = asked and bool(part.outputs or part.kind == 'answer')
        if slide.parts and (heading or answers or lines + needs > FULL):
            yield slide
            under = '' if heading else _heading(slide)
            slide, lines = Slide(under, [], []), 0
        if short != part:
            slide.sources.append(part.text)
        slide.parts.append(short)
        lines += needs
        asked = part.kind == 'guess' or '**Predict' in part.text if part.kind in ('text', 'guess') else asked and not answers
    if slide.parts:
        yield slide


def _pieces(part: Part) -> Iterator[Part]:
    """Split Markdown into paragraphs, tables and lists. Also separate code from its outputs if both are long."""
    if part.kind == 'text':
        yield from (part._replace(text=found.strip('\n')) for found in _PIECES.findall(part.text) if found.strip())
    elif part.kind == 'code' and part.outputs:
        yield part._replace(outputs=())
        yield from (Part('output', part.ident, '', outputs=(output,)) for output in part.outputs)
    else:
        yield part


def _lines(part: Part) -> int:
    if part.kind in ('quiz', 'guess', 'answer'):
        return 2 * len(part.question.choices) + 2 if part.question else 2
    if part.kind == 'text':
        return 1 + sum(1 + len(line) // _WIDE for line in part.text.split('\n')) * (
            1 if part.text[:1] in '|-*' or _LEADS.match(part.text) else 2
        )
    shown = (13 if output.data else len(output.text.split('\n')) for output in part.outputs)
    return sum(shown) + len(part.text.split('\n'))


def _short(part: Part) -> Part:
    """Return the first sentence of a plain paragraph."""
    if part.kind != 'text' or _KEPT_WHOLE.match(part.text) or _LEADS.match(part.text):
        return part
    joined = ' '.join(part.text.split('\n'))
    sentence = re.match(r'(?:`[^`]*`|[^`])*?[.:?!](?=\s+[A-Z`*(]|$)', joined)
    return part._replace(text=sentence[0] if sentence and len(sentence[0]) < len(joined) else part.text)


def _heading(slide: Slide) -> str:
    found = next((part.text for part in slide.parts if part.kind == 'text' and part.text.startswith('#')), '')
    return found.lstrip('# ') or slide.under
