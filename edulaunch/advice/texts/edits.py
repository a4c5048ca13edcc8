"""Create the edits that correct a finding, from the edit forms of its rule. There is no edit if the place is not certain."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from typing import Any, NamedTuple

from edulaunch.advice.reader import fields_of
from edulaunch.advice.rule import Finding, rule_named
from edulaunch.advice.texts.text import Span, Text
from edulaunch.engine.nearest import nearest_spelling


class Edit(NamedTuple):
    """A change of a file. `new` replaces the string `old`, which is at `span`.

    :ivar file: the path of the file.
    """

    file: str
    span: Span
    old: str
    new: str


Edits = tuple[Edit, ...]
"""Edits that belong together. The tuple is empty if no edit is certain."""


def written(finding: Finding) -> tuple[str, str, str] | None:
    """Return (old, new, place) of a rule's first edit form whose facts are all known, or None if there is no such form."""
    facts = {**finding.facts, finding.kind: finding.name}
    for old, new, place in rule_named(finding.rule).edits:
        if all(facts.get(name) not in (None, '', [], ()) for name in (*fields_of(old), *fields_of(new))):
            old, new = old.format_map(facts), new.format_map(facts)
            if old != new and (place != 'near' or nearest_spelling(old.strip('.:'), [new.strip('.:')])):
                return old, new, place
    return None


def edits_of(finding: Finding, text: Text, within: Span | None = None) -> Edits:
    """Return the edits of a file that correct a finding.

    :param finding: the finding.
    :param text: the content of the file.
    :param within: the span of the mistake, if more than its line is known.
    """
    form = written(finding)
    if form is None:
        return ()
    old, new, place = form
    if place in INSERTING:
        return INSERTING[place](text, new, finding.facts)
    span = within or (text.extent(finding.line) if finding.line else Span(0, len(text.text)))
    at = text.found(old, span)
    if at is None or (place == 'line' and text.text[at.end : text.whole_line(text.place(at.end).line).end].strip()):
        return ()
    return (Edit(text.path, at, old, new),)


def inserted(text: Text, offset: int, new: str) -> Edit:
    """Return an edit that only inserts a string.

    :param text: the content of the file.
    :param offset: the offset at which the string is inserted.
    :param new: the string.
    """
    return Edit(text.path, Span(offset, offset), '', new)


def _import(text: Text, line: str, facts: dict[str, Any]) -> Edits:
    """Return the edit that adds an import after the last import at the top of the file.

    Without imports, the edit adds it below the docstring and comments.
    """
    tree = text.tree
    if tree is None or line in text.text.splitlines():
        return ()
    last: Any = next((node for node in reversed(tree.body) if isinstance(node, (ast.Import, ast.ImportFrom))), None)
    if last is None and tree.body and isinstance(tree.body[0], ast.Expr):
        last = tree.body[0]
    if last is not None:
        return (inserted(text, text.of_node(last).end, f'\n{line}'),)
    first = tree.body[0].lineno if tree.body else 1
    return (inserted(text, text.whole_line(first).start, f'{line}\n'),)


def _in_list(keyword: str) -> Callable[[Text, str, dict[str, Any]], Edits]:
    def insert(text: Text, new: str, facts: dict[str, Any]) -> Edits:
        """Return the edit that appends an item to a list of setup.py, such as `data_files=[...]` or `console_scripts`."""
        tree = text.tree
        found = None if tree is None or facts.get('move') or facts.get('beside') else _list_of(tree, keyword)
        if tree is None or found is None or new in text.text:
            return ()
        end = text.of_node(found).end - 1
        edits = [_behind_last(text, found, end, new)]
        names = {node.id for node in ast.walk(ast.parse(new)) if isinstance(node, ast.Name)}
        bound = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)}
        bound |= {
            alias.asname or alias.name
            for node in ast.walk(tree)
            if isinstance(node, (ast.Import, ast.ImportFrom))
            for alias in node.names
        }
        lines = {'os': 'import os', 'glob': 'from glob import glob'}
        if not names <= {*bound, *lines}:
            return ()
        wanted = [lines[name] for name in ('os', 'glob') if name in names - bound]
        return (*(_import(text, '\n'.join(wanted), facts) if wanted else ()), *edits)

    return insert


def _list_of(tree: ast.Module, keyword: str) -> ast.List | None:
    for node in ast.walk(tree):
        if isinstance(node, ast.keyword) and node.arg == keyword and isinstance(node.value, ast.List):
            return node.value
        if isinstance(node, ast.Dict):
            for key, value in zip(node.keys, node.values, strict=True):
                if isinstance(key, ast.Constant) and key.value == keyword and isinstance(value, ast.List):
                    return value
    return None


def _behind_last(text: Text, found: ast.List, end: int, new: str) -> Edit:
    """Return the edit that adds an item after the last item of a list.

    The new item gets its own line if the other items have their own lines.
    """
    opened = text.of_node(found).start
    if not found.elts:
        return inserted(text, opened + 1, new)
    last = text.of_node(found.elts[-1])
    is_long = text.place(last.end).line != text.place(end).line
    comma = re.compile(r'\s*,').match(text.text, last.end)
    at = comma.end() if comma is not None else last.end
    if not is_long:
        return inserted(text, last.end, f', {new}')
    indent = ' ' * text.place(text.of_node(found.elts[-1]).start).column
    return inserted(text, at, f'{"" if comma else ","}\n{indent}{new},')


def _manifest(text: Text, new: str, facts: dict[str, Any]) -> Edits:
    """Return the edit that adds a line to package.xml after the last dependency.

    Without dependencies, the edit adds the line before <export> or at the end.
    """
    if new in text.text:
        return ()
    found = list(re.finditer(r'^([ \t]*)<(?:\w+_)?depend>.*</(?:\w+_)?depend>[ \t]*$', text.text, re.MULTILINE))
    found = [one for one in found if '<test_depend>' not in one[0]] or found
    if found:
        return (inserted(text, found[-1].end(), f'\n{found[-1][1]}{new}'),)
    end = re.search(r'^[ \t]*(?:<export>|</package>)', text.text, re.MULTILINE)
    return () if end is None else (inserted(text, end.start(), f'  {new}\n'),)


INSERTING: dict[str, Callable[[Text, str, dict[str, Any]], Edits]] = {
    'import': _import,
    'data_files': _in_list('data_files'),
    'console_scripts': _in_list('console_scripts'),
    'manifest': _manifest,
}
"""Places at which something is inserted. The first two are in any Python file, the others are in files of a package."""
FILES = {'data_files': 'setup.py', 'console_scripts': 'setup.py', 'manifest': 'package.xml'}
"""Files of the package that these edits change, whichever file the finding is about."""


def applied(text: str, edits: Edits) -> str:
    """Return the content of a file after the edits. If two edits overlap, only one of them is applied."""
    made, last = text, len(text) + 1
    for edit in sorted(edits, key=lambda one: one.span, reverse=True):
        if edit.span.end <= last and text[edit.span.start : edit.span.end] == edit.old:
            made = made[: edit.span.start] + edit.new + made[edit.span.end :]
            last = edit.span.start
    return made
