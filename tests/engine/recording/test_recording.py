"""Questions one asks a recording."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.recording import Recording, file_format
from edulaunch.engine.recording.file_format import decode
from edulaunch.errors import RecordingError

from .conftest import turtle_run


def test_processes_know_where_they_were_written_and_how_they_ended(recording: Recording) -> None:
    assert [(p.name, p.pid, p.origin, p.started_s, p.ended_s, p.returncode) for p in recording.processes] == [
        ('sim-1', 1001, ('/home/me/a.launch.py', 12), 0.0, None, None),
        ('watcher-2', 1002, ('/home/me/a.launch.py', 12), 0.0, 1.5, 0),
    ]
    assert recording.processes[0].parameter_origins == {'radius': 'launch argument circle_radius'}


def test_nodes_know_their_ends(recording: Recording) -> None:
    assert [(n.name, n.process, n.ended_s, n.publishers, n.subscriptions, n.services, n.clients) for n in recording.nodes] == [
        (
            '/sim',
            'sim-1',
            None,
            [('/turtle1/pose', 'turtlesim/msg/Pose'), ('/tf', 'tf2_msgs/msg/TFMessage')],
            [],
            [('/spawn', 'turtlesim/srv/Spawn')],
            [],
        ),
        ('/ns/watcher', 'watcher-2', 1.5, [], [('/turtle1/pose', 'turtlesim/msg/Pose')], [], [('/spawn', 'turtlesim/srv/Spawn')]),
    ]


def test_topics_are_in_alphabetical_order_with_their_counts(recording: Recording) -> None:
    assert [(t.name, t.type, t.publishers, t.subscriptions, t.count) for t in recording.topics.values()] == [
        ('/tf', 'tf2_msgs/msg/TFMessage', ['/sim'], [], 5),
        ('/turtle1/pose', 'turtlesim/msg/Pose', ['/sim'], ['/ns/watcher'], 5),
    ]


def test_the_last_value_of_a_parameter_counts_with_its_origin(recording: Recording) -> None:
    assert recording.parameters('/sim') == {'background_r': (150, 'command line')}
    assert recording.parameters('/ns/watcher') == {}
    with pytest.raises(
        KeyError, match="no parameter 'background_g' of /sim in this recording; there are: background_r\n  help: did you"
    ):
        recording.parameters('/sim')['background_g']
    with pytest.raises(KeyError, match='help: /ns/watcher ended at 1.50 s: look at what it printed last'):
        recording.parameters('/ns/watcher')['radius']
    with pytest.raises(KeyError, match="no node '/simm' in this recording; there are: /sim, /ns/watcher"):
        recording.parameters('/simm')


def test_messages_come_with_their_time(recording: Recording) -> None:
    messages = recording.messages('/turtle1/pose')
    assert [(time, message.x) for time, message in messages] == [(0.0, 1.0), (0.5, 2.0), (1.0, 3.0), (1.5, 4.0), (2.0, 5.0)]
    assert recording.series('/turtle1/pose', 'x', 'y')[1] == (0.5, 2.0, 2.0)
    assert recording.series('/turtle1/pose', 'theta')[0] == (0.0, 0.0)
    assert recording.messages('/nothing') == []


def test_a_series_has_what_the_messages_have_of_each_publisher_in_order_of_time() -> None:
    content = decode(turtle_run().to_bytes())
    poses = next(topic for topic in content['topics'] if topic['topic'] == '/turtle1/pose')
    later = {
        **poses,
        'times': [time + 1 for time in poses['times']],
        'messages': [[7.0, *rest] for _, *rest in poses['messages']],
    }
    recording = Recording({**content, 'topics': [*content['topics'], later]})
    messages = recording.messages('/turtle1/pose')
    assert len(messages) == 10
    assert recording.series('/turtle1/pose', 'theta', 'x') == [(time, message.theta, message.x) for time, message in messages]
    stamped = recording.series('/tf', 'transforms[0].header.frame_id', 'transforms[0].transform.translation.x')
    assert stamped == [(time, tf.header.frame_id, tf.transform.translation.x) for time, (tf,) in _transforms(recording)]


def _transforms(recording: Recording) -> list[tuple[float, Any]]:
    return [(time, message.transforms) for time, message in recording.messages('/tf')]


def test_a_topic_that_was_not_there_is_empty_and_its_first_message_names_the_nearest(recording: Recording) -> None:
    for none in (recording.messages('/turtle1/poze'), recording.series('/turtle1/poze', 'x')):
        assert (none, list(none), none[:1]) == ([], [], [])
        for which in (0, -1):
            with pytest.raises(
                KeyError, match=r"no topic '/turtle1/poze' in this recording; there are: (?s:.*)did you mean '/turtle1/pose'"
            ):
                none[which]


def test_a_trajectory_is_arrays(recording: Recording) -> None:
    track = recording.trajectory('turtle1')
    assert (track.t.tolist(), track.x.tolist(), track.theta.shape) == ([0.0, 0.5, 1.0, 1.5, 2.0], [1.0, 2.0, 3.0, 4.0, 5.0], (5,))
    with pytest.raises(KeyError, match="nothing called 'turtle9' moved in this recording; there are: turtle1"):
        recording.trajectory('turtle9')


def test_frames_are_those_known_at_the_time(recording: Recording) -> None:
    assert recording.frames_at(1.2) == {'turtle1': ('world', (3.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0), False, 1.0)}


def test_logs_output_and_calls_are_kept(recording: Recording) -> None:
    assert [tuple(log) for log in recording.logs] == [(1.0, 'sim-1', 'sim', 20, 'Spawning turtle [turtle2]')]
    assert [tuple(text) for text in recording.output] == [(1.0, 'sim-1', 'stderr', 'half a line')]
    call = recording.service_calls[0]
    assert (call.time_s, call.service, call.client, call.served, call.request.name, call.response.name) == (
        0.25,
        '/spawn',
        '/ns/watcher',
        True,
        'turtle2',
        'turtle2',
    )


def test_saving_and_loading_gives_the_same_bytes(recording: Recording, tmp_path: Path) -> None:
    recording.save(tmp_path / 'run.rec')
    loaded = Recording.load(tmp_path / 'run.rec')
    assert (loaded.to_bytes(), loaded.digest()) == (recording.to_bytes(), recording.digest())
    assert [message.x for _, message in loaded.messages('/turtle1/pose')] == [1.0, 2.0, 3.0, 4.0, 5.0]
    assert list(tmp_path.iterdir()) == [tmp_path / 'run.rec']


def test_the_digest_of_bytes_of_ours_writes_long_topics_no_second_time(
    recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    data, wanted, written = recording.to_bytes(), recording.digest(), []
    line_of = file_format._line
    monkeypatch.setattr(file_format, '_line', lambda value: written.append(value.get('topic')) or line_of(value))
    assert Recording.from_bytes(data, is_ours=True).digest() == wanted
    assert '/turtle1/pose' not in written
    assert Recording.from_bytes(data).digest() == wanted
    assert '/turtle1/pose' in written


def test_the_same_run_gives_the_same_digest() -> None:
    assert turtle_run().digest() == turtle_run().digest()


def test_a_digest_covers_what_happened_and_not_where_files_lie(recording: Recording) -> None:
    content = dict(recording._content)
    moved = Recording({**content, 'launch': {'file': '/a/b/x.launch.py'}, 'roots': [['/a/b', '@launch']]})
    elsewhere = Recording({**content, 'launch': {'file': '/c/x.launch.py'}, 'roots': [['/c', '@launch']]})
    other = Recording({**content, 'launch': {'file': '/c/y.launch.py'}, 'roots': [['/c', '@launch']]})
    assert moved.digest() == elsewhere.digest() != other.digest()


def test_a_message_may_name_a_file_too(recording: Recording) -> None:
    """As the parameter event of a parameter that defaults to a file in a share folder."""
    digests = set()
    for folder in ('/a/b', '/c'):
        topic = {
            'topic': '/where',
            'type': 'std_msgs/msg/String',
            'times': [0],
            'publishers': [0],
            'messages': [[f'{folder}/x.yaml']],
        }
        digests.add(Recording({**recording._content, 'topics': [topic], 'roots': [[folder, '@workspace']]}).digest())
    assert len(digests) == 1


@pytest.mark.parametrize(
    ('data', 'text'),
    [
        (b'', 'this input is not a recording of edulaunch'),
        (b'\x00\xff\n', 'this input is not a recording of edulaunch'),
        (b'[]\n', 'this input is not a recording of edulaunch'),
        (b'{"format": "something"}\n', 'is not a recording of edulaunch'),
        (b'{"format": "edulaunch recording", "version": 99}\n', 'has recording format 99; this edulaunch reads format 1'),
    ],
)
def test_what_is_no_recording_is_said_so(data: bytes, text: str) -> None:
    with pytest.raises(RecordingError, match=text):
        Recording.from_bytes(data)


def test_a_cut_off_recording_is_an_error_wherever_it_is_cut(recording: Recording) -> None:
    data = recording.to_bytes()
    lines = data.count(b'\n')
    whole = 0
    for cut in range(0, len(data) - 1, 97):
        try:
            Recording.from_bytes(data[:cut])
        except RecordingError:
            continue
        whole += 1
        assert data[cut : cut + 1] == b'\n' or data[cut - 1 : cut] == b'\n'
    assert lines > 5 and whole <= 2


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="cannot read the recording '.*gone.rec': No such file"):
        Recording.load(tmp_path / 'gone.rec')
    with pytest.raises(RecordingError, match='cannot write the recording'):
        turtle_run().save(tmp_path / 'no' / 'folder.rec')


@pytest.mark.skipif(not hasattr(os, 'mkfifo'), reason='no pipes with names')
def test_what_is_no_file_is_written_to_and_stays(recording: Recording, tmp_path: Path) -> None:
    pipe, file = tmp_path / 'pipe', tmp_path / 'file.rec'
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    (tmp_path / 'link.rec').symlink_to(file)
    recording.save(pipe)
    recording.save(tmp_path / 'link.rec')
    assert os.read(reader, 1 << 16) == file.read_bytes() == recording.to_bytes()
    os.close(reader)
    assert pipe.is_fifo() and (tmp_path / 'link.rec').is_symlink()


def test_what_is_unwound_at_the_end_is_not_recorded(stage: Any) -> None:
    process = stage.process('p-1', 100)
    stage.graph.add_node(process, 'node', '/')
    recording = stage.finish(1.0)
    assert recording.processes[0].ended_s is None and recording.nodes[0].ended_s is None
    assert recording.duration_s == 1.0


def test_messages_after_the_end_are_left_out(stage: Any) -> None:
    from std_msgs.msg import String

    publisher = stage.graph.create_publisher(
        stage.graph.add_node(stage.process('p-1', 100), 'node', '/'), '/chatter', String, QoS()
    )
    for seconds in (0.5, 1.0):
        stage.at(seconds, lambda: publisher.publish(('hello',)))
    stage.sim.run(stage.sim.start_ns + 10**9)
    stage.recorder.stop()
    stage.at(2.0, lambda: publisher.publish(('too late',)))
    recording = stage.finish(3.0)
    assert stage.recorder.publication_count() == 3
    assert [(time_s, message.data) for time_s, message in recording.messages('/chatter')] == [(0.5, 'hello'), (1.0, 'hello')]
