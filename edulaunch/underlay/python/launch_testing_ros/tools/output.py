"""Filters of what ROS nodes print."""
from __future__ import annotations

from collections.abc import Callable, Iterable

from launch_testing.tools.output import basic_output_filter as filter_lines


def basic_output_filter(*, filtered_prefixes: Iterable[str] | None = None, filtered_patterns: Iterable[str] | None = None,
                        filtered_rmw_implementation: str | None = None) -> Callable[[str], str]:
    """As :func:`launch_testing.tools.basic_output_filter`; the simulated middleware prints nothing that had to be filtered."""
    return filter_lines(filtered_prefixes=filtered_prefixes, filtered_patterns=filtered_patterns)
