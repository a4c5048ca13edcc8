"""The static search for launch arguments, and the files that are loaded only for this search.

Upstream searches everything below a file when it is included, and again at each level, so the time is quadratic in the depth.
Here each file is searched once within one visit, which executes includes of any depth one after the other. A file that is
launched is always loaded again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, TypeVar

from ._engine import running_process

if TYPE_CHECKING:
    from .launch_description_entity import LaunchDescriptionEntity

T = TypeVar('T')
FoundArguments = list[tuple[Any, 'list[Any] | None']]
"""`DeclareLaunchArgument` actions, each with the `IncludeLaunchDescription` actions that lead to it, if any."""
Finding = tuple[Any, bool, tuple[Any, ...]]
"""An argument, whether it is visited only under a condition, and the includes that lead to it."""
_KEY = 'launch.look'


class Look:
    """The results of files that were searched without being launched.

    :ivar descriptions: launch descriptions by type of source and location; None for a file that cannot be loaded.
    :ivar findings: the arguments found in a description and below it, by `id()` of the description; None before the search.
    """

    def __init__(self) -> None:
        self.descriptions: dict[tuple[type, str], Any] = {}
        self.findings: dict[int, list[Finding] | None] = {}


@contextmanager
def looking() -> Iterator[Look]:
    """Search each file only once inside this context. A nested context uses the results of the outer context."""
    state = running_process().state
    if _KEY in state:
        yield state[_KEY]
        return
    state[_KEY] = look = Look()
    try:
        yield look
    finally:
        del state[_KEY]


def load_once(source: object, location: str, load: Callable[[], T]) -> T | None:
    """Return the result of `load()`, or None if `load` raises an exception.

    The result is stored by source type and location, and later calls return the stored result.
    """
    with looking() as look:
        key = type(source), location
        if key not in look.descriptions:
            try:
                look.descriptions[key] = description = load()
                look.findings[id(description)] = None
            except Exception:
                look.descriptions[key] = None
        found: T | None = look.descriptions[key]
        return found


def found_arguments(entities: Iterable[LaunchDescriptionEntity], conditional: bool) -> FoundArguments:
    """Return the first declaration of each launch argument in the entities and in everything below them.

    :param conditional: whether the entities themselves are visited only under a condition.
    """
    found: FoundArguments = []
    with looking() as look:
        for argument, is_conditional, includes in _first_ones(_findings(entities, conditional, look)):
            argument._conditionally_included = is_conditional
            found.append((argument, list(includes) or None))
    return found


def _first_ones(findings: Iterable[Finding]) -> list[Finding]:
    first: dict[str, Finding] = {}
    for finding in findings:
        first.setdefault(finding[0].name, finding)
    return list(first.values())


def _findings(entities: Iterable[LaunchDescriptionEntity], conditional: bool, look: Look) -> list[Finding]:
    """Return all arguments below the entities, up to the first `ResetLaunchConfigurations`.

    As in upstream, only arguments directly in a conditional branch count as conditional. The arguments of a file that is included
    under a condition do not count as conditional, and are checked even when the condition is false.
    """
    findings: list[Finding] = []
    for entity in entities:
        role = getattr(entity, '_search_role', '')
        if role == 'reset':
            break
        if role == 'argument':
            argument: Any = entity
            findings.append((argument, conditional or argument.condition is not None, ()))
        below = _inside(entity.describe_sub_entities(), False, look)
        for _, branch in entity.describe_conditional_sub_entities():
            below += _inside(branch, True, look)
        if role == 'include':
            include: Any = entity
            below = [(argument, is_conditional, (include, *includes)) for argument, is_conditional, includes in below]
        findings += below
    return findings


def _inside(entities: Any, conditional: bool, look: Look) -> list[Finding]:
    only = id(entities[0]) if isinstance(entities, list) and len(entities) == 1 else 0
    if only not in look.findings:
        return _findings(entities, conditional, look)
    found = look.findings[only]
    if found is None:
        look.findings[only] = []  # set during the search, because the file may include itself
        found = look.findings[only] = _first_ones(_findings(entities, False, look))
    return list(found)
