"""A node on the real rclpy that records nodes and messages, for `edulaunch compare`.

The node prints a line when it is ready. It replies to each line on its standard input with one line of JSON: the nodes so far,
and the messages since the last reply. After 'end', or the end of its input, it first requests the parameters of all nodes.
"""

from __future__ import annotations

import base64
import json
import queue
import sys
import threading
import time
from collections.abc import Iterable
from typing import Any

import rclpy
from rcl_interfaces.srv import GetParameters, ListParameters
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import parameter_value_to_python
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from edulaunch.engine.interfaces.importer import installed_registry
from edulaunch.errors import InterfaceError

NAME = '_edulaunch_observer'
UNCLAIMED = '_NODE_NAME_UNKNOWN_'
"""ROS 2's name for the node of an endpoint until that node is known."""
LOOK_EVERY_S = 0.25
LOOK_AT_ALL_EVERY_S = 1.0
"""The number of rounds between two requests for the endpoints of all nodes, which are slow."""
TAKE_EVERY_S = 0.05
MOST_MESSAGES = 20_000
"""The maximum number of messages of one topic. Later messages are left out."""
PATIENCE_S = 10.0
"""The seconds in which nodes can report their parameters."""


class Observer:
    """The observation so far. Times are seconds since 1970."""

    def __init__(self) -> None:
        self.node = rclpy.create_node(NAME, start_parameter_services=False, enable_rosout=False)
        self.executor = SingleThreadedExecutor()
        self.nodes: dict[str, float] = {}
        self.ends: dict[tuple[str, str, str, str, str], float] = {}
        self.messages: dict[str, tuple[str, list[tuple[float, str]]]] = {}
        self.parameters: dict[str, dict[str, Any]] = {}
        self._subscriptions: dict[str, Any] = {}
        self._counts: dict[str, int] = {}
        self._known: Any = None
        self._looked_s = 0.0

    def look(self) -> None:
        """Record the current nodes, and subscribe to new topics."""
        now = time.time()
        names, topics = self.node.get_node_names_and_namespaces(), self.node.get_topic_names_and_types()
        if (names, topics) == self._known and now < self._looked_s + LOOK_AT_ALL_EVERY_S:
            return
        self._known, self._looked_s = (names, topics), now
        for name, namespace in names:
            full = f'{namespace.rstrip("/")}/{name}'
            if name != NAME:
                self.nodes.setdefault(full, now)
                self._look_at_services(name, namespace, full, now)
        for topic, types in topics:
            publishers = self.node.get_publishers_info_by_topic(topic)
            self._note('publisher', topic, publishers, now)
            self._note('subscription', topic, self.node.get_subscriptions_info_by_topic(topic), now)
            if publishers and topic not in self.messages:
                self._listen(topic, types[0], publishers)

    def _look_at_services(self, name: str, namespace: str, full: str, now: float) -> None:
        try:
            found = {
                'service': self.node.get_service_names_and_types_by_node(name, namespace),
                'client': self.node.get_client_names_and_types_by_node(name, namespace),
            }
        except Exception:  # the node has ended; the kind of error depends on the middleware
            return
        for kind, rows in found.items():
            for service, types in rows:
                self.ends.setdefault((kind, service, types[0], full, ''), now)

    def _note(self, kind: str, topic: str, infos: Iterable[Any], now: float) -> None:
        for info in infos:
            full = f'{info.node_namespace.rstrip("/")}/{info.node_name}'
            if info.node_name not in (NAME, UNCLAIMED):
                qos = f'{info.qos_profile.reliability.name} {info.qos_profile.durability.name}'.lower()
                self.ends.setdefault((kind, topic, info.topic_type, full, qos), now)

    def _listen(self, topic: str, type_name: str, publishers: list[Any]) -> None:
        self.messages[topic] = type_name, []
        registry = installed_registry()
        assert registry is not None
        try:
            message_class = registry.get(type_name)
        except InterfaceError:
            return  # a program with unknown message types
        offered = [info.qos_profile for info in publishers]
        reliable = all(each.reliability == ReliabilityPolicy.RELIABLE for each in offered)
        kept = all(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offered)
        qos = QoSProfile(
            depth=1000,
            reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
            durability=DurabilityPolicy.TRANSIENT_LOCAL if kept else DurabilityPolicy.VOLATILE,
        )
        silent = SubscriptionEventCallbacks(use_default_callbacks=False)
        self._subscriptions[topic] = self.node.create_subscription(
            message_class, topic, _leave, qos, raw=True, event_callbacks=silent
        )

    def take(self) -> None:
        """Take the waiting messages directly, because a turn of the executor for each message takes longer than all other work
        here.
        """
        for topic, subscription in self._subscriptions.items():
            while (taken := subscription.handle.take_message(subscription.msg_type, True)) is not None:
                data, info = taken
                self._counts[topic] = self._counts.get(topic, 0) + 1
                if self._counts[topic] <= MOST_MESSAGES:
                    sent_s = info['source_timestamp'] / 1e9 or time.time()
                    self.messages[topic][1].append((sent_s, base64.b64encode(data).decode()))

    def ask(self) -> None:
        """Request the parameters of all nodes, and ignore messages from then on."""
        for subscription in self._subscriptions.values():
            self.node.destroy_subscription(subscription)
        self._subscriptions.clear()
        self.executor.add_node(self.node)
        until = time.monotonic() + PATIENCE_S
        for full in self.nodes:
            if not full.rpartition('/')[2].startswith('_'):
                names = self._call(ListParameters, f'{full}/list_parameters', ListParameters.Request(), until)
                listed = [] if names is None else names.result.names
                values = self._call(GetParameters, f'{full}/get_parameters', GetParameters.Request(names=listed), until)
                if values is not None:
                    self.parameters[full] = dict(zip(listed, map(parameter_value_to_python, values.values), strict=False))

    def _call(self, kind: Any, name: str, request: Any, until: float) -> Any:
        client = self.node.create_client(kind, name)
        try:
            if not client.wait_for_service(timeout_sec=max(0.0, min(1.0, until - time.monotonic()))):
                return None
            future = client.call_async(request)
            self.executor.spin_until_future_complete(future, timeout_sec=max(0.0, until - time.monotonic()))
            return future.result() if future.done() else None
        finally:
            self.node.destroy_client(client)

    def report(self) -> str:
        """Return all data that were recorded since the last report, as JSON."""
        messages, self.messages = self.messages, {topic: (kind, []) for topic, (kind, _) in self.messages.items()}
        ends = [[*end, when] for end, when in self.ends.items()]
        report = {'nodes': self.nodes, 'ends': ends, 'messages': messages, 'parameters': self.parameters}
        return json.dumps(report, default=list)


def _leave(data: bytes) -> None:
    """Do nothing. This is the callback of the subscriptions, because :meth:`Observer.take` is faster."""


def _read(words: queue.SimpleQueue[str]) -> None:
    for line in sys.stdin:
        words.put(line.strip())
    words.put('end')


def main() -> int:
    """Observe until a line on standard input is 'end'."""
    rclpy.init(args=[])
    observer = Observer()
    words: queue.SimpleQueue[str] = queue.SimpleQueue()
    threading.Thread(target=_read, args=(words,), daemon=True).start()
    print('ready', flush=True)
    looked, word = 0.0, ''
    while word != 'end':
        word = '' if words.empty() else words.get()
        if word or time.monotonic() - looked > LOOK_EVERY_S:
            observer.look()
            looked = time.monotonic()
        observer.take()
        if word == 'end':
            observer.ask()
        if word:
            print(observer.report(), flush=True)
        time.sleep(TAKE_EVERY_S)
    rclpy.try_shutdown()
    return 0
