"""Create the plan items of processes and nodes, with everything that is known before a program starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from launch.utilities.texts import perform_substitutions

from edulaunch.engine.graph.names import fully_qualified_name, remapped_namespace, remapped_node_name
from edulaunch.engine.graph.ros_arguments import RosArguments, RosArgumentsError, parse_ros_arguments

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

    from edulaunch.advice.plan.rehearsal import RehearsalHost
    from edulaunch.engine.graph.parameter_files import Entry

Item = dict[str, Any]
UNNAMED = 'unnamed'
"""Represents the name that the program itself chooses, which a plan does not know, when parameter files are read."""


def process_item(action: Any, context: LaunchContext, environ: Mapping[str, str], index: int) -> Item:
    """Return the item of an ExecuteLocal action that was just executed.

    For a node, :func:`add_names_and_parameters` adds the other entries.

    :param action: the action.
    :param context: the launch context.
    :param environ: the environment variables at the start of launch.
    :param index: the number of processes that were started earlier.
    """
    details = action.process_description
    command = list(details.command)
    item = {
        'kind': 'process',
        'index': index,
        'cmd': command,
        'cwd': details.final_cwd,
        'process_name': details.final_name.rpartition('-')[0],
        'env_changes': _changes(environ, details.final_env),
        'shell': action.shell,
        'output': action.output,
        'emulate_tty': action.emulate_tty,
        'respawn': action.respawn,
        'respawn_delay': action.respawn_delay,
        'sigterm_timeout': perform_substitutions(context, action.sigterm_timeout),
        'sigkill_timeout': perform_substitutions(context, action.sigkill_timeout),
    }
    if hasattr(action, 'node_executable'):
        item.update(_node_part(action, command, details.word_count))
    return item


def _changes(base: Mapping[str, str], env: Mapping[str, str]) -> dict[str, str | None]:
    """Return the environment variables of a process whose values differ from the values at the start of launch.

    A removed variable has the value None.
    """
    if env == base:
        return {}
    changed: dict[str, str | None] = {name: value for name, value in sorted(env.items()) if base.get(name) != value}
    return {**changed, **{name: None for name in sorted(base) if name not in env}}


def _node_part(action: Any, words: list[str], own: int) -> Item:
    """Return the part of an item that only nodes have.

    :param action: the node action.
    :param words: the command line.
    :param own: the number of words at the end of the command line that belong to the node. A prefix command precedes them.
    """
    prefix, command = words[:-own], words[-own:]
    program = action.process_spec_details()
    arguments, others = _split(command[1:])
    return {
        'kind': 'node',
        'package': program['package'],
        'executable': program['executable'],
        'prefix': prefix,
        'arguments': arguments,
        'other_ros_arguments': others,
        'fully_qualified_name': action.node_name if action.is_node_name_fully_specified() else None,
        'remappings': [list(rule) for rule in action.expanded_remapping_rules],
    }


def _split(words: list[str]) -> tuple[list[str], list[str]]:
    """Return the program's own arguments, and the ROS arguments that are not names, remappings or parameters."""
    arguments: list[str] = []
    others: list[str] = []
    inside = False
    rest = iter(words)
    for word in rest:
        if word in ('--ros-args', '--'):
            inside = word == '--ros-args'
        elif not inside:
            arguments.append(word)
        elif word in ('-r', '--remap', '-p', '--param', '--params-file'):
            next(rest, None)
        else:
            others.append(word)
    return arguments, others


def add_parameter_sources(item: Item, host: RehearsalHost) -> None:
    """Add the path and the content of each parameter file on the node's command line to the node's item."""
    command = item['cmd'][len(item['prefix']) :]
    item['parameter_sources'] = [
        {'file': path, 'content': host.parameter_content(path)}
        for flag, path in zip(command, command[1:], strict=False)
        if flag == '--params-file'
    ]


def add_names_and_parameters(item: Item, entries_of: Callable[[str], Sequence[Entry]]) -> None:
    """Add the name, namespace and parameters to a node's item, as rcl reads them from the command line.

    If the program chooses the name or namespace, the item contains None.

    :param item: the item of the node.
    :param entries_of: a function that returns the entries of the parameter file at a path (see `Host.parameter_entries`).
    """
    command = item['cmd'][len(item['prefix']) :]
    try:
        arguments = parse_ros_arguments(command, entries_of)
    except RosArgumentsError as error:
        arguments, item['parameter_error'] = RosArguments(), str(error)
    name = remapped_node_name(arguments.remap_rules, '') or None
    namespace = remapped_namespace(arguments.remap_rules, name or '', '') or None
    full_name = fully_qualified_name(namespace or '/', name or UNNAMED)
    overrides = arguments.overrides_for(full_name)
    item['name'], item['namespace'] = name, namespace
    item['runtime_name'] = None if name is None else full_name
    item['parameters'] = {parameter: override.value for parameter, override in sorted(overrides.items())}
