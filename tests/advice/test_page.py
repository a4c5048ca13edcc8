"""docs/advice.md is what the rules and their examples say today."""

from __future__ import annotations

from edulaunch.advice.rule import all_rules
from tests.advice.page import PAGE, SHOWN, examples, page


def test_the_page_is_up_to_date() -> None:
    assert PAGE.read_text(encoding='utf-8') == page(), 'python -m tests.advice.page writes it anew'


def test_the_examples_of_explain_are_up_to_date() -> None:
    assert SHOWN.read_text(encoding='utf-8') == examples(), 'python -m tests.advice.page writes them anew'


def test_the_lessons_that_rules_name_are_there() -> None:
    lessons = {file.stem for file in (PAGE.parents[1] / 'lessons').glob('*.ipynb')}
    assert {rule.lesson for rule in all_rules().values()} - {None} <= lessons
