"""A finding in words, in the reader's language: the only place of the house where facts become sentences of advice."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import cache
from gettext import NullTranslations
from string import Formatter
from typing import Any, NamedTuple

from edulaunch.advice.finding import Finding
from edulaunch.advice.registry import rule_named

LOCALE = os.path.join(os.path.dirname(__file__), 'locale')


class Told(NamedTuple):
    """The sentences of a finding; `why` is '' where the rule gives no reason, `where` where no place is known."""

    what: str
    where: str
    why: str
    do: str
    lesson: str | None


def told(finding: Finding) -> Told:
    """What is wrong, where, why that matters, and what to do."""
    rule = rule_named(finding.rule)
    facts = {**finding.facts, finding.kind: finding.name}
    return Told(_worded(rule.what, facts), place(finding), _worded(rule.why, facts), _worded(rule.do, facts), rule.lesson)


def translated(text: str) -> str:
    """A sentence of ours in the language that `EDULAUNCH_LANG` names (default: English, as it is written)."""
    language = os.environ.get('EDULAUNCH_LANG', '').partition('.')[0]
    return _catalogue(language).gettext(text) if language and text else text


@cache
def _catalogue(language: str) -> NullTranslations:
    from gettext import translation

    return translation('advice', LOCALE, [language, language.partition('_')[0]], fallback=True)


def place(finding: Finding) -> str:
    """File and line, and the simulated time: 'follow.launch.py:12, at 0.50 s'."""
    where = '' if finding.file is None else finding.file if finding.line is None else f'{finding.file}:{finding.line}'
    when = '' if finding.time_s is None else translated('at {time:.2f} s').format(time=finding.time_s)
    return ', '.join(filter(None, (where, when)))


def _worded(templates: Sequence[str], facts: dict[str, Any]) -> str:
    """The first of the templates whose facts are all known, with the facts in it; '' when there is none."""
    for template in templates:
        if all(facts.get(name) not in (None, [], ()) for name in fields(template)):
            return translated(template).format_map({name: _listed(value) for name, value in facts.items()})
    return ''


def fields(template: str) -> list[str]:
    """Names of the facts in a template."""
    return [name for _, name, _, _ in Formatter().parse(template) if name]


def _listed(value: Any) -> Any:
    return ', '.join(map(str, value)) if isinstance(value, (list, tuple)) else value
