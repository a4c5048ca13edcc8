"""`BufferCore`, whose methods accept and return messages, and tf2's exceptions.

The transforms themselves are stored in `edulaunch.engine.tf.TransformBuffer`.
"""

from __future__ import annotations

import warnings
from typing import Any

from geometry_msgs.msg import TransformStamped

from edulaunch.engine.tf import TransformBuffer, TransformFailure
from edulaunch.engine.tf.buffer import DEFAULT_CACHE_NS
from edulaunch.engine.tf.rejection import Rejection
from edulaunch.engine.tf.transforms import Transform
from edulaunch.engine.tf.velocity import lookup_velocity


def report(rejections: tuple[Rejection, ...]) -> None:
    """Log each line with its severity."""
    from rclpy.impl.rcutils_logger import RcutilsLogger
    from rclpy.logging import LoggingSeverity

    logger = RcutilsLogger('')
    for severity, text in rejections:
        logger.log(text, LoggingSeverity.ERROR if severity == 'error' else LoggingSeverity.WARN)


def nanoseconds(value: Any, name: str = 'time') -> int:
    """Return the integer nanoseconds of an rclpy or builtin_interfaces time or duration.

    :raises TypeError: for any other object, including numbers.
    """
    try:
        return value.nanoseconds  # type: ignore[no-any-return]
    except AttributeError:
        pass
    try:
        return value.sec * 1_000_000_000 + value.nanosec  # type: ignore[no-any-return]
    except AttributeError:
        raise TypeError(f'{name} must have sec and nanosec, or nanoseconds.') from None


class TransformException(Exception):
    """No transform is available. This is the base class of all tf2 exceptions."""

    __module__ = 'tf2'


class LookupException(TransformException):
    """A frame does not exist, or the frames form a loop."""

    __module__ = 'tf2'


class ConnectivityException(TransformException):
    """Both frames exist, but are not in the same tree."""

    __module__ = 'tf2'


class ExtrapolationException(TransformException):
    """The buffer has no data at the requested time."""

    __module__ = 'tf2'


class InvalidArgumentException(TransformException):
    """A frame name is empty or starts with a slash."""

    __module__ = 'tf2'


class TimeoutException(TransformException):
    """A reply did not arrive in time. Only the buffer client raises this exception."""

    __module__ = 'tf2'


_BY_KIND: dict[str, type[TransformException]] = {
    'lookup': LookupException,
    'connectivity': ConnectivityException,
    'extrapolation': ExtrapolationException,
    'invalid_argument': InvalidArgumentException,
}


def exception_of(failure: TransformFailure) -> TransformException:
    """Return the tf2 exception for a failure of `edulaunch.engine.tf`."""
    return _BY_KIND[failure.kind](str(failure))


def wire_of(transform: Any) -> tuple[Any, ...]:
    """Return (sec, nanosec, parent, child, x, y, z, qx, qy, qz, qw) of a TransformStamped or a similar object.

    :raises TypeError: when the translation is not a Vector3. A rotation that is not a Quaternion only causes a warning.
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


NS_PER_S = 1_000_000_000


to_wire = TransformStamped.to_wire


from_wire = TransformStamped.from_wire


class BufferCore:
    """Stores transforms and looks them up, without a node or a topic. It mirrors tf2_py's class of the same name.

    :param cache_time: how long the samples of each frame are stored (a Duration); None means 10 s.
    """

    def __init__(self, cache_time: Any = None) -> None:
        cache_ns = DEFAULT_CACHE_NS if cache_time is None else nanoseconds(cache_time, 'duration')
        self._tf = TransformBuffer(cache_ns)

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform. If tf2 rejects the transform, log the reason without raising an exception.

        :raises TypeError: when the translation is not a Vector3.
        """
        wire = to_wire(transform) if transform.__class__ is TransformStamped else wire_of(transform)
        rejections = self._tf.set(wire[2], wire[3], wire[0] * NS_PER_S + wire[1], wire[4:], authority)
        if rejections:
            report(rejections)

    def set_transform_static(self, transform: TransformStamped, authority: str) -> None:
        """Add a transform that is valid at all times; see :meth:`set_transform`."""
        wire = wire_of(transform)
        rejections = self._tf.set(wire[2], wire[3], 0, wire[4:], authority, static=True)
        if rejections:
            report(rejections)

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> TransformStamped:
        """Return the transform that maps coordinates in the source frame to the target frame.

        :raises TransformException: one of its subclasses, with tf2's message.
        """
        try:
            stamp_ns, pose = self._tf.lookup(target_frame, source_frame, nanoseconds(time))
        except TransformFailure as failure:
            raise exception_of(failure) from None
        return message(target_frame, source_frame, stamp_ns, pose)

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> TransformStamped:
        """Return the transform from the source frame at one time to the target frame at another time, through a fixed frame.

        :raises TransformException: one of its subclasses, with tf2's message.
        """
        try:
            stamp_ns, pose = self._tf.lookup_full(
                target_frame, nanoseconds(target_time), source_frame, nanoseconds(source_time), fixed_frame
            )
        except TransformFailure as failure:
            raise exception_of(failure) from None
        return message(target_frame, source_frame, stamp_ns, pose)

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[int, str]:
        """Return the pair (1, '') if the transform is available, and otherwise (0, the reason)."""
        possible, reason = self._tf.can_transform(target_frame, source_frame, nanoseconds(time))
        return int(possible), reason

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[int, str]:
        """Return the pair (1, '') if :meth:`lookup_transform_full_core` succeeds, and otherwise (0, the reason)."""
        possible, reason = self._tf.can_transform_full(
            target_frame, nanoseconds(target_time), source_frame, nanoseconds(source_time), fixed_frame
        )
        return int(possible), reason

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Any:
        """Return the newest time at which the transform is available, as an rclpy Time of the system clock. The time is 0 if
        all transforms are static.

        :raises TransformException: when the frames are unknown or not connected.
        """
        from rclpy.time import Time

        try:
            return Time(nanoseconds=self._tf.latest_common_time(target_frame, source_frame))
        except TransformFailure as failure:
            unknown = 'passed to' in str(failure)
            raise (exception_of(failure) if unknown else TransformException(str(failure))) from None

    def lookupVelocityCore(
        self,
        tracking_frame: str,
        observation_frame: str,
        time: Any,  # noqa: N802
        averaging_interval: Any,
    ) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Return the linear (m/s) and angular (rad/s) velocity of the tracking frame seen from the observation frame.

        :raises TransformException: one of its subclasses, with tf2's message.
        """
        try:
            return lookup_velocity(
                self._tf, tracking_frame, observation_frame, nanoseconds(time), nanoseconds(averaging_interval, 'duration')
            )
        except TransformFailure as failure:
            raise exception_of(failure) from None

    def all_frames_as_yaml(self) -> str:
        """Return all frames as a YAML string, with the parent, rate and time span of each frame. Return `[]` if there are no
        frames.
        """
        return self._tf.all_frames_as_yaml()

    def all_frames_as_string(self) -> str:
        """Return one line for each frame that has a parent."""
        return self._tf.all_frames_as_string()

    def clear(self) -> None:
        """Drop all dynamic transforms. Static transforms stay."""
        self._tf.clear()

    def _allFramesAsDot(self, time: Any = None) -> str:  # noqa: N802
        """Return a graphviz graph of all frames. If `time` is given, the graph shows the ages of the transforms."""
        return self._tf.all_frames_as_dot(0 if time is None else nanoseconds(time))

    def _chain(self, *, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str) -> list[str]:
        """Return the frames between source and target.

        :raises TransformException: one of its subclasses, with tf2's message.
        """
        try:
            return self._tf.chain(target_frame, nanoseconds(target_time), source_frame, nanoseconds(source_time), fixed_frame)
        except TransformFailure as failure:
            raise exception_of(failure) from None

    def _frameExists(self, frame_id: str) -> bool:  # noqa: N802
        return self._tf.frame_exists(frame_id)

    def _getFrameStrings(self) -> list[str]:  # noqa: N802
        return self._tf.frame_names()


def message(target_frame: str, source_frame: str, stamp_ns: int, pose: Transform) -> TransformStamped:
    """Return a transform as a TransformStamped, the message that tf2 returns."""
    seconds = stamp_ns // NS_PER_S
    return from_wire((seconds, stamp_ns - seconds * NS_PER_S, target_frame, source_frame, *pose))
