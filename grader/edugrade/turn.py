"""``check('radio')`` for the section "Your turn" of a lesson.

The rubric of such a turn is in ``checks/`` beside the notebook, and names the file or the values to check. A turn runs in
the notebook's own process and folder, like the cells above it. Its report and its record have the same form as for an
exercise. A turn never ends with a traceback.
"""

from __future__ import annotations

import inspect
import os
from collections.abc import Mapping, Sequence
from hashlib import sha256
from typing import Any

from edulaunch.errors import EdulaunchError, UnusableInput

from .bare_runs import with_defaults_given
from .course import HIGHEST
from .evidence import Outcome, Scenario
from .judging import judge
from .results import Report
from .rubric import Rubric
from .rubrics.catalogue import load_rubric, rubrics_in
from .source import SubmittedText
from .submission import Submission
from .verdicts import come_to

FOLDER = 'checks'
SEED = 0
"""The seed of all turns. A student's package rarely has the same text twice, and the output of a lesson must not depend on
it.
"""


def find_turn(name: str) -> str | None:
    """Return the rubric of a lesson's check, or None. The function searches the folder ``checks`` beside the notebook, and in
    the folder ``lessons`` of this folder and its parents.
    """
    return turns().get(name)


def turns() -> dict[str, str]:
    """Return the rubric of each turn of the lessons around the current folder, by name."""
    above = os.curdir
    for _ in range(HIGHEST):
        for folder in (above, os.path.join(above, 'lessons')):
            if os.path.isdir(os.path.join(folder, FOLDER)):
                return rubrics_in(os.path.join(folder, FOLDER))
        above = os.path.join(above, os.pardir)
    return {}


def grade_turn(name: str, path: str, names: Mapping[str, Any]) -> Report:
    """Grade a turn of a lesson, and return the report.

    :param name: the name of the turn.
    :param path: the path of the turn's rubric.
    :param names: the values that the cells of the notebook have defined, for a rubric that checks them.
    :raises UnusableInput: if the file to check does not exist or cannot be read.
    """
    rubric = load_rubric(path)
    return _of_values(name, rubric, names) if rubric.names else _of_file(name, rubric, os.path.dirname(os.path.dirname(path)))


def _of_values(name: str, rubric: Rubric, names: Mapping[str, Any]) -> Report:
    """Return the report on values that cells have defined."""
    source = SubmittedText(os.path.abspath('cell.py'), '')
    defined = {each: names[each] for each in rubric.names if each in names}
    results = judge(rubric.checks, (), source, defined)[1:]
    text = '\0'.join(f'{key}={_text_of(value)}' for key, value in defined.items())
    digest = sha256(text.encode('utf-8', 'replace')).hexdigest()
    given = ', '.join(rubric.names)
    here = os.path.dirname(source.file)
    return Report(source.file, given, here, '', None, digest, name, rubric.title, 0, (), tuple(results))


def _text_of(value: object) -> str:
    try:
        return inspect.getsource(value)  # type: ignore[arg-type]
    except (OSError, TypeError):
        return repr(value)[:1000]


def _of_file(name: str, rubric: Rubric, folder: str) -> Report:
    """Return the report on a launch file, or on a file that the rubric's own launch file starts."""
    path = os.path.normpath(os.path.join(folder, rubric.of))
    try:
        submission = Submission(path)
    except UnusableInput as error:
        help = 'run the cell that writes it (its first line is %%writefile)'
        raise UnusableInput(error.message, help=help if error.message.endswith('does not exist') else error.help) from None
    launch = path if not rubric.launch else _write(os.path.splitext(path)[0] + '.launch.py', rubric.launch)
    digest = sha256(submission.sha256.encode())
    for beside in rubric.beside:
        digest.update(_bytes(os.path.join(folder, beside)))

    def runs(scenarios: Sequence[Scenario]) -> list[Outcome]:
        return [_outcome(scenario, launch, rubric.ended) for scenario in scenarios]

    outcomes = with_defaults_given(runs(rubric.scenarios(SEED)), runs)
    results = judge(rubric.checks, outcomes, submission.source)
    return Report(
        **submission.named,
        sha256=digest.hexdigest(),
        rubric=name,
        title=rubric.title,
        seed=SEED,
        outcomes=tuple(outcomes),
        results=tuple(results),
    )


def _outcome(scenario: Scenario, launch: str, ended: str) -> Outcome:
    from edulaunch.engine.packages.discovery import folder_of, workspaces_of_command

    from .turn_session import TurnSession

    target, file = _target(launch)
    workspaces = _workspaces(launch) or workspaces_of_command((), target)
    try:
        session = TurnSession(seed=scenario.seed, workspaces=workspaces, near=folder_of(target))
        with session:
            session.hide(scenario)
            session.launch(target, file, dict(scenario.arguments))
            session.run(scenario.duration_s)
            if ended:
                session.end(ended)
            recording = session.recording()
    except EdulaunchError as error:
        return Outcome(scenario, 'unusable', text=error.message, try_=error.help)
    if recording.launch.returncode == 0:  # the launch may have started nothing on purpose; the checks report what is missing
        return Outcome(scenario, 'recorded', recording=recording)
    return come_to(scenario, recording)


def _target(launch: str) -> tuple[str, str | None]:
    """Return the target of a launch file: its path and None or, for a file in a package, the package and the file's name.

    With the package's name, launch finds only installed files.
    """
    package = Submission(launch).package
    return (launch, None) if package is None else (package.name, os.path.basename(launch))


def _workspaces(launch: str) -> list[str] | None:
    package = Submission(launch).package
    return None if package is None else [os.path.relpath(package.workspace)]


def _write(path: str, text: str) -> str:
    try:
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
    except OSError as error:
        raise UnusableInput(f'{path} cannot be written: {error.strerror}') from None
    return path


def _bytes(path: str) -> bytes:
    try:
        with open(path, 'rb') as file:
            return file.read()
    except OSError:
        return b''
