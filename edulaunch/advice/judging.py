"""Apply the rules and return their findings, without duplicates and with the most serious one first."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import islice
from typing import TYPE_CHECKING, Any

from edulaunch.advice.outlines import students_python
from edulaunch.advice.rule import CONFIDENCES, LEVELS, Failure, Finding, Rule, failure_of, found, rule_named, rules_over
from edulaunch.advice.run_sources import Script, launch_scripts
from edulaunch.advice.runs import INTERRUPTS
from edulaunch.errors import EdulaunchError
from edulaunch.ros.collector_pause import collector_paused

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal
    from edulaunch.advice.source_package import Workspace
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

DIED = 'programs.died'
"""A rule whose finding is omitted for a program whose error another rule explains."""
FAILS = 'launch.fails'
"""A rule whose finding is omitted if another rule explains the failure."""
ODD = (ArithmeticError, AssertionError, AttributeError, EdulaunchError, LookupError, RecursionError, TypeError, ValueError)
"""Errors that a rule raises for unexpected data. A timeout does not belong to them."""
_LOOKUP_ERROR = re.compile(r'(Lookup|Connectivity|Extrapolation|InvalidArgument|Transform|Timeout)Exception')
"""Matches the error of a program that a failed lookup has ended."""
MOST = 20
"""The maximum number of findings of one rule."""


def judge(recording: Recording) -> list[Finding]:
    """Return the mistakes in a run. The rules check the recording, its launch files, and the errors that ended programs."""
    with collector_paused():  # in a large recording, garbage collection takes longer than the rules
        return _judge(recording)


def _judge(recording: Recording) -> list[Finding]:
    explained = [
        finding._replace(process=failure.process) for failure in failures(recording) for finding in _asked('errors', failure)
    ]
    causes = {finding.process for finding in explained}
    others = [one for one in _asked('recordings', recording) if one.rule != DIED or one.name not in causes]
    others += of_scripts(tuple(launch_scripts(recording)))
    return in_order(about_command(_without_consequences([*explained, *others], recording), recording))


@lru_cache(maxsize=16)
def of_scripts(scripts: tuple[Script, ...]) -> tuple[Finding, ...]:
    """Return the findings of the rules for launch files. The result is cached, because equal files share their syntax trees."""
    return tuple(_asked('scripts', list(scripts)))


ABSENT = frozenset(
    (
        'messages.other-package',
        'messages.unknown-package',
        'packages.absent-module',
        'packages.absent-package',
        'programs.compiled-module',
    )
    + ('programs.library', 'programs.native', 'programs.native-component', 'programs.unknown-module', 'programs.window')
)
"""Rules about a program that cannot run here, whose endpoints are therefore unknown."""
NOT_STARTED = 'exception occurred while executing process'
"""The start of launch's message about a program that it could not start."""
LONELY = frozenset(
    ('messages.bag-of-nothing', 'messages.no-joint-states', 'messages.no-server', 'messages.nobody-listens')
    + ('messages.nobody-publishes', 'messages.other-topic', 'time.no-clock')
)
"""Rules that report a missing partner."""


def _without_consequences(findings: list[Finding], recording: Recording) -> list[Finding]:
    """Remove findings about a missing partner if a program of the command failed. The partner may be in that program."""
    own = [process for process in recording.processes if recording.command is None or process.name in recording.command]
    names = {process.name for process in own}
    is_absent = any(finding.rule in ABSENT for finding in findings)
    has_died = any(finding.rule == DIED and finding.name in names for finding in findings)
    has_failed = any(_has_failed(process) for process in own) or any(
        row[4].startswith(NOT_STARTED) for row in recording.rows('logs')
    )
    if not is_absent and not has_died and not has_failed:
        return findings
    commands = {process.name for process in recording.processes if process.argv[:1] == ['ros2']} if is_absent else set()
    return [one for one in findings if one.rule not in LONELY and not (one.rule == DIED and one.name in commands)]


def _has_failed(process: ProcessRecord) -> bool:
    """Return whether an error ended a program. Ctrl-C is not an error."""
    return process.exception is not None and process.exception['type'] not in INTERRUPTS


def about_command(findings: list[Finding], recording: Recording) -> list[Finding]:
    """Return the findings about the command of the recording, or all findings if the recording is of a whole machine.

    A finding that names nodes or programs concerns the command if one of them belongs to the command. Any other finding concerns
    the command if it is about the command's file or argument, or about a topic, service or frame of its nodes.
    """
    if recording.command is None or all(process.name in recording.command for process in recording.processes):
        return findings
    nodes = [node for node in recording.nodes if node.process in recording.command]
    names = {node.name for node in nodes} | recording.command
    ends = {
        name for node in nodes for end in (node.publishers, node.subscriptions, node.services, node.clients) for name, _ in end
    }
    files = {process.file for process in recording.processes if process.name in recording.command}
    return [
        one
        for one in findings
        if (_named(one) & names if _named(one) else one.name in ends or one.kind in ('argument', 'run') or one.file in files)
    ]


_WHO = ('node', 'other', 'process', 'first', 'second', 'asker', 'nodes')
"""Facts that contain the name of a node or program, or several names."""


def _named(finding: Finding) -> set[str]:
    """Return the names of the nodes and programs in a finding."""
    facts = {**finding.facts, finding.kind: finding.name}
    named: set[str] = {finding.process} if finding.process else set()
    for key in _WHO:
        value = facts.get(key)
        named |= {value} if isinstance(value, str) else {*value} if isinstance(value, list) else set()
    return named


def judge_plan(rehearsal: Rehearsal) -> list[Finding]:
    """Return the mistakes in a launch file that its dry run shows."""
    findings = in_order([*_asked('plans', rehearsal), *_asked('scripts', list(students_python(rehearsal)))])
    better = [one for one in findings if one.rule != FAILS]
    if len(better) < len(findings):
        better += _behind_failure(rehearsal)
    rules = [rule_named(one.rule) for one in better]
    return better if any(one.level == LEVELS[0] or FAILS in one.hides for one in rules) else findings


def _behind_failure(rehearsal: Rehearsal) -> list[Finding]:
    """Return the findings about the error that ended a dry run. They explain more than the finding about the failure itself."""
    error = rehearsal.plan['error'] or {}
    cause = error.get('cause')
    if cause is None:
        return []
    file, _, line = (error['origin'] or '').rpartition(':')
    if not line.isdigit():
        file, line = rehearsal.plan['file'], ''
    file = os.path.realpath(file)  # an included file is a link to the student's file
    return judge_failure(Failure(cause['type'], cause['text'], file, int(line) if line else None, facts=error['facts']))


def judge_scripts(scripts: list[Script]) -> list[Finding]:
    """Return the mistakes in Python launch files that their syntax trees show. No code of the files is executed."""
    return in_order(_asked('scripts', scripts))


def judge_failure(error: Failure | BaseException) -> list[Finding]:
    """Return the mistakes that caused an error."""
    return in_order(_asked('errors', error if isinstance(error, Failure) else failure_of(error)))


def judge_sources(path: str) -> list[Finding]:
    """Return the mistakes in the packages of a workspace or package folder. No code of the packages is executed."""
    from edulaunch.advice.source_package import workspace_at

    return judge_workspace(workspace_at(path))


def judge_workspace(workspace: Workspace) -> list[Finding]:
    """Return the mistakes in a workspace that has already been read."""
    found = _asked('workspaces', workspace)
    for source in (one for one in workspace.sources if not one.is_of_ros_1):
        found += _asked('sources', source)
    return in_order(found)


def failures(recording: Recording) -> Iterator[Failure]:
    """Yield the error that ended the launch, then the errors that ended programs, in the order of the programs."""
    launch = recording.launch
    if launch.error is not None:
        type_, cause = launch.error_type or '', launch.error_cause or ''
        yield Failure(type_, cause, launch.error_file, launch.error_line, facts=launch.error_facts)
    for process in recording.processes:
        error = process.exception
        if error:
            file, line = (error['file'], error['line']) if error['file'] else (process.file, process.line)
            facts = error.get('facts') or {}
            if 'parameter_path' in facts and 'at' in facts:
                file, line = os.path.realpath(facts['parameter_path']), facts['at']
            yield Failure(error['type'], error['message'], file, line, process.ended_s, process.name, facts)


def in_order(findings: Iterable[Finding]) -> list[Finding]:
    """Return the findings without duplicates and without consequences of other findings.

    Sort them by seriousness, then by certainty, then by time.
    """
    rules = {finding.rule: rule_named(finding.rule) for finding in findings}
    causes = [one for one in findings if rules[one.rule].hides]
    first: dict[tuple[Any, ...], Finding] = {}
    for finding in sorted(findings, key=lambda one: _rank(rules[one.rule], one)):
        if not any(finding.rule in rules[cause.rule].hides and _may_hide(cause, finding) for cause in causes):
            first.setdefault((finding.rule, finding.kind, finding.name, finding.file, finding.line), finding)
    return list(first.values())


def _may_hide(cause: Finding, other: Finding) -> bool:
    """Return whether two findings may be about the same node or program.

    For two findings about frames, return True, because all nodes share the frames.

    """
    error = other.facts.get('error') if other.rule == DIED and cause.rule.startswith('tf.') else None
    if error and not _LOOKUP_ERROR.match(error):
        return False
    of_cause, of_other = _nodes(cause), _nodes(other)
    shared = cause.rule.startswith('tf.') and other.rule.startswith('tf.')
    return not of_cause or not of_other or bool(of_cause & of_other) or shared


def _nodes(finding: Finding) -> set[str]:
    facts = {**finding.facts, finding.kind: finding.name}
    return {facts[name] for name in ('node', 'other', 'process') if facts.get(name)}


def _asked(kind: str, thing: Any) -> list[Finding]:
    """Return the findings of all rules for one kind of thing.

    :param kind: the kind, which is the name of the folder with the rules.
    :param thing: the object that the rules check.
    """
    return [finding for rule in rules_over(kind) for finding in _findings_by(rule, thing)]


def _findings_by(rule: Rule, thing: Any) -> list[Finding]:
    """Return the findings of one rule. If the rule fails, return a finding about that, so that advice never ends a run."""
    try:
        return [_of_student(finding._replace(rule=rule.name)) for finding in islice(rule.look(thing), MOST)]
    except ODD as error:
        return [found('rule', rule.name, error=f'{type(error).__name__}: {error}')._replace(rule='programs.rule-failed')]


def _of_student(finding: Finding) -> Finding:
    """Return the finding with the path of the student's file in place of a link in the folder of a simulated build."""
    is_link = finding.file is not None and os.path.islink(finding.file) and '/edulaunch-' in finding.file
    return finding._replace(file=os.path.realpath(finding.file)) if is_link and finding.file is not None else finding


def _rank(rule: Rule, finding: Finding) -> tuple[Any, ...]:
    late = finding.time_s if finding.time_s is not None else 0.0
    place = (finding.file or '', finding.line or 0)
    return (LEVELS.index(rule.level), CONFIDENCES.index(rule.confidence), late, rule.name, finding.kind, finding.name, place)
