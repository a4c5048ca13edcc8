"""A recording as the feed of one client. It plays, pauses and seeks only for this client."""

from __future__ import annotations

import time as wall
from bisect import bisect_right
from collections.abc import Callable, Sequence
from typing import Any

from edulaunch.engine.graph.qos import TRANSIENT_LOCAL, QoS
from edulaunch.engine.recording import Recording
from edulaunch.errors import RecordingError
from edulaunch.extras.foxglove import server_messages
from edulaunch.extras.foxglove.feed import Key, Refused, Row, Topic
from edulaunch.extras.foxglove.protocol import Playback, Value
from edulaunch.extras.foxglove.server_messages import Graph

PARTS = {'publisher': 'published', 'subscription': 'subscribed', 'service': 'served'}
NO_CHANGES = 'a recording cannot be changed'


class RecordingFeed:
    """Plays a recording from its beginning, at the speed of real time until the client requests another speed.

    :param controls: whether the client can control how the recording plays.
    :param clock: returns real time in seconds. Tests replace it.
    """

    def __init__(
        self, recording: Recording, name: str, controls: bool = True, clock: Callable[[], float] = wall.monotonic
    ) -> None:
        self.name = name
        self.capabilities: tuple[str, ...] = ('connectionGraph', 'parameters', 'parametersSubscribe', 'time')
        if controls:
            self.capabilities += ('playbackControl',)
        self._recording, self._clock = recording, clock
        self._start_ns, self._length_ns = recording.start_ns, round(recording.duration_s * 1e9)
        self._columns = {(one['topic'], one['type']): one for one in recording.rows('topics') if one['times']}
        self._wires: dict[Key, Sequence[Any]] = {}
        self._ends = recording.rows('endpoints')
        self._nodes = {row[4]: row for row in recording.rows('nodes')}
        times = {row[5] for row in self._ends} | {row[3] for row in self._nodes.values() if row[3] is not None}
        self._changes = sorted(times)
        self._parameter_times = [row[0] for row in recording.parameter_rows]
        self._at_ns, self._speed, self._state = 0, 1.0, server_messages.PLAYING
        self._since = 0, clock()
        self._sent_state: int | None = None

    def session(self) -> str:
        return f'{self.name}-{self._start_ns}'

    def details(self) -> dict[str, Any]:
        if 'playbackControl' not in self.capabilities:
            return {}
        ends = (self._start_ns, self._start_ns + self._length_ns)
        first, last = ({'sec': time_ns // 10**9, 'nsec': time_ns % 10**9} for time_ns in ends)
        return {'dataStartTime': first, 'dataEndTime': last}

    # -- time

    def now_ns(self) -> int:
        return self._start_ns + self._at_ns

    def advance(self) -> list[bytes]:
        if self._state == server_messages.PLAYING:
            began_ns, began_s = self._since
            self._at_ns = min(began_ns + round((self._clock() - began_s) * self._speed * 1e9), self._length_ns)
            if self._at_ns == self._length_ns:
                self._state = server_messages.ENDED
        if self._state == self._sent_state or 'playbackControl' not in self.capabilities:
            return []
        self._sent_state = self._state
        return [server_messages.playback(self._state, self.now_ns(), self._speed)]

    def play(self, request: Playback) -> tuple[bytes, bool]:
        self.advance()
        seek_ns = request.seek_ns
        if seek_ns is None and request.plays and self._state == server_messages.ENDED:
            seek_ns = self._start_ns  # start again from the beginning
        if seek_ns is not None:
            self._at_ns = min(max(seek_ns - self._start_ns, 0), self._length_ns)
        self._speed = request.speed
        self._since = self._at_ns, self._clock()
        is_over = self._at_ns == self._length_ns
        self._state = server_messages.ENDED if is_over else server_messages.PLAYING if request.plays else server_messages.PAUSED
        self._sent_state = self._state
        did_seek = seek_ns is not None
        return server_messages.playback(self._state, self.now_ns(), self._speed, did_seek, request.request), did_seek

    # -- channels and services

    def version(self) -> object:
        return bisect_right(self._changes, self._at_ns)

    def topics(self) -> list[Topic]:
        found = []
        for name, kind in self._columns:
            try:
                found.append(Topic(name, kind, self._recording.message_class(kind), self._recording.registry))
            except RecordingError:  # the type of the topic is unknown here
                continue
        return found

    def services(self) -> list[Topic]:
        """Raise an error, because no service replies in a recording."""
        return []

    def graph(self) -> Graph:
        found: dict[str, dict[str, list[str]]] = {part: {} for part in PARTS.values()}
        for kind, name, _, index, _, made_ns, _ in self._ends:
            node = self._nodes.get(index)
            if kind in PARTS and node is not None and made_ns <= self._at_ns and (node[3] is None or node[3] > self._at_ns):
                nodes = found[PARTS[kind]].setdefault(name, [])
                if node[0] not in nodes:
                    nodes.append(node[0])
        return found

    # -- messages

    def _wires_of(self, key: Key) -> Sequence[Any]:
        """Return the messages of a topic. The first call checks them."""
        if key not in self._wires:
            try:
                self._wires[key] = [wire for _, wire in self._recording.wires(*key)]
            except RecordingError as error:
                raise Refused(str(error)) from None
        return self._wires[key]

    def end(self, key: Key) -> int:
        return bisect_right(self._columns[key]['times'], self._at_ns)

    def kept(self, key: Key) -> list[Row]:
        """Return the messages for a client that subscribes now, which are the last message of each publisher.

        For a latched topic, return as many messages as the publisher stores.
        """
        wires, column, end = self._wires_of(key), self._columns[key], self.end(key)
        depths = {row[4]: _depth(row[6]) for row in self._ends if row[0] == 'publisher' and row[1] == key[0]}
        taken: dict[int, int] = {}
        places = []
        for place in range(end - 1, -1, -1):
            publisher = column['publishers'][place]
            if taken.get(publisher, 0) < depths.get(publisher, 1):
                taken[publisher] = taken.get(publisher, 0) + 1
                places.append(place)
            elif taken.keys() >= depths.keys():
                break
        return [(self._start_ns + column['times'][place], wires[place]) for place in reversed(places)]

    def rows(self, key: Key, first: int, most: int) -> tuple[list[Row], int, int]:
        end = self.end(key)
        begin = max(first, end - most)
        times, wires = self._columns[key]['times'], self._wires_of(key)
        return [(self._start_ns + times[place], wires[place]) for place in range(begin, end)], end, max(begin - first, 0)

    # -- parameters

    def parameter_version(self) -> object:
        return bisect_right(self._parameter_times, self._at_ns)

    def parameters(self) -> dict[str, Any]:
        rows = self._recording.parameter_rows[: bisect_right(self._parameter_times, self._at_ns)]
        found = {f'{node}.{name}': value for _, node, name, value, _ in rows}
        return {name: value for name, value in sorted(found.items()) if value is not None}

    # -- unsupported requests

    def set(self, values: Sequence[tuple[str, Value, str | None]], answer: Callable[[str], object]) -> None:
        answer(NO_CHANGES)

    def advertise(self, topic: str, type_name: str, encoding: str) -> Callable[[bytes], object]:
        raise Refused(NO_CHANGES)

    def retire(self, publish: Callable[[bytes], object]) -> None:
        """Do nothing, because clients cannot publish in a recording."""

    def call(self, service: Topic, request: bytes, answer: Callable[[bytes | str], object]) -> None:
        raise Refused(NO_CHANGES)

    def close(self) -> None:
        """Do nothing, because a recording needs no clean-up."""


def _depth(policies: Sequence[Any]) -> int:
    """Return how many messages a publisher stores for late subscribers, at least one."""
    qos = QoS(*policies)
    return 1 if qos.durability != TRANSIENT_LOCAL else (qos.queue_length or 1000)
