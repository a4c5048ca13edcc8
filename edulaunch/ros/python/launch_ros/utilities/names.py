"""Namespaces, remap rules, and the names of the nodes that were started."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from launch._lazy import has_ros_paths
from launch.utilities.texts import normalize_to_list_of_substitutions
from launch.utilities.type_utils import ensure_argument_type

from ..parameters_type import RemapRule, SomeRemapRule, SomeRemapRules

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


def is_root_namespace(ns: str) -> bool:
    """Whether it is `/`."""
    return ns == '/'


def is_namespace_absolute(ns: str) -> bool:
    """Whether it begins with `/`."""
    return ns.startswith('/')


def prefix_namespace(base_ns: str | None, ns: str | None) -> str | None:
    """`ns` inside `base_ns`; an absolute `ns` stays. None means "not given", and None in both stays None."""
    if base_ns is None and ns is None:
        return None
    if ns is None:
        joined = base_ns or ''
    elif not base_ns or is_namespace_absolute(ns):
        joined = ns
    elif not ns:
        joined = base_ns
    else:
        joined = (base_ns if is_root_namespace(base_ns) else base_ns + '/') + ns
    return joined.rstrip('/') if joined.endswith('/') and not is_root_namespace(joined) else joined


def make_namespace_absolute(ns: str | None) -> str | None:
    """`ns` with a leading `/`; None stays None."""
    if ns is None or is_namespace_absolute(ns):
        return ns
    return '/' + ns


def normalize_remap_rule(remap_rule: SomeRemapRule) -> RemapRule:
    """A pair of tuples of substitutions.

    :raises TypeError: for anything but a tuple of two.
    """
    ensure_argument_type(remap_rule, (tuple,), 'remap_rule')
    if len(remap_rule) != 2:
        raise TypeError(f'remap_rule must be a tuple of length 2, got length {len(remap_rule)}')
    source, target = remap_rule
    return tuple(normalize_to_list_of_substitutions(source)), tuple(normalize_to_list_of_substitutions(target))


def normalize_remap_rules(remap_rules: SomeRemapRules) -> Iterable[RemapRule]:
    """:func:`normalize_remap_rule` of each, one by one."""
    return (normalize_remap_rule(rule) for rule in remap_rules)


_KEY = 'unique_ros_node_names'


def add_node_name(context: LaunchContext, node_name: str) -> int:
    """Count a node with this full name; gives how many there are now."""
    counts = context.local(_KEY)
    if counts is None:
        counts = {}
        context.extend_globals({_KEY: counts})
    count: int = counts.get(node_name, 0) + 1
    counts[node_name] = count
    return count


def get_node_name_count(context: LaunchContext, node_name: str) -> int:
    """How often the name was counted."""
    counts: dict[str, int] = context.local(_KEY) or {}
    return counts.get(node_name, 0)


has_ros_paths(__name__)
