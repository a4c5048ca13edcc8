"""Quality of service: profiles and policies. `qos_compatibility` checks whether two profiles are compatible."""

from __future__ import annotations

from enum import Enum, IntEnum
from operator import attrgetter
from typing import TYPE_CHECKING, Any
from warnings import warn

from edulaunch.engine.graph import qos as engine
from rclpy.duration import Duration
from rclpy.impl.refusals import student_level

if TYPE_CHECKING:
    from edulaunch.engine.graph.qos import QoS

_INFINITE_NS = (1 << 63) - 1
DURATION_INFINITE = Duration(nanoseconds=_INFINITE_NS)


class InvalidQoSProfileException(Exception):
    """The arguments of a profile are incomplete."""

    def __init__(self, *args: object) -> None:
        super().__init__('Invalid QoSProfile', *args)


class QoSPolicyEnum(IntEnum):
    """A policy with named values. Each value also has a short key such as 'keep_last'."""

    def __str__(self) -> str:
        return str(int(self))

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return all short keys."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> int:
        """Return the number of the value with this short key. Raise KeyError for an unknown key."""
        return cls[name.upper()].value

    @property
    def short_key(self) -> str:
        """The short key of this value."""
        return self.name.lower()


class HistoryPolicy(QoSPolicyEnum):
    """Whether a queue limits the number of its messages."""

    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    """Whether messages may be lost."""

    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    """Whether late subscriptions receive old messages."""

    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    """How a publisher asserts that it is alive."""

    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

_DEFAULTS: dict[str, Any] = {
    'history': HistoryPolicy.KEEP_LAST,
    'depth': 10,
    'reliability': ReliabilityPolicy.RELIABLE,
    'durability': DurabilityPolicy.VOLATILE,
    'lifespan': Duration(),
    'deadline': Duration(),
    'liveliness': LivelinessPolicy.SYSTEM_DEFAULT,
    'liveliness_lease_duration': Duration(),
    'avoid_ros_namespace_conventions': False,
}
_POLICIES = {
    'history': HistoryPolicy,
    'reliability': ReliabilityPolicy,
    'durability': DurabilityPolicy,
    'liveliness': LivelinessPolicy,
}
_DURATIONS = ('lifespan', 'deadline', 'liveliness_lease_duration')


class QoSProfile:
    """The quality of service of one endpoint.

    Set `depth`, `history`, or both. `lifespan`, `deadline` and `liveliness_lease_duration` are Durations (0 means no limit).

    :raises InvalidQoSProfileException: without history and depth, or with KEEP_LAST and no depth.
    :raises AssertionError: for an unknown keyword or a value of the wrong type.
    """

    __slots__ = tuple('_' + name for name in _DEFAULTS)

    if TYPE_CHECKING:
        history: HistoryPolicy
        depth: int
        reliability: ReliabilityPolicy
        durability: DurabilityPolicy
        lifespan: Duration
        deadline: Duration
        liveliness: LivelinessPolicy
        liveliness_lease_duration: Duration
        avoid_ros_namespace_conventions: bool

    def __init__(self, **kwargs: Any) -> None:
        assert kwargs.keys() <= _DEFAULTS.keys(), f'Invalid arguments passed to constructor: {kwargs.keys()!r}'
        if 'history' not in kwargs:
            if 'depth' not in kwargs:
                raise InvalidQoSProfileException('History and/or depth settings are required.')
        elif kwargs['history'] == HistoryPolicy.KEEP_LAST and 'depth' not in kwargs:
            raise InvalidQoSProfileException('History set to KEEP_LAST without a depth setting.')
        for name, default in _DEFAULTS.items():
            setattr(self, name, kwargs.get(name, default))
        if 'depth' in kwargs:
            _warn_of_zero(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, QoSProfile):
            return False
        return all(getattr(self, slot) == getattr(other, slot) for slot in self.__slots__)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        return '{}({})'.format(type(self).__name__, ', '.join(f'{slot[1:]}={getattr(self, slot)}' for slot in self.__slots__))

    def get_c_qos_profile(self) -> _CProfile:
        """Return a copy of the profile in the form of ROS 2's C layer. Later changes of this profile do not affect the copy."""
        return _CProfile(self)


class _CProfile:
    """A profile in the form of ROS 2's C layer, in which policies are numbers.

    :ivar resolved: the profile in the form of the graph.
    """

    def __init__(self, profile: QoSProfile) -> None:
        values = {name: getattr(profile, name) for name in _C_ORDER}
        self.resolved = engine_qos(profile)
        self._values = {name: int(value) if isinstance(value, IntEnum) else value for name, value in values.items()}

    def to_dict(self) -> dict[str, Any]:
        """Return the values by name. `QoSProfile` accepts them as keyword arguments."""
        return dict(self._values)


_CProfile.__module__, _CProfile.__qualname__ = 'rclpy._rclpy_pybind11', 'rmw_qos_profile_t'

_C_ORDER = ('depth', *(name for name in _DEFAULTS if name != 'depth'))


def _warn_of_zero(profile: QoSProfile) -> None:
    if profile.depth == 0 and profile.history == HistoryPolicy.KEEP_LAST:
        warn(
            "A zero depth with KEEP_LAST doesn't make sense; no data could be stored. This will be interpreted as SYSTEM_DEFAULT",
            stacklevel=student_level(),
        )


def _property(name: str) -> property:
    slot, is_depth = '_' + name, name == 'depth'

    def getter(self: QoSProfile) -> Any:
        """Return the value of this policy."""
        return getattr(self, slot)

    def setter(self: QoSProfile, value: Any) -> None:
        if name in _POLICIES:
            assert isinstance(value, int)
            value = _POLICIES[name](value)
        elif name in _DURATIONS:
            assert isinstance(value, Duration)
        else:
            assert isinstance(value, bool if name == 'avoid_ros_namespace_conventions' else int)
        setattr(self, slot, value)
        # without this attribute, the profile is still being created
        if is_depth and getattr(self, '_avoid_ros_namespace_conventions', None) is not None:
            _warn_of_zero(self)

    return property(getter, setter)


for _name in _DEFAULTS:
    setattr(QoSProfile, _name, _property(_name))


def engine_qos(profile: QoSProfile, side: str = 'publisher') -> QoS:
    """Return the resolved profile for the graph.

    The system defaults are those of Fast DDS, with depth 1. Publishers are reliable and transient local; subscriptions are best
    effort and volatile.
    """
    history: Any
    history, depth, reliability, durability, lifespan, deadline, liveliness, lease, _ = _values_of(profile)
    if side == 'subscription' and reliability is ReliabilityPolicy.SYSTEM_DEFAULT:
        reliability = ReliabilityPolicy.BEST_EFFORT
    if side == 'publisher' and durability is DurabilityPolicy.SYSTEM_DEFAULT:
        durability = DurabilityPolicy.TRANSIENT_LOCAL
    return engine.QoS(
        depth or 1,
        engine.BEST_EFFORT if reliability is ReliabilityPolicy.BEST_EFFORT else engine.RELIABLE,
        engine.TRANSIENT_LOCAL if durability is DurabilityPolicy.TRANSIENT_LOCAL else engine.VOLATILE,
        engine.KEEP_ALL if history is HistoryPolicy.KEEP_ALL else engine.KEEP_LAST,
        _finite_ns(deadline),
        _finite_ns(lifespan),
        engine.MANUAL_BY_TOPIC if liveliness is LivelinessPolicy.MANUAL_BY_TOPIC else engine.AUTOMATIC,
        _finite_ns(lease),
    )


_values_of = attrgetter(*QoSProfile.__slots__)


def _finite_ns(duration: Duration) -> int:
    nanoseconds = duration.nanoseconds
    return 0 if nanoseconds >= _INFINITE_NS - 1 else nanoseconds  # one nanosecond less than infinity means 'best available'


def profile_from_engine(qos: QoS) -> QoSProfile:
    """Return the profile of an endpoint in the form of graph queries. Unlimited durations are infinite. The history is unknown,
    because DDS does not announce it.
    """

    def duration(nanoseconds: int) -> Duration:
        return Duration(nanoseconds=nanoseconds) if nanoseconds else DURATION_INFINITE

    return QoSProfile(
        history=HistoryPolicy.UNKNOWN,
        depth=0,
        reliability=ReliabilityPolicy[qos.reliability.upper()],
        durability=DurabilityPolicy[qos.durability.upper()],
        lifespan=duration(qos.lifespan_ns),
        deadline=duration(qos.deadline_ns),
        liveliness=LivelinessPolicy[qos.liveliness.upper()],
        liveliness_lease_duration=duration(qos.lease_ns),
    )


def validate_qos(qos: QoSProfile | int) -> QoSProfile:
    """Return the profile for a `qos_profile` argument. An int is the depth.

    :raises ValueError: for a negative depth.
    :raises TypeError: for an object that is neither an int nor a QoSProfile.
    """
    if isinstance(qos, QoSProfile):
        return qos
    if not isinstance(qos, int):
        raise TypeError(f'Expected QoSProfile or int, but received {type(qos)!r}')
    if qos < 0:
        raise ValueError('history depth must be greater than or equal to zero')
    return QoSProfile(depth=qos)


_SYSTEM = {'reliability': ReliabilityPolicy.SYSTEM_DEFAULT, 'durability': DurabilityPolicy.SYSTEM_DEFAULT}
qos_profile_unknown = QoSProfile(
    history=HistoryPolicy.UNKNOWN,
    depth=0,
    reliability=ReliabilityPolicy.UNKNOWN,
    durability=DurabilityPolicy.UNKNOWN,
    liveliness=LivelinessPolicy.UNKNOWN,
)
qos_profile_default = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=10)
qos_profile_system_default = QoSProfile(history=HistoryPolicy.SYSTEM_DEFAULT, depth=0, **_SYSTEM)
qos_profile_sensor_data = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
qos_profile_services_default = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=10)
qos_profile_parameters = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1000)
qos_profile_parameter_events = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1000)
_BEST_AVAILABLE = Duration(nanoseconds=(1 << 63) - 2)
qos_profile_best_available = QoSProfile(
    history=HistoryPolicy.KEEP_LAST,
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
    deadline=_BEST_AVAILABLE,
    liveliness_lease_duration=_BEST_AVAILABLE,
    liveliness=LivelinessPolicy.BEST_AVAILABLE,
)
qos_profile_action_status_default = QoSProfile(
    history=HistoryPolicy.KEEP_LAST, depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL
)
qos_profile_rosout_default = QoSProfile(
    history=HistoryPolicy.KEEP_LAST, depth=1000, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=10)
)


class QoSPresetProfiles(Enum):
    """The preset profiles of ROS 2."""

    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available

    @classmethod
    def short_keys(cls) -> list[str]:
        """Return the short keys of all profiles, such as 'sensor_data'."""
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        """Return the profile with this short key. Raise KeyError for an unknown key."""
        profile: QoSProfile = cls[name.upper()].value
        return profile


_LATE = ('QoSCompatibility', 'QoSPolicyKind', 'qos_check_compatible', 'qos_policy_name_from_kind')
__all__ = [*[_name for _name in list(globals()) if not _name.startswith('_')], *_LATE]


def __getattr__(name: str) -> Any:
    """Import a rarely needed name when it is first used."""
    if name not in _LATE:
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from rclpy import qos_compatibility

    return getattr(qos_compatibility, name)
