"""What is known about an error besides its text, as plain data. `edulaunch.advice` has the words for it.

The module belongs to no room of the engine: the processes, the graph and ROS's packages attach facts, and each recording keeps
them.
"""

from __future__ import annotations

from typing import Any, TypeVar

Error = TypeVar('Error', bound=BaseException)


def with_facts(error: Error, about: str, **data: Any) -> Error:
    """Return the error, which keeps its own text and now carries facts.

    :param about: the rule that has words for it, such as 'programs.after-shutdown'.
    :param data: the values of these names: strings, numbers, and lists of strings.
    """
    error.edulaunch_facts = {'about': about, **data}  # type: ignore[attr-defined]
    return error


def facts_of(error: BaseException | None) -> dict[str, Any]:
    """Return the facts of an error; an empty dict if it has none."""
    found: dict[str, Any] = getattr(error, 'edulaunch_facts', {})
    return found


def with_facts_of(error: Error, other: BaseException) -> Error:
    """Return the error, which is raised in place of another one, with that one's facts."""
    found = facts_of(other)
    return with_facts(error, **found) if found else error


def kind_of(value: object) -> str:
    """Return what a value is, for the facts: the name of its class, or 'None'."""
    return 'None' if value is None else type(value).__name__
