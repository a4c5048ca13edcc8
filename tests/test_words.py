"""Plain English in what people read: sentence length, chains, banned phrases, passives without an agent, readability, spelling.

A file that is not clean yet has its counts in `tests/words.toml`; they may only fall. `python -m tests.words FILE` prints the
findings of a file, and `python -m tests.words` lowers the counts.
"""

from __future__ import annotations

import io
import os
from contextlib import redirect_stdout
from pathlib import Path

import pytest
from codespell_lib import main as codespell

from tests.house import ROOT, modules, wing
from tests.words import (
    Text,
    allowed,
    comments,
    counted,
    files,
    in_text,
    lix,
    markdown,
    problems,
    python,
    sentences,
    table,
    tree,
    unreadable,
)

PARTS = {
    'the pages': lambda path: path.suffix == '.md' and 'lessons' not in path.parts,
    'the lessons': lambda path: 'lessons' in path.parts,
    **{
        of_wing: lambda path, of_wing=of_wing: path in {file for name, file in modules().items() if wing(name) == of_wing}
        for of_wing in sorted({wing(name) for name in modules()})
    },
}
SPELLING = ROOT / 'tests' / 'spelling.txt'
BAD = {
    'length': 'The node ' + 'waits and ' * 12 + 'ends.',
    'chain': 'It has two parts: the first; the second.',
    'phrase': 'The report tells which argument is unknown.',
    'passive': 'The students are shown what they typed.',
}
GOOD = (
    'The node waits, and then it ends.',
    'It has two parts: the first and the second.',
    'The report names the unknown argument.',
    'The picture is shown in the sidebar.',
    'When no argument is given, the default holds.',
    'The marks are given by the teacher.',
)


@pytest.mark.parametrize('part', PARTS)
def test_no_file_has_more_findings_than_the_table_allows(part: str) -> None:
    more = []
    for path in filter(PARTS[part], files()):
        grown = counted(path) - allowed(path)
        name = path.relative_to(ROOT).as_posix()
        more += [
            f'{name}:{found.line}: {found.rule} ({counted(path)[found.rule]}, allowed {allowed(path)[found.rule]}): {found.advice}\n    {found.sentence}'
            for found in problems(path)
            if grown[found.rule]
        ]
    assert not more, 'rewrite these (if you renamed a file, run python -m tests.words):\n' + '\n'.join(more)


@pytest.mark.skipif(
    'EDULAUNCH_THOROUGH' not in os.environ, reason='the counts are lowered once for a release or in CI, not with each edit'
)
def test_the_counts_of_the_table_are_those_of_today() -> None:
    known = {path.relative_to(ROOT).as_posix() for path in files()}
    slack = [path.name for path in files() if allowed(path) - counted(path)]
    assert slack + sorted(set(table()['not_yet_clean']) - known) == [], 'python -m tests.words lowers them'


@pytest.mark.parametrize('rule', BAD)
def test_each_rule_finds_its_mistake(rule: str) -> None:
    assert rule in [found.rule for found in in_text(Text(1, BAD[rule]))]


@pytest.mark.parametrize('sentence', GOOD)
def test_good_sentences_pass(sentence: str) -> None:
    assert list(in_text(Text(1, sentence))) == []


def test_each_banned_phrase_has_a_replacement() -> None:
    assert all(len(instead) > 3 for instead in table()['phrases'].values())


def test_hard_pages_are_found() -> None:
    hard = [
        Text(
            1,
            'Notwithstanding considerable infrastructural heterogeneity, institutions systematically underestimate requirements.',
        )
    ] * 20
    assert unreadable(hard) and not unreadable([Text(1, 'A node waits for a message.')] * 40)
    assert lix('The cat sat. The dog ran.') == 3


def test_markdown_is_read_by_paragraph_item_and_cell() -> None:
    page = '# A title\nOne line\nand `code`.\n\n```\nshall\n```\n- [item](a.md)\n  goes on\n\n| a cell | `x|y` |\n|---|---|\n'
    assert [text.words for text in markdown(page)] == ['A title', 'One line and Code.', 'item goes on', 'a cell', 'Code']
    assert sentences('One. Two (e.g. this). Three?') == ['One.', 'Two (e.g. this).', 'Three?']


def test_docstrings_help_and_advice_are_read(tmp_path: Path) -> None:
    source = 'def f():\n    """It goes on.\n\n    :param x: a text\n    """\nrule("a.b", what="{x} shall", do=("no", f"tell {y}"))\nadd(help="anew")\nMOST = 3\n"""So many."""\n'
    (tmp_path / 'some.py').write_text(source)
    assert sorted(text.words for text in python(tree(tmp_path / 'some.py'))) == [
        'Code shall',
        'It goes on.',
        'So many.',
        'a text',
        'anew',
        'no',
        'tell Code',
    ]


def test_comments_are_read_and_lines_below_each_other_are_one_text() -> None:
    source = 'one = 1  # so many\n# first part,\n# second part\n\n# apart\n'
    assert [(text.line, text.words) for text in comments(source)] == [
        (1, 'so many'),
        (2, 'first part, second part'),
        (5, 'apart'),
    ]


def test_the_spelling_is_right() -> None:
    """Codespell knows common misspellings; `tests/spelling.txt` has the words that we mean."""
    said = io.StringIO()
    skipped = '*.json,*.po,*.toml,*.png,*.gif,*.css,*.js,*/advice/*,*/__pycache__/*'
    places = [ROOT / name for name in ('README.md', 'CHANGELOG.md', 'docs', 'lessons', 'edulaunch', 'grader')]
    with redirect_stdout(said):
        wrong = codespell('--quiet-level', '3', '--ignore-words', str(SPELLING), '--skip', skipped, *map(str, places))
    assert not wrong, said.getvalue()


def test_a_misspelling_is_found(tmp_path: Path) -> None:
    (tmp_path / 'page.md').write_text('The nodes recieve messages.\n')
    with redirect_stdout(io.StringIO()) as said:
        assert codespell('--ignore-words', str(SPELLING), str(tmp_path / 'page.md'))
    assert 'recieve ==> receive' in said.getvalue()
