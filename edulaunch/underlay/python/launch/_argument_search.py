"""The static search for launch arguments.

Upstream searches everything below a file when it is included, and so again at each level: quadratic in the
depth. Here what was found below a description that was only loaded to look inside is kept, as long as none of
the files changes that it came from.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ._static_loads import Loaded, is_current, loads_watched

if TYPE_CHECKING:
    from .actions.declare_launch_argument import DeclareLaunchArgument
    from .actions.include_launch_description import IncludeLaunchDescription
    from .launch_description import LaunchDescription
    from .launch_description_entity import LaunchDescriptionEntity

FoundArguments = list[tuple['DeclareLaunchArgument', list['IncludeLaunchDescription'] | None]]
Finding = tuple['DeclareLaunchArgument', bool, tuple['IncludeLaunchDescription', ...]]
"""An argument, whether it is only there under a condition, and the includes that lead to it."""


def found_arguments(entities: Iterable[LaunchDescriptionEntity], conditional: bool) -> FoundArguments:
    """The first declaration of each name in the entities and below them.

    :param conditional: whether the entities themselves are only there under a condition.
    """
    found: FoundArguments = []
    for argument, is_conditional, includes in _first_ones(_findings(entities, conditional)):
        argument._conditionally_included = is_conditional
        found.append((argument, list(includes) or None))
    return found


def _first_ones(findings: Iterable[Finding]) -> list[Finding]:
    first: dict[str, Finding] = {}
    for finding in findings:
        first.setdefault(finding[0].name, finding)
    return list(first.values())


def _findings(entities: Iterable[LaunchDescriptionEntity], conditional: bool) -> list[Finding]:
    """All below the entities; nothing is seen after a `ResetLaunchConfigurations`.

    As upstream, only what stands directly in a conditional branch counts as conditional: the arguments of a file that is
    included under a condition do not, and are checked even when the condition is false.
    """
    findings: list[Finding] = []
    for entity in entities:
        role = getattr(entity, '_search_role', '')
        if role == 'reset':
            break
        if role == 'argument':
            argument: Any = entity
            findings.append((argument, conditional or argument.condition is not None, ()))
        below = _below(entity)
        if role == 'include':
            include: Any = entity
            below = [(argument, conditional, (include, *includes)) for argument, conditional, includes in below]
        findings += below
    return findings


def _below(entity: Any) -> list[Finding]:
    findings = _inside(entity.describe_sub_entities(), False)
    for _, entities in entity.describe_conditional_sub_entities():
        findings += _inside(entities, True)
    return findings


def _inside(entities: Any, conditional: bool) -> list[Finding]:
    only: Any = entities[0] if isinstance(entities, list) and len(entities) == 1 else None
    loaded: Loaded | None = getattr(only, '_loaded', None)
    return list(_findings(entities, conditional) if loaded is None else _below_loaded(only, loaded))


def _below_loaded(description: LaunchDescription, loaded: Loaded) -> list[Finding]:
    """The same for a description that was only loaded to look inside."""
    if loaded.is_searched:
        return []  # it includes itself
    if loaded.findings is None or not is_current(loaded.files):
        loaded.is_searched = True
        with loads_watched() as files:
            loaded.findings = _first_ones(_findings([description], False))
        loaded.files, loaded.is_searched = files, False
    return loaded.findings
