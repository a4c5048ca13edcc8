"""What a run of a corpus package did, as lines of (simulated time, who, what) in the order in which it happened."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import edulaunch
from edulaunch.engine.recording.records import Fact

from .cases import CASES, CORPUS

QUIET = re.compile(
    r'\[INFO\] \[launch\]: (Default|All log)|\[(?!(?:INFO|WARNING|ERROR)\])[^\]]+-\d+\] |\[INFO\] .*process started'
)
INSTALLED = re.compile(r'/\S+/lib/(\w+)/')
PARAMS = re.compile(r'/\S+/launch_params_\w+')
LOG_LINE = re.compile(r'\[(DEBUG|INFO|WARN|ERROR|FATAL)\] \[\d+\.\d+\] (.*)', re.DOTALL)


def run_case(name: str, seed: int = 0) -> edulaunch.Recording:
    """Run the package's launch file as its case says."""
    case = CASES[name]
    with edulaunch.Session(
        seed=seed, workspaces=[CORPUS / name], stdin=case.stdin, env={'USER': 'student', 'PATH': '/usr/bin:/bin'}
    ) as session:
        launch = session.launch(case.package or name, case.file, case.arguments)
        session.run(case.duration_s)
        launch.raise_error()
        return session.recording()


def journal(recording: edulaunch.Recording, name: str) -> list[str]:
    """One line for each line that a program wrote, each note of the engine, each end of a program, each watched value."""
    case = CASES[name]
    events = _written(recording, CORPUS / name)
    events += [(note.time_s, f'{note.process or "launch"}  ! {note.kind}: {note.text}') for note in recording.notes]
    events += [
        (fact.time_s, f'{fact.process or "launch"}  ! {fact.kind}: {_plain(fact, CORPUS / name)}') for fact in recording.facts
    ]
    for topic, *fields in case.topics:
        events += _values(recording, topic, fields)
    events.sort(key=lambda event: event[0])
    return [f'{time:7.3f}  {text}'.rstrip() for time, text in events]


def _plain(fact: Fact, folder: Path) -> str:
    """What a fact says, and how often."""
    return f'{fact.data} x{fact.times}'.replace(str(folder), '@')


def _written(recording: edulaunch.Recording, folder: Path) -> list[tuple[float, str]]:
    lines = []
    for output in recording.output:
        if output.process == 'launch' and QUIET.match(output.text):
            continue
        found = LOG_LINE.match(output.text)
        text = f'{found[1]} {found[2]}' if found else output.text
        text = PARAMS.sub('~/launch_params', INSTALLED.sub(r'~/lib/\1/', text.replace(str(folder), '@').rstrip('\n')))
        lines += [(output.time_s, f'{output.process}  {line}') for line in text.split('\n')]
    return lines


def _values(recording: edulaunch.Recording, topic: str, fields: list[str]) -> list[tuple[float, str]]:
    """Each change of some fields of a topic."""
    changes: list[tuple[float, str]] = []
    before: Any = None
    for time, *values in recording.series(topic, *fields):
        shown = '(' + ', '.join(f'{value:.3f}'.replace('-0.000', '0.000') for value in values) + ')'
        if shown != before:
            changes.append((time, f'{topic}  {shown}'))
        before = shown
    return changes
