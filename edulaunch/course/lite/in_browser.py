"""The functions that the page in the browser calls: list files, launch, check. Each function returns JSON."""

from __future__ import annotations

import json
import os
import shlex
import traceback
from collections.abc import Callable

from edulaunch.errors import EdulaunchError, UnusableInput

DEMOS = (
    ('turtlesim', 'multisim.launch.py', 'Two worlds'),
    ('turtle_tf2_py', 'turtle_tf2_demo.launch.py', 'A turtle follows another one'),
    ('turtle_tf2_py', 'turtle_tf2_fixed_frame_demo.launch.py', 'A carrot beside turtle1'),
    ('turtle_tf2_py', 'turtle_tf2_dynamic_frame_demo.launch.py', 'A carrot that moves'),
)
"""The launch files that come with edulaunch and show something in the browser."""


def contents(course: str) -> str:
    """Return the launch files that the page offers: exercises of the course that are one file, and examples that come with
    edulaunch.

    :param course: the folder of the course, which contains course.toml or exercises/course.toml.
    """
    from edugrade.course import read_course

    from edulaunch.course.lessons import EXERCISES, manifest
    from edulaunch.engine.underlay_place import underlay_prefix

    place = manifest(course)
    exercises = [entry for entry in read_course(place) if entry.path == entry.file] if place else []
    files = [
        {'title': entry.title, 'exercise': entry.name, **_file(os.path.join(course, EXERCISES, entry.file))}
        for entry in exercises
    ]
    share = os.path.join(underlay_prefix(), 'share')
    files += [
        {'title': title, 'exercise': '', **_file(os.path.join(share, package, 'launch', name))} for package, name, title in DEMOS
    ]
    return json.dumps(files)


def _file(path: str) -> dict[str, str]:
    with open(path, encoding='utf-8') as file:
        return {'name': os.path.basename(path), 'text': file.read()}


def launch(path: str, text: str, words: str, seconds: float, say: Callable[[str], object]) -> str:
    """Save and launch a file, and return the page that replays the run.

    :param words: launch arguments in the form ``name:=value ...``.
    :param seconds: the duration of the run, in simulated seconds.
    :param say: called with each printed line.
    """
    return _answer(lambda: _launched(_saved(path, text), _arguments(words), seconds, say))


def check(path: str, text: str) -> str:
    """Save and grade a file, and return the report as a page."""
    return _answer(lambda: _checked(_saved(path, text)))


def _answer(work: Callable[[], dict[str, str]]) -> str:
    """Return the result for the page: `page` with an HTML page, or `error` with a message."""
    try:
        return json.dumps(work())
    except EdulaunchError as error:
        return json.dumps({'error': str(error)})
    except Exception:
        return json.dumps({'error': traceback.format_exc()})


def _saved(path: str, text: str) -> str:
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)
    return path


def _arguments(words: str) -> dict[str, str]:
    found = [word.partition(':=') for word in shlex.split(words)]
    for name, sign, _ in found:
        if not sign:
            raise UnusableInput(f'{name} is not a launch argument', help='write name:=value, and separate arguments by spaces')
    return {name: value for name, _, value in found}


def _launched(path: str, arguments: dict[str, str], seconds: float, say: Callable[[str], object]) -> dict[str, str]:
    from edulaunch.advice.rendering import end_of_run_lines
    from edulaunch.desk.view.page import recorded_page
    from edulaunch.desk.view.replay import timeline_of
    from edulaunch.runtime.session import run

    recording = run(path, arguments=arguments, duration_s=seconds, workspaces=(), console=lambda stream, text: say(text))
    for line in end_of_run_lines(recording):
        say(f'{line}\n')
    return {'page': recorded_page(timeline_of(recording), os.path.basename(path))}


def _checked(path: str) -> dict[str, str]:
    from edugrade.grading import grade, plan_work
    from edugrade.reports.page import page
    from edugrade.submission import Submission

    (report,) = grade([plan_work(Submission(path))])
    return {'page': page([report], []), 'said': f'{report.rubric}: {report.verdict}\n'}
