"""A recording as a client sees it: it plays, pauses, seeks and ends, on ordered logs and without real time."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip('tornado')

import edulaunch
from edulaunch.engine.recording import Recording
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.recorded import NO_CHANGES, RecordingFeed
from edulaunch.ros.serialization.cdr import encode
from tests.extras.foxglove.feeds import Spoken

POSE = 'turtlesim/msg/Pose'
TOPIC = '/turtlesim1/turtle1/pose'
PLAYING, PAUSED, ENDED = 0, 1, 3


@pytest.fixture(scope='module')
def recording() -> Recording:
    return edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=4)


class Player:
    """A recording that plays for a client, on a clock that the test turns."""

    def __init__(self, recording: Recording, controls: bool = True) -> None:
        self.now_s = 100.0
        feed = RecordingFeed(recording, 'multisim.rec', controls, lambda: self.now_s)
        self.start_ns = recording.start_ns
        self.spoken = Spoken(Conversation(feed))
        self.spoken.turn()

    def pass_time(self, seconds: float) -> None:
        self.now_s += seconds
        self.spoken.turn()

    def control(self, command: int, speed: float = 1.0, seek_s: float | None = None, name: bytes = b'') -> None:
        seek_ns = 0 if seek_s is None else self.start_ns + round(seek_s * 1e9)
        packed = struct.pack('<BBfBQI', 3, command, speed, seek_s is not None, seek_ns, len(name))
        self.spoken.conversation.take(packed + name)

    def states(self) -> list[tuple[int, float, float, int, bytes]]:
        """(state, seconds, speed, whether the place is another one, request) of all playback states."""
        found = []
        for one in self.spoken.log:
            if isinstance(one, bytes) and one[0] == 5:
                state, time_ns, speed, did_seek, length = struct.unpack_from('<BQfBI', one, 1)
                assert len(one) == 19 + length
                found.append((state, (time_ns - self.start_ns) / 1e9, speed, did_seek, one[19:]))
        return found

    def times(self) -> list[float]:
        return [(time_ns - self.start_ns) / 1e9 for time_ns, _ in self.spoken.data()]


def rows(recording: Recording, begin_s: float, end_s: float) -> list[tuple[int, bytes]]:
    """(time, CDR) of the poses after `begin_s` until `end_s`."""
    wires, cls = recording.wires(TOPIC, POSE), recording.message_class(POSE)
    start = recording.start_ns
    return [(start + ns, encode(cls, wire)) for ns, wire in wires if begin_s * 1e9 < ns <= end_s * 1e9]


def test_it_says_from_when_to_when_and_plays_at_once(recording: Recording) -> None:
    player = Player(recording)
    [info] = player.spoken.texts('serverInfo')
    first, last = (info[name]['sec'] * 10**9 + info[name]['nsec'] for name in ('dataStartTime', 'dataEndTime'))
    assert (first, last) == (recording.start_ns, recording.start_ns + 4 * 10**9)
    assert 'playbackControl' in info['capabilities'] and 'clientPublish' not in info['capabilities']
    player.spoken.subscribe(TOPIC)
    player.pass_time(1.0)
    player.pass_time(0.5)
    assert player.spoken.data() == rows(recording, 0.0, 1.5)
    assert player.states() == [(PLAYING, 0.0, 1.0, 0, b'')]


def test_pause_speed_and_the_end(recording: Recording) -> None:
    player = Player(recording)
    player.spoken.subscribe(TOPIC)
    player.pass_time(1.0)
    player.control(1, name=b'stop')
    player.pass_time(5.0)
    assert player.times()[-1] <= 1.0
    player.control(0, speed=2.0, name=b'go')
    player.pass_time(1.0)
    player.pass_time(5.0)
    assert player.spoken.data() == rows(recording, 0.0, 4.0)
    assert player.states() == [
        (PLAYING, 0.0, 1.0, 0, b''),
        (PAUSED, 1.0, 1.0, 0, b'stop'),
        (PLAYING, 1.0, 2.0, 0, b'go'),
        (ENDED, 4.0, 2.0, 0, b''),
    ]
    player.control(0)
    assert player.spoken.turn() and player.states()[-1] == (PLAYING, 0.0, 1.0, 1, b'')


@pytest.mark.parametrize('seek_s', [0.5, 3.0])
def test_seek_shows_the_state_there_and_goes_on_from_there(recording: Recording, seek_s: float) -> None:
    player = Player(recording)
    player.spoken.subscribe(TOPIC)
    player.pass_time(2.0)
    before = len(player.spoken.data())
    player.control(1, seek_s=seek_s, name=b'there')
    player.pass_time(1.0)
    [shown] = player.spoken.data()[before:]
    assert shown == rows(recording, 0.0, seek_s)[-1]
    player.control(0)
    player.pass_time(0.5)
    assert player.spoken.data()[before + 1 :] == rows(recording, seek_s, seek_s + 0.5)
    assert player.states()[1] == (PAUSED, seek_s, 1.0, 1, b'there')


def test_a_client_of_the_old_protocol_gets_it_once_without_controls(recording: Recording) -> None:
    player = Player(recording, controls=False)
    player.spoken.subscribe(TOPIC)
    player.pass_time(9.0)
    [info] = player.spoken.texts('serverInfo')
    assert 'dataStartTime' not in info and 'playbackControl' not in info['capabilities']
    assert (player.spoken.data(), player.states()) == (rows(recording, 0.0, 4.0), [])


LATE = '<launch><timer period="2.0"><node pkg="turtlesim" exec="turtlesim_node"/></timer></launch>'


def test_parameters_and_graph_are_those_of_the_time(tmp_path: Path) -> None:
    (tmp_path / 'late.launch.xml').write_text(LATE)
    player = Player(edulaunch.run(tmp_path / 'late.launch.xml', duration_s=4))
    player.control(1, seek_s=1.0)
    player.spoken.op('getParameters', parameterNames=['/turtlesim.background_r'], id='early')
    player.spoken.op('subscribeConnectionGraph')
    player.spoken.turn()
    player.control(1, seek_s=3.0)
    player.spoken.op('getParameters', parameterNames=['/turtlesim.background_r'], id='late')
    player.spoken.turn()
    early, late = (text['parameters'] for text in player.spoken.texts('parameterValues'))
    assert (early, late) == ([], [{'name': '/turtlesim.background_r', 'value': 69}])
    first, second = player.spoken.texts('connectionGraphUpdate')
    pose = {'name': '/turtle1/pose', 'publisherIds': ['/turtlesim']}
    assert pose not in first['publishedTopics'] and pose in second['publishedTopics']


def test_nothing_of_a_recording_can_be_changed(recording: Recording) -> None:
    player = Player(recording)
    asked: list[dict[str, Any]] = [
        {'channels': [{'id': 1, 'topic': '/x', 'encoding': 'cdr', 'schemaName': 'std_msgs/msg/Empty'}], 'operation': 'advertise'},
        {'parameters': [{'name': '/a.b', 'value': 1}], 'operation': 'setParameters'},
    ]
    for one in asked:
        player.spoken.op(**one)
    player.spoken.turn()
    assert player.spoken.statuses() == [NO_CHANGES, NO_CHANGES]
