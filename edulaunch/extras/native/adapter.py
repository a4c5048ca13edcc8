"""The few names that edulaunch's rclpy has in addition to the names of ROS 2, for edulaunch's programs on the real rclpy."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from functools import cached_property
from importlib.machinery import ModuleSpec, PathFinder
from typing import Any

from edulaunch.ros import node_facts
from edulaunch.ros.serialization.cdr import decode, encode

AT_ONCE = 100
"""The number of callbacks that `rcl_spin_ready` runs before it checks for later events."""
_ITS_OWN = frozenset(('rclpy', 'rcl_interfaces', 'rpyutils', 'rosidl_parser', 'rosidl_pycommon'))


class Faces:
    """Finds edulaunch's Python packages before other packages of the same name. rclpy and its parts are those of the real
    rclpy.
    """

    def __init__(self, folder: str) -> None:
        self._folder = folder

    def find_spec(self, name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Find a top-level package of edulaunch, as the import protocol requires."""
        if path is not None or name in _ITS_OWN or not os.path.isdir(os.path.join(self._folder, name)):
            return None
        return PathFinder.find_spec(name, [self._folder])


def install(faces: str) -> None:
    """Make the modules that edulaunch's programs need available in a process with the real rclpy.

    :param faces: the folder of edulaunch's Python packages.
    """
    sys.meta_path.insert(0, Faces(faces))
    node_facts.choose(_NodeFacts.of)
    _messages()
    _times()
    _executors()


def _messages() -> None:
    """Make publishers accept and subscriptions return wire tuples, so that no message objects are created."""
    from rclpy.context import Context
    from rclpy.publisher import Publisher
    from rclpy.subscription import Subscription

    def send(publisher: Any, wire: tuple[Any, ...]) -> None:
        publisher.publish(encode(publisher.msg_type, wire))

    def take_wires(subscription: Any, callback: Callable[[Any], object]) -> None:
        kind = subscription.msg_type
        subscription.raw = True
        subscription.callback = lambda data: callback(decode(kind, data))

    from rclpy.utilities import get_default_context

    add: Callable[..., None] = _add
    add(Publisher, send_wire=send, context=property(lambda each: get_default_context()))
    add(Subscription, rcl_take_wires=take_wires)
    add(Context, alive=property(lambda context: context.ok()), rcl_park=_park, waits=[])


def _park(context: Any, deadline_ns: int | None) -> None:
    """Wait a moment, at most until the deadline, with the function of `waits`, if any."""
    left_s = 0.05 if deadline_ns is None else (deadline_ns - time.time_ns()) / 1e9
    for wait in context.waits or (time.sleep,):
        wait(max(0.0, min(left_s, 0.05)))


class _NodeFacts:
    """The facts about one node of an edulaunch program: its names, and its parameter overrides."""

    destroyed = True  # prevents collecting facts from it

    def __init__(self, node: Any) -> None:
        self._node = node

    @classmethod
    def of(cls, node: Any) -> _NodeFacts:
        """Return the data of a node. Create them at the first call."""
        found: _NodeFacts = node.__dict__.setdefault('_edulaunch_facts', cls(node))
        return found

    @property
    def takes_any_type(self) -> bool:
        """Return False, because a real subscription cannot accept several types."""
        return False

    @takes_any_type.setter
    def takes_any_type(self, wanted: bool) -> None:
        pass

    def resolve(self, name: str, kind: str, only_expand: bool = False) -> str:
        """Return the absolute name, after remapping. On request, only expand the name."""
        resolve = self._node.resolve_topic_name if kind == 'topic' else self._node.resolve_service_name
        return str(resolve(name, only_expand=only_expand))

    @cached_property
    def graph(self) -> Any:
        """Return the topics that can be recorded."""
        from edulaunch.engine.processes.current import current_process
        from edulaunch.extras.native.bag_topics import BagTopics

        return BagTopics(self._node, current_process())

    @property
    def entry(self) -> Any:
        """The object that represents the node in a graph."""
        return self.graph.entry

    @property
    def overrides(self) -> Any:
        """Return the parameter values from the command line and its parameter files."""
        from edulaunch.engine.graph.ros_arguments import parse_ros_arguments

        return parse_ros_arguments(sys.argv).overrides_for(self._node.get_fully_qualified_name())


def _times() -> None:
    from rclpy.clock import Clock
    from rclpy.time import Time

    _add(Clock, rcl_now_ns=lambda clock: clock.now().nanoseconds)
    _add(Time, _nanoseconds=property(lambda each: each.nanoseconds))


def _executors() -> None:
    from rclpy.executors import SingleThreadedExecutor

    _add(SingleThreadedExecutor, rcl_spin_ready=_spin_ready)


def _spin_ready(executor: Any) -> None:
    from rclpy.executors import ShutdownException, TimeoutException

    for _ in range(AT_ONCE):
        try:
            handler, _, _ = executor.wait_for_ready_callbacks(timeout_sec=0)
        except (TimeoutException, ShutdownException):
            return
        handler()
        if handler.exception() is not None:
            raise handler.exception()


def _add(kind: Any, **names: object) -> None:
    for name, value in names.items():
        setattr(kind, name, value)
