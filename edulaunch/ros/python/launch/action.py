"""The base class of actions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ._bases import ParsedByFrontend, ReadOnly
from ._origin import MAKERS, Inherited, caller_outside_launch, note_origin, origin_of
from .condition import Condition
from .events.execution_complete import ExecutionComplete
from .launch_description_entity import ConditionalEntities, LaunchDescriptionEntity

if TYPE_CHECKING:
    from edulaunch.engine.processes import Origin

    from .frontend.entity import Entity
    from .frontend.parser_protocol import ParserProtocol
    from .launch_context import LaunchContext


def _only_a_condition(entity: Entity, parser: ParserProtocol) -> tuple[type, dict[str, Any]]:
    """Return the keyword arguments that every action element may have, from `if` and `unless`."""
    from .frontend.condition_of import condition_of

    return Action, condition_of(entity, parser)


class Action(LaunchDescriptionEntity):
    """Something that a launch file requests: start a program, set a value, include a file.

    Creating an action has no effect. :meth:`visit` executes it if its condition is true.

    :param condition: the condition for executing the action. Without one, the action is always executed.
    """

    def __init__(self, *, condition: Condition | None = None) -> None:
        self.__condition = condition
        self.__origin: Any = caller_outside_launch(self)

    @property
    def origin(self) -> Origin | None:
        """The file and line that created this action, or None if they are unknown. (edulaunch only.)"""
        place: Any = self.__dict__.get('_Action__origin')
        if type(place) is tuple:
            place = self.__origin = origin_of(place)
        return origin_of(place) if type(place) is Inherited else place

    @property
    def calls(self) -> list[tuple[str, Origin]]:
        """The functions of the launch file through which this action was created, each with the line that calls it. The
        innermost is first.

        The list is empty if a function that launch itself calls created the action, such as `generate_launch_description`.
        (edulaunch only.)
        """
        places: Any = self.__dict__.get('_Action__calls', ())
        return [(name, found) for name, place in places if (found := origin_of(place)) is not None]

    @property
    def is_made_by_launch(self) -> bool:
        """Whether launch itself created this action while it visited another action, from which it takes its origin. (edulaunch
        only.)
        """
        return type(self.__dict__.get('_Action__origin')) is Inherited

    def set_origin(self, file: str, line: int) -> None:
        """Set the file and line of an action that the parser of a launch file created."""
        self.__origin = (file, line)

    parse = ParsedByFrontend('action', _only_a_condition)
    """Class method: returns the class, and the keyword arguments for an element of an XML or YAML file."""

    condition: ReadOnly[Condition | None] = ReadOnly('The condition, or None.')

    def describe(self) -> str:
        """Return Python's `repr`, which plans and error messages show."""
        return repr(self)

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that launch visits because of this action, if they are known without executing it.

        Subclasses override this method.
        """
        return []

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the result of :meth:`get_sub_entities` if the action has no condition, and otherwise an empty list."""
        return self.get_sub_entities() if self.__condition is None else []

    def describe_conditional_sub_entities(self) -> ConditionalEntities:
        """Return the result of :meth:`get_sub_entities` with a description of the condition, if the action has one."""
        if self.__condition is None:
            return []
        return [(f'Conditionally included by {self.describe()}', self.get_sub_entities())]

    def visit(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Execute the action if its condition is true. Afterwards, emit an ExecutionComplete event if a handler is registered for
        this event.

        If the action raises an exception, add the action's file and line to the exception for the error message.
        """
        try:
            if self.__condition is not None and not self.__condition.evaluate(context):
                return None
            try:
                observer = getattr(context, 'observer', None)
                if observer is None:
                    return self.execute(context)
                execute = observer.instead_of(self)
                answer = self.execute(context) if execute is None else execute(self, context)
                observer.executed(self, context)
                return answer
            finally:
                self.__announce_completion(context)
        except Exception as error:
            note_origin(error, self)
            raise

    MAKERS[id(visit.__code__)] = visit.__code__

    def __announce_completion(self, context: LaunchContext) -> None:
        event = ExecutionComplete(action=self)
        if not context.would_handle_event(event):
            return
        future = self.get_asyncio_future()
        if future is None:
            context.emit_event_sync(event)
        else:
            future.add_done_callback(lambda _: context.emit_event_sync(event))

    def execute(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Execute the action. Return the entities to visit next, or None. :meth:`visit` calls this method, and subclasses
        override it.
        """
        return None
