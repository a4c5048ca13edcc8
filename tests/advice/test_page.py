"""The pages on advice are what the rules and their examples say today."""

from __future__ import annotations

from edulaunch.advice.rule import all_rules
from tests.advice.page import DOCS, SHOWN, documents, examples


def test_the_pages_are_up_to_date() -> None:
    written = documents()
    assert sorted(path.name for path in (DOCS / 'advice').glob('*.md')) == sorted(name[7:] for name in written if '/' in name)
    for name, text in written.items():
        assert (DOCS / name).read_text(encoding='utf-8') == text, 'python -m tests.advice.page writes it'


def test_the_examples_of_explain_are_up_to_date() -> None:
    assert SHOWN.read_text(encoding='utf-8') == examples(), 'python -m tests.advice.page writes them'


def test_the_lessons_that_rules_name_are_there() -> None:
    lessons = {file.stem for file in (DOCS.parent / 'lessons').glob('*.ipynb')}
    assert {rule.lesson for rule in all_rules().values()} - {None} <= lessons
