"""The child process of the rclpy link. It creates nodes and endpoints on the real rclpy as the link requests.

Frames (`rclpy_wire`) pass over the socket whose number is the first word of the command line. Messages pass as bytes.
One thread reads frames and publishes their messages. All other calls of rclpy happen in the thread of its executor, which is
woken only for them. An executor checks all its nodes each time, which costs more than the messages.
"""

from __future__ import annotations

import json
import os
import socket
import sys
import threading
import time
from collections import Counter, deque
from collections.abc import Callable
from contextlib import suppress
from hashlib import sha256
from importlib import import_module
from typing import Any

import rclpy
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import deserialize_message, serialize_message

from edulaunch.extras.native.loopback import is_alone
from edulaunch.extras.native.qos import from_rclpy, to_rclpy
from edulaunch.extras.native.typesupport.classes import ITS_OWN, SupportedClasses, layered
from edulaunch.extras.network import rclpy_wire as wire
from edulaunch.extras.network.network_link import ENCLAVE, KEPT, MARK, WAITING
from edulaunch.runtime.framing import Frames

LOOK_EVERY_S = 0.1
"""The period of checks for names of nodes and topics."""
LOOK_CLOSELY_EVERY_S = 0.5
"""The period of checks for all endpoints, even without new names."""
PAUSE = 9
"""The pause between two checks, in multiples of a check's duration. Thousands of topics would otherwise take all the time."""
SETTLED_S = 2.0
"""The time after a change of names in which each check includes all endpoints. A node creates them one after the other."""
AT_ONCE = 100
"""The number of messages of one subscription that one turn takes."""
_NOT_YET = object()


class Side:
    """Carries out the requests of the link."""

    def __init__(self, connection: socket.socket) -> None:
        self.connection = connection
        self.executor = SingleThreadedExecutor()
        self.helper = _node(f'{MARK}_{os.urandom(4).hex()}', '/')  # a random name, because each machine has such a helper
        self.executor.add_node(self.helper)
        self.inbox: deque[tuple[int, int, int, bytes]] = deque()
        self.lock, self.mouth = threading.Lock(), threading.Lock()
        self.nodes: dict[int, Any] = {}
        self.ends: dict[int, tuple[str, Any, int]] = {}
        self.pending: dict[int, tuple[Any, Any]] = {}
        self.early: list[tuple[int, int, bytes]] = []
        self.serial = 0
        self.registries: dict[str, SupportedClasses] = {}
        self.message = ''
        self.names: list[Any] = []
        self.changed_s = self.looked_s = 0.0
        self.own = self._own_prefix()
        self.guard = self.helper.create_guard_condition(self.work)

    def _own_prefix(self) -> bytes:
        """Return the first bytes of the gids of this process's own participant."""
        while True:
            for info in self.helper.get_publishers_info_by_topic('/parameter_events'):
                if info.node_name == self.helper.get_name():
                    return bytes(info.endpoint_gid)[:12]
            time.sleep(0.01)

    def say(self, kind: int, handle: int = 0, number: int = 0, data: bytes = b'') -> None:
        """Send a frame to the link."""
        with self.mouth:
            self.connection.sendall(wire.frame(kind, handle, number, data))

    def read(self) -> None:
        """Receive frames in a thread until the link closes."""
        frames = Frames()
        with suppress(ConnectionResetError):
            while data := self.connection.recv(1 << 16):
                left = [frame for frame in wire.opened(frames.feed(data)) if not self.is_published(*frame)]
                if left:
                    self.guard.trigger()
        rclpy.try_shutdown()

    def is_published(self, *frame: Any) -> bool:
        """Publish a message if all earlier requests are done, and return True. Otherwise, queue the frame for the executor."""
        with self.lock:
            if frame[0] != wire.PUBLISH or self.inbox:
                self.inbox.append(frame)
                return False
            self.do(*frame)
            return True

    def work(self) -> None:
        """Handle the waiting frames."""
        while self.inbox:
            with self.lock:
                self.do(*self.inbox.popleft())

    def do(self, kind: int, handle: int, number: int, data: bytes) -> None:
        """Handle one frame. If rclpy raises an error, report it and continue with the next frame."""
        try:
            _WORK[kind](self, handle, number, data)
        except Exception as error:
            self.say(wire.TROUBLE, handle, 0, f'{type(error).__name__}: {error}'.encode())

    def add_node(self, handle: int, number: int, data: bytes) -> None:
        namespace, name = json.loads(data)
        self.nodes[handle] = made = _node(name, namespace)
        self.executor.add_node(made)

    def remove_node(self, handle: int, number: int, data: bytes) -> None:
        node = self.nodes.pop(handle)
        self.executor.remove_node(node)
        node.destroy_node()

    def add(self, handle: int, number: int, data: bytes) -> None:
        message = json.loads(data)
        node, kind, name = self.nodes[number], message['kind'], message['name']
        cls, qos = self._class(message['type'], message['layers']), to_rclpy(message['qos'])
        end = getattr(self, f'_add_{kind}')(handle, node, name, cls, qos)
        self.ends[handle] = kind, end, number

    def _class(self, type_name: str, layers: list[Any]) -> Any:
        package, kind, name = type_name.split('/')
        if package in ITS_OWN:
            return getattr(import_module(f'{package}.{kind}'), name)
        key = json.dumps(layers)
        if key not in self.registries:
            self.registries[key] = layered(layers)
        return self.registries[key].get(type_name)

    def _add_publisher(self, handle: int, node: Any, name: str, cls: Any, qos: QoSProfile) -> Any:
        """Create a publisher. If the network stays on this computer, a reliable volatile publisher stores more messages than its
        depth.

        A slow network could not resend so much data, such as images, in time.
        """
        silent = PublisherEventCallbacks(use_default_callbacks=False)
        is_kept = qos.reliability == ReliabilityPolicy.RELIABLE and qos.durability == DurabilityPolicy.VOLATILE
        if is_kept and is_alone(os.environ):
            qos.depth = max(qos.depth, KEPT)
        return node.create_publisher(cls, name, qos, event_callbacks=silent)

    def _add_subscription(self, handle: int, node: Any, name: str, cls: Any, qos: QoSProfile) -> Any:
        def on_message(data: bytes, info: Any) -> None:
            """Pass on this message and all waiting messages, because another turn of the executor would take longer."""
            self.say(wire.MESSAGE, handle, info['source_timestamp'], data)
            for _ in range(AT_ONCE):
                taken = made.handle.take_message(cls, True)
                if taken is None:
                    return
                self.say(wire.MESSAGE, handle, taken[1]['source_timestamp'], taken[0])

        silent = SubscriptionEventCallbacks(use_default_callbacks=False)
        qos.depth = max(qos.depth, WAITING)
        made = node.create_subscription(cls, name, on_message, qos, raw=True, event_callbacks=silent)
        return made

    def _add_service(self, handle: int, node: Any, name: str, cls: Any, qos: QoSProfile) -> Any:
        def asked(request: Any, response: Any) -> Any:
            self.serial += 1
            self.say(wire.REQUEST, handle, self.serial, bytes(serialize_message(request)))
            return _NOT_YET

        service = node.create_service(cls, name, asked, qos_profile=qos)
        answer = service.send_response

        def kept(response: Any, header: Any) -> None:
            if response is _NOT_YET:
                self.pending[self.serial] = header, answer
            else:
                answer(response, header)

        service.send_response = kept
        return service

    def _add_client(self, handle: int, node: Any, name: str, cls: Any, qos: QoSProfile) -> Any:
        return node.create_client(cls, name, qos_profile=qos)

    def remove(self, handle: int, number: int, data: bytes) -> None:
        kind, end, node = self.ends.pop(handle)
        getattr(self.nodes[node], f'destroy_{kind}')(end)

    def publish(self, handle: int, number: int, data: bytes) -> None:
        self.ends[handle][1].publish(data)

    def ask(self, handle: int, number: int, data: bytes) -> None:
        client = self.ends[handle][1]
        request = deserialize_message(data, client.srv_type.Request)
        if not isinstance(request, client.srv_type.Request):
            raise ValueError('these bytes are not a request of its type')
        if not client.service_is_ready():
            self.early.append((handle, number, data))  # before discovery, DDS would lose the request
            return
        future = client.call_async(request)
        future.add_done_callback(
            lambda done: (
                self.say(wire.RESPONSE, handle, number, bytes(serialize_message(done.result()))) if done.result() else None
            )
        )

    def answer(self, handle: int, number: int, data: bytes) -> None:
        header, answer = self.pending.pop(number)
        answer(deserialize_message(data, self.ends[handle][1].srv_type.Response), header)

    def glance(self) -> None:
        """Check the network. If names have changed, check it in more detail, because checking each topic is slow."""
        now_s = time.monotonic()
        names = [self.helper.get_node_names_and_namespaces(), self.helper.get_topic_names_and_types()]
        if names != self.names:
            self.names, self.changed_s = names, now_s
        if now_s - self.changed_s < SETTLED_S or now_s - self.looked_s > LOOK_CLOSELY_EVERY_S:
            self.looked_s = now_s
            self.look()

    def look(self) -> None:
        """Report the other nodes and endpoints if they have changed."""
        ends: list[list[Any]] = []
        participants: dict[str, str] = {}
        for topic, _ in self.names[1]:
            for kind, infos in (
                ('publisher', self.helper.get_publishers_info_by_topic(topic)),
                ('subscription', self.helper.get_subscriptions_info_by_topic(topic)),
            ):
                for info in infos:
                    gid = bytes(info.endpoint_gid)[:16]
                    if gid[:12] != self.own:
                        node = info.node_namespace, info.node_name
                        participants.setdefault(_full(*node), gid[:12].hex())
                        what = kind, topic, info.topic_type, str(info.topic_type_hash), from_rclpy(info.qos_profile)
                        ends.append([gid.hex(), *what, *node])
        nodes = []
        mine = [(node.get_name(), node.get_namespace()) for node in (*self.nodes.values(), self.helper)]
        others = Counter(self.helper.get_node_names_and_namespaces_with_enclaves())
        others.subtract((*each, ENCLAVE) for each in mine)
        for (name, namespace, enclave), count in others.items():
            if count > 0:
                nodes.append([participants.get(_full(namespace, name), ''), namespace, name, enclave == ENCLAVE])
                if (name, namespace) not in mine:
                    ends += self._services(name, namespace)
        text = json.dumps([sorted(nodes), sorted(ends, key=lambda end: end[0])])
        if text != self.message:
            self.message = text
            self.say(wire.GRAPH, 0, 0, text.encode())

    def _services(self, name: str, namespace: str) -> list[list[Any]]:
        """Return the services and clients of a node. They have no gid, so this function creates one from their names."""
        try:
            found = {
                'service': self.helper.get_service_names_and_types_by_node(name, namespace),
                'client': self.helper.get_client_names_and_types_by_node(name, namespace),
            }
        except Exception:  # the node has ended; the kind of error depends on the middleware
            return []
        made = [(kind, service, types[0]) for kind, rows in found.items() for service, types in rows]
        return [[_made_gid(*row[:2], _full(namespace, name)), *row, '', None, namespace, name] for row in made]

    def run(self) -> None:
        """Run until the link closes."""
        threading.Thread(target=self.read, daemon=True).start()
        self.say(wire.READY)
        looked, pause_s = 0.0, LOOK_EVERY_S
        while rclpy.ok():
            self.executor.spin_once(timeout_sec=0.01 if self.early else LOOK_EVERY_S)
            early, self.early = self.early, []
            self.inbox.extendleft((wire.ASK, *each) for each in reversed(early) if each[0] in self.ends)
            if early:
                self.work()
            if time.monotonic() - looked > pause_s:
                used_s = time.thread_time()
                self.glance()
                looked, pause_s = time.monotonic(), max(LOOK_EVERY_S, PAUSE * (time.thread_time() - used_s))


def _node(name: str, namespace: str) -> Any:
    """Create a node with as few endpoints as possible. It still publishes /parameter_events."""
    return rclpy.create_node(
        name,
        namespace=namespace,
        start_parameter_services=False,
        enable_rosout=False,
        use_global_arguments=False,
        parameter_overrides=[Parameter('start_type_description_service', value=False)],
    )


def _full(namespace: str, name: str) -> str:
    return f'{namespace.rstrip("/")}/{name}'


def _made_gid(*words: str) -> str:
    return sha256(' '.join(words).encode()).hexdigest()[:32]


_WORK: dict[int, Callable[[Side, int, int, bytes], None]] = {
    wire.NODE: Side.add_node,
    wire.NODE_GONE: Side.remove_node,
    wire.ADD: Side.add,
    wire.REMOVE: Side.remove,
    wire.PUBLISH: Side.publish,
    wire.ASK: Side.ask,
    wire.ANSWER: Side.answer,
}


def main() -> int:
    """Serve the link through the socket with the given number."""
    connection = socket.socket(fileno=int(sys.argv[1]))
    rclpy.init(args=['--ros-args', '--enclave', ENCLAVE], signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
    with suppress(ExternalShutdownException, BrokenPipeError):  # the link has closed
        Side(connection).run()
    return 0
