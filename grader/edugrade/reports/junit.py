"""Writes reports as JUnit XML for continuous integration servers: a suite for each submission, and a case for each check."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from xml.sax.saxutils import escape, quoteattr

from ..results import FAILED, GRADER_BROKE, NOT_RUN, Refusal
from .document import explanation

_ELEMENTS = {FAILED: 'failure', GRADER_BROKE: 'error', NOT_RUN: 'skipped'}


def junit_text(documents: Sequence[Mapping[str, Any]], refusals: Sequence[Refusal] = ()) -> str:
    """Return all reports (JSON documents or results of a batch) as one XML document. A refused path is a suite with one error."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<testsuites name="edugrade">']
    for found in documents:
        who = ': '.join(filter(None, (found.get('student'), found.get('path') or found.get('submission', {}).get('file'))))
        lines += _refused(who, found['refused'], found.get('help') or '') if 'refused' in found else _suite(who, found)
    for refusal in refusals:
        lines += _refused(refusal.given, refusal.reason, refusal.help or '')
    return '\n'.join([*lines, '</testsuites>']) + '\n'


def _refused(name: str, reason: str, help: str) -> list[str]:
    counts = {'tests': '1', 'failures': '0', 'errors': '1', 'skipped': '0'}
    return [
        _start('testsuite', {'name': name, **counts}),
        _start('testcase', {'classname': name, 'name': 'It can be graded'}),
        f'{_start("error", {"message": reason, "type": "refused"})}{_safe(help)}</error>',
        '</testcase>',
        '</testsuite>',
    ]


def _suite(who: str, found: Mapping[str, Any]) -> Iterator[str]:
    checks, rubric, points = found['checks'], found['rubric']['name'], found['points']
    count = {status: str(sum(check['status'] == status for check in checks)) for status in _ELEMENTS}
    counts = {'tests': str(len(checks)), 'failures': count[FAILED], 'errors': count[GRADER_BROKE], 'skipped': count[NOT_RUN]}
    yield _start('testsuite', {'name': f'{rubric}: {who}', **counts})
    mark = 'no mark' if points['earned'] is None else f'{points["earned"]} of {points["possible"]}'
    properties = {'points': mark, 'seed': str(found['seed']), 'sha256': found['submission']['sha256']}
    yield '<properties>'
    for name, value in {**({'student': found['student']} if found.get('student') else {}), **properties}.items():
        yield _start('property', {'name': name, 'value': value}, '/>')
    yield '</properties>'
    for check in checks:
        yield from _case(check, f'edugrade.{rubric}' + (f'.{found["student"]}' if found.get('student') else ''))
    yield '</testsuite>'


def _case(check: Mapping[str, Any], classname: str) -> Iterator[str]:
    case = {'classname': classname, 'name': check['sentence']}
    element = _ELEMENTS.get(check['status'])
    if element is None:
        yield _start('testcase', case, '/>')
        return
    yield _start('testcase', case)
    details = _safe('\n'.join(explanation(check)))
    yield f'{_start(element, {"message": check["reason"] or "", "type": check["name"]})}{details}</{element}>'
    yield '</testcase>'


def _start(name: str, attributes: Mapping[str, str], end: str = '>') -> str:
    words = ''.join(f' {key}={quoteattr(_legal(value))}' for key, value in attributes.items())
    return f'<{name}{words}{end}'


def _safe(text: str) -> str:
    return escape(_legal(text))


def _legal(text: str) -> str:
    """Replace control characters and lone surrogates, which XML 1.0 does not allow."""
    return ''.join(sign if sign.isprintable() or sign in '\n\t' else '?' for sign in text)
