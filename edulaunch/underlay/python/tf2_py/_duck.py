"""The values of a transform message, also of an object that only looks like one."""

from __future__ import annotations

import warnings
from typing import Any


def wire_of(transform: Any) -> tuple[Any, ...]:
    """(sec, nanosec, parent, child, x, y, z, qx, qy, qz, qw) of a TransformStamped or its look-alike.

    :raises TypeError: the translation is not a Vector3; a rotation that is not a Quaternion is a warning
        only.
    """
    from geometry_msgs.msg import Quaternion, Vector3

    stamp = transform.header.stamp
    translation, rotation = transform.transform.translation, transform.transform.rotation
    if not isinstance(translation, Vector3):
        warnings.warn('translation should be of type Vector3', UserWarning, stacklevel=4)
        raise TypeError('transform.translation must have members x, y, z')
    if not isinstance(rotation, Quaternion):
        warnings.warn('rotation should be of type Quaternion', UserWarning, stacklevel=4)
    return (
        stamp.sec,
        stamp.nanosec,
        transform.header.frame_id,
        transform.child_frame_id,
        translation.x,
        translation.y,
        translation.z,
        rotation.x,
        rotation.y,
        rotation.z,
        rotation.w,
    )
