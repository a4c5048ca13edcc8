"""The log lines with which tf2 explains why it ignores a transform."""

from __future__ import annotations

from math import copysign, isnan

from edulaunch.engine.tf.dumps import seconds_text
from edulaunch.engine.tf.transforms import Transform

Rejection = tuple[str, str]  # ('error' or 'warn', the text)

UNIT_TOLERANCE = 0.01  # largest difference of a quaternion's squared length from 1


def reasons_against(parent: str, child: str, pose: Transform, authority: str) -> tuple[Rejection, ...]:
    """Return tf2's errors about one transform, in the same order as tf2; () for a valid transform.

    :param parent: the name of the parent frame, without a leading slash.
    :param child: the name of the child frame, without a leading slash.
    :param pose: parent_from_child. Its quaternion is canonical, so it has length 1 or is nan.
    :param authority: the name of the publisher in tf2's log.
    """
    x, y, z, w = pose[3:]
    rotation = _numbers(pose[3:])
    found: list[str] = []
    if parent == child:
        found.append(
            f'TF_SELF_TRANSFORM: Ignoring transform from authority "{authority}" with frame_id and  '
            f'child_frame_id "{child}" because they are the same'
        )
    if not child:
        found.append(f'TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "{authority}" because child_frame_id not set ')
    if not parent:
        found.append(
            f'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "{child}"  from authority "{authority}" '
            'because frame_id not set'
        )
    if any(isnan(number) for number in pose):
        found.append(
            f'TF_NAN_INPUT: Ignoring transform for child_frame_id "{child}" from authority "{authority}" '
            f'because of a nan value in the transform ({_numbers(pose[:3])}) ({rotation})'
        )
    if not abs(x * x + y * y + z * z + w * w - 1.0) < UNIT_TOLERANCE:
        found.append(
            f'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "{child}" from authority '
            f'"{authority}" because of an invalid quaternion in the transform ({rotation})'
        )
    return tuple(('error', text) for text in found)


def too_old(child: str, stamp_ns: int, authority: str) -> tuple[Rejection, ...]:
    """Return tf2's warning about a sample that is older than everything in the buffer."""
    text = (
        f'TF_OLD_DATA ignoring data from the past for frame {child} at time {seconds_text(stamp_ns)} '
        f'according to authority {authority}\n'
        'Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained'
    )
    return (('warn', text),)


def _numbers(values: tuple[float, ...]) -> str:
    return ' '.join(_number(value) for value in values)


def _number(value: float) -> str:
    """Format a number like printf's %f. Unlike Python, printf shows the sign of nan."""
    return f'{"-" if copysign(1.0, value) < 0.0 else ""}nan' if isnan(value) else f'{value:.6f}'
