"""`check(text, path)`: find the mistakes in a file while the student writes it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from edulaunch.advice.judging import in_order, judge_failure, judge_scripts
from edulaunch.advice.reader import fields_of
from edulaunch.advice.rule import Finding, rule_named
from edulaunch.advice.texts.around import Around
from edulaunch.advice.texts.edits import Edits, edits_of, written
from edulaunch.advice.texts.launch_python import foreseen_in_launch, joined_in_lists
from edulaunch.advice.texts.markup import foreseen_in_markup, foreseen_in_parameters
from edulaunch.advice.texts.package_files import findings_of_package
from edulaunch.advice.texts.programs import foreseen_in_program
from edulaunch.advice.texts.syntax import Foreseen, syntax_error
from edulaunch.advice.texts.text import LONGEST, Span, Text

LAUNCH_PYTHON, LAUNCH_MARKUP, PARAMETERS, SETUP, MANIFEST, PROGRAM = (
    'launch file in Python',
    'launch file in XML or YAML',
    'parameter file',
    'setup.py',
    'package.xml',
    'program',
)
_MARKUP = re.compile(r'[._]launch\.(xml|ya?ml)$')


class Marked(NamedTuple):
    """A finding with its span in the file, and the edits that certainly correct the mistake, if there are any."""

    finding: Finding
    span: Span
    edits: Edits = ()


def kind_of(path: str, text: str) -> str | None:
    """Return the kind of a file, from its name and content. Return None for a file that is not checked."""
    name = os.path.basename(path)
    if name == 'package.xml':
        return MANIFEST
    if name == 'setup.py':
        return SETUP
    if _MARKUP.search(name) or name.endswith('.xml') and '<launch' in text:
        return LAUNCH_MARKUP
    if name.endswith(('.yaml', '.yml')):
        if re.search(r'^launch:', text, re.MULTILINE):
            return LAUNCH_MARKUP
        return PARAMETERS if re.search(r'\bros_*param', text) else None
    if not name.endswith('.py'):
        return None
    if name.endswith(('.launch.py', '_launch.py')) or 'generate_launch_description' in text:
        return LAUNCH_PYTHON
    return PROGRAM if re.search(r'\b(rclpy|tf2_ros|LaunchDescription)\b', text) else None


def check(text: str, path: str, around: Around | None = None) -> list[Marked]:
    """Return the mistakes in the content of a file, with the most serious mistake first. No code of the file is executed.

    :param text: the content of the file.
    :param path: the path of the file. Its name determines the kind of file, and its folder determines the available packages.
    :param around: the available packages. By default, they are read again.
    """
    kind = kind_of(path, text)
    if kind is None or len(text) > LONGEST:
        return []
    written_text = Text(text, os.path.abspath(path))
    known = around or Around(path)
    broken = syntax_error(written_text) if path.endswith('.py') else None
    if broken is not None:
        return _ordered(_of_failures(written_text, [broken]))
    return _ordered(_looked_at(kind, written_text, known))


def _looked_at(kind: str, text: Text, around: Around) -> Iterator[Marked]:
    tree = text.tree if text.path.endswith('.py') else None
    if kind == LAUNCH_PYTHON and tree is not None:
        yield from _of_failures(text, foreseen_in_launch(text, tree, around))
        yield from (marked(finding, text) for finding in judge_scripts([(text.path, tree)]))
        yield from (marked(finding, text, span) for finding, span in joined_in_lists(text, tree))
    elif kind == PROGRAM and tree is not None:
        yield from _of_failures(text, foreseen_in_program(text, tree, around))
    elif kind == LAUNCH_MARKUP:
        yield from _of_failures(text, foreseen_in_markup(text, around))
    elif kind == PARAMETERS:
        yield from _of_failures(text, foreseen_in_parameters(text))
    elif kind in (SETUP, MANIFEST):
        yield from (marked(finding, text) for finding in findings_of_package(text))


def _of_failures(text: Text, failures: Iterable[Foreseen]) -> Iterator[Marked]:
    """Yield the findings of the rules for errors about predicted errors."""
    for foreseen in failures:
        for finding in judge_failure(foreseen.failure)[:1]:
            finding = finding._replace(file=text.path, process=None)
            yield marked(finding, text, foreseen.span, foreseen.edits)


def marked(finding: Finding, text: Text, span: Span | None = None, edits: Edits | None = None) -> Marked:
    """Return a finding with its span in the file.

    The span is the given `span`, a word that occurs once in the line of the finding, or the whole line.

    :param finding: the finding.
    :param text: the content of the file.
    :param span: the span of the mistake, or None if it is unknown.
    :param edits: the certain edits, or None for the edits of the rule.
    """
    if edits is None:
        edits = (edits_of(finding, text, span) if span else ()) or edits_of(finding, text)
    if span is None:
        span = _narrowed(finding, text, edits)
    return Marked(finding, span, edits)


def _narrowed(finding: Finding, text: Text, edits: Edits) -> Span:
    replaced = [edit.span for edit in edits if edit.old and edit.file == text.path]
    if replaced:
        return replaced[0]
    line = text.line_span(finding.line or 1)
    if finding.line is None:
        return line
    form = written(finding)
    facts = {**finding.facts, finding.kind: finding.name}
    names = [field for template in rule_named(finding.rule).what for field in fields_of(template)]
    for word in (form[0] if form else '', finding.name, *(facts.get(name) for name in names)):
        at = text.found(word, line) if isinstance(word, str) and len(word) > 1 else None
        if at is not None:
            return at
    return line


def _ordered(marks: Iterable[Marked]) -> list[Marked]:
    """Return the findings in the order of a report, without duplicates and without consequences of other findings."""
    listed = list(marks)
    by_finding = {id(mark.finding): mark for mark in listed}
    return [by_finding[id(finding)] for finding in in_order([mark.finding for mark in listed])]
