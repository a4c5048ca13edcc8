"""The pages and anchors in `docs/advice/` that describe the rules.

This module assigns rules to pages by their group, by the kind of thing that they check, and by the beginning of their names. So
the address of a rule changes only when the rule is renamed, or when a page has become too long and is split.
"""

from __future__ import annotations

from typing import NamedTuple

from edulaunch.advice.rule import KINDS, Rule, rules_over


class ReferencePage(NamedTuple):
    """One page of the reference.

    :ivar name: the name of the page's file in `docs/advice/`, without the suffix.
    :ivar kinds: the kinds of things that the rules on this page check.
    :ivar first: the beginning of the first rule's name after the group, such as 'a' or 'no-l'.
    :ivar last: the beginning of the last rule's name after the group.
    """

    name: str
    group: str
    kinds: tuple[str, ...]
    first: str = 'a'
    last: str = 'z'

    def has(self, rule: Rule, kind: str) -> bool:
        """Return whether a rule is on this page.

        :param rule: the rule.
        :param kind: the kind of thing that the rule checks.
        """
        name = rule.name.partition('.')[2]
        return rule.group == self.group and kind in self.kinds and self.first <= name and name[: len(self.last)] <= self.last


def _pages(name: str, group: str, kinds: tuple[str, ...], *ranges: str) -> tuple[ReferencePage, ...]:
    """Return a page for each range of first letters, such as 'a e', or 'n' for a single letter."""
    return tuple(
        ReferencePage(f'{name}-{letters.replace(" ", "-")}', group, kinds, letters.split()[0], letters.split()[-1])
        for letters in ranges
    )


PAGES = (
    *_pages('launch-errors', 'launch', ('errors',), 'a e', 'f i', 'j m', 'n', 'o p', 'q t', 'u z'),
    *_pages('launch-files', 'launch', ('plans',), 'a m', 'n z'),
    *_pages('launch-runs', 'launch', ('recordings', 'scripts'), 'a d', 'e m', 'n r', 's z'),
    *_pages('programs-errors', 'programs', ('errors',), 'a c', 'd i', 'j m', 'n no-k', 'no-l n', 'o r', 's z'),
    *_pages('programs-runs', 'programs', ('recordings', 'plans', 'sources'), 'a d', 'e f', 'g m', 'n', 'o p', 'q z'),
    ReferencePage('messages-errors', 'messages', ('errors',)),
    *_pages('messages-runs', 'messages', ('recordings',), 'a n', 'o z'),
    *_pages('packages-errors', 'packages', ('errors',), 'a m', 'n z'),
    *_pages('packages-files', 'packages', ('sources',), 'a m', 'n z'),
    ReferencePage('packages-workspaces', 'packages', ('workspaces',)),
    *_pages('tf', 'tf', KINDS, 'a l', 'm r', 's z'),
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
    """Return the anchor of a rule on its page.

    The anchor is the name without the dot, which Markdown renderers create from the heading.
    """
    return rule.name.replace('.', '')


def address_of(rule: Rule) -> str | None:
    """Return the address of a rule's description in the repository, such as `docs/advice/tf-a-l.md#tflate-lookup`. Return None
    for a rule of a plug-in.
    """
    page = page_of(rule)
    return f'docs/advice/{page.name}.md#{anchor_of(rule)}' if page else None
