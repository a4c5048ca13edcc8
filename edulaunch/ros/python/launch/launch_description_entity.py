"""The base class of everything that launch can visit."""

from __future__ import annotations

import collections.abc
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from ._bases import StableRepr

if TYPE_CHECKING:
    import asyncio

    from .launch_context import LaunchContext

ConditionalEntities = list[tuple[str, Iterable['LaunchDescriptionEntity']]]


class LaunchDescriptionEntity(StableRepr):
    """An action, a launch description, or anything else with a `visit`."""

    _search_role: ClassVar[str] = ''
    """How the static search for launch arguments handles the entity: 'argument', 'include', 'reset', or '' to search its
    content.
    """

    def describe(self) -> str:
        """Return a description of the entity. Subclasses implement this method."""
        raise NotImplementedError('LaunchDescriptionEntity.describe must be overridden')

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities to which a visit always leads, as far as they are known without a visit."""
        return []

    def describe_conditional_sub_entities(self) -> ConditionalEntities:
        """Return the entities to which a visit may lead, in groups. Each group has a description of its condition."""
        return []

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Execute the entity. Return the entities to visit next, or None."""
        return None

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """Return the future that launch waits for before it is idle, or None if launch need not wait for this entity."""
        return None


SomeEntitiesType = LaunchDescriptionEntity | Iterable[LaunchDescriptionEntity]
"""One entity or several."""

SomeEntitiesType_types_tuple = (LaunchDescriptionEntity, collections.abc.Iterable)
