"""Points in time."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.read_only import ReadOnly
from rclpy.clock_type import ClockType, TypeOfTime
from rclpy.constants import S_TO_NS
from rclpy.duration import Duration

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMessage

__all__ = ['CONVERSION_CONSTANT', 'Duration', 'S_TO_NS', 'Time']

CONVERSION_CONSTANT = S_TO_NS

_LIMIT = 1 << 63
_DIFFERENT = "Can't compare times with different clock types"


class Time:
    """A point in time of one kind of clock, in nanoseconds.

    As in rclpy, the default clock type is SYSTEM_TIME, while `node.get_clock().now()` has ROS_TIME. Times of these two types
    cannot be compared.

    :raises TypeError: if `clock_type` is not a ClockType.
    :raises ValueError: for negative seconds or nanoseconds.
    :raises OverflowError: for 2**63 nanoseconds or more.
    """

    __slots__ = ('_nanoseconds', '_clock_type')

    def __init__(self, *, seconds: float = 0, nanoseconds: float = 0, clock_type: ClockType = ClockType.SYSTEM_TIME) -> None:
        if not isinstance(clock_type, (ClockType, TypeOfTime)):
            raise TypeError('Clock type must be a ClockType enum')
        if seconds < 0:
            raise ValueError('Seconds value must not be negative')
        if nanoseconds < 0:
            raise ValueError('Nanoseconds value must not be negative')
        total = int(seconds * S_TO_NS) + int(nanoseconds)
        if total >= _LIMIT:
            raise OverflowError('Total nanoseconds value is too large to store in C time point.')
        self._nanoseconds = total
        self._clock_type = ClockType(clock_type)

    nanoseconds: ReadOnly[int] = ReadOnly("Nanoseconds since the clock's epoch.", '_nanoseconds')

    @property
    def clock_type(self) -> ClockType:
        """The kind of clock to which this time belongs; see :data:`TypeOfTime`."""
        kind: ClockType = TypeOfTime(self._clock_type)
        return kind

    def seconds_nanoseconds(self) -> tuple[int, int]:
        """Return the whole seconds and the remaining nanoseconds."""
        return divmod(self._nanoseconds, S_TO_NS)

    def __repr__(self) -> str:
        return f'Time(nanoseconds={self._nanoseconds}, clock_type={self._clock_type.name})'

    def __add__(self, other: object) -> Time:
        if not isinstance(other, Duration):
            return NotImplemented
        total = self._nanoseconds + other.nanoseconds
        if total >= _LIMIT:
            raise OverflowError('Addition leads to overflow in C storage.')
        return Time(nanoseconds=total, clock_type=self._clock_type)

    __radd__ = __add__

    def __sub__(self, other: object) -> Any:
        if isinstance(other, Time):
            if self._clock_type != other._clock_type:
                raise TypeError("Can't subtract times with different clock types")
            return Duration(nanoseconds=self._nanoseconds - other.nanoseconds)
        if not isinstance(other, Duration):
            return NotImplemented
        total = self._nanoseconds - other.nanoseconds
        if total < 0:
            raise ValueError('Subtraction leads to negative time.')
        return Time(nanoseconds=total, clock_type=self._clock_type)

    def _comparable(self, other: object) -> bool:
        if not isinstance(other, Time):
            return False
        if self._clock_type != other._clock_type:
            raise TypeError(_DIFFERENT)
        return True

    def __eq__(self, other: Any) -> bool:
        return self._nanoseconds == other.nanoseconds if self._comparable(other) else NotImplemented

    def __ne__(self, other: Any) -> bool:
        return self._nanoseconds != other.nanoseconds if self._comparable(other) else NotImplemented

    def __lt__(self, other: Any) -> bool:
        return self._nanoseconds < other.nanoseconds if self._comparable(other) else NotImplemented

    def __le__(self, other: Any) -> bool:
        return self._nanoseconds <= other.nanoseconds if self._comparable(other) else NotImplemented

    def __gt__(self, other: Any) -> bool:
        return self._nanoseconds > other.nanoseconds if self._comparable(other) else NotImplemented

    def __ge__(self, other: Any) -> bool:
        return self._nanoseconds >= other.nanoseconds if self._comparable(other) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def to_msg(self) -> TimeMessage:
        """Return the time as builtin_interfaces/Time."""
        return _message_of(divmod(self._nanoseconds, S_TO_NS))

    @classmethod
    def from_msg(cls, msg: Any, clock_type: ClockType = ClockType.ROS_TIME) -> Time:
        """Return the Time for a builtin_interfaces/Time. Raise TypeError for anything else."""
        from builtin_interfaces.msg import Time as TimeMessage

        if not isinstance(msg, TimeMessage):
            raise TypeError('Must pass a builtin_interfaces.msg.Time object')
        return cls(seconds=msg.sec, nanoseconds=msg.nanosec, clock_type=clock_type)


def _message_of(wire: tuple[int, int]) -> Any:
    """Return a builtin_interfaces/Time with these values. Every stamp needs a call, so the function is fast."""
    cls = _time_message_class()
    return cls.from_wire(wire)


@cache
def _time_message_class() -> Any:
    from builtin_interfaces.msg import Time as TimeMessage

    return TimeMessage


def time_of_clock(nanoseconds: int, clock_type: ClockType) -> Time:
    """Return a Time without the checks of the constructor. Clocks use this function, because programs read them often."""
    time = Time.__new__(Time)
    time._nanoseconds = nanoseconds
    time._clock_type = clock_type
    return time


__getattr__ = passed_on(__name__)
