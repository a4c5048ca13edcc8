"""``edugrade similar RESULTS`` shows pairs of submissions that are more similar than the task explains.

Changes of names, comments, spaces, strings and numbers do not change the fingerprints of code (winnowing, Schleimer et al. 2003).
"""

from __future__ import annotations

import argparse
import keyword
import os
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import combinations, zip_longest
from math import log
from typing import Any, NamedTuple
from zlib import crc32

from edulaunch.errors import UnusableInput

from ..course import find_course, read_course
from ..files import write_whole
from ..reports.markup import Markup, element, html_page, table_row
from ..reports.terminal import printable
from ..reports.theme import PAGE
from ..submission import Submission
from ..worker import TooLong, cpu_limit
from .batch.store import Store
from .verify import find_submission

TOKENS, WINDOW = 9, 4  # tokens in a fingerprint; fingerprints of which the smallest one is kept
MOST_TOKENS = 50_000
# Strings and comments have a maximum length, so that an endless one is not searched repeatedly.
_TOKEN = re.compile(
    r'(?P<skip>\s+|#[^\n]*|<!--.{0,2000}?-->)'
    r'|(?P<text>(?:\b[rRbBfFuU]{1,2})?(?:"""(?:[^\\]|\\.){0,5000}?"""|\'\'\'(?:[^\\]|\\.){0,5000}?\'\'\'|"(?:[^"\\\n]|\\.){0,300}"|\'(?:[^\'\\\n]|\\.){0,300}\'))'
    r'|(?P<number>\d[\w.]*)|(?P<name>[^\W\d]\w*)|(?P<sign>.)',
    re.S,
)
_IMPORT = re.compile(r'^\s*(?:from\s+[\w.]+\s+)?import\s+([^\n#]+)', re.M)


class Code(NamedTuple):
    """The lines of a file, and the lines on which each of its fingerprints begins and ends."""

    lines: list[str]
    prints: dict[int, tuple[int, int]]


def fingerprints(text: str) -> Code:
    """Return the fingerprints of Python, XML or YAML code. Imported names, attributes and keywords of Python are not replaced."""
    tokens = _tokens(text)
    grams = [
        (
            crc32(' '.join(word for word, _ in tokens[start : start + TOKENS]).encode()),
            tokens[start][1],
            tokens[start + TOKENS - 1][1],
        )
        for start in range(len(tokens) - TOKENS + 1)
    ]
    kept: dict[int, tuple[int, int]] = {}
    for start in range(max(1, len(grams) - WINDOW + 1) if grams else 0):
        number, first, last = min(grams[start : start + WINDOW])
        kept.setdefault(number, (first, last))
    return Code(text.splitlines(), kept)


def _tokens(text: str) -> Sequence[tuple[str, int]]:
    """Return (normalised token, its line) for each token."""
    known = {
        name.strip() for found in _IMPORT.findall(text) for part in found.split(',') for name in part.strip('() ').split(' as ')
    }
    found: list[tuple[str, int]] = []
    line, before = 1, ''
    for match in _TOKEN.finditer(text):
        word, kind = match[0], match.lastgroup
        if kind != 'skip' and len(found) < MOST_TOKENS:
            if kind == 'name' and not (keyword.iskeyword(word) or word in known or before == '.'):
                found.append(('n', line))
            else:
                found.append(({'text': 's', 'number': '0'}.get(kind or '', word), line))
            before = word
        line += word.count('\n')
    return found


class Work(NamedTuple):
    """A submission with its student, its path, its files by name, and its launch graph."""

    student: str
    path: str
    texts: dict[str, Code]
    graph: tuple[str, ...]

    @property
    def prints(self) -> set[int]:
        """The fingerprints of all files of the submission."""
        return {number for code in self.texts.values() for number in code.prints}


class Pair(NamedTuple):
    """Two submissions and their similarity.

    :ivar code: the share of the smaller submission's code that the other submission also contains, from 0 to 1.
    :ivar graph: the share of the smaller launch graph that the other launch graph also contains, from 0 to 1.
    :ivar shared: the fingerprints that both submissions contain.
    """

    one: Work
    two: Work
    code: float
    graph: float
    shared: frozenset[int]


def alike(works: Sequence[Work], given: Iterable[int] = (), least: float = 0.5) -> list[Pair]:
    """Return the pairs of different students that share at least `least` of their code. The most similar pair comes first.

    Code of the starter file does not count. Code that many students have counts little, because there are few ways to write a
    launch file.

    :param given: fingerprints of the starter file.
    :param least: the smallest similarity of code, from 0 to 1.
    """
    handed_out = set(given)
    own = [work.prints - handed_out for work in works]
    weights = _weights(own)
    lines = _weights([set(work.graph) for work in works])
    pairs = []
    for (one, here), (two, there) in combinations(zip(works, own, strict=True), 2):
        if one.student == two.student:
            continue
        shared = here & there
        code = _share(shared, here, there, weights)
        if code >= least:
            common = set(one.graph) & set(two.graph)
            pairs.append(Pair(one, two, code, _share(common, set(one.graph), set(two.graph), lines), frozenset(shared)))
    return sorted(pairs, key=lambda pair: (-pair.code, pair.one.path, pair.two.path))


def _weights(sets: Sequence[set[int]] | Sequence[set[str]]) -> dict[object, float]:
    """Return the weight of each fingerprint: 1 if two of many submissions have it, and nearly 0 if all have it."""
    counts: Counter[object] = Counter(item for items in sets for item in items)
    most = log(max(len(sets), 2) + 1) - log(2)
    return {item: 0.05 + (log(len(sets) + 1) - log(max(count, 2))) / most for item, count in counts.items()}


def _share(
    shared: set[int] | set[str], here: set[int] | set[str], there: set[int] | set[str], weights: dict[object, float]
) -> float:
    smaller = min(sum(weights[item] for item in items) for items in (here, there))
    return round(sum(weights[item] for item in shared) / smaller, 3) if smaller else 0.0


STYLE = (
    f'{PAGE}\n'
    """
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em; }
td, th { text-align: left; vertical-align: top; padding: .15em 1.2em .15em 0; }
.side { display: grid; grid-template-columns: 1fr 1fr; gap: 1em; } pre { overflow-x: auto; margin: 0; }
mark { color: inherit; background: var(--mark); } .same { background: var(--same); }
"""
)
WORDS = (
    'These submissions have more in common than the task and the class explain. The comparison ignores names, comments, '
    'strings and numbers. Marked lines are alike. Similarity is a reason to look and to ask, and not a proof.'
)
MOST_PAIRS = 100
MOST_LINES = 2000


def similar_page(exercise: str, pairs: Sequence[Pair]) -> str:
    """Return the page with all pairs. Strings of students never become markup."""
    rows = [table_row('pair', 'code', 'launch graph', kind='th')]
    for number, pair in enumerate(pairs[:MOST_PAIRS]):
        link = element('a', f'{pair.one.student} and {pair.two.student}', href=f'#p{number}')
        rows.append(table_row(link, f'{pair.code:.0%}', f'{pair.graph:.0%}'))
    parts = [element('h1', f'Alike: {exercise}'), element('p', WORDS), element('table', *rows)]
    parts += [_section(pair, number) for number, pair in enumerate(pairs[:MOST_PAIRS])]
    return html_page(f'edugrade similar: {exercise}', STYLE, *parts)


def _section(pair: Pair, number: int) -> Markup:
    both = set(pair.one.graph) & set(pair.two.graph)
    sides = [
        element('div', element('h3', work.path), *_texts(work, pair.shared), _graph(work, both)) for work in (pair.one, pair.two)
    ]
    title = f'{pair.one.student} and {pair.two.student}: code {pair.code:.0%}, launch graph {pair.graph:.0%}'
    return element('section', element('h2', title), element('div', *sides, class_='side'), id=f'p{number}')


def _texts(work: Work, shared: frozenset[int]) -> list[Markup]:
    """Return the files that contain shared code, with the shared lines marked."""
    found = []
    for name, code in work.texts.items():
        marked = {line for number, (first, last) in code.prints.items() if number in shared for line in range(first, last + 1)}
        if marked:
            found += [element('h4', name), element('pre', *_lines(code, marked))]
    return found


def _lines(code: Code, marked: set[int]) -> list[Markup]:
    lines = []
    for number, line in zip_longest(range(1, min(len(code.lines), MOST_LINES) + 1), code.lines[:MOST_LINES]):
        text = f'{number:4} {line}'
        lines.append(Markup((element('mark', text) if number in marked else element('span', text)) + '\n'))
    return lines


def _graph(work: Work, both: set[str]) -> Markup:
    rows = [element('li', line, class_='same' if line in both else '') for line in work.graph]
    return element('details', element('summary', f'launch graph, {len(work.graph)} lines'), element('ul', *rows))


LONGEST_READING_S = 20.0  # time limit for the fingerprints of one submission


def similar_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade similar``."""
    parser = argparse.ArgumentParser(
        prog='edugrade similar', description='Show submissions that are more alike than the task explains.'
    )
    parser.add_argument('results', metavar='RESULTS', help='the folder that edugrade batch has written')
    parser.add_argument('--exercise', metavar='NAME', help='the exercise (default: all of them)')
    parser.add_argument(
        '--least', type=_percent, default=0.6, metavar='PERCENT', help='least percentage of common code (default: 60)'
    )
    parser.add_argument('--html', metavar='FILE', help='also write the pairs side by side')
    return parser


def main(words: Sequence[str]) -> int:
    """Print the pairs, and write the page on request. The exit code is always 0, because similarity is not a verdict."""
    options = similar_parser().parse_args(words)
    results = [result for result in Store(options.results).all() if 'rubric' in result]
    names = sorted({result['rubric']['name'] for result in results})
    if options.exercise is not None and options.exercise not in names:
        raise UnusableInput(f'there are no results of {options.exercise}', help=f'choose one of {", ".join(names)}')
    pages, lines = [], []
    for name in [options.exercise] if options.exercise else names:
        works, lost = _works([result for result in results if result['rubric']['name'] == name], options.results)
        pairs = alike(works, _handed_out(name), options.least)
        pages.append(similar_page(name, pairs))
        count = f'{len(works)} submissions, {len(pairs)} pairs with at least {options.least:.0%} of their code in common'
        lines += [f'{name}: {count}', *map(_line, pairs)]
        if lost:
            lines.append('  not found with the graded content: ' + ', '.join(lost))
    if options.html is not None:  # first, because a reader of the output may stop early (``| head``)
        write_whole(options.html, '\n'.join(pages))
    print('\n'.join(map(printable, lines)) or f'there are no results in {options.results}')
    return 0


def _line(pair: Pair) -> str:
    return f'  {pair.code:4.0%} code {pair.graph:4.0%} launch graph  {pair.one.path}  {pair.two.path}'


def _works(results: Sequence[dict[str, Any]], folder: str) -> tuple[list[Work], list[str]]:
    """Return the submissions with their files, and the paths of the submissions whose files no longer exist."""
    works, lost = [], []
    for result in results:
        try:
            submission = Submission(find_submission(result, os.path.join(folder, f'{result["path"]}.json')))
        except UnusableInput:
            lost.append(str(result['path']))
            continue
        try:
            with cpu_limit(LONGEST_READING_S):
                texts = _codes(submission)
        except TooLong:  # the file was written to be slow to compare
            lost.append(str(result['path']))
            continue
        works.append(Work(result['student'], result['path'], texts, tuple(map(str, result.get('graph') or ()))))
    return works, lost


def _codes(submission: Submission) -> dict[str, Code]:
    return {name: fingerprints(text) for name, text in submission.source.texts().items()}


def _handed_out(name: str) -> set[int]:
    """Return the fingerprints of the starter file, if the course is in this folder."""
    try:
        manifest = find_course(os.getcwd())
        entry = next((entry for entry in read_course(manifest) if entry.name == name), None)
        places = [os.path.join(os.path.dirname(manifest), *inside) for inside in ((), ('exercises',))]
        for place in places:
            path = os.path.join(place, entry.path) if entry else ''
            if os.path.exists(path):
                return {number for code in _codes(Submission(path)).values() for number in code.prints}
    except UnusableInput:
        pass
    return set()


def _percent(text: str) -> float:
    try:
        percent = float(text.rstrip('%'))
    except ValueError:
        percent = -1.0
    if not 0 <= percent <= 100:
        raise argparse.ArgumentTypeError(f'{text} is not a number from 0 to 100')
    return percent / 100
