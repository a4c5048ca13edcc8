"""Functions that check whether a class is a message, a service or an action.

The module also defines the type variables for annotations of publishers, subscriptions, clients and services.
"""

from __future__ import annotations

from typing import Any, TypeVar

from edulaunch.engine.facts import kind_of, with_facts
from edulaunch.ros.passed_on import passed_on


def check_for_type_support(msg_or_srv_type: Any) -> None:
    """Raise AttributeError, with ROS 2's hint, for an object that is not an interface class."""
    if not isinstance(getattr(msg_or_srv_type, 'TYPE', None), str):
        raise AttributeError(
            f"type object '{type(msg_or_srv_type).__name__}' has no attribute '_TYPE_SUPPORT' This might be a ROS 1 message type "
            'but it should be a ROS 2 message type. Make sure to source your ROS 2 workspace after your ROS 1 workspace.'
        )


def check_is_valid_msg_type(msg_type: Any) -> None:
    """Raise an error unless a class is a message class.

    :raises RuntimeError: for a service or action class.
    :raises AttributeError: for anything else.
    """
    check_for_type_support(msg_type)
    if not _has(msg_type, 'to_wire'):
        raise RuntimeError(f'The message type provided is not valid ({msg_type}), this might be a service or action')


def check_is_valid_srv_type(srv_type: Any) -> None:
    """Raise an error unless a class is a service class.

    :raises RuntimeError: for a message or action class.
    :raises AttributeError: for anything else.
    """
    check_for_type_support(srv_type)
    if not (_has(srv_type, 'Request') and _has(srv_type, 'Response')):
        raise RuntimeError(f'The service type provided is not valid ({srv_type}), this might be a message or action')


def check_is_valid_action_type(action_type: Any) -> None:
    """Raise an error unless a class is an action class.

    :raises RuntimeError: for a message or service class.
    :raises AttributeError: for anything else.
    """
    check_for_type_support(action_type)
    if not (_has(action_type, 'Goal') and _has(action_type, 'Impl')):
        raise RuntimeError(f'The action type provided is not valid ({action_type}), this might be a message or service')


def wrong_class(given: Any, interface: Any, part: str) -> TypeError:
    """Return ROS 2's empty error, with a hint, for an object that is not a `Service.Request` or similar."""
    wanted = f'{interface.__name__}.{part}'
    if isinstance(given, type):
        return with_facts(TypeError(), 'messages.class-given', wanted=wanted)
    return with_facts(TypeError(), 'messages.other-class', wanted=wanted, given=kind_of(given))


def _has(cls: Any, name: str) -> bool:
    """Return whether an attribute exists. Do not create the parts of services and actions, which exist only after their first
    use.
    """
    for base in getattr(cls, '__mro__', ()):  # noqa: SIM110 - a loop takes half the time, and each service asks twice
        if name in base.__dict__:
            return True
    return False


__getattr__ = passed_on(__name__)

MsgType = TypeVar('MsgType')
SrvType = TypeVar('SrvType')
SrvTypeRequest = TypeVar('SrvTypeRequest')
SrvTypeResponse = TypeVar('SrvTypeResponse')
