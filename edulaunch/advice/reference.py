"""The page of `docs/advice/` and the anchor where the documentation describes each rule of advice.

The pages are fixed here, by the group of a rule, what it looks at, and the first letter of its name. The address of a rule
therefore changes only when the rule is renamed.
"""

from __future__ import annotations

from typing import NamedTuple

from edulaunch.advice.rule import KINDS, Rule, rules_over


class ReferencePage(NamedTuple):
    """One page of the reference.

    :ivar name: its file in `docs/advice/`, without the suffix.
    :ivar kinds: the kinds of things that its rules look at.
    :ivar letters: the first and the last letter with which the names of its rules begin, after the group, or one letter.
    """

    name: str
    group: str
    kinds: tuple[str, ...]
    letters: str = 'az'

    def has(self, rule: Rule, kind: str) -> bool:
        """Return whether a rule that looks at `kind` is on this page."""
        first = rule.name.partition('.')[2][0]
        return rule.group == self.group and kind in self.kinds and self.letters[0] <= first <= self.letters[-1]


def _pages(name: str, group: str, kinds: tuple[str, ...], *ranges: str) -> tuple[ReferencePage, ...]:
    """Return a page for each range of first letters, such as 'ae' or 'n'."""
    return tuple(ReferencePage(f'{name}-{"-".join(letters)}', group, kinds, letters) for letters in ranges)


PAGES = (
    *_pages('launch-errors', 'launch', ('errors',), 'ae', 'fi', 'jm', 'n', 'ot', 'uz'),
    *_pages('launch-files', 'launch', ('plans',), 'am', 'nz'),
    *_pages('launch-runs', 'launch', ('recordings', 'scripts'), 'ao', 'pz'),
    *_pages('programs-errors', 'programs', ('errors',), 'ac', 'di', 'jm', 'n', 'or', 'sz'),
    *_pages('programs-runs', 'programs', ('recordings', 'plans', 'sources'), 'ad', 'em', 'np', 'qz'),
    ReferencePage('messages-errors', 'messages', ('errors',)),
    *_pages('messages-runs', 'messages', ('recordings',), 'an', 'oz'),
    ReferencePage('packages-errors', 'packages', ('errors',)),
    *_pages('packages-files', 'packages', ('sources',), 'am', 'nz'),
    ReferencePage('packages-workspaces', 'packages', ('workspaces',)),
    *_pages('tf', 'tf', KINDS, 'al', 'mr', 'sz'),
    ReferencePage('time', 'time', KINDS),
    ReferencePage('turtlesim', 'turtlesim', KINDS),
    ReferencePage('grader', 'grader', KINDS),
)


def page_of(rule: Rule) -> ReferencePage | None:
    """Return the page that describes a rule, or None for a rule of a plug-in."""
    kind = next((kind for kind in KINDS if rule in rules_over(kind)), '')
    if not rule.look.__module__.startswith('edulaunch.'):
        return None
    return next((page for page in PAGES if page.has(rule, kind)), None)


def anchor_of(rule: Rule) -> str:
    """Return the anchor of a rule on its page: its name without the dot, as Markdown readers make it from the heading."""
    return rule.name.replace('.', '')


def address_of(rule: Rule) -> str | None:
    """Return where the repository describes a rule, such as `docs/advice/tf-a-l.md#tflate-lookup`, or None."""
    page = page_of(rule)
    return f'docs/advice/{page.name}.md#{anchor_of(rule)}' if page else None
