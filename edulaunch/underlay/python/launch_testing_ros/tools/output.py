"""Filters of what ROS nodes print."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable

from ament_index_python.resources import get_resource, get_resources
from launch_testing.tools.output import basic_output_filter as filter_lines
from launch_testing.tools.output import get_default_filtered_patterns, get_default_filtered_prefixes


def get_rmw_output_filter(rmw_implementation: str, filter_type: str) -> list[str]:
    """A middleware's own lines, which say nothing about a program: those that its package has registered (the simulated: none).

    :param filter_type: 'prefixes' or 'patterns'.
    """
    resource_type = f'rmw_output_{filter_type}'
    if rmw_implementation not in get_resources(resource_type):
        return []
    content, _ = get_resource(resource_type, rmw_implementation)
    return content.strip().split(os.linesep)


def basic_output_filter(
    *,
    filtered_prefixes: Iterable[str] | None = None,
    filtered_patterns: Iterable[str] | None = None,
    filtered_rmw_implementation: str | None = None,
) -> Callable[[str], str]:
    """As :func:`launch_testing.tools.basic_output_filter`, and without the lines of a middleware."""
    if filtered_rmw_implementation:
        filtered_prefixes = [
            *(filtered_prefixes if filtered_prefixes is not None else get_default_filtered_prefixes()),
            *get_rmw_output_filter(filtered_rmw_implementation, 'prefixes'),
        ]
        filtered_patterns = [
            *(filtered_patterns if filtered_patterns is not None else get_default_filtered_patterns()),
            *get_rmw_output_filter(filtered_rmw_implementation, 'patterns'),
        ]
    return filter_lines(filtered_prefixes=filtered_prefixes, filtered_patterns=filtered_patterns)
