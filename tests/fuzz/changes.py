"""Change a text or bytes as typing errors, cut files and strangers do: reproducible from a number."""

from __future__ import annotations

import copy
import datetime
import random
import re
from typing import Any

NASTY = (
    *(
        '',
        ' ',
        '\t',
        '\n',
        '\0',
        '"',
        "'",
        '\\',
        '$',
        '$(',
        ')',
        '$(var x)',
        '{',
        '}',
        '[',
        ']',
        '{}',
        '[]',
        '{{}}',
        ':',
        ': ',
        '- ',
        '~',
        '*a',
        '&a',
    ),
    *(
        '!!python/object:os.system',
        '!!binary x',
        '<<: *a',
        '? ',
        '|\n',
        '>',
        '%',
        '@',
        '`',
        '#',
        '...',
        '---',
        '/',
        '//',
        '~/',
        '../',
        '/dev/null',
    ),
    *(
        '-1',
        '0',
        '1e999',
        '-0.0',
        'nan',
        '.inf',
        '0x7f',
        '1_0',
        '9' * 30,
        'true',
        'yes',
        'None',
        'null',
        'é',
        'ß\u0301',
        '\u202e',
        '\U0001f422',
    ),
    *(
        '--',
        '-',
        '-r',
        '--ros-args',
        '-p',
        'a:=b',
        ':=',
        '__node:=',
        '__ns:=/',
        '<',
        '>',
        '<!DOCTYPE x>',
        '<!-- ',
        '&lt;',
        '&x;',
        ']]>',
        '<a b="c"/>',
    ),
    *('lambda: 0', 'print', 'object()', '()', '(', ',', '**{}', '*()', 'raise', '@x', 'a' * 300, 'a/' * 60, '(' * 120, '[' * 120),
)
PIECES = re.compile(r"'[^'\n]*'|\"[^\"\n]*\"|\w+|[^\w\s]|\s+")


def changed(text: str, chance: random.Random) -> str:
    """A text with one to four of its pieces replaced, left out, doubled or exchanged, or cut short."""
    pieces = PIECES.findall(text)
    for _ in range(chance.randint(1, 4)):
        place = chance.randrange(len(pieces)) if pieces else 0
        way = chance.randrange(7)
        if way == 0:
            pieces[place : place + 1] = []
        elif way == 1:
            pieces[place:place] = pieces[place : place + chance.randint(1, 8)]
        elif way == 2 and pieces:
            other = chance.randrange(len(pieces))
            pieces[place : place + 1], pieces[other : other + 1] = pieces[other : other + 1], pieces[place : place + 1]
        elif way == 3 and chance.random() < 0.2:
            pieces[place:] = []
        else:
            pieces[place : place + chance.randint(0, 2)] = [chance.choice(NASTY)]
    return ''.join(pieces)


def changed_bytes(data: bytes, chance: random.Random) -> bytes:
    """The same, sometimes with bytes that are no text."""
    made = changed(data.decode(), chance).encode()
    if chance.random() < 0.2:
        place = chance.randint(0, len(made))
        made = made[:place] + chance.randbytes(chance.randint(1, 4)) + made[place + chance.randint(0, 4) :]
    return made


VALUES: tuple[Any, ...] = (
    *(
        None,
        True,
        False,
        0,
        1,
        -1,
        7,
        255,
        1 << 40,
        1 << 70,
        0.5,
        -2.5,
        1e300,
        float('inf'),
        float('nan'),
        datetime.date(2026, 1, 1),
    ),
    *(
        '',
        ' ',
        'a',
        'A b',
        '/',
        '/a',
        'a/b',
        '/a//b',
        '1',
        'nan',
        '$(x)',
        '$(arg who)',
        '{a',
        'é',
        '\0',
        'std_msgs/msg/String',
        'x' * 300,
    ),
    *(
        [],
        {},
        [[]],
        [{}],
        ['a'],
        [1, 'a', None],
        {'a': 1},
        {'': {}},
        {1: 2},
        {'between': [2, 1]},
        {'are': ['/a']},
        [[1, 2], [3]],
        b'bytes',
    ),
)


def changed_data(data: Any, chance: random.Random) -> Any:
    """Plain data with one to three of its parts replaced, left out, doubled, renamed or exchanged."""
    made = [copy.deepcopy(data)]  # so that the whole has a place, too
    for _ in range(chance.randint(1, 3)):
        holder, key = chance.choice(list(_places(made)))
        way = chance.randrange(6)
        if way == 0 and holder is not made:
            del holder[key]
        elif way == 1 and isinstance(holder, list) and holder is not made:
            holder.insert(key, copy.deepcopy(holder[key]))
        elif way == 2 and isinstance(holder, dict):
            holder[chance.choice(['', 'a', key + 'x' if isinstance(key, str) else 'x', 3, None])] = holder.pop(key)
        elif way == 3:
            other, place = chance.choice(list(_places(made)))
            holder[key] = copy.deepcopy(other[place])
        elif way == 4 and isinstance(holder[key], (int, float, str)):
            holder[key] = (
                changed(holder[key], chance)
                if isinstance(holder[key], str)
                else chance.choice((-holder[key], holder[key] + 0.5, 1 << 65))
            )
        else:
            holder[key] = copy.deepcopy(chance.choice(VALUES))
    return made[0]


def _places(data: Any) -> Any:
    """Every (list or dictionary, index or key) in the data."""
    for key in list(data) if isinstance(data, dict) else range(len(data)):
        yield data, key
        if isinstance(data[key], (list, dict)):
            yield from _places(data[key])
