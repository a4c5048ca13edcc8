"""`edulaunch explain RULE`: show the cause, an example and the fix of a rule of advice."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator

from edulaunch.advice import rule as rule_module
from edulaunch.advice.reader import Reader, reader_here
from edulaunch.advice.reference import address_of
from edulaunch.advice.rule import GROUPS, Rule, all_rules
from edulaunch.engine.nearest import nearest
from edulaunch.errors import UnusableInput

_RULE = re.compile(rf'({"|".join(GROUPS)})\.[a-z][a-z0-9-]*')
_FACT = re.compile(r'\{(\w+)\}')
EXAMPLES = os.path.join(os.path.dirname(rule_module.__file__), 'examples.json')
"""For each rule, the example of `tests/advice/examples`: the difference from the correct file, and the report."""


def is_rule(word: str) -> bool:
    """Return whether a word has the form of a rule's name and is not a file."""
    return _RULE.fullmatch(word) is not None and not os.path.exists(word)


def explain_rule(name: str) -> int:
    """Print what a rule reports, why that matters, what to do, and an example with its fix. Return the exit code 0.

    :param name: the name of the rule, such as 'programs.after-shutdown'.
    :raises UnusableInput: for an unknown rule. The message suggests the most similar rule or the rules of the same group.
    """
    rules = all_rules()
    if name not in rules:
        near = nearest(name, rules)
        group = [other for other in rules if other.partition('.')[0] == name.partition('.')[0]]
        raise UnusableInput(f'there is no rule {name!r}', help=f'write {near}' if near else f'choose one of: {", ".join(group)}')
    print('\n'.join(_lines(rules[name], reader_here())).encode(errors='backslashreplace').decode())
    return 0


def _lines(rule: Rule, reader: Reader) -> Iterator[str]:
    yield f'{rule.name} ({rule.level})'
    for label, templates in (('what', rule.what), ('why', rule.why), ('do', rule.do)):
        for number, template in enumerate(templates):
            heading = '  or' if number else 'what:' if label == 'what' else f'{reader.says(label)}:'
            yield f'  {heading:<8}{readable(reader.says(template))}'
    if rule.lesson:
        yield f'  see:    lessons/{rule.lesson}.ipynb'
    if address := address_of(rule):
        yield f'  page:   {address}'
    example = _example(rule.name)
    if example is not None:
        yield ''
        yield 'Example (lines with - are the mistake, lines with + are the fix):'
        yield ''
        yield from (f'  {line}' for line in example.splitlines())


def readable(template: str) -> str:
    """Return the template of a rule's message in readable form. Each fact appears as <fact>."""
    return _FACT.sub(r'<\1>', template).replace('{{', '{').replace('}}', '}')


def _example(name: str) -> str | None:
    with open(EXAMPLES, encoding='utf-8') as file:
        found: str | None = json.load(file).get(name)
    return found
