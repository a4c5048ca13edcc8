"""Services and actions: their classes, and the message types that ROS derives from them.

A class of a service or an action contains message classes, and cannot be instantiated.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from edulaunch.engine.interfaces.generator import module_of
from edulaunch.engine.interfaces.message import Lazy, Message
from edulaunch.engine.interfaces.spec import ActionSpec, Field, FieldType, MessageSpec, ServiceSpec

_GOAL_ID = Field('goal_id', FieldType('unique_identifier_msgs/msg/UUID'))


def event_of(service: ServiceSpec) -> MessageSpec:
    """Return the message type of a service's introspection events."""
    return MessageSpec(
        f'{service.type}_Event',
        (
            Field('info', FieldType('service_msgs/msg/ServiceEventInfo')),
            Field('request', FieldType(service.request.type, None, 'bounded', 1)),
            Field('response', FieldType(service.response.type, None, 'bounded', 1)),
        ),
        (),
        service.request.file,
    )


def send_goal_of(action: ActionSpec) -> ServiceSpec:
    """Return the service that carries a goal to an action server."""
    name, file = f'{action.type}_SendGoal', action.goal.file
    return ServiceSpec(
        name,
        MessageSpec(f'{name}_Request', (_GOAL_ID, Field('goal', FieldType(action.goal.type))), (), file),
        MessageSpec(
            f'{name}_Response',
            (Field('accepted', FieldType('bool')), Field('stamp', FieldType('builtin_interfaces/msg/Time'))),
            (),
            file,
        ),
    )


def get_result_of(action: ActionSpec) -> ServiceSpec:
    """Return the service that returns the result of a goal when the goal has ended."""
    name, file = f'{action.type}_GetResult', action.goal.file
    return ServiceSpec(
        name,
        MessageSpec(f'{name}_Request', (_GOAL_ID,), (), file),
        MessageSpec(
            f'{name}_Response', (Field('status', FieldType('int8')), Field('result', FieldType(action.result.type))), (), file
        ),
    )


def feedback_message_of(action: ActionSpec) -> MessageSpec:
    """Return the message type of the feedback topic."""
    return MessageSpec(
        f'{action.type}_FeedbackMessage', (_GOAL_ID, Field('feedback', FieldType(action.feedback.type))), (), action.goal.file
    )


def parts_of(spec: MessageSpec | ServiceSpec | ActionSpec) -> dict[str, MessageSpec | ServiceSpec | ActionSpec]:
    """Return the interface itself and every interface derived from it, by full type name."""
    if isinstance(spec, MessageSpec):
        return {spec.type: spec}
    if isinstance(spec, ServiceSpec):
        return {part.type: part for part in (spec, spec.request, spec.response, event_of(spec))}
    parts: dict[str, MessageSpec | ServiceSpec | ActionSpec] = {
        part.type: part for part in (spec, spec.goal, spec.result, spec.feedback, feedback_message_of(spec))
    }
    return parts | parts_of(send_goal_of(spec)) | parts_of(get_result_of(spec))


ClassOf = Callable[[str], type[Any]]


class InterfaceMeta(type):
    """The base of the metaclasses of services and actions."""

    _TYPE_SUPPORT: Any = None

    @classmethod
    def __import_type_support__(mcs) -> None:
        """Do nothing, because only the real rclpy needs type support in C."""


class Service(metaclass=InterfaceMeta):
    """The base class of service classes such as `turtlesim.srv.Spawn`."""

    TYPE: ClassVar[str]
    Request: ClassVar[type[Message]]
    Response: ClassVar[type[Message]]
    Event: ClassVar[type[Message]]


class Action(metaclass=InterfaceMeta):
    """The base class of action classes such as `turtlesim.action.RotateAbsolute`."""

    TYPE: ClassVar[str]
    Goal: ClassVar[type[Message]]
    Result: ClassVar[type[Message]]
    Feedback: ClassVar[type[Message]]
    Impl: ClassVar[type[Any]]


def _make(kind: str, base: type[Any], type_name: str, attributes: dict[str, Any]) -> type[Any]:
    """Return a class that cannot be instantiated and has its own metaclass."""
    name, module = _name(type_name), module_of(type_name)

    def refuse(self: object) -> None:
        raise NotImplementedError(f'{kind} classes can not be instantiated')

    refuse.__name__, refuse.__qualname__ = '__init__', f'{name}.__init__'
    metaclass = type(f'Metaclass_{name}', (InterfaceMeta,), {'__module__': module})
    made: type[Any] = metaclass(name, (base,), {'__module__': module, '__init__': refuse, 'TYPE': type_name, **attributes})
    return made


def make_service(spec: ServiceSpec, class_of: ClassOf) -> type[Service]:
    """Return the class of a service. The classes of its parts are created when a program first reads them."""
    parts = {part: f'{spec.type}_{part}' for part in ('Request', 'Response', 'Event')}
    return _make('Service', Service, spec.type, _lazy(class_of, parts))


def make_action(spec: ActionSpec, class_of: ClassOf) -> type[Action]:
    """Return the class of an action. The classes of its parts are created when a program first reads them."""
    impl = type(
        'Impl',
        (),
        {
            '__module__': module_of(spec.type),
            '__qualname__': f'{_name(spec.type)}.Impl',
            **_lazy(
                class_of,
                {
                    'SendGoalService': send_goal_of(spec).type,
                    'GetResultService': get_result_of(spec).type,
                    'FeedbackMessage': feedback_message_of(spec).type,
                    'CancelGoalService': 'action_msgs/srv/CancelGoal',
                    'GoalStatusMessage': 'action_msgs/msg/GoalStatusArray',
                },
            ),
        },
    )
    parts = {part: f'{spec.type}_{part}' for part in ('Goal', 'Result', 'Feedback')}
    return _make('Action', Action, spec.type, {'Impl': impl, **_lazy(class_of, parts)})


def _name(type_name: str) -> str:
    return type_name.split('/')[2]


def _lazy(class_of: ClassOf, types: dict[str, str]) -> dict[str, Lazy]:
    return {
        name: Lazy(lambda type_name=type_name: class_of(type_name))  # type: ignore[misc]
        for name, type_name in types.items()
    }
