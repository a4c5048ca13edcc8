"""Each rule has one page and one anchor, and `edulaunch explain` names both."""

from __future__ import annotations

import re

import pytest

from edulaunch.advice.reference import PAGES, address_of, anchor_of, page_of
from edulaunch.advice.rule import KINDS, Rule, all_rules, rules_over
from edulaunch.desk.commands import edulaunch
from tests.advice.page import DOCS


def test_each_rule_is_on_exactly_one_page() -> None:
    kinds = {rule.name: kind for kind in KINDS for rule in rules_over(kind)}
    found = {name: [page.name for page in PAGES if page.has(rule, kinds[name])] for name, rule in all_rules().items()}
    assert {name: pages for name, pages in found.items() if len(pages) != 1} == {}


def test_each_address_leads_to_the_heading_of_its_rule() -> None:
    for rule in all_rules().values():
        file, _, anchor = str(address_of(rule)).partition('#')
        headings = re.findall(r'^## (.+)$', (DOCS.parent / file).read_text('utf-8'), re.M)
        assert rule.name in headings
        assert re.sub(r'[^\w-]', '', rule.name) == anchor == anchor_of(rule)  # how mkdocs and GitHub make anchors


def test_a_rule_of_a_plug_in_has_no_page() -> None:
    def look(seen: object) -> list[object]:
        return []

    look.__module__ = 'ferry.rules'
    rule = Rule('programs.two-ferries', look, ('x',), ('x',), ('x',), None, 'error', 'stated', ())  # type: ignore[arg-type]
    assert page_of(rule) is None and address_of(rule) is None


def test_explain_names_the_page(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('sys.argv', ['edulaunch', 'explain', 'tf.unknown-frame'])
    assert edulaunch() == 0
    assert '  page:   docs/advice/tf-s-z.md#tfunknown-frame\n' in capsys.readouterr().out
