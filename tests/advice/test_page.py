"""docs/advice.md is what the rules and their examples say today."""

from __future__ import annotations

from tests.advice.page import PAGE, page


def test_the_page_is_up_to_date() -> None:
    assert PAGE.read_text(encoding='utf-8') == page(), 'python -m tests.advice.page writes it anew'
