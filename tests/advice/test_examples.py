"""Each rule speaks on its failing example, first and in the golden words, and is silent on the healthy one."""

from __future__ import annotations

import pytest

from edulaunch.advice import rendered
from edulaunch.advice.rule import all_rules
from tests.advice.harness import EXAMPLES, WITHOUT, findings, told_text

RULES = [name for name in all_rules() if name not in WITHOUT]

pytestmark = pytest.mark.filterwarnings('ignore::UserWarning')  # a student's program warns and goes on


@pytest.mark.parametrize('rule', RULES)
def test_a_rule_speaks_first_on_its_failing_example(rule: str) -> None:
    found = findings(rule, 'failing')
    assert [one.rule for one in found][:1] == [rule]
    assert all(words.what and words.do for words in map(rendered, found)), 'a fact that the sentence needs is missing'
    assert told_text(rule, found) == (EXAMPLES / rule / 'told.txt').read_text(encoding='utf-8')


@pytest.mark.parametrize('rule', RULES)
def test_nobody_speaks_on_its_healthy_example(rule: str) -> None:
    assert findings(rule, 'healthy') == []


def test_every_example_belongs_to_a_rule() -> None:
    assert {path.name for path in EXAMPLES.iterdir() if path.is_dir()} <= set(RULES)
