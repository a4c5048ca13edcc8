"""Keyword arguments of log calls that let only some messages through: once, throttle, skip_first."""

from __future__ import annotations

from typing import Any

from rclpy.clock import Clock

_FILTERS: dict[str, dict[str, Any]] = {
    'throttle': {'throttle_duration_sec': None, 'throttle_time_source_type': False},
    'skip_first': {'skip_first': None},
    'once': {'once': None},
}
_OPTIONS = ['throttle_duration_sec', 'throttle_time_source_type', 'skip_first', 'once']


def filters_of(options: dict[str, Any]) -> tuple[str, ...]:
    """The filters that keyword arguments ask for.

    :raises TypeError: for an unknown keyword, or a throttle without its duration.
    :raises ValueError: for a time source that is no clock.
    """
    wanted = tuple(name for name, parameters in _FILTERS.items() if any(options.get(parameter) for parameter in parameters))
    if 'throttle' in wanted and 'throttle_duration_sec' not in options:
        raise TypeError(
            'required parameter "throttle_duration_sec" not specified but is required for the the logging filter "throttle"'
        )
    for name in options:
        if name not in _OPTIONS:
            raise TypeError(f'parameter "{name}" is not one of the recognized logging options "{_OPTIONS}"')
    source = options.get('throttle_time_source_type')
    if 'throttle' in wanted and source is not None and not isinstance(source, Clock):
        raise ValueError(f'Received throttle_time_source_type of "{source}" is not a clock instance')
    return wanted


class CallSite:
    """What one place in a program that logs remembers between its calls."""

    __slots__ = ('name', 'severity', 'filters', 'skipped', 'logged', 'next_ns')

    def __init__(self, name: str, severity: int, filters: tuple[str, ...]) -> None:
        self.name = name
        self.severity = severity
        self.filters = filters
        self.skipped = self.logged = False
        self.next_ns = 0

    def check(self, name: str, severity: int, filters: tuple[str, ...]) -> None:
        """Refuse a call that differs from the first one at this place. Raises ValueError."""
        if severity != self.severity:
            raise ValueError('Logger severity cannot be changed between calls.')
        if name != self.name:
            raise ValueError('Logger name cannot be changed between calls.')
        if filters != self.filters:
            raise ValueError('Requested logging filters cannot be changed between calls.')

    def lets_through(self, options: dict[str, Any], now_ns: int) -> bool:
        """Whether this call's message is to be written. Filters are asked in order, until one says no."""
        return all(self._passes(name, options, now_ns) for name in self.filters)

    def _passes(self, name: str, options: dict[str, Any], now_ns: int) -> bool:
        if name == 'once':
            before, self.logged = self.logged, True
            return not before
        if name == 'skip_first':
            before, self.skipped = self.skipped, True
            return before
        source = options.get('throttle_time_source_type')
        if isinstance(source, Clock):
            now_ns = source.now_ns()
        if self.next_ns and now_ns < self.next_ns:
            return False
        self.next_ns = now_ns + int(options['throttle_duration_sec'] * 1e9)
        return True
