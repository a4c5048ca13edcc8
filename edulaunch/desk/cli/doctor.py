"""`edulaunch doctor`: find mistakes in a launch file, a package, a workspace or a run, and suggest fixes."""

from __future__ import annotations

import argparse
import json
import os
import time
from typing import TYPE_CHECKING, Any

from edulaunch.advice.judging import in_order, judge, judge_plan, judge_sources
from edulaunch.advice.reader import reader_here
from edulaunch.advice.rendering import diagnosis, diagnosis_data, is_note
from edulaunch.desk.cli.launch import split_words
from edulaunch.engine.packages.discovery import folder_of, workspaces_of_command
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.file_format import FORMAT
from edulaunch.engine.underlay_place import is_students, underlay_prefix
from edulaunch.errors import UnusableInput
from edulaunch.runtime.launching import find_launch_file
from edulaunch.runtime.session import Session

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal
    from edulaunch.advice.rule import Finding
    from edulaunch.runtime.session import Session

SECONDS = 20.0
ELSEWHERE = 'launch.needs-elsewhere'
"""A rule about a launch file that needs a missing package or module. For a folder, the doctor prints one line about it."""
NOT_PYTHON = 'packages.not-python'
"""A rule that is less specific than the findings of a dry run at the same place."""
OF_FOLDER_S = 8.0
"""Simulated seconds for each launch file of a folder."""
MOST_LAUNCHED = 12
"""The doctor runs at most this many launch files of a folder. The workspace of a company may have hundreds of them."""
PATIENCE_S = 30.0
"""After this many real seconds, the doctor runs no further launch file of a folder."""
PASSED_OVER = frozenset(('build', 'install', 'log', 'node_modules', '__pycache__', 'test', 'tests'))
ENDINGS = ('.launch.py', '.launch.xml', '.launch.yaml', '.launch.yml', '_launch.py', '_launch.xml', '_launch.yaml', '_launch.yml')


def doctor_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the file, folder, package or recording to examine, and the options of the report."""
    parser.add_argument(
        'target',
        metavar='FILE | FOLDER | RECORDING | PACKAGE',
        help='a launch file, package, workspace or recording; or a package, followed by the name of one of its launch files',
    )
    parser.add_argument('rest', nargs='*', default=[], metavar='FILE | name:=value', help='launch file name, launch arguments')
    parser.add_argument(
        '--json',
        nargs='?',
        const='facts',
        choices=('facts', 'lsp', 'sarif'),
        help='print JSON: the facts of each finding (facts), diagnostics and edits of the Language Server '
        'Protocol (lsp), or SARIF 2.1.0 (sarif)',
    )
    parser.add_argument(
        '--for',
        dest='seconds',
        type=float,
        metavar='SECONDS',
        help=f'simulated seconds (default: {SECONDS:g}, and {OF_FOLDER_S:g} for each launch file of a folder)',
    )
    parser.add_argument('--fix', action='store_true', help='show the edits that are certain, and make them if you agree')
    parser.add_argument('--yes', action='store_true', help='make the edits of --fix without asking')
    parser.add_argument('--workspace', action='append', default=[], metavar='DIR', help='folder with packages; may be repeated')


def doctor_verb(arguments: argparse.Namespace) -> int:
    """Report mistakes. Return 0 without mistakes, 1 with mistakes, and 2 if there is nothing to examine.

    Notes are not mistakes, so they do not change the exit code.
    """
    notes: list[str] = []
    findings, reader = _findings(arguments, notes), reader_here()
    if arguments.fix:
        from edulaunch.desk.cli.fixing import changes_for, fix

        print('\n'.join([*diagnosis(findings, reader), *notes, '']))
        return fix(changes_for(_named(arguments), findings), arguments.yes)
    if arguments.json:
        from edulaunch.desk.cli.sarif import lsp, sarif

        forms = {'facts': diagnosis_data, 'lsp': lsp, 'sarif': sarif}
        data = forms[arguments.json](findings, reader)
        print(json.dumps(data, indent=2, ensure_ascii=False))
    else:
        print('\n'.join([*diagnosis(findings, reader), *notes]).encode(errors='backslashreplace').decode())
    return 0 if all(map(is_note, findings)) else 1


def _findings(arguments: argparse.Namespace, notes: list[str]) -> list[Finding]:
    target: str = arguments.target
    if os.path.isdir(target) and not arguments.rest:
        return _of_folder(target, arguments, notes)
    if _is_recording(target):
        return judge(Recording.load(target))
    return _of_launch(target, arguments, notes)


def _named(arguments: argparse.Namespace) -> str:
    """Return the path of the file or folder that the command names. `--fix` changes nothing outside this path.

    :raises UnusableInput: for a recording, and for a package or file that does not belong to the user.
    """
    first, file, _ = split_words(arguments.target, arguments.rest)
    if os.path.isdir(first) or (os.path.isfile(first) and not _is_recording(first)):
        return first
    if os.path.isfile(first):
        raise UnusableInput('a recording cannot be changed', help='name the launch file or the folder of the package')
    with Session(workspaces=workspaces_of_command(arguments.workspace, first), near=folder_of(first)) as session:
        if file is None:
            return _folder_of(first, session.index.share(first))
        path = os.path.realpath(find_launch_file(session.index, first, file))
    if not is_students(path) or path.startswith(underlay_prefix()):
        raise UnusableInput(f'{path} belongs to edulaunch', help='copy it into your package')
    return path


def _is_recording(path: str) -> bool:
    if not os.path.isfile(path):
        return False
    with open(path, 'rb') as file:
        return FORMAT.encode() in file.read(100)


def _of_launch(target: str, arguments: argparse.Namespace, notes: list[str]) -> list[Finding]:
    """Examine the launch file in a dry run. If the dry run reaches the end, run the launch file and examine that run, too."""
    first, file, given = split_words(target, arguments.rest)
    workspaces = workspaces_of_command(arguments.workspace, first)
    with Session(workspaces=workspaces, near=folder_of(first)) as session:
        if file is None and not os.path.exists(first) and first in session.index.packages():
            return _of_folder(_folder_of(first, session.index.share(first)), arguments, notes)
        path = find_launch_file(session.index, first, file)
        rehearsal = _rehearsed(session, path, given)
        if rehearsal.plan['error'] is not None:
            return _in_sources(session, judge_plan(rehearsal))
        session.launch(path, None, given)
        session.run(SECONDS if arguments.seconds is None else arguments.seconds)
        return in_order(_in_sources(session, [*judge_plan(rehearsal), *judge(session.recording())]))


def _in_sources(session: Session, findings: list[Finding]) -> list[Finding]:
    """Return the findings with the paths of the student's own files instead of the links in a generated prefix."""
    source_path = session.index.source_path
    return [one if one.file is None else one._replace(file=source_path(one.file)) for one in findings]


def _rehearsed(session: Session, path: str, given: dict[str, str]) -> Rehearsal:
    from edulaunch.advice.plan import rehearse

    return rehearse(path, given, session.index, session.host.env, command_set=session.host.command_set)


def _of_folder(folder: str, arguments: argparse.Namespace, notes: list[str]) -> list[Finding]:
    """Examine the sources of the packages in a folder, and briefly run each launch file that needs no arguments.

    :param notes: receives one line about all launch files that ran, and for each other launch file a line with the reason.
    """
    findings, ran = judge_sources(folder), []
    files = _launch_files(folder)
    began_s = time.monotonic()
    for number, path in enumerate(files):
        name = os.path.relpath(path, folder)
        if number >= MOST_LAUNCHED or time.monotonic() - began_s > PATIENCE_S:
            notes.append(
                f'{len(files) - number} more launch files did not run; to run them: edulaunch doctor {os.path.relpath(path)}'
            )
            break
        found, reason = _of_one(folder, path, arguments)
        findings += found
        if reason is None:
            ran.append(name)
        else:
            notes.append(f'{name} did not run: {reason}')
    if ran:
        seconds = OF_FOLDER_S if arguments.seconds is None else arguments.seconds
        notes.insert(0, f'launch files that ran for {seconds:g} simulated seconds each: {", ".join(ran)}')
    read = {(one.file, one.line) for one in findings if one.rule != NOT_PYTHON}
    return in_order([one for one in findings if one.rule != NOT_PYTHON or (one.file, one.line) not in read])


def _of_one(folder: str, path: str, arguments: argparse.Namespace) -> tuple[list[Finding], str | None]:
    """Return the findings of one launch file of a folder, and the reason why it did not run (None if it ran)."""
    workspaces = arguments.workspace or _workspaces_of(folder, path)
    with Session(workspaces=workspaces, near=folder_of(path)) as session:
        rehearsal = _rehearsed(session, path, {})
        needed = [one['name'] for one in rehearsal.plan['arguments'] if one['default'] is None]
        if needed:
            return [], f'it needs {", ".join(f"{name}:=..." for name in needed)}'
        found = judge_plan(rehearsal)
        elsewhere = next((one for one in found if one.rule == ELSEWHERE), None)
        if elsewhere is not None:
            return [one for one in found if one is not elsewhere], _needed(elsewhere.facts)
        if rehearsal.plan['error'] is not None:
            return found, 'launch cannot load it'
        session.launch(path)
        session.run(OF_FOLDER_S if arguments.seconds is None else arguments.seconds)
        return [*found, *judge(session.recording())], None


def _needed(facts: dict[str, Any]) -> str:
    """Return why a launch file did not run: the package, module or program that it needs and that is not here."""
    if facts.get('package'):
        return f'package {facts["package"]} is not installed'
    if facts.get('module'):
        return f'module {facts["module"]} is not installed'
    return f'it needs {facts.get("made") or facts["executable"]}, which a build creates'


def _workspaces_of(folder: str, path: str) -> list[str]:
    """Return the workspaces of a launch file. Add the folder itself if none of these workspaces contains it."""
    found = workspaces_of_command([], path)
    here = os.path.join(os.path.realpath(folder), '')
    return found if any(here.startswith(os.path.join(os.path.realpath(one), '')) for one in found) else [*found, folder]


def _launch_files(folder: str) -> list[str]:
    """Return the launch files below a folder, sorted by name in each folder. Skip build folders, tests and hidden folders."""
    found: list[str] = []
    for place, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in PASSED_OVER and not name.startswith('.'))
        found += (os.path.join(place, name) for name in sorted(names) if name.endswith(ENDINGS))
    return found


def _folder_of(package: str, share: str | None) -> str:
    """Return the folder with the sources of a package.

    :raises UnusableInput: when only the installed package is available, without its sources.
    """
    manifest = os.path.join(share or '', 'package.xml')
    folder = os.path.dirname(os.path.realpath(manifest))
    if not os.path.islink(manifest):
        raise UnusableInput(f'the sources of {package} are not here', help='name the folder of the package, or a launch file')
    return folder
