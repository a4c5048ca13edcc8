"""Type support for service and action classes."""

from __future__ import annotations

import ctypes as c
from collections.abc import Callable
from typing import Any

from edulaunch.engine.interfaces.registry import Registry
from edulaunch.engine.interfaces.services import Action, Service
from edulaunch.extras.native.typesupport import abi
from edulaunch.extras.native.typesupport.description import described
from edulaunch.extras.native.typesupport.messages import members, message_support


def _with_metaclass(cls: type[Any], make_support: Callable[[], Any], **attributes: Any) -> type[Any]:
    """Return a class like `cls` whose metaclass has type support. It is created on first use."""
    metaclass: Any = type(f'Metaclass_{cls.__name__}', (type(cls),), {'_TYPE_SUPPORT': None})

    def import_type_support(_: type) -> None:
        if metaclass._TYPE_SUPPORT is None:
            metaclass._TYPE_SUPPORT = abi.capsule(c.addressof(make_support()))

    metaclass.__import_type_support__ = classmethod(import_type_support)
    made: type[Any] = metaclass(cls.__name__, (cls,), {'__module__': cls.__module__, **attributes})
    return made


def support_service(cls: type[Service], registry: Registry) -> type[Service]:
    """Return a service class that the real rclpy can use."""

    def make_support() -> abi.ServiceSupport:
        for part in (cls.Request, cls.Response):
            type(part).__import_type_support__()  # rclpy expects the type support of both parts
        return service_support(cls, registry)

    return _with_metaclass(cls, make_support)


def service_support(cls: type[Service], registry: Registry) -> abi.ServiceSupport:
    """Return the C type support of a service class.

    The event message has type support, but no code creates events. Service introspection of the real rclpy must stay off for this
    class.
    """
    package, kind, name = cls.TYPE.split('/')
    parts = (cls.Request, cls.Response, cls.Event)
    request, response, event = (c.addressof(message_support(part, registry)) for part in parts)
    callbacks = abi.keep(abi.ServiceCallbacks(f'{package}::{kind}'.encode(), name.encode(), request, response))
    inside = [c.addressof(members(part, registry)) for part in parts]
    listed = abi.keep(abi.ServiceMembers(f'{package}__{kind}'.encode(), name.encode(), *inside))
    looked = abi.keep(abi.ServiceSupport(abi.identifier(abi.INTROSPECTION), c.addressof(listed), abi.NO_VARIANTS['service']))
    made = abi.ServiceSupport(abi.identifier(abi.FASTRTPS), c.addressof(callbacks), None, request, response, event)
    made.function = abi.chooser(abi.keep(made), looked)
    made.hash, made.description, made.sources = described(cls.TYPE, registry)
    return made


def support_action(cls: type[Action], registry: Registry) -> type[Action]:
    """Return an action class that the real rclpy can use. The types for cancelling and status are those of the real rclpy."""
    from action_msgs.msg import GoalStatusArray
    from action_msgs.srv import CancelGoal

    goal, result, feedback = (registry.get(f'{cls.TYPE}_{part}') for part in ('SendGoal', 'GetResult', 'FeedbackMessage'))
    names = {
        'SendGoalService': goal,
        'GetResultService': result,
        'FeedbackMessage': feedback,
        'CancelGoalService': CancelGoal,
        'GoalStatusMessage': GoalStatusArray,
    }

    def make_support() -> abi.ActionSupport:
        made = abi.keep(abi.ActionSupport(*map(_support_address, (goal, result, CancelGoal, feedback, GoalStatusArray))))
        made.hash, made.description, made.sources = described(cls.TYPE, registry)
        return made  # type: ignore[no-any-return]

    return _with_metaclass(cls, make_support, Impl=type('Impl', (), names))


def _support_address(cls: Any) -> int:
    type(cls).__import_type_support__()
    return abi.capsule_address(type(cls)._TYPE_SUPPORT)
