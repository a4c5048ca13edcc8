"""A lesson as the parts of a page or a slide: text, code, pictures, predictions and questions.

A page cannot wait for a prediction, so the answers are folded away. Only teachers see the right answers, and
questions appear without answers.

nbconvert converts the parts to HTML, with Markdown and syntax colours. It is imported late, because it needs the notebook extra.
"""

from __future__ import annotations

import os
import re
from base64 import b64decode, b64encode
from collections.abc import Callable, Iterable, Iterator, Mapping
from html import unescape
from io import BytesIO
from typing import Any, NamedTuple

from edugrade.reports.markup import element

from edulaunch.errors import UnusableInput, how_to_install

from .notebook_file import Cell
from .questions import Question, Questions

WRITES = '%%writefile '
_CALL = r"^{}\('([\w-]+)'(?:.*#\s*(.*))?"
_PREDICTS, _COMPARES, _ASKS, _EXPLAINS = (
    re.compile(_CALL.format(name), re.MULTILINE) for name in ('predict', 'compare', 'quiz', 'explain')
)
_CALLS = re.compile(r"^(predict|compare|quiz|explain)\('.*$\n?", re.MULTILINE)
_ANSI = re.compile(r'\x1b\[[0-9;]*m')
_WAS = re.compile(r'The result is (.*?)(?:\. You made no prediction|$)', re.DOTALL)
_FRAME, _STILL = re.compile(r'<iframe [^>]*srcdoc="([^"]*)"'), re.compile(r'src="data:image/svg\+xml;base64,([^"]*)"')


class Output(NamedTuple):
    """An output of a cell.

    :param kind: text, error, picture, html or replay.
    :param text: the text of the output; for a picture or a replay, the caption.
    :param data: the bytes of the picture, PNG or SVG; None if only the caption was stored.
    :param page: the HTML of an html output or a replay.
    """

    kind: str
    text: str
    data: bytes = b''
    page: str = ''


class Part(NamedTuple):
    """One element of a page.

    :param kind: text (Markdown), code, guess (the place for a prediction), answer (to a prediction, for teachers) or quiz.
    :param ident: the ID of the cell.
    :param text: the Markdown, the code, the form of the prediction, or the answer.
    :param file: the name of the file to which the code is written.
    :param folded: whether the outputs answer a prediction, so that readers open the outputs only after their prediction.
    """

    kind: str
    ident: str
    text: str
    file: str = ''
    outputs: tuple[Output, ...] = ()
    folded: bool = False
    question: Question | None = None


def lesson_parts(
    cells: Iterable[Cell], outputs: Mapping[str, list[dict[str, Any]]], questions: Questions, teacher: bool
) -> Iterator[Part]:
    """Return the parts of a notebook's cells in order.

    :param outputs: the outputs of each code cell, by the ID of the cell.
    :param teacher: whether to include the right answers to predictions.
    """
    asked = False
    for cell in cells:
        source = cell.source
        if cell.kind == 'markdown':
            asked = '**Predict' in source
            yield Part('text', cell.ident, source)
        elif cell.kind == 'code':
            asked = asked or bool(_PREDICTS.search(source))
            gave = tuple(_outputs(outputs.get(cell.ident, [])))
            yield from _code_parts(cell.ident, source, gave, asked and not teacher)
            yield from (
                Part('quiz', cell.ident, name, question=questions.questions.get(name)) for name, _ in _ASKS.findall(source)
            )
            for name, _ in _EXPLAINS.findall(source):
                answer = questions.explanations[name].answer if name in questions.explanations else ''
                yield Part('guess', cell.ident, 'one or two sentences')
                yield Part('text', cell.ident, f'<details><summary>Answer</summary>\n\n{answer}\n\n</details>')
            if _COMPARES.search(source):
                asked = False
                was = next((found[1] for output in reversed(gave) if (found := _WAS.search(output.text))), '')
                if teacher and was:
                    yield Part('answer', cell.ident, was)


def _code_parts(ident: str, source: str, gave: tuple[Output, ...], folded: bool) -> Iterator[Part]:
    """Return the parts of a code cell: its lines without calls of `predict`, `compare` or `quiz`, its outputs, and the place for
    the prediction.
    """
    predicts = _PREDICTS.search(source)
    if predicts:
        yield Part('guess', ident, predicts[2] or '')
    called = _CALLS.search(source)
    if called:  # the cell's last output is the result of this call
        source, gave = _CALLS.sub('', source).strip('\n'), tuple(output for output in gave if output.kind in ('text', 'error'))
        gave = tuple(
            output
            for output in gave
            if not output.text.startswith(('The result is ', 'You predicted ', 'No prediction yet', '<'))
        )
        if called[1] in ('quiz', 'explain'):
            gave = ()
    if not source.strip():
        return
    first, _, rest = source.partition('\n')
    file = first.removeprefix(WRITES).strip() if first.startswith(WRITES) else ''
    yield Part('code', ident, rest if file else source, file, () if file else gave, folded and bool(gave) and not file)


def _outputs(raw: list[dict[str, Any]]) -> Iterator[Output]:
    for output in raw:
        if output['output_type'] == 'stream':
            yield Output('text', _plain(output['text']))
        elif output['output_type'] == 'error':
            yield Output('error', _plain('\n'.join(output['traceback']) or f'{output["ename"]}: {output["evalue"]}'))
        else:
            yield _shown(output['data'])


def _plain(text: str | list[str]) -> str:
    return _ANSI.sub('', ''.join(text)).strip('\n')


def _shown(data: Mapping[str, Any]) -> Output:
    """Return an output in the best available form: a picture with its caption, a table, or text."""
    text, page = _plain(data.get('text/plain', '')), ''.join(data.get('text/html', ''))
    if 'image/png' in data:
        return Output('picture', text, b64decode(''.join(data['image/png'])))
    frame, still = _FRAME.search(page), _STILL.search(page)
    if frame:
        return Output('replay', text, b64decode(still[1]) if still else b'', unescape(frame[1]))
    if page.startswith('<table') or (page and re.fullmatch(r'<.* object.*>', text)):
        return Output('html', text, page=page)
    return Output('picture' if 'text/html' in data and text.startswith('replay of') else 'text', text)


FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'pages')
_HEADING = re.compile(r'<h([1-6])(?: id="[^"]*")?>(.*?)</h\1>', re.DOTALL)
_CODE_OR_MATH = re.compile(r'(```.*?```|`[^`]*`)|\$\$?([^$`]+?)\$\$?(?!\w)', re.DOTALL)
_LANGUAGES = {'.xml': 'xml', '.urdf': 'xml', '.xacro': 'xml', '.yaml': 'yaml', '.yml': 'yaml', '.cfg': 'ini', '.toml': 'toml'}


def environment() -> Any:
    """Return the environment of the templates, with the filters `markdown`, `code` and `picture`.

    :raises UnusableInput: when nbconvert is not installed.
    """
    try:
        import nbconvert  # noqa: F401
        from jinja2 import Environment, FileSystemLoader
    except ImportError:
        raise UnusableInput(
            'nbconvert, which converts lessons to pages, is not installed', help=how_to_install('notebook')
        ) from None
    templates = Environment(loader=FileSystemLoader(FOLDER), autoescape=True, trim_blocks=True, lstrip_blocks=True)
    templates.filters.update(code=_code, picture=_picture, markdown=_safe(markdown))
    return templates


def _safe(function: Callable[..., str]) -> Callable[..., Any]:
    from markupsafe import Markup

    return lambda *words: Markup(function(*words))


def markdown(text: str, prefix: str = '', lower: int = 0, opened: bool = False) -> str:
    """Convert Markdown to HTML. Formulas become drawings, and table headings name their columns.

    :param prefix: the beginning of each heading's ID.
    :param lower: the number of levels by which headings are lowered.
    :param opened: whether to open the parts that the text folds away.
    """
    from nbconvert.filters.markdown_mistune import IPythonRenderer, MarkdownWithMath

    formulas: list[str] = []

    def keep(found: re.Match[str]) -> str:
        if found[1]:
            return found[1]
        formulas.append(_formula(found[2]))
        return f'FORMULA{len(formulas) - 1}E'

    renderer = IPythonRenderer(escape=False, exclude_anchor_links=True)
    page: str = MarkdownWithMath(renderer=renderer).render(_CODE_OR_MATH.sub(keep, text))
    page = _HEADING.sub(lambda found: _heading(int(found[1]) + lower, found[2], prefix), page)
    page = re.sub(r'FORMULA(\d+)E', lambda found: formulas[int(found[1])], page).replace('<th', '<th scope="col"')
    page = page.replace('<th scope="col"ead', '<thead')
    return page.replace('<details>', '<details open>') if opened else page


def heading_id(prefix: str, html: str) -> str:
    """Return the ID of a heading for its text."""
    return prefix + re.sub(r'\W+', '-', re.sub(r'<[^>]*>|&\w+;', '', html)).strip('-').lower()


def _heading(level: int, html: str, prefix: str) -> str:
    return f'<h{level} id="{heading_id(prefix, html)}">{html}</h{level}>'


def _formula(latex: str) -> str:
    """Return a formula as a drawing, or unchanged if it cannot be drawn."""
    from matplotlib.mathtext import math_to_image

    drawn = BytesIO()
    try:
        math_to_image(f'${latex}$', drawn, format='svg')
    except ValueError:
        return element('code', latex)
    drawing = re.sub(rb'<metadata>.*?</metadata>', b'', drawn.getvalue(), flags=re.DOTALL)  # the metadata has today's date
    return element('img', class_='formula', alt=latex, src=f'data:image/svg+xml;base64,{b64encode(drawing).decode()}')


def _code(part: Part) -> Any:
    """Return the code of a part with syntax colours, as HTML."""
    from markupsafe import Markup
    from nbconvert.filters import Highlight2HTML

    language = _LANGUAGES.get(os.path.splitext(part.file)[1], 'python' if not part.file or part.file.endswith('.py') else 'text')
    colours: Any = Highlight2HTML
    return Markup(colours(pygments_lexer='ipython3')(part.text, language=language if part.file else 'ipython3'))


def _picture(output: Output) -> str:
    """Return the address of a picture. The address itself contains the bytes."""
    kind = 'svg+xml' if output.kind == 'replay' else 'png'
    return f'data:image/{kind};base64,{b64encode(output.data).decode()}'
