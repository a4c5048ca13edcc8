"""The part of a machine's recording that belongs to one command: the command's programs, and other programs that ran at the
same time.

A machine runs longer than its commands. Advice on a command must not mention earlier programs. From concurrent programs, it
may use only facts that the command's own programs could observe.
"""

from __future__ import annotations

import shlex
from bisect import bisect_left, bisect_right
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.engine.recording.recorder import Recorder

Row = list[Any]


class Excerpt:
    """The records of one command, and of other programs that ran at the same time.

    :param recorder: the recorder of the machine.
    :param leader: the process ID of the command. An unknown ID raises KeyError.
    :ivar beside: the command line of each other program in the excerpt, by program name.
    :ivar programs: launch names of the command's own programs. Other programs with such a name are renamed in the excerpt.
    """

    def __init__(self, recorder: Recorder, leader: int) -> None:
        self._recorder = recorder
        command = next((row for row in recorder.processes if row['pid'] == leader), None)
        if command is None:
            raise KeyError(leader)
        self._since: int = command['started']
        ended = command['ended']
        self._until: int = recorder.sim.now_ns - recorder.sim.start_ns if ended is None else ended
        own = {pid for pid, group in recorder.groups.items() if group == leader}
        taken = {row['name'] for row in recorder.processes if row['pid'] in own}
        self._names = {
            row['pid']: row['name'] if row['pid'] in own or row['name'] not in taken else f'{row["name"]} (pid {row["pid"]})'
            for row in recorder.processes
            if self._overlaps(row['started'], row['ended']) or row['pid'] in own
        }
        lines = {row['pid']: shlex.join(row['argv']) for row in recorder.processes}
        others = {name: pid for pid, name in self._names.items() if pid not in own}
        self.beside = {name: lines.get(recorder.groups.get(pid, pid), '') for name, pid in others.items()}
        self.programs = frozenset(self._names[pid] for pid in own if pid in self._names)

    def _overlaps(self, start: int, end: int | None) -> bool:
        """Return whether an object existed while the command ran. An object that ended exactly at the start does not count."""
        return start <= self._until and (end is None or end > self._since)

    def content(self, launch: dict[str, Any]) -> dict[str, Any]:
        """Return the excerpt as plain data, with the same parts as a recording.

        :param launch: the record of the launch, if a session started the command.
        """
        recorder = self._recorder
        nodes = list(self._nodes())
        alive = {row[4]: row for row in nodes}
        endpoints = [row for row in recorder.endpoints if row[3] in alive and row[5] <= self._until]
        first: dict[str, int] = {}
        for row in nodes:
            first[row[0]] = min(row[2], first.get(row[0], row[2]))
        served = {row[1]: row[5] for row in reversed(endpoints) if row[0] == 'service'}
        return {
            'seed': recorder.sim.seed,
            'start_ns': recorder.sim.start_ns,
            'duration_ns': self._until,
            'roots': recorder.roots,
            'launch': launch,
            'processes': [{**row, 'name': self._names[row['pid']]} for row in recorder.processes if row['pid'] in self._names],
            'nodes': nodes,
            'endpoints': endpoints,
            'parameters': [row for row in recorder.parameters if first.get(row[1], self._until + 1) <= row[0] <= self._until],
            'calls': [
                row for row in recorder.calls if min(self._since, served.get(row[1], self._since)) <= row[0] <= self._until
            ],
            'logs': self._rows(recorder.logs),
            'output': self._rows(recorder.output_lines),
            'notes': self._rows(recorder.notes),
            'facts': self._facts(),
            'descriptors': recorder.descriptors,
            'interfaces': recorder.interfaces({row[2] for row in endpoints}),
            'topics': list(self._topics(endpoints)),
        }

    def _nodes(self) -> Iterator[Row]:
        """Yield the nodes that existed while the command ran. Nodes of another computer keep the recorded program name."""
        pids = self._recorder.pids
        for row in self._recorder.nodes:
            if self._overlaps(row[2], row[3]):
                yield [row[0], self._names.get(pids.get(row[4], 0), row[1]), *row[2:]]

    def _rows(self, rows: list[Row]) -> list[Row]:
        """Return the rows from the time when the command ran. The given rows must be sorted by time."""
        start = bisect_left(rows, self._since, key=lambda row: row[0])
        return rows[start : bisect_right(rows, self._until, key=lambda row: row[0])]

    def _facts(self) -> list[Row]:
        """Return the rows of programs that ran at the same time as the command."""
        rows = [
            [row[0], self._names[pid], *row[2:]]
            for pid, row in self._recorder.facts_of()
            if pid in self._names and row[5] >= self._since and row[0] <= self._until
        ]
        return sorted(rows, key=lambda row: row[0])

    def _topics(self, endpoints: list[Row]) -> Iterator[dict[str, Any]]:
        """Yield the messages of publishers that existed while the command ran, including earlier messages for late
        subscriptions.
        """
        publishers = {row[4] for row in endpoints if row[0] == 'publisher'}
        kept = {row[4] for row in endpoints if row[0] == 'publisher' and 'transient_local' in row[6]}
        named = {(row[1], row[2]) for row in endpoints if row[0] == 'publisher'}
        start_ns = self._recorder.sim.start_ns
        for (topic, kind), flat in sorted(self._recorder.columns.items()):
            if (topic, kind) not in named:
                continue
            numbers = range(len(flat) // 3)
            since = bisect_left(numbers, start_ns + self._since, key=lambda number: flat[3 * number])
            until = bisect_right(numbers, start_ns + self._until, key=lambda number: flat[3 * number])
            chosen = [number for number in range(since) if flat[3 * number + 1] in kept] if kept else []
            chosen += [number for number in range(since, until) if flat[3 * number + 1] in publishers]
            yield {
                'topic': topic,
                'type': kind,
                'times': [flat[3 * number] - start_ns for number in chosen],
                'publishers': [flat[3 * number + 1] for number in chosen],
                'messages': [flat[3 * number + 2] for number in chosen],
            }
