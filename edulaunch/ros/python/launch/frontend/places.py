"""Places and facts that edulaunch attaches to errors of ROS in XML and YAML launch files.

The attributes of the error are `edulaunch_file`, `edulaunch_line`, and its facts (`edulaunch.engine.facts`). `edulaunch.advice`
creates messages from the facts.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from edulaunch.engine.facts import facts_of, with_facts

from .._origin import origin_of

if TYPE_CHECKING:
    from .entity import Entity

Error = TypeVar('Error', bound=BaseException)


def at(error: Error, entity: Entity, about: str = 'launch.element', **facts: Any) -> Error:
    """Attach the line of the element, and facts about it, to the error. Return the error."""
    error.edulaunch_line = entity.line  # type: ignore[attr-defined]
    return with_facts(error, about, element=str(entity.type_name), shown=entity.shown, **facts)


def complete(error: BaseException, file: str, entity: Entity) -> None:
    """Add the file, and the facts that are still missing, to an `error` raised while `entity` was parsed.

    The innermost element is the first to add them.
    """
    if hasattr(error, 'edulaunch_file'):
        return
    if not hasattr(error, 'edulaunch_line'):
        known = facts_of(error)
        at(error, entity)
        if known:
            with_facts(error, **known)
    _point_to(error, file, error.edulaunch_line)  # type: ignore[attr-defined]


def complete_unreadable(error: Any, file: str) -> None:
    """Add the place and the problem to the error for a file in an invalid format."""
    mark = getattr(error, 'problem_mark', None)
    line = getattr(error, 'edulaunch_line', 0) or (mark.line + 1 if mark is not None else _first_or_bad_line(error))
    if not facts_of(error) and not isinstance(error, UnicodeDecodeError):
        problem = getattr(error, 'problem', None) or str(error)
        with_facts(error, 'launch.unreadable', problem=problem.split('\n', 1)[0])
    _point_to(error, file, line)


def _first_or_bad_line(error: Exception) -> int:
    """Return the line of a byte that is not UTF-8. Any other problem concerns the whole file, so return line 1."""
    return error.object.count(b'\n', 0, error.start) + 1 if isinstance(error, UnicodeDecodeError) else 1


def _point_to(error: Any, file: str, line: int) -> None:
    """Store the place in the same form as for an error of a Python launch file (see `launch._origin`)."""
    error.edulaunch_file, error.edulaunch_line = file, line
    if file and not hasattr(error, 'edulaunch_origin'):
        error.edulaunch_origin = origin_of((file, line))
