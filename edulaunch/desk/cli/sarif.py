"""Findings as SARIF 2.1.0, the format of static analysis results that editors and code hosts read."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from edulaunch.advice.reader import Reader
from edulaunch.advice.rule import Finding, rule_named
from edulaunch.advice.wording import told
from edulaunch.version import __version__

SCHEMA = 'https://json.schemastore.org/sarif-2.1.0.json'
LEVELS = {'error': 'error', 'warning': 'warning', 'info': 'note'}


def sarif(findings: Sequence[Finding], reader: Reader) -> dict[str, Any]:
    """The log of one run of the doctor, as plain data.

    :param reader: in whose language the messages are; places are absolute.
    """
    names = list(dict.fromkeys(finding.rule for finding in findings))
    driver = {'name': 'edulaunch doctor', 'version': __version__, 'rules': [_rule(name) for name in names]}
    results = [_result(finding, names.index(finding.rule), reader) for finding in findings]
    return {'$schema': SCHEMA, 'version': '2.1.0', 'runs': [{'tool': {'driver': driver}, 'results': results}]}


def _rule(name: str) -> dict[str, Any]:
    rule = rule_named(name)
    why = rule.why[0] if rule.why else rule.what[0]
    return {
        'id': name,
        'shortDescription': {'text': rule.what[0]},
        'fullDescription': {'text': why},
        'help': {'text': f'edulaunch explain {name}'},
        'defaultConfiguration': {'level': LEVELS[rule.level]},
    }


def _result(finding: Finding, number: int, reader: Reader) -> dict[str, Any]:
    words = told(finding, reader)
    text = '\n'.join(filter(None, (words.what, words.why, words.do)))
    result: dict[str, Any] = {
        'ruleId': finding.rule,
        'ruleIndex': number,
        'level': LEVELS[rule_named(finding.rule).level],
        'message': {'text': text},
    }
    if finding.file is not None:
        region = {} if not finding.line else {'region': {'startLine': finding.line}}
        place = {'artifactLocation': {'uri': Path(finding.file).absolute().as_uri()}, **region}
        result['locations'] = [{'physicalLocation': place}]
    return result
