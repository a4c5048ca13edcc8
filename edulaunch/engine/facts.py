"""Facts about an error beyond its message, as plain data. `edulaunch.advice` turns them into sentences.

The module belongs to no package of the engine, because processes, the graph and ROS's packages attach facts, and recordings store
them.
"""

from __future__ import annotations

from typing import Any, TypeVar

Error = TypeVar('Error', bound=BaseException)


def with_facts(error: Error, about: str, **data: Any) -> Error:
    """Attach facts to an error, which keeps its message, and return it.

    :param about: the rule with the sentences for it, such as 'programs.after-shutdown'.
    :param data: the facts by name: strings, numbers, and lists of strings.
    """
    error.edulaunch_facts = {'about': about, **data}  # type: ignore[attr-defined]
    return error


def facts_of(error: BaseException | None) -> dict[str, Any]:
    """Return the facts of an error; an empty dict if it has none."""
    found: dict[str, Any] = getattr(error, 'edulaunch_facts', {})
    return found


def with_facts_of(error: Error, other: BaseException) -> Error:
    """Attach the facts of another error to the error that replaces it, and return it."""
    found = facts_of(other)
    return with_facts(error, **found) if found else error


def kind_of(value: object) -> str:
    """Return the kind of a value for the facts: the name of its class, or 'None'."""
    return 'None' if value is None else f'the class {value.__name__}' if isinstance(value, type) else type(value).__name__
