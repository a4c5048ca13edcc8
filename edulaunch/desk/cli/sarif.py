"""Convert findings to formats of other programs: SARIF 2.1.0, and diagnostics of the Language Server Protocol."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from edulaunch.advice.reader import Reader
from edulaunch.advice.rendering import rendered
from edulaunch.advice.rule import Finding, rule_named
from edulaunch.advice.texts import Marked, Span, Text, marked
from edulaunch.advice.texts.lsp import diagnostic, title, uri_of
from edulaunch.desk.cli.explain_rule import readable
from edulaunch.runtime.version import __version__

SCHEMA = 'https://json.schemastore.org/sarif-2.1.0.json'
LEVELS = {'error': 'error', 'warning': 'warning', 'info': 'note'}


def sarif(findings: Sequence[Finding], reader: Reader) -> dict[str, Any]:
    """Return the SARIF log of one run of the doctor as plain data.

    :param findings: the findings of the doctor, with absolute paths.
    :param reader: determines the language of the messages.
    """
    names = list(dict.fromkeys(finding.rule for finding in findings))
    driver = {'name': 'edulaunch doctor', 'version': __version__, 'rules': [_rule(name, reader) for name in names]}
    results = [_result(finding, names.index(finding.rule), reader) for finding in findings]
    run = {'tool': {'driver': driver}, 'columnKind': 'unicodeCodePoints', 'results': results}
    return {'$schema': SCHEMA, 'version': '2.1.0', 'runs': [run]}


def _rule(name: str, reader: Reader) -> dict[str, Any]:
    rule = rule_named(name)
    what, why = (readable(reader.says(sentence)) for sentence in (rule.what[0], (rule.why or rule.what)[0]))
    return {
        'id': name,
        'shortDescription': {'text': what},
        'fullDescription': {'text': why},
        'help': {'text': f'edulaunch explain {name}'},
        'defaultConfiguration': {'level': LEVELS[rule.level]},
    }


def _result(finding: Finding, number: int, reader: Reader) -> dict[str, Any]:
    words = rendered(finding, reader)
    text = '\n'.join(filter(None, (words.what, words.why, words.do)))
    result: dict[str, Any] = {
        'ruleId': finding.rule,
        'ruleIndex': number,
        'level': LEVELS[rule_named(finding.rule).level],
        'message': {'text': text},
    }
    if finding.file is not None:
        content = _text_of(finding.file)
        mark = marked(finding, content) if content is not None and finding.line else None
        region = {'startLine': finding.line} if mark is None or content is None else _region(content, mark.span)
        place = {'artifactLocation': {'uri': uri_of(finding.file)}, **({'region': region} if finding.line else {})}
        result['locations'] = [{'physicalLocation': place}]
        if content is not None and mark is not None and mark.edits:
            result['fixes'] = [_fix(content, mark)]
    return result


def _text_of(path: str) -> Text | None:
    """Return the content of a file, or None if it cannot be read."""
    try:
        with open(path, encoding='utf-8', newline='') as file:
            return Text(file.read(), path)
    except (OSError, UnicodeDecodeError):
        return None


def _region(text: Text, span: Span) -> dict[str, int]:
    start, end = text.place(span.start), text.place(span.end)
    return {'startLine': start.line, 'startColumn': start.column + 1, 'endLine': end.line, 'endColumn': end.column + 1}


def _fix(text: Text, mark: Marked) -> dict[str, Any]:
    replacements = [{'deletedRegion': _region(text, edit.span), 'insertedContent': {'text': edit.new}} for edit in mark.edits]
    change = {'artifactLocation': {'uri': uri_of(text.path)}, 'replacements': replacements}
    return {'description': {'text': title(mark.edits)}, 'artifactChanges': [change]}


def lsp(findings: Sequence[Finding], reader: Reader) -> dict[str, Any]:
    """Return the diagnostics of the Language Server Protocol, by the URI of the file. Each diagnostic includes its edits.

    :param findings: the findings of the doctor.
    :param reader: determines the language of the messages.
    """
    found: dict[str, list[Any]] = {}
    for finding in findings:
        text = None if finding.file is None else _text_of(finding.file)
        if text is not None:
            found.setdefault(uri_of(text.path), []).append(diagnostic(marked(finding, text), text, reader))
    return found
