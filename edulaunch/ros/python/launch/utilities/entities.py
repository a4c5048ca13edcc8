"""Convert entities to a flat list, and execute them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ..launch_description_entity import LaunchDescriptionEntity, SomeEntitiesType

if TYPE_CHECKING:
    import asyncio

    from .._include_ring import Include
    from .._observer import Observer
    from ..launch_context import LaunchContext


def normalize_to_list_of_entities(entities: SomeEntitiesType) -> list[LaunchDescriptionEntity]:
    """Return one entity, or a possibly nested iterable of entities, as a flat list.

    :raises TypeError: for anything else.
    """
    return list(_flat(entities))


def _flat(entities: Any) -> Iterable[LaunchDescriptionEntity]:
    if isinstance(entities, LaunchDescriptionEntity):
        yield entities
        return
    for entity in entities:
        if isinstance(entity, str):
            raise TypeError(
                f"Failed to normalize given item of type '{type(entity)}', when only "
                "'launch.LaunchDescriptionEntity' was expected."
            )
        yield from _flat(entity)


EntityFuturePairs = list[tuple[LaunchDescriptionEntity, 'asyncio.Future[Any]']]


def visit_all_entities_and_collect_futures(entity: LaunchDescriptionEntity, context: LaunchContext) -> EntityFuturePairs:
    """Visit the entity, and then every entity that a visit returns, depth first and in order.

    :returns: each visited entity that has a future, with that future.
    """
    pairs: EntityFuturePairs = []
    around = getattr(context, 'open_includes', None)
    includes = context.open_includes = [] if around is None else around
    observer = getattr(context, 'observer', None)
    try:
        if observer is None:
            _visit(entity, context, includes, pairs)
        else:
            _visit_observed(entity, context, includes, pairs, observer)
    finally:
        context.open_includes = around
    return pairs


def _visit(entity: LaunchDescriptionEntity, context: LaunchContext, includes: list[Include], pairs: EntityFuturePairs) -> None:
    depth = len(includes)
    sub_entities = entity.visit(context)
    future = entity.get_asyncio_future()
    if future is not None:
        pairs.append((entity, future))
    if sub_entities is not None:
        for sub_entity in sub_entities:
            _visit(sub_entity, context, includes, pairs)
        del includes[depth:]


def _visit_observed(
    entity: LaunchDescriptionEntity, context: LaunchContext, includes: list[Include], pairs: EntityFuturePairs, observer: Observer
) -> None:
    """Visit as :func:`_visit` does, and call the observer."""
    depth = len(includes)
    observer.enter(entity, context)
    error = None
    try:
        sub_entities = entity.visit(context)
        future = entity.get_asyncio_future()
        if future is not None:
            pairs.append((entity, future))
        if sub_entities is not None:
            observer.leads_to(entity, sub_entities)
            for sub_entity in sub_entities:
                _visit_observed(sub_entity, context, includes, pairs, observer)
            del includes[depth:]
    except Exception as caught:
        error = caught
        raise
    finally:
        observer.leave(entity, context, error)
