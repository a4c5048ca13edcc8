"""The command line of static_transform_publisher: flags, or the old fixed order of numbers."""

from __future__ import annotations

import re
from typing import NamedTuple

from edulaunch.tf.quaternions import from_euler
from edulaunch.tf.transforms import Transform

USAGE = """\
usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW]
                                  [--roll ROLL] [--pitch PITCH] [--yaw YAW]
                                  --frame-id FRAME_ID --child-frame-id CHILD_FRAME_ID

Publish one transform that never changes. What is left out is zero: no translation, no rotation.

required arguments:
  --frame-id FRAME_ID              parent frame
  --child-frame-id CHILD_FRAME_ID  child frame

optional arguments:
  --x X  --y Y  --z Z              translation in metres
  --qx QX  --qy QY  --qz QZ  --qw QW
                                   rotation as a quaternion
  --roll ROLL  --pitch PITCH  --yaw YAW
                                   rotation as angles in radians (not together with a quaternion)
  -h, --help                       show this text
"""

_QUATERNION, _EULER = ('qx', 'qy', 'qz', 'qw'), ('roll', 'pitch', 'yaw')
_NUMBERS = ('x', 'y', 'z', *_QUATERNION, *_EULER)
_NAMES = ('frame-id', 'child-frame-id')
_NUMBER = re.compile(r'\s*[+-]?(?:inf(?:inity)?|nan|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)', re.IGNORECASE)


class ArgumentError(Exception):
    """The command line cannot be used; the text is the reason that ROS gives."""


class Request(NamedTuple):
    """What is to be published."""

    frame_id: str
    child_frame_id: str
    transform: Transform
    old_style: bool


def parse(arguments: list[str]) -> Request:
    """Read the arguments after the program's name; ROS arguments have been taken out.

    :raises ArgumentError: with ROS's reason.
    """
    if not arguments:
        raise ArgumentError('Not enough arguments to parse')
    flags: dict[str, str] = {}
    rest: list[str] = []
    words = iter(arguments)
    for word in words:
        name = word[2:]
        if word.startswith('--') and name in (*_NUMBERS, *_NAMES):
            value = next(words, None)
            if value is None:
                raise ArgumentError(f'Not enough arguments for {word}')
            flags[name] = value
        else:
            rest.append(word)
    if not rest:
        return _from_flags(flags)
    if flags:
        raise ArgumentError('Cannot specify both new-style (flags) and old-style (arguments)')
    return _from_positions(rest)


def _from_flags(flags: dict[str, str]) -> Request:
    numbers = {name: _number(f'--{name}', text) for name, text in flags.items() if name in _NUMBERS}
    euler = [name for name in _EULER if name in numbers]
    if euler and any(name in numbers for name in _QUATERNION):
        raise ArgumentError('Cannot specify both quaternion and Euler rotations')
    x, y, z = (numbers.get(name, 0.0) for name in ('x', 'y', 'z'))
    if euler:
        rotation = from_euler(*(numbers.get(name, 0.0) for name in _EULER))
    elif any(name in numbers for name in _QUATERNION):
        qx, qy, qz, qw = (numbers.get(name, float(name == 'qw')) for name in _QUATERNION)
        rotation = (qx, qy, qz, qw)
    else:
        rotation = (0.0, 0.0, 0.0, 1.0)
    return _checked(flags.get('frame-id', ''), flags.get('child-frame-id', ''), (x, y, z, *rotation), False)


def _from_positions(words: list[str]) -> Request:
    """x y z yaw pitch roll frame child, or x y z qx qy qz qw frame child."""
    if len(words) < 8:
        raise ArgumentError('Not enough arguments to parse')
    if len(words) > 9:
        raise ArgumentError('Extra unparsed arguments on command-line')
    names = ('x', 'y', 'z', *(_QUATERNION if len(words) == 9 else _EULER[::-1]))
    numbers = [_number(f'--{name}', text) for name, text in zip(names, words, strict=False)]
    x, y, z = numbers[:3]
    if len(words) == 9:
        rotation = (numbers[3], numbers[4], numbers[5], numbers[6])
    else:
        rotation = from_euler(numbers[5], numbers[4], numbers[3])
    return _checked(words[-2], words[-1], (x, y, z, *rotation), True)


def _checked(frame_id: str, child_frame_id: str, transform: Transform, old_style: bool) -> Request:
    if not frame_id:
        raise ArgumentError('Frame id must not be empty')
    if not child_frame_id:
        raise ArgumentError('Child frame id must not be empty')
    return Request(frame_id, child_frame_id, transform, old_style)


def _number(option: str, text: str) -> float:
    """A float as C++ reads it: what follows the number is ignored."""
    match = _NUMBER.match(text)
    if match is None:
        raise ArgumentError(f'Failed to parse {option} argument as float')
    return float(match.group())
