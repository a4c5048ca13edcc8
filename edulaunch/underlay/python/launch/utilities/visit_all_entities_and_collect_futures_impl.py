"""The walk that executes a launch description."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    import asyncio

    from ..launch_context import LaunchContext

EntityFuturePairs = list[tuple[LaunchDescriptionEntity, 'asyncio.Future[Any]']]


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> EntityFuturePairs:
    """Visit the entity, then, in order and depth first, every entity its visit returns.

    :returns: each visited entity that has a future, with that future.
    """
    pairs: EntityFuturePairs = []
    _visit(entity, context, pairs)
    return pairs


def _visit(entity: LaunchDescriptionEntity, context: LaunchContext, pairs: EntityFuturePairs) -> None:
    includes = context._includes
    depth = len(includes)
    sub_entities = entity.visit(context)
    future = entity.get_asyncio_future()
    if future is not None:
        pairs.append((entity, future))
    if sub_entities is not None:
        for sub_entity in sub_entities:
            _visit(sub_entity, context, pairs)
        del includes[depth:]
