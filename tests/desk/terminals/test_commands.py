"""Every command of the tutorials, typed into real terminals; `docs/commands.md` and `docs/from_a_tutorial.md` say how it goes.

After a change: `python -m tests.desk.terminals.report` writes both pages anew.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.terminals.pages import Page, pages
from tests.desk.terminals.report import DOCS, documents
from tests.desk.terminals.shop import SEEDS, Shop


@pytest.mark.terminals
@pytest.mark.parametrize('page', list(pages()), ids=lambda page: page.title)
def test_the_page_can_be_followed(page: Page, tmp_path: Path) -> None:
    if page.seed and not SEEDS.is_dir():
        pytest.skip('the files of the seed tutorials are not here (../shared/seeds)')
    shop = Shop(tmp_path, page)
    try:
        for step in page.steps:
            if not step.why or step.type or step.shows:
                shop.do(step)
    finally:
        shop.desk.close()


def test_the_pages_have_every_command_of_the_seed_tutorials() -> None:
    if not SEEDS.is_dir():
        pytest.skip('the files of the seed tutorials are not here (../shared/seeds)')
    wanted = [tuple(line.split('\t')) for line in (SEEDS / 'commands.txt').read_text(encoding='utf-8').splitlines()]
    there = {(page.seed, step.says) for page in pages() for step in page.steps}
    assert [row for row in wanted if row not in there] == []


def test_the_documents_say_what_was_tried() -> None:
    for name, text in documents().items():
        assert (DOCS / name).read_text(encoding='utf-8') == text, 'python -m tests.desk.terminals.report writes it'
