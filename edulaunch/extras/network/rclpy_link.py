"""This link connects to ROS 2 through the real rclpy, which runs in a child process.

It bridges topics, services, parameters and actions in both directions to every ROS 2 peer.
"""

from __future__ import annotations

import json
import os
import socket
import subprocess
from collections import deque
from collections.abc import Sequence
from contextlib import suppress

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.packages import Index, Program
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.errors import UnusableInput
from edulaunch.extras.native.command import command, interface_layers
from edulaunch.extras.native.environment import needed
from edulaunch.extras.native.loopback import is_alone
from edulaunch.extras.network import rclpy_wire as wire
from edulaunch.extras.network.network_link import (
    MARK,
    Event,
    GraphChanged,
    Interface,
    LinkDiagnostic,
    LinkError,
    Message,
    RemoteEndpoint,
    RemoteGraph,
    RemoteNode,
    Request,
    Response,
    Settings,
)
from edulaunch.runtime.framing import Frames

LONGEST_START_S = 30.0
MOST_WAITING = 32 << 20
"""The maximum number of bytes that wait for a child process that does not read. Later messages are dropped."""
BUFFER = 4 << 20
"""The size of the socket's own buffer, which must hold all data between two turns, such as an image."""
URGENT = (wire.NODE, wire.ADD)
"""The frames that are sent before waiting messages, because no waiting message can refer to their node or endpoint."""
AT_ONCE = 1 << 20
"""The number of bytes that one turn of the machine reads."""
AGAIN = '\n  help: type edulaunch network off, then edulaunch network on'
RENEW = 'read its errors in the log of the machine; edulaunch network install creates its environment again'
_PROFILE, _LOOPBACK_PROFILE = (os.path.join(os.path.dirname(__file__), f'rclpy_side{end}.xml') for end in ('', '_loopback'))
"""The settings of Fast DDS for the child process."""
_SIDE = Program('entry_point', '', 'link', 'link', module='edulaunch.extras.network.rclpy_side', function='main')


class RclpyLink:
    """The link through the real rclpy; see `network_link.Link`. It does not report the publisher of a message."""

    title = 'rclpy'

    def __init__(self) -> None:
        self._count = 0
        self._out = wire.Outbox()
        self._frames = Frames()
        self._waiting: deque[Event] = deque()
        self._kinds: dict[int, str] = {}
        self._remote = RemoteGraph((), ())
        self._known: dict[tuple[object, ...], RemoteEndpoint] = {}
        self._child: subprocess.Popen[bytes] | None = None
        self._sockets: list[socket.socket] = []

    def open(self, settings: Settings) -> None:
        """Implement `Link.open`."""
        try:
            environment = needed()
        except UnusableInput as error:
            raise LinkError(str(error)) from None
        self.title = f'rclpy {environment.version}'
        env = {name: value for name, value in os.environ.items() if not name.startswith(('PYTHON', 'ROS_'))}
        env.update(ROS_DOMAIN_ID=str(settings.domain), ROS_AUTOMATIC_DISCOVERY_RANGE=settings.discovery_range)
        env.update(ROS_STATIC_PEERS=';'.join(settings.static_peers), FASTRTPS_DEFAULT_PROFILES_FILE=_PROFILE)
        if is_alone(env):
            env['FASTRTPS_DEFAULT_PROFILES_FILE'] = _LOOPBACK_PROFILE
        words = command(environment, _SIDE, ProcessSpec((), 'link'), Index())
        self._socket, theirs = self._sockets = list(socket.socketpair())
        number = theirs.fileno()
        self._child = subprocess.Popen(
            [*words, 'link', str(number)], env=env, pass_fds=(number,), stdin=subprocess.DEVNULL, start_new_session=True
        )
        theirs.close()
        self._wait()
        self._socket.setblocking(False)
        with suppress(OSError):
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, BUFFER)

    def _wait(self) -> None:
        """Wait until the child process is ready.

        :raises LinkError: when the child process does not start.
        """
        self._socket.settimeout(LONGEST_START_S)
        try:
            data = self._socket.recv(1 << 16)
        except TimeoutError:
            data = b''
        kinds = [self._hear(*frame) for frame in wire.opened(self._frames.feed(data))]
        if wire.READY not in kinds:
            self.close()
            raise LinkError('the side process with the real rclpy did not start.', help=RENEW)

    def _say(self, kind: int, handle: int, number: int = 0, data: bytes = b'') -> None:
        if self._out.size > MOST_WAITING and kind == wire.PUBLISH:
            self._waiting.append(LinkDiagnostic('full', 'the side process with the real rclpy is too slow: messages are dropped'))
            return
        self._out.put(wire.frame(kind, handle, number, data), is_urgent=kind in URGENT)

    def add_node(self, namespace: str, name: str) -> int:
        """Implement `Link.add_node`."""
        self._count += 1
        self._say(wire.NODE, self._count, 0, json.dumps([namespace, name]).encode())
        return self._count

    def remove_node(self, handle: int) -> None:
        """Implement `Link.remove_node`."""
        self._say(wire.NODE_GONE, handle)

    def add(self, node: int, kind: str, name: str, interface: Interface, qos: QoS) -> int:
        """Add an endpoint; see `Link.add`. If rclpy rejects the endpoint, a :class:`LinkDiagnostic` reports it later."""
        self._count += 1
        self._kinds[self._count] = f'{kind} {name}'
        message = {
            'kind': kind,
            'name': name,
            'type': interface.name,
            'layers': interface_layers(interface.registry),
            'qos': list(qos),
        }
        self._say(wire.ADD, self._count, node, json.dumps(message).encode())
        return self._count

    def remove(self, handle: int) -> None:
        """Implement `Link.remove`."""
        del self._kinds[handle]
        self._say(wire.REMOVE, handle)

    def publish(self, handle: int, cdr: bytes) -> None:
        """Implement `Link.publish`."""
        self._say(wire.PUBLISH, handle, 0, cdr)

    def request(self, handle: int, number: int, cdr: bytes) -> None:
        """Implement `Link.request`."""
        self._say(wire.ASK, handle, number, cdr)

    def reply(self, handle: int, who: bytes, cdr: bytes) -> None:
        """Implement `Link.reply`."""
        self._say(wire.ANSWER, handle, int.from_bytes(who, 'little'), cdr)

    def flush(self) -> None:
        """Send waiting frames; see `Link.flush`. Frames that the child process does not accept yet are sent later."""
        try:
            self._out.send(self._socket.send)
        except BlockingIOError:
            return
        except OSError:
            self._out.clear()  # the side process has ended; `take` reports this

    def take(self) -> Sequence[Event]:
        """Implement `Link.take`."""
        taken = 0
        while taken < AT_ONCE:
            try:
                data = self._socket.recv(1 << 16)
            except BlockingIOError:
                break
            except OSError:
                data = b''
            if not data:
                self._died()
                break
            taken += len(data)
            for frame in wire.opened(self._frames.feed(data)):
                self._hear(*frame)
        self.flush()
        events, self._waiting = list(self._waiting), deque()
        return events

    def _died(self) -> None:
        self._remote, self._known = RemoteGraph((), ()), {}
        self._waiting += (
            GraphChanged(),
            LinkDiagnostic('died', 'the side process with the real rclpy has died, so no messages cross' + AGAIN),
        )
        silent, bell = socket.socketpair()
        silent.setblocking(False)  # dup2 copies this setting, too
        os.dup2(silent.fileno(), self._socket.fileno())  # same number, but never readable, so the machine keeps its registration
        silent.close()
        self._sockets.append(bell)

    def _hear(self, kind: int, handle: int, number: int, data: bytes) -> int:
        if kind == wire.GRAPH:
            self._see(json.loads(data))
            self._waiting.append(GraphChanged())
        elif kind == wire.TROUBLE:
            what = self._kinds.get(handle, 'the link')
            self._waiting.append(LinkDiagnostic(f'refused {what}', f'{what}: {data.decode(errors="replace")}'))
        elif handle in self._kinds:
            if kind == wire.MESSAGE:
                self._waiting.append(Message(handle, b'', number, data))
            elif kind == wire.REQUEST:
                self._waiting.append(Request(handle, number.to_bytes(8, 'little'), data))
            else:
                self._waiting.append(Response(handle, number, data))
        return kind

    def _see(self, message: list[list[list[object]]]) -> None:
        """Update the known nodes and endpoints. An endpoint that existed before keeps its object."""
        nodes = {
            (space, name): RemoteNode(bytes.fromhex(str(gid)), str(space), str(name), bool(is_simulated))
            for gid, space, name, is_simulated in message[0]
            if not str(name).startswith(MARK)
        }
        before, self._known = self._known, {}
        for gid, kind, name, type_name, type_hash, qos, space, node in message[1]:
            if str(node).startswith(MARK):
                continue
            key = (gid, kind, name, type_name, type_hash, tuple(qos) if isinstance(qos, list) else None, nodes.get((space, node)))
            policies = QoS(*qos) if isinstance(qos, list) else QoS()
            texts = (str(kind), str(name), str(type_name), str(type_hash))
            self._known[key] = before.get(key) or RemoteEndpoint(
                bytes.fromhex(str(gid)), *texts, policies, nodes.get((space, node))
            )
        self._remote = RemoteGraph(tuple(nodes.values()), tuple(self._known.values()))

    def graph(self) -> RemoteGraph:
        """Implement `Link.graph`."""
        return self._remote

    def fileno(self) -> int:
        """Implement `Link.fileno`."""
        return self._socket.fileno()

    def close(self) -> None:
        """Implement `Link.close`."""
        child, self._child = self._child, None
        for each in self._sockets:
            each.close()
        if child is None:
            return
        try:
            child.wait(1.0)
        except subprocess.TimeoutExpired:
            child.kill()
            child.wait()
