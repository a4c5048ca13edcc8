"""Finds the rubric of an exercise. Rubrics are trusted files of the course: they are run in this process."""

from __future__ import annotations

import os
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader

from edulaunch.errors import UnusableInput

from .rubric import Rubric

_HERE = os.path.dirname(os.path.abspath(__file__))


def rubrics_folder() -> str:
    """Where the course's rubrics are: inside the installed package, or beside it in the source tree."""
    inside = os.path.join(_HERE, 'checks')
    return inside if os.path.isdir(inside) else os.path.join(os.path.dirname(_HERE), 'checks')


def exercises() -> list[str]:
    """The names of the exercises that have a rubric, in alphabetical order."""
    folder = rubrics_folder()
    names = os.listdir(folder) if os.path.isdir(folder) else []
    return sorted(name[:-3] for name in names if name.endswith('.py') and not name.startswith('_'))


def find_rubric(exercise: str, given: str | None = None) -> tuple[str, Rubric]:
    """The rubric of an exercise and its name.

    :param given: a rubric's file, or an exercise's name, instead of the one of the submission's file name.
    :raises UnusableInput: when there is none, naming those there are.
    """
    path = rubric_file(exercise, given)
    name = os.path.splitext(os.path.basename(path))[0]
    if _is_file(given):
        return name, _load(path)
    known = exercises()
    if name in known:
        return name, _load(path)
    from edulaunch.nearest import nearest

    close = nearest(name, known)
    hint = f'did you mean {close}? ' if close else ''
    raise UnusableInput(
        f'there is no rubric for "{name}"; there are: {", ".join(known) or "none"}',
        help=f'{hint}Name the file after its exercise (circle.launch.py), or give --rubric NAME or FILE',
    )


def rubric_file(exercise: str, given: str | None = None) -> str:
    """The file of the rubric that `find_rubric` finds for these, or would find."""
    return given if given is not None and _is_file(given) else os.path.join(rubrics_folder(), f'{given or exercise}.py')


def _is_file(given: str | None) -> bool:
    return given is not None and (given.endswith('.py') or os.sep in given)


def _load(path: str) -> Rubric:
    if not os.path.isfile(path):
        raise UnusableInput(f'the rubric {path} does not exist', help=f'rubrics of the course: {", ".join(exercises())}')
    name = f'edugrade_rubric_{os.path.splitext(os.path.basename(path))[0]}'
    spec = spec_from_loader(name, SourceFileLoader(name, path))
    if spec is None or spec.loader is None:
        raise UnusableInput(f'the rubric {path} cannot be loaded')
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    rubric = getattr(module, 'RUBRIC', None)
    if not isinstance(rubric, Rubric):
        raise UnusableInput(
            f'{path} is not a rubric: it defines no RUBRIC = Rubric(...)', help='docs/grading.md shows how to write one'
        )
    return rubric
