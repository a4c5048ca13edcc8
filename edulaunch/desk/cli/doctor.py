"""`edulaunch doctor`: what is wrong with a launch file, a package or workspace, or a run, and what to do about it."""

from __future__ import annotations

import argparse
import os
from typing import TYPE_CHECKING

from edulaunch.advice.judging import in_order, judge, judge_plan, judge_sources
from edulaunch.advice.reader import reader_here
from edulaunch.advice.wording import diagnosis, diagnosis_data
from edulaunch.desk.cli.launch import split_words
from edulaunch.engine.packages.discovery import workspaces_of_command
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.file_format import FORMAT
from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.advice.rule import Finding

SECONDS = 20.0


def doctor_arguments(parser: argparse.ArgumentParser) -> None:
    """What to look at, and how to tell it."""
    parser.add_argument(
        'target',
        metavar='FILE | FOLDER | RECORDING | PACKAGE',
        help='a launch file, a package or workspace, a recording; or a package, and the name of a launch file in it',
    )
    parser.add_argument('rest', nargs='*', metavar='FILE | name:=value', help='launch file name, launch arguments')
    parser.add_argument('--json', action='store_true', help='as JSON, with the facts behind each sentence')
    parser.add_argument(
        '--for', dest='seconds', type=float, default=SECONDS, metavar='SECONDS', help=f'simulated seconds (default: {SECONDS:g})'
    )
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def doctor_verb(arguments: argparse.Namespace) -> int:
    """Say what is wrong. 0 when nothing is, 1 when something is, 2 when there is nothing that can be looked at."""
    findings, reader = _findings(arguments), reader_here()
    if arguments.json:
        import json

        print(json.dumps(diagnosis_data(findings, reader), indent=2, ensure_ascii=False))
    else:
        print('\n'.join(diagnosis(findings, reader)).encode(errors='backslashreplace').decode())
    return 1 if findings else 0


def _findings(arguments: argparse.Namespace) -> list[Finding]:
    target: str = arguments.target
    if os.path.isdir(target) and not arguments.rest:
        return judge_sources(target)
    if _is_recording(target):
        return judge(Recording.load(target))
    return _of_launch(target, arguments)


def _is_recording(path: str) -> bool:
    if not os.path.isfile(path):
        return False
    with open(path, 'rb') as file:
        return FORMAT.encode() in file.read(100)


def _of_launch(target: str, arguments: argparse.Namespace) -> list[Finding]:
    """By its dry run and, when that comes to its end, by a run."""
    from edulaunch.advice.plan import rehearse
    from edulaunch.runtime.launching import find_launch_file
    from edulaunch.runtime.session import Session

    first, file, given = split_words(target, arguments.rest)
    workspaces = workspaces_of_command(arguments.workspace, first)
    with Session(workspaces=workspaces) as session:
        if file is None and not os.path.exists(first) and first in session.index.packages():
            return judge_sources(_folder_of(first, session.index.share(first)))
        path = find_launch_file(session.index, first, file)
        host = session.host
        rehearsal = rehearse(path, given, session.index, host.env, command_set=host.command_set)
        if rehearsal.plan['error'] is not None:
            return judge_plan(rehearsal)
        session.launch(path, None, given)
        session.run(arguments.seconds)
        return in_order([*judge_plan(rehearsal), *judge(session.recording())])


def _folder_of(package: str, share: str | None) -> str:
    """The folder with the sources of a package.

    :raises UnusableInput: when only what was built of it is here.
    """
    manifest = os.path.join(share or '', 'package.xml')
    folder = os.path.dirname(os.path.realpath(manifest))
    if not os.path.islink(manifest):
        raise UnusableInput(f'the sources of {package} are not here', help='give the folder of the package, or a launch file')
    return folder
