"""The file format of a recording: JSON lines, with the same bytes for the same run.

The first line is the header, followed by one line for each part. Then come lines for unusual facts, for declared parameters, and
for the definitions of the student's own message types, if there are any. The file ends with one line for each topic. Messages are
wire tuples written as JSON lists, and byte strings are written as {"hex": ...}. Reading a file creates only plain data.
"""

from __future__ import annotations

import io
import json
import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Any

from edulaunch.engine.recording import schema
from edulaunch.engine.underlay_place import help_text
from edulaunch.errors import RecordingError

FORMAT = 'edulaunch recording'
VERSION = 1
PARTS = tuple(schema.PARTS)
OPTIONAL_PARTS = ('facts', 'descriptors', 'interfaces', 'beside')
HEADER_NUMBERS = ('seed', 'start_ns', 'duration_ns')
TYPE_NAME = re.compile(r'[A-Za-z]\w*/(msg|srv|action)/[A-Za-z][A-Za-z0-9]*', re.ASCII)
TOPIC_KEYS = tuple(schema.TOPIC)
MOST_BYTES, MOST_LINE_BYTES, MOST_VALUES = 1 << 28, 1 << 27, 10_000_000
"""The limits for a recording that the caller does not trust. A value takes up to 90 bytes of memory, and two or three of a
file. Ten minutes of ten turtles have 4 million values.
"""


def encode(content: dict[str, Any], known: Mapping[int, bytes] = MappingProxyType({})) -> bytes:
    """Return a recording's content as bytes; see `lines_of`."""
    return b''.join(lines_of(content, known))


def lines_of_topics(data: bytes, content: dict[str, Any]) -> dict[int, bytes]:
    """Return the line of each topic in the bytes of `encode`, by the `id` of the topic in the decoded content."""
    topics = content['topics']
    return dict(zip(map(id, topics), data.splitlines(keepends=True)[-len(topics) :] if topics else (), strict=True))


def lines_of(content: dict[str, Any], known: Mapping[int, bytes] = MappingProxyType({})) -> Iterator[bytes]:
    """Yield a recording file line by line, so that writing a long run needs less memory.

    :param content: the content of the recording.
    :param known: lines of topics from the file from which the content was read, by the `id` of the topic. These lines are
        used unchanged.
    """
    yield _line({'format': FORMAT, 'version': VERSION, **{key: content[key] for key in HEADER_NUMBERS}})
    yield from (_line({part: content[part]}) for part in PARTS)
    yield from (_line({part: content[part]}) for part in OPTIONAL_PARTS if content.get(part))
    for topic in content['topics']:
        yield known.get(id(topic)) or _line({key: topic[key] for key in TOPIC_KEYS})


def _line(value: Any) -> bytes:
    return json.dumps(value, default=_plain, separators=(',', ':')).encode() + b'\n'


def _plain(value: Any) -> Any:
    if isinstance(value, (bytes, bytearray)):
        return {'hex': bytes(value).hex()}
    if hasattr(value, 'tolist'):
        return value.tolist()
    raise TypeError(f'a recording can contain only plain data, not {type(value).__name__}')


def _restore(mapping: dict[str, Any]) -> Any:
    return bytes.fromhex(mapping['hex']) if len(mapping) == 1 and isinstance(mapping.get('hex'), str) else mapping


def refuse_huge(data: bytes, name: str) -> None:
    """Reject a recording that is too large, before reading its values takes memory and time.

    :raises RecordingError: if the recording has too many bytes, too many values, or too long a line.
    """
    values = sum(map(data.count, (b',', b'[', b'{')))
    line = max(map(len, io.BytesIO(data)), default=0)
    for count, most, what in (
        (len(data), MOST_BYTES, 'bytes'),
        (line, MOST_LINE_BYTES, 'bytes in one line'),
        (values, MOST_VALUES, 'values'),
    ):
        if count > most:
            raise RecordingError(
                f'cannot read the recording {name!r}: it has more than {most} {what}', help=help_text('huge-recording')
            )


def decode(data: bytes, name: str = 'this input') -> dict[str, Any]:
    """Return the content of a recording file.

    :param name: the name of the file, for error messages.
    :raises RecordingError: if the file is not a recording, has another version, or is damaged.
    """
    lines = io.BytesIO(data)
    first = lines.readline()
    header = _parse(first, name, 1) if first.startswith(b'{') else {}
    if header.get('format') != FORMAT:
        raise RecordingError(f'{name} is not a recording of edulaunch.', help=help_text('no-recording'))
    if header.get('version') != VERSION:
        raise RecordingError(f'{name} has recording format {header.get("version")!r}; this edulaunch reads format {VERSION}.')
    content: dict[str, Any] = {**{key: header.get(key) for key in HEADER_NUMBERS}, 'facts': [], 'descriptors': [], 'beside': {}}
    content |= {'interfaces': {}, 'topics': []}
    for number, line in enumerate(lines, 2):
        if line != b'\n':
            part = _parse(line, name, number)
            if 'topic' in part:
                content['topics'].append(part)
            elif part.keys() <= {*PARTS, *OPTIONAL_PARTS}:
                content.update(part)
            else:
                raise RecordingError(f'{name} is damaged: line {number} is not a part of a recording.')
    _check(content, name)
    return content


def _parse(line: bytes, name: str, number: int) -> dict[str, Any]:
    try:
        value = json.loads(line, object_hook=_restore)
    except (ValueError, RecursionError) as error:
        raise RecordingError(f'{name} is damaged: line {number} is not JSON ({error}).') from None
    if not isinstance(value, dict):
        raise RecordingError(f'{name} is damaged: line {number} is not a part of a recording.')
    return value


def _check(content: dict[str, Any], name: str) -> None:
    """Raise RecordingError unless every part exists and has the right form, so that other code can rely on it."""
    numbers = [content[key] for key in HEADER_NUMBERS]
    if not all(map(schema.number, numbers)) or not 0 <= content['duration_ns'] < schema.FAR - abs(content['start_ns']):
        raise RecordingError(f'{name} is damaged: its header lacks {", ".join(HEADER_NUMBERS)}.')
    for part, fits in schema.PARTS.items():
        if not fits(content.get(part)):
            raise RecordingError(f'{name} is damaged: the part {part!r} is missing, incomplete or invalid.')
    for part, fits in schema.OPTIONAL.items():
        if not fits(content[part]):
            raise RecordingError(f'{name} is damaged: the part {part!r} is incomplete or invalid.')
    texts = content['interfaces']
    if not schema.table(schema.text)(texts) or not all(map(TYPE_NAME.fullmatch, texts)):
        raise RecordingError(f"{name} is damaged: the part 'interfaces' does not contain definitions of message types.")
    for topic in content['topics']:
        if not schema.record(schema.TOPIC)(topic) or len({len(topic[key]) for key in ('times', 'publishers', 'messages')}) != 1:
            raise RecordingError(f'{name} is damaged: the columns of a topic do not fit together.')
