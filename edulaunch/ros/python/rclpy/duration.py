"""Durations."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy.constants import S_TO_NS

if TYPE_CHECKING:
    from builtin_interfaces.msg import Duration as DurationMessage

_INT64 = range(-(1 << 63), 1 << 63)


class Duration:
    """A duration in nanoseconds, which may be negative. As in rclpy, durations can be compared, but not added.

    :raises OverflowError: when the duration does not fit in 64 bits.
    """

    __slots__ = ('_nanoseconds',)

    def __init__(self, *, seconds: float = 0, nanoseconds: float = 0) -> None:
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if total not in _INT64:
            raise OverflowError('Total nanoseconds value is too large to store in C duration.')
        self._nanoseconds = total

    nanoseconds: ReadOnly[int] = ReadOnly('The whole length in nanoseconds.', '_nanoseconds')

    def __repr__(self) -> str:
        return f'Duration(nanoseconds={self._nanoseconds})'

    def __str__(self) -> str:
        return 'Infinite' if self._nanoseconds == _INT64[-1] else f'{self._nanoseconds} nanoseconds'

    def __eq__(self, other: object) -> bool:
        return self._nanoseconds == other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __ne__(self, other: object) -> bool:
        return self._nanoseconds != other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __lt__(self, other: object) -> bool:
        return self._nanoseconds < other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __le__(self, other: object) -> bool:
        return self._nanoseconds <= other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __gt__(self, other: object) -> bool:
        return self._nanoseconds > other.nanoseconds if isinstance(other, Duration) else NotImplemented

    def __ge__(self, other: object) -> bool:
        return self._nanoseconds >= other.nanoseconds if isinstance(other, Duration) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def to_msg(self) -> DurationMessage:
        """Return the duration as builtin_interfaces/Duration."""
        from builtin_interfaces.msg import Duration as DurationMessage

        seconds, nanoseconds = divmod(self._nanoseconds, S_TO_NS)
        return DurationMessage.from_wire((seconds, nanoseconds))  # no range check, because Infinite is too long for the field

    @classmethod
    def from_msg(cls, msg: Any) -> Duration:
        """Return the Duration for a builtin_interfaces/Duration. Raise TypeError for anything else."""
        from builtin_interfaces.msg import Duration as DurationMessage

        if not isinstance(msg, DurationMessage):
            raise TypeError('Must pass a builtin_interfaces.msg.Duration object')
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec)

    def get_c_duration(self) -> int:
        """Return the duration in nanoseconds, as in the C layer."""
        return self._nanoseconds


Infinite = Duration(nanoseconds=_INT64[-1])


__getattr__ = passed_on(__name__)
