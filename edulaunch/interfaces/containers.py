"""Service and action classes: namespaces that hold message classes and are never instantiated."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

from edulaunch.interfaces.derived import feedback_message_of, get_result_of, send_goal_of
from edulaunch.interfaces.generator import module_of
from edulaunch.interfaces.message import Lazy, Message
from edulaunch.interfaces.spec import ActionSpec, ServiceSpec

ClassOf = Callable[[str], type[Any]]


class Service:
    """Base of service classes such as `turtlesim.srv.Spawn`."""

    TYPE: ClassVar[str]
    Request: ClassVar[type[Message]]
    Response: ClassVar[type[Message]]
    Event: ClassVar[type[Message]]

    def __init__(self) -> None:
        raise NotImplementedError('Service classes can not be instantiated')


class Action:
    """Base of action classes such as `turtlesim.action.RotateAbsolute`."""

    TYPE: ClassVar[str]
    Goal: ClassVar[type[Message]]
    Result: ClassVar[type[Message]]
    Feedback: ClassVar[type[Message]]
    Impl: ClassVar[type[Any]]

    def __init__(self) -> None:
        raise NotImplementedError('Action classes can not be instantiated')


def make_service(spec: ServiceSpec, class_of: ClassOf) -> type[Service]:
    """The class of a service; its parts are made when first read."""
    return type(
        _name(spec.type),
        (Service,),
        {
            '__module__': module_of(spec.type),
            'TYPE': spec.type,
            **_lazy(class_of, {part: f'{spec.type}_{part}' for part in ('Request', 'Response', 'Event')}),
        },
    )


def make_action(spec: ActionSpec, class_of: ClassOf) -> type[Action]:
    """The class of an action; its parts are made when first read."""
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
    return type(
        _name(spec.type),
        (Action,),
        {
            '__module__': module_of(spec.type),
            'TYPE': spec.type,
            'Impl': impl,
            **_lazy(class_of, {part: f'{spec.type}_{part}' for part in ('Goal', 'Result', 'Feedback')}),
        },
    )


def _name(type_name: str) -> str:
    return type_name.split('/')[2]


def _lazy(class_of: ClassOf, types: dict[str, str]) -> dict[str, Lazy]:
    return {
        name: Lazy(lambda type_name=type_name: class_of(type_name))  # type: ignore[misc]
        for name, type_name in types.items()
    }
