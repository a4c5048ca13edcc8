"""Whatever is in a file: it is a recording that answers every question, or there is one clear error."""

from __future__ import annotations

import builtins
import contextlib
import copy
import json
import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from edulaunch.desk.cli.recording import lines, summarise
from edulaunch.desk.view.replay import timeline_of
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.frames import frame_links
from edulaunch.engine.recording.trajectory import moving_things
from edulaunch.errors import RecordingError
from tests.house import EXAMPLES

from .conftest import turtle_run

OWN = {
    'mine/msg/Level': 'uint8[] cells\nint16[2] pair\nfloat64[] q [1.0, nan]\nstring[<=2] words\nbyte b\nPoint at\nPoint[] more\n',
    'mine/msg/Point': 'uint8 LEFT=1\ngeometry_msgs/Point place\nfloat32 z\n',
    'mine/srv/Ask': 'string who\n---\nbool yes\n',
}
POINT = [1.0, 2.0, 3.0, 0.5]


def whole() -> list[Any]:
    """The parts of a recording with messages of a student's own types, as JSON."""
    content = turtle_run()._content
    level = [{'hex': '0102'}, [1, -1], [math.nan, 1.5], ['a'], {'hex': '61'}, *POINT, [POINT, POINT]]
    content['interfaces'] = OWN
    content['topics'].append(
        {'topic': '/level', 'type': 'mine/msg/Level', 'times': [1, 2], 'publishers': [1, 1], 'messages': [level, level]}
    )
    content['endpoints'].append(['publisher', '/level', 'mine/msg/Level', 1, 99, 5, []])
    content['calls'].append([5, '/ask', 'mine/srv/Ask', '/sim', ['me'], True, 7, [True]])
    text = '/a: /sim (x) and /ns/watcher (y) cannot talk because of TYPE'
    content['notes'].append([5, 'sim-1', 'incompatible', text])
    return [json.loads(line) for line in Recording(content).to_bytes().splitlines()]


WHOLE = whole()


def text_of(parts: list[Any]) -> bytes:
    return b'\n'.join(json.dumps(part).encode() for part in parts) + b'\n'


def ask_everything(data: bytes) -> Recording:
    timeline_of(Recording.from_bytes(data))  # of one that nothing has read before
    recording = Recording.from_bytes(data)
    '\n'.join(lines(summarise(recording))).encode()
    recording.mismatches, recording.service_calls, recording.frames_at(1.0), frame_links(recording)
    for node in recording.nodes:
        recording.parameters(node.name)
    for topic in recording.topics:
        for _, message in recording.messages(topic):
            repr(message)
    for name in moving_things(recording):
        recording.trajectory(name)
    assert Recording.from_bytes(recording.to_bytes()).digest() == recording.digest()
    return recording


def places(value: Any, here: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inside = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [here, *(place for key, item in inside for place in places(item, (*here, key)))]


PLACES = places(WHOLE)[1:]
PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=5) | st.sampled_from(list(OWN)) | st.just(POINT),
    lambda inside: st.lists(inside, max_size=3) | st.dictionaries(st.sampled_from(['hex', 'type', 'a']), inside, max_size=2),
    max_leaves=4,
)


def test_an_undamaged_one_answers() -> None:
    recording = ask_everything(text_of(WHOLE))
    level = recording.messages('/level')[0][1]
    assert level.cells.tolist() == [1, 2] and list(level.pair) == [1, -1] and level.b == b'a' and level.at.place.y == 2.0
    assert (level.at.LEFT, level.more[1].z, level.words) == (1, 0.5, ['a']) and recording.service_calls[-1].response.yes
    assert repr(level.at) == 'mine.msg.Point(place=geometry_msgs.msg.Point(x=1.0, y=2.0, z=3.0), z=0.5)'
    assert level.at == level.more[0]
    assert recording.series('/level', 'at.place.y') == [(1e-9, 2.0), (2e-9, 2.0)]


@pytest.mark.parametrize('value', ['fast', None, []])
def test_the_page_of_a_damaged_one_is_refused(value: Any) -> None:
    parts = copy.deepcopy(WHOLE)
    (part,) = (part for part in parts if '/turtle1/pose' in json.dumps(part) and 'messages' in json.dumps(part))
    columns = part['topics'] if isinstance(part, dict) and 'topics' in part else [part]
    column = next(column for column in columns if column.get('topic') == '/turtle1/pose')
    column['messages'][1][0] = value
    with pytest.raises(RecordingError, match='it has messages that are not of the type turtlesim/msg/Pose'):
        timeline_of(Recording.from_bytes(text_of(parts)))


@settings(max_examples=4 * EXAMPLES, suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(st.tuples(st.sampled_from(PLACES), PLAIN | st.just(...)), min_size=1, max_size=3))
def test_another_value_anywhere(changes: list[tuple[tuple[Any, ...], Any]]) -> None:
    parts = copy.deepcopy(WHOLE)
    for place, value in changes:
        holder: Any = parts
        try:
            for key in place[:-1]:
                holder = holder[key]
            if value is ...:
                del holder[place[-1]]
            else:
                holder[place[-1]] = value
        except (KeyError, IndexError, TypeError):
            continue  # an earlier change took the place away
    try:
        ask_everything(text_of(parts))
    except RecordingError as error:
        assert str(error)


@settings(max_examples=3 * EXAMPLES)
@given(st.data())
def test_other_bytes_anywhere(data: Any) -> None:
    text = bytearray(text_of(WHOLE))
    for _ in range(data.draw(st.integers(1, 3))):
        start = data.draw(st.integers(0, len(text)))
        text[start : start + data.draw(st.integers(0, 4))] = data.draw(st.binary(max_size=4))
    with contextlib.suppress(RecordingError):
        ask_everything(bytes(text))


def deep(levels: int, last: str) -> dict[str, str]:
    """Types each of which holds the next one twice."""
    return {f'mine/msg/T{i}': f'T{i + 1} a\nT{i + 1} b\n' for i in range(levels)} | {f'mine/msg/T{levels}': last}


@pytest.mark.parametrize(
    'texts, told',
    [
        (deep(26, 'float64 x\n'), 'has more than 10000 values'),
        (deep(3000, 'float64 x\n'), 'too many nested messages|more than 10000 values'),
        ({'mine/msg/T0': 'T0 a\n'}, 'contains itself'),
        ({'mine/msg/T0': 'T0[] a\n'}, 'contains itself'),
        ({'mine/msg/T0': 'Gone a\n'}, 'unknown'),
        ({'mine/msg/T0': 'float64 class = (\n'}, "'mine/msg/T0' cannot be read|mine/msg/T0"),
        ({'mine/srv/T0': '---\n'}, 'unknown'),
    ],
)
def test_types_without_end(texts: dict[str, str], told: str) -> None:
    parts = copy.deepcopy(WHOLE)
    parts = [part for part in parts if 'interfaces' not in part and 'topic' not in part]
    topic = {'topic': '/t', 'type': 'mine/msg/T0', 'times': [0], 'publishers': [1], 'messages': [[1.0]]}
    parts += [{'interfaces': {'mine/srv/Ask': OWN['mine/srv/Ask'], **texts}}, topic]
    parts[5]['endpoints'] = [['publisher', '/t', 'mine/msg/T0', 1, 99, 5, []]]
    with pytest.raises(RecordingError, match=told):
        ask_everything(text_of(parts))


def test_types_of_which_nothing_is_left_take_no_time() -> None:
    parts = [part for part in copy.deepcopy(WHOLE) if 'interfaces' not in part and 'topic' not in part]
    topic = {'topic': '/t', 'type': 'mine/msg/T0', 'times': [0], 'publishers': [1], 'messages': [[]]}
    parts += [{'interfaces': deep(40, 'uint8 ONE=1\n')}, topic]
    parts[5]['endpoints'] = [['publisher', '/t', 'mine/msg/T0', 1, 99, 5, []]]
    with pytest.raises(RecordingError, match='more than 10000'):
        Recording.from_bytes(text_of(parts)).messages('/t')


def test_nothing_of_a_file_is_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    ask_everything(text_of(WHOLE))  # the underlay's own classes are made

    def refuse(*_: Any, **__: Any) -> Any:
        raise AssertionError('compiled')

    for name in ('compile', 'exec', 'eval'):
        monkeypatch.setattr(builtins, name, refuse)
    texts = {name.replace('Level', 'list').replace('Point', 'Int'): text.replace('Point', 'Int') for name, text in OWN.items()}
    data = text_of(WHOLE).replace(b'mine/msg/Point', b'mine/msg/Int').replace(b'Point at', b'Int at')
    assert texts and ask_everything(data.replace(b'Point[] more', b'Int[] more')).messages('/level')


def test_what_is_no_file_is_not_read(tmp_path: Path) -> None:
    for name in ('/dev/zero', str(tmp_path), 'a\0b'):
        with pytest.raises(RecordingError, match='cannot read the recording'):
            Recording.load(name)


@pytest.mark.parametrize(
    ('limit', 'what'),
    [('MOST_BYTES', 'more than 1000 bytes\n'), ('MOST_LINE_BYTES', '1000 bytes in one line'), ('MOST_VALUES', '1000 values')],
)
def test_a_file_that_is_too_large_is_not_parsed_unless_it_is_trusted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, limit: str, what: str
) -> None:
    from edulaunch.engine.recording import file_format

    content = Recording.from_bytes(text_of(WHOLE))._content
    content['logs'] *= 500
    (tmp_path / 'large.rec').write_bytes(Recording(content).to_bytes())
    assert Recording.load(tmp_path / 'large.rec').logs
    monkeypatch.setattr(file_format, limit, 1000)
    with monkeypatch.context() as patch, pytest.raises(RecordingError, match=f'cannot read the recording .*{what}'):
        patch.setattr(file_format, '_parse', None)
        Recording.load(tmp_path / 'large.rec')
    assert len(Recording.load(tmp_path / 'large.rec', trusted=True).logs) == len(content['logs'])
