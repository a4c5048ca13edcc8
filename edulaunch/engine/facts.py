"""Facts about an error in addition to its message, as plain data. `edulaunch.advice` turns these facts into sentences.

The module is in no package of the engine, because processes, the graph and the ROS packages attach facts, and recordings
store facts.
"""

from __future__ import annotations

from typing import Any, TypeVar

Error = TypeVar('Error', bound=BaseException)


def with_facts(error: Error, about: str, **data: Any) -> Error:
    """Attach facts to an error and return the error. Its message does not change.

    :param about: the name of the rule that explains this error, such as 'programs.after-shutdown'.
    :param data: the facts by name: strings, numbers, and lists of strings.
    """
    error.edulaunch_facts = {'about': about, **data}  # type: ignore[attr-defined]
    return error


def facts_of(error: BaseException | None) -> dict[str, Any]:
    """Return the facts of an error, or an empty dict for an error without facts."""
    found: dict[str, Any] = getattr(error, 'edulaunch_facts', {})
    return found


def with_facts_of(error: Error, other: BaseException) -> Error:
    """Copy the facts of the error `other` to `error`, which replaces `other`, and return `error`."""
    found = facts_of(other)
    return with_facts(error, **found) if found else error


def kind_of(value: object) -> str:
    """Return the kind of a value for the facts of an error: the name of its class, or 'None'.

    For a class, return 'the class ' and its name.
    """
    return 'None' if value is None else f'the class {value.__name__}' if isinstance(value, type) else type(value).__name__
