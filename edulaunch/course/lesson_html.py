"""Parts of a lesson as HTML, by nbconvert's Markdown and colours; loaded late, for it needs the notebook extra."""

from __future__ import annotations

import os
import re
from base64 import b64encode
from collections.abc import Callable
from typing import Any

from edugrade.markup import element

from edulaunch.errors import UnusableInput

from .lesson_parts import Output, Part

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'pages')
_HEADING = re.compile(r'<h([1-6])(?: id="[^"]*")?>(.*?)</h\1>', re.DOTALL)
_CODE_OR_MATH = re.compile(r'(```.*?```|`[^`]*`)|\$\$?([^$`]+?)\$\$?(?!\w)', re.DOTALL)
_LANGUAGES = {'.xml': 'xml', '.urdf': 'xml', '.xacro': 'xml', '.yaml': 'yaml', '.yml': 'yaml', '.cfg': 'ini', '.toml': 'toml'}


def environment() -> Any:
    """The templates, with the filters `markdown`, `code` and `picture`.

    :raises UnusableInput: when nbconvert is not installed.
    """
    try:
        import nbconvert  # noqa: F401
        from jinja2 import Environment, FileSystemLoader
    except ImportError:
        help = "pip install 'edulaunch[notebook]' installs it; then try again"
        raise UnusableInput('nbconvert, which makes pages of lessons, is not installed', help=help) from None
    templates = Environment(loader=FileSystemLoader(FOLDER), autoescape=True, trim_blocks=True, lstrip_blocks=True)
    templates.filters.update(code=_code, picture=_picture, markdown=_safe(markdown))
    return templates


def _safe(function: Callable[..., str]) -> Callable[..., Any]:
    from markupsafe import Markup

    return lambda *words: Markup(function(*words))


def markdown(text: str, prefix: str = '', lower: int = 0, opened: bool = False) -> str:
    """Markdown as HTML: headings have ids that begin with `prefix`, formulas are drawn, tables' heads name their columns.

    :param lower: by how many levels headings go down.
    :param opened: show what the text folds away.
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
    """The id of a heading, given what stands in it."""
    return prefix + re.sub(r'\W+', '-', re.sub(r'<[^>]*>|&\w+;', '', html)).strip('-').lower()


def _heading(level: int, html: str, prefix: str) -> str:
    return f'<h{level} id="{heading_id(prefix, html)}">{html}</h{level}>'


def _formula(latex: str) -> str:
    """A formula as a drawing; as it was written where it cannot be drawn."""
    from io import BytesIO

    from matplotlib.mathtext import math_to_image

    drawn = BytesIO()
    try:
        math_to_image(f'${latex}$', drawn, format='svg')
    except ValueError:
        return element('code', latex)
    drawing = re.sub(rb'<metadata>.*?</metadata>', b'', drawn.getvalue(), flags=re.DOTALL)  # it has today's date
    return element('img', class_='formula', alt=latex, src=f'data:image/svg+xml;base64,{b64encode(drawing).decode()}')


def _code(part: Part) -> Any:
    """A part's code with its colours."""
    from markupsafe import Markup
    from nbconvert.filters import Highlight2HTML

    language = _LANGUAGES.get(os.path.splitext(part.file)[1], 'python' if not part.file or part.file.endswith('.py') else 'text')
    colours: Any = Highlight2HTML
    return Markup(colours(pygments_lexer='ipython3')(part.text, language=language if part.file else 'ipython3'))


def _picture(output: Output) -> str:
    """Where a picture's bytes are: in the page itself."""
    kind = 'svg+xml' if output.kind == 'replay' else 'png'
    return f'data:image/{kind};base64,{b64encode(output.data).decode()}'
