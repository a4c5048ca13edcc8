"""What a machine can check of our English: README, docs, lessons, advice, help texts and docstrings, sentence by sentence.

`python -m tests.words FILE...` prints the findings of some files; without a file it lowers the counts of `tests/words.toml` to
what is true today. It never raises one.
"""

from __future__ import annotations

import ast
import io
import json
import re
import sys
import tokenize
from collections import Counter
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from tests.house import ROOT, modules, tree

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TABLE = ROOT / 'tests' / 'words.toml'
WORDS_IN_A_SENTENCE = 25
READABILITY = 32
"""The largest LIX of a page or lesson: words per sentence, plus the percentage of words of seven letters and more. Pages of code and names have short words, so 32 is a lot."""
GENERATED = ('advice', 'commands/')
"""Pages of docs/ that are made of texts which are checked where they are written."""
PROSE = ('README.md', 'SECURITY.md', 'CODE_OF_CONDUCT.md')
TEMPLATES = ('what', 'why', 'do')
HELP = ('help', 'description', 'epilog')


class Text(NamedTuple):
    """A paragraph, heading, list item, table cell, docstring or help text, without code."""

    line: int
    words: str


class Problem(NamedTuple):
    """A sentence that an editor would send back, and the rule that says so."""

    line: int
    rule: str
    advice: str
    sentence: str


@cache
def table() -> dict[str, Any]:
    """The content of `tests/words.toml`: banned phrases, and what is not yet clean."""
    with TABLE.open('rb') as file:
        return tomllib.load(file)


@cache
def phrases() -> tuple[re.Pattern[str], list[tuple[re.Pattern[str], str]]]:
    """All banned phrases in one pattern, and each one with what to write instead."""
    wanted = table()['phrases']
    return re.compile(rf'\b(?:{"|".join(wanted)})\b', re.I), [
        (re.compile(rf'\b(?:{old})\b', re.I), new) for old, new in wanted.items()
    ]


def files() -> list[Path]:
    """Every file with English that people read."""
    docs = [
        path
        for path in sorted((ROOT / 'docs').rglob('*.md'))
        if not path.relative_to(ROOT / 'docs').as_posix().startswith(GENERATED)
    ]
    lessons = [*sorted((ROOT / 'lessons').glob('*.ipynb')), *sorted((ROOT / 'lessons' / 'notes').glob('*.md'))]
    return [*(ROOT / name for name in PROSE), *docs, *lessons, *modules().values()]


@cache
def problems(path: Path) -> list[Problem]:
    """Return the findings in one file, first line first."""
    found = [problem for text in texts(path) for problem in in_text(text)]
    if path.suffix == '.ipynb' or path.parent == ROOT / 'docs' or path.name == 'README.md':
        found += unreadable(texts(path))
    return found


def texts(path: Path) -> list[Text]:
    """Return the English of a file: a page, a notebook or a Python file."""
    if path.suffix == '.ipynb':
        cells = json.loads(path.read_text(encoding='utf-8'))['cells']
        return [text for cell in cells if cell['cell_type'] == 'markdown' for text in markdown(''.join(cell['source']))]
    source = path.read_text(encoding='utf-8')
    return [*python(tree(path)), *comments(source)] if path.suffix == '.py' else list(markdown(source))


def markdown(source: str) -> Iterator[Text]:
    """Yield the paragraphs, headings, list items and table cells of Markdown; code is left out."""
    held: list[str] = []
    start, fence = 1, ''
    for number, line in enumerate([*source.split('\n'), ''], 1):
        mark = re.match(r'\s*(```+|~~~+)', line)
        if mark and (not fence or mark[1].startswith(fence)):
            fence = '' if fence else mark[1]
        elif not fence and line.startswith('|'):
            if not re.fullmatch(r'[|\s:-]+', line):
                cells = (
                    re.sub(r'`[^`]*`', lambda code: code[0].replace('|', '/'), line.replace(r'\|', '/'))
                    .strip()
                    .strip('|')
                    .split('|')
                )
                yield from (Text(number, plain(cell)) for cell in cells)
        elif not fence and line.strip() and not re.match(r'\s*([-*+]|\d+\.|#+|>|:::|<)(\s|$)', line) and not line.startswith('<'):
            start = start if held else number
            held.append(line)
            continue
        if held:
            yield Text(start, plain(' '.join(held)))
            held = []
        begun = re.match(r'\s*(?:[-*+]|\d+\.|#+|>)\s+(.*)', line)
        if begun and not fence and not mark:
            start, held = number, [begun[1]]
            if line.lstrip().startswith('#'):
                yield Text(number, plain(begun[1]))
                held = []


def plain(text: str) -> str:
    """Return a text without links, emphasis and code, where each piece of code is one word."""
    text = re.sub(r'!\[[^\]]*\]\([^)]*\)', '', text)
    text = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', text)
    text = re.sub(r'``[^`]+``|`[^`]+`|\$[^$]+\$', 'Code', text)
    text = re.sub(r'<[^>]+>|\*\*|__|(?<!\w)\*|\*(?!\w)', '', text)
    return ' '.join(text.split())


def python(module: ast.Module) -> Iterator[Text]:
    """Yield the docstrings of a file, also those below its constants, the templates of its rules, and the help texts of its commands."""
    for node in ast.walk(module):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str):
            yield from docstring(node.lineno, node.value.value)
        elif isinstance(node, ast.Call):
            is_rule = isinstance(node.func, ast.Name) and node.func.id == 'rule'
            for keyword in node.keywords:
                if keyword.arg in (TEMPLATES if is_rule else HELP):
                    yield from (Text(line, plain(words)) for line, words in strings(keyword.value))


def comments(source: str) -> Iterator[Text]:
    """Yield the comments of a file. Comment lines below each other are one text."""
    held: list[tuple[int, bool, str]] = []
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        if token.type == tokenize.COMMENT:
            line, alone = token.start[0], not token.line[: token.start[1]].strip()
            if held and not (alone and held[-1][:2] == (line - 1, True)):
                yield Text(held[0][0], plain(' '.join(words for _, _, words in held)))
                held = []
            held.append((line, alone, token.string.lstrip('#! ')))
    if held:
        yield Text(held[0][0], plain(' '.join(words for _, _, words in held)))


def docstring(line: int, text: str) -> Iterator[Text]:
    """Yield the paragraphs and fields of a docstring; indented blocks after `::` and examples are left out."""
    start, held = line, list[str]()
    is_code = False
    for number, words in enumerate([*text.split('\n'), ''], line):
        stripped = words.strip()
        is_code = (is_code and (not stripped or words.startswith('        '))) or stripped.startswith('>>>')
        if is_code or not stripped or re.match(r':\w+[^:]*:|[-*] |\d+\. ', stripped):
            if held:
                yield Text(start, plain(' '.join(held)))
            start, held = number, []
        if stripped and not is_code:
            held.append(re.sub(r'^:\w+[^:]*:\s*|^[-*] |^\d+\. ', '', stripped))
        is_code = is_code or stripped.endswith('::')


def strings(node: ast.expr) -> Iterator[tuple[int, str]]:
    """Yield the strings of an expression; what an f-string fills in becomes one word."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.lineno, re.sub(r'\{[^{}]*\}', 'Code', node.value)
    elif isinstance(node, ast.JoinedStr):
        yield node.lineno, ''.join(str(part.value) if isinstance(part, ast.Constant) else 'Code' for part in node.values)
    elif isinstance(node, ast.Tuple | ast.List):
        for item in node.elts:
            yield from strings(item)


def sentences(text: str) -> list[str]:
    """Split a paragraph into sentences."""
    return [part for part in re.split(r'(?<=[.!?])[)"\']*\s+(?=[("\']?(?:[A-Z0-9]|edulaunch|edugrade))', text) if part.strip()]


def in_text(text: Text) -> Iterator[Problem]:
    """Yield the findings in one text: each sentence is judged alone."""
    for sentence in sentences(text.words):
        count = len(re.findall(r"[\w'/.-]+", sentence))
        if count > WORDS_IN_A_SENTENCE:
            yield Problem(text.line, 'length', f'{count} words: at most {WORDS_IN_A_SENTENCE}, so write two sentences', sentence)
        if len(re.findall(r'[;:](?=\s)', sentence)) > 1:
            yield Problem(text.line, 'chain', 'at most one colon or semicolon: write two sentences, or a list', sentence)
        any_phrase, each_phrase = phrases()
        for pattern, instead in each_phrase if any_phrase.search(sentence) else ():
            if match := pattern.search(sentence):
                yield Problem(text.line, 'phrase', f'{match[0]!r}: {instead}', sentence)
        if match := has_no_agent(sentence):
            yield Problem(text.line, 'passive', f'{match!r}: say who does it, in the active voice', sentence)


def has_no_agent(sentence: str) -> str:
    """Return 'is told', 'is said', 'is given' or 'is shown' if the sentence does not say by whom (or, for 'shown', where)."""
    match = re.search(r'\b(?:is|are|was|were|be|been|being) (?:\w+ly |not |never )?(told|said|given|shown)\b(.*)', sentence, re.I)
    if not match or re.search(r'\bby\b', match[2]):
        return ''
    if match[1] == 'given' and re.search(r'\b(if|when|unless|that|which|where)\b[^,]*$', sentence[: match.start()], re.I):
        return ''
    if match[1] == 'shown' and re.match(r' (in|on|as|at|below|above|under|beside|with|here|only|until|when|to)\b', match[2]):
        return ''
    return match[0][: match.end(1) - match.start()]


def unreadable(all_texts: Iterable[Text]) -> list[Problem]:
    """Return a finding for each point of LIX above `READABILITY`."""
    all_texts = list(all_texts)
    if sum(len(text.words.split()) for text in all_texts) < 150:
        return []
    value = lix(' '.join(text.words if text.words.endswith(('.', '!', '?', ':')) else f'{text.words}.' for text in all_texts))
    advice = f'readability (LIX) {value}, at most {READABILITY}: shorter sentences and shorter words'
    return [Problem(1, 'readability', advice, '')] * max(0, value - READABILITY)


def lix(text: str) -> int:
    """Return the readability index LIX of a text: 30 is easy, 40 medium, 60 very hard."""
    words = re.findall(r"[A-Za-z][A-Za-z'-]*", text)
    ends = len(re.findall(r'[.!?:](?:\s|$)', text))
    return round(len(words) / max(1, ends) + 100 * sum(len(word) > 6 for word in words) / max(1, len(words)))


def counted(path: Path) -> Counter[str]:
    """Return how many findings a file has, by rule."""
    return Counter(problem.rule for problem in problems(path))


def allowed(path: Path) -> Counter[str]:
    """Return how many findings a file may have today, by rule."""
    return Counter(table()['not_yet_clean'].get(path.relative_to(ROOT).as_posix(), {}))


def lower() -> str:
    """Return the text of the table with each count lowered to what is true today; a renamed file keeps its counts."""
    head, mark, _ = TABLE.read_text(encoding='utf-8').partition('[not_yet_clean]\n')
    known = {path.relative_to(ROOT).as_posix(): path for path in files()}
    listed = table()['not_yet_clean']
    gone = {name: Counter(counts) for name, counts in listed.items() if name not in known}
    new = {name: counted(path) for name, path in known.items() if name not in listed and counted(path)}
    pairs = (
        (sum((counts & gone[old]).values()) - sum((counts - gone[old]).values()), name, old)
        for name, counts in new.items()
        for old in gone
    )
    before = {name: Counter(counts) for name, counts in listed.items()}
    for _, name, old in sorted(pairs, reverse=True):
        if name not in before and old in gone:
            before[name] = gone.pop(old)
    left = {name: counted(path) & before.get(name, Counter()) for name, path in sorted(known.items())}
    lines = [
        f'"{name}" = {{{", ".join(f"{rule} = {counts[rule]}" for rule in sorted(counts))}}}\n'
        for name, counts in left.items()
        if counts
    ]
    return head + mark + ''.join(lines)


if __name__ == '__main__':
    if len(sys.argv) == 1:
        TABLE.write_text(lower(), encoding='utf-8')
    for path in (Path(name).resolve() for name in sys.argv[1:]):
        for problem in problems(path):
            sys.stdout.write(
                f'{path.relative_to(ROOT)}:{problem.line}: {problem.rule}: {problem.advice}\n    {problem.sentence}\n'
            )
