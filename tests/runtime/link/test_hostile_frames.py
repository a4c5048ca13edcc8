"""Whatever the confined peer sends, the trusted one believes nothing of it that is not its own to say, and comes to an end."""

from __future__ import annotations

import socket
from collections.abc import Iterator, Sequence
from typing import Any, NoReturn

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.sim.simulation import EPOCH_NS
from edulaunch.runtime.framing import frame
from edulaunch.runtime.link.codec import AS_CDR, LONGEST_FRAME, FrameKind, Violation, dump
from edulaunch.runtime.link.peer import NUMBER, TIME, TOKEN, Gone, TooMuch
from edulaunch.runtime.link.replica import END as NUMBERED
from edulaunch.runtime.link.replica import ENDS
from edulaunch.runtime.link.trusted import Trusted
from edulaunch.runtime.link.trusted_host import shipped_path
from tests.house import EXAMPLES

SIM, FAKE = shipped_path('turtlesim', 'turtlesim_node'), '/home/me/fake'
POSE = 'turtlesim/msg/Pose'
LAST = 1 << 40  # a number that is later than any before it


def token(at_ns: int = EPOCH_NS + 10**12, number: int = LAST) -> bytes:
    return frame(FrameKind.TOKEN, TOKEN.pack(number, at_ns, 0, 0, number) + b'null')


def spec(argv: Sequence[str], package: str | None = None, executable: str | None = None, name: str = 'p-1') -> list[Any]:
    return [list(argv), name, None, {}, False, None, package, executable, {}, False, False]


def started(pid: int, *of: Any) -> bytes:
    return frame(FrameKind.STARTED, dump([pid, spec(*of)]))


def spawn(pid: int, argv: Sequence[str], package: str, executable: str, of: list[Any] | None = None) -> bytes:
    return frame(FrameKind.SPAWN, dump([pid, list(argv), package, executable, of or spec(argv, package, executable)]))


def node(index: int, pid: int = 1001, name: str = 'mine', namespace: str = '/') -> bytes:
    return frame(FrameKind.NODE, dump([index, pid, name, namespace]))


def end(kind: str, index: int, of: int, name: str, type_name: str = POSE, qos: Any = None) -> bytes:
    return frame(FrameKind.END, dump([kind, index, of, name, type_name, list(qos or QoS())]))


def call(kind: FrameKind, value: Any, number: int = LAST) -> bytes:
    return frame(kind, NUMBER.pack(number) + dump(value))


MINE = started(1001, [FAKE]) + node(1)
"""A program with a node: numbers go on at 1002 and 2."""


def returned(number: int) -> bytes:
    return frame(FrameKind.RETURN, TOKEN.pack(number, EPOCH_NS + 10**6, 0, 0, number) + b'null')


WITH_SIM = (
    started(1001, [FAKE])
    + spawn(1002, [SIM], 'turtlesim', 'turtlesim_node')
    + token(EPOCH_NS + 10**6, 5)
    + returned(1 << 30)
    + returned(1 << 31)
)
"""A program of one's own and a turtlesim, which has told its two lines and runs; then it is the confined peer's turn."""


def meet(sent: bytes, duration_s: float = 1.0, quota: int | None = None, fails: Sequence[str] = ()) -> tuple[Trusted, Exception]:
    """What the trusted peer makes of these bytes, after which the other end is closed; and why it gives up."""
    ours, theirs = socket.socketpair()
    ours.setblocking(True)
    theirs.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 1 << 22)
    try:
        theirs.sendall(sent)
        theirs.shutdown(socket.SHUT_WR)
        trusted = Trusted(ours, 0, quota)
        trusted.host.fails = fails
        errors: list[Exception] = []

        def fatal(error: Exception) -> NoReturn:
            errors.append(error)
            trusted.recorder.stop()
            raise error

        trusted.peer.fatal = fatal  # type: ignore[method-assign]
        with pytest.raises(Exception):  # noqa: B017  (it may come up inside a program, which prints the first one and goes on)
            trusted.run(duration_s)
        return trusted, errors[0]
    finally:
        ours.close()
        theirs.close()


@pytest.mark.parametrize(
    ('sent', 'fails'),
    [
        (MINE + spawn(1002, [SIM], 'turtlesim', 'turtlesim_node'), 'turtlesim_node'),
        (started(1001, ['ros2', 'bag', 'record', '-a']), 'ros2 bag record'),
    ],
)
def test_a_program_that_cannot_start_does_not_start_without_a_question_either(sent: bytes, fails: str) -> None:
    assert isinstance(meet(sent + token())[1], Gone)
    trusted, error = meet(sent + token(), fails=[fails])
    assert isinstance(error, Violation) and 'ask before' in str(error)
    assert len(trusted.recorder.processes) == (fails == 'turtlesim_node')


def fake_stock() -> Iterator[tuple[str, bytes]]:
    yield 'a stock program that runs there', started(1001, [SIM], 'turtlesim', 'turtlesim_node')
    yield 'a stock program that does not exist', started(1001, [shipped_path('turtlesim', 'none')], 'turtlesim', 'none')
    yield 'a stock program under another claim', started(1001, [SIM], 'mine', 'fake')
    yield (
        'a stock name for another program',
        spawn(1001, ['/x/lib/demo_nodes_cpp/talker'], 'demo_nodes_cpp', 'talker', spec([SIM], 'turtlesim', 'turtlesim_node')),
    )
    yield (
        'a stock command line for another program',
        spawn(1001, [SIM], 'demo_nodes_cpp', 'talker', spec([SIM], 'turtlesim', 'turtlesim_node')),
    )
    yield 'other words than its command line', spawn(1001, [SIM, '-r', 'a:=b'], 'turtlesim', 'turtlesim_node', spec([SIM]))
    yield 'a program that evaluates texts', spawn(1001, ['/x/lib/xacro/xacro'], 'xacro', 'xacro')
    yield 'no program', spawn(1001, ['/bin/sh'], 'bin', 'sh')
    yield 'a path for a name', spawn(1001, ['x'], '../../..', 'x')
    yield 'a number that is not next', started(1005, [FAKE])
    yield 'a number twice', started(1001, [FAKE]) + started(1001, [FAKE])
    yield 'what is no command', frame(FrameKind.STARTED, dump([1001, ['x']]))


def fake_graph() -> Iterator[tuple[str, bytes]]:
    yield 'a node of nobody', started(1001, [FAKE]) + node(1, pid=1002)
    yield 'a node of the past', MINE + node(1)
    yield 'a node of the far future', MINE + node(1 << 40)
    yield 'a name with a line in it', started(1001, [FAKE]) + node(1, name='a\nb')
    yield 'no name', started(1001, [FAKE]) + node(1, name='')[:-9] + b'null,"/"]'
    yield 'a topic with markup', MINE + end('publisher', 2, 1, '/<b>')
    yield 'a type with code', MINE + end('publisher', 2, 1, '/a', 'a/msg/B\nimport os')
    yield 'another kind of end', MINE + end('node', 2, 1, '/a')
    yield 'an end of an end', MINE + end('publisher', 2, 1, '/a') + end('publisher', 3, 2, '/a')
    yield 'no quality', MINE + end('publisher', 2, 1, '/a', qos=[1, 2])
    yield 'a negative depth', MINE + end('publisher', 2, 1, '/a', qos=QoS(depth=-1))
    yield 'an unknown word', MINE + end('publisher', 2, 1, '/a', qos=QoS(reliability='best'))
    yield 'an end twice gone', MINE + end('publisher', 2, 1, '/a') + 2 * frame(FrameKind.END_GONE, NUMBERED.pack(2))


def fake_messages() -> Iterator[tuple[str, bytes]]:
    mine = (
        MINE + end('publisher', 2, 1, '/a') + end('subscription', 3, 1, '/a') + end('client', 4, 1, '/s', 'turtlesim/srv/Spawn')
    )
    yield 'no CDR', mine + frame(FrameKind.PUBLISH, NUMBERED.pack(2) + bytes((AS_CDR,)) + b'\x00\x01\x00\x00\x00')
    yield 'another message', mine + frame(FrameKind.PUBLISH, NUMBERED.pack(2) + b'\x02["x"]')
    yield 'deep JSON', mine + frame(FrameKind.PUBLISH, NUMBERED.pack(2) + b'\x02' + b'[' * 100_000)
    yield 'a long number', mine + frame(FrameKind.PUBLISH, NUMBERED.pack(2) + b'\x02[' + b'9' * 100_000 + b']')
    yield 'published by a subscription', mine + frame(FrameKind.PUBLISH, NUMBERED.pack(3) + b'\x02[]')
    yield 'a message that nobody sent', mine + frame(FrameKind.READY, ENDS.pack(3, 2) + b'\x00')
    yield 'a reply that nobody waits for', mine + frame(FrameKind.ANSWERED, dump([4, 1, b'\x02["x"]']))
    yield 'a request of a publisher', mine + call(FrameKind.REQUEST, [4, 2, 1, b''])


def fake_order() -> Iterator[tuple[str, bytes]]:
    yield 'the past', frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS - 1))
    yield 'the future', frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS + 1))
    yield 'a number of the past', token(number=9) + token(number=3)
    yield 'a number too large', frame(FrameKind.MARK, NUMBER.pack(1 << 63))
    yield 'an answer to nothing', frame(FrameKind.RETURN, TOKEN.pack(LAST, EPOCH_NS, 0, 0, 1) + b'null')
    yield 'an unknown kind', frame(200, b'')
    yield 'a call that only we make', call(FrameKind.OUTPUT, [1001, 'stdout', 'x'])
    yield 'an endless frame', (LONGEST_FRAME + 1).to_bytes(4, 'little') + bytes((FrameKind.NOTE,))
    yield 'no JSON', frame(FrameKind.NOTE, b'\xff')
    yield 'nothing in it', b''.join(frame(kind, b'') for kind in FrameKind)


CASES = [*fake_stock(), *fake_graph(), *fake_messages(), *fake_order()]


@pytest.mark.parametrize('sent', [sent for _, sent in CASES], ids=[name for name, _ in CASES])
def test_a_frame_that_breaks_a_rule_ends_the_run(sent: bytes) -> None:
    _, error = meet(sent + token())
    assert not isinstance(error, Gone)


def after_the_sim(sent: bytes) -> tuple[Trusted, Exception]:
    """Frames that come when the turtlesim runs: its node is 1, its /turtle1/pose among what follows."""
    return meet(WITH_SIM + sent + token(EPOCH_NS + 10**12, LAST))


def pose_publisher(trusted: Trusted) -> int:
    return next(row[4] for row in trusted.recorder.endpoints if row[:2] == ['publisher', '/turtle1/pose'])


@pytest.fixture(scope='module')
def numbers() -> tuple[int, int, int]:
    """Of turtlesim's node, of its pose publisher, and the next one that is free."""
    trusted, error = after_the_sim(b'')
    assert isinstance(error, Gone)
    return trusted.recorder.nodes[0][4], pose_publisher(trusted), trusted.graph.last_index + 1


def test_nothing_is_done_in_the_name_of_a_stock_node(numbers: tuple[int, int, int]) -> None:
    sim, pose, free = numbers
    fakes = {
        'publish': frame(FrameKind.PUBLISH, NUMBERED.pack(pose) + b'\x02[1.0,1.0,1.0,1.0,1.0]'),
        'a publisher': end('publisher', free, sim, '/turtle1/pose'),
        'a parameter': frame(FrameKind.PARAMETER, dump([sim, 'background_r', 1, 'mine'])),
        'its end': frame(FrameKind.NODE_GONE, NUMBERED.pack(sim)),
        'the end of its publisher': frame(FrameKind.END_GONE, NUMBERED.pack(pose)),
        'a node of its program': node(free, pid=1002),
        'its output': frame(FrameKind.WROTE, dump([1002, 'stdout', 'x'])),
        'its log': frame(FrameKind.LOG, dump([1002, 20, 'sim', 'x'])),
        'its exit': frame(FrameKind.ENDED, dump([1002, 0, None])),
        'a fact of it': frame(FrameKind.FACT, dump([1002, 'odd', 1, {}])),
    }
    honest = meet(WITH_SIM)[0].recorder
    for name, fake in fakes.items():
        trusted, error = after_the_sim(fake)
        assert not isinstance(error, Gone), name
        assert trusted.recorder.endpoints == honest.endpoints, name
        assert trusted.recorder.output_lines == honest.output_lines, name


def test_what_reaches_a_stock_node_has_come_by_its_topic_and_service(numbers: tuple[int, int, int]) -> None:
    honest, free = meet(WITH_SIM)[0].recorder, numbers[2]
    heard = next(row[4] for row in honest.endpoints if row[:2] == ['subscription', '/turtle1/cmd_vel'])
    served = next(row[4] for row in honest.endpoints if row[:2] == ['service', '/turtle1/teleport_absolute'])
    mine = node(free) + end('publisher', free + 1, free, '/mine', 'geometry_msgs/msg/Twist')
    mine += end('client', free + 2, free, '/mine', 'turtlesim/srv/TeleportAbsolute')
    twist = frame(FrameKind.PUBLISH, NUMBERED.pack(free + 1) + b'\x02[1.0,0.0,0.0,0.0,0.0,0.0]')
    asked = frame(FrameKind.ASKED, dump([free + 2, 1, True, b'\x02[1.0,1.0,0.0]']))
    for fake in (
        twist + frame(FrameKind.READY, ENDS.pack(heard, free + 1) + b'\x00'),
        asked + call(FrameKind.REQUEST, [served, free + 2, 1, b'\x02[1.0,1.0,0.0]'], 1 << 35),
    ):
        assert isinstance(after_the_sim(mine + fake)[1], Violation)


def test_a_topic_of_a_world_has_the_world_among_its_publishers_and_says_who_else_is(numbers: tuple[int, int, int]) -> None:
    """Another publisher of a pose is as legal as in ROS; what the grader counts is the stock node's own."""
    sim, _, free = numbers
    mine = (
        node(free)
        + end('publisher', free + 1, free, '/turtle1/pose')
        + frame(FrameKind.PUBLISH, NUMBERED.pack(free + 1) + b'\x02[1.0,1.0,1.0,1.0,1.0]')
    )
    trusted, error = after_the_sim(mine)
    assert isinstance(error, Gone)
    provenance = trusted.recorder.provenance
    assert [
        row[4] for row, of in zip(trusted.recorder.nodes, provenance.owners['nodes'], strict=True) if of in provenance.programs
    ] == [sim]


def test_the_digest_of_a_recording_does_not_depend_on_the_name_of_a_temporary_file() -> None:
    both = (frame(FrameKind.TEMPORARY, dump(path)) for path in ('/tmp/my-x1y2', '/usr'))
    trusted, error = meet(b''.join(both) + token())
    assert isinstance(error, Gone) and trusted.recorder.roots == [['/tmp/my-x1y2', '@temporary']]


def test_too_many_bytes_are_too_many() -> None:
    note = frame(FrameKind.NOTE, dump([None, 'x', 'y' * 1000]))
    assert isinstance(meet(note * 100 + token(), quota=50_000)[1], TooMuch)


def test_half_a_frame_and_silence_is_an_end() -> None:
    assert isinstance(meet(token()[:-3])[1], Gone)


PARTS = [MINE, WITH_SIM, token(EPOCH_NS, 7), node(3), end('publisher', 4, 1, '/a'), frame(FrameKind.ADVANCE, TIME.pack(EPOCH_NS))]


@settings(max_examples=2 * EXAMPLES)
@given(st.lists(st.sampled_from(PARTS), max_size=6), st.lists(st.tuples(st.integers(0), st.integers(0, 255)), max_size=4))
def test_noise_ends_the_run(parts: list[bytes], changes: list[tuple[int, int]]) -> None:
    sent = bytearray(b''.join(parts) or b'x')
    for position, value in changes:
        sent[position % len(sent)] = value
    trusted, error = meet(bytes(sent), 0.2)
    assert isinstance(error, Exception)
    assert all(row['package'] != 'turtlesim' or row['argv'] == [SIM] for row in trusted.recorder.processes)
