"""The bytes of a recording file, line by line."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy
import pytest

from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.file_format import HEADER_NUMBERS, PARTS, TOPIC_KEYS, decode, encode, lines_of, lines_of_topics


@pytest.fixture
def content(recording: Recording, tmp_path: Path) -> dict[str, Any]:
    recording.save(tmp_path / 'run.edulaunch')
    return decode((tmp_path / 'run.edulaunch').read_bytes(), 'run.edulaunch')


def test_a_header_comes_first_then_each_part_and_at_the_end_the_topics(content: dict[str, Any]) -> None:
    lines = [json.loads(line) for line in lines_of({**content, 'facts': []})]
    assert list(lines[0]) == ['format', 'version', *HEADER_NUMBERS] and lines[0]['version'] == 1
    assert [list(line) for line in lines[1 : 1 + len(PARTS)]] == [[part] for part in PARTS]
    assert [tuple(line) for line in lines[-len(content['topics']) :]] == [TOPIC_KEYS] * len(content['topics'])


def test_what_was_encoded_is_decoded_and_encoded_to_the_same_bytes(content: dict[str, Any]) -> None:
    data = encode(content)
    assert decode(data, 'again') == content and encode(decode(data, 'again')) == data


def test_the_known_line_of_a_topic_is_used_unchanged(content: dict[str, Any]) -> None:
    data = encode(content)
    known = lines_of_topics(data, content)
    assert list(known) == [id(topic) for topic in content['topics']]
    assert [json.loads(line)['topic'] for line in known.values()] == [topic['topic'] for topic in content['topics']]
    topic = content['topics'][0]
    assert encode(content, {id(topic): b'known line\n'}).splitlines()[-len(content['topics'])] == b'known line'


def test_a_recording_without_topics_has_no_lines_of_them(content: dict[str, Any]) -> None:
    empty = {**content, 'topics': []}
    assert lines_of_topics(encode(empty), empty) == {}
    with pytest.raises(ValueError, match='shorter'):
        lines_of_topics(b'', content)


@pytest.mark.parametrize(
    ('value', 'text'),
    [
        (b'\x01\xff', '{"hex":"01ff"}'),
        (bytearray(b'a'), '{"hex":"61"}'),
        (numpy.float32(0.5), '0.5'),
        (numpy.array([[1, 2], [3, 4]]), '[[1,2],[3,4]]'),
    ],
)
def test_bytes_and_values_of_numpy_are_plain_data(content: dict[str, Any], value: Any, text: str) -> None:
    part = PARTS[0]
    line = list(lines_of({**content, part: [value]}))[1]
    assert line == f'{{"{part}":[{text}]}}\n'.encode()


def test_anything_else_is_refused_by_its_type(content: dict[str, Any]) -> None:
    with pytest.raises(TypeError, match='a recording can contain only plain data, not object'):
        encode({**content, PARTS[0]: [object()]})
