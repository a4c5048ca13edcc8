"""Finds the rubric of an exercise. Rubrics are trusted files of the course, so they run in this process."""

from __future__ import annotations

import os
from collections.abc import Callable
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType

from edulaunch.errors import UnusableInput

from ..course import course_manifest, read_course
from ..faults import raise_fault
from ..files import read_regular
from ..rubric import Rubric, RubricMistake

_PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
RUBRICS = 'rubrics'
ENDINGS = ('.py', '.yaml', '.yml')
LARGEST_BYTES = 1_000_000


def rubrics_folder() -> str:
    """Return the folder of edugrade's own rubrics, inside the installed package or beside it in the source tree."""
    inside = os.path.join(_PACKAGE, 'checks')
    return inside if os.path.isdir(inside) else os.path.join(os.path.dirname(_PACKAGE), 'checks')


def course_rubrics(inside: str = '') -> str | None:
    """Return the directory ``rubrics`` of a course, beside its course.toml or one level above. Return None without a course.

    The function searches for the course in a folder (default: the current folder) and its parents, but never in a
    submission.
    """
    path = course_manifest(inside)
    if path is None:
        return None
    manifest = os.path.dirname(path)
    places = (os.path.join(place, RUBRICS) for place in (manifest, os.path.dirname(manifest)))
    return next(filter(os.path.isdir, places), None)


def exercises() -> list[str]:
    """Return the names of the exercises that have a rubric, in alphabetical order."""
    return sorted(_rubrics())


def _rubrics() -> dict[str, str]:
    """Return the file of each rubric, by the exercise's name. Rubrics of the course take precedence over rubrics of edugrade."""
    own = course_rubrics()
    return {**rubrics_in(rubrics_folder()), **(rubrics_in(own) if own else {})}


def rubrics_in(folder: str) -> dict[str, str]:
    """Return the file of each rubric in a folder, by the exercise's name."""
    names = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    parts = [(*os.path.splitext(name), name) for name in names if not name.startswith('_')]
    return {stem: os.path.join(folder, name) for stem, ending, name in parts if ending in ENDINGS}


def find_rubric(
    exercise: str, given: str | None = None, submission: str = '', personal: Callable[[str], str] | None = None
) -> tuple[str, Rubric]:
    """Return the name of an exercise and its rubric.

    :param exercise: the name of the submission's exercise.
    :param given: the file of a rubric, or the name of an exercise that replaces `exercise`, or None.
    :param submission: the folder of the submission. A rubric in this folder is rejected.
    :param personal: a function that changes the content of the rubric to a student's variant, or None.
    :raises UnusableInput: if there is no such rubric, with the names of the existing rubrics.
    :raises RubricMistake: if the rubric cannot be loaded.
    """
    if given is not None and _is_file(given):
        return os.path.splitext(os.path.basename(given))[0], load_rubric(given, personal)
    known, name = _rubrics(), given or exercise
    if name in known:
        if submission and os.path.realpath(known[name]).startswith(os.path.join(os.path.realpath(submission), '')):
            raise UnusableInput(
                f'the rubric {known[name]} is in the folder of the submission',
                help='keep rubrics in another folder than exercises',
            )
        return name, _by_the_course(name, load_rubric(known[name], personal))
    from edulaunch.engine.nearest import nearest

    close = nearest(name, list(known))
    hint = f'write --rubric {close}' if close else 'name one of these rubrics with --rubric'
    raise UnusableInput(
        f'there is no rubric named "{name}". Available rubrics: {", ".join(sorted(known)) or "none"}',
        help=f'{hint}, or write the path of a rubric file'
        if given != exercise
        else f'write {close or "one of these names"} instead of {name}',
    )


def _by_the_course(name: str, rubric: Rubric) -> Rubric:
    """Return a rubric with the points that the course around the current folder gives for its checks.

    Only rubrics of edugrade are changed.

    :raises UnusableInput: if the manifest gives points for a check that does not exist.
    """
    path = course_manifest()
    if path is None or os.path.dirname(rubric.file) != rubrics_folder():
        return rubric
    points = next((item.check_points for item in read_course(path) if item.name == name), None)
    if not points:
        return rubric
    try:
        found = rubric.with_points(points)
    except (ValueError, TypeError, AttributeError) as error:
        raise UnusableInput(f'{path}: check_points of {name}: {error}') from None
    table = {key: points[key] for key in sorted(points)}
    words = f'RUBRIC = RUBRIC.with_points({table})' if rubric.file.endswith('.py') else f'points: {table}'
    found.text = rubric.text + f'\n{words}\n'.encode()  # the text that is sent elsewhere and hashed includes these points
    return found


def _is_file(given: str) -> bool:
    return given.endswith(ENDINGS) or os.sep in given


def load_rubric(path: str, personal: Callable[[str], str] | None = None) -> Rubric:
    """Return the rubric in a file.

    :param personal: a function that changes the content of the rubric to a student's variant, or None.
    :raises UnusableInput: if the file cannot be read, or is not a rubric.
    :raises RubricMistake: if the rubric has a mistake.
    """
    try:
        data = read_regular(path, LARGEST_BYTES)
    except FileNotFoundError:
        raise UnusableInput(
            f'the rubric {path} does not exist', help=f'choose a rubric of the course: {", ".join(exercises())}'
        ) from None
    except OSError as error:
        raise_fault(error)
        raise UnusableInput(f'the rubric {path} cannot be read: {error.strerror}') from None
    if personal is not None:
        data = personal(data.decode('utf-8')).encode()
    if path.endswith('.py'):
        rubric = getattr(_module(path, data), 'RUBRIC', None)
    else:
        from .yaml_rubric import read_yaml_rubric

        rubric = read_yaml_rubric(path, data)
    if not isinstance(rubric, Rubric):
        raise UnusableInput(
            f'{path} is not a rubric: it defines no RUBRIC = Rubric(...)', help='write one as docs/rubrics.md shows'
        )
    rubric.file, rubric.text = path, data
    return rubric


def _module(path: str, data: bytes) -> ModuleType:
    """Execute the file of a rubric, and return the module.

    :raises RubricMistake: if the file raises an exception, with the line of the rubric.
    """
    spec = spec_from_loader(f'edugrade_rubric_{os.path.splitext(os.path.basename(path))[0]}', None)
    assert spec is not None  # None means that the loader cannot load the file
    module = module_from_spec(spec)
    module.__file__ = path
    try:
        exec(compile(data, path, 'exec', dont_inherit=True), module.__dict__)
    except SyntaxError as error:
        raise RubricMistake(f'{error.filename}:{error.lineno}: {error.msg}') from None
    except Exception as error:
        raise RubricMistake(f'{path}:{_line_of(error, path)}: {type(error).__name__}: {error}') from error
    return module


def _line_of(error: Exception, path: str) -> int:
    line, trace = 1, error.__traceback__
    while trace is not None:
        line = trace.tb_lineno if trace.tb_frame.f_code.co_filename == path else line
        trace = trace.tb_next
    return line
